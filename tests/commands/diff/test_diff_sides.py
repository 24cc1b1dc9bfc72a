"""``clickgen diff``: the possible sides, and what stops it."""

from __future__ import annotations

import csv
import json
import os
import re
from pathlib import Path

import pytest
from diffing import RUNGS, SUB, Run, build, bundle, program, run, write
from judges.program_files import program_file

from clickgen.commands.diff.changes import KINDS

__all__ = ["bundle", "run"]


# -- one file alone ----------------------------------------------------------------------------------------------------


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


# -- what stops it -----------------------------------------------------------------------------------------------------


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
