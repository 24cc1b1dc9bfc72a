"""The addresses that an action touches, including those beyond an operand's own: block copies, texts, searches.

They belong to the program as much as those that it names.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple, get_args

from clickgen.device.banks import BANKS, TEXT_WIDTHS, Address, Kind, current_value
from clickgen.instructions.spec import Access, Param
from clickgen.ir.operands import Cell, Hex, Integer, Named, Operand, Pointer, Range, Real, Text
from clickgen.ir.program import Action, KeptToken, Operands, Options, Program, actions_in, rungs_in
from clickgen.ir.walk import value_operands

AddressOf = Callable[[object], Address | None]


def cell_address(operand: object) -> Address | None:
    return operand.address if isinstance(operand, Cell) else None


def reached(action: Action, param: Param) -> Operand | None:
    """An operand with all the addresses that it covers; None if it is not an operand or was left out."""
    operand = action.args.get(param.name)
    if isinstance(operand, Cell):
        length = length_of(action, param)
        if length > 1 or param.extends_over:
            first = operand.address.number
            return Range(operand.bank, first, first + length - 1, operand.span)
        return operand
    return operand if operand.__class__ in _OPERANDS and isinstance(operand, Operand) else None


_OPERANDS: frozenset[type] = frozenset(get_args(Operand))
"""To ask for one class is faster than to ask for each of these in turn."""


def length_of(action: Action, param: Param, address_of: AddressOf = cell_address) -> int:
    """How many addresses an operand covers, from its own upward. ``address_of`` also resolves names."""
    operand = action.args.get(param.name)
    if param.extends_over:
        source = action.args.get(param.extends_over)
        return len(source) if isinstance(source, Range) else 1
    if param.extends_to:
        start, end = address_of(operand), address_of(action.args.get(param.extends_to))
        if start and end and start.bank == end.bank:
            return max(1, end.number - start.number + 1)
    if isinstance(operand, Named | Cell) and operand.bank == "TXT" and param.name == action.spec.matrix[1]:
        return characters(action)
    return 1


def characters(action: Action) -> int:
    """How many TXT addresses a copy may fill.

    No source says what CLICK makes of a number that goes to TXT without an option: it may be the digits.
    """
    source, options = action.args.get(action.spec.matrix[0]), action.args.get("options")
    if isinstance(source, Text):
        return max(1, len(source.value))
    if "to_text" not in action.spec.conversions or (isinstance(options, Options) and options.name != "to_text"):
        return 1
    end = 1 if isinstance(options, Options) and options.termination_code is not None else 0
    return _digits(source) + end


def _digits(source: object) -> int:
    """The most characters that a number becomes as text; 1 for anything else."""
    if isinstance(source, Integer):
        return len(str(source.value))
    if isinstance(source, Hex):
        return TEXT_WIDTHS[Kind.HEX]
    if isinstance(source, Real):
        return TEXT_WIDTHS[Kind.FLOAT]
    return TEXT_WIDTHS.get(BANKS[source.bank].kind, 1) if isinstance(source, Named | Cell | Pointer) else 1


class Touch(NamedTuple):
    """One operand of an action with all the addresses that it covers. An owned one is written.

    Addresses in a kept token are read and written: nobody knows what its instruction does.
    """

    operand: Operand
    is_written: bool
    param: Param


def touches(action: Action) -> Iterator[Touch]:
    """Yield every operand of an action, including those of its pins and formulas and the registers of its pointers."""
    args = action.args
    ends = action.spec.ends
    for param in action.spec.params:
        if param.name not in args or param.name in ends:
            continue
        operand = reached(action, param)
        is_written = param.slot.access is not Access.READ
        if operand is not None:
            yield Touch(operand, is_written, param)
            if isinstance(operand, Pointer):
                yield Touch(operand.register, False, param)
            if param.slot.access is Access.OWN and isinstance(operand, Cell):
                yield Touch(Cell(current_value(operand.address), operand.span), True, param)
        else:
            value = args[param.name]
            for operand in value_operands(value):
                is_kept = isinstance(value, KeptToken)
                if is_kept:
                    yield Touch(operand, False, param)
                yield Touch(operand, is_kept or (is_written and isinstance(value, Operands)), param)


def reaching(program: Program, address_of: AddressOf = cell_address) -> Iterator[tuple[Operand, int]]:
    """Yield every operand that covers more addresses than its own, and how many."""
    for routine in program.routines:
        for rung in rungs_in(routine.rungs):
            for action in actions_in(rung.items):
                for param in action.spec.params:
                    operand = action.args.get(param.name)
                    if isinstance(operand, Named | Cell):
                        length = length_of(action, param, address_of)
                        if length > 1:
                            yield operand, length
