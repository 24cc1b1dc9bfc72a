"""A program has a main."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG401"


def find(facts: Facts) -> Findings:
    if facts.program.main is not None:
        return
    programs = facts.importers()
    main = facts.spell.routine("main", is_main=True)
    help = f"add {main} with the rungs that run in every scan"
    if programs:
        help = f"this file is a part of {' and of '.join(programs[:3])}: build {programs[0]}"
    yield finding(CODE, facts.program.source.span(1, 1, 1, 2), "the program has no main", help)


ABOUT = Code(
    "CG401",
    Severity.ERROR,
    "the program has no main",
    """
Without `def main():` nothing runs. If other files import this file, it is part of their program: build
the program that the message names.
""",
    wrong=(
        Wrong(
            """
@sub  # <-
def alarms():  # not called by anything: there is no def main
    if True:
        return
""",
        ),
    ),
    right=(
        """
@sub
def alarms():
    if True:
        return


def main():
    if True:
        call(alarms)
    if True:
        end()
""",
    ),
)

RULE = Rule(find, (ABOUT,))
