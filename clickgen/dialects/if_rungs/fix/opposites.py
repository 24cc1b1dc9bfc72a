"""The opposite of a condition, where the language can say it."""

from __future__ import annotations

from clickgen.ir.conditions import OPPOSITE, All, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Named, Section


def opposite(condition: Condition) -> Condition | None:
    """The opposite; None for what has none: an edge, a range, an immediate contact that would be read again.

    A name counts as one bit and a register as a number. That is a proposal: whether the name is one of a block, and
    whether the register may hold no number, is judged when names are addresses.
    """
    if isinstance(condition, All | Any):
        terms = [opposite(term) for term in condition.terms]
        kept = tuple(term for term in terms if term is not None)
        if len(kept) < len(terms):
            return None
        return Any(kept, condition.span) if isinstance(condition, All) else All(kept, condition.span)
    if isinstance(condition, Compare):
        return Compare(OPPOSITE[condition.op], condition.left, condition.right, condition.span)
    if not isinstance(condition, Contact) or condition.edge:
        return None
    bit = condition.operand
    if isinstance(bit, Cell) or (isinstance(bit, Named) and not isinstance(bit.part, Section)):
        return Contact(bit, condition.span, not condition.negated)
    return None
