"""An address table beside a workbook: the workbook comes first, the table holds only the names that it lacks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.table.address_table import AddressTable
from clickgen.table.read import bytes_of_table, read_table
from clickgen.table.rows import Row, default_row, is_scratch
from clickgen.workspace import Workspace


class TableRead(NamedTuple):
    """An address table with the rows of the workbook that it adds to, and the bytes of its file, or None."""

    table: AddressTable
    before: bytes | None


def read_layers(
    path: Path, workbook: Path | None, must_exist: bool, workspace: Workspace, problems: Diagnostics
) -> TableRead:
    """Return the address table at a place, which need not exist, over a workbook. Raises TableUnreadable."""
    shown = str(path)
    if workspace.has(path) or (must_exist and workbook is None):
        before: bytes | None = bytes_of_table(path, shown, workspace)
        table = read_table(path, shown, problems, before)
    else:
        before, table = workspace.look(path), AddressTable.empty(shown)
    if workbook is None:
        return TableRead(table, before)
    from clickgen.table.workbook.archive import bytes_of_workbook
    from clickgen.table.workbook.read import read_workbook

    rows = read_workbook(workbook, str(workbook), problems, bytes_of_workbook(workbook, str(workbook), workspace))
    return TableRead(beside_workbook(table, rows, problems), before)


def beside_workbook(table: AddressTable, base: Iterable[Row], problems: Diagnostics) -> AddressTable:
    """Return the table with the workbook's rows in front. A row of the table that contradicts one is a problem."""
    layered = replace(table, base=tuple(base))
    by_address = {row.address: row for row in layered.base}
    by_name = {row.nickname.lower(): row for row in layered.base if row.nickname}
    for row in table.own_rows:
        stands = by_address.get(row.address)
        holder = by_name.get(row.nickname.lower()) if row.nickname else None
        if stands is not None and row.nickname.lower() != stands.nickname.lower():
            there = stands.nickname or (f'"{stands.spare}"' if stands.spare else "given no name")
            _disagree(
                layered, row, stands, f"{row.address} is {row.nickname or 'given no name'} here and {there}", problems
            )
        elif holder is not None and holder.address != row.address:
            _disagree(layered, row, holder, f"{row.nickname} is {row.address} here and {holder.address}", problems)
        elif stands is not None:
            for what, here, there in _other_settings(row, stands):
                _disagree(layered, row, stands, f"the {what} of {row.address} is {here} here and {there}", problems)
    return layered


def _other_settings(row: Row, other: Row) -> Iterator[tuple[str, str, str]]:
    """Yield the settings in which a row differs from the workbook; a row with no settings of its own agrees."""
    usual = default_row(row.address, row.nickname)
    if row.initial not in (usual.initial, other.initial):
        yield "initial value", row.initial, other.initial or "nothing"
    if row.retentive not in (usual.retentive, other.retentive):
        yield "retention", "Yes" if row.retentive else "No", "Yes" if other.retentive else "No"
    if row.comment not in ("", other.comment):
        yield "comment", f'"{row.comment}"', f'"{other.comment}"'


def _disagree(table: AddressTable, row: Row, other: Row, what: str, problems: Diagnostics) -> None:
    if is_scratch(row):
        help = "delete this row: clickgen then takes another cell for itself"
    else:
        help = "change one of them, this row being the one that clickgen wrote; a PLC keeps its data by address"
    assert other.cell is not None
    label = Label(other.cell, "the workbook says")
    problems.add("CG605", table.span(row), f"{what} in {table.place(other)}", help, (label,))
