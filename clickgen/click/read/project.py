"""The SOURCE of an import as drawn rungs: a bundle, a ladder file, a capture, or CLICK's program files."""

from __future__ import annotations

import json
import re
import stat
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path

from clickgen.click.read.binary import ProgramHeader, program_header, read_clipboard, read_program
from clickgen.click.read.calls import call_of
from clickgen.click.read.grid import DrawnRung, Ladder, decode_ladder, read_ladder
from clickgen.click.read.kinds import HEAD_BYTES, Kind, kind_of, other_kind
from clickgen.click.read.problem import LadderProblem
from clickgen.device.limits import SUBROUTINE_NAME_MAX
from clickgen.device.project_file import PROGRAM_MAGIC, is_click_project
from clickgen.workspace import CouldNotRun, Workspace

MAIN = "main"
_PART = re.compile(r"main_0*([2-9]|[1-9][0-9]+)")
_MAIN_FILE = re.compile(r"main(_[0-9]+)?")
_PROGRAM_FILE = re.compile(r"scr[0-9]+\.tmp")
_PROGRAM_ENDINGS = (".tmp", ".scr")
_CAPTURE = ".clipboard"
"""The ending of a copy that laddercodec's tools make of a routine: ``Heat.clipboard.csv``, ``Heat.clipboard.bin``."""
_MAIN_INDEX = 1
"""The highest prog_idx of main: 1 in every native program file (click-facts [click-file.program]), but 0 in
laddercodec's manual."""
_BYTES_MAX = 1 << 27
"""128 MiB: far more than the ladder of any project, and little enough to read at once."""
_READS = "a folder with main.csv, or with the Scr*.tmp files of a project"


@dataclass(frozen=True)
class DrawnRoutine:
    """One routine. ``name`` is ``main`` or the exact name of the subroutine in CLICK, ``file`` its first file."""

    name: str
    is_main: bool
    rungs: tuple[DrawnRung, ...]
    file: str


@dataclass(frozen=True)
class Project:
    """Main first, then the subroutines in CLICK's order.

    ``problems`` has those of files that belong to no rung; a rung has its own. ``nicknames`` is the nickname table of
    a folder. ``texts`` has every ladder file that is text, by its shown name.
    """

    source: Path
    routines: tuple[DrawnRoutine, ...]
    problems: tuple[LadderProblem, ...]
    nicknames: Path | None
    texts: Mapping[str, str]


def read_project(path: Path, files: Workspace | None = None) -> Project:
    """Return the contents of a file or folder. Raises CouldNotRun if there is nothing to read; damage becomes problems.

    A folder with main.csv is a bundle: main_2.csv, main_3.csv, … continue main, each file in subroutines/ is a
    routine. Such a folder has no order of its own. It takes that of the build that made it, if its source map has
    exactly these routines; else the order in which main calls them, with those that it does not call by name last.
    Without main.csv the folder's program files of CLICK are read, which know their order.

    A single file is main, or a subroutine if it says so, is in subroutines/, or returns and does not end.
    """
    try:
        reading = _Reading(files or Workspace())
        return _folder(path, reading) if path.is_dir() else _single(path, reading)
    except OSError as error:
        raise CouldNotRun(f"{error.filename or path} cannot be read: {error.strerror or error}") from None


@dataclass
class _Reading:
    """The files so far."""

    files: Workspace
    problems: list[LadderProblem] = field(default_factory=list)
    texts: dict[str, str] = field(default_factory=dict)

    def routine(self, name: str, paths: Sequence[Path], is_main: bool = False) -> DrawnRoutine:
        """Read a routine of one file or several, with its rungs numbered consecutively."""
        rungs: list[DrawnRung] = []
        for path in paths:
            ladder = self.ladder(self.whole(path), _shown(path))
            before = len(rungs)
            rungs += (rung.numbered(before + rung.number) for rung in ladder.rungs)
        return DrawnRoutine(name, is_main, tuple(rungs), _shown(paths[0]))

    def ladder(self, data: bytes, file: str) -> Ladder:
        """Read the rungs of a file; problems that belong to none are noted."""
        ladder = self._ladder(data, file)
        self.problems += ladder.problems
        return ladder

    def _ladder(self, data: bytes, file: str) -> Ladder:
        kind = kind_of(data)
        if kind is Kind.PROGRAM:
            return read_program(data, file)
        if kind is Kind.CLIPBOARD:
            return read_clipboard(data, file)
        self.texts[file] = data.decode("utf-8-sig", "replace")
        if kind is Kind.OTHER:
            return Ladder((), (LadderProblem(f"the file is {other_kind(data, file)}", file, 1),))
        try:
            return read_ladder(decode_ladder(data, file), file)
        except LadderProblem as problem:
            return Ladder((), (problem,))

    def whole(self, path: Path) -> bytes:
        """Read all of a file. Raises CouldNotRun if it is not a file, or far too large for ladder."""
        if not path.exists():
            raise CouldNotRun(f"there is no file or folder {_shown(path)}")
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise CouldNotRun(f"{_shown(path)} is no file")
        if status.st_size > _BYTES_MAX:
            raise CouldNotRun(f"{_shown(path)} is too large for ladder ({status.st_size} bytes)")
        return self.files.read(path, _BYTES_MAX)

    def head(self, path: Path) -> bytes:
        """Return as much of a file as shows its kind. This reads all of it, since most such files are read later."""
        return self.files.start(path, _BYTES_MAX + 1)[:HEAD_BYTES]

    def project(self, source: Path, routines: Iterable[DrawnRoutine], nicknames: Path | None = None) -> Project:
        return Project(source, tuple(routines), tuple(self.problems), nicknames, self.texts)


# -- one file ---------------------------------------------------------------------------------------------------------


def _single(path: Path, reading: _Reading) -> Project:
    data, file = reading.whole(path), _shown(path)
    if kind_of(data) is Kind.OTHER:
        raise CouldNotRun(f"{file} is {other_kind(data, file)}; import reads a ladder file, or {_READS}")
    ladder = reading.ladder(data, file)
    header = program_header(data)
    if header:
        return reading.project(path, [_program(header, path, ladder)])
    stem = _stem(path)
    if path.absolute().parent.name.casefold() == "subroutines":
        return reading.project(path, [DrawnRoutine(stem, False, ladder.rungs, file)])
    tokens = {box.token for rung in ladder.rungs for box in rung.boxes}
    is_main = "return()" not in tokens or "end()" in tokens or bool(_MAIN_FILE.fullmatch(stem.casefold()))
    return reading.project(path, [DrawnRoutine(MAIN if is_main else _usable(stem), is_main, ladder.rungs, file)])


def _program(header: ProgramHeader, path: Path, ladder: Ladder) -> DrawnRoutine:
    is_main = header.index <= _MAIN_INDEX
    name = MAIN if is_main else header.name or _usable(path.stem)
    return DrawnRoutine(name, is_main, ladder.rungs, _shown(path))


def _usable(stem: str) -> str:
    """A name that CLICK takes for a subroutine (click-facts [limit.subroutine-names])."""
    return re.sub(r"[^A-Za-z0-9_ -]", "_", stem)[:SUBROUTINE_NAME_MAX].strip() or "subroutine"


# -- a folder ---------------------------------------------------------------------------------------------------------


def _folder(path: Path, reading: _Reading) -> Project:
    entries = sorted(entry for entry in path.iterdir() if not entry.name.startswith("."))
    _refuse_devices(entries)
    tables = [entry for entry in entries if entry.suffix.casefold() == ".csv" and entry.is_file()]
    nicknames = next((table for table in tables if table.name.casefold() == "nicknames.csv"), None)
    if any(table.stem.casefold() == MAIN for table in tables):
        return _bundle(path, entries, [table for table in tables if table != nicknames], nicknames, reading)
    programs = [entry for entry in entries if _is_program(entry, reading)]
    if programs:
        return _programs(path, entries, programs, nicknames, reading)
    project = next((entry for entry in entries if is_click_project(b"", entry.name)), None)
    which = f" (and {project.name} is a project, which only CLICK opens)" if project else ""
    raise CouldNotRun(f"{path} holds neither main.csv nor a program file of CLICK{which}; import reads {_READS}")


def _refuse_devices(entries: Iterable[Path]) -> None:
    """Refuse entries that are named like ladder or a table but are neither file nor folder."""
    for entry in entries:
        is_asked = entry.suffix.casefold() in (".csv", *_PROGRAM_ENDINGS)
        if is_asked and entry.exists() and not (entry.is_file() or entry.is_dir()):
            raise CouldNotRun(f"{_shown(entry)} is a pipe or a device, not a file")


def _bundle(
    path: Path, entries: Sequence[Path], tables: Sequence[Path], nicknames: Path | None, reading: _Reading
) -> Project:
    main = reading.routine(MAIN, _parts(tables, reading), is_main=True)
    subroutines: dict[str, DrawnRoutine] = {}
    for file in _subroutine_files(entries):
        name = _shown(Path(file.stem))
        if name in subroutines:
            reading.problems.append(LadderProblem(f"{subroutines[name].file} has the same name", _shown(file)))
        else:
            subroutines[name] = reading.routine(name, [file])
    order = _order_of_build(path / "sources.json", subroutines, reading.files) or _order_of_calls(main, subroutines)
    return reading.project(path, [main, *(subroutines[name] for name in order)], nicknames)


def _subroutine_files(entries: Sequence[Path]) -> list[Path]:
    folders = [entry for entry in entries if entry.name.casefold() == "subroutines" and entry.is_dir()]
    files = [file for folder in folders for file in sorted(folder.iterdir()) if not file.name.startswith(".")]
    _refuse_devices(files)
    tables = [file for file in files if file.suffix.casefold() == ".csv" and file.is_file()]
    return [file for file in tables if not _is_copy(file, tables)]


def _parts(tables: Sequence[Path], reading: _Reading) -> list[Path]:
    """The files of main in their order. Other ladder files are noted: ClickNick would paste them into main, too."""
    parts: dict[int, Path] = {}
    for table in tables:
        stem = table.stem.casefold()
        match = _PART.fullmatch(stem)
        number = int(match[1]) if match else 1 if stem == MAIN else 0
        if number and number not in parts:
            parts[number] = table
        elif number:
            reading.problems.append(LadderProblem(f"{parts[number].name} is the same part of main", _shown(table)))
        elif not _is_copy(table, tables) and kind_of(reading.head(table)) is not Kind.OTHER:
            message = "the file is ladder and belongs to no routine: subroutines are read from subroutines/"
            reading.problems.append(LadderProblem(message, _shown(table)))
    missing = next((number for number in range(2, max(parts)) if number not in parts), None)
    if missing:
        reading.problems.append(LadderProblem(f"part {missing} of main is missing", _shown(parts[max(parts)])))
    return [parts[number] for number in sorted(parts)]


def _is_copy(file: Path, files: Sequence[Path]) -> bool:
    """True for ``Heat.clipboard.csv`` beside ``Heat.csv``: a copy of the same rungs."""
    return _stem(file) != file.stem and any(other.stem == _stem(file) for other in files)


def _stem(path: Path) -> str:
    return path.stem[: -len(_CAPTURE)] if path.stem.casefold().endswith(_CAPTURE) else path.stem


def _order_of_build(path: Path, names: Iterable[str], files: Workspace) -> list[str] | None:
    """The subroutines in the order of the source map; None without one, or if it is that of another program."""
    try:
        noted = json.loads(files.read(path))
    except (OSError, ValueError, RecursionError):
        return None
    routines = noted.get("routines") if isinstance(noted, dict) and noted.get("generator") == "clickgen" else None
    if not isinstance(routines, dict) or routines.keys() != {MAIN, *names}:
        return None
    return [name for name in routines if name != MAIN]


def _order_of_calls(main: DrawnRoutine, names: Iterable[str]) -> list[str]:
    """The subroutines in the order of main's calls, whatever their case: Windows does not distinguish such files."""
    known = {name.casefold(): name for name in sorted(names)}
    calls = (call_of(box.token) for rung in main.rungs for box in rung.boxes)
    called = [call.arguments[0][1:-1].casefold() for call in calls if call and call.name == "call" and call.arguments]
    return list(dict.fromkeys([*(known[name] for name in called if name in known), *sorted(names)]))


def _programs(
    path: Path, entries: Sequence[Path], programs: Sequence[Path], nicknames: Path | None, reading: _Reading
) -> Project:
    """Main has the index 1, the subroutines follow with theirs."""
    found: list[tuple[int, DrawnRoutine]] = []
    for program in programs:
        data = reading.whole(program)
        header = program_header(data)
        ladder = reading.ladder(data, _shown(program))
        if header:
            found.append((header.index, _program(header, program, ladder)))
    for entry in entries:
        if _PROGRAM_FILE.fullmatch(entry.name.casefold()) and entry not in programs and entry.is_file():
            message = "the file is no program file of CLICK, as its name says: is it damaged?"
            reading.problems.append(LadderProblem(message, _shown(entry)))
    found.sort(key=lambda one: (not one[1].is_main, one[0]))
    routines = [routine for _, routine in found]
    mains = [routine.file for routine in routines if routine.is_main]
    if len(mains) > 1:
        raise CouldNotRun(f"{mains[0]} and {mains[1]} are both main programs: import reads one project at a time")
    if not mains:
        known = f" ({reading.problems[0]})" if reading.problems else ""
        raise CouldNotRun(f"{path} holds program files of CLICK, and none of them is the main program{known}")
    for (index, routine), (other, following) in pairwise(found):
        if index == other or routine.name == following.name:
            message = f"the file is of the same routine as {routine.file}: are these two projects?"
            reading.problems.append(LadderProblem(message, following.file))
    return reading.project(path, routines, nicknames)


def _is_program(path: Path, reading: _Reading) -> bool:
    return (
        path.suffix.casefold() in _PROGRAM_ENDINGS and path.is_file() and reading.head(path).startswith(PROGRAM_MAGIC)
    )


def _shown(path: Path) -> str:
    """The name as the person gave it; bytes of it that are not text are marked."""
    return str(path).encode("utf-8", "surrogateescape").decode("utf-8", "replace")
