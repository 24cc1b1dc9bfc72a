"""Merges a fresh export of CLICK into the address table: finds the differences, and takes the requested ones.

CLICK knows addresses, a program knows names. So if the same addresses have names before and after, they were
renamed; if a name left an address without one, or came to one without, it moved. Rows of SC and SD are CLICK's and
rows of scratch cells are clickgen's: both stay unchanged. Settings from a workbook or a declaration of a program are
changed there.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

from clickgen.commands.nicknames.changes import (
    ADDED,
    CHANGED,
    KINDS,
    MOVED,
    REMOVED,
    RENAMED,
    SWAPPED,
    Change,
    changes_between,
    differing,
    with_swaps,
)
from clickgen.commands.nicknames.uses import ProgramsSay
from clickgen.device.banks import Address
from clickgen.ir.program import Declaration
from clickgen.problems.diagnostics import Diagnostics
from clickgen.resolve.declare import initial_of
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import Row, is_scratch

__all__ = ["KINDS", "SWAPPED", "Change", "Conflict", "Merge", "merge"]

OWN_BANKS = ("SC", "SD")
"""Nobody knows what CLICK does with such rows on import (click-facts [nickname-file.system-rows]): they are neither
taken nor written."""


@dataclass(frozen=True)
class Conflict:
    """A change that cannot be taken: what is in its way, and the kinds that settle it when accepted together.

    Without ``accept`` no kind does.
    """

    change: Change
    reason: str
    accept: tuple[str, ...] = ()


class _Needs(NamedTuple):
    """The needs of a change: other changes, which remove these rows from its way. ``never`` says why nothing helps."""

    never: str
    others: list[tuple[int, Row]]


@dataclass(frozen=True)
class Merge:
    """How an export differs from the table. ``kept_apart`` counts its rows of SC and SD."""

    table: AddressTable
    export: AddressTable
    changes: tuple[Change, ...]
    kept_apart: int
    says: ProgramsSay = field(default_factory=ProgramsSay)

    def of(self, kinds: Collection[str]) -> tuple[Change, ...]:
        """The changes of these kinds, in CLICK's row order."""
        return tuple(change for change in self.changes if change.kind in kinds)

    def takes(self, kinds: Collection[str]) -> tuple[Change, ...]:
        """The changes of these kinds that leave a legal table: each name and each address once."""
        stuck = self._stuck(kinds)
        return tuple(change for index, change in enumerate(self.changes) if index not in stuck)

    def conflicts(self, kinds: Collection[str]) -> tuple[Conflict, ...]:
        """The reasons why the other changes of these kinds cannot be taken."""
        stuck = sorted(index for index in self._stuck(kinds) if self.changes[index].kind in kinds)
        return tuple(self._conflict(index, kinds) for index in stuck)

    @cached_property
    def never(self) -> tuple[Conflict, ...]:
        """The changes that no kind settles, and why."""
        return tuple(conflict for conflict in self.conflicts(KINDS) if not conflict.accept)

    def taken(self, kinds: Collection[str]) -> AddressTable:
        """The table with the changes of these kinds. Order, foreign rows and unchanged rows stay."""
        taken = self.takes(kinds)
        rows: dict[Address, Row | None] = {}
        for change in taken:
            if change.before and change.kind in (MOVED, REMOVED):
                rows[change.before.address] = self._without_name(change.before)
        for change in taken:
            if change.after and change.kind in (ADDED, MOVED, RENAMED, SWAPPED):
                rows[change.after.address] = self._named(change.after, rows)
        for change in taken:
            if change.after and change.kind == CHANGED:
                stands = rows.get(change.after.address) or self.table.by_address[change.after.address]
                rows[change.after.address] = replace(change.after, nickname=stands.nickname)
        return self.table.changed(rows) if rows else self.table

    def _without_name(self, row: Row) -> Row | None:
        """The rest of a row when its name goes: what the export says of the address, if anything."""
        left = self.export.by_address.get(row.address)
        return left if left and not left.nickname and not left.is_default else None

    def _named(self, row: Row, rows: Mapping[Address, Row | None]) -> Row:
        """An export's row under its name; the table's settings for an address that stays are another question."""
        stands = self.table.by_address.get(row.address)
        if stands is None or stands.is_default or row.address in rows:
            return row
        return replace(stands, nickname=row.nickname)

    # -- conflicts ----------------------------------------------------------------------------------------------------

    @cached_property
    def _needs(self) -> list[_Needs]:
        """The needs of each change, in the order of the changes."""
        leaving = {
            change.before.address: index
            for index, change in enumerate(self.changes)
            if change.before and change.before.nickname and change.kind in (MOVED, REMOVED, RENAMED, SWAPPED)
        }
        needs: list[_Needs] = []
        for change in self.changes:
            rows = [*self._in_the_way(change)]
            standing = next((self._stands(change, row) for row in rows if row.address not in leaving), "")
            others = [(leaving[row.address], row) for row in rows if row.address in leaving]
            needs.append(_Needs(self._fault(change) or standing, others))
        return needs

    def _stuck(self, kinds: Collection[str]) -> set[int]:
        """The changes that are not of these kinds, or cannot be taken, or need one of those."""
        needed_by: dict[int, list[int]] = {}
        for index, needs in enumerate(self._needs):
            for other, _ in needs.others:
                needed_by.setdefault(other, []).append(index)
        waiting = [
            index
            for index, (change, needs) in enumerate(zip(self.changes, self._needs, strict=True))
            if change.kind not in kinds or needs.never
        ]
        stuck = set(waiting)
        for index in waiting:
            new = [other for other in needed_by.get(index, ()) if other not in stuck]
            stuck.update(new)
            waiting += new
        return stuck

    def _conflict(self, index: int, kinds: Collection[str]) -> Conflict:
        """The needs of a stuck change, followed through all that they need in turn."""
        change, reason = self.changes[index], ""
        waiting = [index]
        seen = {index}
        for each in waiting:
            never, others = self._needs[each]
            if never:
                return Conflict(change, never)
            for other, row in others:
                if self.changes[other].kind not in kinds:
                    reason = reason or self._stands(self.changes[each], row)
                if other not in seen:
                    seen.add(other)
                    waiting.append(other)
        needed = {self.changes[each].kind for each in seen}
        return Conflict(change, reason, tuple(kind for kind in KINDS if kind in needed))

    def _fault(self, change: Change) -> str:
        """The reason why a change can never be taken."""
        for row in (change.before, change.after and self.table.by_address.get(change.after.address)):
            if row is not None and row.cell is not None:
                return f"{row.address} stands in {self.table.place(row)}, and a workbook is changed by hand"
        after = change.after
        if after is not None and after.nickname:
            first = self.export.by_nickname[after.nickname.lower()]
            if first.address != after.address and first.address.bank not in OWN_BANKS:
                return f"the export gives {after.nickname} to {first.address} and to {after.address}"
        return self._declared_otherwise(change)

    def _declared_otherwise(self, change: Change) -> str:
        """The objection of a program's declaration to a change."""
        after = change.after
        if after is None or change.is_case_only:
            return ""
        here = self.says.declared_at.get(after.address)
        if change.kind == CHANGED:
            assert change.before is not None
            fixed = [what for what in differing(change.before, after) if here and _says_otherwise(here, what, after)]
            fields = " and ".join(fixed)
            return (
                f"{self.says.place_of(here)} gives {after.address} its {fields}: change it there"
                if here and fixed
                else ""
            )
        name = after.nickname.lower()
        there, block = self.says.declared.get(name), self.says.blocks.get(name)
        if there is not None and there.cell.address != after.address:
            return f"{after.nickname} is {there.cell.address} by {self.says.place_of(there)}"
        if block is not None:
            return f"{after.nickname} is a block by {self.says.place_of(block)}"
        # A rename in the programs reaches a declaration too.
        is_followed = change.before is not None and change.before.nickname.lower() == _lower(here)
        if name and here is not None and _lower(here) != name and not (change.kind == RENAMED and is_followed):
            return f"{after.address} is {here.named.name} by {self.says.place_of(here)}"
        return ""

    def _in_the_way(self, change: Change) -> Iterator[Row]:
        """The table's rows that have the name or the address that a change needs, except its own row."""
        after = change.after
        if after is None or not after.nickname or change.kind == CHANGED:
            return
        own = change.before.address if change.before else None
        for row in (self.table.by_address.get(after.address), self.table.by_nickname.get(after.nickname.lower())):
            if row is not None and row.nickname and row.address != own:
                yield row

    def _stands(self, change: Change, row: Row) -> str:
        assert change.after is not None
        place = self.table.place(row)
        if is_scratch(row):
            way = f"give {change.after.nickname} another address in CLICK, or delete that row"
            return f"{row.address} is {row.nickname}, which clickgen uses for itself ({place}): {way}"
        return f"{row.nickname} is {row.address} in the table ({place})"


def merge(
    table: AddressTable,
    export: AddressTable,
    used: Callable[[str], list[str]] | None = None,
    says: ProgramsSay | None = None,
) -> Merge:
    """Compare an export with the table, both without errors; an export that gives a name twice has conflicts.

    ``used`` gives the places where programs use a nickname, such as ``prog.py:12``; ``says`` is the rest of what they
    say.
    """
    ours = [row for row in table.rows if _is_shared(row) and not is_scratch(row)]
    changes = changes_between(ours, [row for row in export.rows if _is_shared(row) and _is_news(row, table)])
    if used is not None:
        changes = [replace(change, used=tuple(used(change.name))) if change.name else change for change in changes]
        changes = with_swaps(changes)
    if says is not None:
        changes = [replace(change, by_number=_by_number(change, says)) for change in changes]
    kept_apart = sum(row.address.bank in OWN_BANKS for row in export.rows)
    return Merge(table, export, tuple(changes), kept_apart, says or ProgramsSay())


def _by_number(change: Change, says: ProgramsSay) -> tuple[str, ...]:
    after = change.after
    gets_a_name = after is not None and after.nickname and change.kind in (ADDED, MOVED)
    return tuple(says.by_number(after.address)) if after is not None and gets_a_name else ()


def _lower(declaration: Declaration | None) -> str:
    return declaration.named.name.lower() if declaration else ""


def _says_otherwise(declaration: Declaration, what: str, row: Row) -> bool:
    """True if a declaration gives an address another initial value, retention or comment than a row."""
    if what == "initial" and declaration.initial is not None:
        return initial_of(declaration.initial, row.address, Diagnostics()) != row.initial
    said = {"retentive": declaration.retentive, "comment": declaration.comment}.get(what)
    return said is not None and said != getattr(row, what)


def _is_shared(row: Row) -> bool:
    """True for a row that says something and does not concern only CLICK itself."""
    return row.address.bank not in OWN_BANKS and not row.is_default


def _is_news(row: Row, table: AddressTable) -> bool:
    """False for an export's rows of clickgen's scratch cells, unless the table knows nothing of the cell."""
    stands = table.by_address.get(row.address)
    if stands is not None and is_scratch(stands) and row.nickname.lower() in ("", stands.nickname.lower()):
        return False
    return not is_scratch(row) or (stands is None and row.nickname.lower() not in table.by_nickname)
