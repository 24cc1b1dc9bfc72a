"""The rungs of two sides: first what stays, then what moved, then what resembles each other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property

from clickgen.comparing.outputs import Writes, writes_of
from clickgen.comparing.same import Comparison, Likeness, compare
from clickgen.device.banks import Address
from clickgen.diffing.changes import ADDED, CHANGED, COMMENTED, MOVED, REMOVED, RENAMED, SAME, RoutineChange, RungChange
from clickgen.diffing.match import Gap, Pair, gaps, longest_common, most_like
from clickgen.diffing.routines import Match, Routines
from clickgen.diffing.units import Unit, Units
from clickgen.diffing.words import WordedRung


class RungDiff:
    """The rungs of all routines; ``scratch`` are the cells that clickgen took for itself on either side."""

    def __init__(
        self, first: Routines, second: Routines, matches: Sequence[Match], scratch: frozenset[Address]
    ) -> None:
        self._first, self._second, self._matches = first, second, matches
        self._units = Units(first, scratch), Units(second, scratch)
        self._settled: dict[int, RungChange | None] = {}
        """Rungs that only together do the same as others, by their identity, and what is to be said of them."""
        self._compared: dict[tuple[int, int], Comparison] = {}
        self._moves: dict[int, RungChange] = {}
        """By the identity of a rung, on both sides."""
        self._pairs: dict[Match, list[Pair]] = {}
        self._contradicted: dict[int, RungChange] = {}
        """Rungs in the same words that do not do the same, by the identity of the newer one."""
        self.drawn_otherwise = 0

    def routines(self) -> Iterator[RoutineChange]:
        for match in self._matches:
            self._pairs[match] = list(self._equal(*self._rungs(match)))
        self._find_moves()
        for match in self._matches:
            yield self._routine(match)

    def _rungs(self, match: Match) -> tuple[Sequence[WordedRung], Sequence[WordedRung]]:
        one = self._first[match.one] if match.one is not None else ()
        other = self._second[match.other] if match.other is not None else ()
        return one, other

    def _equal(self, one: Sequence[WordedRung], other: Sequence[WordedRung]) -> Iterator[Pair]:
        """The rungs that stay what they are: in the same words, or between such the same however it is drawn."""
        left, right = self._units[0].of(one), self._units[1].of(other)
        common = longest_common([unit.words for unit in left], [unit.words for unit in right])
        for step in _steps(common, left, right):
            if isinstance(step, Gap):
                before = [rung for n in step.one for rung in left[n].rungs]
                after = [rung for n in step.other for rung in right[n].rungs]
                yield from self._equal_in_gap(before, after)
            else:
                yield from self._equal_in_units(left[step[0]], right[step[1]])

    def _equal_in_units(self, one: Unit, other: Unit) -> Iterator[Pair]:
        """Units in the same words, but for the numbers of their scratch cells, which nobody else uses."""
        pairs = [*zip(one.rungs, other.rungs, strict=True)]
        renumbered = [before for before, after in pairs if before.lines != after.lines]
        self.drawn_otherwise += len(renumbered)
        for before, after in pairs:
            if not renumbered:
                self._note_drawing(before, after)
            yield before.number - 1, after.number - 1

    def _equal_in_gap(self, one: Sequence[WordedRung], other: Sequence[WordedRung]) -> Iterator[Pair]:
        common = longest_common([rung.lines for rung in one], [rung.lines for rung in other])
        for step in _steps(common, one, other):
            if not isinstance(step, Gap):
                before, after = one[step[0]], other[step[1]]
                self._note_drawing(before, after)
                yield before.number - 1, after.number - 1
                continue
            left = self._units[0].of([one[n] for n in step.one])
            right = self._units[1].of([other[n] for n in step.other])
            for i, j in longest_common([unit.outputs for unit in left], [unit.outputs for unit in right]):
                if len(left[i].rungs) > 1 or len(right[j].rungs) > 1:
                    self._settle(left[i], right[j])
                    continue
                [before], [after] = left[i].rungs, right[j].rungs
                if self._compare(before, after).is_same:
                    self.drawn_otherwise += 1
                    yield before.number - 1, after.number - 1

    def _settle(self, one: Unit, other: Unit) -> None:
        """Takes out rungs that together do the same, as where one of both sides needs a scratch bit."""
        if not self._compare_units(one, other).is_same:
            return
        self.drawn_otherwise += len(other.rungs)
        self._settled |= {id(rung): None for rung in (*one.rungs, *other.rungs)}
        if one.rungs[0].comment != other.rungs[0].comment:
            self._settled[id(other.rungs[0])] = RungChange(COMMENTED, one.rungs[0], other.rungs[0])

    def _compare_units(self, one: Unit, other: Unit) -> Comparison:
        older, newer = self._units
        cells = (*older.cells(one), *newer.cells(other))
        scratch = [address for address in cells if older.keeps(address, one) and newer.keeps(address, other)]
        before, after = ([rung.drawn for rung in unit.rungs] for unit in (one, other))
        return compare(before, after, scratch, self._calls)

    @cached_property
    def _calls(self) -> dict[str, Writes]:
        """What subroutines may change, on either side."""
        names = {*self._first, *self._second}
        routines = {name: (*self._first.get(name, ()), *self._second.get(name, ())) for name in names}
        return {name: writes_of(rung.drawn for rung in rungs) for name, rungs in routines.items()}

    def _note_drawing(self, one: WordedRung, other: WordedRung) -> None:
        """Rungs in the same words are the same, unless they are drawn otherwise and it is known that they are not."""
        comparison = self._compare(one, other)
        if comparison.likeness is Likeness.DIFFERENT:
            self._contradicted[id(other)] = RungChange(CHANGED, one, other, comparison.reason, is_drawn=True)
        elif comparison.likeness is not Likeness.IDENTICAL:
            self.drawn_otherwise += 1

    def _compare(self, one: WordedRung, other: WordedRung) -> Comparison:
        key = (id(one), id(other))
        if key not in self._compared:
            self._compared[key] = compare([one.drawn], [other.drawn])
        return self._compared[key]

    def _find_moves(self) -> None:
        """Pairs what is left over in the same words, first in one routine, then anywhere."""
        left: defaultdict[tuple[str, ...], list[tuple[Match, WordedRung]]] = defaultdict(list)
        for match in self._matches:
            one, _ = self._rungs(match)
            paired = {i for i, _ in self._pairs[match]}
            for n, rung in enumerate(one):
                if n not in paired and id(rung) not in self._settled:
                    left[rung.lines].append((match, rung))
        for is_near in (True, False):
            for match in self._matches:
                _, other = self._rungs(match)
                paired = {j for _, j in self._pairs[match]}
                for n, rung in enumerate(other):
                    if n in paired or id(rung) in self._settled or id(rung) in self._moves:
                        continue
                    fitting = [each for each in left[rung.lines] if (each[0] == match) == is_near]
                    if fitting and (is_near or not rung.is_plain):
                        left[rung.lines].remove(fitting[0])
                        self._move(fitting[0][1], rung)

    def _move(self, one: WordedRung, other: WordedRung) -> None:
        self._note_drawing(one, other)
        contradicted = self._contradicted.pop(id(other), None)
        moved = replace(contradicted, kind=MOVED) if contradicted else RungChange(MOVED, one, other)
        self._moves[id(one)] = self._moves[id(other)] = moved

    def _routine(self, match: Match) -> RoutineChange:
        one, other = self._rungs(match)
        changes: list[RungChange] = []
        for step in _steps(self._pairs[match], one, other):
            if isinstance(step, Gap):
                changes += self._gap([one[n] for n in step.one], [other[n] for n in step.other])
                continue
            before, after = one[step[0]], other[step[1]]
            contradicted = self._contradicted.get(id(after))
            if contradicted:
                changes.append(contradicted)
            elif before.comment != after.comment:
                changes.append(RungChange(COMMENTED, before, after))
        if match.other is None:
            return RoutineChange(REMOVED, match.one or "", "", len(one), tuple(changes))
        kind = ADDED if match.one is None else RENAMED if match.is_renamed else SAME
        former = match.one if match.one is not None and match.one != match.other else ""
        return RoutineChange(kind, match.other, former, len(other), tuple(changes))

    def _gap(self, one: Sequence[WordedRung], other: Sequence[WordedRung]) -> Iterator[RungChange]:
        """What happened between rungs that stay, in the order of the newer side."""
        left, right = ([n for n, rung in enumerate(rungs) if not self._is_known(rung)] for rungs in (one, other))
        pairs = most_like([one[n].features for n in left], [other[n].features for n in right])
        for step in _steps([(left[i], right[j]) for i, j in pairs], one, other):
            if not isinstance(step, Gap):
                yield from self._changed(one[step[0]], other[step[1]])
                continue
            for n in step.one:
                yield from self._leaving(one[n])
            for n in step.other:
                yield from self._coming(other[n])

    def _is_known(self, rung: WordedRung) -> bool:
        return id(rung) in self._moves or id(rung) in self._settled

    def _coming(self, rung: WordedRung) -> Iterator[RungChange]:
        """A rung of the newer side that stood elsewhere or nowhere."""
        if id(rung) not in self._settled:
            yield self._moves.get(id(rung)) or RungChange(ADDED, None, rung)
            return
        said = self._settled[id(rung)]
        if said is not None:
            yield said

    def _leaving(self, rung: WordedRung) -> Iterator[RungChange]:
        """A rung of the older side that stands here no more; one that moved within its routine is told where it is."""
        moved = self._moves.get(id(rung))
        if id(rung) in self._settled:
            return
        if moved is None:
            yield RungChange(REMOVED, rung, None)
        elif moved.other and not self._is_near(moved):
            yield moved

    def _is_near(self, moved: RungChange) -> bool:
        assert moved.one
        assert moved.other
        return any(match.one == moved.one.routine and match.other == moved.other.routine for match in self._matches)

    def _changed(self, one: WordedRung, other: WordedRung) -> Iterator[RungChange]:
        comparison = self._compare(one, other)
        if not comparison.is_same:
            yield RungChange(CHANGED, one, other, comparison.reason, comparison.likeness is Likeness.UNKNOWN)
            return
        self.drawn_otherwise += 1
        if one.comment != other.comment:
            yield RungChange(COMMENTED, one, other)


def _steps(pairs: Iterable[Pair], one: Sequence[object], other: Sequence[object]) -> Iterator[Pair | Gap]:
    """The pairs, and what lies between them."""
    pairs = list(pairs)
    between = {(gap.one.stop, gap.other.stop): gap for gap in gaps(pairs, len(one), len(other))}
    for pair in (*pairs, (len(one), len(other))):
        if pair in between:
            yield between[pair]
        if pair[0] < len(one) and pair[1] < len(other):
            yield pair
