"""What is compared with what: a revision that is named without a path stands for the programs of the working folder."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from clickgen.commands.diff.revision import is_revision, named_revision
from clickgen.commands.diff.sides import is_program
from clickgen.config import Config
from clickgen.dialects.if_rungs.discover import targets
from clickgen.problems.diagnostics import CouldNotRun


def pairs_of(one: str, other: str, config: Config) -> list[tuple[str, str]]:
    """The sides to compare, pair by pair.

    ``HEAD~1 HEAD`` are every program that the settings name, or the only one of the working folder, in both revisions;
    ``HEAD~1 prog.py`` is that program in both. Raises CouldNotRun where nobody can tell which program is meant.
    """
    first, second = is_revision(one), is_revision(other)
    if not first and not second:
        return [(one, other)]
    if first and second:
        return [(f"{one}:{path}", f"{other}:{path}") for path in _programs(one, config)]
    revision, named = (one, other) if first else (other, one)
    path = _program_of(named)
    if path is None:
        path, *more = _programs(revision, config)
        if more:
            raise CouldNotRun(_which(revision, [path, *more]))
    return [(f"{one}:{path}", other) if first else (one, f"{other}:{path}")]


def _program_of(side: str) -> str | None:
    """The program that a side names, as a revision names it; None for another side."""
    if os.path.lexists(side):
        return _from_here(side) if is_program(side) and not os.path.isdir(side) else None
    named = named_revision(side)
    return named.path if named is not None and is_program(named.path) else None


def _from_here(path: str | Path) -> str:
    """A path on disk as git takes it, from the working folder."""
    return "./" + os.path.relpath(path).replace(os.sep, "/")


def _programs(revision: str, config: Config) -> list[str]:
    """The programs that the settings name, else the only one below the working folder."""
    if config.programs:
        return [_from_here(program.path) for program in config.programs]
    found = [_from_here(target.path) for target in targets(["."], config) if not target.is_part]
    if len(found) == 1:
        return found
    if not found:
        raise CouldNotRun(f"{revision} names no program, and there is none here: write {revision}:prog.py")
    raise CouldNotRun(_which(revision, found))


def _which(revision: str, programs: Iterable[str]) -> str:
    listed = ", ".join(f"{revision}:{path.removeprefix('./')}" for path in programs)
    return f"{revision} does not say which program: write one of {listed}; or name programs in clickgen.toml"
