"""Two sequences side by side: what they have in common, what is between, and which places there resemble each other."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Hashable, Iterable, Iterator, Sequence
from typing import NamedTuple

Pair = tuple[int, int]
"""A place in the one sequence and a place in the other."""

LIKE_ENOUGH = 0.3
"""From this value on two sets of features resemble each other; 1 is equal."""
_ALL_PAIRS = 10_000
"""In a gap with at most this many pairs each is looked at; in a larger one only those that share something rare."""


class Block(NamedTuple):
    """Neighbouring places in the one sequence, and in the other."""

    one: range
    other: range


def longest_common(one: Sequence[Hashable], other: Sequence[Hashable]) -> list[Pair]:
    """The pairs of a longest common subsequence; equal beginnings and ends are paired first.

    Each row of the usual table is a number with one bit per place (Crochemore et al., 2001), so that thousands of
    rungs take no time.
    """
    start, stop = _shared_ends(one, other)
    middle_one, middle_other = one[start : len(one) - stop], other[start : len(other) - stop]
    pairs = [(n, n) for n in range(start)]
    pairs += ((start + i, start + j) for i, j in _common(middle_one, middle_other))
    return pairs + [(len(one) - n, len(other) - n) for n in range(stop, 0, -1)]


def _shared_ends(one: Sequence[Hashable], other: Sequence[Hashable]) -> Pair:
    shorter = min(len(one), len(other))
    start = next((n for n in range(shorter) if one[n] != other[n]), shorter)
    rest = shorter - start
    return start, next((n for n in range(rest) if one[-1 - n] != other[-1 - n]), rest)


def _common(one: Sequence[Hashable], other: Sequence[Hashable]) -> list[Pair]:
    places: defaultdict[Hashable, int] = defaultdict(int)
    for n, key in enumerate(other):
        places[key] |= 1 << n
    every = (1 << len(other)) - 1
    rows = [every]
    for key in one:
        # A bit is 0 where the common subsequence up to this place is longer than the one before it.
        row = rows[-1]
        hits = row & places.get(key, 0)
        rows.append(((row + hits) | (row - hits)) & every)
    pairs: list[Pair] = []
    i, j = len(one), len(other)
    while i and j:
        bit = 1 << (j - 1)
        if rows[i] & bit:
            j -= 1
        elif not rows[i - 1] & bit:
            i -= 1
        else:
            i, j = i - 1, j - 1
            pairs.append((i, j))
    return pairs[::-1]


def single(pair: Pair) -> Block:
    i, j = pair
    return Block(range(i, i + 1), range(j, j + 1))


def steps(shared: Iterable[Block], within: Block) -> Iterator[tuple[bool, Block]]:
    """Yield all places in order: the shared blocks, with True, and those between them."""
    i, j = within.one.start, within.other.start
    for block in (*shared, Block(range(within.one.stop, within.one.stop), range(within.other.stop, within.other.stop))):
        if block.one.start > i or block.other.start > j:
            yield False, Block(range(i, block.one.start), range(j, block.other.start))
        if block.one or block.other:
            yield True, block
        i, j = block.one.stop, block.other.stop


def same_together(one: Sequence[Sequence[Hashable]], other: Sequence[Sequence[Hashable]]) -> Iterator[Block]:
    """Yield the shortest blocks in which both sequences hold the same, in order, however it is divided."""
    mine, theirs = ([n for n, held in enumerate(side) for _ in held] for side in (one, other))
    common = longest_common([key for held in one for key in held], [key for held in other for key in held])
    found: list[tuple[int, int, int, int, int]] = []
    for i, j in ((mine[a], theirs[b]) for a, b in common):
        if found and (i < found[-1][1] or j < found[-1][3]):
            start_i, _, start_j, _, count = found[-1]
            found[-1] = (start_i, i + 1, start_j, j + 1, count + 1)
        else:
            found.append((i, i + 1, j, j + 1, 1))
    for start_i, stop_i, start_j, stop_j, count in found:
        if all(sum(map(len, held)) == count for held in (one[start_i:stop_i], other[start_j:stop_j])):
            yield Block(range(start_i, stop_i), range(start_j, stop_j))


def most_like(one: Sequence[frozenset[str]], other: Sequence[frozenset[str]]) -> list[Pair]:
    """Return pairs in order on both sides that have the most in common."""
    scored = ((i, j, likeness(one[i], other[j])) for i, j in _candidates(one, other))
    return _best_chain([each for each in scored if each[2] >= LIKE_ENOUGH], len(other))


def likeness(one: frozenset[str], other: frozenset[str]) -> float:
    """The common share of two sets: 0 nothing, 1 everything."""
    return 2 * len(one & other) / (len(one) + len(other)) if one or other else 1.0


def _candidates(one: Sequence[frozenset[str]], other: Sequence[frozenset[str]]) -> list[Pair]:
    """Pairs worth a look, by the first place and, if that is the same, by the second from the last on."""
    if len(one) * len(other) <= _ALL_PAIRS:
        return [(i, j) for i in range(len(one)) for j in reversed(range(len(other)))]
    places: defaultdict[str, list[int]] = defaultdict(list)
    for j, features in enumerate(other):
        for feature in features:
            places[feature].append(j)
    counts = Counter(feature for features in one for feature in features)
    # If everything changed alike nothing is rare, but what is at the same place may belong together.
    found: set[Pair] = {(n, n) for n in range(len(one))} if len(one) == len(other) else set()
    for i, features in enumerate(one):
        rare = (feature for feature in features if counts[feature] * len(places.get(feature, ())) <= _ALL_PAIRS)
        found.update((i, j) for feature in rare for j in places.get(feature, ()))
    return sorted(found, key=lambda pair: (pair[0], -pair[1]))


def _best_chain(scored: Sequence[tuple[int, int, float]], width: int) -> list[Pair]:
    """The pairs that rise on both sides with the highest sum; of equal ones the first that was found."""
    # A Fenwick tree over the second places: the best chain that ends before one.
    best: list[tuple[float, int]] = [(0.0, -1)] * (width + 1)
    before: list[int] = []
    for index, (_, j, score) in enumerate(scored):
        sum_before, previous = 0.0, -1
        place = j
        while place:
            if best[place][0] > sum_before:
                sum_before, previous = best[place]
            place &= place - 1
        before.append(previous)
        place = j + 1
        while place <= width:
            if sum_before + score > best[place][0]:
                best[place] = (sum_before + score, index)
            place += place & -place
    place, (total, last) = width, (0.0, -1)
    while place:
        if best[place][0] > total:
            total, last = best[place]
        place &= place - 1
    chain: list[Pair] = []
    while last >= 0:
        chain.append((scored[last][0], scored[last][1]))
        last = before[last]
    return chain[::-1]
