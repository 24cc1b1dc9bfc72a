"""What clickgen found out in earlier runs, kept in a folder of the repository: JSON, signed by this user.

The folder comes with the repository, so whoever made the repository could have put anything there. Each file is
therefore signed with a secret of this user, together with its name and with everything that its contents depend on. A
file with another signature counts for nothing. The contents are data: nothing in them is ever run. A memory that
cannot be used is no memory: every answer is found anew.
"""

from __future__ import annotations

import contextlib
import json
import os
import sys
from functools import cache, cached_property
from importlib.machinery import PathFinder

from clickgen import __version__
from clickgen.workspace.digest import blake2b
from clickgen.workspace.disk import StrPath, leads_elsewhere, read_file
from clickgen.workspace.secret import user_secret

FOLDER = ".clickgen_cache"
_MARK = 64
"""The signature of a file, in characters; a line break follows."""


class Memory:
    """The folder ``.clickgen_cache`` in ``root``; without a root, what is remembered ends with the process."""

    def __init__(self, root: StrPath | None = None) -> None:
        self.root = None if root is None else os.fspath(root)
        self.texts: dict[str, dict[str, object]] = {}
        """What was made of texts in this process: for each kind, by the text."""
        self._waiting: dict[str, object] = {}

    def __reduce__(self) -> tuple[type[Memory], tuple[str | None]]:
        """Another process knows the folder alone."""
        return Memory, (self.root,)

    def get(self, name: str) -> object:
        """What was put under this name; None where nothing was, or nothing that can be trusted."""
        if name in self._waiting:
            return self._waiting[name]
        if self._secret is None or self._folder is None:
            return None
        try:
            mark, body = read_file(os.path.join(self._folder, name)).split(b"\n", 1)
            if mark.decode() != self._mark(name, body):
                return None
            return json.loads(body)
        except (OSError, ValueError, RecursionError):
            return None

    def put(self, name: str, value: object) -> None:
        """Remember a value, which consists of lists, texts, numbers, truth values and None, until ``save``."""
        self._waiting[name] = value

    def save(self) -> None:
        """Write what is new."""
        waiting, self._waiting = self._waiting, {}
        if not waiting or self._secret is None or self._folder is None:
            return
        with contextlib.suppress(OSError, ValueError):
            os.makedirs(self._folder, exist_ok=True)
            with contextlib.suppress(FileExistsError):
                _write_new(os.path.join(self._folder, ".gitignore"), b"*\n")
            for name, value in waiting.items():
                body = json.dumps(value, separators=(",", ":")).encode()
                path = os.path.join(self._folder, name)
                staged = f"{path}.{os.urandom(8).hex()}"
                _write_new(staged, self._mark(name, body).encode() + b"\n" + body)
                os.replace(staged, path)

    @cached_property
    def _folder(self) -> str | None:
        """The folder; None where it is a link to another place."""
        folder = None if self.root is None else os.path.join(self.root, FOLDER)
        return None if folder is None or leads_elsewhere(folder) else folder

    @cached_property
    def _secret(self) -> bytes | None:
        return None if self._folder is None or self.root is None else user_secret(self.root)

    def _mark(self, name: str, body: bytes) -> str:
        """What only this user could have written above these contents, and only this version of clickgen."""
        assert self._secret is not None
        rests_on = json.dumps([name, own_state()]).encode() + b"\n"
        signed = blake2b(rests_on, key=self._secret, digest_size=_MARK // 2)
        signed.update(body)
        return signed.hexdigest()


def _write_new(path: str, data: bytes) -> None:
    """Write a file that is not there yet, not even as a link. Raises OSError."""
    with open(path, "xb") as file:
        file.write(data)


@cache
def own_state() -> str:
    """What every result depends on beside the files of the user: clickgen, Python, and the parsers that read for it.

    A checkout that is worked on has no version of its own, so the youngest of clickgen's files counts.
    """
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    beside = os.path.join(os.path.dirname(package), "grammar")
    youngest = max(_youngest(package), _youngest(beside))
    return json.dumps([__version__, youngest, sys.hexversion, *map(_library, ("libcst", "lark"))])


def _youngest(folder: str) -> int:
    """When the youngest file in a folder and below it was changed."""
    found = 0
    waiting = [folder]
    while waiting:
        with contextlib.suppress(OSError), os.scandir(waiting.pop()) as entries:
            for entry in entries:
                if entry.name.endswith((".py", ".lark", ".csv")):
                    found = max(found, entry.stat().st_mtime_ns)
                elif "." not in entry.name and entry.name != "__pycache__" and entry.is_dir():
                    waiting.append(entry.path)
    return found


def _library(name: str) -> int:
    """What tells one installed version of a library from another, without loading it."""
    spec = PathFinder.find_spec(name)
    if spec is None or spec.origin is None:
        return 0
    return os.stat(spec.origin).st_mtime_ns
