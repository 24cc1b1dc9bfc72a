"""Writes routines as the texts of a program's files: one for all, or one for each subroutine."""

from __future__ import annotations

from collections.abc import Sequence

from clickgen.dialects.if_rungs.write.expressions import Names
from clickgen.dialects.if_rungs.write.routine import functions_of, write_source
from clickgen.ir.program import Routine


def a_file_each(routines: Sequence[Routine], names: Names) -> dict[str, str]:
    """The text of each file by its name: main imports the subroutines in their order."""
    subroutines = [routine for routine in routines if not routine.is_main]
    imports = "\n".join(f"from {routine.function} import {routine.function}" for routine in subroutines)
    functions = functions_of(routines)
    files = {f"{routine.function}.py": write_source([routine], names) for routine in subroutines}
    mains = [routine for routine in routines if routine.is_main]
    return {"main.py": write_source(mains, names, imports, functions), **files} if mains else files
