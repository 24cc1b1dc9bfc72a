"""A file gives the same read in pieces as read whole."""

from __future__ import annotations

import ast
from pathlib import Path

import libcst
import pytest
from budget import examples
from hypothesis import given, note
from hypothesis import strategies as st
from strategies.broken import broken_programs, mutants
from strategies.given import CASES, Given, case_texts

from clickgen.dialects.if_rungs.read import pieces
from clickgen.dialects.if_rungs.read.content import FileContent
from clickgen.dialects.if_rungs.read.parse import soundness
from clickgen.dialects.if_rungs.read.program import read_file
from clickgen.ir.program import Routine
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.source import SourceFile

TAIL = "    if True:\n        end()\n"
RUNG = "    # One rung.\n    if x[1]:\n        out(y[1])\n"
FOLLOW = {
    "a string that holds rungs": '    if x[1]:\n        copy("""\n    if x[2]:\n""", txt[1])\n' + RUNG,
    "brackets that hold an if": "    if all(x[1],\n    if_,\n    x[2]):\n        out(y[1])\n" + RUNG,
    "a line that goes on": "    if x[1] and \\\n    x[2]:\n        out(y[1])\n" + RUNG,
    "nested rungs": "    if x[1]:\n        if x[2]:\n            out(y[1])\n        if x[3]:\n            out(y[2])\n"
    + RUNG,
    "an else": RUNG + "    else:\n        out(y[2])\n" + RUNG,
    "an elif": RUNG + "    elif x[2]:\n        out(y[2])\n" + RUNG,
    "an else at the top": RUNG + "else:\n    pass\n",
    "a function": RUNG + "\n\n@sub\ndef a():\n" + RUNG + "    if True:\n        return\n",
    "a function of another indentation": RUNG
    + "\n\n@sub\ndef a():\n  if x[1]:\n    out(y[2])\n  if True:\n    return\n",
    "a head over several lines": RUNG + "\n\ndef a(\n    b\n):\n" + RUNG,
    "tabs": RUNG + "\tif x[1]:\n\t\tout(y[1])\n",
    "a rung on one line": RUNG + "    if x[2]: out(y[2])\n" + RUNG,
    "a broken line": RUNG + "    if x[1\n" + RUNG,
    "an indentation that nobody opened": RUNG + "      if x[1]:\n        out(y[1])\n" + RUNG,
    "declarations between": RUNG + "nickname(x.A, x[5])\n\n\n@sub\ndef b():\n" + RUNG,
    "a string that is not closed": RUNG + '    """\n' + RUNG,
    "comments at the margin": RUNG + "# A note\n" + RUNG,
    "a decorator alone": RUNG + "@sub\n" + RUNG,
    "a monster": RUNG + "    if " + "(" * 150 + "x[1]" + ")" * 150 + ":\n        out(y[1])\n" + RUNG,
    "an endless number": RUNG + f"    if ds[1] == 0x{'F' * 5000}:\n        out(y[1])\n" + RUNG,
    "an else after a string": '    if x[1]:\n        copy("""\n""", txt[1])\n    else:\n        pass\n' + RUNG,
}


def read(source: SourceFile, lines: int) -> tuple[FileContent | None, tuple[Diagnostic, ...]]:
    problems = Diagnostics()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(pieces, "LINES", lines)
        content = read_file(source, problems)
    return content, problems.in_order()


def compare(text: str) -> None:
    source = SourceFile("p.py", text)
    whole = read(source, len(text))
    for lines in (0, 1, 2, 5):
        assert read(source, lines) == whole


@pytest.mark.parametrize("name", FOLLOW)
def test_wherever_a_piece_could_end(name: str) -> None:
    for before in (1, 2, 3):
        compare("def main():\n" + RUNG * before + FOLLOW[name] + TAIL)


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.parent.name)
def test_the_cases(path: Path) -> None:
    for text in case_texts(path).values():
        compare(text)


@given(st.one_of(mutants, broken_programs))
@examples(20)
def test_a_broken_program(files: Given) -> None:
    note(files.text)
    compare(files.text)


def long_program() -> str:
    return "def main():\n" + RUNG * 400 + TAIL + "\n\n@sub\ndef a():\n" + RUNG * 400 + "    if True:\n        return\n"


def test_long_programs_are_read_in_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not one tree of all of it, which would take a hundred times the memory of the text."""
    monkeypatch.setattr(pieces, "LINES", 100)
    largest, parse = 0, ast.parse

    def measured(source: str) -> ast.Module:
        nonlocal largest
        tree = parse(source)
        largest = max(largest, sum(isinstance(node, ast.If) for node in ast.walk(tree)))
        return tree

    monkeypatch.setattr(ast, "parse", measured)
    source = SourceFile("p.py", long_program())
    found = [
        (statement.node, list(statement.body)) for statement in pieces.statements_in_pieces(source, soundness(source))
    ]
    assert [len(body) for _, body in found] == [401, 401]
    assert largest <= 100


def test_libcst_reads_one_statement_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not one tree of all of it, which would take a thousand times the memory of the text."""
    longest, parse = 0, libcst.parse_statement

    def measured(text: str) -> libcst.SimpleStatementLine | libcst.BaseCompoundStatement:
        nonlocal longest
        longest = max(longest, len(text))
        return parse(text)

    monkeypatch.setattr(libcst, "parse_statement", measured)
    content = read_file(SourceFile("p.py", long_program()), Diagnostics())
    assert content is not None
    assert [len(item.rungs) for item in content.items if isinstance(item, Routine)] == [401, 401]
    assert 0 < longest < 200
