"""The looks of contacts, and conditions in which one contact replaces all looks at the same bit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from clickgen.click.draw.network import is_range
from clickgen.click.draw.tokens import compare_token, contact_token
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact


def look_of(leaf: Contact | Compare) -> str:
    """The look of a contact, as a token: a bit and its negation are one look."""
    leaf = asserted(leaf)
    return compare_token(leaf) if isinstance(leaf, Compare) else contact_token(leaf)


def asserted(leaf: Contact | Compare) -> Contact | Compare:
    """The contact that is on while its bit is. For a range, "none is on" is not the negation of "all are on"."""
    return replace(leaf, negated=False) if isinstance(leaf, Contact) and not is_range(leaf) else leaf


def looking_at(condition: Condition, kept: Mapping[str, Contact]) -> Condition:
    """The condition with the kept contacts, by their looks, in place of its own."""
    if isinstance(condition, All | Any):
        return type(condition)(tuple(looking_at(term, kept) for term in condition.terms), condition.span)
    if isinstance(condition, Always):
        return condition
    contact = kept.get(look_of(condition))
    if contact is None:
        return condition
    is_negated = isinstance(condition, Contact) and condition.negated and not is_range(condition)
    return replace(contact, span=condition.span, negated=is_negated)
