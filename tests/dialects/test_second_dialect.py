"""A second dialect goes through every stage, and no message shows it the text of the first one."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import toy
from test_examples import TOO_LONG, WRONG, Example, program_of

import clickgen
from clickgen.api import check
from clickgen.commands.nicknames.uses import read_names
from clickgen.config import Config
from clickgen.dialects import registry
from clickgen.dialects.discover import targets
from clickgen.dialects.if_rungs.read.imports import read_program
from clickgen.ir.program import Program
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.source import SourceFile

TELL_TALE = re.compile(
    r"\b[a-z_]+\(|\b(?:x|y|c|t|ct|sc|ds|dd|dh|df|xd|yd|td|ctd|sd|txt)(?:\[|\.[A-Za-z_])|\bif [A-Z<].*:|\belif\b"
    r"|\bdef \w|@sub|lambda|# ?clickgen|\bslice|\w=(?!=)|\.immediate|nickname\(|\bfor _ in\b|\bfrom \w+ import\b|Python"
)
"""Text of the ``if`` dialect: calls, addresses, rungs, comments for clickgen."""
TOKEN = re.compile(r"\b(?:raw|math)\([^ ]*(?: [^ ]*\))?")
"""CLICK's own tokens in ladder files, which every dialect shows."""
BY_TEXT = {
    "CG524": "a word in place of a sign is seen in the text of if_rungs alone",
    "CG551": "whether a number has all its digits, the text says",
}
"""Codes of rules that ask how something is written, each with the reason."""


@pytest.fixture(autouse=True)
def registered(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The toy is a dialect for the time of a test: a folder and one registration."""
    monkeypatch.setitem(sys.modules, "clickgen.dialects.toy", toy)
    monkeypatch.setattr(registry, "NAMES", ["if_rungs", "toy"])
    yield
    registry.named.cache_clear()


def _no_file(path: str) -> bytes:
    raise FileNotFoundError(path)


def read(text: str) -> Program | None:
    """A program of the ``if`` dialect; None for one that its reader refuses."""
    problems = Diagnostics()
    program, _ = read_program(SourceFile("prog.py", text), _no_file, problems)
    return None if problems.has_errors else program


READ = [one for one in WRONG if one.code.name not in TOO_LONG and read(program_of(one.wrong.text))]
"""Examples of rules: what the reader refuses, each dialect refuses in its own words."""


def in_toy(text: str, folder: Path) -> Path:
    """A program of the ``if`` dialect, written in the toy."""
    program = read(text)
    assert program is not None
    path = folder / "prog.toy"
    path.write_text(toy.DIALECT.written(program, str(path)), "utf-8")
    return path


def texts(problem: Diagnostic) -> list[str]:
    """All that a problem shows."""
    edits = problem.fix.edits if problem.fix else ()
    return [
        problem.message,
        problem.help,
        *(label.text for label in problem.labels),
        *(edit.text for edit in edits),
    ]


def test_most_examples_can_be_written_in_any_dialect() -> None:
    assert len(READ) > 0.9 * len(WRONG)


@pytest.mark.parametrize("example", READ, ids=lambda one: one.code.name)
def test_a_rule_speaks_the_dialect_of_the_program(example: Example, tmp_path: Path) -> None:
    text = program_of(example.wrong.text)
    (tmp_path / "prog.py").write_text(text, "utf-8")
    first = check(tmp_path / "prog.py").diagnostics
    second = check(in_toy(text, tmp_path)).diagnostics
    assert sorted(one.code for one in second if one.code not in BY_TEXT) == sorted(
        one.code for one in first if one.code not in BY_TEXT
    )
    for problem in second:
        for shown in texts(problem):
            found = TELL_TALE.search(TOKEN.sub("", shown))
            assert not found, f"{problem.code}: {shown!r}"


@pytest.mark.parametrize(
    ("text", "code", "help"),
    [
        ("def main():\n    if c.A:\n        out(c.B)\n", "CG403", "WHEN EVER THEN DO end"),
        ("def main():\n    if c.A:\n        copy(ds.A, t.B)\n    if True:\n        end()\n", "CG304", "DO rton"),
        ("def main():\n    if td.A > 3:\n        out(c.B)\n    if True:\n        end()\n", "CG207", "<T A>"),
        ("def main():\n    if sc.Fisrt_Scn:\n        out(c.B)\n    if True:\n        end()\n", "CG206", "<SC"),
        (
            "nickname(ds.A, dd[5])\n\n\ndef main():\n    if ds.A:\n        out(c.B)\n    if True:\n        end()\n",
            "CG205",
            "<DD A>",
        ),
        ("def main():\n    if ds.Block[3] > 1:\n        out(c.B)\n    if True:\n        end()\n", "CG214", "NAME <DS"),
    ],
)
def test_names_are_spelled_by_the_dialect(text: str, code: str, help: str, tmp_path: Path) -> None:
    problems = check(in_toy(text, tmp_path)).diagnostics
    (found,) = [one for one in problems if one.code == code]
    assert help in found.help
    assert not [shown for problem in problems for shown in texts(problem) if TELL_TALE.search(shown)]


def test_a_program_of_a_second_dialect_builds_the_same_ladder(tmp_path: Path) -> None:
    rung = "    if any(c.A, nc(x[1])):\n        out(c.B)\n        copy(ds.D, ds.E)\n"
    text = f"def main():\n{rung}    if True:\n        end()\n"
    (tmp_path / "prog.py").write_text(text)
    first = clickgen.build(tmp_path / "prog.py")
    second = clickgen.build(in_toy(text, tmp_path))
    assert first.ok
    assert second.ok
    assert second.files["main.csv"] == first.files["main.csv"]


def test_it_is_found_in_a_folder_and_its_names_are_read(tmp_path: Path) -> None:
    text = "def main():\n    if c.A:\n        out(c.B)\n    if True:\n        end()\n"
    path = in_toy(text, tmp_path)
    assert [target.path for target in targets([str(tmp_path)], Config(tmp_path))] == [str(path)]
    names = read_names(SourceFile(str(path), path.read_text()), Diagnostics())
    assert names is not None
    assert [named.name for named in names.named] == ["A", "B"]
