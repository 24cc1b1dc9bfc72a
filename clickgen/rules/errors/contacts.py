"""Immediate contacts are inputs (click-facts [contact.immediate])."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.ir.operands import Immediate
from clickgen.problems.diagnostics import Diagnostics


def check(facts: Facts, problems: Diagnostics) -> None:
    for contact in facts.contacts:
        operand = contact.operand
        if isinstance(operand, Immediate) and operand.bank != "X":
            problems.add(
                "CG308",
                operand.span,
                f"an immediate contact reads an input X, not {operand.bank}",
                "leave out .immediate",
            )
