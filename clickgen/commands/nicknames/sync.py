"""Brings address tables up to date with their programs: missing names get an address, unused ones are reported."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from clickgen.api import build, build_all
from clickgen.commands.nicknames.programs import Job, Program, programs_around
from clickgen.config import Config, find_config
from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, VALUE_BANK, Address
from clickgen.problems.diagnostics import Diagnostics
from clickgen.results import BuildResult
from clickgen.table.address_table import AddressTable
from clickgen.table.names import record_beside
from clickgen.table.read import read_table
from clickgen.table.record import left_in, placed_in, read_record, record_of
from clickgen.table.rows import Row, is_scratch
from clickgen.workspace import CouldNotRun, Workspace


@dataclass(frozen=True)
class TableSync:
    """The new state of one table."""

    path: Path
    added: tuple[Row, ...]
    """The rows that the programs bring, scratch included."""
    changed: tuple[Row, ...]
    """Rows to which the programs give another initial value, retention or comment."""
    unused: tuple[Row, ...]
    """The rows that no program refers to, including those that are removed."""
    removed: tuple[Row, ...]
    kept: Mapping[Address, str]
    """The reason why an unused row stays although it was to be removed, unless a person's edit keeps it."""
    doubtful: tuple[str, ...]
    """Programs of this table that have errors, so that nobody knows what they use."""


@dataclass(frozen=True)
class Sync:
    """It writes nothing: ``put_in_place(writes, (), unchanged)`` does that."""

    results: tuple[BuildResult, ...]
    """The programs that were named, built; if one is not ``ok`` there is nothing to write."""
    tables: tuple[TableSync, ...]
    writes: Mapping[Path, bytes]
    unchanged: Mapping[Path, bytes | None]

    @property
    def ok(self) -> bool:
        return all(result.ok for result in self.results)


def sync(jobs: Sequence[Job], config: Config, prune: bool = False, files: Workspace | None = None) -> Sync:
    """Allocate the names that these programs lack. ``prune`` removes rows that clickgen placed and nothing refers to.

    Every other program that uses the same table is looked at too: beside it, below it, and in the settings. Raises
    CouldNotRun if a file cannot be read.
    """
    files = files or Workspace()
    results = build_all(((job.program, job.settings) for job in jobs), files)
    if not all(result.ok for result in results):
        return Sync(tuple(results), (), {}, {})
    places = [result.table_path for result in results]
    places += [Path(os.path.realpath(place)) for place in places]
    around = programs_around(jobs, _with_programs_of(config, places, files), files, places)
    tables: list[TableSync] = []
    writes: dict[Path, bytes] = {}
    unchanged: dict[Path, bytes | None] = {}
    for key in dict.fromkeys(os.path.realpath(result.table_path) for result in results):
        own = [result for result in results if os.path.realpath(result.table_path) == key]
        others = [program for program in around if not program.is_job]
        table = _Table(own, others, prune, files)
        tables.append(table.sync)
        for path, data, before in table.files():
            unchanged[path] = before
            if data is not None and data != before:
                writes[path] = data
    return Sync(tuple(results), tuple(tables), writes, unchanged)


def table_changes(results: Sequence[BuildResult]) -> list[TableSync]:
    """Compare each table with what these programs make of it, built in this order; empty if one has errors."""
    if not all(result.ok for result in results):
        return []
    last = {os.path.realpath(result.table_path): result for result in results}
    first = {os.path.realpath(result.table_path): result for result in reversed(results)}
    changes = {key: _changes(first[key].table_path, first[key].table_before, last[key].address_table) for key in last}
    return [TableSync(first[key].table_path, *changed, (), (), {}, ()) for key, changed in changes.items()]


def _with_programs_of(config: Config, tables: Iterable[Path], files: Workspace) -> Config:
    """The settings with the programs that those around the tables name."""
    folders = dict.fromkeys(table.parent.absolute() for table in tables if table.parent.is_dir())
    found = [find_config(folder, files) for folder in folders]
    return config._replace(programs=(*config.programs, *(each for one in found for each in one.programs)))


class _Table:
    """One table with the programs that use it: those that were named, in their order, and the others.

    A program around it that has its own table is not among them. One whose table is missing may be used with this
    one later, so the names that it uses stay.
    """

    def __init__(self, own: Sequence[BuildResult], others: Sequence[Program], prune: bool, files: Workspace) -> None:
        self._path = own[0].table_path
        key = os.path.realpath(self._path)
        self._strangers = [each for each in others if each.table_key != key and not os.path.exists(each.table_key)]
        others = [each for each in others if each.table_key == key]
        self._before = own[0].table_before
        self._record = read_record(record_beside(self._path), files)
        self._placed = placed_in(self._record)
        self._placed |= {row.address: row.nickname for result in own for row in result.placed_rows}
        self._left = left_in(self._record)
        table = own[-1].address_table
        readers, doubtful = _read(others, self._path, table, files)
        users = [*own, *readers]
        named = [row for row in table.own_rows if row.nickname and not BANKS[row.address.bank].settings_fixed]
        unused = [row for row in named if not any(_is_used(row, result) for result in users)]
        gone = {row.address for row in unused}
        pairs = [left for result in own for left in result.left if left.is_half or left.old.address in gone]
        self._left |= {left.new.address: left.old.address for left in pairs}
        removed: list[Row] = []
        kept: dict[Address, str] = {}
        for row in unused if prune else ():
            reason = self._reason_to_stay(row, users, doubtful) if self._is_ours(row) else None
            if reason == "":
                removed.append(row)
            elif reason:
                kept[row.address] = reason
        self._table = table.changed({row.address: None for row in removed})
        added, changed = _changes(self._path, self._before, self._table)
        self.sync = TableSync(self._path, added, changed, tuple(unused), tuple(removed), kept, tuple(doubtful))

    def _is_ours(self, row: Row) -> bool:
        """True for a row that clickgen wrote and no person has touched since."""
        if is_scratch(row):
            return True
        is_bare = replace(row, nickname="").is_default
        return is_bare and self._placed.get(row.address, "") == row.nickname != ""

    def _reason_to_stay(self, row: Row, users: Iterable[BuildResult], doubtful: Sequence[str]) -> str:
        if doubtful:
            return f"{doubtful[0]} has errors, so nobody knows what it uses"
        for program in self._strangers:
            if any(file.of(row.nickname) for file in program.names):
                return f"{program.path} names it"
        for result in users:
            uses = result.facts.uses if result.facts else None
            if uses and any(uses.is_pointed(row.address.bank, way) for way in (True, False)):
                return f"{result.program} points into {row.address.bank}"
        return ""

    def files(self) -> list[tuple[Path, bytes | None, bytes | None]]:
        """The table and the record beside it: their new contents and their former ones."""
        rows = {row.address: row.nickname for row in self._table.own_rows}
        placed = {address: name for address, name in self._placed.items() if rows.get(address) == name}
        record = record_of(placed, self._left, self._record) if placed or self._record is not None else None
        data = None if self._before is None and not rows else self._table.to_bytes()
        return [
            (self._path, data, self._before),
            (record_beside(self._path), record, self._record),
        ]


def _changes(path: Path, before: bytes | None, table: AddressTable) -> tuple[tuple[Row, ...], tuple[Row, ...]]:
    """Return the rows that the file of a table lacks, and those that it has otherwise."""
    if before == table.to_bytes():
        return (), ()
    said: dict[Address, object] = {}
    if before is not None:
        said = {row.address: row.content for row in read_table(path, str(path), Diagnostics(), before).own_rows}
    rows = table.own_rows
    added = tuple(row for row in rows if row.address not in said)
    return added, tuple(row for row in rows if said.get(row.address, row.content) != row.content)


def _read(
    programs: Iterable[Program], path: Path, table: AddressTable, files: Workspace
) -> tuple[list[BuildResult], list[str]]:
    """The other programs, built with the table as it will be, and those that have errors."""
    readers: list[BuildResult] = []
    doubtful: list[str] = []
    with_table = files.apart({os.path.realpath(path): table.to_bytes()})
    for program in programs:
        try:
            result = build(program.path, settings=program.settings, workspace=with_table)
        except CouldNotRun:
            doubtful.append(program.path)
            continue
        readers.append(result)
        if not result.ok and not (program.is_part and _lacks_only_main(result)):
            doubtful.append(program.path)
    return readers, doubtful


def _lacks_only_main(result: BuildResult) -> bool:
    return all(problem.code == "CG401" for problem in result.diagnostics if problem.is_error)


def _is_used(row: Row, result: BuildResult) -> bool:
    """True if a program refers to a row: by name or number, in a range, by a declaration, for itself."""
    if row.address in result.needed:
        return True
    bank = row.address.bank
    twins = (bank, VALUE_BANK.get(bank), CURRENT_VALUE_OF.get(bank))
    addresses = [row.address._replace(bank=twin) for twin in twins if twin]
    return result.facts is not None and any(result.facts.uses.at(address) for address in addresses)
