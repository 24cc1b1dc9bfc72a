"""The rows of a sheet are, to the byte, those that openpyxl writes."""

from __future__ import annotations

import io
import zipfile

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from openpyxl.cell import WriteOnlyCell
from openpyxl.cell.rich_text import CellRichText

from clickgen.emit.workbook.book import clean
from clickgen.emit.workbook.markup import Entry, pieces_of, row_markup

Value = str | int | float | None


def by_openpyxl(value: Value) -> str:
    """What openpyxl writes for a row with this value in its first cell, in a cell with a style."""
    book = openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet()
    cell = WriteOnlyCell(sheet)
    cell.number_format = "@"
    if isinstance(value, str):
        pieces = pieces_of(value)
        cell.value = CellRichText(*pieces) if len(pieces) > 1 else value
        cell.data_type = "s"
    else:
        cell.value = value
    assert cell.style_id == 1
    sheet.append([cell])
    file = io.BytesIO()
    book.save(file)
    with zipfile.ZipFile(file) as archive:
        text = archive.read("xl/worksheets/sheet1.xml").decode()
    return text.partition("<sheetData>")[2].partition("</sheetData>")[0]


TEXTS = ["=1+1", "_x0041_", "a_x0041__x0042_", " a ", "  ", "a\nb", "\n", "<&>\"'", "\u00a0a", "\u20ac\U0001f600"]


@pytest.mark.parametrize("value", [*TEXTS, None, 0, -5, 2**40, 0.1, -0.0, 1e300, 1e-7])
def test_a_row_is_what_openpyxl_writes(value: Value) -> None:
    assert row_markup(1, [Entry("A", 1, value)]) == by_openpyxl(value)


@given(st.one_of(st.text(min_size=1, max_size=12).map(clean), st.integers(-(2**63), 2**63), st.floats(-1e300, 1e300)))
def test_any_row_is_what_openpyxl_writes(value: Value) -> None:
    assert row_markup(1, [Entry("A", 1, value)]) == by_openpyxl(value)
