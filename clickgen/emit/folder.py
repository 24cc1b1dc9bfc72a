"""The output folder: what an earlier build left in it, and what must not be there (click-facts [ladder-file.bundle]).

The source map of the last build says what it made. Anybody can write a source map, so a file counts as made by a build
only where its writer recognizes it too: by its path and by its contents. It is removed only where it is what the map
says was written.
"""

from __future__ import annotations

import json
import stat
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from clickgen.emit.registry import folders, writer_of
from clickgen.emit.source_map import PATH as MAP
from clickgen.emit.writer import Writer
from clickgen.workspace import Workspace, leads_elsewhere


class ForeignFiles(Exception):
    """The folder holds files in the way that clickgen did not make; the message names them."""


def stale_files(folder: Path, files: Mapping[str, bytes], disk: Workspace) -> list[Path]:
    """Return the files of an earlier build that this one does not make. ``disk`` shows what the folder holds now.

    Raises ForeignFiles when an output would replace a file that is not an earlier output, and when other CSV files
    are there: ClickNick's guided paste takes every CSV file of the folder as ladder (click-facts [ladder-file.guided]).
    """
    for away in (folder / name for name in folders()):
        if leads_elsewhere(away):
            raise ForeignFiles(f"{away} is a link to another place; take it away, or choose another folder with -o")
    noted = _Noted.of(folder, disk)
    there = {path.relative_to(folder).as_posix(): path for path in _csv_files(folder)}
    leftovers = {name: path for name, path in there.items() if name not in files}
    in_the_way = [path for name, path in leftovers.items() if not noted.may_go(name)]
    if in_the_way:
        raise ForeignFiles(_message(folder, "ClickNick would take these for ladder", in_the_way))
    taken = [
        folder / name
        for name, data in files.items()
        if _differs(folder / name, data, disk) and not noted.may_be_replaced(name)
    ]
    if taken:
        raise ForeignFiles(_message(folder, "these are not an earlier build's", taken))
    others = (name for name in noted.inside() if name not in files and name not in there and noted.may_go(name))
    return [*leftovers.values(), *(folder / name for name in others)]


def _csv_files(folder: Path) -> list[Path]:
    """Files that Windows takes for CSV, whatever the case of their ending."""
    places = [place for place in (folder, *(folder / name for name in folders())) if place.is_dir()]
    return sorted(path for place in places for path in place.iterdir() if path.suffix.casefold() == ".csv")


def _differs(path: Path, data: bytes, disk: Workspace) -> bool:
    return path.is_file() and disk.read(path) != data


def _message(folder: Path, why: str, paths: list[Path]) -> str:
    names = ", ".join(path.relative_to(folder).as_posix() for path in paths)
    return (
        f"{folder} holds files that clickgen did not make ({why}): {names}; move them, or choose another folder with -o"
    )


class _Noted:
    """What the source map of the last build says about the folder, and which of it is to be believed."""

    def __init__(self, folder: Path, disk: Workspace, files: Iterable[object], digests: Mapping[str, object]) -> None:
        self._folder = folder
        self._disk = disk
        self._digests = digests
        self.files = {name: None for name in files if isinstance(name, str)}

    @classmethod
    def of(cls, folder: Path, disk: Workspace) -> _Noted:
        try:
            noted = json.loads(disk.read(folder / MAP))
        except (OSError, ValueError, RecursionError):
            noted = None
        is_ours = isinstance(noted, dict) and noted.get("generator") == "clickgen"
        files, digests = (noted.get("files"), noted.get("digests")) if is_ours else (None, None)
        known = digests if isinstance(digests, dict) else {}
        return cls(folder, disk, files if isinstance(files, list) else (), known)

    def digest(self, path: str) -> str:
        """The digest of what the build wrote into a file; "" where the map has none."""
        digest = self._digests.get(path)
        return digest if isinstance(digest, str) else ""

    def read(self, path: str) -> bytes:
        """The bytes of a file in the folder; none where there is no such file."""
        try:
            return self._disk.read(self._folder / path)
        except (FileNotFoundError, NotADirectoryError):
            return b""

    def inside(self) -> Iterator[str]:
        """The noted files that lie where writers put theirs."""
        places = {self._folder, *(self._folder / name for name in folders())}
        for name in self.files:
            path = self._folder / name
            # A name such as ../mine.txt, or c:mine.txt on Windows, leads out of the folder.
            if path.parent in places and path.name != ".." and path.relative_to(self._folder).as_posix() == name:
                yield name

    def may_be_replaced(self, name: str) -> bool:
        """True for an output that is noted and recognized; an empty file holds nothing that could be lost."""
        return self._owner(name) is not None

    def may_go(self, name: str) -> bool:
        """True for a leftover that a build made, and that is as the map says."""
        writer = self._owner(name)
        return writer is not None and not writer.on_request and writer.may_go(self, name)

    def _owner(self, name: str) -> Writer | None:
        """The writer that made a file; None where a person may have made it."""
        writer = writer_of(name) if name in self.files else None
        if writer is None:
            return None
        try:
            is_file = stat.S_ISREG((self._folder / name).lstat().st_mode)
            data = self._disk.read(self._folder / name) if is_file else None
        except (OSError, ValueError):  # ValueError: a name that no file can have
            return None
        return writer if data is not None and (not data or writer.is_own(data)) else None
