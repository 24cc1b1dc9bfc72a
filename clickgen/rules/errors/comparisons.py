"""Compared values are of one class: decimal, hexadecimal or text (click-facts [compare.classes])."""

from __future__ import annotations

from clickgen.device.banks import BANKS, Kind
from clickgen.facts.facts import Facts
from clickgen.facts.kinds import same_kind
from clickgen.facts.values import range_fault, value_class
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, Constant, Integer, Single, Text
from clickgen.problems.diagnostics import Diagnostics
from clickgen.resolve.constants import kind_of


def check(facts: Facts, problems: Diagnostics) -> None:
    for compare in facts.comparisons:
        _check(facts, compare, problems)


def _check(facts: Facts, compare: Compare, problems: Diagnostics) -> None:
    left, right = compare.left, compare.right
    for side in (left, right):
        if isinstance(side, Cell) and BANKS[side.bank].is_bit:
            bank = BANKS[side.bank].dsl
            problems.add(
                "CG303",
                side.span,
                f"{side.address} is a bit and cannot be compared",
                f"a bit is a condition by itself: {bank}.Name, or nc({bank}.Name)",
            )
            return
    if isinstance(left, Constant) and isinstance(right, Constant):
        problems.add("CG303", compare.span, "two constants are compared", "compare a register")
        return
    for constant, other in ((left, right), (right, left)):
        # Any other constant beside a hexadecimal word is hexadecimal by now.
        if isinstance(constant, Integer) and kind_of(other) is Kind.HEX:
            problems.add("CG302", constant.span, range_fault(constant, Kind.HEX), _word(facts, compare, constant))
            return
    classes = value_class(left), value_class(right)
    if classes[0] != classes[1]:
        problems.add(
            "CG303",
            compare.span,
            f"a {classes[0]} value and a {classes[1]} value cannot be compared",
            same_kind(facts, compare),
        )
        return
    for constant, other in ((left, right), (right, left)):
        fault = range_fault(constant, kind_of(other))
        if fault:
            problems.add("CG302", constant.span, fault, "the comparison could never change")
        elif isinstance(constant, Text) and len(constant.value) != 1:
            problems.add("CG302", constant.span, "a TXT address holds one character", _search(facts, compare, other))


def _word(facts: Facts, compare: Compare, constant: Integer) -> str:
    """The way out for ``dh.A == -1``: the word with the same bits."""
    if not -0x8000 <= constant.value < 0:
        return "the comparison could never change"
    word = f"0x{constant.value + 0x10000:04X}"
    left, right = (word if side is constant else facts.text(side.span) for side in (compare.left, compare.right))
    return f"the comparison could never change; the same bits are {left} {compare.op} {right}"


def _search(facts: Facts, compare: Compare, register: Single) -> str:
    """The way out for a text of several characters: a search compares it with as many addresses."""
    text = compare.left if isinstance(compare.left, Text) else compare.right
    shown = facts.text(register.span)
    count = len(text.value) if isinstance(text, Text) else 0
    if isinstance(register, Cell):
        first = register.address.number
        shown = f"txt[{first}:{first + count}]"
        is_there = BANKS["TXT"].has(first + count - 1)
    else:
        shown = shown if shown.endswith("]") else f"{shown}[0:{count}]"
        is_there = True
    if not count or not is_there or compare.op not in ("==", "!="):
        return 'compare with one: txt[1] == "A"'
    bit = "c.Found" if compare.op == "==" else "nc(c.Found)"
    search = f"search({shown} == {facts.text(text.span)}, result=ds.FoundAt, found=c.Found)"
    return f"compare with one character, or search in a rung before, {search}, and test {bit}"
