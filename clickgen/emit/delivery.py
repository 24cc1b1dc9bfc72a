"""Deliver what builds made: the outputs, the extended address table and the record of placed names, or nothing."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.emit.folder import ForeignFiles, stale_files
from clickgen.table.names import record_beside
from clickgen.table.record import read_record, with_placed
from clickgen.table.rows import Row
from clickgen.text.write import put_in_place
from clickgen.workspace import CouldNotRun, Workspace


class TableChange(NamedTuple):
    """An address table before and after a build. ``before`` is None where there was no table.

    ``placed`` are the names that clickgen placed in the build, ``left`` the addresses of names that left the program,
    by the addresses of those that came in their place.
    """

    path: Path
    before: bytes | None
    after: bytes
    placed: tuple[Row, ...]
    left: Mapping[Address, Address]


class Delivery(NamedTuple):
    """The outputs of one build, by their paths inside ``folder``; ``table`` is None where no table is to be written."""

    folder: Path
    files: Mapping[str, str]
    table: TableChange | None


def deliver(deliveries: Iterable[Delivery]) -> list[Path]:
    """Put everything in place, all or nothing; returns what really changed.

    Removes the files of earlier builds that these do not make. Of programs that share an address table, each must have
    been built with the table that the one before it made. Raises CouldNotRun when a folder holds files that are not
    clickgen's and in the way; OSError when something cannot be written; ChangedMeanwhile when a table changed since it
    was read.
    """
    # A fresh view of the disk: a build may be delivered long after it has read its files, and more than once.
    disk = Workspace()
    writes: dict[Path, bytes] = {}
    removals: list[Path] = []
    no_links: list[Path] = []
    changes: list[TableChange] = []
    for folder, files, table in deliveries:
        outputs = {name: text.encode() for name, text in files.items()}
        writes.update((folder / name, data) for name, data in outputs.items())
        no_links += (folder / name for name in outputs)
        try:
            removals += stale_files(folder, outputs, disk)
        except ForeignFiles as error:
            raise CouldNotRun(str(error)) from None
        if table is not None:
            changes.append(table)
    tables, records = _tables(changes), _records(changes, disk)
    for path in writes:
        if os.path.realpath(path) in tables:
            raise CouldNotRun(f"{path.parent} holds the address table {path.name}; choose another folder with -o")
    unchanged: dict[Path, bytes | None] = {}
    for path, before, after in tables.values():
        # A result that is written a second time finds the table as it wants it.
        unchanged[path] = after if _holds(path, after, disk) else before
        if after != before:
            writes[path] = after
    for path, (before, record) in records.items():
        if record is not None and record != before:
            writes[path], unchanged[path] = record, before
    return put_in_place(writes, removals, unchanged, [*no_links, *records])


def _holds(path: Path, data: bytes, disk: Workspace) -> bool:
    try:
        return disk.read(path) == data
    except (FileNotFoundError, NotADirectoryError):
        return False


def _tables(changes: Iterable[TableChange]) -> dict[str, tuple[Path, bytes | None, bytes]]:
    """Each table by its real path: as it was before the first change, and as it is after the last."""
    tables: dict[str, tuple[Path, bytes | None, bytes]] = {}
    for change in changes:
        place = os.path.realpath(change.path)
        path, before, _ = tables.get(place, (change.path, change.before, b""))
        tables[place] = (path, before, change.after)
    return tables


def _records(changes: Iterable[TableChange], disk: Workspace) -> dict[Path, tuple[bytes | None, bytes | None]]:
    """The record beside each table, before and after."""
    first: dict[str, Path] = {}
    placed: dict[Path, list[Row]] = {}
    left: dict[Path, dict[Address, Address]] = {}
    for change in changes:
        path = record_beside(first.setdefault(os.path.realpath(change.path), change.path))
        placed.setdefault(path, []).extend(change.placed)
        left.setdefault(path, {}).update(change.left)
    records: dict[Path, tuple[bytes | None, bytes | None]] = {}
    for path, rows in placed.items():
        data = read_record(path, disk)
        records[path] = data, with_placed(data, rows, left[path])
    return records
