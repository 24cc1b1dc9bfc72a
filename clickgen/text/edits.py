"""Apply fixes: edits in the text of a file that keep every other byte."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from clickgen.text.source import FORM_FEED, Span


class Edit(NamedTuple):
    """Text that replaces a stretch of a source file; an empty stretch is an insertion."""

    span: Span
    text: str


class Fix(NamedTuple):
    """Edits that remove a problem. A safe one cannot change what the program does."""

    edits: tuple[Edit, ...]
    is_safe: bool = True
    rests_on_names: bool = False
    """True when it is safe only because of what names mean: every program that uses the file has to agree."""


_LINE_END = re.compile(r"\r\n|\r|\n")


def apply_fixes(text: str, fixes: Iterable[Fix]) -> tuple[str, int]:
    """Return the text after the fixes that do not overlap, the earlier first, and how many those are.

    ``text`` is the raw text of the file, with its own line ends and byte order mark; new lines get the same line ends.
    """
    places = _Places(text)
    fitting = _fitting(places, fixes)
    chosen = [piece for _, pieces in fitting for piece in pieces]
    parts: list[str] = []
    done = 0
    # An insertion comes before what is replaced at its place; two insertions of one fix keep their order.
    for start, end, new in sorted(chosen, key=lambda piece: piece[:2]):
        parts += (text[done:start], new)
        done = end
    return "".join((*parts, text[done:])), len(fitting)


def fixes_that_fit(text: str, fixes: Iterable[Fix]) -> list[Fix]:
    """The fixes that ``apply_fixes`` takes: none of them overlaps another."""
    return [fix for fix, _ in _fitting(_Places(text), fixes)]


def _fitting(places: _Places, fixes: Iterable[Fix]) -> list[tuple[Fix, list[tuple[int, int, str]]]]:
    """The fixes that do not overlap, each with its stretches of the text and the replacements."""
    taken: list[tuple[int, int]] = []
    fitting: list[tuple[Fix, list[tuple[int, int, str]]]] = []
    for fix in sorted(fixes, key=lambda fix: min(edit.span[1:3] for edit in fix.edits)):
        pieces = [_piece(places, edit) for edit in fix.edits]
        if any(_overlap((start, end), other) for start, end, _ in pieces for other in taken):
            continue
        taken += [(start, end) for start, end, _ in pieces]
        fitting.append((fix, pieces))
    return fitting


def _piece(places: _Places, edit: Edit) -> tuple[int, int, str]:
    start, end = places.offsets(edit.span)
    return start, end, edit.text.replace("\n", places.line_end)


def _overlap(one: tuple[int, int], other: tuple[int, int]) -> bool:
    """True for two stretches that share a character, or two insertions at one place."""
    return one == other or (one[0] < other[1] and other[0] < one[1])


class _Places:
    """Lines and columns of a file as problems name them, and their offsets in its text."""

    def __init__(self, text: str) -> None:
        self.line_end = "\n"
        ends = list(_LINE_END.finditer(text))
        if ends:
            self.line_end = ends[0].group()
        self._starts = [0, *(match.end() for match in ends)]
        self._ends = [*(match.start() for match in ends), len(text)]
        self._text = text

    def offsets(self, span: Span) -> tuple[int, int]:
        return self._offset(span.line, span.col), self._offset(span.end_line, span.end_col)

    def _offset(self, line: int, col: int) -> int:
        index = min(line, len(self._starts)) - 1
        start, end = self._starts[index], self._ends[index]
        # What the reader of the file leaves out: a byte order mark, and blanks before a form feed.
        if index == 0 and self._text.startswith("\ufeff"):
            start += 1
        skipped = FORM_FEED.match(self._text[start:end])
        if skipped:
            start += skipped.end()
        return min(start + col - 1, end)
