"""Random rungs against damaged ones: those that count as the same have the same power and leave the same memory."""

from __future__ import annotations

import csv
import io
import random
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import pytest
from budget import examples
from hypothesis import assume, given, note
from hypothesis import strategies as st
from judges.builds import ladder_files
from judges.codec import normalise
from judges.machine import Machine
from judges.meaning import Drawing, LadderForm, drawings, visible
from judges.power import (
    LadderRung,
    Output,
    Pin,
    Row,
    _expand,
    condition_tokens,
    power_sets,
    situations,
)
from strategies.conditions import Always, BitRange, Condition, Contact, Group, Logic
from strategies.meaning import meaning_programs
from strategies.one_rung import power_programs
from strategies.programs import Act, Branch, Item, Program, Rung
from test_importing_cases import ladder_text

from clickgen.click.compare.outputs import Surroundings
from clickgen.click.compare.same import Likeness, compare
from clickgen.click.read.grid import DrawnBox, DrawnRow, DrawnRung, Square, read_ladder
from clickgen.click.read.operands import condition_of
from clickgen.device.banks import Address
from clickgen.text.source import Span

Rows = list[list[str]]
"""The rows of a rung: marker, 31 squares, output."""
SCRATCH = frozenset(Address("C", number) for number in range(1900, 2001))
EXPANDED = re.compile(r"D[SDHF](4[45]\d\d|49\d|500|99\d|1000)\b|~T1[125]\b")
"""Signs of scratch registers and of an rtof: no rung drawn by hand is the same as theirs."""
HERE = Span("main.csv", 1, 1, 1, 2)


def rungs_of(text: str) -> list[Rows]:
    """The rungs of a ladder file, without comments."""
    found: list[Rows] = []
    for row in list(csv.reader(io.StringIO(text, newline="")))[1:]:
        if row[0].startswith("R"):
            found.append([])
        if row[0] != "#":
            found[-1].append(row)
    return found


def drawn(rows: Rows) -> DrawnRung:
    [rung] = read_ladder(ladder_text(rows), "main.csv").rungs
    return rung


# -- damage -----------------------------------------------------------------------------------------------------------

LEAVES = ("X001", "~X001", "C1", "~C2", "SC1", "~SC1", "rise(C1)", "fall(X002)", "DS1==5", "DS1!=5", "immediate(X001)")
OUTPUTS = ("out(Y001)", "out(Y002)", "latch(C1)", "reset(C1)", "copy(1,DS1)", "NOP", "")
OPPOSITE = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
_COMPARE = re.compile(r"([^=!<>]+)(==|!=|<=|>=|<|>)([^=!<>]+)")


def negated(cell: str) -> str:
    compare = _COMPARE.fullmatch(cell)
    if compare:
        return f"{compare[1]}{OPPOSITE[compare[2]]}{compare[3]}"
    if cell.startswith(("rise", "fall")):
        return cell.replace("rise", "FALL").replace("fall", "rise").replace("FALL", "fall")
    return cell[1:] if cell.startswith("~") else f"~{cell}"


def damaged(rows: Rows, chance: random.Random) -> Rows:
    """The rung with one change, which may be a wire that leads nowhere."""
    found = [list(row) for row in rows]
    for _ in range(5):
        if found == rows:
            chance.choice((*[_contact] * 4, *[_wire] * 4, _row, _column, _output))(found, chance)
    return found


def _place(rows: Rows, chance: random.Random, wanted: Callable[[str], bool]) -> tuple[int, int] | None:
    places = [(r, c) for r, row in enumerate(rows) for c in range(1, 32) if wanted(row[c])]
    return chance.choice(places) if places else None


def _contact(rows: Rows, chance: random.Random) -> None:
    place = _place(rows, chance, lambda cell: cell.removeprefix("T:") not in ("", "-", "T", "|"))
    if place is None:
        return
    row, column = place
    cell = rows[row][column]
    token = cell.removeprefix("T:")
    down = cell[: len(cell) - len(token)]
    others = {rows[r][c].removeprefix("T:") for r in range(len(rows)) for c in range(1, 32)} - {"", "-", "T", "|"}
    options = [negated(token), chance.choice(LEAVES), chance.choice(sorted(others))]
    new = chance.choice([*(down + option for option in options), "T" if down else "-", "|" if down else "", token])
    rows[row][column] = new


def _wire(rows: Rows, chance: random.Random) -> None:
    busy = max((c for row in rows for c in range(1, 32) if row[c] not in ("", "-")), default=1) + 1
    row, column = chance.randrange(len(rows)), chance.randint(1, min(busy, 31))
    cell = rows[row][column]
    is_down = cell in ("T", "|") or cell.startswith("T:")
    can_down = column > 1 and row + 1 < len(rows)
    token = cell.removeprefix("T:") if cell not in ("T", "|") else ""
    if token in ("", "-"):
        right = cell in ("-", "T")
        if chance.random() < 0.5 and can_down:
            is_down = not is_down
        else:
            right = not right
        rows[row][column] = {(True, True): "T", (True, False): "-", (False, True): "|", (False, False): ""}[
            right, is_down
        ]
    elif can_down:
        rows[row][column] = token if is_down else f"T:{token}"


def _row(rows: Rows, chance: random.Random) -> None:
    one, other = chance.randrange(len(rows)), chance.randrange(len(rows))
    if chance.random() < 0.5:
        column = chance.randint(1, 31)
        rows[one][1:column], rows[other][1:column] = rows[other][1:column], rows[one][1:column]
    else:
        rows[one][-1], rows[other][-1] = rows[other][-1], rows[one][-1]


def _column(rows: Rows, chance: random.Random) -> None:
    column = chance.randint(1, 30)
    for row in rows:
        row[column], row[column + 1] = row[column + 1], row[column]


def _output(rows: Rows, chance: random.Random) -> None:
    row = chance.choice(rows)
    if not row[-1].startswith("."):
        row[-1] = chance.choice(OUTPUTS)


# -- the judge --------------------------------------------------------------------------------------------------------

_KINDS = {
    "whole": re.compile(r"(?:DS|DD|TD|CTD|SD)\d+|[+-]?\d+"),
    "word": re.compile(r"DH\d+|[XY]D\du?|[0-9A-Fa-f]+h"),
    "float": re.compile(r"DF\d+|[+-]?\d*\.\d+"),
    "text": re.compile(r'TXT\d+|".*"|\$[0-9A-Fa-f]{2}'),
}
_MIRRORED = {"==": "==", "!=": "!=", "<": ">", ">": "<", "<=": ">=", ">=": "<="}


def leaf(cell: str) -> str:
    """A comparison within one kind in one spelling: ``DS2==DS1`` is ``DS1==DS2``, and ``DS1!=5`` is ``~DS1==5``.

    All six comparisons are known to go together only for whole numbers, and ``==`` and ``!=`` for texts. Others stay.
    """
    down = "T:" if cell.startswith("T:") else ""
    compare = _COMPARE.fullmatch(cell.removeprefix("T:"))
    if compare is None:
        return str(normalise(cell))
    left, operator, right = compare.groups()
    kind = next((name for name, form in _KINDS.items() if form.fullmatch(left) and form.fullmatch(right)), "")
    if not kind:
        return cell
    if (not right[0].isalpha(), right) < (not left[0].isalpha(), left):
        left, operator, right = right, _MIRRORED[operator], left
    is_total = kind in ("whole", "word") or (kind == "text" and operator in ("==", "!="))
    if operator in ("!=", "<=", ">=") and is_total:
        return f"{down}~{left}{OPPOSITE[operator]}{right}"
    return f"{down}{left}{operator}{right}"


def joined(rows: Rows) -> Rows:
    """The rows with each downward wire continued through blank squares, as laddercodec reads a file."""
    found = [list(row) for row in rows]
    for number in range(len(rows) - 2):
        above, below = found[number], found[number + 1]
        for column in range(2, 32):
            is_down = above[column] in ("T", "|") or above[column].startswith("T:")
            if is_down and below[column] == "" and below[column - 1] in ("", "|"):
                below[column] = "|"
    return found


@dataclass(frozen=True)
class Judged:
    outputs: list[tuple[str, list[str]]]
    power: list[int]


def judged(sides: Sequence[Rows]) -> tuple[list[Judged], int]:
    """The verdict of the tests' judge on each rung, and how many leaves there are."""
    rungs = []
    for rows in map(joined, sides):
        written = tuple(Row(tuple(map(leaf, row[1:-1])), normalise(row[-1]), 1) for row in rows)
        full, outputs = _expand(written)
        rungs.append(LadderRung((), written, full, outputs))
    leaves = dict.fromkeys(token for rung in rungs for token in condition_tokens(rung) if token != "SC1")
    sets, every = situations(list(leaves))
    sets["SC1"] = every
    found = []
    for rung in rungs:
        levels = power_sets(rung, sets, every)
        kept = {number: one for number, one in enumerate(rung.found) if one.token != "NOP"}
        power = [level for terminal, level in levels.items() if terminal.output in kept]
        found.append(Judged([(one.token, [pin.token for pin in one.pins]) for one in kept.values()], power))
    return found, len(leaves)


def check_damage(one: Rows, other: Rows) -> str:
    """Check that the comparison agrees with the judge; return its verdict."""
    compared = compare([drawn(one)], [drawn(other)])
    note(f"{compared}")
    if drawn(other).problems:
        assert compared.likeness is Likeness.UNKNOWN
        return "damaged"
    try:
        [first, second], leaves = judged((one, other))
    except AssertionError as error:  # the judge does not read it
        return f"not judged: {str(error)[:20]}"
    agrees = first == second
    if compared.likeness is Likeness.UNKNOWN:
        assert agrees, compared.reason
        assert "looks at the terminal itself" in compared.reason
        return "another number of looks"
    if leaves > 12 and agrees:  # the judge has seen a sample of the situations
        return f"{compared.likeness.name} of many"
    assert compared.is_same == agrees, (one, other)
    assert bool(compared.reason) != compared.is_same
    return compared.likeness.name


def check_damaged_program(program: Program, seed: int, rounds: int = 8) -> Iterator[str]:
    chance = random.Random(seed)
    for text in ladder_files(program.texts).values():
        for rows in rungs_of(text):
            assert compare([drawn(rows)], [drawn(rows)]).likeness is Likeness.IDENTICAL
            for _ in range(rounds):
                other = damaged(rows, chance)
                if chance.random() < 0.2:
                    other = damaged(other, chance)
                yield check_damage(rows, other)


@pytest.mark.parametrize(
    ("one", "other"),
    [("DS2==DS1", "DS1==DS2"), ("~C1", "~C1"), ("5>DS1", "DS1<5"), ("DS1>=5", "5<=DS1"), ('"A"!=TXT1', 'TXT1!="A"')],
)
def test_the_judge_knows_a_comparison_by_either_side(one: str, other: str) -> None:
    assert leaf(one) == leaf(other)
    for is_same, sides in ((True, (one, other)), (False, (one, "C9"))):
        mine, theirs = ([["R", side, *["-"] * 30, "out(Y001)"]] for side in sides)
        [first, second], _ = judged((mine, theirs))
        assert (first == second) is is_same
        assert compare([drawn(mine)], [drawn(theirs)]).is_same is is_same


@given(st.one_of(power_programs(), meaning_programs()), st.integers(0, 2**32))
@examples(3)
def test_a_damaged_rung_is_the_same_when_its_power_is(program: Program, seed: int) -> None:
    note(program.text)
    for _ in check_damaged_program(program, seed):
        pass


@given(st.one_of(power_programs(), meaning_programs()))
@examples(3)
def test_what_is_built_twice_is_identical(program: Program) -> None:
    one, other = ladder_files(program.texts), ladder_files(program.texts)
    for name, text in one.items():
        mine, theirs = (read_ladder(each, name).rungs for each in (text, other[name]))
        assert compare(mine, theirs, SCRATCH).likeness is Likeness.IDENTICAL


# -- rungs that were split --------------------------------------------------------------------------------------------


def ways(condition: Condition) -> list[frozenset[str]]:
    """The sets of contacts that let power through, each with its ~."""
    if isinstance(condition, Always):
        return [frozenset()]
    if isinstance(condition, BitRange):
        return ways(Group("all", condition.contacts))
    assert not isinstance(condition, Logic)
    if not isinstance(condition, Group):
        is_negated = isinstance(condition, Contact) and condition.form == "nc"
        return [frozenset([f"~{condition.leaf}" if is_negated else condition.leaf])]
    inner = [ways(term) for term in condition.terms]
    if condition.word == "any":
        return _fewest(way for legs in inner for way in legs)
    found = [frozenset[str]()]
    for legs in inner:
        found = _fewest(way | leg for way in found for leg in legs)
        assume(len(found) < 40)
    return found


def _fewest(found: Iterator[frozenset[str]]) -> list[frozenset[str]]:
    several = list(dict.fromkeys(found))
    assume(len(several) < 200)
    return [way for way in several if not any(other < way for other in several)]


def steps(condition: Condition, items: Sequence[Item]) -> Iterator[tuple[Act, Condition]]:
    for item in items:
        if isinstance(item, Act):
            yield item, condition
        elif isinstance(item, Branch):
            yield from steps(Group("all", (condition, item.condition)), item.items)


@dataclass(frozen=True)
class Whole:
    """A rung of the source as one rung, as if there were no limits: every way is a row of its own."""

    drawn: DrawnRung
    judged: LadderRung


def whole(rung: Rung) -> Whole:
    rows: list[list[str]] = []
    boxes: list[DrawnBox] = []

    def block(condition: Condition | None) -> int:
        first = len(rows)
        for way in ways(condition) if condition is not None else [frozenset(["~SC1"])]:
            assume(len(way) <= 30)
            cells = sorted(way)
            rows.append([*cells, *["-"] * (30 - len(cells)), "|"])
        rows[-1][-1] = ""
        rows[first][-1] = "T" if rows[first][-1] else "-"
        return first

    for act, condition in steps(rung.condition, rung.items):
        if act.token == "NOP":
            continue
        for token in act.tokens:
            row = block(condition)
            boxes.append(DrawnBox(token, row, tuple((pin.token, block(pin.condition)) for pin in act.pins)))
    assume(rows and boxes)
    squares = [
        tuple(
            Square(
                cell not in ("", "|"),
                cell in ("T", "|"),
                None if cell in ("", "-", "T", "|") else condition_of(cell, HERE),
            )
            for cell in row
        )
        for row in rows
    ]
    return Whole(
        DrawnRung(1, "main.csv", 1, "", tuple(DrawnRow(row, "", 1) for row in squares), tuple(boxes)),
        LadderRung(
            (),
            (),
            tuple(Row(tuple(row)) for row in rows),
            tuple(Output(box.token, box.row, tuple(Pin(*pin) for pin in box.pins)) for box in boxes),
        ),
    )


def without_loops(items: Sequence[Item]) -> tuple[Item, ...]:
    found: list[Item] = []
    for item in items:
        if isinstance(item, Branch):
            inner = without_loops(item.items)
            found += [replace(item, items=inner)] if inner else []
        elif isinstance(item, Act):
            found.append(item)
    return tuple(found)


def remembered(routines: Mapping[str, list[Drawing]], seed: int) -> list[object]:
    """The memory after a few scans."""
    found: list[object] = []
    for edges_by_bit in (False, True):
        machine = Machine(seed, edges_by_bit, inputs_move=seed % 2 == 1)
        form = LadderForm(routines, machine)
        for _ in range(16):
            machine.begin_scan()
            form.scan()
            machine.end_scan()
            found.append((list(machine.seen), visible(machine)))
    return found


def judged_run(rungs: Sequence[Rows]) -> list[Drawing]:
    found = []
    for rows in map(joined, rungs):
        written = tuple(Row(tuple(row[1:-1]), row[-1], 1) for row in rows)
        full, outputs = _expand(written)
        found.append(Drawing(LadderRung((), written, full, outputs)))
    return found


def damaged_run(rungs: Sequence[Rows], chance: random.Random) -> list[Rows]:
    found = [[list(row) for row in rows] for rows in rungs]
    kind = chance.randrange(8)
    at = chance.randrange(len(found))
    if kind == 0 and len(found) > 1:
        other = chance.randrange(len(found))
        found[at], found[other] = found[other], found[at]
    elif kind == 1 and len(found) > 1:
        del found[at]
    elif kind < 5:
        # A condition on a scratch bit is looked at where the bit was, or another bit is.
        place = next(
            (
                (rows, row, column)
                for rows in chance.sample(found, len(found))
                for row in rows
                for column in range(1, 32)
                if re.search(r"\bC(19\d\d|2000)\b", row[column])
            ),
            None,
        )
        if place is not None:
            _, row, column = place
            bit = re.search(r"C(?:19\d\d|2000)", row[column])
            assert bit is not None
            definition = next((rows for rows in found if rows[0][-1] == f"out({bit[0]})"), None)
            cells = [cell for cell in definition[0][1:-1] if cell != "-"] if definition else []
            if definition and len(definition) == 1 and len(cells) == 1 and not cells[0].startswith("T:"):
                row[column] = row[column].replace(bit[0], cells[0]).replace("~~", "")
                if chance.random() < 0.5:
                    found.remove(definition)
            else:
                row[column] = row[column].replace(bit[0], chance.choice(("C1999", "C1998", "C1", "~C2000")))
    else:
        found[at] = damaged(found[at], chance)
    return found


def check_run(program: Program, seed: int, rounds: int = 6) -> Iterator[str]:
    """Check that a split rung never differs from the whole one, and that rungs that count as the same do the same."""
    rung = replace(program.main[0], items=without_loops(program.main[0].items))
    assume(rung.items)
    one = whole(rung)
    main = replace(program, main=(rung,), _cache={})
    files = ladder_files(main.texts)
    built = rungs_of(files["main.csv"])[:-1]
    others = {name: text for name, text in files.items() if name.startswith("subroutines/")}
    around = Surroundings.of({name[12:-4]: read_ladder(text, name).rungs for name, text in others.items()})
    is_plain = not EXPANDED.search(files["main.csv"])
    chance = random.Random(seed)
    for number in range(rounds):
        run = damaged_run(built, chance) if number else built
        if number and chance.random() < 0.2:
            run = damaged_run(run, chance)
        sides = [drawn(rows) for rows in run]
        compared = compare([one.drawn], sides, SCRATCH, around)
        if not number and is_plain:
            note(f"{run} {compared}")
            assert compared.likeness is not Likeness.DIFFERENT, compared.reason
            yield f"built: {compared.likeness.name} ({len(built) > 1}) {re.sub(r'[0-9]+', 'N', compared.reason)[-40:]}"
        if not compared.is_same:
            if number:
                yield f"damaged: {compared.likeness.name}"
            continue
        routines = drawings(files)
        for each in range(4):
            mine = remembered({**routines, "main": [Drawing(one.judged)]}, each)
            theirs = remembered({**routines, "main": judged_run(run)}, each)
            assert mine == theirs, (run, each)
        yield f"damaged: same ({len(run) > 1})" if number else "run"


@given(meaning_programs(), st.integers(0, 2**32))
@examples(8)
def test_a_split_rung_is_the_same_only_when_it_does_the_same(program: Program, seed: int) -> None:
    note(program.text)
    for _ in check_run(program, seed):
        pass
