"""The programs around an address table: those that a command names, and every other one that would feel a change."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple, Protocol

from clickgen.commands.nicknames.uses import FileNames, read_names
from clickgen.config import CheckSettings, Config
from clickgen.dialects.if_rungs.discover import Target, targets
from clickgen.dialects.if_rungs.read.imports import read_program
from clickgen.dialects.if_rungs.read.parse import decode
from clickgen.problems.diagnostics import CouldNotRun, Diagnostic, Diagnostics
from clickgen.settings import TABLE_NAME, Settings
from clickgen.table.layers import is_workbook
from clickgen.text.source import SourceFile
from clickgen.workspace import read_file


class Job(Protocol):
    """A program that a command works on, and what it is built with."""

    @property
    def program(self) -> str: ...
    @property
    def settings(self) -> Settings: ...


@dataclass
class Files:
    """Every file as it was when it was first read, by its real path; None for one that is not there."""

    contents: dict[str, bytes | None] = field(default_factory=dict)
    shown: dict[str, str] = field(default_factory=dict)

    def read(self, path: str) -> bytes:
        """Raises OSError."""
        data = self.look(path)
        if data is None:
            raise FileNotFoundError(2, "there is no such file", path)
        return data

    def look(self, path: str) -> bytes | None:
        """The bytes of a file, None where there is none. Raises OSError."""
        real = os.path.realpath(path)
        if real not in self.contents:
            self.contents[real] = read_file(path) if os.path.lexists(path) else None
            self.shown[real] = path
        return self.contents[real]

    @property
    def overlay(self) -> dict[str, bytes]:
        return {real: data for real, data in self.contents.items() if data is not None}


class SourceNames(NamedTuple):
    """A source file of a program, the names in it, and what is wrong with it."""

    source: SourceFile
    names: FileNames | None
    """None when the file is not Python."""
    problems: tuple[Diagnostic, ...]


@dataclass(frozen=True)
class Program:
    """A program, or a part of one that no program imports, with every file that it is made of."""

    path: str
    settings: Settings
    is_job: bool
    is_part: bool
    sources: tuple[SourceNames, ...]

    @property
    def names(self) -> list[FileNames]:
        """The names in each of its files that is Python."""
        return [source.names for source in self.sources if source.names is not None]

    @property
    def table(self) -> Path:
        return table_of(self.path, self.settings)

    @property
    def workbook(self) -> Path | None:
        """The list of addresses that the table adds to."""
        named = None if self.settings.nicknames is None else Path(self.settings.nicknames)
        return named if named is not None and is_workbook(named) else None

    @property
    def table_key(self) -> str:
        return os.path.realpath(self.table)


def programs_around(jobs: Sequence[Job], config: Config, files: Files, tables: Iterable[Path] = ()) -> list[Program]:
    """The programs of the jobs, those around them and their tables, and the configured ones; each once.

    ``tables`` are further tables to look around. Raises CouldNotRun when a program cannot be read.
    """
    places = [table.parent for table in tables]
    for job in jobs:
        places += (table_of(job.program, job.settings).parent, Path(job.program).parent)
    folders = {os.path.realpath(folder): str(folder) for folder in places if folder.is_dir()}
    found: dict[str, Program] = {}
    read: dict[str, SourceNames] = {}
    for job in jobs:
        _add(found, read, files, Target(job.program), replace(job.settings, frozen=False), True)
    for target in _around(folders.values(), config):
        _add(found, read, files, target, Settings(target.nicknames, reserved=config.reserved), False)
    return list(found.values())


def _around(folders: Iterable[str], config: Config) -> Iterator[Target]:
    # What nobody wants to have checked uses the table all the same.
    config = config._replace(check=CheckSettings())
    for program in config.programs:
        if program.path.is_file():
            yield Target(str(program.path), str(program.nicknames) if program.nicknames else None)
    yield from targets([*folders], config) if folders else ()


def table_of(program: str, settings: Settings) -> Path:
    """The table that clickgen writes: beside a workbook it is the program's own."""
    named = None if settings.nicknames is None else Path(settings.nicknames)
    return Path(program).parent / TABLE_NAME if named is None or is_workbook(named) else named


def _add(
    found: dict[str, Program],
    read: dict[str, SourceNames],
    files: Files,
    target: Target,
    settings: Settings,
    is_job: bool,
) -> None:
    real = os.path.realpath(target.path)
    if real in found:
        return
    try:
        source = decode(target.path, files.read(target.path), Diagnostics())
    except OSError as error:
        fault = "there is no such file" if isinstance(error, FileNotFoundError) else error.strerror or str(error)
        raise CouldNotRun(f"{target.path} cannot be read: {fault}") from None
    sources = read_program(source, files.read, Diagnostics())[1] if source else ()
    names: list[SourceNames] = []
    for each in sources:
        key = os.path.realpath(each.path)
        if key not in read:
            problems = Diagnostics()
            read[key] = SourceNames(each, read_names(each, problems), problems.in_order())
        names.append(read[key])
    found[real] = Program(target.path, replace(settings, overlay={}), is_job, target.is_part, tuple(names))
