"""Compares two runs of CLICK rungs: drawn alike, proven to do the same, or what differs, in words.

Power is compared in every situation while these are few. Beyond that, a sample of situations finds differences, and
decision diagrams, which are exact, prove that there are none; a rung whose diagrams grow too large stays unknown.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from enum import Enum

from clickgen.click.compare.contacts import contact_name
from clickgen.click.compare.divided import Run
from clickgen.click.compare.outputs import ALONE, Said, Surroundings, said_by
from clickgen.click.read.grid import DrawnRung
from clickgen.device.banks import Address
from clickgen.logic.equality import Decisions, Situations, TooMany

EXHAUSTIVE_MAX = 12
"""With more variables than this there are too many situations to look at all of them."""

NAMES_MAX = 12
"""A person reads no more contacts than this."""

_Cell = tuple[bool, bool, str]
"""A square: whether it carries power right, whether down, and its contact."""


class Likeness(Enum):
    """The result of comparing two runs of rungs."""

    IDENTICAL = "identical"
    """Drawn alike, square by square."""
    SAME = "same"
    """Drawn differently, but proven to do the same."""
    DIFFERENT = "different"
    UNKNOWN = "unknown"
    """Could be proven neither way."""


@dataclass(frozen=True)
class Comparison:
    """``reason`` says what differs, or why nothing could be proven; "" if both are the same."""

    likeness: Likeness
    reason: str = ""

    @property
    def is_same(self) -> bool:
        """True if both do the same, however they are drawn."""
        return self.likeness in (Likeness.IDENTICAL, Likeness.SAME)


def compare(
    one: Sequence[DrawnRung],
    other: Sequence[DrawnRung],
    scratch: Collection[Address] = (),
    surroundings: Surroundings = ALONE,
    scratch_of_other: Collection[Address] | None = None,
) -> Comparison:
    """Compare two runs of rungs, each of which represents one rung of a program. Comments are not compared.

    ``scratch`` has addresses that clickgen took for itself: a coil on such a bit that a later rung of its run reads is
    no output of the program. Nothing outside the run may read the bit, unless the runs are the same rung by rung.
    ``surroundings`` has the known facts of the rest of the program; without it a call may change everything.
    ``scratch`` holds for both runs, or only for the first if ``scratch_of_other`` is given for the other.
    """
    for rung in (*one, *other):
        if rung.problems:
            return Comparison(Likeness.UNKNOWN, f"the rung is damaged: {rung.problems[0].message}")
    if len(one) == len(other):
        if all(map(is_identical, one, other)):
            return Comparison(Likeness.IDENTICAL)
        # Rungs that are the same one by one are the same together, whatever they read and write.
        pairs = [_compared(Run((mine,)), Run((theirs,))) for mine, theirs in zip(one, other, strict=True)]
        if len(pairs) == 1:
            return pairs[0]
        if all(pair.is_same for pair in pairs):
            return Comparison(Likeness.SAME)
    taken = (scratch, scratch if scratch_of_other is None else scratch_of_other)
    runs = (Run(tuple(rungs), frozenset(own), surroundings) for rungs, own in zip((one, other), taken, strict=True))
    return _compared(*runs)


def is_identical(one: DrawnRung, other: DrawnRung) -> bool:
    """True for the same squares and outputs in the same rows; blank rows at the end and spelling do not count."""
    if one.is_drawn_as(other):
        return True
    outputs = [[(box.row, said_by(box), [row for _, row in box.pins]) for box in rung.boxes] for rung in (one, other)]
    return outputs[0] == outputs[1] and _squares(one) == _squares(other)


def _squares(rung: DrawnRung) -> list[list[_Cell]]:
    rows = [
        [(square.right, square.down, contact_name(square.contact) if square.contact else "") for square in row.squares]
        for row in rung.rows
    ]
    while rows and not any(right or down for right, down, _ in rows[-1]):
        rows.pop()
    return rows


# -- the proof --------------------------------------------------------------------------------------------------------


def _compared(one: Run, other: Run) -> Comparison:
    if one.outputs != other.outputs:
        return Comparison(Likeness.DIFFERENT, _other_outputs(one.outputs, other.outputs))
    if one.doubt or other.doubt:
        return Comparison(Likeness.UNKNOWN, one.doubt or other.doubt)
    compared = _by_power(one, other)
    # Between two looks something may change: then any(...) of them is no longer all(...) of them.
    repeated = sorted(name for name, count in (one.looks | other.looks).items() if count > 1)
    if compared.is_same and repeated:
        name = repeated[0]
        times = " and ".join(str(count) for count in sorted((one.looks[name], other.looks[name])))
        what = "looks at the terminal itself" if "immediate" in name else "is looked at"
        reason = f"{name} {what}, {times} times: it may change in between"
        return Comparison(Likeness.UNKNOWN, reason)
    return compared


def _by_power(one: Run, other: Run) -> Comparison:
    names = list(dict.fromkeys(literal.name for run in (one, other) for literal in run.literals))
    is_exact = len(names) <= EXHAUSTIVE_MAX
    situations = Situations.every(names) if is_exact else Situations.sampled(names)
    differing = _first_difference(one.powers(situations), other.powers(situations))
    if differing is None and is_exact:
        return Comparison(Likeness.SAME)
    try:
        decisions = Decisions(names)
        powers = one.powers(decisions), other.powers(decisions)
        proven = _first_difference(*powers)
    except TooMany:
        if differing is None:
            return Comparison(Likeness.UNKNOWN, "the contacts can be on and off in too many ways to compare them all")
        where = _place(one.outputs, *differing)
        return Comparison(Likeness.DIFFERENT, f"{where} does not have power in the same situations")
    if proven is None:
        if differing is None:
            return Comparison(Likeness.SAME)
        return Comparison(Likeness.UNKNOWN, "two ways to compare the power disagree: please report this rung")
    output, line = proven
    only_in_one = {literal.name for literal in one.literals.keys() ^ other.literals.keys()}
    reason = _case(decisions, powers[0][output][line], powers[1][output][line], only_in_one)
    return Comparison(Likeness.DIFFERENT, f"{_place(one.outputs, output, line)} has power {reason}")


def _first_difference(one: Sequence[Sequence[int]], other: Sequence[Sequence[int]]) -> tuple[int, int] | None:
    """The number of an output, and of one of its inputs, that differ; input 0 is the output's own."""
    for output, lines in enumerate(zip(one, other, strict=True)):
        for line, (mine, theirs) in enumerate(zip(*lines, strict=True)):
            if mine != theirs:
                return output, line
    return None


# -- in words ---------------------------------------------------------------------------------------------------------


def _other_outputs(one: Sequence[Said], other: Sequence[Said]) -> str:
    """The difference between two lists of outputs."""
    if Counter(one) == Counter(other):
        return f"the outputs are in another order: {_listed(one)} in the first, {_listed(other)} in the second"
    index = next((n for n, (mine, theirs) in enumerate(zip(one, other, strict=False)) if mine != theirs), None)
    if index is None:
        longer, which = (one, "first") if len(one) > len(other) else (other, "second")
        return f"only the {which} has {_listed(longer[min(len(one), len(other)) :])}"
    mine, theirs = one[index], other[index]
    if mine.token == theirs.token:
        return f"{_short(mine.token)} has the inputs {_pins(mine)} in the first, {_pins(theirs)} in the second"
    return f"output {index + 1} is {_short(mine.token)} in the first, {_short(theirs.token)} in the second"


def _listed(outputs: Iterable[Said]) -> str:
    return ", ".join(_short(said.token) for said in outputs)


def _pins(said: Said) -> str:
    return ", ".join(said.pins) or "none"


def _short(token: str) -> str:
    return token if len(token) <= 120 else f"{token[:117]}..."


def _place(outputs: Sequence[Said], output: int, line: int) -> str:
    said = outputs[output]
    return f"{said.pins[line - 1]} of {_short(said.token)}" if line else _short(said.token)


def _case(decisions: Decisions, one: int, other: int, first: Collection[str]) -> str:
    """``with X001 and C5 on and X002 off in the first only``: as few contacts as decide, these ``first``."""
    cases: list[tuple[str, dict[str, bool]]] = []
    for which, mine, theirs in (("first", one, other), ("second", other, one)):
        try:
            only = decisions.both(mine, decisions.opposite(theirs))
            if only != decisions.never:
                cases.append((which, decisions.smallest_case(only)))
        except TooMany:
            continue
    if not cases:
        return "in other situations in the second than in the first"
    which, case = min(cases, key=lambda found: len(found[1]))
    if not case:
        return f"always in the {which}, never in the other"
    names = sorted(case, key=lambda name: name not in first)
    sides = [
        (state, [name for name in names if case[name] == is_on]) for state, is_on in (("on", True), ("off", False))
    ]
    states = [f"{_and(names)} {state}" for state, names in sides if names]
    return f"with {' and '.join(states)} in the {which} only"


def _and(names: Sequence[str]) -> str:
    if len(names) > NAMES_MAX:
        names = [*names[: NAMES_MAX - 1], f"{len(names) - NAMES_MAX + 1} more"]
    return f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else names[0]
