"""The sheet of the timers and counters with their setpoints."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.click.draw.tokens import NEVER_CONTACT
from clickgen.click.draw.words import condition_words
from clickgen.device.banks import Address, current_value
from clickgen.emit.workbook.project import Project, or_none
from clickgen.emit.workbook.sheet import Cells, Column, Sheet, Value
from clickgen.emit.workbook.tags import initial
from clickgen.ir.operands import Cell, Integer, Operand
from clickgen.ir.program import Action

_UNITS = {"Tms": "ms", "Ts": "s", "Tm": "min", "Th": "h", "Td": "days"}
_WORDS_MAX = 500
"""A longer condition would be higher than a row can be."""
_NONE = "The program has no timer and no counter."


def timers_and_counters(project: Project) -> Sheet:
    return Sheet(
        "Timers and counters",
        "Setpoints are numbers, or the register that holds them and what the register begins with.",
        (
            Column("Bit", 8),
            Column("Nickname", 27),
            Column("Kind", 7),
            Column("Setpoint", 22, wraps=True),
            Column("Begins with", 9),
            Column("Unit", 7),
            Column("Current value", 9),
            Column("Reset when", 34, wraps=True),
            Column("Counts down when", 26, wraps=True),
            Column("Routine", 16, wraps=True),
            Column("Rung", 7),
            Column("Source", 22, wraps=True),
        ),
        or_none(_rows(project), _NONE),
    )


def _rows(project: Project) -> Iterator[Cells]:
    found: list[tuple[Address, Cells]] = []
    for routine in project.built.routines:
        for number, rung in enumerate(routine.rungs, 1):
            for action in rung.actions:
                owner = action.owned
                if owner is not None and action.effects.done is not None:
                    place = (routine.name, number, project.line(action.span))
                    found.append((owner.address, (*_line(project, action, owner.address), *place)))
    return (line for _, line in sorted(found, key=lambda item: item[0].sort_key))


def _line(project: Project, action: Action, bit: Address) -> Cells:
    return (
        str(bit),
        project.built.names.nickname(bit),
        _kind(project, action, bit),
        *_setpoint(project, action),
        _unit(action),
        str(current_value(bit)),
        _pin(project, action, "reset"),
        _pin(project, action, "count_down"),
    )


def _kind(project: Project, action: Action, bit: Address) -> str:
    """The instruction of the source; the scratch bits of an rtof say that clickgen built it from one."""
    is_rtof = any(row.comment.startswith(f"rtof {bit}: ") for row in project.built.scratch)
    return "rtof" if is_rtof else action.spec.name


def _setpoint(project: Project, action: Action) -> tuple[Value, Value]:
    """The setpoint; for a register, also its initial value."""
    setpoint = action.args["setpoint"]
    if isinstance(setpoint, Integer):
        return setpoint.value, None
    assert isinstance(setpoint, Operand)
    row = project.built.by_address.get(setpoint.address) if isinstance(setpoint, Cell) else None
    return project.built.names.show(setpoint), initial(row) if row else None


def _unit(action: Action) -> str:
    units = [param.default for param in action.spec.params if param.name == "unit"]
    return _UNITS[action.word("unit") or str(units[0])] if units else ""


def _pin(project: Project, action: Action, name: str) -> str:
    """The condition of an input; an input that was left out is never on."""
    if all(param.name != name for param in action.spec.pins):
        return ""
    condition = action.pin(name)
    words = condition_words(condition, project.built.names.show) if condition else f"never ({NEVER_CONTACT})"
    return words if len(words) <= _WORDS_MAX else words[:_WORDS_MAX] + "... (see the rung)"
