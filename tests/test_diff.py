"""``clickgen diff`` as a user has it: what it says of programs, bundles and revisions, and how it ends."""

from __future__ import annotations

import csv
import json
import os
import random
import re
import shutil
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import budget
import pytest
from budget import examples
from hypothesis import assume, given
from hypothesis import strategies as st
from judges.builds import ladder_files
from judges.program_files import program_file
from strategies.edits import random_draft
from strategies.meaning import meaning_programs
from strategies.one_rung import power_programs
from strategies.programs import Program
from test_importing_cases import ladder_text, wired

import clickgen
from clickgen.cli import main
from clickgen.click.compare.same import Comparison, Likeness, compare
from clickgen.click.ladder_csv import HEADER
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.click.read.project import DrawnRoutine
from clickgen.commands.diff.changes import ADDED, CHANGED, COMMENTED, KINDS, MOVED, REMOVED, Difference
from clickgen.commands.diff.match import Block, longest_common, most_like, single, steps
from clickgen.commands.diff.programs import diff
from clickgen.commands.diff.revision import named_revision
from clickgen.commands.diff.sides import Side, program_side
from clickgen.commands.diff.words import Wording
from clickgen.config import Settings
from clickgen.device.banks import Address, parse_address
from clickgen.emit.rung_words import Names
from clickgen.ir.conditions import Contact
from clickgen.lower.scratch import purpose_of, rung_of
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import default_row, scratch_name

RUNGS = [
    "    # Start and stop\n    if all(c.Start, nc(c.EStop)):\n        set(c.Running)\n",
    "    if c.Running:\n        out(y[1])\n",
    "    # How many\n    if re(c.Running):\n        copy(ds.Count, ds.Shown)\n",
    "    if c.Running:\n        ton(t.Delay, 5, unit=Ts)\n",
]
END = "    if True:\n        end()\n"
SUB = "\n\n@sub\ndef wash():\n    if c.Wash:\n        out(c.Valve)\n\n    if True:\n        return\n"
TABLE = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"


class Said(NamedTuple):
    code: int
    out: str
    err: str

    @property
    def lines(self) -> list[str]:
        """What is said between the names of the sides and the summary."""
        return [line for line in self.out.split("\n")[3:] if line]


Run = Callable[..., Said]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run ``clickgen diff`` with these arguments in a folder of its own."""
    monkeypatch.chdir(tmp_path)

    def run_diff(*arguments: str) -> Said:
        try:
            code = main(["diff", *arguments])
        except SystemExit as stop:
            code = int(str(stop.code))
        said = capsys.readouterr()
        return Said(code, said.out, said.err)

    return run_diff


def program(*rungs: str, sub: str = "", top: str = "") -> str:
    return f"{top}def main():\n" + "\n".join([*rungs, END]) + sub


def write(name: str, text: str) -> None:
    path = Path(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


def build(name: str, folder: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", name, "-o", folder]) == 0
    capsys.readouterr()


@pytest.fixture
def bundle(run: Run, capsys: pytest.CaptureFixture[str]) -> str:
    """prog.py, and what it was built into."""
    del run  # It is the folder that this needs.
    write("prog.py", program(*RUNGS, sub=SUB))
    build("prog.py", "plc", capsys)
    return "plc"


# -- rungs ------------------------------------------------------------------------------------------------------------


def test_what_was_built_is_what_the_program_says(run: Run, bundle: str) -> None:
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    said = run("prog.py", bundle)
    assert said == (0, "--- prog.py\n+++ plc\n\nNo difference in logic: 7 rungs in 2 routines.\n", "")
    assert run(bundle, "prog.py").code == 0
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before


def test_a_changed_rung(run: Run, bundle: str) -> None:
    write("prog.py", program(RUNGS[0].replace("c.EStop", "c.Stop"), *RUNGS[1:], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines == [
        "main",
        "  rung 1 changed",
        "      | Start and stop",
        "    - if C1:Start and not C2:EStop",
        "    + if C1:Start and not C6:Stop",
        "        latch(C3:Running)",
        "Nicknames",
        "  + C6 Stop",
        "1 rung changed in 1 routine.",
        "Without effect on the PLC: 1 nickname or its comment differs.",
        "Note: a name of prog.py has no address yet; the one that a build would choose is compared.",
    ]
    assert run(bundle, "prog.py", "--quiet").out == "\n".join(said.lines[-3:]) + "\n"


def test_an_added_rung_is_no_noise(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    rungs = [f"    if c[{n}]:\n        set(y[1])\n" for n in (1, 2) * 100]
    write("prog.py", program(*rungs))
    build("prog.py", "plc", capsys)
    write("prog.py", program("    if c[3]:\n        out(c[4])\n", *rungs))
    said = run("plc", "prog.py")
    assert said.lines == ["main", "  rung 1 added", "    + if C3", "    +   out(C4)", "1 rung added in 1 routine."]
    assert run("prog.py", "plc").lines[1] == "  rung 1 removed"


def test_a_rung_that_is_there_twice(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[:2], RUNGS[1], *RUNGS[2:], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert [line for line in said.lines if line.startswith("  rung")] in (["  rung 2 added"], ["  rung 3 added"])


def test_a_moved_rung(run: Run, bundle: str) -> None:
    write("prog.py", program(RUNGS[0], RUNGS[2], RUNGS[3], RUNGS[1], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines == [
        "main",
        "  rung 2 moved to rung 4",
        "      if C3:Running",
        "        out(Y001)",
        "1 rung moved in 1 routine.",
    ]


def test_a_rung_that_moves_to_another_routine(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[:1], *RUNGS[2:], sub=SUB.replace("def wash():\n", f"def wash():\n{RUNGS[1]}\n")))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines[:2] == ["main", "  rung 2 moved to wash rung 1"]
    assert said.lines[4:6] == ["wash", "  rung 1 moved here from main rung 2"]
    assert said.lines[-1] == "1 rung moved in 2 routines."


def test_a_rung_that_changes_its_place_and_its_comment(run: Run, bundle: str) -> None:
    other = RUNGS[2].replace("How many", "How much")
    write("prog.py", program(other, *RUNGS[:2], RUNGS[3], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.lines[1:4] == ["  rung 3 moved to rung 1", "    - | How many", "    + | How much"]


def test_a_changed_rung_with_another_number(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[1:3], RUNGS[3].replace("5", "6"), sub=SUB))
    said = run(bundle, "prog.py")
    assert [line for line in said.lines if line.startswith("  rung")] == [
        "  rung 1 removed",
        "  rung 4, now rung 3, changed",
    ]


def test_only_a_comment(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[:2], RUNGS[2].replace("How many", "How many\n    # and why"), RUNGS[3], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 0
    assert said.lines == [
        "main",
        "  rung 3 comment changed",
        "      | How many",
        "    + | and why",
        "No difference in logic: 7 rungs in 2 routines.",
        "Without effect on the PLC: 1 comment changed.",
    ]


def test_a_rung_that_is_only_drawn_otherwise(run: Run, bundle: str) -> None:
    rung = RUNGS[0].replace("all(c.Start, nc(c.EStop))", "all(nc(c.EStop), c.Start)")
    write("prog.py", program(rung, *RUNGS[1:], sub=SUB, top="nickname(c.Start, c[1])\nnickname(c.EStop, c[2])\n\n\n"))
    said = run(bundle, "prog.py")
    assert said.code == 0
    assert said.lines[-1] == "Without effect on the PLC: 1 rung is drawn otherwise."


def test_long_conditions_are_compared_term_by_term(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    terms = ", ".join(f"c.Rather_long_name_{n}" for n in range(12))
    write("prog.py", program(f"    if all({terms}):\n        out(y[1])\n"))
    build("prog.py", "plc", capsys)
    write("prog.py", program(f"    if all({terms.replace('name_7', 'text_7')}):\n        out(y[1])\n"))
    marked = [line for line in run("plc", "prog.py").lines if line[4:5] in ("-", "+")]
    assert marked == ["    -    and C8:Rather_long_name_7", "    +    and C13:Rather_long_text_7"]


def test_a_proof_that_fails_is_told(run: Run, bundle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    unknown = Comparison(Likeness.UNKNOWN, "too many ways")
    monkeypatch.setattr("clickgen.commands.diff.rungs.compare", lambda *_: unknown)
    write("prog.py", program(RUNGS[0].replace("nc(c.EStop)", "c.EStop"), *RUNGS[1:], sub=SUB))
    said = run(bundle, "prog.py")
    assert (said.code, said.lines[1]) == (1, "  rung 1 changed, as far as is known (too many ways)")


def test_words_that_hide_a_difference(run: Run, bundle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    different = Comparison(Likeness.DIFFERENT, "out(Y001) has power always")
    monkeypatch.setattr("clickgen.commands.diff.rungs.compare", lambda *_: different)
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert "  rung 2 changed, which its words do not show (out(Y001) has power always)" in said.lines
    assert "      C3:Running  30 x -  out(Y001)" in said.lines


def test_a_rung_without_words_is_shown_by_its_cells(run: Run, bundle: str) -> None:
    text = Path("plc/main.csv").read_text("utf-8")
    wires = ",".join(["C3", *["-"] * 30])
    assert f"R,{wires},out(Y001)" in text
    write("plc/main.csv", text.replace(f"R,{wires},out(Y001)", f"R,{','.join(['', *['-'] * 30])},out(Y001)"))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert "    - .  30 x -  out(Y001)" in said.lines


# -- scratch cells ----------------------------------------------------------------------------------------------------

SCRATCH_PROGRAM = program(
    "    if all(c.A, nc(c.B)):\n        set(c.E)\n        rton(t.Timer, 5, unit=Ts, reset=lambda: c.E)\n", *RUNGS[1:]
)


def test_the_number_of_a_scratch_cell_is_no_logic(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    write("prog.py", SCRATCH_PROGRAM)
    build("prog.py", "plc", capsys)
    assert "C2000" in Path("plc/main.csv").read_text("utf-8")
    write("nicknames.csv", Path("nicknames.csv").read_text("utf-8").replace("C2000", "C1000"))
    said = run("plc", "prog.py")
    assert said.code == 0
    assert said.lines[0] == "No difference in logic: 7 rungs in 1 routine."
    # Where something else uses it, it is.
    write(
        "prog.py",
        SCRATCH_PROGRAM.replace("    if c.Running:\n        out(y[1])\n", "    if c[2000]:\n        out(y[1])\n"),
    )
    assert run("plc", "prog.py").code == 1


@pytest.mark.parametrize("seed", range(6))
def test_programs_with_other_scratch_cells_do_the_same(tmp_path: Path, seed: int) -> None:
    for name, text in random_draft(seed).items():
        (tmp_path / name).write_text(text, "utf-8")
    built = clickgen.build(tmp_path / "prog.py")
    assert built.scratch_rows
    rows = [row for row in built.rows if row not in built.scratch_rows]
    (tmp_path / "nicknames.csv").write_bytes(AddressTable.empty("").extended(rows).to_bytes())
    taken = Settings(reserved=tuple(Address("C", number) for number in range(1996, 2001)))
    one, other = (program_side(tmp_path / "prog.py", "prog.py", each) for each in (Settings(), taken))
    found = diff(one, other)
    assert found.drawn_otherwise
    assert (found.differs, happened(found)) == (False, [])


NUMBERED = program(
    "    if c.Go:\n        calc('ds[ds[1]] + 1', ds[2])\n",
    "    if c.Go:\n        calc('ds[ds[5]] + ds[ds[1]]', ds[3])\n",
    "    if c.A:\n        rtof(t[1], 5, unit=Ts, reset=lambda: c.B)\n",
    "    if t[1]:\n        out(y[1])\n",
    "    if c.Wash:\n        call(wash)\n",
    sub="\n\n@sub\ndef wash():\n    if nc(t[1]):\n        out(y[2])\n\n    if True:\n        return\n",
)
NAMED = "".join(f'C{n},BIT,"{name}",0,No,""\n' for n, name in enumerate(("Go", "A", "B", "Wash"), 1))
OTHER_NUMBERS = 'C1996,BIT,"Taken",0,No,""\nDS4499,INT,"Level",0,Yes,""\nDS4500,INT,"Taken_too",0,Yes,""\n'


def test_scratch_cells_of_any_bank_and_reach(run: Run) -> None:
    write("prog.py", NUMBERED)
    write("nicknames.csv", TABLE + NAMED)
    assert main(["nicknames", "sync", "prog.py"]) == 0
    write("new/prog.py", NUMBERED)
    write("new/nicknames.csv", TABLE + NAMED + OTHER_NUMBERS)
    for before, after in (("prog.py", "new/prog.py"), ("new/prog.py", "prog.py")):
        said = run(before, after)
        assert said.code == 0, said.out
        assert "rungs are drawn otherwise" in said.out
    for old, new in (
        ("ds[ds[1]] + 1", "ds[ds[2]] + 1"),
        ("nc(t[1])", "nc(t[2])"),
        ("if t[1]", "if t[2]"),
        ("+ 1", "+ 2"),
    ):
        write("new/prog.py", NUMBERED.replace(old, new))
        assert run("prog.py", "new/prog.py").code == 1


def test_a_scratch_cell_in_a_range_keeps_its_number() -> None:
    def rungs(bit: str) -> dict[str, list[DrawnRung]]:
        looks = [("X001", f"out({bit})")], [("X003", "out(C1)")], [(bit, "out(Y001)")]
        return plant(*looks, [("X002", "reset(C1990..C1999)")], [(bit, "out(Y002)")])

    assert diff(with_scratch(rungs("C2000"), "C2000"), with_scratch(rungs("C1999"), "C1999")).differs
    assert not diff(with_scratch(rungs("C2000"), "C2000"), with_scratch(rungs("C1989"), "C1989")).differs


def test_the_number_of_a_scratch_cell_that_is_shown_is_its_own(run: Run) -> None:
    write("prog.py", NUMBERED)
    write("nicknames.csv", TABLE + NAMED)
    write("new/prog.py", NUMBERED.replace("'ds[ds[1]] + 1'", "'ds[ds[1]] + 2'"))
    write("new/nicknames.csv", TABLE + NAMED + OTHER_NUMBERS)
    said = run("prog.py", "new/prog.py")
    [before] = [line for line in said.lines if "+ 1" in line]
    [after] = [line for line in said.lines if "+ 2" in line]
    assert ("DS4500" in before, "DS4498" in after) == (True, True)


@pytest.mark.property
@pytest.mark.parametrize("seed", range(4))
def test_no_numbers_hide_a_change(tmp_path: Path, seed: int) -> None:
    """Whatever the rows say of what their cells are for."""
    chance = random.Random(seed)
    for name, text in random_draft(seed).items():
        (tmp_path / name).write_text(text, "utf-8")
    taken = Settings(reserved=tuple(Address("C", number) for number in range(1996, 2001)))
    one, other = (program_side(tmp_path / "prog.py", "prog.py", each) for each in (Settings(), taken))
    assert other.table
    rows = other.scratch_rows
    reasons = [row.comment for row in rows]
    chance.shuffle(reasons)
    others = [row for row in other.table.rows if row not in rows]
    others += [replace(row, comment=reason) for row, reason in zip(rows, reasons, strict=True)]
    other = replace(other, table=AddressTable.empty("").extended(others))
    assert not diff(one, replace(one)).differs
    changed = 0
    for routine in other.routines:
        for n, rung in budget.some(list(enumerate(routine.rungs)), 4):
            new = negated(rung)
            if compare([rung], [new]).is_same:
                continue
            changed += 1
            rungs = (*routine.rungs[:n], new, *routine.rungs[n + 1 :])
            routines = tuple(replace(each, rungs=rungs) if each is routine else each for each in other.routines)
            assert diff(one, replace(other, routines=routines)).differs
    assert changed


def test_the_word_rung_in_the_name_of_a_routine() -> None:
    reasons = [f"condition of {name} rung 9: X001 == 1" for name in ("Pump rung 3", "Pump rung 4", "Pump - rung 3 x")]
    assert len({purpose_of(reason) for reason in reasons}) == 3
    assert {rung_of(reason) for reason in reasons} == {9}
    assert purpose_of("condition of Pump rung 3 rung 12") == purpose_of("condition of Pump rung 3 rung 9")
    assert rung_of("condition of Pump rung 3: out Y001 Motor") == 0


def test_a_purpose_has_no_nickname_and_no_number() -> None:
    purposes = {
        "condition of main: out Y001 Motor (12)": ("condition of main: out Y001", 12),
        "value of DS[DS1] for the formula of main: calc to DD1 My sum": (
            "value of DS[DS1] for the formula of main: calc to DD1",
            0,
        ),
        "condition of main: shift C1..C8 (2)": ("condition of main: shift C1..C8", 2),
        "condition of main: call C1 pump": ("condition of main: call C1 pump", 0),
        "rtof T1: on while its rung is true": ("rtof T1: on while its rung is true", 0),
    }
    assert {comment: (purpose_of(comment), rung_of(comment)) for comment in purposes} == purposes


def ladder(*rungs: tuple[str, str]) -> dict[str, list[DrawnRung]]:
    lines = [",".join(["R", contact, *["-"] * 30, output]) for contact, output in rungs]
    return {"main": list(read_ladder("\n".join([",".join(HEADER), *lines]), "main.csv").rungs)}


def test_rungs_that_do_together_what_one_does() -> None:
    row = default_row(Address("C", 2000), "Scratch_C2000", "part of condition of main rung 1: X001")
    table = AddressTable.empty("nicknames.csv").extended([row])
    one = side(ladder(("X001", "out(Y001)"), ("X002", "out(Y002)")))
    split = ("X001", "out(C2000)"), ("C2000", "out(Y001)")
    found = diff(one, replace(side(ladder(*split, ("X002", "out(Y002)"))), table=table))
    assert (found.differs, happened(found), found.drawn_otherwise) == (False, [], 2)
    found = diff(one, replace(side(ladder(*split, ("C2000", "out(Y002)"))), table=table))
    assert found.differs
    assert diff(one, side(ladder(*split, ("X002", "out(Y002)")))).differs
    first, *others = ladder(*split, ("X002", "out(Y002)"))["main"]
    found = diff(one, replace(side({"main": [replace(first, comment="why"), *others]}), table=table))
    assert (found.differs, happened(found)) == (False, [(COMMENTED, "main", 1)])


Drawing = Sequence[tuple[str, str]]
"""Rows of a rung: contacts, ``.`` for a blank square; and the output."""

END_RUNG: Drawing = [("-", "end()")]


def plant(*drawings: Drawing) -> dict[str, list[DrawnRung]]:
    """A main with these rungs and an end."""
    rows = [wired(*row, "" if n else "R") for drawing in (*drawings, END_RUNG) for n, row in enumerate(drawing)]
    return {"main": list(read_ladder(ladder_text(rows), "main.csv").rungs)}


def write_plant(folder: str, *drawings: Drawing) -> None:
    rows = [wired(*row, "" if n else "R") for drawing in (*drawings, END_RUNG) for n, row in enumerate(drawing)]
    write(f"{folder}/main.csv", ladder_text(rows))


def test_nothing_is_paired_across_what_stays(run: Run) -> None:
    counter = [("X003 ~C5 T", "latch(C5)"), (". . -", "count_up(CT1,CTD1,preset=10)"), (".", ""), ("X004", ".reset()")]
    write_plant("plant", [("X001 X002", "out(C5)")], counter)
    box = "    if all(x[3], nc(c[5])):\n        set(c[5])\n        ctu(ct[1], 10, reset=lambda: x[4])\n"
    coil = "    if all(x[2], x[1]):\n        out(c[5])\n"
    write("prog.py", program(box, coil))
    assert (run("plant", "prog.py").code, run("prog.py", "plant").code) == (1, 1)
    write("prog.py", program(coil, box))
    assert (run("plant", "prog.py").code, run("prog.py", "plant").code) == (0, 0)


def with_scratch(rungs: dict[str, list[DrawnRung]], *addresses: str, reason: str = "condition of main rung 9") -> Side:
    """A side with these addresses for clickgen's own use."""
    found = [parse_address(address) for address in addresses]
    rows = [default_row(address, scratch_name(address), reason) for address in found if address]
    return replace(side(rungs), table=AddressTable.empty("nicknames.csv").extended(rows))


def test_each_side_has_its_own_scratch_cells() -> None:
    one, other = ladder(("X001", "out(C2000)")), ladder(("X001", "out(C1999)"))
    assert diff(with_scratch(one, "C1999"), with_scratch(other, "C2000")).differs
    kept = plant([("X001 X002", "out(C2000)")], [("C2000", "out(Y001)")])
    plain = plant([("X001 X002", "out(Y001)")])
    assert diff(side(kept), with_scratch(plain, "C2000")).differs
    assert not diff(with_scratch(kept, "C2000"), side(plain)).differs


# -- one rung on one side, several on the other -----------------------------------------------------------------------

MIXED: Drawing = [
    ("X001 T", "out(Y001)"),
    (". -", "count_up(CT1,CTD1,preset=5)"),
    (".", ""),
    ("X002", ".reset()"),
]
DIVIDED: tuple[Drawing, ...] = (
    [("X001", "out(Y001)")],
    [("X001", "count_up(CT1,CTD1,preset=5)"), (".", ""), ("X002", ".reset()")],
)
LOOP: Drawing = [("-", "for(5)")]
NEXT: Drawing = [("-", "next()")]


@pytest.mark.parametrize("is_twice", [False, True])
@pytest.mark.parametrize(
    ("one", "other"),
    [
        ([MIXED], DIVIDED),
        ([[("X003", "out(C9)")], MIXED, [("X001", "out(Y001)")]], [[("X003", "out(C9)")], *DIVIDED, DIVIDED[0]]),
        ([LOOP, MIXED, NEXT], [LOOP, *DIVIDED, NEXT]),
        ([[("C1 T", "out(C2)"), (". -", "out(C3)")]], [[("C1", "out(C2)")], [("C1", "out(C3)")]]),
        (
            [[("C1 T", "out(C2)"), (". -", "out(C3)")], [("C1", "out(C4)")]],
            [[("C1", "out(C2)")], [("C1 T", "out(C3)"), (". -", "out(C4)")]],
        ),
    ],
)
def test_a_rung_that_is_divided_stays(one: Sequence[Drawing], other: Sequence[Drawing], is_twice: bool) -> None:
    times = 2 if is_twice else 1
    for before, after in ((one, other), (other, one)):
        found = diff(side(plant(*[*before] * times)), side(plant(*[*after] * times)))
        assert (found.differs, happened(found)) == (False, [])
        assert found.drawn_otherwise
        if len(after) > 1:
            assert diff(side(plant(*before)), side(plant(*after[::-1]))).differs
        added = diff(side(plant(*before)), side(plant(*after, [("X009", "out(Y009)")])))
        assert [kind for kind, *_ in happened(added)] == [ADDED]


def test_a_divided_rung_is_no_pretext() -> None:
    """What an earlier part drives must not be looked at by a later one."""
    whole: Drawing = [("C1 T", "out(C1)"), (". -", "out(C2)")]
    parts: tuple[Drawing, ...] = ([("C1", "out(C1)")], [("C1", "out(C2)")])
    assert not diff(side(plant(whole)), side(plant(whole))).differs
    other: tuple[Drawing, ...] = ([("~X001 C1", "out(C1)")], [("C1", "out(C2)")])
    joined: Drawing = [("C1 T ~X001", "out(C1)"), (". -", "out(C2)")]
    assert diff(side(plant(whole)), side(plant(*parts))).differs
    assert diff(side(plant(joined)), side(plant(*other))).differs


def test_a_tall_rung_that_is_divided_stays() -> None:
    wires = ["X001 T", *[". T"] * 30, ". -"]
    tall = [(wire, f"out(C{n})") for n, wire in enumerate(wires, 1)]
    single_ones = [[("X001", f"out(C{n})")] for n in range(1, 33)]
    assert not diff(side(plant(tall)), side(plant(*single_ones))).differs
    assert diff(side(plant(tall)), side(plant(*single_ones[:-1]))).differs


# -- rungs that do nothing --------------------------------------------------------------------------------------------


def test_a_rung_that_does_nothing_is_no_logic(run: Run) -> None:
    coil: Drawing = [("X001", "out(Y001)")]
    write_plant("plant", coil)
    for number, idle in enumerate(([("-", "NOP")], [("X002", "")])):
        write_plant("new", coil, idle)
        said = run("plant", "new")
        assert said.code == 0, number
        assert said.lines[:2] == ["main", "  rung 2, which does nothing, added"]
        assert "Without effect on the PLC: 1 comment changed." in said.lines
        said = run("new", "plant")
        assert (said.code, said.lines[1]) == (0, "  rung 2, which does nothing, removed")
        text = Path("new/main.csv").read_text("utf-8")
        marker = text.split("\n")[2]
        write("new/main.csv", text.replace(marker, f"#,Valves\n{marker}"))
        said = run("plant", "new")
        assert (said.code, said.lines[2]) == (0, "    + | Valves")


# -- routines ---------------------------------------------------------------------------------------------------------


def test_routines_that_come_and_go(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS, sub=SUB.replace("wash", "rinse").replace("c.Wash", "c.Rinse")))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines[:6] == [
        "rinse added (2 rungs)",
        "  rung 1 added",
        "    + if C6:Rinse",
        "    +   out(C5:Valve)",
        "  rung 2 added",
        "    + always",
    ]
    place = said.lines.index("wash removed (2 rungs)")
    assert said.lines[place + 1 : place + 4] == ["  rung 1 removed", "    - if C4:Wash", "    -   out(C5:Valve)"]
    assert said.lines[-3] == "1 routine added; 1 routine removed."


def test_the_rungs_of_a_large_routine_are_counted(run: Run, bundle: str) -> None:
    rungs = "\n".join(f"    if c[{n}]:\n        out(c[{n + 100}])\n" for n in range(100, 120))
    write("prog.py", program(*RUNGS, sub=f"{SUB}\n\n@sub\ndef more():\n{rungs}\n    if True:\n        return\n"))
    assert run(bundle, "prog.py").lines == ["more added (21 rungs)", "1 routine added."]
    assert run("prog.py", bundle).lines == ["more removed (21 rungs)", "1 routine removed."]


def test_a_renamed_routine(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS, sub=SUB.replace("wash", "rinse")))
    said = run(bundle, "prog.py")
    assert (said.code, said.lines) == (1, ["wash renamed to rinse (2 rungs)", "1 routine renamed."])


def test_the_order_of_routines_is_no_logic(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    other = SUB.replace("wash", "air").replace("c.Wash", "c.Air").replace("c.Valve", "c.Fan")
    write("prog.py", program(*RUNGS, sub=SUB + other))
    build("prog.py", "plc", capsys)
    write("prog.py", program(*RUNGS, sub=other + SUB))
    assert run("plc", "prog.py").code == 0


def test_a_long_main_in_several_files(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    rungs = [f"    if c[{n % 1000 + 1}]:\n        set(y[{n % 16 + 1}])\n" for n in range(600)]
    write("prog.py", program(*rungs))
    build("prog.py", "plc", capsys)
    assert len(list(Path("plc").glob("main*.csv"))) > 1
    assert run("prog.py", "plc").code == 0
    write("prog.py", program(*rungs[:449], *rungs[450:]))
    said = run("plc", "prog.py")
    assert [line for line in said.lines if line.startswith("  rung")] == ["  rung 450 removed"]


# -- one file alone ---------------------------------------------------------------------------------------------------


def test_a_file_is_compared_with_its_routine(run: Run, bundle: str) -> None:
    said = run("prog.py", f"{bundle}/subroutines/wash.csv")
    assert said.code == 0
    assert said.lines[0] == "No difference in logic: 2 rungs in 1 routine."
    assert "one routine, which is compared with wash alone" in said.out
    assert run(f"{bundle}/main.csv", "prog.py").code == 0
    os.rename(f"{bundle}/subroutines/wash.csv", "copied.csv")
    said = run("copied.csv", "prog.py")
    assert (said.code, "compared with wash alone" in said.out) == (0, True)
    assert "copied.csv has no nicknames.csv" in said.out


def test_what_click_works_on(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    rung = "    # Start\n    if all(c.Start, nc(c.EStop)):\n        out(c.Running)\n"
    write("prog.py", program(rung, RUNGS[1], "    if c.Running:\n        call(wash)\n", sub=SUB))
    build("prog.py", "plc", capsys)
    Path("click").mkdir()
    for number, name in enumerate(("main", "subroutines/wash"), 1):
        rungs: list[tuple[str, list[list[str]]]] = []
        comment = ""
        for fields in csv.reader(Path(f"plc/{name}.csv").read_text("utf-8").splitlines()[1:]):
            if fields[0] == "#":
                comment = fields[1]
            elif fields[0]:
                rungs.append((comment, [fields[1:]]))
                comment = ""
            else:
                rungs[-1][1].append(fields[1:])
        title = "Main Program" if number == 1 else "wash"
        Path(f"click/Scr{number}.tmp").write_bytes(program_file(title, number, rungs))
    said = run("click", "prog.py")
    assert said.code == 0, said.out
    Path("click/Scr3.tmp").write_bytes(Path("click/Scr2.tmp").read_bytes())
    assert "the same routine as" in run("click", "prog.py").err
    Path("click/Scr3.tmp").unlink()
    assert said.lines[0] == "No difference in logic: 6 rungs in 2 routines."
    assert run("click/Scr2.tmp", "prog.py").code == 0
    write("prog.py", Path("prog.py").read_text("utf-8").replace("nc(c.EStop)", "c.EStop"))
    assert run("click", "prog.py").lines[:4] == [
        "main",
        "  rung 1 changed",
        "      | Start",
        "    - if C1:Start and not C2:EStop",
    ]


def test_a_subroutine_with_another_name_in_click(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    write("prog.py", program("    if c.A:\n        call(wash)\n", sub=SUB.replace("@sub", '@sub("Wash 2")')))
    build("prog.py", "plc", capsys)
    assert run("plc", "prog.py").code == 0


def test_colours_stand_on_terminals_alone(run: Run, bundle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    text = Path("plc/main.csv").read_text("utf-8")
    write("plc/main.csv", text.replace("#,Start and stop", "#,Start \x1b[7m and stop").replace(",~C2,", ",C2,"))
    plain = run("prog.py", bundle).out
    assert "\x1b" not in plain
    monkeypatch.setattr("clickgen.cli.diff.use_color", lambda _: True)
    painted = run("prog.py", bundle).out
    assert "\x1b[31m    - if C1:Start and not C2:EStop\x1b[0m\n" in painted
    assert re.sub("\x1b\\[(0|31|32)m", "", painted) == plain


# -- nicknames and addresses ------------------------------------------------------------------------------------------


def test_a_renamed_nickname_is_no_logic(run: Run, bundle: str) -> None:
    text = Path("plc/nicknames.csv").read_text("utf-8")
    write("plc/nicknames.csv", text.replace('"EStop"', '"Emergency"'))
    said = run("prog.py", bundle)
    assert said.code == 0
    assert said.lines == [
        "Nicknames",
        "  ~ C2 EStop -> Emergency (renamed)",
        "No difference in logic: 7 rungs in 2 routines.",
        "Without effect on the PLC: 1 nickname or its comment differs.",
    ]


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ('DS1,INT,"Count",7,Yes,""', "DS1:Count: initial value 0 -> 7"),
        ('DS1,INT,"Count",0,No,""', "DS1:Count: retentive Yes -> No"),
    ],
)
def test_initial_values_and_retention_are_logic(run: Run, bundle: str, row: str, said: str) -> None:
    text = Path("plc/nicknames.csv").read_text("utf-8")
    write("plc/nicknames.csv", text.replace('DS1,INT,"Count",0,Yes,""', row))
    found = run("prog.py", bundle)
    assert (found.code, found.lines) == (1, ["Addresses", f"  {said}", "1 address setting changed."])


def test_another_spelling_of_a_value_is_none(run: Run, bundle: str) -> None:
    text = Path("plc/nicknames.csv").read_text("utf-8")
    write("plc/nicknames.csv", text.replace('DS1,INT,"Count",0,Yes,""', 'DS1,INT,"Count",00,Yes,""'))
    assert run("prog.py", bundle).code == 0


def test_ladder_without_a_table_borrows_names(run: Run, bundle: str) -> None:
    os.remove("plc/nicknames.csv")
    write("prog.py", program(RUNGS[0].replace("c.EStop", "c.Stop"), *RUNGS[1:], sub=SUB))
    said = run(bundle, "prog.py")
    assert "    - if C1:Start and not C2:EStop" in said.lines
    assert said.lines[-2] == "Note: initial values and retention are not compared: plc has no nicknames.csv."
    write("export.csv", TABLE + 'C2,BIT,"Emergency",0,No,""\nDS1,INT,"Count",7,Yes,""\n')
    said = run(bundle, "prog.py", "--export", "export.csv")
    assert "    - if C1 and not C2:Emergency" in said.lines
    assert "  DS1:Count: initial value 7 -> 0" in said.lines
    assert run("prog.py", "prog.py", "--nicknames", "missing.csv").code == 2


@pytest.mark.parametrize("text", ["", "no table"])
def test_a_bad_table_does_not_stop_the_diff(run: Run, bundle: str, text: str) -> None:
    write("plc/nicknames.csv", text)
    said = run("prog.py", bundle)
    assert said.code == 0
    assert "initial values and retention are not compared: plc/nicknames.csv" in said.out.replace("\\", "/")


@pytest.mark.parametrize(
    ("row", "code"),
    [
        ('C9999,BIT,"None",0,No,""', 0),
        ('DS77,INT,"Far",many,Yes,""', 0),
        ('DS1,INT,"Count",many,Yes,""', 1),
        ('DS1,INT,"Count",0,Perhaps,""', 1),
        ('DS1,BIT,"Count",0,Yes,""', 1),
        ('DS1,INT,"Count,0,Yes,""', 1),
        ('DS1,INT,"No name!",0,Yes,""', 0),
        ('DS1,INT,"Count",0,Yes,"\u00e9\u00e9"', 0),
    ],
)
def test_rows_that_cannot_be_read_are_left_out(run: Run, bundle: str, row: str, code: int) -> None:
    text = Path("plc/nicknames.csv").read_text("utf-8")
    assert 'DS1,INT,"Count",0,Yes,""\n' in text
    kept = text if row[:4] != "DS1," else text.replace('DS1,INT,"Count",0,Yes,""\n', "")
    write("plc/nicknames.csv", f"{kept}{row}\n")
    for before, after in ((bundle, "prog.py"), ("prog.py", bundle)):
        said = run(before, after)
        assert said.code == code, said.out
        assert (
            "DS1" in said.out and "initial value and retention" in said.out and "cannot be read" in said.out
        ) == code
    # The other rows are compared.
    changed = kept.replace('DS2,INT,"Shown",0,Yes', 'DS2,INT,"Shown",8,Yes')
    assert changed != kept
    write("plc/nicknames.csv", f"{changed}{row}\n")
    said = run(bundle, "prog.py")
    assert (said.code, "  DS2:Shown: initial value 8 -> 0" in said.lines) == (1, True)


def test_the_same_bad_row_on_both_sides_is_none(run: Run, bundle: str) -> None:
    write("plc/nicknames.csv", Path("plc/nicknames.csv").read_text("utf-8").replace('"Count",0,', '"Count",many,'))
    shutil.copytree(bundle, "copy")
    said = run(bundle, "copy")
    assert (said.code, "left out: plc/nicknames.csv" in said.out.replace("\\", "/")) == (0, True)


# -- names without an address -----------------------------------------------------------------------------------------


def swapped(text: str) -> str:
    return text.replace("Foo", "@").replace("Bar", "Foo").replace("@", "Bar")


FOO_AND_BAR = ("    if c.Foo:\n        out(y[1])\n", "    if c.Bar:\n        out(y[2])\n")


@pytest.mark.parametrize(
    ("new", "code"),
    [
        (FOO_AND_BAR, 0),
        (tuple(map(swapped, FOO_AND_BAR)), 1),
        ((FOO_AND_BAR[0], FOO_AND_BAR[1].replace("Bar", "Baz")), 1),
        # What the older side chose is something else here.
        ((FOO_AND_BAR[0], "    if c[1]:\n        out(y[2])\n"), 1),
        (("    if c[1]:\n        out(y[1])\n", FOO_AND_BAR[1].replace("Bar", "Foo")), 1),
    ],
)
def test_names_without_addresses_are_compared_by_name(run: Run, new: Sequence[str], code: int) -> None:
    write("old.py", program(*FOO_AND_BAR))
    write("new/new.py", program(*new))
    said = run("old.py", "new/new.py")
    assert said.code == code
    assert "of old.py have no addresses yet" in said.out
    assert "renamed" not in said.out
    assert run("new/new.py", "old.py").code == code or "c[1]" in "".join(new)
    assert list(Path().rglob("nicknames.csv")) == []


def test_names_keep_their_place_where_others_come_before_them(run: Run) -> None:
    write("old.py", program(*FOO_AND_BAR))
    write("new.py", program("    if c.First:\n        out(y[3])\n", *FOO_AND_BAR))
    said = run("old.py", "new.py")
    assert [line for line in said.lines if line.startswith("  rung")] == ["  rung 1 added"]
    assert "Note: names without addresses on both sides are compared by name." in said.lines


def test_a_row_of_the_table_wins(run: Run) -> None:
    write("old.py", program(*FOO_AND_BAR))
    write("new/new.py", program(*FOO_AND_BAR))
    write("new/nicknames.csv", TABLE + 'C2,BIT,"Foo",0,No,""\n')
    said = run("old.py", "new/new.py")
    assert (said.code, "    - if C1:Foo" in said.lines, "    + if C2:Foo" in said.lines) == (1, True, True)


# -- what stops it ----------------------------------------------------------------------------------------------------


def test_a_program_with_errors(run: Run, bundle: str) -> None:
    write("prog.py", "def main():\n    if c.A:\n        nothing(c.B)\n    if True:\n        end()\n")
    said = run(bundle, "prog.py")
    assert (said.code, said.out) == (2, "")
    assert "prog.py:3:9: error[" in said.err
    assert said.err.endswith("clickgen: prog.py has 1 error; there is nothing to compare\n")


def test_damaged_ladder(run: Run, bundle: str) -> None:
    text = Path("plc/main.csv").read_text("utf-8")
    write("plc/main.csv", text.replace("latch(C3)", "latch(C3)", 1).replace(",~C2,", ",~Q2,"))
    said = run("prog.py", bundle)
    assert (said.code, said.out) == (2, "")
    assert said.err.replace("\\", "/") == (
        "clickgen: plc is damaged; what is left is not compared:\n"
        "  plc/main.csv:3: column B holds '~Q2', which is no contact and no wire\n"
    )


@pytest.mark.parametrize("wrong", ["missing.py", "C:\\plc\\prog.py", "C:/plc/prog.py", "empty"])
def test_what_is_not_there(run: Run, bundle: str, wrong: str) -> None:
    """``.`` with one program in it is that program; a folder without ladder and program is nothing."""
    Path("empty").mkdir()
    said = run(wrong, bundle)
    assert (said.code, said.out) == (2, "")
    assert "git" not in said.err.split("; a revision")[0]
    assert said.err.startswith("clickgen: ")


def test_the_flags(run: Run) -> None:
    assert run().code == 2
    assert run("one").code == 2
    said = run("--help")
    assert said.code == 0
    assert "exit codes: 0 no difference in logic; 1 logic differs; 2 could not run" in said.out


def test_json(run: Run, bundle: str) -> None:
    write("prog.py", program(RUNGS[0].replace("c.EStop", "c.Stop"), *RUNGS[1:], sub=SUB))
    said = run(bundle, "prog.py", "--output-format", "json")
    found = json.loads(said.out)
    assert (said.code, found["version"], found["differs"]) == (1, 1, True)
    assert found["rungs"] == {name: int(name == "changed") for name in (*KINDS, "drawn_otherwise")}
    [change] = found["routines"][0]["changes"]
    assert change["old"]["words"] == ["if C1:Start and not C2:EStop", "  latch(C3:Running)"]
    assert change["new"]["number"] == 1
    assert change["reason"].startswith("latch(C3) has power with ")
    write("prog.py", program(*RUNGS[1:], sub=SUB))
    [routine] = json.loads(run(bundle, "prog.py", "--output-format", "json").out)["routines"]
    [change] = routine["changes"]
    assert (change["kind"], change["new"], change["old"]["number"]) == ("removed", None, 1)


# -- git --------------------------------------------------------------------------------------------------------------


def git(*words: str) -> str:
    if not shutil.which("git"):
        pytest.skip("there is no git")
    who = ["-c", "user.name=Test", "-c", "user.email=test@example.org", "-c", "commit.gpgsign=false"]
    done = subprocess.run(["git", *who, *words], capture_output=True, encoding="utf-8", check=True)
    return done.stdout.strip()


@pytest.fixture
def repository(run: Run) -> Run:
    """A repository with prog.py and its table, committed."""
    git("init", "--quiet", "--initial-branch=main")
    write("prog.py", program(*RUNGS))
    assert main(["nicknames", "sync", "prog.py"]) == 0
    commit()
    return run


def commit() -> None:
    git("add", "--all")
    git("commit", "--quiet", "--message=x")


CHANGED_RUNGS = (RUNGS[0].replace("nc(c.EStop)", "c.EStop"), *RUNGS[1:])


def test_a_revision(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert repository("HEAD:prog.py", "prog.py").code == 0
    write("prog.py", program(*CHANGED_RUNGS))
    status = git("status", "--porcelain")
    said = repository("HEAD:prog.py", "prog.py")
    assert said.code == 1
    assert said.out.startswith("--- HEAD:prog.py\n+++ prog.py\n")
    assert said.lines[:5] == [
        "main",
        "  rung 1 changed",
        "      | Start and stop",
        "    - if C1:Start and not C2:EStop",
        "    + if C1:Start and C2:EStop",
    ]
    assert repository(":prog.py", "prog.py").code == 1
    git("add", "prog.py")
    assert repository(":prog.py", "prog.py").code == 0
    assert repository(":prog.py", "HEAD:prog.py").code == 1
    git("reset", "--quiet")
    assert git("status", "--porcelain") == status
    commit()
    assert repository("HEAD~1:prog.py", "main:prog.py").code == 1
    assert repository("HEAD^{/x}:prog.py", "prog.py").code == 0


def test_a_revision_has_its_own_surroundings(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """Table, settings and imported files are those of the revision, and what is gone from disk is there."""
    write("plc/clickgen.toml", 'programs = [{ path = "line.py", nicknames = "names/line.csv" }]\n')
    write("plc/names/line.csv", TABLE + 'C77,BIT,"Wash",0,No,"old"\n')
    write("plc/parts.py", SUB.strip() + "\n")
    write("plc/line.py", "from parts import wash\n\n\n" + program("    if c.Go:\n        call(wash)\n"))
    commit()
    git("rm", "-r", "--quiet", "plc/names", "plc/clickgen.toml", "plc/parts.py")
    write("plc/line.py", program("    if c.Go:\n        call(wash)\n", sub=SUB))
    os.chdir("plc")
    capsys.readouterr()
    said = repository("HEAD:line.py", "line.py")
    assert said.out.startswith("--- HEAD:plc/line.py\n+++ line.py\n")
    assert "    - if C77:Wash" in said.lines
    assert said.err == ""
    assert repository("HEAD:./line.py", "HEAD:plc/line.py").code == 0


def test_named_settings_and_tables_are_those_of_the_revision(
    repository: Run, capsys: pytest.CaptureFixture[str]
) -> None:
    write("conf/own.toml", 'reserved = ["C1..C100"]\nprograms = [{ path = "../prog.py", nicknames = "empty.csv" }]\n')
    write("conf/empty.csv", TABLE)
    commit()
    write("conf/own.toml", 'reserved = ["C1..C200"]\nprograms = [{ path = "../prog.py", nicknames = "empty.csv" }]\n')
    write("conf/empty.csv", TABLE + 'C777,BIT,"EStop",0,No,""\n')
    capsys.readouterr()
    said = repository("HEAD:prog.py", "prog.py", "--config", "conf/own.toml")
    assert "    - if C101:Start and not C102:EStop" in said.lines
    assert "    + if C201:Start and not C777:EStop" in said.lines
    said = repository("HEAD:prog.py", "prog.py", "--nicknames", "conf/empty.csv")
    assert "    - if C1:Start and not C2:EStop" in said.lines
    assert "    + if C1:Start and not C777:EStop" in said.lines
    # What the revision does not have is read from disk.
    write("conf/new.csv", TABLE + 'C888,BIT,"EStop",0,No,""\n')
    assert repository("HEAD:prog.py", "prog.py", "--nicknames", "conf/new.csv").code == 0


def test_what_is_not_merged_is_not_in_the_index(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    git("switch", "--quiet", "--create", "other")
    write("prog.py", program(*CHANGED_RUNGS))
    commit()
    git("switch", "--quiet", "main")
    write("prog.py", program(RUNGS[0].replace("c.Start", "c.Go"), *RUNGS[1:]))
    commit()
    with pytest.raises(subprocess.CalledProcessError):
        git("merge", "other")
    capsys.readouterr()
    said = repository(":prog.py", "HEAD:prog.py")
    assert (said.code, said.err) == (2, "clickgen: :prog.py is not merged: there is no file to compare\n")


def test_the_root_comes_first_as_for_git(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    write("sub/prog.py", program(*CHANGED_RUNGS))
    commit()
    os.chdir("sub")
    capsys.readouterr()
    said = repository("HEAD:prog.py", "../prog.py")
    assert said.code == 0
    assert said.err == (
        "clickgen: HEAD:prog.py is prog.py of the repository's root, as for git; "
        "the one in the working folder is HEAD:./prog.py\n"
    )
    assert repository("HEAD:./prog.py", "HEAD:../prog.py").code == 1


def test_a_bundle_of_a_revision(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    build("prog.py", "out/prog", capsys)
    commit()
    write("prog.py", program(*CHANGED_RUNGS))
    said = repository("HEAD:out/prog", "prog.py")
    assert said.code == 1
    assert "    - if C1:Start and not C2:EStop" in said.lines
    assert repository("HEAD:out/prog/main.csv", "HEAD:prog.py").code == 0
    assert repository("HEAD:out/prog/", "HEAD:out/prog").code == 0


def test_a_path_that_is_there_wins(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    if os.name == "nt":
        pytest.skip("no colon in a file name")
    write("HEAD:prog.py", program(*CHANGED_RUNGS))
    capsys.readouterr()
    assert repository("HEAD:prog.py", "prog.py").code == 1


def test_a_program_of_a_revision_with_errors(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    write("prog.py", "import gone\n\n\n" + program("    if c.A:\n        nothing(c.B)\n"))
    commit()
    capsys.readouterr()
    said = repository("HEAD:prog.py", "HEAD~1:prog.py")
    assert said.code == 2
    assert "HEAD:prog.py:6:9: error[" in said.err
    assert "6 |         nothing(c.B)" in said.err
    assert "there is no file HEAD:gone.py" in said.err
    assert "clickgen-" not in said.err


@pytest.mark.parametrize(
    ("side", "reason"),
    [
        ("nowhere:prog.py", "git knows no revision nowhere"),
        ("--all:prog.py", "git knows no revision --all"),
        ("HEAD:other.py", "the revision HEAD has no other.py"),
        ("HEAD:../prog.py", "the revision HEAD has no ../prog.py"),
        ("HEAD:", "names no file or folder"),
        ("HEAD:/etc/prog.py", "names no file or folder"),
        ("HEAD:link.py", "HEAD:link.py is a link"),
        ("HEAD:large.py", "is kept in Git LFS"),
        ("HEAD:large/", "is kept in Git LFS"),
        ("HEAD:empty", "HEAD:empty holds neither main.csv"),
    ],
)
def test_what_a_revision_lacks(repository: Run, capsys: pytest.CaptureFixture[str], side: str, reason: str) -> None:
    pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 12\n"
    write("large.py", pointer)
    write("large/main.csv", pointer)
    write("empty/note.txt", "")
    if os.name != "nt":
        os.symlink("prog.py", "link.py")
    commit()
    capsys.readouterr()
    said = repository("--", side, "prog.py")
    assert (said.code, said.out) == (2, "")
    assert reason in said.err
    assert "clickgen-" not in said.err


def test_no_name_of_a_tree_leaves_the_folder(repository: Run) -> None:
    """Trees that git itself would never make."""

    def hashed(kind: str, data: bytes) -> str:
        command = ["git", "hash-object", "-t", kind, "-w", "--literally", "--stdin"]
        return subprocess.run(command, input=data, capture_output=True, check=True).stdout.decode().strip()

    def tree(mode: str, name: str, what: str) -> bytes:
        return f"{mode} {name}\0".encode() + bytes.fromhex(what)

    blob = hashed("blob", b"evil")
    inner = hashed("tree", tree("100644", "main.csv", blob))
    main_csv = hashed("blob", (",".join(HEADER) + "\n").encode())
    up = hashed("tree", tree("40000", "..", inner) + tree("100644", "main.csv", main_csv))
    root = hashed("tree", tree("40000", "plc", up))
    said = repository(f"{root}:plc", "prog.py")
    assert said.code == 2
    assert "plc/../main.csv is no name that a file can have here" in said.err


@pytest.mark.skipif(not shutil.which("git"), reason="there is no git")
def test_without_a_repository(run: Run, bundle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(Path.cwd().parent))
    assert "in no git repository" in run("HEAD:prog.py", bundle).err
    monkeypatch.setenv("PATH", "")
    said = run("HEAD:prog.py", bundle)
    assert (said.code, "needs git" in said.err) == (2, True)


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("HEAD~1:prog.py", ("HEAD~1", "prog.py")),
        ("main@{10:30}:a/prog.py", ("main@{10:30}", "a/prog.py")),
        (":prog.py", ("", "prog.py")),
        ("v1:./prog.py", ("v1", "./prog.py")),
        ("C:prog.py", ("C", "prog.py")),
        ("C:\\x\\prog.py", None),
        ("c:/x/prog.py", None),
        ("C:", None),
        ("prog.py", None),
    ],
)
def test_what_names_a_revision(text: str, named: tuple[str, str] | None) -> None:
    found = named_revision(text)
    assert (tuple(found) if found else None) == named


# -- matching ---------------------------------------------------------------------------------------------------------

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


# -- properties -------------------------------------------------------------------------------------------------------


def side(files: dict[str, list[DrawnRung]]) -> Side:
    return Side("a", tuple(DrawnRoutine(name, name == "main", tuple(rungs), name) for name, rungs in files.items()))


def drawn(program: Program) -> dict[str, list[DrawnRung]]:
    """The rungs of each routine as they are drawn."""
    files = ladder_files(program.texts)
    return {Path(name).stem: list(read_ladder(text, name).rungs) for name, text in files.items()}


def happened(difference: Difference) -> list[tuple[str, str, int]]:
    """What happened to which rung; of an added one its new number."""
    found = []
    for routine in difference.routines:
        for change in routine.changes:
            rung = change.one or change.other
            assert rung
            found.append((change.kind, routine.name, rung.number))
    return found


programs = st.one_of(power_programs(), meaning_programs())


@given(programs)
@examples(6)
def test_nothing_differs_from_itself(program: Program) -> None:
    found = diff(side(drawn(program)), side(drawn(program)))
    assert (found.differs, happened(found), found.drawn_otherwise) == (False, [], 0)


def words(rung: DrawnRung) -> tuple[str, ...]:
    return Wording(Names({}), Names({})).rung("", 1, rung).lines


@st.composite
def edited(draw: st.DrawFn, kind: str) -> tuple[Side, Side, int, bool]:
    """A program before and after something is done to a rung of main, which rung, and whether it has a double."""
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


def negated(rung: DrawnRung) -> DrawnRung:
    """The rung with its first contact the other way round."""
    rows = list(rung.rows)
    for index, row in enumerate(rows):
        for column, square in enumerate(row.squares):
            if isinstance(square.contact, Contact) and not square.contact.edge:
                contact = replace(square.contact, negated=not square.contact.negated)
                squares = [*row.squares]
                squares[column] = replace(square, contact=contact)
                rows[index] = replace(row, squares=tuple(squares))
                return replace(rung, rows=tuple(rows))
    return rung


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


# -- revisions and folders without a program's name -------------------------------------------------------------------


def test_two_revisions_without_a_path_are_the_only_program(repository: Run) -> None:
    write("prog.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")  # What came before it was said.
    named = repository("HEAD~1:./prog.py", "HEAD:./prog.py")
    assert named.code == 1
    assert repository("HEAD~1", "HEAD") == named
    for sides in (("HEAD~1", "prog.py"), ("HEAD~1", "HEAD:prog.py"), ("HEAD~1", ":prog.py"), ("HEAD~1", "HEAD", "-q")):
        assert repository(*sides).code == 1
    assert repository("HEAD", "prog.py").code == 0


def test_two_revisions_without_a_path_are_every_program_of_the_settings(repository: Run) -> None:
    write("packer/packer.py", program(*RUNGS))
    write("clickgen.toml", 'programs = ["prog.py", "packer/packer.py"]\n')
    commit()
    write("packer/packer.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")
    said = repository("HEAD~1", "HEAD")
    assert said.code == 1
    assert said.out.startswith("--- HEAD~1:prog.py\n")
    assert "--- HEAD~1:packer/packer.py\n+++ HEAD:packer/packer.py\n" in said.out
    told = repository("HEAD~1", "HEAD", "--output-format", "json")
    found = json.loads(told.out)
    assert (told.code, found["version"], found["differs"]) == (1, 1, True)
    assert [(each["old"], each["differs"]) for each in found["programs"]] == [
        ("HEAD~1:prog.py", False),
        ("HEAD~1:packer/packer.py", True),
    ]
    assert repository("HEAD~1", "packer/packer.py").code == 1


def test_a_program_that_came_or_went_with_a_revision(repository: Run) -> None:
    write("clickgen.toml", 'programs = ["prog.py"]\n')
    commit()
    write("packer/packer.py", program(*RUNGS))
    write("clickgen.toml", 'programs = ["prog.py", "packer/packer.py"]\n')
    commit()
    repository("prog.py", "prog.py")
    said = repository("HEAD~1", "HEAD")
    assert said.code == 1
    assert "HEAD:packer/packer.py is new: there is no packer/packer.py in HEAD~1\n" in said.out
    assert "main added" in said.out
    back = repository("HEAD", "HEAD~1", "-q")
    assert back.code == 1
    assert "HEAD:packer/packer.py was removed: there is no packer/packer.py in HEAD~1\n" in back.out
    found = json.loads(repository("HEAD~1", "HEAD", "--output-format", "json").out)
    assert [(each["old"], each["new"], each["differs"]) for each in found["programs"]] == [
        ("HEAD~1:prog.py", "HEAD:prog.py", False),
        (None, "HEAD:packer/packer.py", True),
    ]
    # Gone with its line in the settings.
    Path("packer/packer.py").unlink()
    write("clickgen.toml", 'programs = ["prog.py"]\n')
    commit()
    said = repository("HEAD~1", "HEAD")
    assert said.code == 1
    assert "HEAD~1:packer/packer.py was removed: there is no packer/packer.py in HEAD\n" in said.out
    # In neither revision, and without settings: the only program is new.
    write("late.py", program(*RUNGS))
    write("clickgen.toml", 'programs = ["prog.py", "late.py"]\n')
    assert repository("HEAD", "HEAD").code == 0


def test_the_only_program_may_be_new(repository: Run) -> None:
    git("mv", "prog.py", "plant.py")
    commit()
    repository("plant.py", "plant.py")
    said = repository("HEAD~1", "HEAD")
    assert (said.code, "HEAD:plant.py is new" in said.out) == (1, True)


def test_a_program_with_errors_among_several(repository: Run) -> None:
    write("bad.py", program("if c.A AND:\n        out(y[1])"))
    write("clickgen.toml", 'programs = ["prog.py", "bad.py"]\n')
    commit()
    write("prog.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")
    said = repository("HEAD~1", "HEAD", "--output-format", "json")
    assert said.code == 2
    assert [each["differs"] for each in json.loads(said.out)["programs"]] == [True, None]


@pytest.mark.parametrize(
    "sides", [("HEDA", "HEAD"), ("HEAD", "HEDA"), ("HEDA", "HEDB"), ("HEDA", "prog.py"), ("prog.py", "HEDA")]
)
def test_an_unknown_revision_is_named(repository: Run, sides: tuple[str, str]) -> None:
    repository("prog.py", "prog.py")
    for several in (False, True):
        if several:
            write("other.py", program(*RUNGS))
            write("clickgen.toml", 'programs = ["prog.py", "other.py"]\n')
        said = repository(*sides)
        assert (said.code, said.out) == (2, "")
        assert "there is no file, folder or revision 'HEDA'" in said.err


def test_a_revision_that_could_be_any_of_several_programs_names_them(repository: Run) -> None:
    write("other.py", program(*RUNGS))
    commit()
    said = repository("HEAD~1", "HEAD")
    assert said.code == 2
    assert "HEAD~1 does not say which program: write one of HEAD~1:other.py, HEAD~1:prog.py" in said.err
    assert repository("HEAD", "other.py").code == 0


def test_a_folder_of_programs_is_its_program(repository: Run) -> None:
    write("plant/prog.py", program(*RUNGS))
    commit()
    write("plant/prog.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")
    named = repository("HEAD~1:plant/prog.py", "HEAD:plant/prog.py")
    assert named.code == 1
    for sides in (("HEAD~1:plant/", "HEAD:plant/"), ("HEAD~1:plant", "HEAD:plant"), ("HEAD~1:./plant/", "HEAD:plant")):
        assert repository(*sides) == named
    assert repository("HEAD~1:plant/", "plant").code == repository("HEAD~1:plant", "plant/").code == 1
    assert repository("HEAD:plant/", "plant").code == 0
    write("plant/other.py", program(*RUNGS))
    commit()
    said = repository("HEAD:plant/", "plant")
    assert said.code == 2
    assert "has several programs: name one of HEAD:plant/other.py, HEAD:plant/prog.py" in said.err
    # A folder of ladder is one of ladder.
    assert main(["build", "plant/prog.py", "-o", "out"]) == 0
    commit()
    assert repository("HEAD:out/", "plant/prog.py").code == 0
