"""How far an operand reaches behind its own address: block copies, texts, searched ranges.

Addresses in such a reach belong to the program as much as those it names, so nothing is allocated there.
"""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.device.banks import BANKS, Kind
from clickgen.instructions.copies import COPY
from clickgen.instructions.data import SEARCH
from clickgen.ir.operands import Cell, Named, Operand, Pointer, Range, Text
from clickgen.ir.program import Action, Options, Program, actions_in, rungs_in

_TEXT_WIDTHS = {Kind.INT16: 6, Kind.INT32: 11, Kind.HEX: 4, Kind.FLOAT: 15}
"""The most characters that a number becomes with its sign (click-facts, section 8, "Numeric -> TXT")."""


def extents(program: Program) -> Iterator[tuple[Operand, int]]:
    """Operands that stand for several addresses from their own upward, and how many."""
    for routine in program.routines:
        for rung in rungs_in(routine.rungs):
            for action in actions_in(rung.items):
                yield from _extents(action)


def _extents(action: Action) -> Iterator[tuple[Operand, int]]:
    args = action.args
    for param in action.spec.params:
        target, source = args.get(param.name), args.get(param.extends_over)
        if param.extends_over and isinstance(target, Named | Cell) and isinstance(source, Range):
            yield target, len(source)
    if action.spec is SEARCH:
        start, end = args.get("start"), args.get("end")
        if isinstance(start, Cell) and isinstance(end, Cell) and start.bank == end.bank:
            yield start, max(1, end.address.number - start.address.number + 1)
    if action.spec is COPY:
        target = args.get("destination")
        if isinstance(target, Named | Cell) and target.bank == "TXT":
            yield target, _characters(action)


def _characters(action: Action) -> int:
    """How many TXT addresses a copy may fill."""
    source, options = action.args.get("source"), action.args.get("options")
    if isinstance(source, Text):
        return max(1, len(source.value))
    if isinstance(options, Options) and isinstance(source, Named | Cell | Pointer):
        end = 0 if options.termination_code is None else 1
        return _TEXT_WIDTHS.get(BANKS[source.bank].kind, 1) + end
    return 1
