"""Proves that separate conditions hold exactly when the arms of an if with elif and else ran."""

from __future__ import annotations

from collections.abc import Sequence

from clickgen.ir.conditions import All, Any, Compare, Condition, Contact
from clickgen.ir.operands import Named, Single, form_of
from clickgen.ir.proposals import Alternative
from clickgen.logic.conditions import are_exclusive, implies, terms_of


def stand_alone(arms: Sequence[Alternative]) -> bool:
    """True if every arm's own condition holds alone exactly when it holds and none of the earlier ones does."""
    tests = [_opaque(arm.test) for arm in arms]
    return all(
        _stands_alone(_opaque(arm.alone), tests[index], tests[:index])
        for index, arm in enumerate(arms)
        if index  # The first arm stays as it is written.
    )


def _stands_alone(alone: Condition, own: Condition, earlier: Sequence[Condition]) -> bool:
    terms = sorted(terms_of(alone), key=lambda term: isinstance(term, All | Any))
    series = All(tuple(terms), alone.span)
    return (
        implies(series, own)
        and all(_excludes(test, own, terms) for test in earlier)
        and all(_follows(term, own, earlier) for term in terms)
    )


def _excludes(test: Condition, own: Condition, terms: Sequence[Condition]) -> bool:
    """True if an earlier test never holds together with these terms. One of them mostly shows it at once."""
    return are_exclusive(test, own) or any(are_exclusive(test, term) for term in terms) or are_exclusive(test, *terms)


def _follows(term: Condition, own: Condition, earlier: Sequence[Condition]) -> bool:
    """True if a term holds whenever the arm runs. Mostly the arm's own test or one earlier test shows it."""
    if implies(own, term) or any(implies(own, Any((term, test), term.span)) for test in earlier):
        return True
    return implies(own, Any((term, *earlier), term.span))


def _opaque(condition: Condition) -> Condition:
    """The condition with a bit of its own in place of each comparison of floating-point values.

    If a register may hold no number, nobody knows what one comparison says of another.
    """
    if isinstance(condition, All | Any):
        return type(condition)(tuple(map(_opaque, condition.terms)), condition.span)
    if isinstance(condition, Compare) and "DF" in (form_of(condition.left), form_of(condition.right)):
        text = f"{_shown(condition.left)} {condition.op} {_shown(condition.right)}"
        return Contact(Named("C", text, condition.span, 0), condition.span)
    return condition


def _shown(side: Single) -> str:
    return str(getattr(side, "address", None) or (type(side).__name__, getattr(side, "value", side)))
