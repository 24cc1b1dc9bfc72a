"""Immediate contacts are inputs (click-facts [contact.immediate])."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.ir.operands import Immediate
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    for contact in facts.contacts:
        operand = contact.operand
        if isinstance(operand, Immediate) and operand.bank != "X":
            yield finding(
                "CG308",
                operand.span,
                f"an immediate contact reads an input X, not {operand.bank}",
                f"leave out {facts.spell.immediate}",
            )


ABOUT = Code(
    "CG308",
    Severity.ERROR,
    "immediate has no place here",
    """
Only X can be an immediate contact, and only Y an immediate coil. Edges are never immediate.
""",
    wrong=(
        Wrong(
            """
if c.Run.immediate:  # <-
    out(y[1])
""",
        ),
    ),
    right=(
        """
if x[1].immediate:
    out(y[1].immediate)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
