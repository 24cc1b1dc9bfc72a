"""A drawn rung as a graph: nodes are edges of squares that wires join, arcs the contacts between them.

A downward wire ties the left edges of two squares. A contact and a wire carry power to the right (click-facts
[grid.power, grid.wires]), so a wire joins its two ends only if power could not come back through it to something
else; otherwise the wire stays an arc of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from clickgen.click.draw.grid import COLUMNS
from clickgen.click.draw.tokens import compare_token, contact_token
from clickgen.click.ladder_csv import HEADER
from clickgen.click.read.grid import DrawnRung
from clickgen.click.read.problem import LadderProblem
from clickgen.ir.conditions import Always, Compare, Condition, Contact

Place = tuple[int, int]
"""Row and column: of a square, or of the left edge of one."""
RAIL: Place = (0, 0)
ONE_WAY_WIRE = (
    "a wire could carry power back to another output; it is assumed to carry it only to the right, and the part "
    "before it is written several times"
)


@dataclass(eq=False)
class Arc:
    """A path for power from one node to another; ``place`` is that of its first contact.

    ``legs`` has those of several that became one, each with its place.
    """

    start: Place
    stop: Place
    condition: Condition
    place: Place
    legs: tuple[tuple[Place, Condition], ...] = ()


@dataclass
class Network:
    """Arcs from the rail, and the node of each row at the output column; ``notes`` are on changes to the drawing."""

    arcs: list[Arc]
    ends: dict[int, Place]
    notes: list[str] = field(default_factory=list)


def network_of(rung: DrawnRung) -> Network:
    """Return the graph of a rung. Raises LadderProblem for a contact that leads from or to nothing."""
    nodes = _Joined()
    for row, drawn in enumerate(rung.rows):
        nodes.join(RAIL, (row, 0))
        if row + 1 < len(rung.rows):
            for column, square in enumerate(drawn.squares):
                if square.down and column:
                    nodes.join((row, column), (row + 1, column))
    wire = Always(rung.span)
    arcs: list[Arc] = []
    for row, drawn in enumerate(rung.rows):
        squares = drawn.squares
        above = rung.rows[row - 1].squares if row else squares
        # A wire ends at a contact, at a gap, and at a square where another wire meets it from above or below.
        stops = [
            column
            for column, square in enumerate(squares)
            if square.contact is not None or square.down or not square.right or (row and above[column].down)
        ]
        stops.append(COLUMNS)
        following = iter(stops)
        stop = next(following)
        column = 0
        while column < COLUMNS:
            place, square = (row, column), squares[column]
            column += 1
            if square.contact is None and square.right:
                # A wire is one arc up to the next square that is more than a piece of it.
                while stop < column:
                    stop = next(following)
                column = stop
            if square.right:
                arcs.append(Arc(nodes.of(place), nodes.of((row, column)), square.contact or wire, place))
    rows = {row for box in rung.boxes for row in (box.row, *(row for _, row in box.pins))}
    ends = {row: nodes.of((row, COLUMNS)) for row in sorted(rows)}
    kept = leading(arcs, ends.values())
    useful = set(kept)
    _refuse_loose(rung, [arc for arc in arcs if arc not in useful])
    found = Network(kept, ends)
    _join_wires(found)
    return found


def leading(arcs: list[Arc], ends: Iterable[Place]) -> list[Arc]:
    """Return the arcs on a way from the rail to one of the ends."""
    fed = reached(arcs, [RAIL])
    useful = reached(arcs, ends, backwards=True)
    return [arc for arc in arcs if arc.start in fed and arc.stop in useful]


def reached(
    arcs: Iterable[Arc], starts: Iterable[Place], backwards: bool = False, without: Place | None = None
) -> set[Place]:
    """The nodes that power reaches from these, or that reach these; ``without`` names a node that blocks it."""
    following: dict[Place, list[Place]] = {}
    for arc in arcs:
        one, other = (arc.stop, arc.start) if backwards else (arc.start, arc.stop)
        following.setdefault(one, []).append(other)
    waiting = [node for node in starts if node != without]
    found = set(waiting)
    while waiting:
        for node in following.get(waiting.pop(), ()):
            if node not in found and node != without:
                found.add(node)
                waiting.append(node)
    return found


def _refuse_loose(rung: DrawnRung, loose: list[Arc]) -> None:
    contacts = [arc for arc in loose if not isinstance(arc.condition, Always)]
    if contacts:
        message = f"{_shown(contacts[0])} does not lead from the power rail to an output"
        raise LadderProblem(message, rung.file, rung.rows[contacts[0].place[0]].line)


def _shown(arc: Arc) -> str:
    """``X002 in row 1, column B``"""
    row, column = arc.place
    condition = arc.condition
    assert isinstance(condition, Contact | Compare)
    token = contact_token(condition) if isinstance(condition, Contact) else compare_token(condition)
    return f"{token} in row {row + 1}, column {HEADER[column + 1]}"


# -- wires ------------------------------------------------------------------------------------------------------------


class _Joined:
    """Nodes that are one; each class is identified by its first place in reading order."""

    def __init__(self) -> None:
        self._above: dict[Place, Place] = {}

    def of(self, node: Place) -> Place:
        while node in self._above:
            node = self._above[node]
        return node

    def join(self, one: Place, other: Place) -> None:
        one, other = sorted((self.of(one), self.of(other)))
        if one != other:
            self._above[other] = one


def _join_wires(network: Network) -> None:
    """Make one node of a wire's ends wherever no power could come back through it."""
    nodes = _Joined()
    ends = set(network.ends.values())
    while True:
        joined = next((pairs for rule in _RULES if (pairs := list(rule(network.arcs, ends)))), None)
        if joined is None:
            break
        for one, other in joined:
            nodes.join(one, other)
        for arc in network.arcs:
            arc.start, arc.stop = nodes.of(arc.start), nodes.of(arc.stop)
        network.notes += _left_out(arc for arc in network.arcs if arc.start == arc.stop)
        network.arcs = [arc for arc in network.arcs if arc.start != arc.stop]
        ends = {nodes.of(end) for end in ends}
    network.ends = {row: nodes.of(end) for row, end in network.ends.items()}
    if any(isinstance(arc.condition, Always) for arc in network.arcs):
        network.notes.append(ONE_WAY_WIRE)
    _leave_out_useless(network)


def _left_out(gone: Iterable[Arc]) -> list[str]:
    """The notes on arcs that were removed; none for wires."""
    contacts = (arc for arc in gone if not isinstance(arc.condition, Always))
    return [f"{_shown(arc)} is left out: a wire leads around it" for arc in contacts]


def _from_one(arcs: list[Arc], _: set[Place]) -> Iterator[tuple[Place, Place]]:
    """Wires to nodes that get their power only from the wire's other end."""
    sources: dict[Place, set[Place]] = {}
    for arc in arcs:
        sources.setdefault(arc.stop, set()).add(arc.start)
    for arc in arcs:
        is_only = len(sources[arc.stop]) == 1 and arc.stop != RAIL
        if isinstance(arc.condition, Always) and (is_only or arc.start == RAIL):
            yield arc.start, arc.stop


def _to_one(arcs: list[Arc], ends: set[Place]) -> Iterator[tuple[Place, Place]]:
    """Wires from nodes that lead nowhere but to the wire's other end."""
    targets: dict[Place, set[Place]] = {}
    for arc in arcs:
        targets.setdefault(arc.start, set()).add(arc.stop)
    for arc in arcs:
        if isinstance(arc.condition, Always) and len(targets[arc.start]) == 1 and arc.start not in ends | {RAIL}:
            yield arc.start, arc.stop


def _always_through(arcs: list[Arc], ends: set[Place]) -> Iterator[tuple[Place, Place]]:
    """The first wire with an end on every way to, or from, its other end."""
    for arc in arcs:
        if isinstance(arc.condition, Always):
            is_before = arc.stop not in reached(arcs, [RAIL], without=arc.start)
            is_behind = arc.start not in ends and not reached(arcs, [arc.start], without=arc.stop) & ends
            if is_before or is_behind:
                yield arc.start, arc.stop
                return


def _has_circle(arcs: list[Arc]) -> bool:
    """True if power could come back to where it was."""
    waiting: dict[Place, int] = {}
    following: dict[Place, list[Place]] = {}
    for arc in arcs:
        waiting[arc.stop] = waiting.get(arc.stop, 0) + 1
        following.setdefault(arc.start, []).append(arc.stop)
    free = [node for node in following if node not in waiting]
    for node in free:
        for other in following.get(node, ()):
            waiting[other] -= 1
            if not waiting[other]:
                free.append(other)
    return any(waiting.values())


_RULES = (_from_one, _to_one, _always_through)


def _leave_out_useless(network: Network) -> None:
    """Remove arcs that only lead back to where power is already, and those that then lead nowhere."""
    ends = set(network.ends.values())
    if not _has_circle(network.arcs):
        return
    gone: list[Arc] = []
    for arc in list(network.arcs):
        rest = [one for one in network.arcs if one is not arc]
        is_back = arc.start not in reached(network.arcs, [RAIL], without=arc.stop)
        is_around = arc.stop not in ends and not reached(network.arcs, [arc.stop], without=arc.start) & ends
        if is_back or is_around:
            gone.append(arc)
            network.arcs = rest
    kept = leading(network.arcs, ends)
    gone += [arc for arc in network.arcs if arc not in kept]
    network.notes += _left_out(gone)
    network.arcs = kept
