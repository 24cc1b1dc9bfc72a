"""Rung comments stay within CLICK's limit and come out as they were written (click-facts [limit.comment])."""

from __future__ import annotations

from clickgen.device.limits import COMMENT_BYTES_MAX, comment_bytes, styled_part
from clickgen.facts.facts import Facts
from clickgen.ir.program import rungs_in
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    for routine in facts.program.routines:
        for rung in rungs_in(routine.rungs):
            if not rung.comment:
                continue
            size = comment_bytes(rung.comment)
            if size > COMMENT_BYTES_MAX:
                yield finding(
                    "CG413",
                    rung.head,
                    f"the comment of this rung takes {size} bytes in CLICK, which has room for {COMMENT_BYTES_MAX}",
                    "shorten it, or end the block with a blank line so that its first part stays in the source; "
                    "a line break costs 5 bytes",
                )
            styled = styled_part(rung.comment)
            if styled:
                yield finding(
                    "CG421",
                    rung.head,
                    f"CLICK would show {styled!r} of this rung's comment as styled text",
                    "write it without the marks",
                )


CODES = (
    Code(
        "CG413",
        Severity.ERROR,
        "the rung comment is too long for CLICK",
        """
CLICK has 1400 bytes for a rung comment. A line break takes 5 of them. Put a blank line into the comment:
the lines above it stay in the source only.
""",
        right=(
            """
# Fills the tank while the level is low.
if c.Run:
    out(y[1])
""",
        ),
    ),
    Code(
        "CG421",
        Severity.WARNING,
        "CLICK shows part of this comment as styled text",
        """
In CLICK's comments, stars and underscores around words set a style: the marks vanish, and the words
become bold, italic or underlined.
""",
        wrong=(
            Wrong(
                """
# Check the **main** valve first.
if c.Run:  # <-
    out(y[1])
""",
            ),
        ),
        right=(
            """
# Check the main valve first: its bit is c.main_valve_open.
if c.Run:
    out(y[1])
""",
        ),
    ),
)

RULE = Rule(find, CODES, holds_in_parts=True)
