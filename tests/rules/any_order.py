"""Judge a program twice, the second time with the rules in another order. The tests of rules judge all theirs so."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import replace

from clickgen.facts.facts import Facts
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.rules.judge import judge
from clickgen.rules.rule import Rule


def judged_in_any_order(
    facts: Facts, rules: Sequence[Rule], wants: Callable[[str], bool], is_part: bool
) -> list[Diagnostic]:
    """What the rules find; fails where it depends on their order, or where a rule has a code that it does not name."""
    found = list(judge(facts, rules, wants, is_part))
    shuffled = random.Random(len(found)).sample(rules, len(rules))
    # What the rules looked up before is not there for the second time.
    facts = replace(facts)
    again: list[Diagnostic] = []
    for rule in shuffled:
        mine = list(judge(facts, [rule], wants, is_part))
        assert {problem.code for problem in mine} <= {*(code.name for code in rule.codes), *rule.also}
        again += mine
    assert in_order(again) == in_order(found)
    return found


def in_order(found: list[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The findings as a report has them."""
    problems = Diagnostics()
    problems.found = found
    return problems.in_order()
