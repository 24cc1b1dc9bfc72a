"""Writes sheets into the bytes of a workbook, every text as text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from io import BytesIO
from itertools import islice
from typing import cast

from openpyxl import Workbook
from openpyxl.cell import Cell
from openpyxl.cell.rich_text import CellRichText
from openpyxl.utils import get_column_letter
from openpyxl.workbook.properties import CalcProperties
from openpyxl.worksheet.worksheet import Worksheet
from openpyxl.writer.excel import ExcelWriter

from clickgen.emit.workbook.archive import PinnedZip
from clickgen.emit.workbook.looks import TEXT_FORMAT_MAX, Style, set_up, styled_cell
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet, Value

ROWS_MAX = 1_048_576
TEXT_MAX = 32_767
"""Excel's limits for a sheet and for a cell."""
_CUT = " [cut]"


def to_bytes(sheets: Iterable[Sheet], program: str) -> bytes:
    """Return the workbook; ``program`` is named at the foot of each page."""
    book = Workbook(write_only=True)
    book.calculation = CalcProperties(fullCalcOnLoad=False)
    for sheet in sheets:
        # A sheet written row by row has everything that is used here of one in memory; its types say less.
        _write(cast(Worksheet, book.create_sheet(sheet.name)), sheet, program)
    file = BytesIO()
    ExcelWriter(book, PinnedZip(file)).save()
    return file.getvalue()


def _write(target: Worksheet, sheet: Sheet, program: str) -> None:
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
        target.auto_filter.ref = f"A1:{get_column_letter(len(sheet.columns))}{pen.rows}"


class _Pen:
    """Writes the rows of one sheet. It reuses one cell for each style, since each is written at once."""

    def __init__(self, sheet: Worksheet, columns: tuple[Column, ...]) -> None:
        self._sheet = sheet
        self._columns = columns
        self._cells: dict[Style, Cell] = {}
        self.rows = 0

    def write_titles(self) -> None:
        self._append(
            self._cell(Marked(column.title, Look.TITLE), column._replace(wraps=True)) for column in self._columns
        )

    def write(self, values: Cells) -> None:
        self._append(self._cell(value, column) for value, column in zip(values, self._columns, strict=False))

    def _append(self, row: Iterator[Cell | None]) -> None:
        self._sheet.append(cast(list[Cell], row))  # It takes generators too.
        self.rows += 1

    def _cell(self, value: Value, column: Column) -> Cell | None:
        look = Look.PLAIN
        if isinstance(value, Marked):
            value, look = value
        if value in (None, ""):
            return None if look in (Look.PLAIN, Look.FAINT) else self._blank(Style(look, column, False))
        if not isinstance(value, str):
            cell = self._blank(Style(look, column, False))
            cell.value = value
            return cell
        text = clean(value)
        cell = self._blank(Style(look, column, True, len(text) > TEXT_FORMAT_MAX))
        cell.value = as_written(text)
        cell.data_type = "s"
        return cell

    def _blank(self, style: Style) -> Cell:
        if style not in self._cells:
            self._cells[style] = styled_cell(self._sheet, style)
        cell = self._cells[style]
        cell.value = None
        return cell


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


_ESCAPE = re.compile(r"_x(?=[0-9A-Fa-f]{4}_)")


def as_written(text: str) -> str | CellRichText:
    """Divide ``_x0041_``, which Excel would take for the code of a character: it reads each piece as it is."""
    if not _ESCAPE.search(text):
        return text
    pieces = _ESCAPE.sub("_x\0", text).split("\0")
    return CellRichText(*pieces)
