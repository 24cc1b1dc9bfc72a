"""A merge in words: what differs, what stands in the way, and how much there is of each kind."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from clickgen.nicknames.changes import ADDED, KINDS, MOVED, REMOVED, RENAMED, Change, differing
from clickgen.nicknames.merge import Merge
from clickgen.resolve.rows import Row
from clickgen.wording import counted

_PLACES_SHOWN = 3


def diff_lines(merge: Merge, kinds: Collection[str] = KINDS) -> list[str]:
    """The changes of these kinds, a line for each, whether or not they can be taken."""
    known = merge.table.by_nickname
    return [_line(change, known) for change in merge.of(kinds)]


def conflict_lines(merge: Merge, kinds: Collection[str]) -> list[str]:
    """What of these kinds cannot be taken, why, and which kinds settle it."""
    known = merge.table.by_nickname
    lines = []
    for conflict in merge.conflicts(kinds):
        settled = f"; --accept {','.join(conflict.accept)} takes both" if conflict.accept else ""
        lines.append(f"! {_line(conflict.change, known)}: {conflict.reason}{settled}")
    return lines


def summary(merge: Merge) -> str:
    """``2 added, 1 renamed; 344 rows of SC and SD kept apart``, or that nothing differs."""
    counts = [f"{len(merge.of([kind]))} {kind}" for kind in KINDS if merge.of([kind])]
    apart = f"; {counted(merge.kept_apart, 'row')} of SC and SD kept apart" if merge.kept_apart else ""
    return (", ".join(counts) or "nothing differs") + apart


def _line(change: Change, known: Mapping[str, Row]) -> str:
    before, after = change.before, change.after
    if before is None or change.kind == ADDED:
        assert after is not None
        return f"+ {_shown(after)}"
    if change.kind == REMOVED or after is None:
        return f"- {_shown(before)}{_notes(_uses(change, 'nothing refers to it' if before.nickname else ''))}"
    if change.kind == MOVED:
        spelled = "" if before.nickname == after.nickname else f", now {after.nickname}"
        return f"> {before.nickname} {before.address} -> {after.address}{_notes(['moved' + spelled, *_uses(change)])}"
    if change.kind == RENAMED:
        notes = ["renamed", *_uses(change)]
        other = known.get(after.nickname.lower())
        if change.is_case_only:
            notes = ["renamed, in capital letters only"]
        elif other is not None:
            notes.insert(1, f"{other.nickname} was {other.address}")
        return f"~ {before.address} {before.nickname} -> {after.nickname}{_notes(notes)}"
    fields = [f"{field} {_said(before, field)} -> {_said(after, field)}" for field in differing(before, after)]
    return f"~ {_shown(after if after.nickname == before.nickname else before)}: {', '.join(fields)}"


def _said(row: Row, field: str) -> str:
    if field == "initial":
        return row.initial or "nothing"
    return f'"{row.comment}"' if field == "comment" else "Yes" if row.retentive else "No"


def _shown(row: Row) -> str:
    return f"{row.address} {row.nickname}" if row.nickname else f"{row.address} without a name"


def _uses(change: Change, unused: str = "") -> list[str]:
    if change.used is None:
        return []
    if not change.used:
        return [unused] if unused else []
    more = len(change.used) - _PLACES_SHOWN
    return [f"used at {', '.join(change.used[:_PLACES_SHOWN])}{f' and {more} more' if more > 0 else ''}"]


def _notes(notes: Iterable[str]) -> str:
    text = "; ".join(notes)
    return f" ({text})" if text else ""
