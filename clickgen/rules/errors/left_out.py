"""A rung that an import left out is drawn again before anything is built."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.problems.diagnostics import Diagnostics


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        if not placed.spec.variants:
            reason = " ".join(placed.action.word("reason").split())
            problems.add(
                "CG426",
                placed.action.span,
                "a rung was left out by clickgen import" + (f": {reason}" if reason else ""),
                "draw the rung again by hand from the old project, and take this line out",
            )
