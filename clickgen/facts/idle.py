"""The actions that never run, for rules that compare actions with each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from clickgen.device.system import ALWAYS_ON
from clickgen.facts.facts import Facts
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import All, Always, Any, Condition, Contact
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action, Branch, Item, Rung, actions_in, loops_in, rungs_in


def never_run(facts: Facts) -> set[int]:
    """The ids of actions that decide nothing: in subroutines that nothing calls, and after an end() or return."""
    missed = (one for routine in facts.program.routines for one in unreached(routine.rungs))
    # An action that CLICK reaches with its rung off turns its bit off.
    idle = {id(one.action) for one in missed if not one.is_looked_at}
    if facts.program.main is None:  # A part of a program: another file decides what runs.
        return idle
    uncalled = (one for one in facts.actions if not one.routine.is_main and one.routine.name not in facts.calls)
    return idle | {id(placed.action) for placed in uncalled}


class Missed(NamedTuple):
    """An action that never runs, and the one that always leaves before it."""

    left: Action
    rung: Rung
    action: Action
    is_rung_reached: bool
    """True if only the end of the rung is never reached."""
    is_looked_at: bool = False
    """True if CLICK reaches it while the rung is off: a coil there is turned off, and never on."""


def unreached(rungs: tuple[Rung, ...]) -> Iterator[Missed]:
    """Yield the actions of a routine or of a loop's body after one that always leaves."""
    left: Action | None = None
    is_open = left_in_loop = False
    for rung in rungs:
        actions = [action for one in rungs_in((rung,)) for action in actions_in(one.items)]
        if any(action.effects.flow is Flow.NEXT for action in actions):
            # An action that leaves inside a loop leaves only if the loop runs at all.
            is_open = False
            if left_in_loop:
                left, left_in_loop = None, False
        elif left is not None:
            for action in actions:
                yield Missed(left, rung, action, False)
        else:
            behind: list[Missed] = []
            is_certain = _is_always(rung.condition)
            leaving = _left_in(rung.items, rung, is_certain, behind)
            left = leaving if is_certain else None
            left_in_loop = left is not None and is_open
            yield from behind
            for loop in loops_in(rung.items):
                is_open = is_open or loop.body is None
                yield from unreached(loop.body or ())


def _left_in(items: tuple[Item, ...], rung: Rung, is_certain: bool, behind: list[Missed]) -> Action | None:
    """The item that leaves whenever their condition is on; ``behind`` gets the actions that can never run after it."""
    for index, item in enumerate(items):
        left: Action | None = None
        if isinstance(item, Branch):
            is_always = _is_always(item.condition)
            inner = _left_in(item.items, rung, is_certain and is_always, behind)
            left = inner if is_always else None
        elif isinstance(item, Action) and item.effects.leaves:
            left = item
        if left is not None:
            behind += [Missed(left, rung, action, True, not is_certain) for action in actions_in(items[index + 1 :])]
            return left
    return None


def _is_always(condition: Condition) -> bool:
    """True for True and for the contact that is always on."""
    if isinstance(condition, All):
        return all(map(_is_always, condition.terms))
    if isinstance(condition, Any):
        return any(map(_is_always, condition.terms))
    if isinstance(condition, Contact):
        is_level = not condition.negated and not condition.edge
        return is_level and isinstance(condition.operand, Cell) and condition.operand.address == ALWAYS_ON
    return isinstance(condition, Always)
