"""A search goes forward through one bank, and compares like with like (click-facts [search.forms])."""

from __future__ import annotations

from clickgen.device.banks import Kind
from clickgen.facts.facts import Facts
from clickgen.facts.values import range_fault, refused_operands, value_class
from clickgen.instructions.effects import Find
from clickgen.ir.operands import Cell, Integer, Operand
from clickgen.ir.program import Action
from clickgen.problems.diagnostics import Diagnostics
from clickgen.resolve.constants import kind_of


def check(facts: Facts, problems: Diagnostics) -> None:
    refused = refused_operands(problems)
    for placed in facts.actions:
        finds = placed.effects.finds
        names = (finds.start, finds.end, finds.value) if finds is not None else ()
        if finds is not None and not any(placed.action.args[name].span in refused for name in names):
            _check(placed.action, finds, problems)


def _check(action: Action, finds: Find, problems: Diagnostics) -> None:
    start, end, value = action.args[finds.start], action.args[finds.end], action.args[finds.value]
    if not (isinstance(start, Cell) and isinstance(end, Cell) and isinstance(value, Operand)):
        return
    for place in (start, end):
        if place.address.upper:
            problems.add("CG301", place.span, f"a search cannot begin or end at {place.address}", "search XD0 to XD8")
            return
    if start.bank != end.bank:
        problems.add("CG306", end.span, f"the search begins in {start.bank} and ends in {end.bank}", "search one bank")
    elif start.address.number > end.address.number:
        problems.add(
            "CG306", end.span, f"the search ends at {end.address}, before it begins at {start.address}", "swap them"
        )
    if isinstance(value, Integer) and kind_of(start) is Kind.HEX:
        # Any other whole number among hexadecimal words is hexadecimal by now.
        problems.add("CG302", value.span, range_fault(value, Kind.HEX), "search for 0x0000 to 0xFFFF")
        return
    searched, sought = value_class(start), value_class(value)
    if searched != sought:
        problems.add(
            "CG303", value.span, f"a {sought} value cannot be found among {searched} values", "search another bank"
        )
    elif searched == "text" and action.word(finds.comparison) not in ("==", "!="):
        problems.add(
            "CG301", action.args[finds.comparison].span, "texts are searched with == or !=", 'search("==", ...)'
        )
