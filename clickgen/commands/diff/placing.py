"""Gives names without an address on either side the same one on both: such names are compared as names."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

from clickgen.api import build
from clickgen.click.compare.outputs import touched_by
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.config import Settings
from clickgen.device.banks import CURRENT_VALUE_OF, VALUE_BANK, Address
from clickgen.lower.effects import Cells, reads
from clickgen.problems.diagnostics import Diagnostics
from clickgen.results import BuildResult
from clickgen.table.address_table import AddressTable
from clickgen.table.names import TABLE_NAME
from clickgen.table.read import read_table
from clickgen.table.rows import Row
from clickgen.workspace import CouldNotRun, Workspace


def name_key(row: Row) -> tuple[str, str]:
    """The key of a name: its bank, and its letters without regard to capitals."""
    return row.address.bank, row.nickname.lower()


def placed_alike(
    result: BuildResult, settings: Settings, shared: Sequence[Row], theirs: Sequence[Row], files: Workspace
) -> BuildResult:
    """Build again, with these shared names where the other side has them, as far as nothing else is there.

    ``theirs`` has all names that got their addresses only on the other side; no other name gets one of these.
    Raises CouldNotRun if a bank has no room to keep the names of both sides apart: at one address they would look
    like one name.
    """
    taken = {*_taken(result), *settings.reserved}
    rows = [row for row in shared if _with_twin(row.address).isdisjoint(taken)]
    table = _with_rows(result, rows)
    alike = settings._replace(reserved=(*settings.reserved, *(row.address for row in theirs)))
    with_table = files.apart({os.path.realpath(result.table_path): table.to_bytes()})
    found = build(str(result.program), settings=alike, workspace=with_table)
    full = next((problem for problem in found.diagnostics if problem.code == "CG208"), None)
    if full is not None:
        raise CouldNotRun(
            f"{result.program} cannot be compared by its names ({full.message}); give both programs their address "
            "tables with clickgen nicknames sync, and compare again"
        )
    return found if found.ok else result


def _with_rows(result: BuildResult, rows: Iterable[Row]) -> AddressTable:
    shown = str(result.table_path)
    before = result.table_before
    table = AddressTable.empty(shown) if before is None else read_table(result.table_path, shown, Diagnostics(), before)
    return table.extended(rows)


def _taken(result: BuildResult) -> set[Address]:
    """The addresses that the program itself or its table uses, without the build's choices for names."""
    chosen = {twin for row in result.placed_rows for twin in _with_twin(row.address)}
    found = Cells({row.address for row in result.rows if row.address not in chosen} | result.needed)
    for name, text in result.files.items():
        if name.endswith(".csv") and name != TABLE_NAME:
            for rung in read_ladder(text, name).rungs:
                found.update(_touched(rung))
    return {twin for address in found.addresses - chosen for twin in _with_twin(address)}


def _touched(rung: DrawnRung) -> Cells:
    """The cells that the contacts and outputs of a rung look at or change."""
    found = Cells()
    for row in rung.rows:
        for square in row.squares:
            if square.contact is not None:
                found.update(reads(square.contact))
    for box in rung.boxes:
        found.update(touched_by(box))
    return found


def _with_twin(address: Address) -> set[Address]:
    """The bit and the current value of a timer or counter share a number."""
    twin = VALUE_BANK.get(address.bank) or CURRENT_VALUE_OF.get(address.bank)
    return {address, Address(twin, address.number)} if twin else {address}
