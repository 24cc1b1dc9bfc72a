"""Every called subroutine exists; only main calls (click-facts, section 5)."""

from __future__ import annotations

from clickgen.check.facts import Facts
from clickgen.diagnostics import Diagnostics, did_you_mean
from clickgen.instructions.control import CALL
from clickgen.ir.program import Word


def check(facts: Facts, problems: Diagnostics) -> None:
    names = {routine.name for routine in facts.program.subroutines} | facts.program.misimported
    for placed in facts.actions:
        word = placed.action.args.get("subroutine")
        if placed.spec is not CALL or not isinstance(word, Word):
            continue
        if not placed.routine.is_main:
            problems.add(
                "CG406",
                placed.action.span,
                f"{placed.routine.name} is a subroutine and cannot call another",
                "call it from main; set a bit here that main's call stands on",
            )
        if word.value == "main":
            problems.add("CG405", word.span, "main is not a subroutine", "a subroutine stands under @sub")
        elif word.value not in names:
            module = facts.program.offered.get(str(word.value))
            help = did_you_mean(str(word.value), names) or f"add @sub def {word.value}():"
            if module:
                help = f"write from {module} import {word.value} at the top"
            problems.add("CG405", word.span, f"there is no subroutine {word.value!r}", help)
