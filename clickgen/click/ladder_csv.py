"""The ladder CSV of a routine: 33 columns, one R row per rung (click-facts [ladder-file.csv])."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator
from string import ascii_uppercase
from typing import TYPE_CHECKING

from clickgen.click.draw.grid import COLUMNS, Grid

if TYPE_CHECKING:
    from clickgen.lower.split import ClickRung

_CONDITION_COLUMNS = [*ascii_uppercase, *(f"A{letter}" for letter in ascii_uppercase)][:COLUMNS]
HEADER = ("marker", *_CONDITION_COLUMNS, "AF")


def ladder_csv(rungs: Iterable[ClickRung]) -> str:
    """The rungs as ladder CSV text, with the same rows that laddercodec's writer gives."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for rung in rungs:
        if rung.comment:
            writer.writerows(("#", line) for line in rung.comment.split("\n"))
        writer.writerows(_rows(rung.grid))
    return text.getvalue()


def _rows(grid: Grid) -> Iterator[tuple[str, ...]]:
    marker = "R"
    for index in range(len(grid)):
        if not _is_understood(grid, index):
            yield (marker, *grid.cells[index], grid.outputs[index])
            marker = ""


def _is_understood(grid: Grid, index: int) -> bool:
    """True for a row that only gives a tall box its height: readers restore it, unless a bare row follows the box.

    Behind an unused input the box goes on: there it is the row below the whole box that counts.
    """
    if not _is_padding(grid, index):
        return False
    below = index + 1
    while below < len(grid) and (_is_padding(grid, below) or (index in grid.unused and grid.boxed[below])):
        below += 1
    return below == len(grid) or grid.outputs[below] != ""


def _is_padding(grid: Grid, index: int) -> bool:
    return grid.boxed[index] and not grid.outputs[index] and all(cell in ("", "|") for cell in grid.cells[index])
