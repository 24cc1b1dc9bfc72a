"""The secret of this user on this machine, which identifies a cache as one's own."""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

from clickgen.workspace.disk import StrPath, read_file

_BYTES = 32


def user_secret(root: StrPath) -> bytes | None:
    """Return the secret, made at first use; None if there is no place for it that is private to this user.

    A place below ``root``, the folder that is checked, does not count: whoever made the repository could have put it
    there.
    """
    folder = _folder()
    if folder is None:
        return None
    path = folder / "cache.key"
    if Path(os.path.realpath(path)).is_relative_to(os.path.realpath(root)):
        return None
    try:
        if not path.exists():
            _make(path)
        if not _is_private(path):
            return None
        found = read_file(path, 4 * _BYTES)
    except OSError:
        return None
    return found if len(found) == _BYTES else None


def _folder() -> Path | None:
    """The folder in which this user's programs keep data that can be made again."""
    if sys.platform == "win32":
        place = os.environ.get("LOCALAPPDATA", "")
    else:
        # The XDG Base Directory Specification: a path that is not absolute is to be ignored.
        place = os.environ.get("XDG_CACHE_HOME", "")
        if not os.path.isabs(place):
            home = os.environ.get("HOME", "")
            place = os.path.join(home, ".cache") if os.path.isabs(home) else ""
    return Path(place, "clickgen") if os.path.isabs(place) else None


def _make(path: Path) -> None:
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    # A process that comes between the two calls finds a file that is too short, and does without the cache this once.
    with open(os.open(path, flags, 0o600), "wb") as file:
        file.write(os.urandom(_BYTES))


def _is_private(path: Path) -> bool:
    """True for a file that this user has and nobody else can read. Windows keeps the folder for the user."""
    status = os.stat(path, follow_symlinks=False)
    if not stat.S_ISREG(status.st_mode):
        return False
    return sys.platform == "win32" or (status.st_uid == os.geteuid() and not status.st_mode & 0o077)
