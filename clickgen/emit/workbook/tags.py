"""The sheet with the address table: clickgen reads it back as ``--nicknames``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from clickgen.device.banks import Kind
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Sheet, Value
from clickgen.resolve.rows import Row

_PLAIN_NUMBER = re.compile(r"-?(0|[1-9][0-9]{0,9})")


def tags(project: Project) -> Sheet:
    return Sheet(
        "Tags",
        "The address table. Name this workbook after --nicknames to build with it.",
        (
            Column("Address", 10),
            Column("Data type", 10),
            Column("Nickname", 27),
            Column("Initial value", 15),
            Column("Retentive", 10),
            Column("Comment", 70, wraps=True),
        ),
        _rows(project),
    )


def _rows(project: Project) -> Iterator[Cells]:
    for row in sorted(project.rows, key=lambda row: row.address.sort_key):
        if not row.is_default:
            retentive = "Yes" if row.retentive else "No"
            kind = row.address.kind.value
            yield str(row.address), kind, row.nickname, initial(row), retentive, row.comment


def initial(row: Row) -> Value:
    """The initial value: a number where the sheet shows it with the same digits, else text.

    ``0100`` of a hexadecimal word is text, and so is every floating-point number: a spreadsheet would round it.
    """
    is_whole = row.address.kind in (Kind.BIT, Kind.INT16, Kind.INT32)
    if is_whole and _PLAIN_NUMBER.fullmatch(row.initial) and row.initial != "-0":
        return int(row.initial)
    return row.initial
