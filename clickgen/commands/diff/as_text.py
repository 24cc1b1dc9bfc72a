"""A difference for a person: routines and rungs, ``-`` as it was and ``+`` as it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from typing import NamedTuple

from clickgen.commands.diff.changes import (
    ADDED,
    CHANGED,
    COMMENTED,
    MOVED,
    REMOVED,
    RENAMED,
    Difference,
    RoutineChange,
    RungChange,
    ValueChange,
)
from clickgen.commands.diff.names import NameChanges
from clickgen.commands.diff.words import WordedRung, named
from clickgen.emit.rung_words import Names
from clickgen.text.wording import counted

_RUNGS_SHOWN = 20
"""For a larger routine that came or went, only the number of its rungs is given."""


class Line(NamedTuple):
    """A line with its mark: ``-``, ``+``, or a space for a line that stays."""

    mark: str
    text: str


def report(difference: Difference, names: NameChanges) -> Iterator[Line]:
    """Everything that differs, and the summary at the end; the mark of a line is in its text, too."""
    yield from _plain(f"--- {difference.one.shown}", f"+++ {difference.other.shown}", "")
    for routine in difference.routines:
        if routine.differs or routine.changes:
            yield from _routine(routine, difference)
            yield from _plain("")
    if difference.values:
        yield from _plain(
            "Addresses", *(f"  {_value(change, difference.names[1])}" for change in difference.values), ""
        )
    if names.lines:
        yield from _plain("Nicknames", *(f"  {line}" for line in names.shown), "")
    yield from _plain(*summary(difference, names))


def _plain(*texts: str) -> Iterator[Line]:
    return (Line(" ", text) for text in texts)


def summary(difference: Difference, names: NameChanges) -> list[str]:
    """How many there are of everything, and what could not be judged."""
    if difference.differs:
        said = _counts(difference)
    else:
        routines = counted(len(difference.routines), "routine")
        said = f"No difference in logic: {counted(difference.rungs, 'rung')} in {routines}."
    others = [
        (difference.count(COMMENTED), "comment changed", "comments changed"),
        (difference.drawn_otherwise, "rung is drawn otherwise", "rungs are drawn otherwise"),
        (len(names.lines), "nickname or its comment differs", "nicknames or their comments differ"),
    ]
    besides = [counted(count, one, many) for count, one, many in others if count]
    lines = [said, *([f"Without effect on the PLC: {', '.join(besides)}."] if besides else [])]
    return [*lines, *(f"Note: {note}." for note in difference.notes)]


def _counts(difference: Difference) -> str:
    """``2 rungs changed, 1 added in 2 routines; 1 routine removed.``"""
    counts = [(difference.count(kind), kind) for kind in (CHANGED, ADDED, REMOVED, MOVED)]
    found = [(count, kind) for count, kind in counts if count]
    rungs = [f"{counted(count, 'rung') if not n else count} {kind}" for n, (count, kind) in enumerate(found)]
    touched = sum(any(change.is_logic for change in routine.counted) for routine in difference.routines)
    parts = [f"{', '.join(rungs)} in {counted(touched, 'routine')}"] if rungs else []
    for kind in (ADDED, REMOVED, RENAMED):
        routines = sum(routine.kind == kind for routine in difference.routines)
        parts += [f"{counted(routines, 'routine')} {kind}"] if routines else []
    if difference.values:
        parts.append(f"{counted(len(difference.values), 'address setting')} changed")
    return "; ".join(parts) + "."


# -- routines and rungs -----------------------------------------------------------------------------------------------


def _routine(routine: RoutineChange, difference: Difference) -> Iterator[Line]:
    size = f"({counted(routine.rungs, 'rung')})"
    if routine.kind in (ADDED, REMOVED):
        yield Line("-" if routine.kind == REMOVED else "+", f"{routine.name} {routine.kind} {size}")
    elif routine.kind == RENAMED:
        yield Line(" ", f"{routine.former} renamed to {routine.name} {size}")
    else:
        yield Line(" ", f"{routine.former} and {routine.name}" if routine.former else routine.name)
    changes = routine.changes if routine.rungs <= _RUNGS_SHOWN else routine.counted
    for change in changes:
        yield Line(" ", f"  {headline(change, routine)}")
        for line in change_lines(change, difference):
            yield Line(line.mark, f"    {line.mark} {line.text}".rstrip())


def headline(change: RungChange, routine: RoutineChange) -> str:
    """``rung 4, now rung 5, changed``; a rung that moved is described from the routine that it is shown in."""
    one, other = change.one, change.other
    if one is None or other is None:
        rung = one or other
        assert rung is not None
        if change.kind == COMMENTED:
            return f"rung {rung.number}, which does nothing, {ADDED if one is None else REMOVED}"
        return f"rung {rung.number} {change.kind}"
    if change.kind == MOVED and one.routine != other.routine and one.routine != routine.former:
        if other.routine == routine.name and routine.kind != REMOVED:
            text = f"rung {other.number} moved here from {one.routine} rung {one.number}"
        else:
            text = f"rung {one.number} moved to {other.routine} rung {other.number}"
    elif change.kind == MOVED:
        text = f"rung {one.number} moved to rung {other.number}"
    else:
        number = f"rung {one.number}" if one.number == other.number else f"rung {one.number}, now rung {other.number},"
        text = f"{number} {'comment changed' if change.kind == COMMENTED else 'changed'}"
    if change.is_drawn:
        return f"{text}, which its words do not show ({change.reason})"
    return f"{text}, as far as is known ({change.reason})" if change.is_unknown else text


def change_lines(change: RungChange, difference: Difference) -> Iterator[Line]:
    """The lines of a change: the comment, then the rung in words."""
    one, other = change.one, change.other
    before, after = difference.names
    if one is None or other is None:
        rung, mark, names = (other, "+", after) if other is not None else (one, "-", before)
        assert rung is not None
        yield from (Line(mark, f"| {line}".rstrip()) for line in rung.comment)
        yield from (Line(mark, named(line, names)) for line in rung.shown.lines)
        return
    yield from _comment_lines(one, other)
    if change.kind == COMMENTED:
        return
    if change.is_drawn:
        cells = difference.wording.cells
        yield from _compared(cells(one), cells(other), difference.names)
    else:
        yield from _compared(one.shown.lines, other.shown.lines, difference.names)


def _comment_lines(one: WordedRung, other: WordedRung) -> Iterator[Line]:
    """The comments if they differ; else the first line, which says what the rung is for."""
    if one.comment != other.comment:
        before, after = ([f"| {line}".rstrip() for line in rung.comment] for rung in (one, other))
        yield from _compared(before, after, (Names({}), Names({})))
    elif other.comment:
        more = " …" if len(other.comment) > 1 else ""
        yield Line(" ", f"| {other.comment[0]}{more}")


def _compared(one: Sequence[str], other: Sequence[str], names: tuple[Names, Names]) -> Iterator[Line]:
    """Lines of both sides, those that they share once and with the newer names."""
    before, after = names
    for _, i, i_end, j, j_end in SequenceMatcher(None, one, other, autojunk=False).get_opcodes():
        if one[i:i_end] == other[j:j_end]:
            yield from (Line(" ", named(line, after)) for line in other[j:j_end])
        else:
            yield from (Line("-", named(line, before)) for line in one[i:i_end])
            yield from (Line("+", named(line, after)) for line in other[j:j_end])


# -- addresses --------------------------------------------------------------------------------------------------------


def _value(change: ValueChange, names: Names) -> str:
    nickname = names.nickname(change.address)
    shown = f"{change.address}:{nickname}" if nickname else str(change.address)
    return f"{shown}: {change.what} {change.one} -> {change.other}"
