"""A difference as JSON: its form is that of ``docs/diff.md`` and stays, or ``version`` rises."""

from __future__ import annotations

from clickgen.commands.diff.as_text import change_lines, summary
from clickgen.commands.diff.changes import KINDS, Difference, RoutineChange, RungChange
from clickgen.commands.diff.names import NameChanges
from clickgen.commands.diff.words import WordedRung, named
from clickgen.emit.rung_words import Names
from clickgen.text.wording import json_text

VERSION = 1


def render(difference: Difference, names: NameChanges) -> str:
    """The whole difference as one object."""
    tree = {
        "version": VERSION,
        "old": difference.one.shown,
        "new": difference.other.shown,
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
    return json_text(tree, indent=2) + "\n"


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
