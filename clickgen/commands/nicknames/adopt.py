"""Finishing a rename that somebody began in the text: the sources say the new name, the table still has the old one."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import NamedTuple

from clickgen.commands.nicknames.programs import Program
from clickgen.commands.nicknames.prove import Side
from clickgen.commands.nicknames.tables import Table
from clickgen.commands.nicknames.uses import FileNames
from clickgen.device.banks import CURRENT_VALUE_OF
from clickgen.facts.uses import addresses_of
from clickgen.problems.diagnostics import CouldNotRun
from clickgen.table.record import left_in, placed_in, record_of
from clickgen.table.rows import Row
from clickgen.workspace import Workspace

Edited = Callable[[FileNames, str, str, Workspace], bytes]
"""A file with another name in the place of one."""


class Adoption(NamedTuple):
    """What becomes of the tables, and how it is proved: the programs as they were before somebody renamed in them."""

    writes: dict[str, bytes]
    """By real path: tables, and the records beside them."""
    row: Row
    """The row that gets the new name."""
    freed: tuple[Row, ...]
    """What a build had given to the new name meanwhile."""
    old: str
    """The old name; where no source could say it, one that stands for it in the proof."""
    before: Side


def adopt(
    old: str, new: str, members: Iterable[Program], tables: Mapping[str, Table], files: Workspace, edited: Edited
) -> Adoption | None:
    """The new name at the address of the old one; None where the sources do not say the new name for the old one.

    They do where some say the new one and none the old one, and where the new one has no address yet, or one that a
    build gave to it when the old one left. Raises CouldNotRun where the two are of different banks.
    """
    sources = {os.path.realpath(file.source.path): file for program in members for file in program.names}
    using = {key: file for key, file in sources.items() if file.of(new)}
    if not using or any(file.of(old) or file.blocks_of(old) or file.blocks_of(new) for file in sources.values()):
        return None
    used = {address for file in sources.values() for cell in file.cells for address in addresses_of(cell)}
    alias = old if old.isidentifier() else re.sub(r"\W", "_", old)
    writes: dict[str, bytes] = {}
    tables_before: dict[str, bytes] = {}
    freed: list[Row] = []
    rows: list[Row] = []
    for key, table in tables.items():
        row, other = table.row(old), table.row(new)
        if row is None or row.cell is not None or (alias != old and table.row(alias)):
            return None
        record = files.look(str(table.record))
        if other is not None and (other.address in used or not _came_for(other, row, record)):
            return None
        _refuse_other_bank(row, new, using.values())
        without = table.table.changed({other.address: None}) if other else table.table
        writes[key] = without.renamed(row.address, new).to_bytes()
        tables_before[key] = without.renamed(row.address, alias).to_bytes()
        if record is not None:
            writes[os.path.realpath(table.record)] = _record(record, row, other, new)
        rows.append(row)
        freed += [other] if other else []
    texts = {key: edited(file, new, alias, files) for key, file in using.items()}
    before = Side(files.apart({**tables_before, **texts}), {})
    return Adoption(writes, rows[0], tuple(freed), alias, before) if rows else None


def _came_for(other: Row, row: Row, record: bytes | None) -> bool:
    """True for a row that clickgen placed when the old name left, and that nobody has touched since."""
    is_bare = replace(other, nickname="").is_default
    is_placed = placed_in(record).get(other.address) == other.nickname
    return is_bare and is_placed and left_in(record).get(other.address) == row.address


def _record(record: bytes, row: Row, other: Row | None, new: str) -> bytes:
    placed = placed_in(record)
    if other is not None:
        placed.pop(other.address, None)
    if placed.get(row.address) == row.nickname:
        placed[row.address] = new
    left = {came: gone for came, gone in left_in(record).items() if gone != row.address}
    return record_of(placed, left)


def _refuse_other_bank(row: Row, new: str, files: Iterable[FileNames]) -> None:
    for file in files:
        for named in file.of(new):
            if _bank(named.bank) != row.address.bank:
                raise CouldNotRun(
                    f"{row.nickname} is {row.address}, and {named.span} says {named.bank.lower()}.{new}: an address "
                    f"stays in its bank, so write {row.address.bank.lower()}.{new} there"
                )


def _bank(bank: str) -> str:
    return CURRENT_VALUE_OF.get(bank, bank)
