"""Every problem code has a program that provokes it: that code at that place, with a way out, nothing written."""

from __future__ import annotations

import csv
import re
import shutil
from pathlib import Path
from typing import NamedTuple

import openpyxl
import pytest

import clickgen
from clickgen.cli import main
from clickgen.problems.codes import CODES, Severity
from clickgen.problems.diagnostics import Diagnostic
from clickgen.rules.registry import Folder, rules
from clickgen.text.source import Span

REJECT = Path(__file__).parents[2] / "fixtures" / "reject"
PROGRAM, TABLE = "prog.py", "nicknames.csv"
LIST, WORKBOOK = "io.csv", "io.xlsx"
"""A fixture holds a workbook as the rows of its one sheet."""

_EXPECT = re.compile(r"# expect: ((?:CG\d{3} (?:\w+\.\w+:)?\d+:\d+(?:, )?)+)\n")
_FLAGS = re.compile(r"^# flags: (\w+)$", re.MULTILINE)


class Place(NamedTuple):
    code: str
    file: str
    line: int
    col: int


# -- the fixtures -----------------------------------------------------------------------------------------------------


def _names() -> list[str]:
    return sorted(path.stem for path in REJECT.iterdir())


def _code(name: str) -> str:
    """``CG209_scratch`` is a second fixture of CG209."""
    return name.partition("_")[0]


def _lay_out(name: str, folder: Path) -> Path:
    """The fixture in a folder of its own; returns its program."""
    program = folder / PROGRAM
    if (REJECT / name).is_dir():
        for path in (REJECT / name).iterdir():
            shutil.copyfile(path, folder / path.name)
        if (folder / LIST).is_file():
            _make_workbook(folder / LIST)
    else:
        shutil.copyfile(REJECT / f"{name}.py", program)
    return program


def _make_workbook(rows: Path) -> None:
    """The workbook with one sheet of these rows."""
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    sheet.title = "IO"
    for row in csv.reader(rows.read_text("utf-8").splitlines()):
        sheet.append([field or None for field in row])
    book.save(rows.with_name(WORKBOOK))


def _table_of(program: Path) -> Path | None:
    """The workbook that the fixture is built with, if it has one."""
    workbook = program.with_name(WORKBOOK)
    return workbook if workbook.is_file() else None


def _expected(text: str) -> list[Place]:
    match = _EXPECT.match(text)
    assert match, "the first line reads # expect: CG101 3:12, CG102 5:1, CG103 sibling.py:3:5"
    return sorted(_place(*entry.split()) for entry in match[1].split(", "))


def _place(code: str, at: str) -> Place:
    *file, line, col = at.split(":")
    usual = TABLE if code.startswith("CG6") else PROGRAM
    return Place(code, file[0] if file else usual, int(line), int(col))


def _is_frozen(text: str) -> bool:
    flags = _FLAGS.findall(text)
    assert flags in ([], ["frozen"])
    return bool(flags)


each_fixture = pytest.mark.parametrize("name", _names())


def test_every_code_has_a_fixture_and_every_fixture_a_code() -> None:
    # The rules about logic have their examples in their own files; import, comments that silence, programs that cannot
    # be judged and names that left a program are tested with these.
    elsewhere = {code.name for rule in rules(Folder.ADVICE) for code in rule.codes} | {"CG140", "CG525", "CG541"}
    wanted = {code for code in CODES if code not in elsewhere and not code.startswith("CG7")}
    assert {_code(name) for name in _names()} == wanted


@each_fixture
def test_exactly_the_expected_problems_come_out(name: str, tmp_path: Path) -> None:
    program = _lay_out(name, tmp_path)
    text = program.read_text("utf-8")
    expected = _expected(text)
    result = clickgen.build(program, nicknames=_table_of(program), frozen=_is_frozen(text))
    assert sorted(map(_found, result.diagnostics)) == expected
    assert _code(name) in {place.code for place in expected}
    for problem in result.diagnostics:
        _check(problem)
    has_errors = any(CODES[place.code].severity is Severity.ERROR for place in expected)
    assert result.ok is not has_errors
    assert bool(result.files) is not has_errors


def _found(problem: Diagnostic) -> Place:
    assert problem.span is not None
    return Place(problem.code, Path(problem.span.path).name, problem.span.line, problem.span.col)


def _check(problem: Diagnostic) -> None:
    """It offers a way out, and points at something that is there."""
    assert problem.message
    assert problem.help, f"{problem.code} has no way out: {problem.message}"
    spans = [problem.span, *(label.span for label in problem.labels)]
    for span in spans:
        assert span is not None
        if span.sheet:
            assert openpyxl.load_workbook(span.path)[span.sheet].cell(span.line, span.col)
            continue
        lines = Path(span.path).read_text("utf-8").split("\n")
        assert 1 <= span.line <= span.end_line <= len(lines)
        assert 1 <= span.col <= len(lines[span.line - 1]) + 1
        assert 1 <= span.end_col <= len(lines[span.end_line - 1]) + 2
        assert (span.line, span.col) < (span.end_line, span.end_col)


@each_fixture
def test_the_command_writes_nothing_where_there_are_errors(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    program = _lay_out(name, tmp_path)
    text = program.read_text("utf-8")
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    out = tmp_path / "out"
    flags = ["--frozen"] if _is_frozen(text) else []
    workbook = _table_of(program)
    flags += ["--nicknames", str(workbook)] if workbook else []
    code = main(["build", str(program), "-o", str(out), *flags])
    said = capsys.readouterr().err
    expected = _expected(text)
    for place in expected:
        at = (place.line, place.col)
        where = Span.of_cell("", "IO", *at) if place.file == WORKBOOK else f":{at[0]}:{at[1]}"
        assert f"{where}: {CODES[place.code].severity.value}[{place.code}]" in said
    if any(CODES[place.code].severity is Severity.ERROR for place in expected):
        assert code == 1
        assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before
    else:
        assert code == 0
        assert (out / "main.csv").is_file()


@pytest.mark.parametrize("frozen", [False, True])
def test_a_chosen_point_in_a_word_is_told_until_it_is_pinned(tmp_path: Path, frozen: bool) -> None:
    text = "def main():\n    if x[101]:\n        copy(dh[1], yd[0])\n        out(y.Lamp)\n    if True:\n        end()\n"
    program = tmp_path / PROGRAM
    program.write_text(text, "utf-8")
    clickgen.build(program).write(tmp_path / "out")
    assert [problem.code for problem in clickgen.build(program, frozen=frozen).diagnostics] == ["CG432"]
    program.write_text(f"nickname(y.Lamp, y[1])\n{text}", "utf-8")
    assert not clickgen.build(program, frozen=frozen).diagnostics
