"""Writes sheets into the bytes of a workbook, every text as text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from io import BytesIO
from itertools import islice
from typing import cast

from openpyxl import Workbook
from openpyxl.utils import get_column_letter
from openpyxl.workbook.properties import CalcProperties
from openpyxl.worksheet.worksheet import Worksheet
from openpyxl.writer.excel import ExcelWriter

from clickgen.emit.workbook.archive import PinnedZip
from clickgen.emit.workbook.looks import TEXT_FORMAT_MAX, Style, set_up, styled_cell
from clickgen.emit.workbook.markup import Entry, row_markup
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet, Value

ROWS_MAX = 1_048_576
TEXT_MAX = 32_767
"""Excel's limits for a sheet and for a cell."""
_CUT = " [cut]"


def to_bytes(sheets: Iterable[Sheet], program: str) -> bytes:
    """Return the workbook; ``program`` is named at the foot of each page.

    openpyxl writes everything but the rows: its sheets stay empty, and the rows go into them in the archive.
    """
    book = Workbook(write_only=True)
    book.calculation = CalcProperties(fullCalcOnLoad=False)
    rows: list[str] = []
    for sheet in sheets:
        # A sheet written row by row has everything that is used here of one in memory; its types say less.
        rows.append(_write(cast(Worksheet, book.create_sheet(sheet.name)), sheet, program))
    file = BytesIO()
    ExcelWriter(book, PinnedZip(file, rows)).save()
    return file.getvalue()


def _write(target: Worksheet, sheet: Sheet, program: str) -> str:
    """Set up a sheet and return the XML of its rows."""
    for index, column in enumerate(sheet.columns, 1):
        target.column_dimensions[get_column_letter(index)].width = column.width
    target.freeze_panes = "A2"
    set_up(target, sheet.about, clean(program))
    pen = _Pen(target, sheet.columns)
    pen.write_titles()
    rows = iter(sheet.rows)
    for row in islice(rows, ROWS_MAX - 2):
        pen.write(row)
    if next(rows, None) is not None:
        pen.write((Marked("There are more rows than a sheet can hold.", Look.TITLE),))
    if sheet.has_filter:
        target.auto_filter.ref = f"A1:{get_column_letter(len(sheet.columns))}{len(pen.rows)}"
    return "".join(pen.rows)


class _Pen:
    """Writes the rows of one sheet."""

    def __init__(self, sheet: Worksheet, columns: tuple[Column, ...]) -> None:
        self._sheet = sheet
        self._columns = tuple((get_column_letter(index), column) for index, column in enumerate(columns, 1))
        self._styles: dict[Style, int] = {}
        self.rows: list[str] = []

    def write_titles(self) -> None:
        self._append(
            self._entry(Marked(column.title, Look.TITLE), letters, column._replace(wraps=True))
            for letters, column in self._columns
        )

    def write(self, values: Cells) -> None:
        self._append(
            self._entry(value, letters, column) for value, (letters, column) in zip(values, self._columns, strict=False)
        )

    def _append(self, entries: Iterator[Entry | None]) -> None:
        self.rows.append(row_markup(len(self.rows) + 1, (entry for entry in entries if entry is not None)))

    def _entry(self, value: Value, letters: str, column: Column) -> Entry | None:
        look = Look.PLAIN
        if isinstance(value, Marked):
            value, look = value
        if value is None or value == "":
            is_seen = look not in (Look.PLAIN, Look.FAINT)
            return Entry(letters, self._style(Style(look, column, False)), None) if is_seen else None
        if not isinstance(value, str):
            return Entry(letters, self._style(Style(look, column, False)), value)
        text = clean(value)
        return Entry(letters, self._style(Style(look, column, True, len(text) > TEXT_FORMAT_MAX)), text)

    def _style(self, style: Style) -> int:
        if style not in self._styles:
            self._styles[style] = styled_cell(self._sheet, style).style_id
        return self._styles[style]


_FORBIDDEN = re.compile(r"[\x00-\x08\x0b-\x1f\x7f\ud800-\udfff\ufffe\uffff]")


def clean(text: str) -> str:
    """Return a text that a workbook can hold: a sign replaces what XML forbids, and a text that is too long is cut."""
    text = _FORBIDDEN.sub(_sign, text)
    return text if len(text) <= TEXT_MAX else text[: TEXT_MAX - len(_CUT)] + _CUT


def _sign(match: re.Match[str]) -> str:
    """The picture of a control character (U+2400 and on); else the sign for what cannot be shown."""
    code = ord(match[0])
    if code == 0x7F:
        return "\u2421"
    return chr(0x2400 + code) if code < 0x20 else "\ufffd"
