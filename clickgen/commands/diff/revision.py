"""A side from git: the files of a revision in a folder of their own; work tree and index are left alone."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from subprocess import TimeoutExpired
from typing import NamedTuple

from clickgen.commands.diff.git import run_git
from clickgen.workspace import MIB, READ_MAX, CouldNotRun

_DRIVE = re.compile(r"[A-Za-z]:([\\/]|$)")
_LFS = b"version https://git-lfs.github.com/spec/"
_NO_FILES = {"120000": "a link", "160000": "a submodule", "unmerged": "not merged"}
"""The modes of entries without content of their own."""


class Named(NamedTuple):
    """``REV:PATH`` as it was typed; without a revision it is the index."""

    revision: str
    path: str

    def __str__(self) -> str:
        return f"{self.revision}:{self.path}"


def named_revision(text: str) -> Named | None:
    """Split ``HEAD~1:prog.py``; return None for a path such as ``C:\\plc\\prog.py``.

    As in git, the first colon outside braces divides: ``main@{10:30}:prog.py``.
    """
    if _DRIVE.match(text):
        return None
    depth = 0
    for index, character in enumerate(text):
        depth += (character == "{") - (character == "}")
        if character == ":" and depth <= 0:
            return Named(text[:index], text[index + 1 :].replace(os.sep, "/"))
    return None


def is_in_revision(text: str) -> bool:
    """True for ``REV:./PATH`` that the revision has."""
    named = named_revision(text)
    return named is not None and _git(named, "rev-parse", "--verify", "--quiet", text, may_fail=True) != b""


def is_revision(text: str) -> bool:
    """True for a revision without a path, such as ``HEAD~1``; a file or folder of that name does not count."""
    if not text or text.startswith("-") or os.path.lexists(text) or named_revision(text) or _DRIVE.match(text):
        return False
    try:
        words = ("rev-parse", "--verify", "--quiet", f"{text}^{{tree}}")
        return _git(Named(text, ""), *words, may_fail=True) != b""
    except CouldNotRun:
        return False


class _Blob(NamedTuple):
    mode: str
    name: str


@dataclass(frozen=True)
class Tree:
    """The files of a revision by their paths in the repository; ``put`` writes some of them below ``folder``.

    ``here`` is the working folder in the repository, ``""`` for its root.
    """

    named: Named
    folder: Path
    here: str
    blobs: dict[str, _Blob]

    @property
    def working_folder(self) -> Path:
        """The folder that represents the working folder."""
        return self.place(self.here)

    def place(self, path: str) -> Path:
        """The place for a file of the revision."""
        return self.folder.joinpath(*path.split("/")) if path else self.folder

    def shown(self, path: str) -> str:
        return f"{self.named.revision}:{path or './'}"

    def reworded(self, text: str) -> str:
        """Return a message that names files of the revision, not the places where they are put."""
        return text.replace(f"{self.folder}{os.sep}", f"{self.named.revision}:").replace(
            str(self.folder), str(self.named)
        )

    def find(self) -> tuple[str, str]:
        """Return the requested path, from the root of the repository, and a note about the choice.

        git's own rule comes first: a path counts from the root, one that begins with ``./`` or ``../`` from the
        working folder. A path that is not there may be in the working folder.
        """
        text = self.named.path
        if not text or text.startswith("/"):
            raise CouldNotRun(
                f"{self.named} names no file or folder of the revision: write {self.named.revision}:prog.py"
            )
        from_here = _normal(posixpath.join(self.here, text))
        from_root = from_here if re.match(r"\.\.?(/|$)", text) else _normal(text)
        both = [path for path in dict.fromkeys((from_root, from_here)) if path is not None and self.has(path)]
        if not both:
            raise CouldNotRun(f"{self.named}: {self._what} has no {text}")
        if len(both) == 1:
            return both[0], ""
        return both[0], (
            f"{self.named} is {both[0]} of the repository's root, as for git; "
            f"the one in the working folder is {self.named.revision}:./{text}"
        )

    def has(self, path: str) -> bool:
        return path in self.blobs or self.is_folder(path)

    def is_folder(self, path: str) -> bool:
        return not path or any(name.startswith(f"{path}/") for name in self.blobs)

    @property
    def _what(self) -> str:
        return f"the revision {self.named.revision}" if self.named.revision else "git's index"

    def path_of(self, place: Path) -> str | None:
        """The path in the repository of a place below the folder; None for one that is elsewhere."""
        absolute = os.path.normpath(place)
        if not Path(absolute).is_relative_to(self.folder):
            return None
        path = Path(absolute).relative_to(self.folder).as_posix()
        return "" if path == "." else path

    def put(self, paths: Iterable[str], must_be_there: bool = False) -> None:
        """Write files of the revision below the folder; those that it does not have are skipped.

        Links, submodules and names that no file can have here count as missing. Raises CouldNotRun for such a file if
        it ``must_be_there``, and for a file of Git LFS that must.
        """
        wanted: list[str] = []
        for path in dict.fromkeys(paths):
            blob = self.blobs.get(path)
            if blob is None or self.place(path).exists():
                continue
            fault = _NO_FILES.get(blob.mode, "" if _is_safe(path) else "no name that a file can have here")
            if not fault:
                wanted.append(path)
            elif must_be_there:
                raise CouldNotRun(f"{self.shown(path)} is {fault}: there is no file to compare")
        contents = _contents([self.blobs[path].name for path in wanted], self.named)
        for path, data in zip(wanted, contents, strict=True):
            if data.startswith(_LFS):
                if must_be_there:
                    raise CouldNotRun(
                        f"{self.shown(path)} is kept in Git LFS, and the revision has only a pointer to it"
                    )
                continue
            place = self.place(path)
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(data)

    def below(self, folder: str, is_wanted: Callable[[str], bool]) -> list[str]:
        """The files in a folder and its subfolders that are wanted by their names."""
        start = f"{folder}/" if folder else ""
        return [path for path in self.blobs if path.startswith(start) and is_wanted(path[len(start) :])]


def open_tree(named: Named, folder: Path) -> Tree:
    """Open the files of a revision; nothing is written yet. Raises CouldNotRun without git, repository or revision."""
    here = _git(named, "rev-parse", "--show-prefix").decode("utf-8", "surrogateescape").rstrip("\n").rstrip("/")
    if named.revision:
        listed = _git(named, "ls-tree", "-r", "-z", "--full-tree", _tree_name(named))
    else:
        listed = _git(named, "ls-files", "--stage", "-z", "--full-name", "--", ":/")
    blobs: dict[str, _Blob] = {}
    for line in listed.decode("utf-8", "surrogateescape").split("\0"):
        facts, _, path = line.partition("\t")
        if path:
            mode, second, third = facts.split()
            if named.revision:
                blobs[path] = _Blob(mode, third)
            else:
                blobs[path] = _Blob(mode if third == "0" else "unmerged", second)
    # The folder may be reached by a link (/tmp on macOS), and messages may name it either way.
    return Tree(named, Path(os.path.realpath(folder)), here, blobs)


def _tree_name(named: Named) -> str:
    if not named.revision.startswith("-"):
        found = _git(named, "rev-parse", "--verify", "--quiet", f"{named.revision}^{{tree}}", may_fail=True)
        if found:
            return found.decode().strip()
    raise CouldNotRun(f"{named}: there is no file or folder of this name, and git knows no revision {named.revision}")


def _normal(path: str) -> str | None:
    """A path without ``.`` and ``..``; None for one that leaves the repository."""
    normal = posixpath.normpath(path)
    return None if normal == ".." or normal.startswith("../") else "" if normal == "." else normal


def _is_safe(path: str) -> bool:
    """False for a name that would be put outside of the folder."""
    parts = path.split("/")
    return not any(part in ("", ".", "..") or os.sep in part or (os.name == "nt" and ":" in part) for part in parts)


def _contents(names: list[str], named: Named) -> list[bytes]:
    """The contents of blobs, in their order."""
    if not names:
        return []
    given = "".join(f"{name}\n" for name in names).encode()
    sizes = [line.split() for line in _git(named, "cat-file", "--batch-check", given=given).splitlines()]
    if any(len(words) == 3 and int(words[2]) > READ_MAX for words in sizes):
        raise CouldNotRun(f"{named}: a file of the revision has more than {READ_MAX // MIB} MB")
    data = _git(named, "cat-file", "--batch", given=given)
    found: list[bytes] = []
    start = 0
    for name in names:
        end = data.find(b"\n", start)
        words = data[start:end].split()
        if len(words) != 3:
            raise CouldNotRun(
                f"{named}: git has no content of {name}; is this a partial clone? clickgen downloads nothing"
            )
        size = int(words[2])
        found.append(data[end + 1 : end + 1 + size])
        start = end + 1 + size + 1
    return found


def _git(named: Named, *words: str, given: bytes | None = None, may_fail: bool = False) -> bytes:
    try:
        done = run_git(*words, given=given)
    except FileNotFoundError:
        raise CouldNotRun(
            f"{named}: there is no such file or folder, and a revision needs git, which is not here"
        ) from None
    except TimeoutExpired:
        raise CouldNotRun(f"{named}: git gave no answer") from None
    if done.returncode == 0 or may_fail:
        return done.stdout if done.returncode == 0 else b""
    said = done.stderr.decode("utf-8", "replace").strip().split("\n")[0].removeprefix("fatal: ")
    if "not a git repository" in said:
        raise CouldNotRun(f"{named}: there is no such file or folder, and the working folder is in no git repository")
    raise CouldNotRun(f"{named}: git says: {said}")
