"""There is one main, and every routine has a name that CLICK takes and no other routine has."""

from __future__ import annotations

import re

from clickgen.check.facts import Facts
from clickgen.device.limits import SUBROUTINE_NAME_MAX, SUBROUTINES_MAX
from clickgen.diagnostics import Diagnostics, Label
from clickgen.ir.program import Routine

_NAME = re.compile(r"[A-Za-z0-9_ -]+")
_DEVICES = frozenset(("con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in range(1, 10))))
"""Names that Windows, where CLICK runs, takes for devices: no file can have them."""


def check(facts: Facts, problems: Diagnostics) -> None:
    program = facts.program
    if program.main is None:
        span = program.source.span(1, 1, 1, 2)
        problems.add("CG401", span, "the program has no main", "add def main(): with the rungs that run in every scan")
    seen: dict[str, Routine] = {}
    for routine in program.routines:
        earlier = seen.setdefault(routine.name.lower(), routine)
        if earlier is not routine:
            problems.add(
                "CG402",
                routine.span,
                f"there is a routine {earlier.name!r} already ({earlier.span})",
                "rename one of them",
                (Label(earlier.span, "the first one"),),
            )
    for routine in program.subroutines:
        _check_name(routine, problems)
    if len(program.subroutines) > SUBROUTINES_MAX:
        problems.add(
            "CG416",
            program.subroutines[SUBROUTINES_MAX].span,
            f"the program has {len(program.subroutines)} subroutines and CLICK takes {SUBROUTINES_MAX}",
            "join some of them",
        )


def _check_name(routine: Routine, problems: Diagnostics) -> None:
    name = routine.name
    if len(name) > SUBROUTINE_NAME_MAX:
        fault = f"it has {len(name)} characters and CLICK takes {SUBROUTINE_NAME_MAX}"
    elif not _NAME.fullmatch(name):
        fault = "CLICK takes letters, digits, _, - and space"
    elif name.lower() in _DEVICES:
        fault = "Windows takes it for a device, so no file can have it"
    else:
        return
    problems.add("CG417", routine.span, f"a subroutine cannot be named {name!r}: {fault}", "rename it")
