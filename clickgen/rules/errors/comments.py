"""Rung comments stay within CLICK's limit and come out as they were written (click-facts [limit.comment])."""

from __future__ import annotations

from clickgen.device.limits import COMMENT_BYTES_MAX, comment_bytes, styled_part
from clickgen.facts.facts import Facts
from clickgen.ir.program import rungs_in
from clickgen.problems.diagnostics import Diagnostics


def check(facts: Facts, problems: Diagnostics) -> None:
    for routine in facts.program.routines:
        for rung in rungs_in(routine.rungs):
            if not rung.comment:
                continue
            size = comment_bytes(rung.comment)
            if size > COMMENT_BYTES_MAX:
                problems.add(
                    "CG413",
                    rung.head,
                    f"the comment of this rung takes {size} bytes in CLICK, which has room for {COMMENT_BYTES_MAX}",
                    "shorten it, or end the block with a blank line so that its first part stays in the source; "
                    "a line break costs 5 bytes",
                )
            styled = styled_part(rung.comment)
            if styled:
                problems.add(
                    "CG421",
                    rung.head,
                    f"CLICK would show {styled!r} of this rung's comment as styled text",
                    "write it without the marks",
                )
