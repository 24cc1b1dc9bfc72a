"""Reads a ladder CSV as rungs: rows of squares, the boxes of the output column with their pins, comments.

It reads everything as laddercodec does, a wire through blank squares included (click-facts [grid.blank-wires]).
Damage becomes a problem of its rung, or of the file if it belongs to none.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from clickgen.click.draw.grid import COLUMNS, MAX_ROWS
from clickgen.click.ladder_csv import HEADER
from clickgen.click.read.operands import condition_of, missing_address
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.tokens import PIN, height_of, is_own_input_below, pin_row_of
from clickgen.ir.conditions import Compare, Contact
from clickgen.text.source import Span

_MARKER = re.compile(r"R[0-9]*")
_WIRES = {"": (False, False), "-": (True, False), "T": (True, True), "|": (False, True)}
"""The squares without a contact: whether power goes right, and whether it goes down at the left edge."""


@dataclass(frozen=True, slots=True)
class Square:
    """One cell of the grid: whether it carries power right, through which contact, and down at its left edge."""

    right: bool = False
    down: bool = False
    contact: Contact | Compare | None = None


@dataclass(frozen=True, slots=True)
class DrawnRow:
    """One row as the file has it; ``line`` is its line there, 0 in a binary file."""

    squares: tuple[Square, ...]
    output: str
    line: int


@dataclass(frozen=True, slots=True)
class DrawnBox:
    """An instruction of the output column, its row, and its pins with theirs."""

    token: str
    row: int
    pins: tuple[tuple[str, int], ...] = ()


class AsWritten(NamedTuple):
    """The text of each row of a rung, with the rows and boxes that the reader made of it."""

    text: tuple[tuple[str, ...], ...]
    rows: tuple[DrawnRow, ...]
    boxes: tuple[DrawnBox, ...]


@dataclass(frozen=True)
class DrawnRung:
    """One rung. ``number`` counts from 1 in its routine; ``line`` is 0 in a binary file.

    For a rung with problems, ``rows`` and ``boxes`` have what could be read.
    """

    number: int
    file: str
    line: int
    comment: str
    rows: tuple[DrawnRow, ...]
    boxes: tuple[DrawnBox, ...]
    problems: tuple[LadderProblem, ...] = ()
    notes: tuple[str, ...] = ()
    """Notes for a person on how the rung was read."""
    written: AsWritten | None = field(default=None, compare=False, repr=False)
    """The text in the file, if the rung was read from text and has no problems."""

    @property
    def span(self) -> Span:
        """The place of the rung. In a binary file its number replaces the line: no two rungs have one place."""
        line = self.line or self.number
        return Span(self.file, line, 1, line, 2)

    def is_drawn_as(self, other: DrawnRung) -> bool:
        """True if both were read from the same text, so that they are drawn alike; False proves nothing."""
        return self is other or (self.text is not None and self.text == other.text)

    @property
    def text(self) -> tuple[tuple[str, ...], ...] | None:
        """The text of each row; None if it is not known, as after a change of the rung."""
        written = self.written
        if written is None or self.problems or written.rows is not self.rows or written.boxes is not self.boxes:
            return None
        return written.text

    def numbered(self, number: int) -> DrawnRung:
        """Return the same rung at another place of its routine."""
        if number == self.number:
            return self
        problems = tuple(problem.in_rung(number) for problem in self.problems)
        return replace(self, number=number, problems=problems)


@dataclass(frozen=True)
class Ladder:
    """The contents of a file; ``problems`` has those that belong to no rung."""

    rungs: tuple[DrawnRung, ...]
    problems: tuple[LadderProblem, ...]

    @property
    def all_problems(self) -> tuple[LadderProblem, ...]:
        found = [*self.problems, *(problem for rung in self.rungs for problem in rung.problems)]
        return tuple(sorted(found, key=lambda problem: (problem.row, problem.rung)))


_PLAIN = {text: Square(*wires) for text, wires in _WIRES.items() if not wires[1]}


def decode_ladder(data: bytes, file: str) -> str:
    """Return the text of a ladder file (UTF-8, with or without a byte order mark). Raises LadderProblem."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        row = data.count(b"\n", 0, error.start) + 1
        raise LadderProblem(f"the file is not UTF-8 text: byte 0x{data[error.start]:02X}", file, row) from None


def read_ladder(text: str, file: str) -> Ladder:
    """Return the rungs of a ladder CSV. Never raises."""
    reader = _Reader(file)
    for row, fields in reader.records(text):
        reader.record(row, fields)
    reader.close()
    if reader.comment:
        reader.problems.append(LadderProblem("a comment at the end belongs to no rung", file, reader.comment_row))
    return Ladder(tuple(reader.rungs), tuple(reader.problems))


@dataclass
class _Reader:
    """The file so far, and the rung that is being read."""

    file: str
    rungs: list[DrawnRung] = field(default_factory=list)
    problems: list[LadderProblem] = field(default_factory=list)
    comment: list[str] = field(default_factory=list)
    comment_row: int = 0
    rung_row: int = 0
    """The line of the open rung; 0 if none is open."""
    rows: list[DrawnRow] = field(default_factory=list)
    cells: list[tuple[str, ...]] = field(default_factory=list)
    faults: list[LadderProblem] = field(default_factory=list)

    def records(self, text: str) -> Iterator[tuple[int, list[str]]]:
        """Yield the lines below the header that are not empty, each with the number of its first one."""
        reader = csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline=""), strict=True)
        is_open, row = False, 1
        try:
            for fields in reader:
                if fields and is_open:
                    yield row, fields
                elif fields:
                    is_open = tuple(name.strip() for name in fields) == HEADER
                    if not is_open:
                        message = f"the header of a ladder file is {HEADER[0]},{HEADER[1]},...,{HEADER[-1]}"
                        self.problems.append(LadderProblem(message, self.file, row))
                        return
                row = reader.line_num + 1
        except csv.Error as error:
            message = f"the quotes of this line do not fit, or the file is cut off here ({error})"
            self.problems.append(LadderProblem(message, self.file, row))
            return
        if not is_open:
            self.problems.append(LadderProblem("the file is empty", self.file, 1))

    def record(self, row: int, fields: list[str]) -> None:
        marker = fields[0].strip()
        if marker == "#":
            self.close()
            self.comment_row = self.comment_row if self.comment else row
            self.comment += _lines(fields[1] if len(fields) > 1 else "")
            if any(cell.strip() for cell in fields[2:]):
                self.problems.append(LadderProblem("a comment has text outside column A", self.file, row))
            return
        if _MARKER.fullmatch(marker):
            self.close()
            self.rung_row = row
        elif not self.rung_row:
            self.problems.append(LadderProblem("this line belongs to no rung: no R above it", self.file, row))
            return
        elif marker:
            self._fault(f"the line begins with {marker!r}, not with R, # or nothing", row)
        if len(fields) != len(HEADER):
            why = ": is it cut off?" if len(fields) < len(HEADER) else ""
            self._fault(f"the line has {len(fields)} columns, not {len(HEADER)}{why}", row)
            return
        text = "".join(fields)
        if "\n" in text or "\r" in text:
            self._fault("a cell holds a line break: is a quote missing?", row)
            return
        plain = _PLAIN.get  # Most squares are blank or a wire.
        squares = tuple(
            [plain(cell) or self._square(cell.strip(), column, row) for column, cell in enumerate(fields[1:-1])]
        )
        self.rows.append(DrawnRow(squares, fields[-1].strip(), row))
        self.cells.append(tuple(fields[1:]))

    def _square(self, text: str, column: int, row: int) -> Square:
        wires = _WIRES.get(text)
        if wires is not None:
            if wires[1] and column == 0:
                self._fault(f"{text} in column A: there the power rail joins the rows", row)
            return Square(*wires)
        is_down = text[:2] in ("T:", "|:")
        contact = condition_of(text[2:] if is_down else text, Span(self.file, row, 1, row, 2))
        if contact is None:
            missing = missing_address(text)
            why = f"and CLICK has no {missing}" if missing else "which is no contact and no wire"
            self._fault(f"column {HEADER[column + 1]} holds {text!r}, {why}", row)
        return Square(True, is_down and column > 0, contact)

    def _fault(self, message: str, row: int) -> None:
        self.faults.append(LadderProblem(message, self.file, row))

    def close(self) -> None:
        """Complete the open rung."""
        if not self.rung_row:
            return
        boxes = self._boxes()
        height, free = _height(self.rows)
        last = self.rows[-1] if self.rows and not free else None
        if last and any(square.down and square.contact is None for square in last.squares):
            self._fault("a wire leads down from the last row of the rung", last.line)
        if height > MAX_ROWS:
            self._fault(f"the rung has {height} rows with its boxes at their full height, and CLICK {MAX_ROWS}", 0)
        number = len(self.rungs) + 1
        rows = _joined(self.rows)
        problems = tuple(LadderProblem(p.message, p.file, p.row or self.rung_row, number) for p in self.faults)
        rung = DrawnRung(
            number,
            self.file,
            self.rung_row,
            "\n".join(self.comment),
            rows,
            boxes,
            problems,
            written=None if problems else AsWritten(tuple(self.cells), rows, boxes),
        )
        self.rungs.append(rung)
        self.comment, self.rows, self.cells, self.faults, self.rung_row = [], [], [], [], 0

    def _boxes(self) -> tuple[DrawnBox, ...]:
        """The instructions of the open rung, with each pin at the one directly above it."""
        boxes: list[DrawnBox] = []
        is_near = False
        for index, row in enumerate(self.rows):
            token = row.output
            if not token:
                is_below = bool(boxes) and is_own_input_below(boxes[-1].token)
                is_near = is_near and not is_below and not any(square.right for square in row.squares)
            elif not token.startswith("."):
                boxes.append(DrawnBox(token, index))
                is_near = True
            elif not PIN.fullmatch(token):
                self._fault(f"{token!r} is no pin", row.line)
            elif not is_near:
                self._fault(f"{token} is not directly below its instruction", row.line)
            else:
                box = boxes[-1]
                if pin_row_of(box.token, token) <= max([0, *(pin_row_of(box.token, pin) for pin, _ in box.pins)]):
                    self._fault(f"{box.token.partition('(')[0]} has no {token} here", row.line)
                boxes[-1] = replace(box, pins=(*box.pins, (token, index)))
        return tuple(boxes)


def _lines(text: str) -> list[str]:
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _joined(rows: Sequence[DrawnRow]) -> tuple[DrawnRow, ...]:
    """Return the rows with each downward wire continued through blank squares, up to a row that meets it from the left.

    laddercodec reads a file the same way; the last row is left alone.
    """
    joined = list(rows)
    for index in range(len(joined) - 2):
        above, below = joined[index].squares, list(joined[index + 1].squares)
        for column in range(1, COLUMNS):
            is_blank = not below[column].right and not below[column].down
            if above[column].down and is_blank and not below[column - 1].right:
                below[column] = Square(down=True)
        joined[index + 1] = replace(joined[index + 1], squares=tuple(below))
    return tuple(joined)


def _height(rows: Sequence[DrawnRow]) -> tuple[int, int]:
    """Return the rows of a rung with every box at full height, and how many of them follow the last one written."""
    total = free = 0
    is_loose = False
    for row in rows:
        if row.output and not row.output.startswith("."):
            own = 1 if is_own_input_below(row.output) else 0
            total += free + (own if own and not is_loose else 0)
            free = height_of(row.output) - 1 - own
        elif free:
            free -= 1
        is_loose = not row.output
        total += 1
    return total + free, free
