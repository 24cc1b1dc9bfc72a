"""One side of a difference: its routines as drawn, and its address table."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from clickgen.api import build
from clickgen.click.read.built import built_ladders
from clickgen.click.read.grid import Ladder
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.project import DrawnRoutine, Project, read_project
from clickgen.commands.diff.placing import name_key, placed_alike
from clickgen.config import Settings
from clickgen.device.banks import Address, parse_address
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.results import BuildResult
from clickgen.table.address_table import AddressTable, Entry
from clickgen.table.form import TableForm
from clickgen.table.judge_row import initial_value_fault, retention_fault
from clickgen.table.names import TABLE_NAME, is_workbook
from clickgen.table.read import PROBLEMS_MAX, TableUnreadable, bytes_of_table, read_table
from clickgen.table.rows import HEADER, Row, format_row, is_scratch
from clickgen.text.source import SourceFile
from clickgen.workspace import CouldNotRun, Workspace

_PROBLEMS_SHOWN = 20
_ADDRESS_MAX = 16
"""No address is longer, and int() must not get a field of thousands of digits."""


class BrokenProgram(CouldNotRun):
    """A program with errors: there is no ladder to compare. ``problems`` has the errors."""

    def __init__(self, shown: str, problems: Sequence[Diagnostic], sources: Sequence[SourceFile]) -> None:
        super().__init__(f"{shown} has errors")
        self.shown = shown
        self.problems = tuple(problems)
        self.sources = tuple(sources)


class Damaged(CouldNotRun):
    """Ladder files that cannot be read in full; the message has a line for each fault."""

    def __init__(self, shown: str, problems: Iterable[LadderProblem]) -> None:
        lines = list(dict.fromkeys(f"  {problem}" for problem in problems))
        more = len(lines) - _PROBLEMS_SHOWN
        lines = [*lines[:_PROBLEMS_SHOWN], *([f"  and {more} more"] if more > 0 else [])]
        super().__init__(f"{shown} is damaged; what is left is not compared:", *lines)


@dataclass(frozen=True)
class Side:
    """``shown`` is the person's name for it. A side that ``is_part`` is a file with a routine, not a whole project.

    ``table`` is None without a table; ``doubt`` says why there is none, or why it is only good for names. ``unread``
    has the rows without a readable initial value, ``faults`` the first problems of rows.
    ``placed`` has the names that get their addresses only from a build.
    """

    shown: str
    routines: tuple[DrawnRoutine, ...]
    table: AddressTable | None = None
    doubt: str = ""
    is_part: bool = False
    placed: tuple[Row, ...] = ()
    unread: Mapping[Address, str] = field(default_factory=dict)
    faults: tuple[str, ...] = ()

    @cached_property
    def scratch_rows(self) -> tuple[Row, ...]:
        """The cells that clickgen needs for itself."""
        return tuple(row for row in self.table.rows if is_scratch(row)) if self.table else ()

    @cached_property
    def scratch(self) -> frozenset[Address]:
        return frozenset(row.address for row in self.scratch_rows)


def is_program(name: str) -> bool:
    """True for a file that is built; everything else is read as ladder."""
    return name.lower().endswith(".py")


_MAIN = re.compile(rb"^def main\(", re.MULTILINE)
_IS_LADDER = re.compile(r"main\.csv|Scr\d+\.(tmp|scr)", re.IGNORECASE)


def program_in(folder: Path, shown: str, files: Workspace) -> str | None:
    """The name of the program in a folder of programs; None for a folder of ladder, or of neither.

    Raises CouldNotRun if it has several.
    """
    there = sorted(path for path in folder.iterdir() if path.is_file())
    if any(_IS_LADDER.fullmatch(path.name) for path in there):
        return None
    programs = [path.name for path in there if is_program(path.name) and _MAIN.search(files.read(path))]
    if len(programs) > 1:
        place = shown if shown.endswith(("/", ":", os.sep)) else f"{shown}/"
        listed = ", ".join(f"{place}{name}" for name in programs)
        raise CouldNotRun(f"{shown} has several programs: name one of {listed}")
    return programs[0] if programs else None


def program_side(path: Path, shown: str, settings: Settings, files: Workspace, placed: Sequence[Row] = ()) -> Side:
    """Return a program, built in memory; its ladder is that of its files, as CLICK gets it.

    ``placed`` has the names that got their addresses on the other side only from a build: if this side needs an address
    for the same name, it gets that one. Raises BrokenProgram, and CouldNotRun if there is no program.
    """
    result = build(str(path), settings=settings, workspace=files)
    if not result.ok:
        errors = [problem for problem in result.diagnostics if problem.is_error]
        raise BrokenProgram(shown, errors, [*result.sources, *_text_of_table(result)])
    names = {name_key(row) for row in result.placed_rows if row.nickname}
    if names and placed:
        shared = [row for row in placed if name_key(row) in names]
        result = placed_alike(result, settings, shared, placed, files)
    table = _table_of(str(result.table_path), result.rows)
    own = tuple(row for row in result.rows if name_key(row) in names)
    return Side(shown, tuple(_routines(result, shown)), table, placed=own)


def _routines(result: BuildResult, shown: str) -> Iterable[DrawnRoutine]:
    ladders = built_ladders(result.files, f"{shown}: ")
    for routine in result.routines:
        rungs = _whole(ladders[routine.name], shown).rungs
        yield DrawnRoutine(routine.name, routine.is_main, rungs, rungs[0].file if rungs else shown)


def _whole(ladder: Ladder, shown: str) -> Ladder:
    if ladder.all_problems:
        raise Damaged(shown, ladder.all_problems)
    return ladder


def _text_of_table(result: BuildResult) -> list[SourceFile]:
    """The table, so that its rows can be shown when its file is gone."""
    if result.table_before is None:
        return []
    return [SourceFile(str(result.table_path), result.table_before.decode("utf-8-sig", "replace"))]


def ladder_side(path: Path, shown: str, nicknames: Path | None, files: Workspace) -> Side:
    """Return a bundle, a ladder file, a capture, or CLICK's program files; ``nicknames`` if it has no table itself.

    Raises Damaged, and CouldNotRun if there is no ladder.
    """
    project = read_project(path, files)
    problems = [*project.problems, *(each for one in project.routines for rung in one.rungs for each in rung.problems)]
    if problems:
        raise Damaged(shown, problems)
    names = [routine.name for routine in project.routines]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise CouldNotRun(f"{shown} has two routines of the name {twice}")
    side = Side(shown, project.routines, is_part=not path.is_dir())
    return _with_table(side, project.nicknames or _beside(path, project) or nicknames, files)


def _beside(path: Path, project: Project) -> Path | None:
    """The table of the bundle that a single file belongs to."""
    folder = path.parent.parent if path.parent.name == "subroutines" else path.parent
    is_in_bundle = project.texts and (folder / "main.csv").is_file()
    table = folder / TABLE_NAME
    return table if not path.is_dir() and is_in_bundle and table.is_file() else None


def _with_table(side: Side, path: Path | None, files: Workspace) -> Side:
    if path is None:
        return replace(side, doubt=f"{side.shown} has no {TABLE_NAME}")
    problems = Diagnostics()
    try:
        table = _table(path, problems, files)
    except TableUnreadable as error:
        return replace(side, doubt=str(error))
    errors = [problem for problem in problems.in_order() if problem.is_error]
    faults = tuple(f"{error.span}: {error.message}" for error in errors)
    if faults and (is_workbook(path) or len(faults) >= PROBLEMS_MAX):
        return replace(side, table=table, doubt=faults[0])
    unread = dict(_unread(table, {error.span.line for error in errors if error.span}))
    return replace(side, table=table, unread=unread, faults=faults)


def _unread(table: AddressTable, lines: Iterable[int]) -> Iterator[tuple[Address, str]]:
    """The rows with a fault on one of these lines whose values cannot be read, by their addresses."""
    at = {line: row for row in table.rows for line in range(row.line, row.line + row.raw.count("\n") + 1)}
    texts = table.text().split("\n")
    for line in lines:
        row = at.get(line)
        text = row.raw if row else texts[line - 1]
        address = row.address if row else parse_address(text.partition(",")[0].strip('"')[:_ADDRESS_MAX])
        if address is not None and (row is None or not _has_values(row, table.form)):
            yield address, text.rstrip("\r")


def _has_values(row: Row, form: TableForm) -> bool:
    """False if the row does not give its address's initial value, or its retention."""
    fields = form.fields(next(csv.reader([row.raw])))
    initial_is_legal = row.initial == "0" or initial_value_fault(row.address, row.initial) is None
    retention_is_legal = fields[4] in ("Yes", "No") and retention_fault(row.address, row.retentive) is None
    return fields[1] == row.address.kind.value and initial_is_legal and retention_is_legal


def _table(path: Path, problems: Diagnostics, files: Workspace) -> AddressTable:
    if not is_workbook(path):
        return read_table(path, str(path), problems, bytes_of_table(path, str(path), files))
    from clickgen.table.workbook.archive import bytes_of_workbook
    from clickgen.table.workbook.read import read_workbook

    data = bytes_of_workbook(path, str(path), files)
    return _table_of(str(path), read_workbook(path, str(path), problems, data))


def _table_of(path: str, rows: Iterable[Row]) -> AddressTable:
    """A table with these rows, whatever they say."""
    return AddressTable(path, (Entry(None, HEADER, "\n"), *(Entry(row, format_row(row), "\n") for row in rows)))
