"""A build of an imported plant is the same as the plant, and nothing else counts as the same."""

from __future__ import annotations

import ast
import random
import re
import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path

import pytest
from budget import examples
from diffing import Drawing, plant, with_scratch
from drawn_rungs import SHAPES, rung, write_bundle
from hypothesis import given
from hypothesis import strategies as st
from test_importing_cases import wired

from clickgen.click.compare.contacts import literal_of
from clickgen.click.compare.power import power_of
from clickgen.click.read.grid import DrawnRung
from clickgen.commands.diff.programs import diff
from clickgen.commands.diff.sides import Side, ladder_side, program_side
from clickgen.commands.import_.project import Target, import_project
from clickgen.config import Settings
from clickgen.ir.conditions import Compare, Contact
from clickgen.workspace import Workspace

Rows = list[list[str]]

END = wired("-", "end()", "R")
BITS = ("X001", "~X002", "C1", "~C2", "rise(X003)", "DS1==5", "C3", "T1")
OUTPUTS = (
    "out(C1)",
    "out(C2)",
    "latch(C3)",
    "reset(C3)",
    "out(Y001)",
    "copy(DS1,DS2)",
    "math(DS1 + 1,DS1,decimal)",
    'call("Sub")',
)
BOXES = (
    ("count_up(CT1,CTD1,preset=5)", ".reset()"),
    ("on_delay(T1,TD1,preset=5,unit=Tms)", ".reset()"),
)


@st.composite
def drawn_rungs(draw: st.DrawFn) -> Rows:
    """A rung as a person draws it: several outputs and boxes on one condition, some with a contact of their own."""
    count = draw(st.integers(1, 5))
    head = draw(st.sampled_from(BITS))
    rows: list[tuple[str, str]] = []
    for n in range(count):
        first = head if not n else "."
        is_last = n + 1 == count
        own = draw(st.sampled_from(("-", *BITS)))
        wire = f"{first} {'-' if is_last and not n else '-' if is_last else 'T'}"
        rows.append((f"{wire} {own}", draw(st.sampled_from(OUTPUTS))))
        if is_last and draw(st.booleans()):
            box, pin = draw(st.sampled_from(BOXES))
            rows[-1] = (f"{wire} {own}", box)
            rows += [(".", ""), (draw(st.sampled_from(("X004", "C1"))), pin)]
    return rung(*rows)


plants = st.lists(drawn_rungs(), min_size=1, max_size=6)
SUB = [*rung(("X005", "out(C1)")), wired("-", "return()", "R")]


def sides(rungs: Sequence[Rows], folder: Path) -> tuple[Side, Side] | None:
    """A plant and its import; None if they differ, which the import reports."""
    main = [row for rows in rungs for row in rows]
    has_sub = any('call("Sub")' in row for row in main)
    write_bundle(folder / "plant", {"main": [*main, END], **({"Sub": SUB} if has_sub else {})})
    result = import_project(folder / "plant", Target(folder / "prog.py"))
    if not result.ok or result.verdict is None or result.verdict.verified != result.rungs:
        return None
    result.write()
    program = program_side(folder / "prog.py", "prog.py", Settings(), Workspace())
    return ladder_side(folder / "plant", "plant", None, Workspace()), program


@given(plants)
@examples(12)
def test_a_plant_is_what_is_imported_of_it(rungs: list[Rows]) -> None:
    folder = Path(tempfile.mkdtemp(prefix="clickgen-diff-"))
    try:
        found = sides(rungs, folder)
        if found is not None:
            one, other = found
            assert not diff(one, other).differs
            assert not diff(other, one).differs
    finally:
        shutil.rmtree(folder)


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_is_what_is_imported_of_it(name: str, tmp_path: Path) -> None:
    found = sides([rung(*SHAPES[name][0])] * 2, tmp_path)
    if found is not None:
        one, other = found
        assert not diff(one, other).differs
        assert not diff(other, one).differs


# -- rungs that count as the same do the same -------------------------------------------------------------------------

SMALL = ("X001", "~X002", "C1", "~C1", "C2", "~C2", "C2000", "C1999")
COILS = ("out(C1)", "out(C2)", "latch(C1)", "reset(C2)", "out(Y001)", "out(C2000)", "out(C1999)")
STATE = ("X001", "X002", "C1", "C2", "C1999", "C2000", "Y001")


@st.composite
def coil_rungs(draw: st.DrawFn) -> Drawing:
    contacts = st.sampled_from(SMALL)
    if draw(st.integers(0, 2)):
        return [(f"{draw(contacts)} {draw(contacts)}", draw(st.sampled_from(COILS)))]
    head = draw(contacts)
    tail = [f"{draw(contacts)}" for _ in range(2)]
    outputs = [draw(st.sampled_from(COILS)) for _ in range(2)]
    return [(f"{head} T {tail[0]}", outputs[0]), (f". - {tail[1]}", outputs[1])]


@st.composite
def edited_ladders(draw: st.DrawFn) -> tuple[list[Drawing], list[Drawing]]:
    """Rungs, and the same with some of them divided, on scratch bits, exchanged, negated or removed."""
    one = draw(st.lists(coil_rungs(), min_size=1, max_size=5))
    other: list[Drawing] = []
    for drawing in one:
        edit = draw(st.sampled_from(("stays", "stays", "divided", "kept", "renumbered", "negated", "gone", "before")))
        head, *more = (contacts.split() for contacts, _ in drawing)
        if edit == "divided" and more:
            other += [[(f"{head[0]} {head[2]}", drawing[0][1])], [(f"{head[0]} {more[0][2]}", drawing[1][1])]]
        elif edit == "kept" and not more:
            bit = draw(st.sampled_from(("C1999", "C2000")))
            other += [[(drawing[0][0], f"out({bit})")], [(bit, drawing[0][1])]]
        elif edit == "renumbered":
            exchange = {"C1999": "C2000", "C2000": "C1999"}
            text = repr(list(drawing))
            rows = "".join(exchange.get(part, part) for part in re.split("(C1999|C2000)", text))
            other.append(ast.literal_eval(rows))
        elif edit == "negated":
            first = head[0].removeprefix("~") if head[0].startswith("~") else f"~{head[0]}"
            other.append([(" ".join([first, *head[1:]]), drawing[0][1]), *drawing[1:]])
        elif edit == "before":
            other.insert(0, drawing)
        elif edit != "gone":
            other.append(drawing)
    return one, other


class Bits:
    """Power in one situation."""

    never, always = 0, 1

    def __init__(self, state: dict[str, int]) -> None:
        self.state = state

    def variable(self, name: str) -> int:
        return self.state[name]

    def both(self, one: int, other: int) -> int:
        return one & other

    def either(self, one: int, other: int) -> int:
        return one | other

    def opposite(self, one: int) -> int:
        return 1 - one


def scan(rungs: Sequence[DrawnRung], state: dict[str, int]) -> None:
    """One scan of a PLC: for each rung all power first, then its coils from top to bottom."""
    for each in rungs:
        bits = Bits(state)

        def conducts(contact: Contact | Compare, bits: Bits = bits) -> int:
            name, is_negated = literal_of(contact)
            return bits.variable(name) ^ is_negated

        power = power_of(each, conducts, bits)
        for box in each.boxes:
            word, _, bit = box.token.rstrip(")").partition("(")
            if word == "out":
                state[bit] = power[box.row]
            elif power[box.row]:
                state[bit] = int(word == "latch")


@given(edited_ladders(), st.lists(st.sampled_from(("C1999", "C2000")), unique=True), st.booleans(), st.integers(0))
@examples(60)
def test_what_passes_does_the_same(
    edited: tuple[list[Drawing], list[Drawing]], scratch: list[str], is_both: bool, seed: int
) -> None:
    one, other = edited
    before, after = plant(*one), plant(*other)
    first = with_scratch(before, *(scratch if is_both else ()))
    second = with_scratch(after, *scratch)
    if diff(first, second).differs:
        return
    chance = random.Random(seed)
    hidden = (set(scratch) if is_both else set(), set(scratch))
    begins = {name: chance.randint(0, 1) if name not in scratch else 0 for name in STATE}
    states = [begins, {**begins}]
    for _ in range(8):
        for name in ("X001", "X002"):
            states[0][name] = states[1][name] = chance.randint(0, 1)
        for state, ladder in zip(states, (before, after), strict=True):
            scan(ladder["main"], state)
        seen = [name for name in STATE if name not in hidden[0] | hidden[1]]
        assert [states[0][name] for name in seen] == [states[1][name] for name in seen]
