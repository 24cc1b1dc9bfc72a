"""A subroutine that nothing calls."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.problems.diagnostics import Diagnostics
from clickgen.rules.rule import Rule, Wrong

CODE = "CG515"


def check(facts: Facts, problems: Diagnostics) -> None:
    for routine in facts.program.subroutines:
        if routine.name not in facts.calls:
            is_own = routine.span.path == facts.program.source.path
            problems.add(
                CODE,
                routine.span,
                f"{routine.name} is in the program and nothing calls it: its rungs never run",
                f"call it from main, or {'remove it' if is_own else 'leave it out of the import'}",
            )


RULE = Rule(
    CODE,
    check,
    """
The subroutine goes into the CLICK, and no rung of main calls it. Whatever it does, alarms or an emergency sequence
among it, does not happen. Its outputs stay as they are, and its timers do not run.
""",
    wrong=(
        Wrong(
            """
def main():
    if True:
        call(auto)

    if True:
        end()


@sub
def auto():
    if x.Start:
        out(y.Motor)

    if True:
        return


@sub
def alarms():  # <-
    if x.Overload:
        out(y.Horn)

    if True:
        return
"""
        ),
    ),
    right=(
        """
def main():
    if c.Auto:
        call("auto")

    if True:
        end()


@sub
def auto():
    if x.Start:
        out(y.Motor)

    if True:
        return
""",
    ),
)
