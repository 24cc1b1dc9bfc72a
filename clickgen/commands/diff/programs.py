"""The difference of two sides: routines by their names, rungs by what they do, and everything else that a PLC feels."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from clickgen.click.read.grid import DrawnRung
from clickgen.click.read.project import DrawnRoutine
from clickgen.commands.diff.changes import Difference, ValueChange
from clickgen.commands.diff.placing import name_key
from clickgen.commands.diff.renumber import Numbers, numbers_of, renumbered
from clickgen.commands.diff.routines import matching
from clickgen.commands.diff.rungs import RungDiff
from clickgen.commands.diff.sides import Side
from clickgen.commands.diff.words import WordedRung, Wording
from clickgen.commands.nicknames.changes import differing
from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address
from clickgen.emit.rung_words import Names
from clickgen.table.rows import Row, default_row
from clickgen.text.wording import counted


def diff(one: Side, other: Side) -> Difference:
    """Compare two sides, ``one`` being the older."""
    names = _names(one, other)
    wording = Wording(*names)
    numbers = numbers_of(one, other)
    first = {each.name: _worded(each, wording, {}) for each in one.routines}
    second = {each.name: _worded(each, wording, numbers) for each in other.routines}
    matches, notes = matching(one, other, first, second)
    scratch = frozenset(numbers.get(address, address) for address in other.scratch)
    run = RungDiff(first, second, matches, (one.scratch, scratch))
    routines = tuple(run.routines())
    values: tuple[ValueChange, ...] = ()
    doubts = [side.doubt for side in (one, other) if side.doubt]
    if not doubts and one.table and other.table:
        values = tuple(_values(one, other, one.table.by_address, other.table.by_address))
        notes = (*notes, *(_left_out(side) for side in (one, other) if side.faults))
    elif doubts:
        notes = (*notes, f"initial values and retention are not compared: {'; '.join(dict.fromkeys(doubts))}")
    notes = (*notes, *(_unplaced(side) for side in (one, other) if side.placed))
    if {name_key(row) for row in one.placed} & {name_key(row) for row in other.placed}:
        notes = (*notes, "names without addresses on both sides are compared by name")
    return Difference(one, other, names, routines, values, run.drawn_otherwise, notes, wording)


def _left_out(side: Side) -> str:
    more = len(side.faults) - 1
    others = f", and {counted(more, 'more fault')}" if more else ""
    return f"rows that cannot be read are left out: {side.faults[0]}{others}"


def _unplaced(side: Side) -> str:
    if len(side.placed) == 1:
        return f"a name of {side.shown} has no address yet; the one that a build would choose is compared"
    return (
        f"{len(side.placed)} names of {side.shown} have no addresses yet; those that a build would choose are compared"
    )


def _names(one: Side, other: Side) -> tuple[Names, Names]:
    """The nicknames of each side; one without a table borrows those of the other."""
    found = [
        {row.address: row.nickname for row in side.table.rows if row.nickname} if side.table else None
        for side in (one, other)
    ]
    first = found[0] if found[0] is not None else found[1]
    second = found[1] if found[1] is not None else found[0]
    return Names(first or {}), Names(second or {})


def _worded(routine: DrawnRoutine, wording: Wording, numbers: Numbers) -> tuple[WordedRung, ...]:
    return tuple(_rung(routine.name, number, rung, wording, numbers) for number, rung in enumerate(routine.rungs, 1))


def _rung(routine: str, number: int, rung: DrawnRung, wording: Wording, numbers: Numbers) -> WordedRung:
    worded = wording.rung(routine, number, rung)
    compared = renumbered(rung, numbers)
    return worded if compared is rung else replace(wording.rung(routine, number, compared), origin=worded)


def _values(
    one: Side, other: Side, first: Mapping[Address, Row], second: Mapping[Address, Row]
) -> Iterator[ValueChange]:
    """The initial values and retention of addresses that differ; without a row, CLICK's defaults."""
    for address in sorted({*first, *second, *one.unread, *other.unread}, key=lambda address: address.sort_key):
        if BANKS[address.bank].settings_fixed:
            continue
        if address in one.unread or address in other.unread:
            yield from _unjudged(one, other, address, first.get(address), second.get(address))
            continue
        before = first.get(address) or default_row(address, "")
        after = second.get(address) or default_row(address, "")
        found = differing(before, after)
        if "initial" in found:
            yield ValueChange(address, "initial value", before.initial or "nothing", after.initial or "nothing")
        # A current value is retentive if its timer or counter is (click-facts [bank.current-values]).
        if "retentive" in found and address.bank not in CURRENT_VALUE_OF:
            yield ValueChange(address, "retentive", *("Yes" if row.retentive else "No" for row in (before, after)))


def _unjudged(one: Side, other: Side, address: Address, first: Row | None, second: Row | None) -> Iterator[ValueChange]:
    """A row that cannot be read, if the other side has a different one: nobody knows whether they mean the same."""
    if one.unread.get(address) == other.unread.get(address):
        return
    if (address in one.unread or first) and (address in other.unread or second):
        shown = (
            "cannot be read" if address in side.unread else _shown(row) for side, row in ((one, first), (other, second))
        )
        yield ValueChange(address, "initial value and retention", *shown)


def _shown(row: Row | None) -> str:
    return f"{row.initial or 'nothing'}, {'retentive' if row.retentive else 'not retentive'}" if row else "nothing"
