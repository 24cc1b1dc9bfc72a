"""Every rule finds what its wrong examples mark, nothing in its right ones, and fixes what it says it fixes."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path
from typing import NamedTuple

import pytest

import clickgen
from clickgen.api import check
from clickgen.problems.declared import Code, Wrong
from clickgen.problems.diagnostics import Diagnostic
from clickgen.rules.registry import Folder, rules
from clickgen.text.edits import apply_fixes

MARK = "# <-"
_DEF = re.compile(r"^def ", re.MULTILINE)


class Example(NamedTuple):
    """An example of a code, and whether a rule of every build has the code."""

    code: Code
    wrong: Wrong
    in_builds: bool


CODES = [(code, folder is not Folder.ADVICE) for folder in Folder for rule in rules(folder) for code in rule.codes]
WRONG = [Example(code, wrong, in_builds) for code, in_builds in CODES for wrong in code.wrong]
RIGHT = [Example(code, Wrong(right), in_builds) for code, in_builds in CODES for right in code.right]
BESIDES = {"CG432": {"CG210"}}
"""What an example of a code has as well: CG432 is about an output that clickgen chose."""
TOO_LONG = {"CG413", "CG416"}
"""A comment of 1400 bytes and 987 subroutines: fixtures/reject has these, and no page."""


def program_of(text: str) -> str:
    """An example as a whole program: rungs stand in a main."""
    text = text.strip("\n")
    if _DEF.search(text):
        return text + "\n"
    return f"def main():\n{textwrap.indent(text, '    ')}\n    if True:\n        end()\n"


def findings(example: Example, text: str, folder: Path) -> list[Diagnostic]:
    """What is found of the example's code; an error of another kind fails."""
    program = folder / "prog.py"
    program.write_text(text, "utf-8")
    found = check(program).diagnostics
    errors = [problem for problem in found if problem.is_error and problem.code != example.code.name]
    assert not errors, errors
    return [problem for problem in found if problem.code == example.code.name]


def lines(problems: list[Diagnostic]) -> list[int]:
    return sorted(problem.span.line for problem in problems if problem.span)


def marked(text: str) -> list[int]:
    """The lines that a mark ends, one entry for each mark."""
    return [n for n, line in enumerate(program_of(text).split("\n"), 1) for _ in range(line.count(MARK))]


def _ids(example: Example) -> str:
    return example.code.name


@pytest.mark.parametrize("example", WRONG, ids=_ids)
def test_a_wrong_example_is_found_where_it_is_marked(example: Example, tmp_path: Path) -> None:
    text = example.wrong.text
    assert marked(text), "an example marks its findings"
    assert lines(findings(example, program_of(text), tmp_path)) == marked(text)


@pytest.mark.parametrize("example", RIGHT, ids=_ids)
def test_a_right_example_is_quiet(example: Example, tmp_path: Path) -> None:
    assert findings(example, program_of(example.wrong.text), tmp_path) == []


@pytest.mark.parametrize("example", WRONG, ids=_ids)
def test_a_fix_makes_of_a_wrong_example_what_it_says(example: Example, tmp_path: Path) -> None:
    text = program_of(example.wrong.text)
    found = findings(example, text, tmp_path)
    fixes = [problem.fix for problem in found if problem.fix]
    assert bool(fixes) is bool(example.wrong.fixed)
    if not fixes:
        return
    fixed, count = apply_fixes(text, fixes)
    assert fixed == program_of(example.wrong.fixed)
    assert count == len(fixes)
    assert not [problem for problem in findings(example, fixed, tmp_path) if problem.fix], "a fix leaves nothing to fix"


@pytest.mark.parametrize("example", [one for one in (*WRONG, *RIGHT) if one.in_builds], ids=_ids)
def test_an_example_of_a_rule_of_every_build_has_nothing_else(example: Example, tmp_path: Path) -> None:
    program = tmp_path / "prog.py"
    program.write_text(program_of(example.wrong.text), "utf-8")
    wanted = {example.code.name, *BESIDES.get(example.code.name, ())} if MARK in example.wrong.text else set()
    assert {problem.code for problem in clickgen.build(program).diagnostics} == wanted


@pytest.mark.parametrize("code", [code for code, _ in CODES], ids=lambda code: code.name)
def test_a_rule_says_why_and_shows_both_sides(code: Code) -> None:
    assert code.why.strip()
    assert code.wrong or code.name in TOO_LONG
    assert code.right
