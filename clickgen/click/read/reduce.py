"""Turns a graph of contacts into conditions: series and parallel arcs are merged until a tree of branches is left.

If legs do not come together like that (a bridge, or an output in the middle of a leg), the contacts before the place
where they part are written for each of them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import groupby

from clickgen.click.read.network import RAIL, Arc, Place, leading, reached
from clickgen.ir.conditions import All, Always, Any, Condition
from clickgen.ir.walk import leaves
from clickgen.text.source import Span

BRIDGE = (
    "the legs do not come together in series and parallel: power is taken to go through each contact to the right "
    "alone, and some contacts are written several times"
)
LEAVES_MAX = 200
"""No person could read a condition of more contacts."""


class TooEntangled(Exception):
    """A condition has more than LEAVES_MAX contacts."""


@dataclass(frozen=True)
class Tree:
    """The conditions on the only way from the rail to each node."""

    arcs: dict[Place, Arc]
    notes: list[str] = field(default_factory=list)

    def path(self, node: Place) -> tuple[Arc, ...]:
        """The arcs from the rail to a node, in their order."""
        path: list[Arc] = []
        while node != RAIL:
            path.append(self.arcs[node])
            node = self.arcs[node].start
        return tuple(reversed(path))


def tree_of(arcs: Iterable[Arc], ends: set[Place]) -> Tree:
    """Return the arcs as a tree with these nodes kept. Every end must be reachable. Raises TooEntangled."""
    left = leading(list(arcs), ends)
    notes: list[str] = []
    while True:
        left = _reduced(left, {RAIL, *ends})
        meeting = _first_meeting(left)
        if meeting is None:
            return Tree({arc.stop: arc for arc in left}, notes)
        left = _written_out(left, meeting, ends, notes)


def series(conditions: Iterable[Condition], span: Span) -> Condition:
    """All of these, flattened."""
    terms: list[Condition] = []
    for condition in conditions:
        terms += condition.terms if isinstance(condition, All) else () if _is_wire(condition) else (condition,)
    if not terms:
        return Always(span)
    return terms[0] if len(terms) == 1 else All(tuple(terms), span)


def parallel(conditions: Iterable[Condition], span: Span) -> Condition:
    """Any of these, flattened. A wire among them is always on."""
    terms: list[Condition] = []
    for condition in conditions:
        if _is_wire(condition):
            return condition
        terms += condition.terms if isinstance(condition, Any) else (condition,)
    return terms[0] if len(terms) == 1 else Any(tuple(terms), span)


def _is_wire(condition: Condition) -> bool:
    return isinstance(condition, Always)


def _reduced(arcs: list[Arc], kept: set[Place]) -> list[Arc]:
    """Merge arcs: those between the same nodes, and those with nothing between them."""
    while True:
        before = len(arcs)
        arcs = _without_joints(_without_legs(arcs), kept)
        if len(arcs) == before:
            return arcs


def _without_legs(arcs: list[Arc]) -> list[Arc]:
    """Merge arcs between the same two nodes, with their legs from top to bottom."""
    found: list[Arc] = []
    in_order = sorted(arcs, key=lambda arc: (arc.start, arc.stop))
    for (start, stop), group in groupby(in_order, key=lambda arc: (arc.start, arc.stop)):
        several = list(group)
        if len(several) == 1:
            found += several
            continue
        legs = [leg for arc in several for leg in arc.legs or ((arc.place, arc.condition),)]
        legs.sort(key=lambda leg: leg[0])
        condition = parallel((leg for _, leg in legs), legs[0][1].span)
        found.append(Arc(start, stop, condition, legs[0][0], tuple(legs)))
    return found


def _without_joints(arcs: list[Arc], kept: set[Place]) -> list[Arc]:
    """Merge two arcs if the node between them has no others."""
    before: dict[Place, list[Arc]] = {}
    behind: dict[Place, list[Arc]] = {}
    for arc in arcs:
        before.setdefault(arc.stop, []).append(arc)
        behind.setdefault(arc.start, []).append(arc)
    found = list(arcs)
    for node in before.keys() & behind.keys() - kept:
        if len(before[node]) == len(behind[node]) == 1:
            [one], [other] = before[node], behind[node]
            condition = series((one.condition, other.condition), one.condition.span)
            both = Arc(one.start, other.stop, condition, min(one.place, other.place))
            found = [arc for arc in found if arc not in (one, other)] + [both]
            behind[one.start] = [both if arc is one else arc for arc in behind[one.start]]
            before[other.stop] = [both if arc is other else arc for arc in before[other.stop]]
    return found


# -- bridges ----------------------------------------------------------------------------------------------------------


def _first_meeting(arcs: list[Arc]) -> Place | None:
    """A node to which several arcs lead, with no such node before it; None in a tree."""
    counts: dict[Place, int] = {}
    for arc in arcs:
        counts[arc.stop] = counts.get(arc.stop, 0) + 1
    several = [node for node, count in counts.items() if count > 1]
    for node in sorted(several):
        before = reached(arcs, [node], backwards=True) - {node}
        if not before & set(several):
            return node
    return None


def _written_out(arcs: list[Arc], meeting: Place, ends: set[Place], notes: list[str]) -> list[Arc]:
    """Return the arcs with one arc to the meeting, from the last node on every way to it."""
    origin = _last_common(arcs, meeting)
    inside = reached(arcs, [origin]) & reached(arcs, [meeting], backwards=True)
    region = [arc for arc in arcs if arc.start in inside - {meeting} and arc.stop in inside - {origin}]
    # All else in the region has one arc to it: its legs come together in the meeting and nowhere else.
    [whole] = _reduced(region, {origin, meeting})
    if sum(1 for _ in leaves(whole.condition)) > LEAVES_MAX:
        raise TooEntangled
    rest = leading([*(arc for arc in arcs if arc.stop != meeting), whole], ends)
    if any(arc in rest for arc in region):
        notes.append(BRIDGE)
    return rest


def _last_common(arcs: list[Arc], meeting: Place) -> Place:
    """The node closest to the meeting that is on every way from the rail to it."""
    before = reached(arcs, [meeting], backwards=True) & reached(arcs, [RAIL])
    common = [node for node in before - {meeting} if meeting not in reached(arcs, [RAIL], without=node)]
    return max(common, key=lambda node: len(reached(arcs, [node], backwards=True) & before))
