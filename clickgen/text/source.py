"""Where text comes from: source files, spans, and positions inside embedded strings."""

from __future__ import annotations

import re
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

FORM_FEED = re.compile(r"(?m)^[ \t]*\f")
"""Blanks at the beginning of a line that Python does not count."""


class Span(NamedTuple):
    """A stretch of one source file. Lines and columns count from 1, in characters; the end is exclusive.

    In a workbook it is a cell: ``sheet`` is the name of its sheet, line and column are those of the cell.
    """

    path: str
    line: int
    col: int
    end_line: int
    end_col: int
    sheet: str = ""

    @staticmethod
    def of_cell(path: str, sheet: str, row: int, column: int) -> Span:
        """A cell of a workbook; row and column count from 1."""
        return Span(path, row, column, row, column + 1, sheet)

    @property
    def cell(self) -> str:
        """``IO!B7`` in a workbook; else ""."""
        return f"{self.sheet}!{_letters(self.col)}{self.line}" if self.sheet else ""

    def __str__(self) -> str:
        return f"{self.path}:{self.cell or f'{self.line}:{self.col}'}"

    def seen_from(self, other: Span) -> str:
        """``line 5``, with its file if that is another one; ``IO!B7`` in a workbook."""
        if self.path != other.path:
            return str(self)
        return self.cell or f"line {self.line}"


def _letters(column: int) -> str:
    """The name of a column in a spreadsheet: 1 is A, 27 is AA."""
    letters = ""
    while column:
        column, rest = divmod(column - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return letters


class SourceFile:
    """One file of a program: the path as the user named it, and its text with ``\\n`` line ends."""

    def __init__(self, path: str, text: str) -> None:
        self.path = path
        self.text = text

    @cached_property
    def lines(self) -> list[str]:
        # Only \n ends a line for Python's parser; form feeds and Unicode separators do not.
        return self.text.split("\n")

    @cached_property
    def starts(self) -> list[int]:
        """The offset in the text at which each line begins, counted from 0."""
        return [0, *accumulate(len(line) + 1 for line in self.lines)]

    @cached_property
    def is_ascii(self) -> bool:
        return self.text.isascii()

    def line(self, number: int) -> str:
        """The text of a line, counted from 1; "" if there is no such line."""
        return self.lines[number - 1] if 0 < number <= len(self.lines) else ""

    def column(self, line: int, byte_offset: int) -> int:
        """The column (from 1, in characters) of a UTF-8 byte offset, as ``ast`` counts."""
        if self.is_ascii:
            return byte_offset + 1
        return len(self.line(line).encode()[:byte_offset].decode(errors="ignore")) + 1

    def text_of(self, span: Span) -> str:
        """The text of a stretch of this file."""
        return self.text[self.starts[span.line - 1] + span.col - 1 : self.starts[span.end_line - 1] + span.end_col - 1]

    def span(self, line: int, col: int, end_line: int, end_col: int) -> Span:
        return Span(self.path, line, col, end_line, end_col)


class EmbeddedText(NamedTuple):
    """The value of a string literal, and the place in the file of each of its characters.

    ``positions`` has one (line, column) per character, and a last one for the end.
    """

    source: SourceFile
    value: str
    positions: tuple[tuple[int, int], ...]

    def span(self, start: int, end: int) -> Span:
        """The span of ``value[start:end]``; an empty stretch is widened to one character."""
        last = len(self.positions) - 1
        start = min(max(start, 0), last)
        line, col = self.positions[start]
        if end <= start:
            return self.source.span(line, col, line, col + 1)
        end_line, end_col = self.positions[min(end, last) - 1]
        return self.source.span(line, col, end_line, end_col + 1)


_PREFIX = re.compile(r"[A-Za-z]*")
_ESCAPE = re.compile(r"\\(?:\n|[0-7]{1,3}|x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|N\{[^}]*\}|.)", re.DOTALL)


def embedded_text(source: SourceFile, parts: list[tuple[str, int, int]], value: str) -> EmbeddedText:
    """Map the characters of a string literal's value to the file.

    ``parts`` holds the literal as written, one (text with quotes, line, column) for each implicitly joined piece.
    """
    positions: list[tuple[int, int]] = []
    line, col = 1, 1
    for raw, line, col in parts:
        prefix = _PREFIX.match(raw)
        start = prefix.end() if prefix else 0
        quote = 3 if raw[start : start + 3] in ('"""', "'''") else 1
        is_raw = "r" in raw[:start].lower()
        col += start + quote
        index, stop = start + quote, len(raw) - quote
        while index < stop:
            escape = None if is_raw else _ESCAPE.match(raw, index)
            width = len(escape.group()) if escape else 1
            if not (escape and escape.group() == "\\\n"):
                positions.append((line, col))
            if "\n" in raw[index : index + width]:
                line, col = line + 1, 1
            else:
                col += width
            index += width
    positions.append((line, col))
    return EmbeddedText(source, value, tuple(positions))
