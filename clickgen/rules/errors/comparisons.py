"""Compared values are of one class: decimal, hexadecimal or text (click-facts [compare.classes])."""

from __future__ import annotations

from clickgen.device.banks import BANKS, Address, Kind
from clickgen.facts.facts import Facts
from clickgen.facts.kinds import same_kind, searched_for
from clickgen.facts.values import range_fault, value_class
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, Constant, Integer, Single, Text
from clickgen.resolve.constants import kind_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    for compare in facts.comparisons:
        yield from _check(facts, compare)


def _check(facts: Facts, compare: Compare) -> Findings:
    left, right = compare.left, compare.right
    for side in (left, right):
        if isinstance(side, Cell) and BANKS[side.bank].is_bit:
            name = facts.spell.name(side.bank, "Name")
            yield finding(
                "CG303",
                side.span,
                f"{side.address} is a bit and cannot be compared",
                f"a bit is a condition by itself: {name}, or {facts.spell.off(name)}",
            )
            return
    if isinstance(left, Constant) and isinstance(right, Constant):
        yield finding("CG303", compare.span, "two constants are compared", "compare a register")
        return
    for constant, other in ((left, right), (right, left)):
        # Any other constant beside a hexadecimal word is hexadecimal by now.
        if isinstance(constant, Integer) and kind_of(other) is Kind.HEX:
            yield finding("CG302", constant.span, range_fault(constant, Kind.HEX), _word(facts, compare, constant))
            return
    classes = value_class(left), value_class(right)
    if classes[0] != classes[1]:
        yield finding(
            "CG303",
            compare.span,
            f"a {classes[0]} value and a {classes[1]} value cannot be compared",
            same_kind(facts, compare),
        )
        return
    for constant, other in ((left, right), (right, left)):
        fault = range_fault(constant, kind_of(other))
        if fault:
            yield finding("CG302", constant.span, fault, "the comparison could never change")
        elif isinstance(constant, Text) and len(constant.value) != 1:
            yield finding("CG302", constant.span, "a TXT address holds one character", _search(facts, compare, other))


def _word(facts: Facts, compare: Compare, constant: Integer) -> str:
    """The way out for ``dh.A == -1``: the word with the same bits."""
    if not -0x8000 <= constant.value < 0:
        return "the comparison could never change"
    word = facts.spell.hexadecimal(constant.value + 0x10000)
    left, right = (word if side is constant else facts.text(side.span) for side in (compare.left, compare.right))
    return f"the comparison could never change; the same bits are {facts.spell.compared(left, compare.op, right)}"


def _search(facts: Facts, compare: Compare, register: Single) -> str:
    """The way out for a text of several characters: a search compares it with as many addresses."""
    text = compare.left if isinstance(compare.left, Text) else compare.right
    shown = facts.text(register.span)
    count = len(text.value) if isinstance(text, Text) else 0
    if isinstance(register, Cell):
        first = register.address.number
        shown = facts.spell.range("TXT", first, first + count - 1)
        is_there = BANKS["TXT"].has(first + count - 1)
    else:
        shown = facts.spell.members(shown, count) if facts.spell.is_name(shown) else shown
        is_there = True
    if not count or not is_there or compare.op not in ("==", "!="):
        one = facts.spell.compared(facts.spell.cell(Address("TXT", 1)), "==", facts.spell.quoted("A"))
        return f"compare with one: {one}"
    search, found = searched_for(facts, shown, facts.text(text.span))
    bit = found if compare.op == "==" else facts.spell.off(found)
    return f"compare with one character, or search in a rung before, {search}, and test {bit}"


ABOUT = Code(
    "CG303",
    Severity.ERROR,
    "values of different kinds cannot be compared",
    """
CLICK compares decimal with decimal (DS, DD, DF, TD, CTD, SD), hexadecimal with hexadecimal (DH, XD, YD)
and text with text, in conditions and in `search`. Write a constant in the form of the register: `ds.Speed == 16`, not
`ds.Speed == 0x10` or `ds.Speed == "16"`. To compare two registers, first copy one to a register of the other kind.
Do not compare a bit: it is a condition by itself, and so is `all(...)` or `nc(...)`.
""",
    wrong=(
        Wrong(
            """
if ds.Speed == dh.Code:  # <-
    out(y[1])

if x[1] == True:  # <-
    out(y[2])
""",
            """
if ds.Speed == dh.Code:  # <-
    out(y[1])

if x[1]:  # <-
    out(y[2])
""",
        ),
    ),
    right=(
        """
if x[1]:
    out(y[2])
""",
        """
if ds.Speed == ds.Limit:
    out(y[1])
if dh.Code == 0x00FF:
    out(y[3])
""",
    ),
)

RULE = Rule(find, (ABOUT,), also=("CG302",), holds_in_parts=True)
