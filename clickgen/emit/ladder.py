"""The ladder CSV files, one or several for main and one for each subroutine."""

from __future__ import annotations

import re

from clickgen.click.ladder_csv import HEADER
from clickgen.emit.writer import EarlierBuild, Writer, digest_of, first_line

_HEAD = ",".join(HEADER)
_MAIN = re.compile(r"main(_[0-9]+)?\.csv")
_SUBROUTINE = re.compile(r"subroutines/([^/]+)\.csv")


def _may_go(earlier: EarlierBuild, path: str) -> bool:
    """True for a file that nobody changed since the build wrote it."""
    return earlier.digest(path) == digest_of(earlier.read(path))


WRITER = Writer(
    paths=lambda built: built.ladders,
    write=lambda built, path: built.ladder_texts[path],
    owns=re.compile(f"{_MAIN.pattern}|{_SUBROUTINE.pattern}"),
    is_own=lambda data: first_line(data) == _HEAD,
    may_go=_may_go,
    folders=("subroutines",),
    rank=10,
)
