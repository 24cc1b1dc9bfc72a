"""Operands that their instruction does not take. One rule says so; the others say nothing more about them."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum, auto

from clickgen.device.banks import BANKS, READ_ONLY, Address, Kind
from clickgen.device.system import WRITABLE_SC, WRITABLE_SD
from clickgen.dialects.base import Spelling
from clickgen.instructions.spec import Access, Param, Slot
from clickgen.ir.formula_nodes import Operand as FormulaOperand
from clickgen.ir.formula_nodes import references
from clickgen.ir.operands import Cell, Constant, Immediate, Named, Operand, Pointer, Range, form_of
from clickgen.ir.program import Action, FormulaText, Operands
from clickgen.text.source import Span

_WRITABLE = {"SC": WRITABLE_SC, "SD": WRITABLE_SD}


class Refusal(Enum):
    """Why an instruction does not take an operand."""

    READ_ONLY = auto()
    IMMEDIATE = auto()
    POINTER = auto()
    CONSTANT = auto()
    BANK = auto()
    """Its bank, or a range in the place of one address, or the other way around."""


def operands_of(action: Action) -> Iterator[tuple[Param, Operand]]:
    """The operands of an action with their parameters. A name without an address is a problem already."""
    for param in action.spec.params:
        value = action.args.get(param.name)
        for operand in value.items if isinstance(value, Operands) else (value,):
            if isinstance(operand, Operand) and not isinstance(operand, Named):
                yield param, operand


def refusal(slot: Slot, operand: Operand) -> Refusal | None:
    """Why this place of an instruction does not take the operand; None where it does."""
    if slot.access is Access.WRITE and (read_only(slot, operand) or unwritable(operand)):
        return Refusal.READ_ONLY
    if isinstance(operand, Immediate):
        return None if operand.bank in slot.immediates else Refusal.IMMEDIATE
    if isinstance(operand, Pointer):
        return None if operand.bank in slot.pointers else Refusal.POINTER
    if isinstance(operand, Constant):
        return None if form_of(operand) in slot.constants else Refusal.CONSTANT
    return None if operand.bank in (slot.ranges if isinstance(operand, Range) else slot.cells) else Refusal.BANK


def refused(action: Action) -> set[Span]:
    """The places of the operands that the action does not take."""
    found = {operand.span for param, operand in operands_of(action) if refusal(param.slot, operand)}
    text = action.args.get("formula")
    for node in references(text.formula) if isinstance(text, FormulaText) else ():
        operand = node.ref if isinstance(node, FormulaOperand) else node.range
        if holds_no_number(operand.bank):
            found.add(operand.span)
    return found


def read_only(slot: Slot, operand: Operand) -> str:
    """Why nothing can write the bank of an operand; "" where something can (click-facts [bank.read-only])."""
    target = target_of(operand)
    reason = READ_ONLY.get(target.bank, "") if isinstance(target, Named | Cell | Range | Pointer) else ""
    is_reached = isinstance(target, Pointer) and target.bank in slot.pointers and target.bank != "XD"
    return "" if is_reached else reason


def unwritable(operand: Operand) -> tuple[Address, frozenset[int]] | None:
    """The first system point of an operand that nothing can write, with the numbers of its bank that can be written."""
    for address in addresses_named(operand):
        numbers = _WRITABLE.get(address.bank)
        if numbers is not None and address.number not in numbers:
            return address, numbers
    return None


def addresses_named(operand: Operand) -> list[Address]:
    """The addresses that a target names by number."""
    target = target_of(operand)
    if isinstance(target, Cell):
        return [target.address]
    return list(target.addresses()) if isinstance(target, Range) else []


def target_of(operand: Operand) -> Operand:
    """The operand without ``.immediate``."""
    return operand.target if isinstance(operand, Immediate) else operand


def holds_no_number(bank: str) -> bool:
    """True for a bank that a formula cannot read."""
    return BANKS[bank].kind in (Kind.BIT, Kind.TEXT)


def shown_target(spell: Spelling, target: object) -> str:
    """A target for a message."""
    if isinstance(target, Cell):
        return str(target.address)
    if isinstance(target, Named):
        return spell.name(target.bank, target.name)
    bank = form_of(target)
    return f"{'an' if bank[0] == 'X' else 'a'} {bank} address"
