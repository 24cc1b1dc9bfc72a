"""Conditions turned round: what has an opposite that the language can say, and that opposite."""

from __future__ import annotations

import re

from clickgen.ir.conditions import OPPOSITE, All, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Named
from clickgen.syntax.context import Context


def opposite(context: Context, condition: Condition) -> Condition | None:
    """The opposite, where the language has a word for it; an immediate contact may differ when it is read again."""
    if isinstance(condition, All | Any):
        terms = [opposite(context, term) for term in condition.terms]
        kept = tuple(term for term in terms if term is not None)
        if len(kept) < len(terms):
            return None
        return Any(kept, condition.span) if isinstance(condition, All) else All(kept, condition.span)
    if isinstance(condition, Compare):
        return Compare(OPPOSITE[condition.op], condition.left, condition.right, condition.span)
    if not isinstance(condition, Contact) or condition.edge:
        return None
    bit = condition.operand
    if isinstance(bit, Cell) or (isinstance(bit, Named) and (isinstance(bit.part, int) or not is_block(context, bit))):
        return Contact(bit, condition.span, not condition.negated)
    return None


def is_block(context: Context, named: Named) -> bool:
    """True for a block and what is in it, as far as this file says so."""
    return named.part is not None or names_block(context, named.bank, named.name)


def names_block(context: Context, bank: str, name: str) -> bool:
    """True where the file declares this as the name of a range: of that nothing is the opposite."""
    word = re.escape(name)
    declared = rf"""nickname\s*\(\s*{bank}\s*(\.\s*{word}\b|\[\s*["']{word}["']\s*\])\s*,\s*\w+\s*\[[^]\n]*:"""
    return re.search(declared, context.source.text, re.IGNORECASE) is not None
