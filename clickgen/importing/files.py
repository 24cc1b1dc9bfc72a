"""Routines to the texts of a program's files: one for all, or one for each subroutine."""

from __future__ import annotations

from collections.abc import Sequence

from clickgen.importing.pieces import Names
from clickgen.importing.source import functions_of, write_source
from clickgen.ir.program import Routine

_DEVICES = {"con", "prn", "aux", "nul", *(f"{port}{digit}" for port in ("com", "lpt") for digit in range(1, 10))}
"""Names that Windows keeps for devices: no file can have them, whatever its ending."""


def a_file_each(routines: Sequence[Routine], names: Names) -> dict[str, str]:
    """The text of each file by its name: main imports the subroutines in their order."""
    subroutines = [routine for routine in routines if not routine.is_main]
    imports = "\n".join(f"from {_module(routine)} import {routine.function}" for routine in subroutines)
    functions = functions_of(routines)
    files = {f"{_module(routine)}.py": write_source([routine], names) for routine in subroutines}
    mains = [routine for routine in routines if routine.is_main]
    return {"main.py": write_source(mains, names, imports, functions), **files} if mains else files


def _module(routine: Routine) -> str:
    return f"{routine.function}_" if routine.function.lower() in _DEVICES else routine.function
