"""Judge a program by rules."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from clickgen.facts.facts import Facts
from clickgen.rules.rule import Findings, Rule


def judge(facts: Facts, rules: Sequence[Rule], wants: Callable[[str], bool], is_part: bool) -> Findings:
    """What rules find: those that are wanted and, in a file that is only part of a program, those that hold there."""
    for rule in rules:
        if rule.is_wanted(wants) and (rule.holds_in_parts or not is_part):
            yield from rule.find(facts)
