"""A merge in words: the differences, the conflicts, and how many there are of each kind."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from clickgen.commands.nicknames.changes import ADDED, KINDS, MOVED, REMOVED, RENAMED, SWAPPED, Change, differing
from clickgen.commands.nicknames.merge import Conflict, Merge
from clickgen.table.rows import Row
from clickgen.text.wording import counted

_PLACES_SHOWN = 3


def diff_lines(merge: Merge, kinds: Collection[str] = KINDS) -> list[str]:
    """The changes of these kinds, a line for each, whether or not they can be taken."""
    return [_line(change, merge) for change in merge.of(kinds)]


def conflict_lines(merge: Merge, kinds: Collection[str]) -> list[str]:
    """The changes of these kinds that cannot be taken, why, and which kinds settle them."""
    return [_conflict_line(conflict, merge) for conflict in merge.conflicts(kinds)]


def never_lines(merge: Merge, kinds: Collection[str]) -> list[str]:
    """The changes of the other kinds that can never be taken, and why."""
    return [_conflict_line(conflict, merge) for conflict in merge.never if conflict.change.kind not in kinds]


def _conflict_line(conflict: Conflict, merge: Merge) -> str:
    settled = f"; --accept {','.join(conflict.accept)} takes both" if conflict.accept else ""
    return f"! {_line(conflict.change, merge)}: {conflict.reason}{settled}"


def summary(merge: Merge) -> str:
    """``2 added, 1 renamed; 344 rows of SC and SD kept apart``, or that nothing differs."""
    counts = [f"{len(merge.of([kind]))} {kind}" for kind in KINDS if merge.of([kind])]
    apart = f"; {counted(merge.kept_apart, 'row')} of SC and SD kept apart" if merge.kept_apart else ""
    return (", ".join(counts) or "nothing differs") + apart


def _line(change: Change, merge: Merge) -> str:
    before, after = change.before, change.after
    if before is None or change.kind == ADDED:
        assert after is not None
        return f"+ {_shown(after)}{_notes(_numbers(change))}"
    if change.kind == REMOVED or after is None:
        return f"- {_shown(before)}{_notes(_uses(change, 'nothing refers to it' if before.nickname else ''))}"
    if change.kind == MOVED:
        spelled = "" if before.nickname == after.nickname else f", now {after.nickname}"
        notes = ["moved" + spelled, *_uses(change), *_numbers(change)]
        return f"> {before.nickname} {before.address} -> {after.address}{_notes(notes)}"
    if change.kind in (RENAMED, SWAPPED):
        notes = [change.kind, *_uses(change)]
        other = merge.table.by_nickname.get(after.nickname.lower())
        new = merge.export.by_nickname.get(before.nickname.lower())
        if change.is_case_only:
            notes = ["renamed, in capital letters only"]
        elif other is not None:
            notes.insert(1, f"{other.nickname} was {other.address}")
        if change.kind == SWAPPED and new is not None and change.used:
            notes.insert(-1, f"programs that say {before.nickname} use {new.address} then")
        return f"~ {before.address} {before.nickname} -> {after.nickname}{_notes(notes)}"
    fields = [f"{field} {_said(before, field)} -> {_said(after, field)}" for field in differing(before, after)]
    return f"~ {_shown(after if after.nickname == before.nickname else before)}: {', '.join(fields)}"


def _said(row: Row, field: str) -> str:
    if field == "initial":
        return row.initial or "nothing"
    return f'"{row.comment}"' if field == "comment" else "Yes" if row.retentive else "No"


def _shown(row: Row) -> str:
    return f"{row.address} {row.nickname}" if row.nickname else f"{row.address} without a name"


def _numbers(change: Change) -> list[str]:
    assert change.after is not None
    return [f"{change.after.address} is used by its number at {_places(change.by_number)}"] if change.by_number else []


def _uses(change: Change, unused: str = "") -> list[str]:
    if change.used is None:
        return []
    if not change.used:
        return [unused] if unused else []
    return [f"used at {_places(change.used)}"]


def _places(places: Sequence[str]) -> str:
    more = len(places) - _PLACES_SHOWN
    return f"{', '.join(places[:_PLACES_SHOWN])}{f' and {more} more' if more > 0 else ''}"


def _notes(notes: Iterable[str]) -> str:
    text = "; ".join(notes)
    return f" ({text})" if text else ""
