"""The disk as it is at this very moment: regular files only, and never more of one than is expected."""

from __future__ import annotations

import errno
import os
import stat
from typing import TypeVar

MIB = 2**20
READ_MAX = 64 * MIB
"""Far more than any program, table or report has."""

StrPath = str | os.PathLike[str]
Data = TypeVar("Data", bytes, str)


class CouldNotRun(Exception):
    """There is nothing to judge: a file is missing or unreadable, an output folder unusable. The message says which.

    ``lines`` are the message and what is listed below it.
    """

    def __init__(self, message: str = "", *more: str) -> None:
        super().__init__("\n".join((message, *more)))
        self.lines = (message, *more)


class NoRegularFile(OSError):
    """A pipe or a device is in the place of a file."""


def read_file(path: StrPath, limit: int = READ_MAX) -> bytes:
    """The bytes of a regular file.

    Raises OSError with the path as ``filename``: also for a pipe or a device, and for a file of more than ``limit``
    bytes.
    """
    with open(path, "rb", opener=open_file) as file:
        data = file.read(limit + 1)
    return require_size(data, path, limit)


def read_start(path: StrPath, size: int) -> bytes:
    """The first bytes of a regular file, at most ``size``. Raises OSError as ``read_file`` does."""
    with open(path, "rb", opener=open_file) as file:
        return file.read(size)


def open_file(path: StrPath, flags: int) -> int:
    """An opener for ``open`` that opens regular files alone. Raises OSError."""
    # To open a device can already do something, so the kind is asked for before; and after, for what was swapped.
    _require_file(path, os.stat(path))
    descriptor = os.open(path, flags | getattr(os, "O_NONBLOCK", 0))
    try:
        _require_file(path, os.fstat(descriptor))
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor


def require_size(data: Data, path: StrPath, limit: int = READ_MAX) -> Data:
    """What was read of a file, where that is not more than the limit. Raises OSError."""
    if len(data) > limit:
        raise OSError(errno.EFBIG, f"it has more than {limit // MIB} MB", os.fspath(path))
    return data


def read_if_there(path: StrPath, limit: int = READ_MAX) -> bytes | None:
    """The bytes of a regular file; None where there is none. Raises OSError as ``read_file`` does."""
    try:
        return read_file(path, limit)
    except (FileNotFoundError, NotADirectoryError):
        return None


def leads_elsewhere(path: StrPath) -> bool:
    """True where the last name of a path is a link, or a junction of Windows, to another place.

    The folders above it may be reached by links.
    """
    folder, name = os.path.split(path)
    if name in ("", ".", ".."):
        return False
    straight = os.path.join(os.path.realpath(folder), name)
    return os.path.normcase(os.path.realpath(path)) != os.path.normcase(straight)


def _require_file(path: StrPath, status: os.stat_result) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), os.fspath(path))
    if not stat.S_ISREG(status.st_mode):
        raise NoRegularFile(errno.EINVAL, "it is a pipe or a device, not a file", os.fspath(path))
