"""The ladder files of a build, read back as CLICK gets them."""

from __future__ import annotations

import re
from collections.abc import Mapping

from clickgen.click.read.grid import Ladder, read_ladder

_PART = re.compile(r"main(?:_([0-9]+))?\.csv")
_SUBROUTINE = re.compile(r"subroutines/(.+)\.csv")


def built_ladders(files: Mapping[str, str], shown: str = "") -> dict[str, Ladder]:
    """Return the ladder of each routine from the outputs of a build, by CLICK's names. ``shown`` goes before their
    files.

    The parts of a long main are one ladder, with its rungs numbered consecutively.
    """
    found: dict[str, Ladder] = {}
    for file in sorted(files, key=_number):
        subroutine = _SUBROUTINE.fullmatch(file)
        if subroutine is None and not _PART.fullmatch(file):
            continue
        name = subroutine[1] if subroutine else "main"
        ladder = read_ladder(files[file], f"{shown}{file}")
        before = found.get(name, Ladder((), ()))
        rungs = [rung.numbered(len(before.rungs) + rung.number) for rung in ladder.rungs]
        found[name] = Ladder((*before.rungs, *rungs), (*before.problems, *ladder.problems))
    return found


def _number(file: str) -> int:
    part = _PART.fullmatch(file)
    return int(part[1] or 1) if part else 0
