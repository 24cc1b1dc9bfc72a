"""main has an unconditional end() (C0201); each subroutine ends in an unconditional return (C0105)."""

from __future__ import annotations

from clickgen.check.facts import Facts
from clickgen.diagnostics import Diagnostics
from clickgen.instructions.control import END, RETURN


def check(facts: Facts, problems: Diagnostics) -> None:
    ended: set[str] = set()
    for placed in facts.actions:
        routine = placed.routine
        if placed.spec is END:
            if not routine.is_main:
                problems.add(
                    "CG410", placed.action.span, "end() belongs in main; a subroutine ends in return", "write return"
                )
            elif placed.is_unconditional and placed.is_top:
                ended.add(routine.name)
        elif placed.spec is RETURN:
            if routine.is_main:
                problems.add(
                    "CG411", placed.action.span, "return belongs in a subroutine; main ends in end()", "write end()"
                )
            elif placed.is_unconditional and placed.is_top and placed.rung is routine.rungs[-1]:
                ended.add(routine.name)
    for routine in facts.program.routines:
        if routine.name in ended or not routine.is_whole:
            continue
        if routine.is_main:
            problems.add("CG403", routine.span, "main has no unconditional end()", "add at its end: if True: end()")
        else:
            problems.add(
                "CG404",
                routine.span,
                f"{routine.name} does not end in an unconditional return",
                "add as its last rung: if True: return",
            )
