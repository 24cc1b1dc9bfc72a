"""Every rule finds what its wrong examples mark, nothing in its right ones, and fixes what it says it fixes."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest

from clickgen.check.lint import RULES
from clickgen.check.rule import Rule, Wrong
from clickgen.codes import CODES
from clickgen.diagnostics import Diagnostic
from clickgen.fixing import apply_fixes
from clickgen.pipeline import check

MARK = "# <-"
WRONG = [(rule, example) for rule in RULES for example in rule.wrong]
RIGHT = [(rule, example) for rule in RULES for example in rule.right]


def program_of(text: str) -> str:
    """An example as a whole program: rungs stand in a main."""
    text = text.strip("\n")
    if "def main" in text:
        return text + "\n"
    return f"def main():\n{textwrap.indent(text, '    ')}\n    if True:\n        end()\n"


def findings(rule: Rule, text: str, folder: Path) -> list[Diagnostic]:
    """What the rule finds; an error of any other kind fails."""
    program = folder / "prog.py"
    program.write_text(text, "utf-8")
    result = check(program)
    errors = [problem for problem in result.diagnostics if problem.is_error]
    assert not errors, errors
    return [problem for problem in result.diagnostics if problem.code == rule.code]


def lines(problems: list[Diagnostic]) -> list[int]:
    return sorted(problem.span.line for problem in problems if problem.span)


def marked(text: str) -> list[int]:
    """The lines that a mark ends, one entry for each mark."""
    return [n for n, line in enumerate(program_of(text).split("\n"), 1) for _ in range(line.count(MARK))]


def _ids(pair: tuple[Rule, Wrong | str]) -> str:
    return pair[0].code


def test_rules_are_in_the_order_of_their_codes_and_have_an_entry() -> None:
    codes = [rule.code for rule in RULES]
    assert codes == sorted(set(codes))
    assert set(codes) <= CODES.keys()


@pytest.mark.parametrize("pair", WRONG, ids=_ids)
def test_a_wrong_example_is_found_where_it_is_marked(pair: tuple[Rule, Wrong], tmp_path: Path) -> None:
    rule, example = pair
    assert marked(example.text), "an example marks its findings"
    assert lines(findings(rule, program_of(example.text), tmp_path)) == marked(example.text)


@pytest.mark.parametrize("pair", RIGHT, ids=_ids)
def test_a_right_example_is_quiet(pair: tuple[Rule, str], tmp_path: Path) -> None:
    rule, example = pair
    assert findings(rule, program_of(example), tmp_path) == []


@pytest.mark.parametrize("pair", WRONG, ids=_ids)
def test_a_fix_makes_of_a_wrong_example_what_it_says(pair: tuple[Rule, Wrong], tmp_path: Path) -> None:
    rule, example = pair
    text = program_of(example.text)
    found = findings(rule, text, tmp_path)
    fixes = [problem.fix for problem in found if problem.fix]
    assert bool(fixes) is bool(example.fixed)
    if not fixes:
        return
    fixed, count = apply_fixes(text, fixes)
    assert fixed == program_of(example.fixed)
    assert count == len(fixes)
    assert not [problem for problem in findings(rule, fixed, tmp_path) if problem.fix], "a fix leaves nothing to fix"


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_a_rule_says_why_and_shows_both_sides(rule: Rule) -> None:
    assert rule.why.strip()
    assert rule.wrong
    assert rule.right
