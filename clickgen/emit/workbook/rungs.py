"""The sheet with the program rung by rung, in the words of the listing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import zip_longest

from clickgen.emit.rung_words import condition_lines, item_lines
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet
from clickgen.lower.split import ClickRung

_LINES_MAX = 24
"""The height of a spreadsheet row is limited; longer text goes on in the next row."""
_COMMENT_WIDTH, _LADDER_WIDTH = 40, 105


def rungs(project: Project) -> Sheet:
    return Sheet(
        "Rungs",
        "Every rung of CLICK in words, numbered in its routine, with the lines of the source that it comes from.",
        (
            Column("Routine", 16, wraps=True),
            Column("Rung", 6),
            Column("Source", 22, wraps=True),
            Column("Rung comment", _COMMENT_WIDTH, wraps=True),
            Column("Ladder in words", _LADDER_WIDTH, wraps=True),
        ),
        _rows(project),
    )


def _rows(project: Project) -> Iterator[Cells]:
    for routine in project.built.routines:
        for number, rung in enumerate(routine.rungs, 1):
            comments = _portions(rung.comment.split("\n"), _COMMENT_WIDTH)
            ladders = _portions(_words(project, rung), _LADDER_WIDTH)
            for index, (comment, ladder) in enumerate(zip_longest(comments, ladders, fillvalue="")):
                shown = comment or ("(goes on)" if index else "")
                yield routine.name, number, project.lines(rung.span), shown, Marked(ladder, Look.LADDER)


def _words(project: Project, rung: ClickRung) -> Iterator[str]:
    yield from condition_lines("", rung.condition, project.built.names)
    yield from item_lines("  ", rung.items, project.built.names)


def _portions(lines: Iterable[str], width: int) -> Iterator[str]:
    """Group lines into portions that a row can show; a line wider than its column counts as several."""
    portion: list[str] = []
    height = 0
    for piece in (piece for line in lines for piece in _pieces(line, width * _LINES_MAX // 2)):
        needed = len(piece) * 5 // (width * 4) + 1  # Lines break at words: a column is never quite filled.
        if portion and height + needed > _LINES_MAX:
            yield "\n".join(portion)
            portion, height = [], 0
        portion.append(piece)
        height += needed
    yield "\n".join(portion)


def _pieces(line: str, most: int) -> Iterator[str]:
    """Divide a line into pieces of at most this many characters, between words if possible."""
    while len(line) > most:
        end = line.rfind(" ", 0, most) + 1 or most
        yield line[:end]
        line = line[end:]
    yield line
