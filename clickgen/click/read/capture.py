"""A capture of the clipboard, cut into its cells byte by byte, and each rung compared with what laddercodec writes.

The form is that of laddercodec 0.2.2 (click-facts [click-file.captures]): a head, then rows of 32 cells. Each rung
begins with a row of its own, whose first cell holds the comment. Every cell gives its row and column, and its
end says where the next one belongs, so a cut is right or fails.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from clickgen.click.ladder_csv import HEADER
from clickgen.click.read.blobs import Blob, BlobFault, read_blob
from clickgen.click.read.fields import first_difference
from clickgen.click.read.harmless import DRAWN_TALLER, WIRED_LATER

_ROWS_AT, _ROWS_UNIT = 0x0254, 32
_FIRST_AT = 0x0260
"""Where the first rung's row begins, after the state of CLICK's window and the number of rows."""
_COLUMNS = 32
_OUTPUT = _COLUMNS - 1
_HEADER = struct.Struct("<BIIBBBBiIIIII")
_PLAIN_BODY = bytes(11)
_COMMENT_ROW = 1
_HEIGHT_MAX = 8


class CaptureFault(Exception):
    """Bytes that are not a capture, from the current rung on."""


class _Header(NamedTuple):
    """The head of a cell. ``unused`` is two bytes in which CLICK leaves old contents."""

    pad: int
    column: int
    row: int
    span: int
    height: int
    unused: int
    unused_too: int
    order: int
    one: int
    start: int
    segment: int
    right: int
    down: int


@dataclass(frozen=True)
class Cell:
    """One cell of a row: its wires, and the instruction in it."""

    header: _Header
    blob: Blob | None


@dataclass
class CutRung:
    """The cells of one rung, row by row, and its comment as RTF."""

    comment: bytes
    rows: list[list[Cell]] = field(default_factory=list)


@dataclass
class Cut:
    """The rungs of a capture; with a fault those before it."""

    rungs: list[CutRung] = field(default_factory=list)
    fault: str = ""


def cut(data: bytes) -> Cut:
    """Cut a capture into its cells. Never raises."""
    found = Cut()
    cutter = _Cutter(data, found.rungs)
    try:
        cutter.cut()
    except (CaptureFault, BlobFault) as fault:
        found.fault = str(fault)
    except (struct.error, IndexError):
        found.fault = "the last cell is cut off"
    if found.fault and found.rungs:
        del found.rungs[-1]
    return found


class _Cutter:
    def __init__(self, data: bytes, rungs: list[CutRung]) -> None:
        self.data = data
        self.at = _FIRST_AT
        self.rungs = rungs

    def cut(self) -> None:
        [word] = struct.unpack_from("<H", self.data, _ROWS_AT)
        rows = word // _ROWS_UNIT
        for number in range(rows):
            is_last = number == rows - 1
            if number == 0 or self._begins_a_rung():
                self._comment_row(number, is_last)
            else:
                row = len(self.rungs[-1].rows) + 1
                cells = [self._cell(number, column, row, is_last)[0] for column in range(_COLUMNS)]
                self.rungs[-1].rows.append(cells)
        if not all(rung.rows for rung in self.rungs):
            raise CaptureFault("a rung has no rows")
        if self.data[self.at : self.at + 9] in (struct.pack("<BII", 0, 0, number) for number in (rows, rows & 0xFF)):
            raise CaptureFault("there are more rows than the file says")

    def _begins_a_rung(self) -> bool:
        cell = self.data[self.at : self.at + 0x34]
        return len(cell) == 0x34 and cell[0x25] == 0 and cell[0x30] != 0

    def _comment_row(self, number: int, is_last: bool) -> None:
        self.rungs.append(CutRung(b""))
        for column in range(_COLUMNS):
            cell, comment = self._cell(number, column, 0, is_last)
            self.rungs[-1].comment += comment
            header = cell.header
            if cell.blob or header[3:5] != (1, 1) or header.order != -1 or any(header[9:]):
                raise CaptureFault(f"the row of the comment holds something in column {column + 1}")

    def _cell(self, number: int, column: int, row: int, is_last: bool) -> tuple[Cell, bytes]:
        """Return the next cell, and the comment in it. ``number`` counts all rows, ``row`` those of the rung from 1."""
        header = _Header(*_HEADER.unpack_from(self.data, self.at))
        # laddercodec writes one byte of the numbers of a comment's row and of a rung.
        numbers = (number, number & 0xFF) if row == 0 else (number,)
        if (header.pad, header.column, header.one) != (0, column, 1) or header.row not in numbers:
            raise CaptureFault(f"row {row} has no column {column + 1}")
        self.at += _HEADER.size
        blob = None
        if self.data[self.at]:
            blob, self.at = read_blob(self.data, self.at)
        elif self.data[self.at : self.at + len(_PLAIN_BODY)] == _PLAIN_BODY:
            self.at += len(_PLAIN_BODY)
        else:
            raise CaptureFault(f"the wire in row {row}, column {column + 1} holds something")
        kind, length = struct.unpack_from("<II", self.data, self.at)
        if kind != (_COMMENT_ROW if row == 0 else 0) or (length and (column or row)):
            raise CaptureFault(f"row {row}, column {column + 1} is of another kind")
        comment = self.data[self.at + 8 : self.at + 8 + length]
        self.at += 8 + length
        rung = len(self.rungs) - 1
        if is_last and column == _OUTPUT:
            self.at += 8  # the number of nicknames that follow, and old contents
        elif column < _OUTPUT:
            self._goes_on_in((rung, row))
        else:
            self._goes_on_in((rung, row + 1), *([(rung + 1, 0)] if row else []))
        return Cell(header, blob), comment

    def _goes_on_in(self, *places: tuple[int, int]) -> None:
        """Check that the end of a cell gives the rung and row of the next one."""
        one, rung, row = struct.unpack_from("<BII", self.data, self.at)
        self.at += 8
        # The last byte of the row is the first of the next cell.
        is_next = any(rung in (other, other & 0xFF) and row & 0xFFFFFF == at for other, at in places)
        if one != 1 or not is_next:
            raise CaptureFault("a cell does not go on with the next one")


# -- comparing --------------------------------------------------------------------------------------------------------


def differences(rung: CutRung, made: CutRung) -> Iterator[str]:
    """Yield the differences between the bytes of a rung and laddercodec's bytes for what was read."""
    if len(rung.rows) != len(made.rows):
        yield f"it has {len(rung.rows)} rows, and {len(made.rows)} are read"
        return
    for number, (cells, others) in enumerate(zip(rung.rows, made.rows, strict=True)):
        covered = _covered_by(made.rows, number)
        for column, (cell, other) in enumerate(zip(cells, others, strict=True)):
            what = _difference(cell, other, column, covered)
            if what:
                yield f"row {number + 1}, column {HEADER[column + 1]}: {what}"
    orders = sorted(cell.header.order for cells in rung.rows for cell in cells if cell.blob)
    if orders != list(range(len(orders))):
        yield "its instructions are not numbered through"


def _covered_by(rows: Sequence[Sequence[Cell]], number: int) -> bool:
    """True in the lower rows of a tall box, where CLICK may keep the wire of a NOP (laddercodec, decode.py)."""
    return any(
        above[_OUTPUT].blob is not None and distance < above[_OUTPUT].header.span
        for distance, above in enumerate(reversed(rows[:number]), 1)
    )


def _difference(cell: Cell, made: Cell, column: int, is_covered: bool) -> str:
    """The difference between two cells; "" if there is none, or only one that does not count.

    ``segment``, and ``start`` in the first column, give the order in which somebody drew the rung (laddercodec,
    encode.py); ``height`` is how tall CLICK draws a box.
    """
    if (cell.blob is None) != (made.blob is None):
        return "an instruction is on one side only"
    header, other = cell.header, made.header
    name = cell.blob.head.name if cell.blob else ""
    if cell.blob is not None and made.blob is not None:
        what = first_difference(cell.blob, made.blob)
        if what:
            return what
    elif header.order != -1:
        return "a wire is numbered as an instruction"
    if header.span != other.span and not (name in DRAWN_TALLER and (header.span, other.span) == (3, 1)):
        return f"{name or 'a wire'} spans {header.span} rows, and {other.span} are read"
    if header.height != other.height and not (name and 0 < header.height <= _HEIGHT_MAX):
        return f"{name or 'a wire'} is {header.height} rows tall"
    if header.segment > 1 or header.start > (column == 0):
        return "its wires are marked in a way that is not known"
    is_free = column == _OUTPUT and header.right in (0, 1) and (name in WIRED_LATER or (is_covered and not name))
    if header.down != other.down or (header.right != other.right and not is_free):
        return f"its wires are ({header.right}, {header.down}), and ({other.right}, {other.down}) are read"
    return ""
