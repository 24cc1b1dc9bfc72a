"""Chooses the programs that a command works on: those that are named, else every configured one."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from clickgen.cli import complain
from clickgen.config import Config, ProgramSettings, Settings, find_config, read_config
from clickgen.workspace import CouldNotRun, Workspace
from clickgen.workspace.memory import Memory


@dataclass(frozen=True)
class Job:
    """One program: its place, its settings, and the folder that it is built into."""

    program: str
    settings: Settings
    folder: Path

    @property
    def folders(self) -> list[Path]:
        """The places where files are written: beside the program and its table, and in the output folder."""
        from clickgen.emit.registry import folders

        table = Path(os.path.realpath(self.settings.table_of(Path(self.program))))
        return [Path(self.program).parent, table.parent, self.folder, *(self.folder / name for name in folders())]


class Run:
    """One run of a command: its files, each read once, and its settings. ``config`` names the file of the settings."""

    def __init__(self, config: str | None) -> None:
        self.config = config
        self.files = Workspace()

    @cached_property
    def settings(self) -> Config:
        """The settings in the named file, else those of the working folder. Raises CouldNotRun."""
        return read_config(Path(self.config), self.files) if self.config else find_config(Path.cwd(), self.files)

    def remember(self) -> None:
        """Keep what is read on disk, beside the settings. Raises CouldNotRun."""
        self.files.memory = Memory(self.settings.root)

    def jobs(self, programs: Sequence[str], nicknames: str | None = None, frozen: bool = False) -> list[Job]:
        """Return the named programs, else all that the settings name. Raises CouldNotRun if there are none."""
        settings = self.settings
        if programs:
            return [_job(program, settings.program(Path(program)), nicknames, frozen, settings) for program in programs]
        if not settings.programs:
            raise CouldNotRun("no program is named: name one, such as prog.py, or name programs in clickgen.toml")
        return [_job(str(near(own.path)), own, nicknames, frozen, settings) for own in settings.programs]

    def settle(self, found: Sequence[Job]) -> None:
        """Put back what a killed command left half written near these and the configured programs.

        Call it before anything but the settings is read. Raises CouldNotRun and OSError.
        """
        programs = [*found, *(self.jobs([]) if self.settings.programs else [])]
        put_back(folder for job in programs for folder in job.folders)


def _job(program: str, own: ProgramSettings, nicknames: str | None, frozen: bool, config: Config) -> Job:
    root = config.root if any(own is configured for configured in config.programs) else Path()
    folder = own.output or root / "build" / Path(program).stem
    table = nicknames if nicknames is not None else own.nicknames and near(own.nicknames)
    return Job(program, Settings(table, nicknames is not None, frozen, config.reserved), near(folder))


def put_back(folders: Iterable[Path]) -> None:
    """Put back what a killed command left half written in these folders. Raises CouldNotRun and OSError."""
    from clickgen.text.journal import recover

    for path in recover(dict.fromkeys(folders)):
        complain(f"{path} is again as it was before a command that was stopped while it wrote")


def near(path: Path) -> Path:
    """A path relative to the working folder, if it is below."""
    absolute, here = path.absolute(), Path.cwd()
    return absolute.relative_to(here) if absolute.is_relative_to(here) else path
