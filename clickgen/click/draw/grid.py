"""Draws a CLICK rung: series and parallel contacts, branches and boxes placed in a grid of 31 columns.

A downward wire is at the left edge of its cell and ties that edge to the left edge of the cell below (click-facts
[grid.wires]). So the picture is made of *boundaries*: boundary c is the left edge of column c, boundary 0 the power
rail, boundary 31 the edge of the output column. A contact joins two boundaries of one row; a tie joins rows at one
boundary. Where parallel legs merge and outputs split at the same boundary they share one tie, as CLICK draws it
(click-facts [grid.shared-tie]).
"""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.click.draw.network import Leaf, Net, Parallel, Series, network
from clickgen.click.draw.tokens import ALWAYS_CONTACT, NEVER_CONTACT, action_token, pin_row, pin_token
from clickgen.instructions.spec import Param
from clickgen.ir.conditions import Always, Condition
from clickgen.ir.program import Action, Branch, Item
from clickgen.records import dataclass

COLUMNS = 31
"""Condition columns A to AE."""
MAX_ROWS = 32
"""Rows of one rung, tall boxes at their full height (click-facts [grid.rows])."""


@dataclass(frozen=True, slots=True)
class Grid:
    """A drawn rung, every row of tall boxes written out: 31 cells and the output cell of each row.

    ``boxed`` says for each row whether it continues the box above it, ``unused`` has those of these rows that are
    inputs which the program does not use.
    """

    cells: tuple[tuple[str, ...], ...]
    outputs: tuple[str, ...]
    boxed: tuple[bool, ...]
    unused: frozenset[int] = frozenset()

    def __len__(self) -> int:
        return len(self.outputs)


class DoesNotFit(Exception):
    """The rung needs more columns or rows than CLICK has."""


def draw(condition: Condition, items: tuple[Item, ...]) -> Grid:
    """Return the grid of one CLICK rung. Raises DoesNotFit if it is too wide or too tall.

    An instruction with pins must be the only item, without branches (click-facts [grid.one-branch]).
    """
    canvas = _Canvas()
    if len(items) == 1 and isinstance(items[0], Action) and items[0].spec.pins:
        canvas.pinned_box(network(condition), items[0])
    else:
        canvas.node(network(condition), items, 0, 0)
    return canvas.finish()


class _Canvas:
    def __init__(self) -> None:
        self.rows: list[list[str]] = []
        self.downs: set[tuple[int, int]] = set()
        self.outputs: dict[int, str] = {}
        self.boxed: set[int] = set()
        self.unused: set[int] = set()

    # -- contacts -----------------------------------------------------------------------------------------------------

    def net(self, net: Net, row: int, col: int, step: int = 1) -> tuple[list[int], list[int]]:
        """Draw contacts from boundary ``col`` of ``row``; further legs go down, or up if ``step`` is -1.

        Returns the rows at which power enters (at ``col``) and leaves (at ``col + net.width``).
        """
        if isinstance(net, Leaf):
            self.put(row, col, net.token)
            return [row], [row]
        if isinstance(net, Series):
            entries: list[int] = []
            exits: list[int] = []
            for part in net.parts:
                inner, outer = self.net(part, row, col, step)
                self.tie(col, exits + inner)
                entries, exits = entries or inner, outer
                col += part.width
            return entries, exits
        return self._legs(net, row, col, step)

    def _legs(self, net: Parallel, row: int, col: int, step: int) -> tuple[list[int], list[int]]:
        entries: list[int] = []
        exits: list[int] = []
        for leg in net.legs if step > 0 else reversed(net.legs):
            inner, outer = self.net(leg, row, col, step)
            if leg.width < net.width:
                self.tie(col + leg.width, outer)
                self.wire(row, col + leg.width, col + net.width)
                outer = [row]
            entries += inner
            exits += outer
            row += step * leg.height
        return entries, exits

    # -- outputs and branches -----------------------------------------------------------------------------------------

    def node(self, net: Net | None, items: tuple[Item, ...], row: int, col: int) -> tuple[list[int], int]:
        """Draw a condition and what depends on it. Returns the rows at which power enters and the rows used."""
        entries: list[int] = []
        exits = [row]
        split = col
        if net is not None:
            entries, exits = self.net(net, row, col)
            split += net.width
        starts: list[int] = []
        below = row
        for item in items:
            if isinstance(item, Branch):
                inner, used = self.node(network(item.condition), item.items, below, split)
                starts += inner
                below += used
            else:
                assert isinstance(item, Action)
                self.lead(below, split, item)
                self.box(below, item)
                starts.append(below)
                below += item.height
        self.tie(split, exits + starts)
        return entries or starts, max(below - row, net.height if net is not None else 1)

    def pinned_box(self, net: Net | None, action: Action) -> None:
        """Draw a box whose inputs are rows of their own: legs of its enable go above it, those of its last pin below
        (click-facts [grid.pin-legs, grid.pin-rows]).

        Every pin input needs a contact (click-facts [grid.pin-contact]): SC1 is always on, ~SC1 never. An enable gets
        one too, unless the box is known to run without it.
        """
        spec = action.spec
        enable = net if net is not None or spec.bare_enable else Leaf(ALWAYS_CONTACT)
        row = enable.height - 1 if enable is not None else 0
        self._input(enable, row, action, step=-1)
        self.box(row, action)
        for param in spec.pins:
            at = row + pin_row(spec, param)
            if param.name not in action.args and not param.missing_pin:
                self.unused.add(at)
                continue
            self._input(pin_network(action, param), at, action)
            self.outputs[at] = pin_token(action, param)

    def _input(self, net: Net | None, row: int, action: Action, step: int = 1) -> None:
        if net is None:
            self.wire(row, 0, COLUMNS)
            return
        _, exits = self.net(net, row, 0, step)
        self.tie(net.width, exits)
        self.lead(row, net.width, action)

    # -- strokes ------------------------------------------------------------------------------------------------------

    def row(self, row: int) -> list[str]:
        while len(self.rows) <= row:
            self.rows.append([""] * COLUMNS)
        return self.rows[row]

    def put(self, row: int, col: int, text: str) -> None:
        if col >= COLUMNS:
            raise DoesNotFit
        self.row(row)[col] = text

    def wire(self, row: int, start: int, stop: int) -> None:
        """Draw a horizontal wire from boundary ``start`` to boundary ``stop``."""
        if stop > COLUMNS:
            raise DoesNotFit
        self.row(row)[start:stop] = ["-"] * (stop - start)

    def lead(self, row: int, start: int, action: Action) -> None:
        """Draw the wire from the last contact to an instruction; to a box of several rows it takes at least one column.

        laddercodec 0.2.2 cannot decode its own encoding of a contact in the last column before such a box
        (click-facts [grid.free-column]).
        """
        if start >= COLUMNS and action.height > 1:
            raise DoesNotFit
        self.wire(row, start, COLUMNS)

    def tie(self, boundary: int, rows: Iterable[int]) -> None:
        """Draw a vertical wire at a boundary over all these rows. The power rail ties every row by itself."""
        touched = set(rows)
        if boundary == 0 or len(touched) < 2:
            return
        if boundary >= COLUMNS:
            raise DoesNotFit
        self.downs.update((row, boundary) for row in range(min(touched), max(touched)))

    def box(self, row: int, action: Action) -> None:
        height = action.height
        self.outputs[row] = action_token(action)
        self.boxed.update(range(row + 1, row + height))
        self.row(row + height - 1)

    def finish(self) -> Grid:
        if len(self.rows) > MAX_ROWS:
            raise DoesNotFit
        for row, col in self.downs:
            text = self.rows[row][col]
            self.rows[row][col] = "|" if text == "" else "T" if text == "-" else f"T:{text}"
        rows = range(len(self.rows))
        return Grid(
            tuple(map(tuple, self.rows)),
            tuple(self.outputs.get(row, "") for row in rows),
            tuple(row in self.boxed for row in rows),
            frozenset(self.unused),
        )


def pin_network(action: Action, param: Param) -> Net:
    """Return the contacts of a pin; a pin that is left out is never on, an unconditional one always."""
    condition = action.pin(param.name)
    if condition is None:
        return Leaf(NEVER_CONTACT)
    return Leaf(ALWAYS_CONTACT) if isinstance(condition, Always) else network(condition) or Leaf(ALWAYS_CONTACT)
