"""The difference of two sides: routines by their names, rungs by what they do, and what else a PLC does otherwise."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address
from clickgen.diffing.changes import Difference, ValueChange
from clickgen.diffing.routines import matching
from clickgen.diffing.rungs import RungDiff
from clickgen.diffing.sides import Side
from clickgen.diffing.words import WordedRung, Wording
from clickgen.emit.listing import Names
from clickgen.ladder.project import DrawnRoutine
from clickgen.nicknames.changes import differing
from clickgen.resolve.rows import Row, default_row


def diff(one: Side, other: Side) -> Difference:
    """Compare two sides, ``one`` being the older."""
    names = _names(one, other)
    wording = Wording(*names)
    first, second = ({each.name: _worded(each, wording) for each in side.routines} for side in (one, other))
    matches, notes = matching(one, other, first, second)
    scratch = frozenset(row.address for side in (one, other) for row in side.scratch_rows)
    run = RungDiff(first, second, matches, scratch)
    routines = tuple(run.routines())
    values: tuple[ValueChange, ...] = ()
    doubts = [side.doubt for side in (one, other) if side.doubt]
    if not doubts and one.table and other.table:
        values = tuple(_values(one.table.by_address, other.table.by_address))
    elif doubts:
        notes = (*notes, f"initial values and retention are not compared: {'; '.join(dict.fromkeys(doubts))}")
    notes = (*notes, *(_unplaced(side) for side in (one, other) if side.unplaced))
    return Difference(one, other, names, routines, values, run.drawn_otherwise, notes, wording)


def _unplaced(side: Side) -> str:
    if side.unplaced == 1:
        return f"a name of {side.shown} has no address yet; the one that a build would choose is compared"
    return f"{side.unplaced} names of {side.shown} have no addresses yet; those that a build would choose are compared"


def _names(one: Side, other: Side) -> tuple[Names, Names]:
    """The nicknames of each side; one without a table borrows those of the other."""
    found = [
        {row.address: row.nickname for row in side.table.rows if row.nickname} if side.table else None
        for side in (one, other)
    ]
    first = found[0] if found[0] is not None else found[1]
    second = found[1] if found[1] is not None else found[0]
    return Names(first or {}), Names(second or {})


def _worded(routine: DrawnRoutine, wording: Wording) -> tuple[WordedRung, ...]:
    return tuple(wording.rung(routine.name, number, rung) for number, rung in enumerate(routine.rungs, 1))


def _values(one: Mapping[Address, Row], other: Mapping[Address, Row]) -> Iterator[ValueChange]:
    """What addresses begin with, and whether they keep it; without a row as CLICK has it by default."""
    for address in sorted({*one, *other}, key=lambda address: address.sort_key):
        if BANKS[address.bank].settings_fixed:
            continue
        before = one.get(address) or default_row(address, "")
        after = other.get(address) or default_row(address, "")
        found = differing(before, after)
        if "initial" in found:
            yield ValueChange(address, "initial value", before.initial or "nothing", after.initial or "nothing")
        # A current value is kept as its timer or counter is (click-facts, section 1).
        if "retentive" in found and address.bank not in CURRENT_VALUE_OF:
            yield ValueChange(address, "retentive", *("Yes" if row.retentive else "No" for row in (before, after)))
