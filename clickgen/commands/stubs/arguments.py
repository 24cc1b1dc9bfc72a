"""The type of each parameter of an instruction, from its Spec."""

from __future__ import annotations

from typing import NamedTuple

from clickgen.commands.stubs.forms import operand, span, union
from clickgen.device.banks import BANKS
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.spec import CONSTANTS, Param, ParamKind, Spec

COMPARISONS = ("==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge")
"""The comparisons of a search, in quotes."""

_TYPES = {
    ParamKind.PATTERN: "Sequence[Sequence[Literal[0, 1] | bool]]",
    ParamKind.TARGET: "ModbusTcpTarget | ModbusRtuTarget",
    ParamKind.REMOTE: "ModbusAddress | str",
    ParamKind.FLAG: "bool",
    ParamKind.UNIT: "_Unit",
    ParamKind.PIN: "_Pin",
    ParamKind.FORMULA: "str",
    ParamKind.ROUTINE: "_Subroutine | str",
    # 100 == ds[1:5] is a bool for Python, because its left side decides.
    ParamKind.RANGE_COMPARISON: "_RangeComparison | bool",
    ParamKind.TEXT: "str",
    ParamKind.TOKEN: "str",
}
"""The types of parameters that are not operands."""


class Group(NamedTuple):
    """A part of a copy's matrix: these sources (banks, forms of constants, options) all go to these banks."""

    sources: tuple[str, ...]
    targets: tuple[str, ...]


def literals(words: tuple[str, ...]) -> str:
    """The type of these words in quotes."""
    quoted = [f'"{word}"' for word in words]
    return f"Literal[{', '.join(quoted)}]"


def option_class(option: str) -> str:
    """The class of a copy's option: ``to_value`` is a ``_ToValue``."""
    return "_" + option.title().replace("_", "")


def type_of(spec: Spec, param: Param, group: Group | None = None) -> str:
    """The type of a parameter; in a copy, that in one group of its matrix."""
    classes = _classes(spec, param, group)
    return union([*classes, "None"] if param.default is None else classes)


def _classes(spec: Spec, param: Param, group: Group | None) -> list[str]:
    kind, slot = param.kind, param.slot
    if kind is ParamKind.OPERAND:
        source, target = spec.matrix
        if group is not None and param.name == source:
            return operand(slot, group.sources) + _converted(param, group.sources)
        return operand(slot, group.targets if group is not None and param.name == target else None)
    if kind is ParamKind.OPERANDS:
        ranges = [span(bank) for bank in slot.cells]
        return [f"Sequence[{union([*operand(slot), *ranges])}]", union([*operand(slot, slot.cells), *ranges])]
    if kind is ParamKind.OPTIONS:
        return [*map(option_class, spec.conversions), *([literals(spec.conversions)] if spec.conversions else [])]
    return [literals(COMPARISONS) if kind is ParamKind.COMPARISON else _TYPES[kind]]


# -- the matrix of a copy ---------------------------------------------------------------------------------------------


def groups(spec: Spec) -> list[Group | None]:
    """The matrix of a copy, sources with the same targets together; only None if there is no matrix."""
    pairs = [pair for variant in spec.variants for pair in variant.pairs]
    by_targets: dict[tuple[str, ...], list[str]] = {}
    for source in (*BANKS, *CONSTANTS):
        targets = {target for pair in pairs if source in pair.sources for target in pair.targets}
        by_targets.setdefault(_in_order(targets), []).append(source)
    for option in spec.conversions:
        sources, ends = CONVERSIONS[option]
        targets = {
            target for pair in pairs if {*sources} & {*pair.sources} for target in pair.targets if target in ends
        }
        by_targets.setdefault(_in_order(targets), []).append(option)
    by_targets.pop((), None)
    return [Group(tuple(sources), targets) for targets, sources in by_targets.items()] or [None]


def whole(spec: Spec) -> Group | None:
    """The matrix without regard to which source goes where."""
    found = [group for group in groups(spec) if group is not None]
    if not found:
        return None
    targets = _in_order({target for group in found for target in group.targets})
    return Group(tuple(source for group in found for source in group.sources), targets)


def _in_order(banks: set[str]) -> tuple[str, ...]:
    return tuple(bank for bank in BANKS if bank in banks)


def _converted(param: Param, options: tuple[str, ...]) -> list[str]:
    """The classes of a source with a modifier after it: ``txt[1].as_value()``."""
    numbers = "_AsNumber" if param.slot.cells else "_AsNumbers"
    classes = {"to_value": numbers, "to_ascii": numbers, "to_binary": "_AsText", "to_text": "_AsText"}
    return [name for option, name in classes.items() if option in options]
