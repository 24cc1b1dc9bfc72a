"""A search goes forward through one bank, and compares like with like (click-facts [search.forms])."""

from __future__ import annotations

from clickgen.device.banks import Kind
from clickgen.dialects.base import Spelling
from clickgen.facts.facts import Facts
from clickgen.facts.refusals import refused
from clickgen.facts.values import range_fault, value_class
from clickgen.instructions.effects import Find
from clickgen.instructions.offered import SEARCH
from clickgen.ir.operands import Cell, Integer, Operand
from clickgen.ir.program import Action
from clickgen.resolve.constants import kind_of
from clickgen.rules.rule import Findings, Rule, finding


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        finds = placed.effects.finds
        if finds is not None:
            places = [placed.action.args[name].span for name in (finds.start, finds.end, finds.value)]
            if refused(placed.action).isdisjoint(places):
                yield from _check(facts.spell, placed.action, finds)


def _check(spell: Spelling, action: Action, finds: Find) -> Findings:
    start, end, value = action.args[finds.start], action.args[finds.end], action.args[finds.value]
    if not (isinstance(start, Cell) and isinstance(end, Cell) and isinstance(value, Operand)):
        return
    for place in (start, end):
        if place.address.upper:
            yield finding("CG301", place.span, f"a search cannot begin or end at {place.address}", "search XD0 to XD8")
            return
    if start.bank != end.bank:
        yield finding("CG306", end.span, f"the search begins in {start.bank} and ends in {end.bank}", "search one bank")
    elif start.address.number > end.address.number:
        yield finding(
            "CG306", end.span, f"the search ends at {end.address}, before it begins at {start.address}", "swap them"
        )
    if isinstance(value, Integer) and kind_of(start) is Kind.HEX:
        # Any other whole number among hexadecimal words is hexadecimal by now.
        words = f"search for {spell.hexadecimal(0)} to {spell.hexadecimal(0xFFFF)}"
        yield finding("CG302", value.span, range_fault(value, Kind.HEX), words)
        return
    searched, sought = value_class(start), value_class(value)
    if searched != sought:
        yield finding(
            "CG303", value.span, f"a {sought} value cannot be found among {searched} values", "search another bank"
        )
    elif searched == "text" and action.word(finds.comparison) not in ("==", "!="):
        way = spell.call(SEARCH, spell.quoted("=="), "...")
        yield finding("CG301", action.args[finds.comparison].span, "texts are searched with == or !=", way)


RULE = Rule(
    find,
    (),
    also=(
        "CG301",
        "CG302",
        "CG303",
        "CG306",
    ),
    holds_in_parts=True,
)
