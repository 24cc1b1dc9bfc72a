"""Chooses the sides to compare: a revision named without a path means the programs of the working folder."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

from clickgen.commands.diff.revision import is_in_revision, is_revision, named_revision
from clickgen.commands.diff.sides import is_program
from clickgen.config import Config
from clickgen.dialects.discover import targets
from clickgen.workspace import CouldNotRun, Workspace


class Pair(NamedTuple):
    """Two sides. If one of two revisions does not have the program, that side is absent."""

    one: str
    other: str
    is_new: bool = False
    is_gone: bool = False


def pairs_of(
    one: str, other: str, config: Config, configured_in: Callable[[str], list[str]], files: Workspace
) -> list[Pair]:
    """Return the sides to compare, pair by pair.

    ``HEAD~1 HEAD`` means every program that the settings name, or the only one of the working folder, in both
    revisions; ``HEAD~1 prog.py`` is that program in both. ``configured_in`` returns what the settings of a revision
    name: a program may have come or gone with them. Raises CouldNotRun if nobody can tell which program is meant.
    """
    first, second = is_revision(one), is_revision(other)
    if not first and not second:
        return [Pair(one, other)]
    if first and second:
        return _in_both(one, other, config, configured_in, files)
    revision, named = (one, other) if first else (other, one)
    if not os.path.lexists(named) and named_revision(named) is None:
        raise CouldNotRun(f"there is no file, folder or revision {named!r}")
    path = _program_of(named)
    if path is None:
        path, *more = _programs(revision, config, files)
        if more:
            raise CouldNotRun(_which(revision, [path, *more]))
    return [Pair(f"{one}:{path}", other) if first else Pair(one, f"{other}:{path}")]


def _in_both(
    one: str, other: str, config: Config, configured_in: Callable[[str], list[str]], files: Workspace
) -> list[Pair]:
    """The programs in both revisions, and those that only one of them has."""
    paths = dict.fromkeys([*configured_in(one), *configured_in(other)])
    paths = dict.fromkeys([*(_programs(one, config, files) if config.programs or not paths else ()), *paths])
    pairs: list[Pair] = []
    for path in paths:
        older, newer = f"{one}:{path}", f"{other}:{path}"
        was, is_there = is_in_revision(older), is_in_revision(newer)
        if was or is_there or len(paths) == 1:
            pairs.append(Pair(older, newer, is_there and not was, was and not is_there))
    if not pairs:
        raise CouldNotRun(f"neither {one} nor {other} has one of the programs that the settings name")
    return pairs


def _program_of(side: str) -> str | None:
    """The program that a side names, in a revision's form; None for another side."""
    if os.path.lexists(side):
        return _from_here(side) if is_program(side) and not os.path.isdir(side) else None
    named = named_revision(side)
    return named.path if named is not None and is_program(named.path) else None


def _from_here(path: str | Path) -> str:
    """A path on disk in git's form, from the working folder."""
    return "./" + os.path.relpath(path).replace(os.sep, "/")


def _programs(revision: str, config: Config, files: Workspace) -> list[str]:
    """The programs that the settings name, else the only one below the working folder."""
    if config.programs:
        return [_from_here(program.path) for program in config.programs]
    found = [_from_here(target.path) for target in targets(["."], config, workspace=files) if not target.is_part]
    if len(found) == 1:
        return found
    if not found:
        raise CouldNotRun(f"{revision} names no program, and there is none here: write {revision}:prog.py")
    raise CouldNotRun(_which(revision, found))


def _which(revision: str, programs: Iterable[str]) -> str:
    listed = ", ".join(f"{revision}:{path.removeprefix('./')}" for path in programs)
    return f"{revision} does not say which program: write one of {listed}; or name programs in clickgen.toml"
