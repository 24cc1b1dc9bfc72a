"""Power through the squares of a drawn rung, in any logic: sets of situations, decision diagrams.

Power goes to the right through contacts and wires; a downward wire ties the left edges of two squares (click-facts
[grid.power, grid.wires]). Every square leads to the next column, so one sweep over the columns finds everything.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Protocol

from clickgen.click.draw.grid import COLUMNS
from clickgen.click.read.grid import DrawnRung
from clickgen.ir.conditions import Compare, Contact


class Logic(Protocol):
    """Truth values of one kind, each identified by a number."""

    @property
    def never(self) -> int: ...
    @property
    def always(self) -> int: ...

    def variable(self, name: str) -> int: ...
    def both(self, one: int, other: int) -> int: ...
    def either(self, one: int, other: int) -> int: ...
    def opposite(self, one: int) -> int: ...


def power_of(rung: DrawnRung, conducts: Callable[[Contact | Compare], int], logic: Logic) -> list[int]:
    """When each row of the output column has power."""
    level = [logic.always] * len(rung.rows)
    for column in range(COLUMNS):
        for tied in _ties(rung, column):
            if len(tied) > 1:
                shared = logic.never
                for row in tied:
                    shared = logic.either(shared, level[row])
                level[tied.start : tied.stop] = [shared] * len(tied)
        for row, drawn in enumerate(rung.rows):
            square = drawn.squares[column]
            if not square.right:
                level[row] = logic.never
            elif square.contact is not None and level[row] != logic.never:
                level[row] = logic.both(level[row], conducts(square.contact))
    return level


def contacts_before(rung: DrawnRung, rows: Iterable[int]) -> Iterator[Contact | Compare]:
    """Yield the contacts that may decide over power in these rows of the output column.

    Contacts before a node come before those after it, leg by leg: decision diagrams stay small in this order.
    """
    seen: set[tuple[int, int]] = set()

    def walk(row: int, column: int) -> Iterator[Contact | Compare]:
        if (row, column) in seen or column == 0:
            return
        tied = next(rows for rows in ties[column] if row in rows) if column < COLUMNS else range(row, row + 1)
        seen.update((other, column) for other in tied)
        for other in tied:
            square = rung.rows[other].squares[column - 1]
            if square.right:
                yield from walk(other, column - 1)
                if square.contact is not None:
                    yield square.contact

    ties = [list(_ties(rung, column)) for column in range(COLUMNS)]
    for row in rows:
        yield from walk(row, COLUMNS)


def _ties(rung: DrawnRung, column: int) -> Iterator[range]:
    """Yield the rows whose left edges in this column are one node, from top to bottom."""
    start, last = 0, len(rung.rows) - 1
    for row, drawn in enumerate(rung.rows):
        if row == last or column == 0 or not drawn.squares[column].down:
            yield range(start, row + 1)
            start = row + 1
