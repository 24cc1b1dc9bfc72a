"""A rung that an import left out is drawn again before anything is built."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        if not placed.spec.variants:
            reason = " ".join(placed.action.word("reason").split())
            yield finding(
                "CG426",
                placed.action.span,
                "a rung was left out by clickgen import" + (f": {reason}" if reason else ""),
                "draw the rung again by hand from the old project, and take this line out",
            )


ABOUT = Code(
    "CG426",
    Severity.ERROR,
    "a rung was left out by import",
    """
`clickgen import --keep-going` puts `not_imported("...")`, with the reason, in the place of each rung
that it could not keep. The program would lack that rung, so it does not build.

Write the rung by hand from the old project, in place of that line.
""",
    wrong=(
        Wrong(
            """
if True:
    not_imported("main.csv:45: the contacts are wired in too many ways")  # <-
""",
        ),
    ),
    right=(
        """
if any(all(x[1], c.Ready), c.Manual):
    out(y[1])
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
