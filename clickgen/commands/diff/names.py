"""The nicknames that differ, in the words of ``clickgen nicknames merge``. A PLC does not know them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from clickgen.commands.diff.sides import Side
from clickgen.commands.nicknames.changed_rows import diff_lines
from clickgen.commands.nicknames.changes import ADDED, CHANGED, Change, differing
from clickgen.commands.nicknames.merge import merge
from clickgen.table.rows import is_scratch

_SHOWN = 10


@dataclass(frozen=True)
class NameChanges:
    """A line for each difference of names and of the comments of addresses."""

    lines: tuple[str, ...] = ()

    @property
    def shown(self) -> Iterable[str]:
        """The first lines, and how many more there are."""
        more = len(self.lines) - _SHOWN
        return (*self.lines[:_SHOWN], *([f"and {more} more"] if more > 0 else []))


def name_changes(one: Side, other: Side) -> NameChanges:
    """The differences of names and comments between the tables of both sides; none if a side has no table."""
    if one.table is None or other.table is None:
        return NameChanges()
    found = merge(one.table, other.table)
    kept = tuple(change for change in found.changes if _is_about_names(change))
    return NameChanges(tuple(diff_lines(replace(found, changes=kept))))


def _is_about_names(change: Change) -> bool:
    """False if only initial values or retention differ, which do not concern names, and for clickgen's own cells."""
    if change.kind == CHANGED and change.before and change.after:
        return differing(change.before, change.after) == ["comment"]
    rows = [row for row in (change.before, change.after) if row is not None]
    if all(map(is_scratch, rows)):
        return False
    return change.kind != ADDED or any(row.nickname or row.comment for row in rows)
