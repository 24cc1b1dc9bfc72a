"""Builds that choose addresses, for the tests of the resolver."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

import pytest

import clickgen
from clickgen.problems.diagnostics import Diagnostic
from clickgen.results import BuildResult

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment"


class Desk:
    """A folder with a program and perhaps an address table."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.program = folder / "prog.py"
        self.table = folder / "nicknames.csv"

    def rows(self, *rows: str, end: str = "\n") -> None:
        """Lay an address table beside the program."""
        self.table.write_bytes("".join(row + end for row in (HEADER, *rows)).encode())

    def build(self, rungs: str, top: str = "", *, frozen: bool = False) -> BuildResult:
        """Build these rungs of main, with these lines in front of it."""
        body = indent(dedent(rungs), "    ")
        self.program.write_text(f"{dedent(top)}\n\ndef main():\n{body}\n    if True:\n        end()\n")
        return clickgen.build(self.program, frozen=frozen)

    def good(self, rungs: str, top: str = "", *, frozen: bool = False) -> BuildResult:
        result = self.build(rungs, top, frozen=frozen)
        assert result.ok, [(problem.code, problem.message) for problem in result.diagnostics]
        return result

    def bad(self, code: str, rungs: str, top: str = "", *, frozen: bool = False) -> Diagnostic:
        """The one error of these rungs."""
        result = self.build(rungs, top, frozen=frozen)
        errors = [problem for problem in result.diagnostics if problem.is_error]
        assert [problem.code for problem in errors] == [code], [problem.message for problem in errors]
        assert not result.files
        return errors[0]

    def text_at(self, problem: Diagnostic) -> str:
        """The source text that a problem marks."""
        span = problem.span
        assert span is not None
        assert span.line == span.end_line
        return Path(span.path).read_text().split("\n")[span.line - 1][span.col - 1 : span.end_col - 1]


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return Desk(tmp_path)


def new(result: BuildResult) -> dict[str, str]:
    """The addresses that clickgen chose, by name."""
    return {row.nickname: str(row.address) for row in result.new_rows}


def rung(result: BuildResult, number: int = 1) -> str:
    """The first row of a rung of main: its contacts and its output, without wires."""
    lines = [line for line in result.files["main.csv"].split("\n") if line.startswith("R,")]
    cells = lines[number - 1].split(",", 32)
    return " ".join(cell for cell in cells[1:] if cell.strip("-")).replace("T:", "").replace(" T ", " ")
