"""From paths to programs: the files to check, and for a file without a main the programs that import it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from typing import NamedTuple, NoReturn

from clickgen.config import Config
from clickgen.dialects.registry import dialect_of, suffixes
from clickgen.text.patterns import meets, names_below, steps_of
from clickgen.workspace import CouldNotRun, Workspace
from clickgen.workspace.memory import Memory

_USUAL_EXCLUDES = ("build", "dist", "venv", "node_modules", "__pycache__", "site-packages")
"""Folders that hold no sources; those with a dot in front are left out too."""


class Target(NamedTuple):
    """One program to check. A file without a main that no program imports is judged as a part of one."""

    path: str
    nicknames: str | None = None
    is_part: bool = False


class Found(NamedTuple):
    """What to check, each program once, in the order of their paths; and the folders that have no program."""

    targets: list[Target]
    empty: tuple[str, ...] = ()


def discover(
    paths: Sequence[str],
    config: Config,
    exclude: Iterable[str] = (),
    force: bool = False,
    workspace: Workspace | None = None,
) -> Found:
    """The programs that these paths name. Raises CouldNotRun for what is not there or cannot be read.

    Without paths it is the configured programs, and without those the working folder. ``exclude`` and the configured
    patterns hold for what is found in folders; with ``force`` also for files that were named, and those of them that
    have nothing to do with a program are left alone: pre-commit names every Python file.
    """
    repository = _Repository(config, (*config.check.exclude, *exclude), workspace or Workspace())
    if not paths and config.programs:
        return Found(_each_once(repository.configured_targets(), repository.real))
    found: list[Target] = []
    empty: list[str] = []
    for path in paths or ["."]:
        targets = list(repository.targets(path, force))
        found += targets
        if not targets and os.path.isdir(path):
            empty.append(path)
    return Found(_each_once(found, repository.real), tuple(empty))


def targets(
    paths: Sequence[str],
    config: Config,
    exclude: Iterable[str] = (),
    force: bool = False,
    workspace: Workspace | None = None,
) -> list[Target]:
    """The programs that ``discover`` finds."""
    return discover(paths, config, exclude, force, workspace).targets


def wholly_judged(
    paths: Iterable[str], judged: Iterable[Target], config: Config, workspace: Workspace | None = None
) -> set[str]:
    """Those of these files of which every program was judged: nothing more can be found in them.

    A part that no program imports is never among them: some other file will bring what it lacks.
    """
    done, programs = _programs_of(paths, judged, config, workspace)
    return {path for path, needed in programs.items() if needed and needed <= done}


def partly_judged(
    paths: Iterable[str], judged: Iterable[Target], config: Config, workspace: Workspace | None = None
) -> set[str]:
    """Those of these files that belong to a program which was not judged."""
    done, programs = _programs_of(paths, judged, config, workspace)
    return {path for path, needed in programs.items() if not needed <= done}


def _programs_of(
    paths: Iterable[str], judged: Iterable[Target], config: Config, workspace: Workspace | None
) -> tuple[set[str], dict[str, set[str]]]:
    """The programs that were judged, and those that each of these files belongs to, by their real paths."""
    repository = _Repository(config, (), workspace or Workspace())
    done = {os.path.realpath(target.path) for target in judged if not target.is_part}
    return done, {path: {os.path.realpath(program) for program in repository.programs_with(path)} for path in paths}


def _each_once(targets: Iterable[Target], real: Callable[[str], str]) -> list[Target]:
    programs: dict[str, Target] = {}
    for target in targets:
        programs.setdefault(real(target.path), target)
    return sorted(programs.values(), key=lambda target: target.path)


def _shown(path: Path) -> str:
    """Relative to the working folder where it is below."""
    here = Path.cwd()
    return str(path.relative_to(here)) if path.is_relative_to(here) else str(path)


# -- the files --------------------------------------------------------------------------------------------------------


class _File(NamedTuple):
    """What a look at a file tells: see ``Look``."""

    is_program: bool
    has_main: bool
    imports: Sequence[str]


def _look_at(path: str, text: str) -> _File:
    look = dialect_of(path, text).look(path, text)
    return _File(look.is_program, look.has_main, look.imports)


_NAME_IN_MEMORY = "discovered.json"
_REMEMBERED_MAX = 20_000
"""So many files are remembered: the last that were new."""


class _Seen:
    """What looks at files told, by their contents and suffixes: an unchanged file is not looked through again."""

    def __init__(self, memory: Memory) -> None:
        found = memory.get(_NAME_IN_MEMORY)
        self._memory = memory
        self._known: dict[str, list[object]] = found if isinstance(found, dict) else {}

    def get(self, key: str) -> _File | None:
        match self._known.get(key):
            case [bool() as is_program, bool() as has_main, list() as imports]:
                return _File(is_program, has_main, imports)
        return None

    def put(self, key: str, file: _File) -> None:
        self._known[key] = [file.is_program, file.has_main, [*file.imports]]
        while len(self._known) > _REMEMBERED_MAX:
            del self._known[next(iter(self._known))]
        self._memory.put(_NAME_IN_MEMORY, self._known)


class _Repository:
    """The files around the programs, each read once."""

    def __init__(self, config: Config, patterns: Sequence[str], files: Workspace) -> None:
        self._config = config
        self._patterns = patterns
        self._workspace = files
        self._seen = _Seen(files.memory)
        self._files: dict[str, _File] = {}
        self._programs: dict[str, list[str]] = {}
        self._parts: dict[str, set[str]] = {}

    # -- targets ------------------------------------------------------------------------------------------------------

    def configured_targets(self) -> Iterator[Target]:
        for program in self._config.programs:
            if not program.path.exists():
                raise CouldNotRun(f"there is no file {program.path}, which {self._config.file} names as a program")
            yield self._target(_shown(program.path))

    def targets(self, path: str, force: bool) -> Iterator[Target]:
        """The programs in a folder, or those that a file belongs to."""
        if os.path.isdir(path):
            for file in self._walk(path):
                yield from self._targets_of(file)
        elif not os.path.exists(path) and self.real(path) not in self._workspace.overlay:
            raise CouldNotRun(f"there is no file or folder {path}")
        elif not force or (not self._is_excluded(path) and (self._is_ours(path) or self._importers(path))):
            yield from self._targets_of(path)

    def _targets_of(self, path: str) -> Iterator[Target]:
        """The program that a file is, else those that import it, else the file as a part of one."""
        if self._is_whole(path):
            yield self._target(path)
            return
        programs = self._importers(path)
        yield from map(self._target, programs)
        if not programs:
            yield self._target(path)._replace(is_part=True)

    def _target(self, path: str) -> Target:
        nicknames = self._config.program(Path(path)).nicknames
        return Target(path, _shown(nicknames.absolute()) if nicknames else None)

    # -- finding ------------------------------------------------------------------------------------------------------

    def _walk(self, folder: str) -> Iterator[str]:
        """The files in a folder that are programs or parts of them."""
        for root, folders, files in os.walk(folder, onerror=_give_up):
            folders[:] = sorted(
                name
                for name in folders
                if not name.startswith(".")
                and name not in _USUAL_EXCLUDES
                and not self._is_excluded(os.path.join(root, name))
            )
            for name in sorted(files):
                path = os.path.normpath(os.path.join(root, name))
                if name.endswith(suffixes()) and self._is_wanted(path):
                    yield path

    def _is_wanted(self, path: str) -> bool:
        """True for a program or a part that is not excluded. A link to nowhere and a pipe are neither."""
        return not self._is_excluded(path) and os.path.isfile(path) and self._is_ours(path)

    def _is_excluded(self, path: str) -> bool:
        if not self._patterns:
            return False
        root = str(self._config.root)
        names = names_below(path, root)
        return any(meets(names, steps_of(pattern, root)) for pattern in self._patterns)

    def _is_ours(self, path: str) -> bool:
        return self._look(path).is_program or self.real(path) in self._named

    def _is_whole(self, path: str) -> bool:
        """True for a program, however broken; not for a part of one."""
        return self._look(path).has_main or self.real(path) in self._configured

    @cached_property
    def _configured(self) -> dict[str, str]:
        """The configured programs that are there, by their real paths."""
        programs = [_shown(program.path) for program in self._config.programs if program.path.is_file()]
        return {self.real(program): program for program in programs}

    @cached_property
    def _named(self) -> set[str]:
        """The configured programs and all that they import: these are never left alone."""
        return {*self._configured}.union(*map(self._imported, self._configured))

    # -- parts of programs --------------------------------------------------------------------------------------------

    def programs_with(self, path: str) -> list[str]:
        """The programs that a file belongs to: itself, if it is one, and those that import it."""
        return [*([path] if self._is_whole(path) else []), *self._importers(path)]

    def _importers(self, path: str) -> list[str]:
        real = self.real(path)
        return [program for program in self._programs_around(path) if real in self._imported(program)]

    def _programs_around(self, path: str) -> list[str]:
        """The programs that could import a file: those configured and those beside it."""
        folder = os.path.dirname(path)
        if folder not in self._programs:
            beside = (
                os.path.normpath(os.path.join(folder, name)) for name in _names(folder) if name.endswith(suffixes())
            )
            programs = {self.real(file): file for file in beside if self._is_program_with_main(file)}
            self._programs[folder] = [*({**programs, **self._configured}).values()]
        return self._programs[folder]

    def _is_program_with_main(self, path: str) -> bool:
        if not os.path.isfile(path):
            return False
        try:
            file = self._look(path)
        except CouldNotRun:
            return False
        return file.is_program and file.has_main

    def _imported(self, program: str) -> set[str]:
        """Every file that a program is made of, itself aside, by its real path."""
        if program not in self._parts:
            self._parts[program] = self._reached(program)
        return self._parts[program]

    def _reached(self, program: str) -> set[str]:
        seen: set[str] = set()
        waiting = [program]
        while waiting:
            path = waiting.pop()
            folder = os.path.dirname(path)
            imported = [os.path.realpath(os.path.join(folder, name)) for name in self._look(path).imports]
            new = [file for file in imported if file not in seen and os.path.isfile(file)]
            seen.update(new)
            waiting += new
        return seen

    # -- reading ------------------------------------------------------------------------------------------------------

    def _look(self, path: str) -> _File:
        """What a file is. Raises CouldNotRun when it cannot be read: it could be a program."""
        real = self.real(path)
        if real not in self._files:
            self._files[real] = self._seen_or_known(path)
        return self._files[real]

    def _seen_or_known(self, path: str) -> _File:
        data = self._bytes(path)
        key = f"{self._workspace.digest(path)}{os.path.splitext(path)[1]}"
        file = self._seen.get(key)
        if file is None:
            text = data.decode("utf-8-sig", "replace")
            file = _look_at(path, text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text)
            self._seen.put(key, file)
        return file

    def real(self, path: str) -> str:
        return self._workspace.real(path)

    def _bytes(self, path: str) -> bytes:
        try:
            return self._workspace.read(path)
        except OSError as error:
            error.filename = path
            _give_up(error)


def _give_up(error: OSError) -> NoReturn:
    raise CouldNotRun(f"{error.filename} cannot be read: {error.strerror or error}")


def _names(folder: str) -> list[str]:
    try:
        return sorted(os.listdir(folder or "."))
    except OSError:
        return []


# -- the programs of a file that has no main --------------------------------------------------------------------------

ReadBytes = Callable[[str], bytes]
"""The bytes of a file by its path as shown; raises OSError."""

_SIBLINGS_MAX = 200
"""So many files of a folder are looked through for a message."""


def importers(path: str, read_bytes: ReadBytes) -> list[str]:
    """The programs beside a file that it is a part of: they have a main, and import it, or import what does."""
    folder, own = os.path.split(path)
    looks: dict[str, _File] = {}
    for name in [name for name in _names(folder) if name.endswith(suffixes())][:_SIBLINGS_MAX]:
        other = os.path.join(folder, name)
        with suppress(OSError):
            if name != own and os.path.isfile(other):
                looks[name] = _look_at(other, read_bytes(other).decode("utf-8-sig", "replace").replace("\r\n", "\n"))
    known = waiting = {own}
    while waiting:
        waiting = {name for name, look in looks.items() if not waiting.isdisjoint(look.imports)} - known
        known = known | waiting
    return [os.path.join(folder, name) for name in sorted(known - {own}) if looks[name].has_main]
