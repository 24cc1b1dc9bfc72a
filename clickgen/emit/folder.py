"""The output folder: what an earlier build left in it, and what must not be there (click-facts [ladder-file.bundle]).

The source map of the last build says what it made. Anybody can write a source map, so a file is replaced only where it
also looks as a build makes it, with the head of its kind, and removed only where it is what the map says was written.
"""

from __future__ import annotations

import json
import re
import stat
from collections.abc import Iterable, Mapping
from pathlib import Path

from clickgen.click.ladder_csv import HEADER as LADDER_COLUMNS
from clickgen.emit.sourcemap import NAME, digest_of, is_ladder
from clickgen.table.rows import HEADER as NICKNAME_HEAD
from clickgen.workspace import leads_elsewhere, read_file

_LADDER_HEAD = ",".join(LADDER_COLUMNS)
_MAIN_PART = re.compile(r"main(_[0-9]+)?\.csv")
_SUBROUTINE = re.compile(r"subroutines/([^/]+)\.csv")


class ForeignFiles(Exception):
    """The folder holds files in the way that clickgen did not make; the message names them."""


def stale_files(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Files of an earlier build that this one does not make.

    Raises ForeignFiles when an output would replace a file that is not an earlier output, and when other CSV files
    are there: ClickNick's guided paste takes every CSV file of the folder as ladder (click-facts [ladder-file.guided]).
    """
    away = folder / "subroutines"
    if leads_elsewhere(away):
        raise ForeignFiles(f"{away} is a link to another place; take it away, or choose another folder with -o")
    noted = _Noted.read(folder)
    there = {path.relative_to(folder).as_posix(): path for path in _csv_files(folder)}
    leftovers = {name: path for name, path in there.items() if name not in files}
    in_the_way = [path for name, path in leftovers.items() if not noted.may_go(name)]
    if in_the_way:
        raise ForeignFiles(_message(folder, "ClickNick would take these for ladder", in_the_way))
    taken = [
        folder / name
        for name, data in files.items()
        if _differs(folder / name, data) and not noted.may_be_replaced(name)
    ]
    if taken:
        raise ForeignFiles(_message(folder, "these are not an earlier build's", taken))
    return [*leftovers.values()]


def _csv_files(folder: Path) -> list[Path]:
    """Files that Windows takes for CSV, whatever the case of their ending."""
    folders = [place for place in (folder, folder / "subroutines") if place.is_dir()]
    return sorted(path for place in folders for path in place.iterdir() if path.suffix.casefold() == ".csv")


def _differs(path: Path, data: bytes) -> bool:
    return path.is_file() and read_file(path) != data


def _message(folder: Path, why: str, paths: list[Path]) -> str:
    names = ", ".join(path.relative_to(folder).as_posix() for path in paths)
    return (
        f"{folder} holds files that clickgen did not make ({why}): {names}; move them, or choose another folder with -o"
    )


class _Noted:
    """What the source map of the last build says of the folder, and what of it is to be believed."""

    def __init__(self, folder: Path, files: Iterable[object], digests: Mapping[str, object]) -> None:
        self._folder = folder
        self._files = {name for name in files if isinstance(name, str)}
        self._digests = digests

    @classmethod
    def read(cls, folder: Path) -> _Noted:
        try:
            noted = json.loads(read_file(folder / NAME))
        except (OSError, ValueError, RecursionError):
            noted = None
        is_ours = isinstance(noted, dict) and noted.get("generator") == "clickgen"
        files, digests = (noted.get("files"), noted.get("digests")) if is_ours else (None, None)
        return cls(folder, files if isinstance(files, list) else (), digests if isinstance(digests, dict) else {})

    def may_be_replaced(self, name: str) -> bool:
        """True for an output that is noted and begins as a build's; an empty file holds nothing that could be lost."""
        if name not in self._files:
            return False
        try:
            is_file = stat.S_ISREG((self._folder / name).lstat().st_mode)
            data = read_file(self._folder / name) if is_file else None
        except OSError:
            return False
        if data is None:
            return False
        head = data.split(b"\n", 1)[0].rstrip(b"\r").decode("utf-8", "replace")
        if name == "listing.txt":
            return not data or head.startswith("CLICK program ")
        if name == "nicknames.csv":
            return not data or head == NICKNAME_HEAD
        is_ladder = _MAIN_PART.fullmatch(name) or _SUBROUTINE.fullmatch(name)
        return name == NAME or not data or (is_ladder is not None and head == _LADDER_HEAD)

    def may_go(self, name: str) -> bool:
        """True for a leftover that a build made: a ladder file that is still what was written then."""
        if not is_ladder(name) or not self.may_be_replaced(name):
            return False
        return self._digests.get(name) == digest_of(read_file(self._folder / name))
