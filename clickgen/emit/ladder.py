"""The ladder CSV files, one or several for main and one for each subroutine."""

from __future__ import annotations

import re

from clickgen.click.ladder_csv import HEADER, ladder_csv
from clickgen.emit.writer import EarlierBuild, Writer, first_line

_HEAD = ",".join(HEADER)
_MAIN = re.compile(r"main(_[0-9]+)?\.csv")
_SUBROUTINE = re.compile(r"subroutines/([^/]+)\.csv")


def _may_go(earlier: EarlierBuild, path: str) -> bool:
    """True when the file holds as many rungs as the map has for its routine: a person may have edited it."""
    match = _SUBROUTINE.fullmatch(path)
    if match:
        return _rungs_in(earlier.read(path)) == earlier.rungs_of(match[1])
    parts = (part for part in earlier.files if _MAIN.fullmatch(part))
    return sum(_rungs_in(earlier.read(part)) for part in parts) == earlier.rungs_of("main")


def _rungs_in(data: bytes) -> int:
    return len(re.findall(rb"(?m)^R,", data))


WRITER = Writer(
    paths=lambda built: built.ladders,
    write=lambda built, path: ladder_csv(built.ladders[path]),
    owns=re.compile(f"{_MAIN.pattern}|{_SUBROUTINE.pattern}"),
    is_own=lambda data: first_line(data) == _HEAD,
    may_go=_may_go,
    folders=("subroutines",),
    rank=10,
)
