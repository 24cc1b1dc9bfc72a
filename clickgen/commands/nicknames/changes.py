"""How the rows of an export differ from those of a table, with one change for each event."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from clickgen.device.banks import Address, Kind
from clickgen.table.rows import Row, format_initial

ADDED, RENAMED, SWAPPED, MOVED, REMOVED, CHANGED = KINDS = (
    "added", "renamed", "swapped", "moved", "removed", "changed"
)  # fmt: skip

Rows = Mapping[Address, Row]


@dataclass(frozen=True)
class Change:
    """One difference: the row of the table and the row of the export.

    ``added`` has no row before if the table has none at the address; ``removed`` has one after if the address
    keeps a comment or a value without its name. ``changed`` is only about initial value, retention and comment.
    ``swapped`` is a name that comes from another address of the table, in a rotation of names that programs use:
    no rename in the programs keeps their ladder.
    """

    kind: str
    before: Row | None
    after: Row | None
    used: tuple[str, ...] | None = None
    """The places where programs use the name of the row before; None if nobody looked."""
    by_number: tuple[str, ...] = ()
    """The places where programs use the number of the address that gets a name."""

    @property
    def name(self) -> str:
        """The nickname that a program may use and that this removes or moves; "" if there is none."""
        is_felt = self.kind in (RENAMED, SWAPPED, MOVED, REMOVED) and not self.is_case_only
        return self.before.nickname if self.before and is_felt else ""

    @property
    def is_case_only(self) -> bool:
        """True for a name that is the same for CLICK and for programs."""
        return self.kind == RENAMED and _name(self.before) == _name(self.after)

    @property
    def sort_key(self) -> tuple[tuple[int, int, bool], int]:
        row = self.after or self.before
        assert row is not None
        return (row.address.sort_key, KINDS.index(self.kind))


def changes_between(ours: Iterable[Row], theirs: Iterable[Row]) -> list[Change]:
    """Every difference between the rows of a table and those of an export, in CLICK's row order."""
    before = {row.address: row for row in ours}
    after = {row.address: row for row in theirs}
    renamed = _renamed(before, after)
    found = [*_of_names(before, after, renamed), *_of_content(before, after, renamed)]
    return sorted(found, key=lambda change: change.sort_key)


def with_swaps(changes: list[Change]) -> list[Change]:
    """The changes, with those marked ``swapped`` that rotate names which programs use."""
    renamed = {_name(change.before): n for n, change in enumerate(changes) if change.kind == RENAMED}
    follower = {n: renamed.get(_name(changes[n].after)) for n in renamed.values()}
    follower = {n: other for n, other in follower.items() if other not in (None, n)}
    swapped: set[int] = set()
    waiting = [other for other in follower.values() if other is not None and changes[other].used]
    around: dict[int, list[int]] = {}
    for one, other in follower.items():
        assert other is not None
        around.setdefault(one, []).append(other)
        around.setdefault(other, []).append(one)
    while waiting:
        index = waiting.pop()
        if index not in swapped:
            swapped.add(index)
            waiting += around[index]
    return [replace(change, kind=SWAPPED) if n in swapped else change for n, change in enumerate(changes)]


def differing(one: Row, other: Row) -> list[str]:
    """The fields among ``initial``, ``retentive`` and ``comment`` that differ in two rows; ``1.50`` is ``1.5``."""
    pairs = {
        "initial": (_value(one), _value(other)),
        "retentive": (one.retentive, other.retentive),
        "comment": (_lines(one.comment), _lines(other.comment)),
    }
    return [field for field, (here, there) in pairs.items() if here != there]


def _of_names(before: Rows, after: Rows, renamed: set[Address]) -> Iterator[Change]:
    """The changes of names."""
    places = {_name(row): row for row in reversed([*after.values()]) if row.nickname}
    came = set()
    for address, row in before.items():
        other = after.get(address)
        if not row.nickname or _name(row) == _name(other):
            if row.nickname and other and row.nickname != other.nickname:
                yield Change(RENAMED, row, other)
            continue
        if address in renamed:
            yield Change(RENAMED, row, other)
        elif _name(row) in places:
            new = places[_name(row)]
            came.add(new.address)
            yield Change(MOVED, row, new)
        else:
            yield Change(REMOVED, row, other if other and not other.nickname else None)
    for address, row in after.items():
        stands = before.get(address)
        if row.nickname and _name(row) != _name(stands) and address not in renamed and address not in came:
            yield Change(ADDED, None if stands is None or stands.nickname else stands, row)


def _renamed(before: Rows, after: Rows) -> set[Address]:
    """The addresses that have another name, and whose names rotated among addresses that have names on both sides.

    A name leads from its address before to its address after: it is followed both ways as far as it goes.
    """
    was = {_name(row): address for address, row in reversed([*before.items()]) if row.nickname}
    is_now = {_name(row): address for address, row in reversed([*after.items()]) if row.nickname}
    differing = [address for address, row in before.items() if row.nickname and _name(row) != _name(after.get(address))]
    renamed: set[Address] = set()
    seen: set[Address] = set()
    for start in differing:
        group: set[Address] = set()
        waiting = [start] if start not in seen else []
        while waiting:
            address = waiting.pop()
            if address not in group:
                group.add(address)
                around = (is_now.get(_name(before.get(address))), was.get(_name(after.get(address))))
                waiting += (other for other in around if other is not None)
        seen |= group
        if all(_name(before.get(address)) and _name(after.get(address)) for address in group):
            renamed |= group
    return renamed


def _of_content(before: Rows, after: Rows, renamed: set[Address]) -> Iterator[Change]:
    """The changes of initial values, retention and comments at addresses that stay what they are."""
    for address, row in before.items():
        other = after.get(address)
        if other is None:
            if not row.nickname:
                yield Change(REMOVED, row, None)
        elif (not row.nickname or address in renamed or _name(row) == _name(other)) and differing(row, other):
            yield Change(CHANGED, row, other)
    for address, row in after.items():
        if not row.nickname and address not in before:
            yield Change(ADDED, None, row)


def _name(row: Row | None) -> str:
    return row.nickname.lower() if row else ""


def _value(row: Row) -> str:
    """An initial value in CLICK's form; as written if it has none."""
    text, kind = row.initial, row.address.kind
    try:
        if kind is Kind.TEXT:
            return text
        number = float(text or 0) if kind is Kind.FLOAT else int(text or "0", 16 if kind is Kind.HEX else 10)
    except ValueError:
        return text
    return format_initial(kind, number) or text


def _lines(comment: str) -> str:
    return comment.replace("\r\n", "\n")
