"""A check of one file takes the programs around it into account."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest

from clickgen.cli import main

MAIN = "from lib import lamp\n\n\ndef main():\n    if True:\n        call(lamp)\n{more}    if True:\n        end()\n"
LIB = "@sub\ndef lamp():\n    if c.A:\n        out(y[1]){comment}\n{more}    if True:\n        return\n"
AGAIN = "    if c.B:\n        out(y[1])\n"
IGNORE = "  # clickgen: ignore[CG501]"


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def write(**files: str) -> None:
    for name, text in files.items():
        Path(f"{name}.py").write_text(text, "utf-8")


def give(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))


def test_a_comment_that_another_program_needs_is_not_unused(capsys: pytest.CaptureFixture[str]) -> None:
    write(a=MAIN.format(more=""), b=MAIN.format(more=AGAIN), lib=LIB.format(comment=IGNORE, more=""))
    assert main(["check"]) == 0, capsys.readouterr().out
    assert main(["check", "a.py", "--fix"]) == 0, capsys.readouterr().out
    assert IGNORE in Path("lib.py").read_text("utf-8")


def test_a_comment_in_a_part_without_a_program_is_not_unused(capsys: pytest.CaptureFixture[str]) -> None:
    write(lib=LIB.format(comment=IGNORE, more=""))
    assert main(["check"]) == 0, capsys.readouterr().out


def test_a_part_on_the_standard_input_is_judged_with_its_program(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lib = LIB.format(comment="", more="")
    write(p=MAIN.format(more=""), lib=lib)
    give(monkeypatch, lib)
    assert main(["check", "-", "--stdin-filename", "lib.py"]) == 0, capsys.readouterr().out
    give(monkeypatch, lib.replace("c.A", "c.A and c.B"))
    capsys.readouterr()
    assert main(["check", "-", "--stdin-filename", "./lib.py", "--fix"]) == 0
    assert capsys.readouterr().out == lib.replace("c.A", "all(c.A, c.B)")


def test_a_part_that_nobody_imports_has_the_rules_that_hold_in_parts(capsys: pytest.CaptureFixture[str]) -> None:
    write(lib=LIB.format(comment="", more=AGAIN))
    assert main(["check", "--output-format", "concise"]) == 1
    said = capsys.readouterr().out
    assert "CG501" in said
    assert "CG401" not in said


@pytest.mark.parametrize("pattern", ["legacy", "/legacy", "legacy/**/*.py"])
def test_the_patterns_of_one_file_are_those_of_exclude(pattern: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("legacy").mkdir()
    Path("legacy/q.py").write_text(MAIN.format(more=AGAIN + AGAIN).partition("\n\n\n")[2], "utf-8")
    Path("clickgen.toml").write_text(f'[check]\nper-file-ignores = {{ "{pattern}" = ["CG501"] }}\n', "utf-8")
    main(["check"])
    assert "CG501" not in capsys.readouterr().out


def test_a_folder_without_a_program_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    Path("empty").mkdir()
    assert main(["check", "empty"]) == 0
    assert "no program in empty" in capsys.readouterr().err
