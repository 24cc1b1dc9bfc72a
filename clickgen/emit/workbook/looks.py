"""The look of everything, on the screen and on paper."""

from __future__ import annotations

from typing import NamedTuple

from openpyxl.cell import Cell, WriteOnlyCell
from openpyxl.styles import Alignment, Border, Font, PatternFill, Side
from openpyxl.worksheet.properties import PageSetupProperties
from openpyxl.worksheet.worksheet import Worksheet

from clickgen.emit.workbook.sheet import Column, Look

_FONT = "Calibri"
_LINE = Side(style="thin", color="A6A6A6")

_FILLS = {
    Look.TITLE: "DDEBF7",
    Look.USED: "C6E0B4",
    Look.NAMED: "FFF2CC",
    Look.BLOCK: "D9D2E9",
    Look.SCRATCH: "F8CBAD",
    Look.RESERVED: "D9D9D9",
}
_FONTS = {
    Look.TITLE: Font(name=_FONT, size=11, bold=True),
    Look.FAINT: Font(name=_FONT, size=10, italic=True, color="7F7F7F"),
    Look.LADDER: Font(name="Consolas", size=9),
}
_BODY = Font(name=_FONT, size=10)

TEXT_FORMAT_MAX = 255
"""Some versions of Excel show ##### for a longer text in a cell of the format Text."""


class Style(NamedTuple):
    """Everything that decides how a cell is written."""

    look: Look
    column: Column
    is_text: bool
    is_long: bool = False


def styled_cell(sheet: Worksheet, style: Style) -> Cell:
    """An empty cell of a style. A text stays one when somebody edits it: by its format, or by its quote prefix."""
    cell = WriteOnlyCell(sheet)
    cell.font = _FONTS.get(style.look, _BODY)
    fill = _FILLS.get(style.look)
    if fill:
        cell.fill = PatternFill("solid", fgColor=fill)
    if style.look is Look.TITLE:
        cell.border = Border(bottom=_LINE)
    across = "center" if style.column.is_centered else None
    cell.alignment = Alignment(vertical="top", wrap_text=style.column.wraps, horizontal=across)
    if style.is_long:
        cell.quotePrefix = True
    elif style.is_text:
        cell.number_format = "@"
    return cell


def set_up(sheet: Worksheet, about: str, program: str) -> None:
    """Set up printing: landscape, as wide as the page, titles on each, the sheet's name above and the page below."""
    setup, header, footer = sheet.page_setup, sheet.oddHeader, sheet.oddFooter
    assert header is not None
    assert footer is not None
    setup.orientation = "landscape"
    setup.fitToWidth, setup.fitToHeight = 1, 0
    sheet.sheet_properties.pageSetUpPr = PageSetupProperties(fitToPage=True)
    sheet.print_title_rows = "1:1"
    sheet.print_options.gridLines = True
    margins = sheet.page_margins
    margins.left = margins.right = 0.4
    margins.top, margins.bottom = 0.75, 0.6
    header.left.text = f"{sheet.title}: {about}"
    footer.left.text = _printed(program)
    footer.right.text = "Page &P of &N"


_PRINTED_MAX = 100
"""All parts of a footer together may have 255 characters."""


def _printed(text: str) -> str:
    """Escape a text for a footer: there an ampersand begins a code, and digits after a code are a font size."""
    return " " + text[:_PRINTED_MAX].replace("&", "&&")
