"""Inputs and outputs whose addresses clickgen chose, inside a word that the program uses as a whole."""

from __future__ import annotations

from collections.abc import Collection

from clickgen.device.banks import WORD_TWINS, Address, points_of
from clickgen.facts.facts import Facts
from clickgen.facts.uses import Use, addresses_of
from clickgen.formula.spelling import SPELL
from clickgen.ir.operands import Named, Operand, Pointer, form_of
from clickgen.problems.diagnostics import Diagnostics


def check(facts: Facts, problems: Diagnostics) -> None:
    left = {point for point in facts.placed if point.bank in ("X", "Y") and point not in facts.declared}
    for use in filter(_is_disturbing, facts.uses.every if left else ()):
        met = sorted(left & _points(use.operand, left))
        left.difference_update(met)
        if met:
            point = met[0]
            named = SPELL.reference(Named(point.bank, facts.nickname(point), use.operand.span))
            verb, noun = "writes" if use.is_written else "reads", "address" if len(met) == 1 else "addresses"
            problems.add(
                "CG432",
                use.operand.span,
                f"this {verb} {facts.listed(met)} too, whose {noun} clickgen chose: is it wired there?",
                f"pin it where it is wired, such as nickname({named}, {point.bank.lower()}[{point.number}])",
            )


def _is_disturbing(use: Use) -> bool:
    return form_of(use.operand) == ("YD" if use.is_written else "XD")


def _points(word: Operand, among: Collection[Address]) -> set[Address]:
    if isinstance(word, Pointer):
        return {point for point in among if point.bank == WORD_TWINS[word.bank]}
    return {point for address in addresses_of(word) for point in points_of(address)}
