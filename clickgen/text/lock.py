"""One writer at a time: a lock on each folder that a command writes into.

The operating system holds the lock, on a file in the folder, so it ends with its process, however that ends. A disk
without locks is written to without one: what is replaced is compared in any case (see ``write.py``).
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import sys
import threading
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import IO

from clickgen.workspace import CouldNotRun

NAME = ".clickgen-lock"
PATIENCE = 60.0
"""Seconds to wait for another writer; each takes a fraction of one."""
_PAUSE = 0.02
_GRACE = 2.0
_WAITS_TO_OPEN = sys.platform == "win32"
"""Windows refuses to open a file that its owner is just removing: try again for so many seconds."""
_NO_LOCKS = {errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP, errno.EINVAL, errno.EBADF}
"""NFS gives EBADF for a lock file that belongs to somebody else and cannot be written to."""

_threads = threading.RLock()
_held: set[str] = set()
"""The folders that this process has locked, by their real paths."""


class Busy(CouldNotRun):
    """Another process has been writing into a folder for longer than it should."""

    def __init__(self, folder: str) -> None:
        super().__init__(f"another clickgen is writing into {folder} and does not end; nothing was written")


@contextlib.contextmanager
def locked(folders: Iterable[str | os.PathLike[str]]) -> Iterator[frozenset[str]]:
    """Lock folders while the block runs; folders locked already stay locked. Yields their real paths.

    All are taken in one order, so that two processes never wait for each other. Raises Busy, and OSError
    if no file can be made in a folder.
    """
    wanted = {os.path.realpath(folder) for folder in folders}
    with _threads, contextlib.ExitStack() as stack:
        for folder in sorted(wanted - _held):
            stack.enter_context(_locked(folder))
        yield frozenset(wanted & _held)


@contextlib.contextmanager
def _locked(folder: str) -> Iterator[None]:
    path = Path(folder, NAME)
    file = _taken(path)
    if file is None:
        yield
        return
    _held.add(folder)
    try:
        yield
    finally:
        _held.discard(folder)
        _release(path, file)


def _taken(path: Path) -> IO[bytes] | None:
    """The lock file, locked; None if this disk has no locks. Raises Busy and OSError."""
    start = time.monotonic()
    while True:
        try:
            file = _opened(path)
        except PermissionError:
            if not _WAITS_TO_OPEN or time.monotonic() > start + _GRACE:
                raise
            time.sleep(_PAUSE)
            continue
        if file is None:
            return None
        try:
            is_late = time.monotonic() > start + PATIENCE
            if _try_lock(file.fileno()):
                if _is_still_there(path, file):
                    return file
                if is_late:  # A network disk that does not recognize its own file: its locks are worth nothing.
                    file.close()
                    _remove_empty(path)
                    return None
            elif is_late:
                raise Busy(str(path.parent))
        except OSError as error:
            file.close()
            if error.errno in _NO_LOCKS:
                _remove_empty(path)
                return None
            raise
        except BaseException:
            file.close()
            raise
        file.close()
        time.sleep(_PAUSE)


def _opened(path: Path) -> IO[bytes] | None:
    """The lock file; None if something else has its name."""
    with contextlib.suppress(FileNotFoundError):
        if not stat.S_ISREG(os.lstat(path).st_mode):
            return None
    try:
        return open(path, "ab")
    except OSError as error:
        # Someone else's lock file can be locked all the same.
        with contextlib.suppress(OSError):
            return open(path, "rb")
        raise OSError(error.errno, error.strerror or str(error), str(path.parent)) from error


def _is_still_there(path: Path, file: IO[bytes]) -> bool:
    """False if the owner of the lock has removed its file: then the next one is another file."""
    try:
        return os.path.samestat(os.fstat(file.fileno()), os.lstat(path))
    except FileNotFoundError:
        return False


def _release(path: Path, file: IO[bytes]) -> None:
    if sys.platform == "win32":
        # Windows unlocks a closed file, but only in its own time. It keeps a file that is open: whoever waits has
        # it open, and removes it in turn.
        with contextlib.suppress(OSError):
            _unlock(file.fileno())
        file.close()
        _remove_empty(path)
    else:
        _remove_empty(path)
        file.close()


def _remove_empty(path: Path) -> None:
    with contextlib.suppress(OSError):
        if os.lstat(path).st_size == 0:
            os.unlink(path)


if sys.platform == "win32":
    import msvcrt

    def _try_lock(descriptor: int) -> bool:
        """Lock the first byte, which need not exist; the lock begins at the file position."""
        try:
            os.lseek(descriptor, 0, os.SEEK_SET)
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        except PermissionError:
            return False
        return True

    def _unlock(descriptor: int) -> None:
        os.lseek(descriptor, 0, os.SEEK_SET)
        msvcrt.locking(descriptor, msvcrt.LK_UNLCK, 1)

else:
    import fcntl

    def _try_lock(descriptor: int) -> bool:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True
