"""A subroutine that nothing calls."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG515"


def find(facts: Facts) -> Findings:
    for routine in facts.program.subroutines:
        if routine.name not in facts.calls:
            is_own = routine.span.path == facts.program.source.path
            yield finding(
                CODE,
                routine.span,
                f"{routine.name} is in the program and nothing calls it: its rungs never run",
                f"call it from main, or {'remove it' if is_own else 'leave it out of the import'}",
            )


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a subroutine is never called",
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

RULE = Rule(find, (ABOUT,))
