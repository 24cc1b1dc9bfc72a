"""The sheet with the address table: clickgen reads it back as ``--nicknames``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from clickgen.device.banks import Kind
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Sheet, Value
from clickgen.table.rows import Row, format_initial

_PLAIN_NUMBER = re.compile(r"-?(0|[1-9][0-9]{0,9})")
_PLAIN_FLOAT = re.compile(r"-?[0-9]{1,8}(\.[0-9]{1,8})?")


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
    for row in sorted(project.built.rows, key=lambda row: row.address.sort_key):
        if not row.is_default:
            retentive = "Yes" if row.retentive else "No"
            kind = row.address.kind.value
            yield str(row.address), kind, row.nickname, initial(row), retentive, row.comment


def initial(row: Row) -> Value:
    """The initial value: a number if the sheet shows it with the same digits, else text.

    ``0100`` of a hexadecimal word is text, and so is ``-3.4028235E+38``: a spreadsheet would show fewer digits.
    """
    kind, text = row.address.kind, row.initial
    if kind in (Kind.BIT, Kind.INT16, Kind.INT32) and _PLAIN_NUMBER.fullmatch(text) and text != "-0":
        return int(text)
    if kind is Kind.FLOAT and _PLAIN_FLOAT.fullmatch(text) and format_initial(kind, float(text)) == text:
        return float(text)
    return text
