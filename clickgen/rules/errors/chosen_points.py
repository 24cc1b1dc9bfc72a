"""Inputs and outputs whose addresses clickgen chose, inside a word that the program uses as a whole."""

from __future__ import annotations

from collections.abc import Collection

from clickgen.device.banks import WORD_TWINS, Address, points_of
from clickgen.facts.facts import Facts
from clickgen.facts.uses import Use, addresses_of
from clickgen.ir.operands import Operand, Pointer, form_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    left = {point for point in facts.placed if point.bank in ("X", "Y") and point not in facts.declared}
    for use in filter(_is_disturbing, facts.uses.every if left else ()):
        met = sorted(left & _points(use.operand, left))
        left.difference_update(met)
        if met:
            point = met[0]
            named = facts.spell.name(point.bank, facts.nickname(point))
            verb, noun = "writes" if use.is_written else "reads", "address" if len(met) == 1 else "addresses"
            yield finding(
                "CG432",
                use.operand.span,
                f"this {verb} {facts.listed(met)} too, whose {noun} clickgen chose: is it wired there?",
                f"pin it where it is wired, such as {facts.spell.declaration(named, facts.spell.cell(point))}",
            )


def _is_disturbing(use: Use) -> bool:
    return form_of(use.operand) == ("YD" if use.is_written else "XD")


def _points(word: Operand, among: Collection[Address]) -> set[Address]:
    if isinstance(word, Pointer):
        return {point for point in among if point.bank == WORD_TWINS[word.bank]}
    return {point for address in addresses_of(word) for point in points_of(address)}


ABOUT = Code(
    "CG432",
    Severity.WARNING,
    "a word holds an input or output that clickgen chose",
    """
YD0 holds the outputs Y001 to Y016: an instruction that writes the word switches all of them. One of
these outputs has a name whose address clickgen chose, because nothing said where it is wired. The same happens with
an input inside an XD word that the program reads. Assign the name to its terminal with `nickname(...)` in the
program, and the warning goes away.
""",
    wrong=(
        Wrong(
            """
if x[1]:
    copy(dh.Pattern, yd[0])  # <-
    out(y.Lamp)
""",
        ),
    ),
    right=(
        """
nickname(y.Lamp, y[1])


def main():
    if x[1]:
        copy(dh.Pattern, yd[0])
        out(y.Lamp)
    if True:
        end()
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
