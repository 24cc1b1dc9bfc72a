"""The way out for a comparison of values of different kinds: ``ds.A == "5"``, ``ds.A == 0x10``, ``dh.A > ds.B``."""

from __future__ import annotations

import re

from clickgen.device.banks import BANKS, Kind
from clickgen.facts.facts import Facts
from clickgen.facts.values import range_fault
from clickgen.instructions.offered import COPY, COPY_PACK, SEARCH
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, CharCode, Constant, Hex, Integer, Real, Single, Text
from clickgen.text.source import Span

_WHOLE = (Kind.INT16, Kind.INT32)
_HOME = {Kind.INT16: "DS", Kind.INT32: "DD", Kind.FLOAT: "DF", Kind.HEX: "DH"}
_NUMBER = re.compile(r"\s*[+-]?\d{1,10}(?:\.\d{1,10})?\s*")
_HEX = re.compile(r"[0-9A-Fa-f]{1,4}")
_NOWHERE = Span("", 0, 0, 0, 0)


def same_kind(facts: Facts, compare: Compare) -> str:
    """The corrected comparison, or the comparison with a rung before it that copies one of its sides."""
    left, right = compare.left, compare.right
    if isinstance(left, Constant):
        return _with_constant(facts, compare, left, right)
    if isinstance(right, Constant):
        return _with_constant(facts, compare, right, left)
    # The decimal side stays: the other side is copied and the copy compared.
    ranks = {Kind.TEXT: 2, Kind.HEX: 1}
    copied, kept = sorted((left, right), key=lambda side: -ranks.get(_kind(side), 0))
    option = {"options": "to_value"} if _kind(copied) is Kind.TEXT else {}
    home = facts.spell.name(_HOME[_kind(kept)], "Copy")
    copy = facts.spell.call(COPY, facts.text(copied.span), home, **option)
    return _after(facts, copy, _written(facts, compare, copied, home))


def _kind(register: Single) -> Kind:
    return BANKS[register.bank].kind if not isinstance(register, Constant) else Kind.INT16


def _written(facts: Facts, compare: Compare, side: Single, text: str) -> str:
    """The comparison with this text in place of one of its sides."""
    texts = [text if one is side else facts.text(one.span) for one in (compare.left, compare.right)]
    return facts.spell.compared(texts[0], compare.op, texts[1])


def _after(facts: Facts, action: str, condition: str) -> str:
    return f"put a rung before it, {facts.spell.rung('', action)}, and write {condition}"


def _with_constant(facts: Facts, compare: Compare, constant: Constant, register: Single) -> str:
    kind = _kind(register)
    if kind is Kind.TEXT:
        return _beside_text(facts, compare, constant, register)
    number = _number_of(constant, kind)
    shown = _shown(facts, number, kind)
    if shown:
        help = f"write {_written(facts, compare, constant, shown)}"
        if kind is Kind.HEX and isinstance(constant, Text) and constant.value.isdigit() and int(constant.value) > 9:
            help += f", or {facts.spell.hexadecimal(int(constant.value))} where {constant.value} is decimal"
        return (
            f"{help}, the code of {constant.value}"
            if isinstance(constant, Text) and not _reads(constant, kind)
            else help
        )
    if isinstance(constant, Real | Integer):
        home = facts.spell.name("DF" if isinstance(constant, Real) else "DD", "Copy")
        copy = facts.spell.call(COPY, facts.text(register.span), home)
        return _after(facts, copy, _written(facts, compare, register, home))
    if isinstance(constant, Text) and constant.value.isascii() and constant.value.isprintable():
        searched = facts.spell.range("TXT", 1, len(constant.value))
        search, found = searched_for(facts, searched, facts.text(constant.span))
        one = _written(facts, compare, constant, facts.spell.hexadecimal(1) if kind is Kind.HEX else "1")
        return f"a register holds a number, write {one}; a text is in TXT: {_after(facts, search, found)}"
    return f"write the number as the register holds it: {_written(facts, compare, constant, '1')}"


def searched_for(facts: Facts, searched: str, text: str) -> tuple[str, str]:
    """The search for a text in a range, and the bit that says that it is there."""
    found = facts.spell.name("C", "Found")
    named = {"result": facts.spell.name("DS", "FoundAt"), "found": found}
    return facts.spell.call(SEARCH, facts.spell.compared(searched, "==", text), **named), found


def _reads(text: Text, kind: Kind) -> bool:
    """True for a text that is a number to read, not a character."""
    return (_HEX if kind is Kind.HEX else _NUMBER).fullmatch(text.value) is not None


def _number_of(constant: Constant, kind: Kind) -> int | float | None:
    """The number that somebody means who compares this with a register of the kind."""
    if isinstance(constant, Text):
        if _reads(constant, kind):
            if kind is Kind.HEX:
                return int(constant.value, 16)
            return float(constant.value) if "." in constant.value else int(constant.value)
        return ord(constant.value) if len(constant.value) == 1 else None
    if isinstance(constant, CharCode):
        return constant.value
    if isinstance(constant, Hex):
        # A decimal register holds the same bits with a sign.
        bits = {Kind.INT16: 16, Kind.INT32: 32}.get(kind, 64)
        return constant.value - (1 << bits) if constant.value >> (bits - 1) == 1 else constant.value
    return int(constant.value) if isinstance(constant, Real) and constant.value.is_integer() else None


def _shown(facts: Facts, number: int | float | None, kind: Kind) -> str:
    """A number as the language writes it beside a register of this kind; "" if it does not fit."""
    if number is None:
        return ""
    if kind is Kind.HEX:
        return facts.spell.hexadecimal(number) if isinstance(number, int) and 0 <= number <= 0xFFFF else ""
    constant = Integer(number, _NOWHERE) if isinstance(number, int) else Real(number, str(number), _NOWHERE)
    return "" if range_fault(constant, kind) else str(number)


def _beside_text(facts: Facts, compare: Compare, constant: Constant, register: Single) -> str:
    """``txt[1] == 5``: the digit, the character with a code, or the number that several digits are."""
    text = facts.text(register.span)
    if isinstance(constant, Integer) and 0 <= constant.value <= 9:
        return f"write {_written(facts, compare, constant, facts.spell.quoted(str(constant.value)))}"
    if isinstance(constant, Hex) and constant.value <= 0x7F:
        sign = chr(constant.value)
        shown = sign if sign.isalnum() else f"${constant.value:02X}"
        return f"write {_written(facts, compare, constant, facts.spell.quoted(shown))}"
    number = str(constant.value) if isinstance(constant, Hex) else facts.text(constant.span)
    is_numbered = isinstance(register, Cell) and text == facts.spell.cell(register.address)
    first = register.address.number if isinstance(register, Cell) and is_numbered else 1
    last = min(first + len(number) - 1, BANKS["TXT"].last)
    home = facts.spell.name("DF" if isinstance(constant, Real) else "DD", "Value")
    sides = [home if side is register else number for side in (compare.left, compare.right)]
    pack = facts.spell.call(COPY_PACK, facts.spell.range("TXT", first, last), home)
    packed = _after(facts, pack, facts.spell.compared(sides[0], compare.op, sides[1]))
    return f"a TXT address holds one character; of a number with several digits {packed}"
