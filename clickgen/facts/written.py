"""The number that an instruction leaves in a register, and when: for rules that follow a number through the program."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.copied import put_in
from clickgen.facts.facts import FIRST_SCAN, Facts, Placed
from clickgen.formula.values import value_of
from clickgen.ir.conditions import All, Compare, Condition, Contact
from clickgen.ir.formula_nodes import references
from clickgen.ir.operands import Cell, Hex, Integer
from clickgen.ir.program import FormulaText
from clickgen.logic.conditions import are_exclusive, implies, looked_at, terms_of
from clickgen.text.source import Span


def left_in(writer: Placed, address: Address, before: int) -> int | None:
    """The number that a writer leaves in a register that held ``before``; None if that is not known."""
    formula = writer.action.moved
    if isinstance(formula, FormulaText):
        value = value_of(formula.formula.root, {address: before})
        return int(value) if value is not None and value == int(value) else None
    put = put_in(writer, address)
    return put.value if isinstance(put, Integer | Hex) else None


def is_relative(writer: Placed, address: Address) -> bool:
    """True for a formula that makes a register's new number from its own."""
    formula = writer.action.moved
    if not isinstance(formula, FormulaText):
        return False
    refs = (getattr(part, "ref", None) for part in references(formula.formula))
    return any(isinstance(ref, Cell) and ref.address == address for ref in refs)


def span_of(writer: Placed) -> Span:
    """The place of the number that a writer leaves, or of the writer itself."""
    moved = writer.action.moved
    return moved.span if isinstance(moved, Integer | Hex) else writer.action.span


def equals(address: Address, number: int, span: Span) -> Compare:
    """The condition that a register holds a number."""
    constant = Hex(number, span) if address.bank == "DH" else Integer(number, span)
    return Compare("==", Cell(address, span), constant, span)


def whole_condition(facts: Facts, placed: Placed) -> All:
    """The condition for an action to run, with the calls of its subroutine, seen through coils too."""
    call = facts.sometimes(placed.routine)
    own = facts.ways_to(placed)
    return All(own if call is None else (*own, call), placed.action.span)


class Asked:
    """The conditions of an action on a register."""

    def __init__(self, facts: Facts, placed: Placed, address: Address) -> None:
        self._address = address
        self._span = placed.action.span
        self._terms = tuple(term for term in terms_of(whole_condition(facts, placed)) if address in looked_at(term))

    @property
    def is_asked(self) -> bool:
        """True if its condition looks at the register."""
        return bool(self._terms)

    def may_be(self, number: int) -> bool:
        """False if the action never runs while the register holds a number."""
        return not self._terms or not are_exclusive(*self._terms, equals(self._address, number, self._span))

    def implies(self, other: Condition) -> bool:
        """True if the condition of the action says something of the register."""
        return bool(self._terms) and implies(All(self._terms, self._span), other)


def runs_at_start_only(facts: Facts, placed: Placed) -> bool:
    """True for an action that runs only in the first scan."""
    first = Contact(Cell(FIRST_SCAN, placed.action.span), placed.action.span)
    return implies(whole_condition(facts, placed), first)
