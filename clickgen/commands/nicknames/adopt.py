"""Finishes a rename that somebody began in the text: the sources have the new name, the table still has the old one.

In a half-done rename the sources have both: it is finished if a build has recorded that the new name came for the old.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import NamedTuple

from clickgen.commands.nicknames.programs import Program
from clickgen.commands.nicknames.prove import Side
from clickgen.commands.nicknames.tables import Table
from clickgen.commands.nicknames.uses import FileNames, read_names
from clickgen.device.banks import CURRENT_VALUE_OF
from clickgen.dialects.registry import dialect_of
from clickgen.facts.uses import addresses_of
from clickgen.ir.program import BlockDeclaration
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.record import left_in, placed_in, record_of
from clickgen.table.rows import Row
from clickgen.workspace import CouldNotRun, Workspace

Edited = Callable[[FileNames, str, str, Workspace], bytes]
"""Returns a file with one name replaced by another."""


class Adoption(NamedTuple):
    """The new tables, and the proof: the programs as they were before somebody renamed in them."""

    writes: dict[str, bytes]
    """By real path: tables, and the records beside them."""
    row: Row
    """The row that gets the new name."""
    freed: tuple[Row, ...]
    """The rows that a build gave to the new name meanwhile."""
    old: str
    """The old name; if no source can say it, a placeholder for it in the proof."""
    before: Side
    edited: Mapping[str, FileNames] = {}
    """The sources that still had the old name, by their real paths."""


def adopt(
    old: str, new: str, members: Iterable[Program], tables: Mapping[str, Table], files: Workspace, edited: Edited
) -> Adoption | None:
    """Put the new name at the address of the old one; None unless the sources use the new name for the old one.

    They do if some have the new one and none the old one, and if the new one has no address yet, or one that a
    build gave to it when the old one left. If some still have the old one, a build must have recorded that the new
    one came for it. Raises CouldNotRun if the two are of different banks.
    """
    sources = {os.path.realpath(file.source.path): file for program in members for file in program.names}
    using = {key: file for key, file in sources.items() if file.of(new)}
    behind = {key: file for key, file in sources.items() if file.of(old)}
    if not using or any(file.blocks_of(old) or file.blocks_of(new) for file in sources.values()):
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
        if other is None and behind:
            return None
        _refuse_other_bank(row, new, using.values())
        without = table.table.changed({other.address: None}) if other else table.table
        writes[key] = without.renamed(row.address, new).to_bytes()
        tables_before[key] = without.renamed(row.address, alias).to_bytes()
        if record is not None:
            writes[os.path.realpath(table.record)] = _record(record, row, other, new)
        rows.append(row)
        freed += [other] if other else []
    if not rows:
        return None
    after = {key: edited(file, old, new, files) for key, file in behind.items()}
    texts = {
        key: _with_alias(file, after.get(key), new, alias, files, edited) for key, file in {**using, **behind}.items()
    }
    before = Side(files.apart({**tables_before, **texts}), {})
    return Adoption({**writes, **after}, rows[0], tuple(freed), alias, before, behind)


def adopt_block(
    old: str, new: str, members: Iterable[Program], tables: Mapping[str, Table], files: Workspace, edited: Edited
) -> Adoption | None:
    """Put the new name in the marks of a block; None unless the sources have the new name for it."""
    sources = {os.path.realpath(file.source.path): file for program in members for file in program.names}
    using = {key: file for key, file in sources.items() if file.every(new)}
    is_declared = any(
        isinstance(each, BlockDeclaration) and each.named.name.lower() == new.lower()
        for file in using.values()
        for each in file.declarations
    )
    marks = [row for table in tables.values() for row, _ in table.marks_of(old)]
    if not is_declared or not marks or any(file.every(old) for file in sources.values()):
        return None
    alias = old if old.isidentifier() else re.sub(r"\W", "_", old)
    writes = {key: table.with_block_renamed(old, new) for key, table in tables.items() if table.marks_of(old)}
    before = {key: table.with_block_renamed(old, alias) for key, table in tables.items() if table.marks_of(old)}
    texts = {key: edited(file, new, alias, files) for key, file in using.items()}
    return Adoption(writes, marks[0], (), alias, Side(files.apart({**before, **texts}), {}))


def _with_alias(file: FileNames, data: bytes | None, new: str, alias: str, files: Workspace, edited: Edited) -> bytes:
    """Return a source with the old name, or its placeholder, wherever the new one is; ``data`` is its new content."""
    if data is None:
        return edited(file, new, alias, files)
    path = file.source.path
    source = dialect_of(path, data).decode(path, data, Diagnostics())
    renamed = read_names(source, Diagnostics()) if source is not None else None
    assert renamed is not None
    return edited(renamed, new, alias, Workspace({os.path.realpath(path): data}))


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
                spell = file.dialect.spell
                raise CouldNotRun(
                    f"{row.nickname} is {row.address}, and {named.span} says {spell.name(named.bank, new)}: an address "
                    f"stays in its bank, so write {spell.name(row.address.bank, new)} there"
                )


def _bank(bank: str) -> str:
    return CURRENT_VALUE_OF.get(bank, bank)
