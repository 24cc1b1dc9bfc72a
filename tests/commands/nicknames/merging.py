"""Tables and exports to merge."""

from __future__ import annotations

from pathlib import Path

from clickgen.commands.nicknames.merge import KINDS
from clickgen.device.banks import parse_address
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.read import read_table
from clickgen.table.rows import HEADER, Row, default_row, format_row

ALL = set(KINDS)


def read(data: bytes, shown: str = "nicknames.csv") -> AddressTable:
    problems = Diagnostics()
    table = read_table(Path(shown), shown, problems, data)
    assert problems.found == []
    return table


def table(*rows: str, newline: str = "\n") -> AddressTable:
    return read(newline.join((HEADER, *map(row, rows), "")).encode())


def row(text: str) -> str:
    """``C1 Motor``, ``DS5 Level 10``, ``DS5 - 10 Yes a comment`` as a row; missing fields have CLICK's defaults."""
    place, name, *rest = text.split(" ", 4)
    address = parse_address(place)
    assert address is not None
    made = default_row(address, "" if name == "-" else name.replace("_", " "), rest[2] if len(rest) > 2 else "")
    initial = rest[0] if rest else made.initial
    retentive = rest[1] == "Yes" if len(rest) > 1 else made.retentive
    return format_row(Row(address, made.nickname, initial, retentive, made.comment))


def rows(table: AddressTable) -> list[str]:
    return [f"{row.address} {row.nickname or '-'}" for row in table.rows]


def read_table_with_faults(text: str) -> AddressTable:
    return read_table(Path("export.csv"), "export.csv", Diagnostics(), text.encode())
