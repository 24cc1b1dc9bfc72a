"""Formulas for the rules: the place of a part, and registers in them that hold nothing but 0."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from clickgen.facts.facts import Facts, Placed
from clickgen.facts.uses import Use
from clickgen.formula.values import value_of
from clickgen.instructions.effects import Shape
from clickgen.ir.conditions import Compare
from clickgen.ir.formula_nodes import Node
from clickgen.ir.operands import Cell, Hex, Integer, Real
from clickgen.ir.program import FormulaText
from clickgen.logic.conditions import are_exclusive
from clickgen.text.source import Span

_BANKS = ("DS", "DD", "DH", "DF")
"""Banks whose registers hold only what the program or a panel puts there."""


class Calculation(NamedTuple):
    """A calc or math_hex and its formula."""

    placed: Placed
    formula: FormulaText

    @property
    def destination(self) -> Cell | None:
        cell = self.placed.action.moved_to
        return cell if isinstance(cell, Cell) else None


def calculations(facts: Facts) -> Iterator[Calculation]:
    """Every calc and math_hex of a program, in source order."""
    for placed in facts.actions:
        formula = placed.action.moved
        if isinstance(formula, FormulaText):
            yield Calculation(placed, formula)


def place_of(facts: Facts, formula: FormulaText, node: Node) -> Span:
    """The place of a part of the formula; the whole formula if its literal is more than quotes around it."""
    span = formula.span
    text = facts.text(span)
    if text[:1] not in ('"', "'") or text[:2] in ('""', "''") or "\\" in text or text.count(text[0]) != 2:
        return span
    return Span(span.path, span.line, span.col + 1 + node.start, span.line, span.col + 1 + node.end)


def shown_register(facts: Facts, cell: Cell) -> str:
    """A register as the language writes it."""
    return facts.text(cell.span) or facts.spell.cell(cell.address)


def holds_only_zero(facts: Facts, placed: Placed, cell: Cell) -> str:
    """``nothing`` or ``nothing but 0``: what the program writes to a register that is 0 when a formula runs.

    "" if it may hold another number, as far as the program shows.
    """
    if cell.bank not in _BANKS or facts.is_set_up(cell.address):
        return ""
    if facts.uses.is_pointed(cell.bank, is_written=True) or _is_tested(placed, cell):
        return ""
    writes = facts.uses.writes(cell.address)
    if not all(map(_writes_zero, writes)):
        return ""
    return "nothing but 0" if writes else "nothing"


def _is_tested(placed: Placed, cell: Cell) -> bool:
    """True if the formula only runs while the register is not 0."""
    zero = Hex(0, cell.span) if cell.bank == "DH" else Integer(0, cell.span)
    return are_exclusive(placed.condition, Compare("==", cell, zero, cell.span))


def _writes_zero(use: Use) -> bool:
    """True for an instruction that writes nothing but 0."""
    assert use.action is not None
    moved = use.action.moved
    if isinstance(moved, FormulaText):
        return value_of(moved.formula.root) == 0
    is_plain = use.action.effects.shape in (Shape.VALUE, Shape.FILL)
    return is_plain and isinstance(moved, Integer | Hex | Real) and moved.value == 0
