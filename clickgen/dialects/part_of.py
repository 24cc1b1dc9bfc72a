"""The words of help for a file without a main that belongs to programs beside it."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress

from clickgen.dialects.base import Look
from clickgen.dialects.registry import dialect_of, suffixes
from clickgen.problems.diagnostics import Diagnostics

ReadBytes = Callable[[str], bytes]
"""The bytes of a file by its path as shown; raises OSError."""

_SIBLINGS_MAX = 200
"""So many files of a folder are looked through for a message."""


def tell_of_programs(path: str, read_bytes: ReadBytes, problems: Diagnostics) -> None:
    """Add to the problem of a missing main which programs import the file: one of them can be built."""
    programs = importers(path, read_bytes)
    if programs:
        help = f"this file is a part of {' and of '.join(programs[:3])}: build {programs[0]}"
        problems.found = [one._replace(help=help) if one.code == "CG401" else one for one in problems.found]


def importers(path: str, read_bytes: ReadBytes) -> list[str]:
    """The programs beside a file that it is a part of: they have a main, and import it, or import what does."""
    folder, own = os.path.split(path)
    looks: dict[str, Look] = {}
    for name in _siblings(folder)[:_SIBLINGS_MAX]:
        other = os.path.join(folder, name)
        with suppress(OSError):
            if name != own and os.path.isfile(other):
                text = read_bytes(other).decode("utf-8-sig", "replace").replace("\r\n", "\n")
                looks[name] = dialect_of(other, text).look(other, text)
    imported = {name: {os.path.basename(file) for file in look.imports} for name, look in looks.items()}
    known = waiting = {own}
    while waiting:
        waiting = {name for name, files in imported.items() if not files.isdisjoint(waiting)} - known
        known = known | waiting
    return [os.path.join(folder, name) for name in sorted(known - {own}) if looks[name].has_main]


def _siblings(folder: str) -> list[str]:
    try:
        return sorted(name for name in os.listdir(folder or ".") if name.endswith(suffixes()))
    except OSError:
        return []
