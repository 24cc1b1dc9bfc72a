"""From paths to programs: the files to check, and for a file without a main the programs that import it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from fnmatch import fnmatch
from pathlib import Path
from typing import NamedTuple

from clickgen.config import Config
from clickgen.diagnostics import CouldNotRun

_USUAL_EXCLUDES = ("build", "dist", "venv", "node_modules", "__pycache__", "site-packages")
"""Folders that hold no sources; those with a dot in front are left out too."""


class Target(NamedTuple):
    """One program to check. A file without a main that no program imports is judged as a part of one."""

    path: str
    nicknames: str | None = None
    is_part: bool = False


def targets(paths: Sequence[str], config: Config, exclude: Iterable[str] = (), force: bool = False) -> list[Target]:
    """What to check, each program once, in the order of their paths. Raises CouldNotRun.

    Without paths it is the configured programs, and without those the working folder. ``exclude`` and the configured
    patterns hold for what is found in folders; with ``force`` also for files that were named, and those of them that
    are no programs are left alone: pre-commit names every Python file.
    """
    patterns = (*config.check.exclude, *exclude)
    if not paths and config.programs:
        for program in config.programs:
            if not program.path.exists():
                raise CouldNotRun(f"there is no file {program.path}, which {config.file} names as a program")
        found = [_shown(program.path) for program in config.programs]
    else:
        found = list(_files(paths or ["."], config, patterns, force))
    programs: dict[str, Target] = {}
    for path in found:
        for target in _programs_of(path, config):
            programs.setdefault(os.path.realpath(target.path), target)
    return sorted(programs.values(), key=lambda target: target.path)


def _shown(path: Path) -> str:
    """Relative to the working folder where it is below."""
    here = Path.cwd()
    return str(path.relative_to(here)) if path.is_relative_to(here) else str(path)


def _files(paths: Sequence[str], config: Config, patterns: Sequence[str], force: bool) -> Iterator[str]:
    for path in paths:
        if os.path.isdir(path):
            yield from _walk(path, config, patterns)
        elif not os.path.exists(path):
            raise CouldNotRun(f"there is no file or folder {path}")
        elif not (force and (_is_excluded(path, config, patterns) or not is_program(_text(path)))):
            yield path


def _walk(folder: str, config: Config, patterns: Sequence[str]) -> Iterator[str]:
    for root, folders, files in os.walk(folder):
        folders[:] = sorted(
            name
            for name in folders
            if not name.startswith(".")
            and name not in _USUAL_EXCLUDES
            and not _is_excluded(os.path.join(root, name), config, patterns)
        )
        for name in sorted(files):
            path = os.path.normpath(os.path.join(root, name))
            if name.endswith(".py") and not _is_excluded(path, config, patterns) and is_program(_text(path)):
                yield path


def _is_excluded(path: str, config: Config, patterns: Sequence[str]) -> bool:
    """True when a pattern names the path, one of its folders or its name."""
    absolute = Path(os.path.abspath(path))
    root = Path(os.path.abspath(config.root))
    shown = absolute.relative_to(root) if absolute.is_relative_to(root) else absolute
    names = [shown.as_posix(), *(parent.as_posix() for parent in shown.parents), *shown.parts]
    return any(fnmatch(name, pattern.rstrip("/")) for pattern in patterns for name in names)


# -- which files are programs -----------------------------------------------------------------------------------------

_HEAD = re.compile(r"^(def main\(|@sub\b|nickname\()", re.MULTILINE)
_OWN = re.compile(r"^(@sub\s*$|nickname\(|from clickgen\.dsl import )|\b(end|out)\(", re.MULTILINE)
_DOCSTRING = re.compile(r"\A\s*(\"\"\"|\'\'\').*?\1", re.DOTALL)
_FOREIGN = re.compile(r"^(?!def |@sub\b|import |from |nickname\(|[#)\s\"\'\ufeff]|$)", re.MULTILINE)
"""A line at the left edge that no program of clickgen's has."""
_FIRST_INDENT = re.compile(r"^([ \t]+)\S", re.MULTILINE)
_RUNG_WORDS = ("if", "elif", "else", "for", "pass", "#", '"', "'", ")", "]", "}")


def is_program(text: str) -> bool:
    """True for a text that looks like clickgen's: routines of nothing but rungs. Other Python is left alone.

    It goes by the beginnings of lines, so that a program with a syntax error is one too.
    """
    if not (_HEAD.search(text) and _OWN.search(text)):
        return False
    text = _DOCSTRING.sub("", text, count=1)
    if _FOREIGN.search(text):
        return False
    indent = _FIRST_INDENT.search(text)
    if indent is None:
        return True
    inner: list[str] = re.findall(rf"^{indent[1]}(?=\S)(.*)", text, re.MULTILINE)
    rungs = sum(line.startswith(_RUNG_WORDS) for line in inner)
    return len(inner) <= 2 * rungs


def _text(path: str) -> str:
    try:
        with open(path, encoding="utf-8-sig", errors="replace") as file:
            return file.read()
    except OSError:
        return ""


# -- parts of programs ------------------------------------------------------------------------------------------------

_MAIN = re.compile(r"^def main\(", re.MULTILINE)
_IMPORT = re.compile(r"^\s*(?:from\s+\.?(\w+)\s+import\b|import\s+(\w+))", re.MULTILINE)


def _programs_of(path: str, config: Config) -> Iterator[Target]:
    """The program that a file is, or those that import it."""
    settings = config.program(Path(path))
    nicknames = str(settings.nicknames) if settings.nicknames else None
    if _MAIN.search(_text(path)):
        yield Target(path, nicknames)
        return
    found = False
    for program in _neighbours(path, config):
        if os.path.realpath(path) in _imported(program):
            found = True
            own = config.program(Path(program))
            yield Target(program, str(own.nicknames) if own.nicknames else None)
    if not found:
        yield Target(path, nicknames, is_part=True)


def _neighbours(path: str, config: Config) -> list[str]:
    """The programs that could import a file: those configured and those beside it."""
    folder = os.path.dirname(path) or "."
    try:
        names = sorted(name for name in os.listdir(folder) if name.endswith(".py"))
    except OSError:
        names = []
    beside = [os.path.normpath(os.path.join(folder, name)) for name in names]
    configured = [_shown(program.path) for program in config.programs if program.path.exists()]
    programs = {os.path.realpath(program): program for program in (*configured, *beside)}
    return [program for program in programs.values() if _MAIN.search(_text(program))]


def _imported(program: str) -> set[str]:
    """Every file that a program is made of, itself aside, by its real path."""
    seen: set[str] = set()
    waiting = [program]
    while waiting:
        path = waiting.pop()
        for match in _IMPORT.finditer(_text(path)):
            sibling = os.path.join(os.path.dirname(path), f"{match[1] or match[2]}.py")
            key = os.path.realpath(sibling)
            if key not in seen and os.path.isfile(sibling):
                seen.add(key)
                waiting.append(sibling)
    return seen
