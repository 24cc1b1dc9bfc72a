"""Chooses which routines of two sides are compared."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from clickgen.click.read.project import MAIN
from clickgen.commands.diff.sides import Side
from clickgen.commands.diff.words import WordedRung

Routines = Mapping[str, Sequence[WordedRung]]


@dataclass(frozen=True)
class Match:
    """A routine by its name on each side; None if a side does not have it."""

    one: str | None
    other: str | None
    is_renamed: bool = False


def matching(one: Side, other: Side, first: Routines, second: Routines) -> tuple[tuple[Match, ...], tuple[str, ...]]:
    """Return the routines to compare, main first, then by name; and notes on the choice."""
    if one.is_part or other.is_part:
        return _parts(one, other, first, second)
    pairs = {name: name for name in first if name in second}
    gone, new = ([name for name in these if name not in those] for these, those in ((first, second), (second, first)))
    for name in gone:
        same = next((other for other in new if _is_renamed(first[name], second[other])), None)
        if same is not None:
            pairs[name] = same
            new.remove(same)
    found = [Match(name, pairs.get(name), pairs.get(name, name) != name) for name in first]
    found += [Match(None, name) for name in new]
    return tuple(sorted(found, key=_order)), ()


def _order(match: Match) -> tuple[bool, str]:
    name = match.other or match.one or ""
    return (name != MAIN, name)


def _is_renamed(one: Sequence[WordedRung], other: Sequence[WordedRung]) -> bool:
    is_something = any(not rung.is_plain for rung in one)
    return is_something and [rung.words for rung in one] == [rung.words for rung in other]


def _parts(one: Side, other: Side, first: Routines, second: Routines) -> tuple[tuple[Match, ...], tuple[str, ...]]:
    """Compare a file with one routine with one routine: by its name, and if it has none by its contents."""
    if len(first) == len(second) == 1:
        return (Match(next(iter(first)), next(iter(second))),), ()
    is_first = one.is_part
    part, whole = (first, second) if is_first else (second, first)
    [(name, rungs)] = part.items()
    if name == MAIN or name not in whole:
        lines = Counter(rung.lines for rung in rungs if not rung.is_plain)
        shared = {
            each: sum((lines & Counter(rung.lines for rung in whole[each])).values())
            for each in sorted(whole, key=lambda each: (each != name, each != MAIN, each))
        }
        best = max(shared, key=lambda each: shared[each])
    else:
        best = name
    match = Match(name, best) if is_first else Match(best, name)
    side = one if is_first else other
    return (match,), (f"{side.shown} is one routine, which is compared with {best} alone",)
