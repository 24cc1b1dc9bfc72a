"""The programs around an address table: those that a command names, and every other one that a change would affect."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple, Protocol

from clickgen.commands.nicknames.uses import FileNames, read_names
from clickgen.config import CheckSettings, Config, Settings
from clickgen.dialects.discover import Target, targets
from clickgen.dialects.registry import dialect_of
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.source import SourceFile
from clickgen.workspace import CouldNotRun, Workspace


class Job(Protocol):
    """A program that a command works on, and its settings for a build."""

    @property
    def program(self) -> str: ...
    @property
    def settings(self) -> Settings: ...


class SourceNames(NamedTuple):
    """A source file of a program, the names in it, and its problems."""

    source: SourceFile
    names: FileNames | None
    """None when the file cannot be read."""
    problems: tuple[Diagnostic, ...]


@dataclass(frozen=True)
class Program:
    """A program, or a part of one that no program imports, with every file in it."""

    path: str
    settings: Settings
    is_job: bool
    is_part: bool
    read: Callable[[], tuple[SourceNames, ...]]

    @cached_property
    def sources(self) -> tuple[SourceNames, ...]:
        """The files that the program is made of, read on demand."""
        return self.read()

    @property
    def names(self) -> list[FileNames]:
        """The names in each of its files that can be read."""
        return [source.names for source in self.sources if source.names is not None]

    @property
    def table(self) -> Path:
        return self.settings.table_of(self.path)

    @property
    def workbook(self) -> Path | None:
        """The list of addresses that the table adds to."""
        return self.settings.workbook

    @property
    def table_key(self) -> str:
        return os.path.realpath(self.table)


def programs_around(
    jobs: Sequence[Job], config: Config, files: Workspace, tables: Iterable[Path] = ()
) -> list[Program]:
    """Return the programs of the jobs, those around them and their tables, and the configured ones; each once.

    ``tables`` are further tables to look around. Raises CouldNotRun if a program cannot be read.
    """
    places = [table.parent for table in tables]
    for job in jobs:
        places += (job.settings.table_of(job.program).parent, Path(job.program).parent)
    folders = {os.path.realpath(folder): str(folder) for folder in places if folder.is_dir()}
    found: dict[str, Program] = {}
    read: dict[str, SourceNames] = {}
    for job in jobs:
        _add(found, read, files, Target(job.program), job.settings._replace(frozen=False), True)
    for target in _around(folders.values(), config, files.apart()):
        _add(found, read, files, target, Settings(target.nicknames, reserved=config.reserved), False)
    return list(found.values())


def _around(folders: Iterable[str], config: Config, files: Workspace) -> Iterator[Target]:
    # A program that is excluded from checks uses the table all the same.
    config = config._replace(check=CheckSettings())
    for program in config.programs:
        if program.path.is_file():
            yield Target(str(program.path), str(program.nicknames) if program.nicknames else None)
    yield from targets([*folders], config, workspace=files) if folders else ()


def _add(
    found: dict[str, Program],
    read: dict[str, SourceNames],
    files: Workspace,
    target: Target,
    settings: Settings,
    is_job: bool,
) -> None:
    real = os.path.realpath(target.path)
    if real in found:
        return
    try:
        data = files.read(target.path)
    except OSError as error:
        fault = "there is no such file" if isinstance(error, FileNotFoundError) else error.strerror or str(error)
        raise CouldNotRun(f"{target.path} cannot be read: {fault}") from None

    def names() -> tuple[SourceNames, ...]:
        dialect = dialect_of(target.path, data)
        source = dialect.decode(target.path, data, Diagnostics())
        sources = dialect.read(source, files, Diagnostics())[1] if source else ()
        for each in sources:
            key = os.path.realpath(each.path)
            if key not in read:
                problems = Diagnostics()
                read[key] = SourceNames(each, read_names(each, problems), problems.in_order())
        return tuple(read[os.path.realpath(each.path)] for each in sources)

    found[real] = Program(target.path, settings, is_job, target.is_part, names)
