"""Random programs, built, imported and built again: the same outputs in the same order, with the same power."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given, note
from hypothesis import strategies as st
from judges.builds import ladder_files
from strategies.meaning import meaning_programs
from strategies.one_rung import power_programs
from strategies.programs import Program
from test_importing_cases import round_trip, source_of

from clickgen.click.read.rungs import is_comment_kept
from clickgen.dialects.if_rungs.read.program import read_file
from clickgen.dialects.if_rungs.write.routine import comment_lines
from clickgen.ir.program import Routine
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile


def check_round_trip(program: Program) -> None:
    note(program.text)
    files = ladder_files(program.texts)
    note(source_of(files))
    for pair in round_trip(files):
        assert pair.is_identical, f"rung at line {pair.before.written[0].line} is drawn otherwise"


@given(power_programs())
@examples(10)
def test_rungs_come_back(program: Program) -> None:
    check_round_trip(program)


@given(meaning_programs())
@examples(6)
def test_programs_come_back(program: Program) -> None:
    check_round_trip(program)


def ruff_changes(text: str) -> str:
    """The changes that ``ruff format`` with its own settings would make."""
    command = [
        str(Path(sys.executable).with_name("ruff")),
        "format",
        "--isolated",
        "--diff",
        "--stdin-filename",
        "prog.py",
        "-",
    ]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=False).stdout


@given(st.one_of(power_programs(), meaning_programs()))
@examples(4)
def test_source_is_laid_out_as_ruff_does(program: Program) -> None:
    source = source_of(ladder_files(program.texts))
    assert ruff_changes(source) == ""


lines = st.text(st.characters(exclude_categories=("Cs", "Cc"), include_characters="\t"), max_size=30)


@given(st.lists(lines, min_size=1, max_size=5).map("\n".join).filter(is_comment_kept))
@examples(50)
def test_a_comment_is_read_as_it_was(comment: str) -> None:
    block = "".join(f"{line}\n" for line in comment_lines(comment, 1))
    text = f"def main():\n{block}    if True:\n        end()\n"
    problems = Diagnostics()
    content = read_file(SourceFile("prog.py", text), problems)
    assert content is not None
    assert not problems.found
    [routine] = content.items
    assert isinstance(routine, Routine)
    assert routine.rungs[0].comment == "\n".join(line.rstrip() for line in comment.split("\n"))


@pytest.mark.parametrize("text", ["clickgen: ignore[CG501]", "one\n  clickgen: ignore", "a\0b", "a\ud800b"])
def test_a_comment_that_would_not_come_back_is_known(text: str) -> None:
    assert not is_comment_kept(text)
