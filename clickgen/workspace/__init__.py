"""The files of the user: every file that a command reads goes through here.

A repository can hold a link to a device that has no end, or a pipe that nobody writes to. So only regular files are
read, and never more than is expected. A ``Workspace`` is what one command sees of the disk: it reads each file once,
knows the texts that an editor has not saved, and notes what was read. The functions beside it look at the disk as it is
at that very moment: for those who are about to write there.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Mapping

from clickgen.workspace.digest import digest_of
from clickgen.workspace.disk import (
    MIB,
    READ_MAX,
    CouldNotRun,
    NoRegularFile,
    StrPath,
    leads_elsewhere,
    open_file,
    read_file,
    read_if_there,
    read_start,
    require_size,
)
from clickgen.workspace.memory import Memory

__all__ = [
    "MIB",
    "READ_MAX",
    "CouldNotRun",
    "NoRegularFile",
    "StrPath",
    "Workspace",
    "leads_elsewhere",
    "open_file",
    "read_file",
    "read_if_there",
    "read_start",
    "require_size",
]


_DEEP = 100
"""A path through more folders than this is looked up as a whole."""


class Workspace:
    """The files as one command sees them.

    ``overlay`` has contents that count instead of those on disk, by real path: what an editor has not saved, what
    comes from the standard input, a table that the build before this one has extended. ``reads`` has what was read
    through this object, by path as it was asked for; None for a file that is not there. The same bytes give the same
    result. ``memory`` has what was made of texts before.
    """

    def __init__(self, overlay: Mapping[str, bytes] | None = None, memory: Memory | None = None) -> None:
        self.overlay: Mapping[str, bytes] = dict(overlay or {})
        self.memory = memory or Memory()
        self.reads: dict[str, bytes | None] = {}
        self._known: dict[str, bytes | None] = {}
        self._shown: dict[str, str] = {}
        self._reals: dict[str, str] = {}
        self._digests: dict[str, str | None] = {}

    def apart(self, overlay: Mapping[str, bytes] | None = None) -> Workspace:
        """The same files, with a record of its own of what is read. ``overlay`` adds to what counts instead."""
        other = Workspace({**self.overlay, **overlay} if overlay else self.overlay, self.memory)
        other._known, other._reals = self._known, self._reals
        return other

    def real(self, path: StrPath) -> str:
        """The real path of a file, looked up once."""
        asked = os.fspath(path)
        found = self._reals.get(asked)
        if found is None:
            folder, name = os.path.split(asked)
            # Most files are no links, and each folder above them costs a look at the disk: it is looked up once.
            is_deep = asked.count("/") > _DEEP
            if os.name == "nt" or is_deep or name in ("", ".", "..") or os.path.islink(asked):
                found = os.path.realpath(asked)
            else:
                found = os.path.join(self.real(folder or "."), name)
            self._reals[asked] = found
        return found

    @property
    def found(self) -> dict[str, bytes | None]:
        """Every file on disk that was asked for here, by the path of the first time; None where there is none."""
        return {shown: self._known[real] for real, shown in self._shown.items() if real in self._known}

    def shown(self, real: str) -> str:
        """The path by which a file was first asked for, from its real path."""
        return self._shown[real]

    def on_disk(self, real: str) -> bytes | None:
        """What was read of a file on disk, by its real path; None where there was none. Raises KeyError."""
        return self._known[real]

    def has(self, path: StrPath) -> bool:
        """True for a file, a folder or a link that is there, and for a file that only the overlay has."""
        return os.path.lexists(path) or (bool(self.overlay) and self.real(path) in self.overlay)

    def read(self, path: StrPath, limit: int = READ_MAX) -> bytes:
        """The bytes of a regular file. Raises OSError: also for one of more than ``limit`` bytes, and NoRegularFile."""
        return require_size(self.start(path, limit + 1), path, limit)

    def start(self, path: StrPath, size: int) -> bytes:
        """The first bytes of a regular file, at most ``size``. Raises OSError as ``read`` does."""
        asked, real = os.fspath(path), self.real(path)
        self.reads[asked] = None
        data = self.overlay.get(real)
        if data is None:
            data = self._on_disk(asked, real, size)
        if data is None:
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), asked)
        self.reads[asked] = data
        return data[:size]

    def look(self, path: StrPath, limit: int = READ_MAX) -> bytes | None:
        """The bytes of a file; None where nothing is there. Raises OSError as ``read`` does: for a link to nowhere."""
        asked, real = os.fspath(path), self.real(path)
        if real not in self.overlay and self._on_disk(asked, real, limit + 1) is None:
            self.reads[asked] = None
            return None
        return self.read(path, limit)

    def digest(self, path: StrPath) -> str | None:
        """The digest of a file's bytes; None where nothing is there. Raises OSError as ``look`` does."""
        real = self.real(path)
        if real not in self._digests:
            data = self.look(path)
            self._digests[real] = None if data is None else digest_of(data)
        return self._digests[real]

    def _on_disk(self, asked: str, real: str, size: int) -> bytes | None:
        """What was first found on the disk; None where nothing was there. Raises OSError."""
        self._shown.setdefault(real, asked)
        if real in self._known:
            return self._known[real]
        try:
            data = read_start(asked, size)
        except FileNotFoundError:
            if os.path.lexists(asked):
                raise
            self._known[real] = None
            return None
        if len(data) < size:  # Only a whole file is remembered.
            self._known[real] = data
        return data
