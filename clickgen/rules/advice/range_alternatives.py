"""A range as an alternative of any(...): it reads "one of them" and means all of them."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.facts.facts import Facts
from clickgen.ir.conditions import All, Any, Condition, Contact
from clickgen.ir.operands import Immediate, Range
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.edits import Edit, Fix

CODE = "CG526"

_BITS_MAX = 16
"""The fix writes out ranges up to this length."""


def find(facts: Facts) -> Findings:
    for condition in facts.conditions:
        for contact in _alternatives(condition, False):
            bits = _bits(facts, contact)
            if len(bits) > 1:
                state = "off, not that one of them is" if contact.negated else "on, not that one of them is"
                every = "both" if len(bits) == 2 else f"all {len(bits)}"
                each = [*bits[:2], *(["..."] if len(bits) > 2 else [])]
                group = facts.spell.some("...")
                text = facts.text(contact.span)
                # A comment between the brackets would be lost.
                is_plain = len(bits) <= _BITS_MAX and "\n" not in text
                fix = Fix((Edit(contact.span, ", ".join(bits)),), is_safe=False) if is_plain else None
                yield finding(
                    CODE,
                    contact.span,
                    f"{text} in {group} means that {every} bits are {state}",
                    f"for one of them write {facts.spell.some(*each)}; for all of them say so with "
                    f"{facts.spell.every(text)}",
                    fix=fix,
                )


def _alternatives(condition: Condition, is_alternative: bool) -> Iterator[Contact]:
    """Yield the contacts that are a term of any(...) by themselves."""
    if isinstance(condition, All | Any):
        for term in condition.terms:
            yield from _alternatives(term, isinstance(condition, Any))
    elif isinstance(condition, Contact) and is_alternative:
        yield condition


def _bits(facts: Facts, contact: Contact) -> list[str]:
    """The contacts for a range, as a program writes them; none if it is not a range."""
    operand = contact.operand
    target = operand.target if isinstance(operand, Immediate) else operand
    if not isinstance(target, Range):
        return []
    end = facts.spell.immediate if isinstance(operand, Immediate) else ""
    bits = [f"{bit}{end}" for bit in _members(facts, facts.text(target.span), target)]
    return list(map(facts.spell.off, bits)) if contact.negated else bits


def _members(facts: Facts, text: str, bits: Range) -> list[str]:
    """Each bit of a range: by its number, or as a member of the block that the text names as a whole."""
    if facts.spell.is_name(text):
        return [facts.spell.member(text, index) for index in range(len(bits))]
    return list(map(facts.spell.cell, bits.addresses()))


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a range among alternatives means all of its bits",
    """
A range as a contact means every bit of it in series: `c[1:5]` is on when C1, C2, C3 and C4 all are, and `nc(c[1:5])`
when all of them are off. Inside `any(...)` it reads as if one bit were enough, as in Python, and a horn that should
sound with any of four alarms waits for all four.

Where one bit is to be enough, name them one by one; the fix does it for up to sixteen. It is never safe, for it changes
when the condition is on: with any of the bits instead of with all of them. Where all of them are meant, put `all(...)`
around the range, and the rule is quiet.
""",
    wrong=(
        Wrong(
            """
if any(c[1:5]):  # <-
    out(y.Horn)
""",
            """
if any(c[1], c[2], c[3], c[4]):  # <-
    out(y.Horn)
""",
        ),
        Wrong(
            """
if all(c.Run, any(c.EmergencyStop, nc(x[1:4]))):  # <-
    reset(c.Run)
""",
            """
if all(c.Run, any(c.EmergencyStop, nc(x[1]), nc(x[2]), nc(x[3]))):  # <-
    reset(c.Run)
""",
        ),
        Wrong(
            """
if any(c.Test, c[101:201]):  # <-
    out(y.Horn)
"""
        ),
    ),
    right=(
        """
if any(c[1], c[2], c[3], c[4]):
    out(y.Horn)
if any(c.Test, all(c[1:5]), all(c.Run, nc(c[1:5]))):
    out(y.Lamp)
if all(c[1:5], nc(c[11:15])):
    out(y.Pump)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
