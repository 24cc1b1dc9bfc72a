"""The shape of a writer: one output of a program, where it goes, and how an earlier one is recognized.

Each writer is a module of this folder with a ``WRITER``; ``registry.py`` finds them all.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from typing import Protocol

from clickgen.emit.built import BuiltProgram


class EarlierBuild(Protocol):
    """What the source map of an earlier build says about an output folder."""

    @property
    def files(self) -> Collection[str]:
        """The outputs that it names, by their paths inside the folder."""

    def digest(self, path: str) -> str:
        """The digest of what the build wrote into a file; "" where the map has none."""

    def read(self, path: str) -> bytes:
        """The bytes of a file in the folder; none where there is no such file."""


def _always(_: EarlierBuild, __: str) -> bool:
    return True


@dataclass(frozen=True)
class Writer:
    """One kind of output. Paths are inside the output folder, with ``/``.

    ``paths`` names the files that a program gets, and ``write`` makes one of them: the same program gives the same
    text. An output of a build is text; one that is made ``on_request`` may be bytes.

    A build replaces and removes only what an earlier build made: ``owns`` matches the whole of every path that this
    writer can choose, ``is_own`` recognizes the contents, and ``may_go`` adds what else must hold before a file that
    is no longer made is removed. ``folders`` are the subfolders that the writer uses.
    """

    paths: Callable[[BuiltProgram], Iterable[str]]
    write: Callable[[BuiltProgram, str], str | bytes]
    owns: re.Pattern[str]
    is_own: Callable[[bytes], bool]
    may_go: Callable[[EarlierBuild, str], bool] = _always
    folders: tuple[str, ...] = ()
    rank: int = 50
    """The place among the outputs of a build; writers of the same rank follow in the order of their modules."""
    on_request: bool = False
    """True for an output that only its own command makes."""


def one_file(
    path: str,
    write: Callable[[BuiltProgram], str],
    is_own: Callable[[bytes], bool],
    rank: int = 50,
) -> Writer:
    """The writer of an output that every program gets, always under the same name."""
    return Writer(
        paths=lambda _: (path,),
        write=lambda built, _: write(built),
        owns=re.compile(re.escape(path)),
        is_own=is_own,
        rank=rank,
    )


def first_line(data: bytes) -> str:
    """The first line of a file, without its end."""
    return data.split(b"\n", 1)[0].rstrip(b"\r").decode("utf-8", "replace")


def digest_of(data: bytes) -> str:
    """What tells one output from another. Git may have changed the ends of its lines."""
    return hashlib.blake2b(data.replace(b"\r\n", b"\n"), digest_size=16).hexdigest()
