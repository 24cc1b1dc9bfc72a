"""A difference as JSON: its form is that of ``docs/diff.md``; ``version`` rises when it changes."""

from __future__ import annotations

from collections.abc import Sequence

from clickgen.commands.diff.as_text import change_lines, summary
from clickgen.commands.diff.changes import KINDS, Difference, RoutineChange, RungChange
from clickgen.commands.diff.names import name_changes
from clickgen.commands.diff.pairs import Pair
from clickgen.commands.diff.words import WordedRung, named
from clickgen.emit.rung_words import Names
from clickgen.text.wording import json_text

VERSION = 1


def render(compared: Sequence[tuple[Pair, Difference | None]]) -> str:
    """Return one object for a difference; for several, one that has them all in ``programs``.

    A program with errors has no difference, and one on its own gives nothing to write.
    """
    if len(compared) == 1:
        [(pair, difference)] = compared
        return "" if difference is None else json_text(_difference(pair, difference), indent=2) + "\n"
    programs = [
        _difference(pair, difference) if difference is not None else _broken(pair) for pair, difference in compared
    ]
    differs = any(difference is None or difference.differs for _, difference in compared)
    return json_text({"version": VERSION, "differs": differs, "programs": programs}, indent=2) + "\n"


def _broken(pair: Pair) -> dict[str, object]:
    """A program that could not be compared: nobody knows whether it differs."""
    return {"version": VERSION, "old": pair.one, "new": pair.other, "differs": None}


def _difference(pair: Pair, difference: Difference) -> dict[str, object]:
    """The whole difference of two sides; null for a side that does not exist."""
    names = name_changes(difference.one, difference.other)
    return {
        "version": VERSION,
        "old": None if pair.is_new else difference.one.shown,
        "new": None if pair.is_gone else difference.other.shown,
        "differs": difference.differs,
        "summary": summary(difference, names),
        "rungs": {kind: difference.count(kind) for kind in KINDS} | {"drawn_otherwise": difference.drawn_otherwise},
        "routines": [_routine(each, difference) for each in difference.routines if each.differs or each.changes],
        "addresses": [
            {"address": str(each.address), "what": each.what, "old": each.one, "new": each.other}
            for each in difference.values
        ],
        "nicknames": list(names.lines),
        "notes": list(difference.notes),
    }


def _routine(routine: RoutineChange, difference: Difference) -> dict[str, object]:
    return {
        "name": routine.name,
        "old_name": routine.former or None,
        "kind": routine.kind,
        "rungs": routine.rungs,
        "changes": [_change(change, difference) for change in routine.changes],
    }


def _change(change: RungChange, difference: Difference) -> dict[str, object]:
    before, after = difference.names
    return {
        "kind": change.kind,
        "reason": change.reason,
        "old": _rung(change.one, before),
        "new": _rung(change.other, after),
        "lines": [f"{line.mark} {line.text}" for line in change_lines(change, difference)],
    }


def _rung(rung: WordedRung | None, names: Names) -> dict[str, object] | None:
    if rung is None:
        return None
    return {
        "routine": rung.routine,
        "number": rung.number,
        "comment": "\n".join(rung.comment),
        "words": [named(line, names) for line in rung.shown.lines],
    }
