"""The rungs of two sides: first those that stay, then those that moved, then those that resemble each other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import zip_longest

from clickgen.click.compare.outputs import Surroundings
from clickgen.click.compare.same import Comparison, Likeness, compare
from clickgen.commands.diff.changes import (
    ADDED,
    CHANGED,
    COMMENTED,
    MOVED,
    REMOVED,
    RENAMED,
    SAME,
    RoutineChange,
    RungChange,
)
from clickgen.commands.diff.match import Block, longest_common, most_like, same_together, single, steps
from clickgen.commands.diff.routines import Match, Routines
from clickgen.commands.diff.units import Unit, Units
from clickgen.commands.diff.words import WordedRung
from clickgen.device.banks import Address

Rungs = tuple[Sequence[WordedRung], Sequence[WordedRung]]
"""The compared part of a routine: the rungs of both sides that do anything."""


class RungDiff:
    """The rungs of all routines; ``scratch`` are the cells that clickgen took for itself on each side."""

    def __init__(
        self,
        first: Routines,
        second: Routines,
        matches: Sequence[Match],
        scratch: tuple[frozenset[Address], frozenset[Address]],
    ) -> None:
        self._first, self._second, self._matches = first, second, matches
        self._units = Units(first, scratch[0]), Units(second, scratch[1])
        self._compared: dict[tuple[tuple[int, ...], tuple[int, ...]], Comparison] = {}
        """By the identities of the rungs."""
        self._moves: dict[int, RungChange] = {}
        """By the identity of a rung, on both sides."""
        self._working = {match: self._rungs(match) for match in matches}
        self._shared: dict[Match, list[Block]] = {}
        """The rungs that stay, in order. Nothing is paired across them."""
        self._contradicted: dict[int, RungChange] = {}
        """Rungs in the same words that do not do the same, by the identity of the newer one."""
        self.drawn_otherwise = 0

    def routines(self) -> Iterator[RoutineChange]:
        for match in self._matches:
            rungs = self._working[match]
            self._shared[match] = self._staying(rungs)
            for block in self._shared[match]:
                self._note_drawing(*_held(rungs, block))
        self._find_moves()
        for match in self._matches:
            yield self._routine(match)

    def _rungs(self, match: Match, is_idle: bool = False) -> Rungs:
        one = self._first[match.one] if match.one is not None else ()
        other = self._second[match.other] if match.other is not None else ()
        return [rung for rung in one if rung.is_idle == is_idle], [rung for rung in other if rung.is_idle == is_idle]

    # -- rungs that stay ----------------------------------------------------------------------------------------------

    def _staying(self, rungs: Rungs) -> list[Block]:
        """Pair rungs in the same words; if many are alike, their outputs show better where each belongs."""
        found = list(self._in_words(rungs))
        if _size(found) == sum(map(len, rungs)):
            return found
        return max(found, list(self._proven(rungs, _whole(rungs))), key=_size)

    def _in_words(self, rungs: Rungs) -> Iterator[Block]:
        """Yield the rungs that stay: in the same words, or between such ones the same however they are drawn."""
        left, right = (units.of(held, range(len(held))) for units, held in zip(self._units, rungs, strict=True))
        common = longest_common([unit.words for unit in left], [unit.words for unit in right])
        shared = [Block(left[i].places, right[j].places) for i, j in common]
        for is_shared, block in steps(shared, _whole(rungs)):
            if is_shared:
                yield block
            else:
                yield from self._in_gap(rungs, block)

    def _in_gap(self, rungs: Rungs, gap: Block) -> Iterator[Block]:
        one, other = ([rung.words for rung in held] for held in _held(rungs, gap))
        common = longest_common(one, other)
        shared = [single((gap.one.start + i, gap.other.start + j)) for i, j in common]
        for is_shared, block in steps(shared, gap):
            if is_shared:
                yield block
            else:
                yield from self._proven(rungs, block)

    def _proven(self, rungs: Rungs, within: Block) -> Iterator[Block]:
        """Yield rungs proven to do the same: one, or several if a build or a person divides one."""
        left, right = (units.of(held, places) for units, held, places in zip(self._units, rungs, within, strict=True))
        for block in same_together([unit.outputs for unit in left], [unit.outputs for unit in right]):
            one, other = left[block.one.start : block.one.stop], right[block.other.start : block.other.stop]
            found = Block(_spanned(one), _spanned(other))
            if self._compare(*_held(rungs, found)).is_same:
                yield found

    def _compare(self, one: Sequence[WordedRung], other: Sequence[WordedRung]) -> Comparison:
        key = (tuple(map(id, one)), tuple(map(id, other)))
        if key not in self._compared:
            before, after = ([rung.drawn for rung in held] for held in (one, other))
            if len(one) == len(other) == 1:
                self._compared[key] = compare(before, after)
            else:
                older, newer = self._units
                self._compared[key] = compare(before, after, older.own(one), self._surroundings, newer.own(other))
        return self._compared[key]

    @cached_property
    def _surroundings(self) -> Surroundings:
        """The cells that subroutines may change and messages bring, on either side."""
        names = {*self._first, *self._second}
        both = {name: (*self._first.get(name, ()), *self._second.get(name, ())) for name in sorted(names)}
        return Surroundings.of({name: [rung.drawn for rung in rungs] for name, rungs in both.items()})

    def _note_drawing(self, one: Sequence[WordedRung], other: Sequence[WordedRung]) -> None:
        """Rungs in the same words are the same, unless they are drawn differently and are known to differ."""
        if len(one) != len(other):
            self.drawn_otherwise += len(other)
            return
        for before, after in zip(one, other, strict=True):
            comparison = self._compare([before], [after])
            if comparison.likeness is Likeness.DIFFERENT and before.words == after.words:
                self._contradicted[id(after)] = RungChange(CHANGED, before, after, comparison.reason, is_drawn=True)
            elif comparison.likeness is not Likeness.IDENTICAL or before.shown.words != after.shown.words:
                self.drawn_otherwise += 1

    # -- rungs that moved ---------------------------------------------------------------------------------------------

    def _find_moves(self) -> None:
        """Pair the rungs left over in the same words, first in one routine, then anywhere."""
        left: defaultdict[tuple[str, ...], list[tuple[Match, WordedRung]]] = defaultdict(list)
        for match in self._matches:
            for rung in self._left_over(match)[0]:
                left[rung.lines].append((match, rung))
        for is_near in (True, False):
            for match in self._matches:
                for rung in self._left_over(match)[1]:
                    if id(rung) in self._moves:
                        continue
                    fitting = [each for each in left[rung.lines] if (each[0] == match) == is_near]
                    if fitting and (is_near or not rung.is_plain):
                        left[rung.lines].remove(fitting[0])
                        self._move(fitting[0][1], rung)

    def _left_over(self, match: Match) -> Rungs:
        """The rungs of both sides that have no counterpart."""
        rungs = self._working[match]
        found = [_held(rungs, block) for is_shared, block in self._steps(match) if not is_shared]
        return [rung for one, _ in found for rung in one], [rung for _, other in found for rung in other]

    def _steps(self, match: Match) -> Iterator[tuple[bool, Block]]:
        return steps(self._shared[match], _whole(self._working[match]))

    def _move(self, one: WordedRung, other: WordedRung) -> None:
        self._note_drawing([one], [other])
        contradicted = self._contradicted.pop(id(other), None)
        moved = replace(contradicted, kind=MOVED) if contradicted else RungChange(MOVED, one, other)
        self._moves[id(one)] = self._moves[id(other)] = moved

    # -- reported changes ---------------------------------------------------------------------------------------------

    def _routine(self, match: Match) -> RoutineChange:
        rungs = self._working[match]
        changes: list[RungChange] = []
        for is_shared, block in self._steps(match):
            one, other = _held(rungs, block)
            if not is_shared:
                changes += self._gap(one, other)
                continue
            contradicted = [self._contradicted[id(rung)] for rung in other if id(rung) in self._contradicted]
            if contradicted:
                changes += contradicted
            else:
                changes += _commented(one, other)
        changes += self._idle(match)
        count = len((self._first if match.other is None else self._second)[match.other or match.one or ""])
        if match.other is None:
            return RoutineChange(REMOVED, match.one or "", "", count, tuple(changes))
        kind = ADDED if match.one is None else RENAMED if match.is_renamed else SAME
        former = match.one if match.one is not None and match.one != match.other else ""
        return RoutineChange(kind, match.other, former, count, tuple(changes))

    def _idle(self, match: Match) -> Iterator[RungChange]:
        """The changes among the rungs that do nothing: comments, which are not logic."""
        one, other = rungs = self._rungs(match, is_idle=True)
        common = longest_common([rung.comment for rung in one], [rung.comment for rung in other])
        for is_shared, block in steps(map(single, common), _whole(rungs)):
            if is_shared:
                continue
            before, after = _held(rungs, block)
            for old, new in zip_longest(before, after):
                yield RungChange(COMMENTED, old, new)

    def _gap(self, one: Sequence[WordedRung], other: Sequence[WordedRung]) -> Iterator[RungChange]:
        """The changes between rungs that stay, in the order of the newer side."""
        left, right = ([n for n, rung in enumerate(rungs) if id(rung) not in self._moves] for rungs in (one, other))
        pairs = most_like([one[n].features for n in left], [other[n].features for n in right])
        rungs = (one, other)
        for is_pair, block in steps([single((left[i], right[j])) for i, j in pairs], _whole(rungs)):
            before, after = _held(rungs, block)
            if is_pair:
                yield from self._changed(before[0], after[0])
                continue
            for rung in before:
                yield from self._leaving(rung)
            for rung in after:
                yield self._moves.get(id(rung)) or RungChange(ADDED, None, rung)

    def _leaving(self, rung: WordedRung) -> Iterator[RungChange]:
        """A rung of the older side that is no longer here; one that moved in its routine is reported where it is."""
        moved = self._moves.get(id(rung))
        if moved is None:
            yield RungChange(REMOVED, rung, None)
        elif moved.other and not self._is_near(moved):
            yield moved

    def _is_near(self, moved: RungChange) -> bool:
        assert moved.one
        assert moved.other
        return any(match.one == moved.one.routine and match.other == moved.other.routine for match in self._matches)

    def _changed(self, one: WordedRung, other: WordedRung) -> Iterator[RungChange]:
        comparison = self._compare([one], [other])
        if not comparison.is_same:
            yield RungChange(CHANGED, one, other, comparison.reason, comparison.likeness is Likeness.UNKNOWN)
            return
        self.drawn_otherwise += 1
        yield from _commented([one], [other])


def _whole(rungs: Rungs) -> Block:
    return Block(range(len(rungs[0])), range(len(rungs[1])))


def _held(rungs: Rungs, block: Block) -> Rungs:
    one, other = rungs
    return one[block.one.start : block.one.stop], other[block.other.start : block.other.stop]


def _size(blocks: Sequence[Block]) -> int:
    return sum(len(block.one) + len(block.other) for block in blocks)


def _spanned(units: Sequence[Unit]) -> range:
    return range(units[0].places.start, units[-1].places.stop)


def _commented(one: Sequence[WordedRung], other: Sequence[WordedRung]) -> Iterator[RungChange]:
    """The differing comments of rungs that do the same; how many rungs share them does not count."""
    before, after = ([rung for rung in rungs if rung.comment] for rungs in (one, other))
    for old, new in zip_longest(before, after):
        if old is None or new is None or old.comment != new.comment:
            yield RungChange(COMMENTED, old or one[-1], new or other[-1])
