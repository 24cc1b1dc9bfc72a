"""A workbook as the address table: read only, with ``nicknames.csv`` beside the program for what it lacks."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest

import clickgen
from clickgen.cli import main
from clickgen.results import BuildResult

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
PROGRAM = """\
def main():
    if x.Start:
        out(y.Motor)
        copy(ds.Speed, ds.Shown)
    if any(all(x.Start, c.A), c.B):
        out(c.C)
        if re(c.D):
            set(c.E)
    if True:
        end()
"""
LIST = [("X001", "Start", "start button"), ("Y5", "Motor", ""), ("ds 100", "Speed", "rpm"), ("DS101", "", "spare")]


def lay_out(folder: Path, rows: list[tuple[str, str, str]], table: str = "") -> Path:
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    sheet.title = "IO"
    for row in (("PLC address", "Tag", "Description"), *rows):
        sheet.append(row)
    book.save(folder / "io.xlsx")
    (folder / "prog.py").write_text(PROGRAM)
    if table:
        (folder / "nicknames.csv").write_text(HEADER + table, "utf-8")
    return folder / "io.xlsx"


def build(folder: Path, frozen: bool = False) -> BuildResult:
    return clickgen.build(folder / "prog.py", nicknames=folder / "io.xlsx", frozen=frozen)


def test_the_table_holds_only_what_the_workbook_lacks(tmp_path: Path) -> None:
    book = lay_out(tmp_path, LIST)
    before = book.read_bytes()
    result = build(tmp_path)
    assert result.ok
    result.write(tmp_path / "out")
    assert book.read_bytes() == before
    own = (tmp_path / "nicknames.csv").read_text("utf-8").splitlines()[1:]
    assert [row.split(",")[0] for row in own] == ["C1", "C2", "C3", "C4", "C5", "DS1"]
    # CLICK gets both, in its order.
    given = (tmp_path / "out" / "nicknames.csv").read_text("utf-8").splitlines()[1:]
    assert [row.split(",")[0] for row in given] == [
        "X001", "Y005", "C1", "C2", "C3", "C4", "C5", "DS1", "DS100", "DS101"
    ]  # fmt: skip
    assert 'DS101,INT,"",0,Yes,"spare"' in given
    again = build(tmp_path, frozen=True)
    assert again.ok
    assert (again.table, again.files) == (result.table, result.files)


def test_a_name_that_moves_into_the_workbook_may_stay_in_the_table(tmp_path: Path) -> None:
    lay_out(tmp_path, [*LIST, ("C1", "A", "")], 'C1,BIT,"A",0,No,""\n')
    assert build(tmp_path).ok


@pytest.mark.parametrize(
    ("own", "words"),
    [
        ('DS5,INT,"Speed",0,Yes,""', "Speed is DS5 here and DS100 in IO!A4 of"),
        ('DS100,INT,"Rate",0,Yes,""', "DS100 is Rate here and Speed in IO!A4 of"),
        ('DS101,INT,"Rate",0,Yes,""', "DS101 is Rate here and given no name in IO!A5 of"),
        ('DS100,INT,"",0,Yes,"x"', "DS100 is given no name here and Speed in IO!A4 of"),
        ('DS100,INT,"Speed",7,Yes,""', "the initial value of DS100 is 7 here and 0 in IO!A4 of"),
        ('DS100,INT,"Speed",0,No,""', "the retention of DS100 is No here and Yes in IO!A4 of"),
        ('DS100,INT,"Speed",0,Yes,"m/s"', 'the comment of DS100 is "m/s" here and "rpm" in IO!A4 of'),
        ('DS100,INT,"Scratch_DS100",0,Yes,"split of main rung 2"', "DS100 is Scratch_DS100 here and Speed"),
    ],
)
def test_the_two_must_not_disagree(own: str, words: str, tmp_path: Path) -> None:
    lay_out(tmp_path, LIST, own + "\n")
    (problem,) = build(tmp_path).diagnostics
    assert problem.code == "CG605"
    assert words in problem.message
    assert problem.span is not None
    assert (Path(problem.span.path).name, problem.span.line) == ("nicknames.csv", 2)


def test_a_problem_in_the_workbook_names_its_cell(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lay_out(tmp_path, [*LIST, ("C7", "bad?name", "")])
    assert main(["build", str(tmp_path / "prog.py"), "--nicknames", str(tmp_path / "io.xlsx")]) == 1
    said = capsys.readouterr().err
    assert f"{tmp_path / 'io.xlsx'}:IO!B6: error[CG603]" in said


def test_a_declaration_goes_before_the_workbook_but_not_into_it(tmp_path: Path) -> None:
    lay_out(tmp_path, LIST)
    program = tmp_path / "prog.py"
    program.write_text(f'nickname(ds.Speed, ds[100], initial=7, comment="mine")\n\n{PROGRAM}')
    result = build(tmp_path)
    assert result.ok
    assert 'DS100,INT,"Speed",7,Yes,"mine"' in result.files["nicknames.csv"]
    assert b"DS100" not in result.table
    program.write_text(f"nickname(ds.Speed, ds[5])\n\n{PROGRAM}")
    (problem,) = build(tmp_path).diagnostics
    assert problem.message == f"Speed is DS5 here and DS100 in IO!A4 of {tmp_path / 'io.xlsx'}"


def test_a_check_sees_a_change_of_the_workbook(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lay_out(tmp_path, LIST)
    (tmp_path / "clickgen.toml").write_text('programs = [{ path = "prog.py", nicknames = "io.xlsx" }]\n')
    monkeypatch.chdir(tmp_path)
    assert main(["check", "--ignore", "ALL"]) == 0
    lay_out(tmp_path, [*LIST, ("DS102", "Speed", "")])
    assert main(["check", "--ignore", "ALL"]) == 1
    assert "CG602" in capsys.readouterr().out


@pytest.mark.parametrize("name", ["io.xlsx", "IO.XLSM"])
def test_a_workbook_that_is_not_there_is_told(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "prog.py").write_text(PROGRAM)
    assert main(["build", str(tmp_path / "prog.py"), "--nicknames", str(tmp_path / name)]) == 2
    assert f"there is no workbook at {tmp_path / name}" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["prog.py"]


def test_beside_a_workbook_that_lacks_nothing_there_is_no_table(tmp_path: Path) -> None:
    lay_out(tmp_path, LIST)
    (tmp_path / "prog.py").write_text(
        "def main():\n    if x.Start:\n        out(y.Motor)\n    if True:\n        end()\n"
    )
    build(tmp_path).write(tmp_path / "out")
    assert not (tmp_path / "nicknames.csv").exists()
    assert (tmp_path / "out" / "main.csv").is_file()
