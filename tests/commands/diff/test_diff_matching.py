"""``clickgen diff``: which rung is compared with which."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

from budget import examples
from diffing import happened, negated, plant, programs, side, words
from hypothesis import assume, given
from hypothesis import strategies as st
from judges.builds import ladder_files
from strategies.programs import Program

from clickgen.click.compare.same import compare
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.commands.diff.changes import CHANGED, COMMENTED, MOVED, REMOVED
from clickgen.commands.diff.match import Block, longest_common, most_like, single, steps
from clickgen.commands.diff.programs import diff
from clickgen.commands.diff.sides import Side

# -- matching ----------------------------------------------------------------------------------------------------------


keys = st.lists(st.integers(0, 4), max_size=12)


@given(keys, keys)
@examples(100)
def test_common_subsequences_are_longest(one: list[int], other: list[int]) -> None:
    lengths = [[0] * (len(other) + 1) for _ in range(len(one) + 1)]
    for i, mine in enumerate(one):
        for j, theirs in enumerate(other):
            lengths[i + 1][j + 1] = lengths[i][j] + 1 if mine == theirs else max(lengths[i][j + 1], lengths[i + 1][j])
    pairs = longest_common(one, other)
    assert len(pairs) == lengths[-1][-1]
    assert all(one[i] == other[j] for i, j in pairs)
    assert all(a < c and b < d for (a, b), (c, d) in pairwise(pairs))
    found = list(steps(map(single, pairs), Block(range(len(one)), range(len(other)))))
    assert [n for _, block in found for n in block.one] == list(range(len(one)))
    assert [n for _, block in found for n in block.other] == list(range(len(other)))
    assert sum(is_shared for is_shared, _ in found) == len(pairs)


@given(*[st.lists(st.frozensets(st.sampled_from("abcdef"), min_size=1), max_size=8)] * 2)
@examples(60)
def test_what_resembles_each_other_stays_in_order(one: list[frozenset[str]], other: list[frozenset[str]]) -> None:
    pairs = most_like(one, other)
    assert all(a < c and b < d for (a, b), (c, d) in pairwise(pairs))
    if one == other:
        assert pairs == [(n, n) for n in range(len(one))]


def test_thousands_of_rungs_that_changed_alike() -> None:
    one, other = ([[(contact, f"out(Y{n % 16 + 1:03d})")] for n in range(500)] for contact in ("X001", "X002"))
    found = diff(side(plant(*one)), side(plant(*other)))
    assert found.count(CHANGED) == len(happened(found)) == 500


def test_thousands_of_rungs_are_aligned() -> None:
    numbers = range(3000)
    one = [frozenset((f"C{n}", f"Y{n % 16}", "out")) for n in numbers]
    other = [frozenset((f"C{n}", f"Y{(n + 1) % 16}", "out")) for n in numbers]
    assert len(longest_common([n % 50 for n in numbers], [(n * 7) % 50 for n in numbers])) > 50
    assert len(most_like(one, other)) == 3000


# -- properties --------------------------------------------------------------------------------------------------------


def drawn(program: Program) -> dict[str, list[DrawnRung]]:
    """The rungs of each routine as drawn."""
    files = ladder_files(program.texts)
    return {Path(name).stem: list(read_ladder(text, name).rungs) for name, text in files.items()}


@given(programs)
@examples(6)
def test_nothing_differs_from_itself(program: Program) -> None:
    found = diff(side(drawn(program)), side(drawn(program)))
    assert (found.differs, happened(found), found.drawn_otherwise) == (False, [], 0)


@st.composite
def edited(draw: st.DrawFn, kind: str) -> tuple[Side, Side, int, bool]:
    """A program before and after a change to a rung of main, which rung, and whether it has a double."""
    before = drawn(draw(programs))
    rungs = list(before["main"])
    n = draw(st.integers(0, len(rungs) - 1))
    has_double = [words(rung) for rung in rungs].count(words(rungs[n])) > 1
    if kind == "delete":
        del rungs[n]
    elif kind == "comment":
        rungs[n] = replace(rungs[n], comment="something else")
    elif kind == "negate":
        rungs[n] = negated(rungs[n])
        assume(not compare([before["main"][n]], [rungs[n]]).is_same)
    else:
        assume(n + 1 < len(rungs) and not compare([rungs[n]], [rungs[n + 1]]).is_same)
        has_double = has_double or [words(rung) for rung in rungs].count(words(rungs[n + 1])) > 1
        rungs[n], rungs[n + 1] = rungs[n + 1], rungs[n]
    return side(before), side({**before, "main": rungs}), n + 1, has_double


@given(edited("delete"))
@examples(6)
def test_a_deleted_rung_is_named(sides: tuple[Side, Side, int, bool]) -> None:
    one, other, number, has_double = sides
    found = diff(one, other)
    [(kind, routine, named)] = happened(found)
    assert (found.differs, kind, routine) == (True, REMOVED, "main")
    assert named == number or has_double


@given(edited("swap"))
@examples(6)
def test_swapped_rungs_are_named(sides: tuple[Side, Side, int, bool]) -> None:
    one, other, number, has_double = sides
    found = diff(one, other)
    assert found.differs
    if not has_double:
        [(kind, routine, named)] = happened(found)
        assert (kind, routine) == (MOVED, "main")
        assert named in (number, number + 1)


@given(edited("negate"))
@examples(6)
def test_a_negated_rung_is_named(sides: tuple[Side, Side, int, bool]) -> None:
    one, other, number, has_double = sides
    found = diff(one, other)
    assert found.differs
    if not has_double:
        assert happened(found) == [(CHANGED, "main", number)]


@given(edited("comment"))
@examples(3)
def test_a_comment_is_no_logic(sides: tuple[Side, Side, int, bool]) -> None:
    one, other, number, _ = sides
    found = diff(one, other)
    assert (found.differs, happened(found)) == (False, [(COMMENTED, "main", number)])
