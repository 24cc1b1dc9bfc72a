"""A sheet before it becomes one of Excel: a name, columns, and rows of values. Pure data."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum, auto
from typing import NamedTuple


class Look(Enum):
    """How a cell stands out; ``looks.py`` defines each look."""

    PLAIN = auto()
    TITLE = auto()
    FAINT = auto()
    """Nothing is there: a free point, a free stretch."""
    LADDER = auto()
    """Rungs in words, indented."""
    USED = auto()
    NAMED = auto()
    BLOCK = auto()
    SCRATCH = auto()
    RESERVED = auto()


class Marked(NamedTuple):
    """A value that stands out."""

    value: str | int | float | None
    look: Look


Value = str | int | float | Marked | None
Cells = tuple[Value, ...]


class Column(NamedTuple):
    """``width`` is in characters. If the column ``wraps``, a wider text goes on in the next line."""

    title: str
    width: int
    wraps: bool = False
    is_centered: bool = False


@dataclass(frozen=True)
class Sheet:
    """``about`` describes the sheet in one line, which is printed above each page."""

    name: str
    about: str
    columns: tuple[Column, ...]
    rows: Iterable[Cells]
    has_filter: bool = True
