"""``clickgen diff``: nicknames that changed, moved, or have no address."""

from __future__ import annotations

import os
import shutil
from collections.abc import Sequence
from pathlib import Path

import pytest
from diffing import RUNGS, SUB, TABLE, Run, bundle, program, run, write

__all__ = ["bundle", "run"]


# -- nicknames and addresses -------------------------------------------------------------------------------------------


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


# -- names without an address ------------------------------------------------------------------------------------------


def swapped(text: str) -> str:
    return text.replace("Foo", "@").replace("Bar", "Foo").replace("@", "Bar")


FOO_AND_BAR = ("    if c.Foo:\n        out(y[1])\n", "    if c.Bar:\n        out(y[2])\n")


@pytest.mark.parametrize(
    ("new", "code"),
    [
        (FOO_AND_BAR, 0),
        (tuple(map(swapped, FOO_AND_BAR)), 1),
        ((FOO_AND_BAR[0], FOO_AND_BAR[1].replace("Bar", "Baz")), 1),
        # The address that the older side chose is something else here.
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
