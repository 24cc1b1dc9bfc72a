"""The ladder files of a build, read back: what CLICK gets."""

from __future__ import annotations

import re
from collections.abc import Mapping

from clickgen.click.read.grid import Ladder, read_ladder

_PART = re.compile(r"main(?:_([0-9]+))?\.csv")
_SUBROUTINE = re.compile(r"subroutines/(.+)\.csv")


def built_ladders(files: Mapping[str, str], shown: str = "") -> dict[str, Ladder]:
    """The ladder of each routine out of the outputs of a build, by CLICK's names. ``shown`` stands before their files.

    The parts of a long main are one ladder, its rungs numbered through.
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
