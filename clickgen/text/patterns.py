"""Patterns for paths, as in ``.gitignore``."""

from __future__ import annotations

import os
from collections.abc import Iterator
from fnmatch import fnmatch
from functools import cache
from pathlib import Path


def matches(pattern: str, path: str | os.PathLike[str], root: str | os.PathLike[str]) -> bool:
    """True when a pattern of the settings in ``root`` names the path or a folder above it, as in ``.gitignore``.

    ``*`` stays in one name and ``**`` is any number of folders. A pattern without a slash meets a name anywhere; one
    with a slash, also in front, begins at ``root``.
    """
    return meets(names_below(path, root), steps_of(pattern, os.fspath(root)))


def names_below(path: str | os.PathLike[str], root: str | os.PathLike[str]) -> tuple[str, ...]:
    """The names that lead from ``root`` to the path; all of its names when it is elsewhere."""
    absolute, above = Path(os.path.abspath(path)), Path(os.path.abspath(root))
    return absolute.relative_to(above).parts if absolute.is_relative_to(above) else absolute.parts[1:]


@cache
def steps_of(pattern: str, root: str) -> tuple[str, ...]:
    """A pattern as the names that follow each other; ``**`` for any number of them."""
    below = pattern.removeprefix(f"{Path(os.path.abspath(root)).as_posix()}/")
    is_anchored = below != pattern or "/" in pattern.rstrip("/")
    names = tuple(name for name in below.split("/") if name not in ("", "."))
    return names if is_anchored or not names else ("**", *names)


def meets(names: tuple[str, ...], steps: tuple[str, ...]) -> bool:
    """True when the steps lead to the path or to a folder above it. A pattern without a name leads nowhere.

    Each name is compared with the steps that can be reached there, each once: no pattern makes it try more.
    """
    while len(steps) > 1 and steps[-1] == "**":
        steps = steps[:-1]
    reached = {0} if steps else set()
    for name in names:
        reached = {beyond for step in reached for beyond in _beyond(steps, step, name)}
        if len(steps) in reached:
            return True
    return False


def _beyond(steps: tuple[str, ...], step: int, name: str) -> Iterator[int]:
    """The steps that can follow when a name has come to ``step``; ``**`` takes any number of names."""
    while steps[step] == "**":
        yield step
        step += 1
        if step == len(steps):
            yield step
            return
    if fnmatch(name, steps[step]):
        yield step + 1
