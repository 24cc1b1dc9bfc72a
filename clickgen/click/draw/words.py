"""A condition in words: ``C1 and not C2 and (rise C3 or DS1 == 5)``."""

from __future__ import annotations

from clickgen.click.draw.network import bits
from clickgen.click.draw.tokens import Namer, operand_token
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.operands import Immediate, Range


def condition_words(condition: Condition, name: Namer = operand_token) -> str:
    """The condition as a person says it; ``name`` gives each operand its text."""
    if isinstance(condition, Contact):
        operand = name(condition.operand)
        target = condition.operand.target if isinstance(condition.operand, Immediate) else condition.operand
        if isinstance(target, Range) and len(target) > 1:
            return f"{'none' if condition.negated else 'all'} of {operand}"
        if isinstance(target, Range):
            (bit,) = bits(condition)
            return condition_words(bit, name)
        if condition.edge:
            return f"{condition.edge.value} {operand}"
        return f"not {operand}" if condition.negated else operand
    if isinstance(condition, Compare):
        return f"{name(condition.left)} {condition.op} {name(condition.right)}"
    if isinstance(condition, Always):
        return "always"
    kept = [term for term in condition.terms if not isinstance(term, Always)]
    if not kept:
        return "always"
    word = " and " if isinstance(condition, All) else " or "
    return word.join(term_words(term, condition, name) for term in kept)


def term_words(term: Condition, whole: All | Any, name: Namer = operand_token) -> str:
    """One term of a series or a parallel, in brackets if it mixes the two."""
    text = condition_words(term, name)
    if isinstance(term, Any if isinstance(whole, All) else All) and len(term.terms) > 1:
        return f"({text})"
    return text
