"""Whatever is in the files, a build reports what is wrong or builds something that outside readers take."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given, note
from judges.builds import check_build
from judges.smallest import Smallest
from strategies.broken import broken_programs, mutants, random_programs
from strategies.given import CASES, Given, case_texts, given_files, given_program, valid
from strategies.tables import table_builds

import clickgen


def check_whole(files: Given) -> None:
    """A valid program builds."""
    check_build(files, is_valid=True)


def check_table(files: Given) -> None:
    """A table is refused or read, whatever it holds."""
    check_build(files, codec=False)


@given(valid.map(given_files))
@examples(5)
def test_a_valid_program_builds(files: Given) -> None:
    note(Smallest(files, check_whole))
    check_whole(files)


@given(mutants)
@examples(40)
def test_a_program_with_one_fault_is_told_or_builds(files: Given) -> None:
    note(Smallest(files, check_build))
    check_build(files)


@given(broken_programs)
@examples(30)
def test_a_broken_program_is_told_or_builds(files: Given) -> None:
    note(Smallest(files, check_build))
    check_build(files)


@given(random_programs)
@examples(40)
def test_anything_can_stand_in_a_program(files: Given) -> None:
    note(Smallest(files, check_build))
    check_build(files)


@given(table_builds)
@examples(30)
def test_anything_can_stand_in_the_address_table(files: Given) -> None:
    note(Smallest(files, check_table))
    check_table(files)


@pytest.mark.parametrize("start", [b"", b"\xef\xbb\xbf", b"a\n", b"\xef\xbb\xbfa\n\n", b"a\r", b"a\r\n", b"\xc3\xa9"])
@pytest.mark.parametrize("byte", [b"\x80", b"\xff"])
def test_the_byte_that_is_no_text_is_named_in_its_place(start: bytes, byte: bytes, tmp_path: Path) -> None:
    """Line and column count from the first character: after a byte order mark, and with any line ends."""
    path = tmp_path / "prog.py"
    path.write_bytes(start + byte + b"\n")
    [problem] = clickgen.build(path).diagnostics
    before = start.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n").split("\n")
    assert problem.span is not None
    assert (problem.code, problem.span.line, problem.span.col) == ("CG101", len(before), len(before[-1]) + 1)
    assert f"0x{byte[0]:02X}" in problem.message


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.parent.name)
def test_the_programs_to_break_are_whole(path: Path) -> None:
    check_build(given_files(case_texts(path)))


FOUND = {
    "a range of one address is sent": """
def main():
    if x[1]:
        send(ModbusRtuTarget(com_port="cpu2", device_id=5), ModbusAddress(address=400001), dh[1:2])
    if True:
        end()
""",
}
"""Valid programs that did not build, or built something that no reader takes."""


@pytest.mark.parametrize("name", FOUND)
def test_what_was_found(name: str) -> None:
    check_whole(given_program(FOUND[name]))


FAULTS = {
    "a sign that no formula has": """
def main():
    if x[1]:
        calc("ds[1] @ 1", ds[2])
    if True:
        end()
""",
}
"""Programs with a fault that was reported badly."""


@pytest.mark.parametrize("name", FAULTS)
def test_what_was_not_told_well(name: str) -> None:
    check_build(given_program(FAULTS[name]))


def test_a_condition_without_end_is_told(tmp_path: Path) -> None:
    """A condition that Python reads and nobody else can ends in a problem, not in a crash."""
    program = tmp_path / "prog.py"
    program.write_text(f"def main():\n    if {' and '.join(['c[1]'] * 20_000)}:\n        out(c[1])\n")
    command = [sys.executable, "-m", "clickgen", "build", str(program), "-o", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 1, done.stderr[-200:]
    assert "CG118" in done.stderr


@pytest.mark.parametrize("condition", ["()", "(x for x in y)", "(c.A, c.B)"])
def test_parentheses_that_belong_to_their_expression_are_told(condition: str, tmp_path: Path) -> None:
    """A line without its colon is read for the condition that it may have had."""
    program = tmp_path / "prog.py"
    program.write_text(f"def main():\n    if {condition}\n        out(y[1])\n    if True:\n        end()\n", "utf-8")
    assert {problem.code for problem in clickgen.check(program).diagnostics} == {"CG101"}
