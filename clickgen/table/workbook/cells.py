"""The cells of a workbook, sheet by sheet and row by row, through openpyxl."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

from clickgen.table.read import TableUnreadable
from clickgen.table.workbook.archive import broken, harmless_copy
from clickgen.text.source import Span

SHEETS_MAX = 100
ROWS = 1_048_576
"""The rows that a sheet can have."""
COLUMNS_MAX = 256
"""The columns in which a list is looked for: A to IV."""

Value = str | int | float | bool


class Cell(NamedTuple):
    """A cell that holds something. ``fault`` names its content if that is not a plain value: ``a formula``."""

    column: int
    value: Value
    fault: str = ""

    @property
    def text(self) -> str:
        """The text of the cell, trimmed; "" if it holds something else."""
        return self.value.strip() if isinstance(self.value, str) and not self.fault else ""

    @property
    def shown(self) -> str:
        """The value as text, whatever it is; a number in its shortest form."""
        if isinstance(self.value, bool):
            return str(self.value).upper()
        if isinstance(self.value, float) and self.value.is_integer() and abs(self.value) < 1e15:
            return str(int(self.value))
        return str(self.value)


class Line(NamedTuple):
    """A row of a sheet that holds something, with its cells by column."""

    number: int
    cells: dict[int, Cell]


@dataclass(frozen=True)
class Sheet:
    """A sheet; its cells are read when ``lines`` is iterated."""

    shown: str
    title: str
    is_hidden: bool
    _content: Any
    """The worksheet of openpyxl."""

    def span(self, line: Line, column: int) -> Span:
        return Span.of_cell(self.shown, self.title, line.number, column)

    def lines(self) -> Iterator[Line]:
        """Yield the rows that hold something, from the top. Raises TableUnreadable if the sheet is broken."""
        self._content.reset_dimensions()  # The file's own figures need not be true.
        from openpyxl.cell.read_only import EMPTY_CELL

        blank = None
        try:
            for number, row in enumerate(self._content.iter_rows(max_row=ROWS, max_col=COLUMNS_MAX), 1):
                # One and the same row represents all those that the file leaves out, perhaps a million.
                if row is blank:
                    continue
                there = [(n, cell) for n, cell in enumerate(row, 1) if cell is not EMPTY_CELL]
                cells = {n: _cell(n, cell) for n, cell in there if cell.value not in (None, "")}
                if cells:
                    yield Line(number, cells)
                else:
                    blank = row
        except Exception as error:
            # openpyxl raises whatever a broken part happens to lead it to.
            raise broken(self.shown, error) from None


def sheets_of(data: bytes, shown: str) -> list[Sheet]:
    """Return every sheet of a workbook that has cells, hidden ones too, in the order of their tabs.

    Raises TableUnreadable if the bytes are not a sound workbook.
    """
    import openpyxl

    copy = harmless_copy(data, shown)
    try:
        workbook = openpyxl.load_workbook(copy, read_only=True, keep_links=False)
        sheets = [
            Sheet(shown, str(sheet.title), sheet.sheet_state != "visible", sheet) for sheet in workbook.worksheets
        ]
    except Exception as error:
        raise broken(shown, error) from None
    if len(sheets) > SHEETS_MAX:
        raise TableUnreadable(
            f"{shown} has {len(sheets)} sheets where {SHEETS_MAX} are read; copy the lists alone into a new workbook"
        )
    return sheets


_NO_VALUES = {"f": "a formula", "d": "a date"}
_NA = re.compile(r"=\s*NA\s*\(\s*\)", re.IGNORECASE)
"""Excel's own function for it, instead of ``#N/A``."""


def _cell(column: int, cell: Any) -> Cell:
    value, kind = cell.value, cell.data_type
    if kind == "e" or (kind == "f" and _NA.fullmatch(str(value))):
        return Cell(column, str(value), f"an error, {value if kind == 'e' else '#N/A'}")
    if kind in _NO_VALUES:
        return Cell(column, str(value), _NO_VALUES[kind])
    if isinstance(value, float) and not math.isfinite(value):
        return Cell(column, str(value), "no number")
    if not isinstance(value, Value):
        return Cell(column, str(value), "no plain value")
    return Cell(column, value)
