"""The address tables of programs, each read once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from clickgen.diagnostics import CouldNotRun, Diagnostics
from clickgen.nicknames.programs import Files, Program
from clickgen.resolve.blocks import Block, marked_blocks
from clickgen.resolve.layers import beside_workbook
from clickgen.resolve.read_table import TableUnreadable, bytes_of_table, read_table
from clickgen.resolve.record import left_in, placed_in, record_beside, record_of
from clickgen.resolve.rows import Row
from clickgen.resolve.table import AddressTable


@dataclass(frozen=True)
class Table:
    """An address table as it stands on disk; ``key`` is its real path."""

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
        """The file with another nickname in the row of one that it has."""
        row = self.row(old)
        assert row is not None
        assert row.cell is None
        return self.table.renamed(row.address, new).to_bytes()

    @property
    def record(self) -> Path:
        """Where it says which names clickgen placed."""
        return record_beside(self.path)

    def record_renamed(self, data: bytes | None, old: str, new: str) -> bytes | None:
        """The record with another name for one that clickgen placed; None where it is not in it."""
        row, placed = self.row(old), placed_in(data)
        if row is None or placed.get(row.address) != row.nickname:
            return None
        return record_of(placed | {row.address: new}, left_in(data))

    def stand_in(self, old: str, new: str) -> tuple[Path, bytes] | None:
        """Where the table was renamed already and the sources were not: the table as it was before, and its place."""
        row = self.row(new)
        if row is None or self.row(old) is not None:
            return None
        if row.cell is None:
            return self.path, self.table.renamed(row.address, old).to_bytes()
        rows = [replace(each, nickname=old) if each is row else each for each in self.rows]
        return self.path, AddressTable.empty(str(self.path)).extended(rows).to_bytes()


def read_tables(programs: Iterable[Program], files: Files) -> dict[str, Table]:
    """The tables of these programs by their real paths. Raises CouldNotRun for one that has errors."""
    tables: dict[str, Table] = {}
    for program in programs:
        if program.table_key not in tables:
            tables[program.table_key] = Table(program.table_key, program.table, _read(program, files))
    return tables


def over_workbook(table: AddressTable, workbook: Path, problems: Diagnostics) -> AddressTable:
    """The table with the rows of a workbook in front. Raises TableUnreadable."""
    from clickgen.resolve.read_workbook import read_workbook

    return beside_workbook(table, read_workbook(workbook, str(workbook), problems), problems)


def _look(path: Path, files: Files) -> bytes | None:
    """The bytes of a table, None where there is none. Raises TableUnreadable, and OSError."""
    if path.exists():
        bytes_of_table(path, str(path))
    return files.look(str(path))


def _read(program: Program, files: Files) -> AddressTable:
    shown = str(program.table)
    problems = Diagnostics()
    try:
        data = _look(program.table, files)
        table = AddressTable.empty(shown) if data is None else read_table(program.table, shown, problems, data)
        if program.workbook is not None:
            table = over_workbook(table, program.workbook, problems)
    except OSError as error:
        raise CouldNotRun(f"{shown} cannot be read: {error.strerror or error}") from None
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None
    for problem in problems.in_order():
        if problem.is_error:
            raise CouldNotRun(f"the address table has errors: {problem.span}: {problem.message}")
    return table
