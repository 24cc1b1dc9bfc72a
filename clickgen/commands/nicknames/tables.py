"""The address tables of programs, each read once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from clickgen.commands.nicknames.programs import Program
from clickgen.lower.scratch import renamed_reason
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.blocks import Block, MarkedRow, marked_blocks, read_marks, renamed_mark
from clickgen.table.layers import beside_workbook
from clickgen.table.names import record_beside
from clickgen.table.read import TableUnreadable, bytes_of_table, read_table
from clickgen.table.record import left_in, placed_in, record_of
from clickgen.table.rows import Row, is_scratch
from clickgen.workspace import CouldNotRun, Workspace


@dataclass(frozen=True)
class Table:
    """An address table as it is on disk; ``key`` is its real path."""

    key: str
    path: Path
    table: AddressTable

    @property
    def rows(self) -> tuple[Row, ...]:
        return self.table.rows

    @cached_property
    def blocks(self) -> dict[str, Block]:
        """The blocks that comments mark, by their lowercase names."""
        return marked_blocks(self.table)

    def row(self, nickname: str) -> Row | None:
        return self.table.by_nickname.get(nickname.lower())

    def place(self, row: Row) -> str:
        return self.table.place(row)

    def renamed(self, old: str, new: str) -> bytes:
        """Return the file with another nickname in a row of its, and in the comments of clickgen's own cells."""
        row = self.row(old)
        assert row is not None
        assert row.cell is None
        table = self.table.renamed(row.address, new)
        for scratch in filter(is_scratch, self.table.own_rows):
            comment = renamed_reason(scratch.comment, row.nickname, new)
            if comment != scratch.comment:
                table = table.recommented(scratch.address, scratch.comment, comment)
        return table.to_bytes()

    def marks_of(self, block: str) -> list[MarkedRow]:
        """The rows that mark a block of this name."""
        return [each for each in read_marks(self.table).rows if each.mark.name.lower() == block.lower()]

    def with_block_renamed(self, old: str, new: str) -> bytes:
        """Return the file with another name in the marks of a block."""
        table = self.table
        for row, mark in self.marks_of(old):
            comment = renamed_mark(f"<{mark.word}>", old, new)
            table = table.recommented(row.address, f"<{mark.word}>", comment)
        return table.to_bytes()

    @property
    def record(self) -> Path:
        """The file that records the names that clickgen placed."""
        return record_beside(self.path)

    def record_renamed(self, data: bytes | None, old: str, new: str) -> bytes | None:
        """Return the record with another name for one that clickgen placed; None if it is not in it."""
        row, placed = self.row(old), placed_in(data)
        if row is None or placed.get(row.address) != row.nickname:
            return None
        return record_of(placed | {row.address: new}, left_in(data), data)

    def stand_in(self, old: str, new: str, is_block: bool) -> tuple[Path, bytes] | None:
        """For a table renamed before its sources: the table as it was, and its place."""
        if is_block:
            marks = self.marks_of(new)
            if not marks or self.marks_of(old):
                return None
            if all(row.cell is None for row, _ in marks):
                return self.path, self.with_block_renamed(new, old)
            rows = [replace(row, comment=renamed_mark(row.comment, new, old)) for row in self.rows]
            return self.path, AddressTable.empty(str(self.path)).extended(rows).to_bytes()
        row = self.row(new)
        if row is None or self.row(old) is not None:
            return None
        if row.cell is None:
            return self.path, self.table.renamed(row.address, old).to_bytes()
        rows = [replace(each, nickname=old) if each is row else each for each in self.rows]
        return self.path, AddressTable.empty(str(self.path)).extended(rows).to_bytes()


def read_tables(programs: Iterable[Program], files: Workspace) -> dict[str, Table]:
    """The tables of these programs by their real paths. Raises CouldNotRun for one that has errors."""
    tables: dict[str, Table] = {}
    for program in programs:
        if program.table_key not in tables:
            tables[program.table_key] = Table(program.table_key, program.table, _read(program, files))
    return tables


def over_workbook(table: AddressTable, workbook: Path, problems: Diagnostics, files: Workspace) -> AddressTable:
    """The table with the rows of a workbook in front. Raises TableUnreadable."""
    from clickgen.table.workbook.archive import bytes_of_workbook
    from clickgen.table.workbook.read import read_workbook

    data = bytes_of_workbook(workbook, str(workbook), files)
    return beside_workbook(table, read_workbook(workbook, str(workbook), problems, data), problems)


def _look(path: Path, files: Workspace) -> bytes | None:
    """The bytes of a table, or None if there is none. Raises TableUnreadable, and OSError."""
    if path.exists():
        bytes_of_table(path, str(path), files)
    return files.look(str(path))


def _read(program: Program, files: Workspace) -> AddressTable:
    shown = str(program.table)
    problems = Diagnostics()
    try:
        data = _look(program.table, files)
        table = AddressTable.empty(shown) if data is None else read_table(program.table, shown, problems, data)
        if program.workbook is not None:
            table = over_workbook(table, program.workbook, problems, files)
    except OSError as error:
        raise CouldNotRun(f"{shown} cannot be read: {error.strerror or error}") from None
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None
    for problem in problems.in_order():
        if problem.is_error:
            raise CouldNotRun(f"the address table has errors: {problem.span}: {problem.message}")
    return table
