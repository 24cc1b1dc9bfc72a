"""The rows of a sheet as XML, to the byte as openpyxl would write them: it makes several objects for each cell."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from openpyxl.compat import safe_string


class Entry(NamedTuple):
    """A cell: the letters of its column, the number of its style in the workbook, and its value."""

    letters: str
    style: int
    value: str | int | float | None


def row_markup(number: int, entries: Iterable[Entry]) -> str:
    """Return the XML of a row."""
    return f'<row r="{number}">{"".join([_cell(number, entry) for entry in entries])}</row>'


def _cell(number: int, entry: Entry) -> str:
    letters, style, value = entry
    place = f'<c r="{letters}{number}" s="{style}"'
    if value is None:
        return f'{place} t="n" />'
    if not isinstance(value, str):
        return f'{place} t="n"><v>{safe_string(value)}</v></c>'
    pieces = pieces_of(value)
    texts = [_text(piece) for piece in pieces]
    inner = texts[0] if len(pieces) == 1 else "".join(f"<r>{text}</r>" for text in texts)
    return f'{place} t="inlineStr"><is>{inner}</is></c>'


def _text(text: str) -> str:
    stripped = text.strip()
    # A text of nothing but spaces is written as openpyxl writes it.
    space = ' xml:space="preserve"' if stripped and stripped != text else ""
    if "&" in text or "<" in text or ">" in text:
        text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return f"<t{space}>{text}</t>"


_ESCAPE = re.compile(r"_x(?=[0-9A-Fa-f]{4}_)")


def pieces_of(text: str) -> list[str]:
    """Divide ``_x0041_``, which Excel would take for the code of a character: it reads each piece as it is."""
    return _ESCAPE.sub("_x\0", text).split("\0") if "_x" in text else [text]
