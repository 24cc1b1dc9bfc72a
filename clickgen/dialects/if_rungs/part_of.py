"""The words of help for a file without a main that belongs to programs beside it."""

from __future__ import annotations

from clickgen.dialects.if_rungs.read.imports import ReadBytes, importers
from clickgen.problems.diagnostics import Diagnostics


def tell_of_programs(path: str, read_bytes: ReadBytes, problems: Diagnostics) -> None:
    """Add to the problem of a missing main which programs import the file: one of them can be built."""
    programs = importers(path, read_bytes)
    if programs:
        help = f"this file is a part of {' and of '.join(programs[:3])}: build {programs[0]}"
        problems.found = [one._replace(help=help) if one.code == "CG401" else one for one in problems.found]
