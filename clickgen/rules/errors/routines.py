"""Every routine has a name that CLICK takes and no other routine has."""

from __future__ import annotations

import re

from clickgen.device.limits import SUBROUTINE_NAME_MAX, SUBROUTINES_MAX
from clickgen.dialects.base import Spelling
from clickgen.facts.facts import Facts
from clickgen.ir.program import Program, Routine
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

_MAIN = "main"
# click-facts [limit.subroutine-names]
_NAME = re.compile(r"[A-Za-z0-9_ -]+")
_DEVICES = frozenset(("con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in range(1, 10))))
"""Names that Windows, where CLICK runs, takes for devices: no file can have them."""


def find(facts: Facts) -> Findings:
    program = facts.program
    yield from _check_twice(program)
    for routine in program.subroutines:
        yield from _check_name(facts.spell, routine)
    if len(program.subroutines) > SUBROUTINES_MAX:
        yield finding(
            "CG416",
            program.subroutines[SUBROUTINES_MAX].span,
            f"the program has {len(program.subroutines)} subroutines and CLICK takes {SUBROUTINES_MAX}",
            "join some of them",
        )


def _check_twice(program: Program) -> Findings:
    """One name in CLICK, where names are files, and one function in the source."""
    names: dict[str, Routine] = {}
    functions: dict[str, Routine] = {}
    for routine in program.routines:
        # A subroutine named like main is refused for that.
        is_kept = not routine.is_main and routine.name.lower() == _MAIN
        earlier = routine if is_kept else names.setdefault(routine.name.lower(), routine)
        namesake = functions.setdefault(routine.function, routine)
        if earlier is not routine:
            fault, place, first = f"routine {earlier.name!r}", routine.named_at, earlier.named_at
        elif namesake is not routine:
            fault, place, first = f"function {routine.function!r}", routine.span, namesake.span
        else:
            continue
        message = f"there is a {fault} already ({first})"
        yield finding("CG402", place, message, "rename one of them", (Label(first, "the first one"),))
    for routine in program.routines:
        other = names.get(routine.function.lower(), routine)
        if other is not routine and routine.function.lower() != routine.name.lower():
            yield finding(
                "CG402",
                routine.span,
                f"the function {routine.function!r} is called like the subroutine {other.name!r} ({other.named_at}), "
                "and is another one",
                "rename the function",
                (Label(other.named_at, "CLICK's name"),),
            )


def _check_name(spell: Spelling, routine: Routine) -> Findings:
    name = routine.name
    mark = spell.subroutine_mark("Auto Mode")
    help = "rename it" if routine.title else f"rename it, or write CLICK's name beside it: {mark}"
    if not name.strip():
        plain = spell.subroutine_mark()
        fault, help = "there is nothing in it", f"write a name, or {plain} alone to use the function's name"
    elif len(name) > SUBROUTINE_NAME_MAX:
        fault = f"it has {len(name)} characters and CLICK takes {SUBROUTINE_NAME_MAX}"
    elif not _NAME.fullmatch(name):
        fault = "CLICK takes letters, digits, _, - and space"
    elif name != name.strip():
        fault, help = "it has a space at its beginning or end", f"write {spell.subroutine_mark(name.strip())}"
    elif name.lower() == _MAIN:
        fault = "the main program has this name"
    elif name.lower() in _DEVICES:
        fault = "Windows takes it for a device, so no file can have it"
    else:
        return
    yield finding("CG417", routine.named_at, f"a subroutine cannot be named {name!r}: {fault}", help)


CODES = (
    Code(
        "CG402",
        Severity.ERROR,
        "two routines have the same name",
        """
Two routines have the same name in CLICK, or two functions have the same name in the source. Case does
not matter in CLICK's names, because each name becomes a file.
""",
        wrong=(
            Wrong(
                """
@sub
def Alarms():
    if True:
        return


@sub
def alarms():  # <-
    if True:
        return


def main():
    if True:
        end()
""",
            ),
        ),
        right=(
            """
@sub
def alarms():
    if True:
        return


@sub
def old_alarms():
    if True:
        return


def main():
    if c.Old:
        call(old_alarms)
    if nc(c.Old):
        call(alarms)
    if True:
        end()
""",
        ),
    ),
    Code(
        "CG416",
        Severity.ERROR,
        "too many subroutines",
        """
CLICK takes at most 986 subroutines.
""",
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
    ),
    Code(
        "CG417",
        Severity.ERROR,
        "CLICK does not take this subroutine name",
        """
A subroutine's name in CLICK has at most 24 characters: letters, digits, `_`, `-`, and spaces that are
not at its beginning or end. The name becomes a file name, so it cannot be a word that Windows reserves for devices,
such as `con` or `com1`. `main` is the main program.

If the function must keep its name, give the subroutine another name in CLICK: `@sub("Conveyor")` above `def con():`.
""",
        wrong=(
            Wrong(
                """
@sub
def con():  # <-
    if True:
        return


def main():
    if True:
        call(con)
        end()
""",
            ),
        ),
        right=(
            """
@sub("Conveyor")
def con():
    if True:
        return


def main():
    if True:
        call(con)
    if True:
        end()
""",
        ),
    ),
)

RULE = Rule(find, CODES, holds_in_parts=True)
