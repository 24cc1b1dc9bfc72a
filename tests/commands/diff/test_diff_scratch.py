"""``clickgen diff``: scratch cells with other numbers are not a difference."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import budget
import pytest
from diffing import (
    RUNGS,
    TABLE,
    Run,
    build,
    happened,
    negated,
    plant,
    program,
    run,
    side,
    with_scratch,
    write,
    write_plant,
)
from strategies.edits import random_draft

import clickgen
from clickgen.cli import main
from clickgen.click.compare.same import compare
from clickgen.click.ladder_csv import HEADER
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.commands.diff.changes import COMMENTED
from clickgen.commands.diff.programs import diff
from clickgen.commands.diff.sides import program_side
from clickgen.config import Settings
from clickgen.device.banks import Address
from clickgen.lower.scratch import purpose_of, rung_of
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import default_row
from clickgen.workspace import Workspace

__all__ = ["run"]


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
    # If something else uses it, it is.
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
    one, other = (program_side(tmp_path / "prog.py", "prog.py", each, Workspace()) for each in (Settings(), taken))
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
    """Whatever the rows give as the purpose of their cells."""
    chance = random.Random(seed)
    for name, text in random_draft(seed).items():
        (tmp_path / name).write_text(text, "utf-8")
    taken = Settings(reserved=tuple(Address("C", number) for number in range(1996, 2001)))
    one, other = (program_side(tmp_path / "prog.py", "prog.py", each, Workspace()) for each in (Settings(), taken))
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


def test_nothing_is_paired_across_what_stays(run: Run) -> None:
    counter = [("X003 ~C5 T", "latch(C5)"), (". . -", "count_up(CT1,CTD1,preset=10)"), (".", ""), ("X004", ".reset()")]
    write_plant("plant", [("X001 X002", "out(C5)")], counter)
    box = "    if all(x[3], nc(c[5])):\n        set(c[5])\n        ctu(ct[1], 10, reset=lambda: x[4])\n"
    coil = "    if all(x[2], x[1]):\n        out(c[5])\n"
    write("prog.py", program(box, coil))
    assert (run("plant", "prog.py").code, run("prog.py", "plant").code) == (1, 1)
    write("prog.py", program(coil, box))
    assert (run("plant", "prog.py").code, run("prog.py", "plant").code) == (0, 0)


def test_each_side_has_its_own_scratch_cells() -> None:
    one, other = ladder(("X001", "out(C2000)")), ladder(("X001", "out(C1999)"))
    assert diff(with_scratch(one, "C1999"), with_scratch(other, "C2000")).differs
    kept = plant([("X001 X002", "out(C2000)")], [("C2000", "out(Y001)")])
    plain = plant([("X001 X002", "out(Y001)")])
    assert diff(side(kept), with_scratch(plain, "C2000")).differs
    assert not diff(with_scratch(kept, "C2000"), side(plain)).differs
