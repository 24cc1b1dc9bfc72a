"""Rules about logic, where the address table or the size of a program decides."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest
from test_examples import program_of

from clickgen.api import check


def _with_table(folder: Path, rungs: str, *rows: str) -> list[str]:
    """The codes found in some rungs beside an address table with these rows."""
    table = "\n".join(("Address,Data Type,Nickname,Initial Value,Retentive,Address Comment", *rows, ""))
    (folder / "nicknames.csv").write_text(table, "utf-8")
    program = folder / "prog.py"
    program.write_text(program_of(textwrap.dedent(rungs)), "utf-8")
    return [problem.code for problem in check(program).diagnostics]


RESET = """
    if x.Stop:
        reset(c.Ready)

    if c.Ready:
        out(y.Lamp)
"""


@pytest.mark.parametrize(("initial", "found"), [("0", 1), ("1", 0)])
def test_a_bit_that_begins_on_in_the_table_may_be_reset_alone(initial: str, found: int, tmp_path: Path) -> None:
    codes = _with_table(tmp_path, RESET, f'C1,BIT,"Ready",{initial},No,""')
    assert codes.count("CG503") == found


@pytest.mark.parametrize(
    ("row", "found"),
    [
        ('DF1,FLOAT,"Limit",0,Yes,""', 1),
        ('DF1,FLOAT,"Limit",2.5,Yes,""', 0),
        ('DF1,FLOAT,"Limit",0,No,""', 0),
    ],
)
def test_a_value_that_the_table_gives_is_not_missing(row: str, found: int, tmp_path: Path) -> None:
    codes = _with_table(tmp_path, "if df.Limit > 1.5:\n    out(y.Lamp)\n", row)
    assert codes.count("CG504") == found


@pytest.mark.parametrize(("initial", "found"), [("2.0", 1), ("2.5", 0)])
def test_a_float_may_be_compared_with_what_the_table_lets_it_begin_with(
    initial: str, found: int, tmp_path: Path
) -> None:
    rungs = "if x.Set:\n    calc('df.New * 2', df.Limit)\nif df.Limit == 2.5:\n    out(y.Lamp)\n"
    codes = _with_table(tmp_path, rungs, f'DF1,FLOAT,"Limit",{initial},Yes,""')
    assert codes.count("CG520") == found


@pytest.mark.parametrize(("retentive", "until"), [("No", "until the PLC restarts"), ("Yes", "for good")])
def test_a_latch_stays_on_for_as_long_as_the_table_says(retentive: str, until: str, tmp_path: Path) -> None:
    rungs = "if x.Set:\n    set(c.Held)\nif c.Held:\n    out(y.Lamp)\n"
    assert "CG502" in _with_table(tmp_path, rungs, f'C1,BIT,"Held",0,{retentive},""')
    assert until in " ".join(problem.message for problem in check(tmp_path / "prog.py").diagnostics)


def test_a_coil_is_compared_with_every_earlier_one(tmp_path: Path) -> None:
    """The second coil excludes the first; the third only the first."""
    subs = ["auto", "manual", "jog"]
    calls = ["ds.Mode == 1", "ds.Mode == 2", "ds.Mode > 1"]
    text = "def main():\n"
    text += "".join(f"    if {when}:\n        call({name})\n" for when, name in zip(calls, subs, strict=True))
    text += "    if True:\n        end()\n"
    for name in subs:
        text += f"\n\n@sub\ndef {name}():\n    if x.Run:\n        out(y.Motor)\n    if True:\n        return\n"
    program = tmp_path / "prog.py"
    program.write_text(text, "utf-8")
    found = [problem for problem in check(program).diagnostics if problem.code == "CG501"]
    assert [problem.labels[0].span.line for problem in found] == [23]
