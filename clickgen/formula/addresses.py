"""Addresses inside a formula: lark's tokens for the reader of addresses, and its faults at their places.

Another module checks whether a formula takes the operand; here it only has to exist.
"""

from __future__ import annotations

from dataclasses import dataclass

from lark import Token

from clickgen.formula.report import Report
from clickgen.formula.spelling import SPELL
from clickgen.ir.addresses import NO_NUMBER, AddressReader, Bounds, Fault, Index, Odd, Part
from clickgen.ir.operands import Cell, Named, Pointer, Range

READER = AddressReader(SPELL)


@dataclass(frozen=True, slots=True)
class Reference:
    """An address as written; ``ref`` is None once its mistake has been reported."""

    ref: Named | Cell | Pointer | Range | None
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Negative:
    """``-1`` inside brackets."""

    value: int
    start: int
    end: int


Inside = Token | Negative | Reference
"""What lark has between brackets, one of it."""
Slice = tuple[Inside | None, Inside | None, Inside | None]


def start_of(part: Inside) -> int:
    return part.start if isinstance(part, Negative | Reference) else part.start_pos or 0


def end_of(part: Inside) -> int:
    return part.end if isinstance(part, Negative | Reference) else part.end_pos or 0


def named(word: Token, member: Token, report: Report) -> Reference:
    """``ds.Name``"""
    start, end = start_of(word), end_of(member)
    bank = READER.bank(word.value, None, lambda: report.text.value[start:end])
    if isinstance(bank, Fault):
        return _refused(bank, word, None, start, end, report)
    return Reference(Named(bank.name, member.value[1:].lstrip(), report.text.span(start, end)), start, end)


def member(word: Token, name: Token, inside: Inside | Slice, close: Token, report: Report) -> Reference:
    """``ds.Recipe[3]`` and ``ds.Recipe[0:10]``: members of a block."""
    whole = named(word, name, report)
    start, end = whole.start, end_of(close)
    index = _index(inside)
    if not isinstance(whole.ref, Named) and isinstance(inside, Reference):
        report.forget(inside.start, inside.end)
    if not isinstance(whole.ref, Named) or index is None:
        return Reference(None, start, end)
    shown = report.text.value[start : whole.end]
    found = READER.part(whole.ref, index, report.text.span(start, end), shown)
    if isinstance(found, Fault):
        return _refused(found, word, inside, start, end, report)
    return Reference(found, start, end)


def indexed(word: Token, inside: Inside | Slice, close: Token, report: Report) -> Reference:
    """``ds[5]``, ``ds["Any name"]``, ``xd["0u"]``, ``ds[1:11]`` or a pointer."""
    start, end = start_of(word), end_of(close)
    index = _index(inside)
    bank = READER.bank(word.value, index, lambda: report.text.value[start:end])
    if isinstance(bank, Fault):
        if isinstance(inside, Reference):
            report.forget(inside.start, inside.end)
        return _refused(bank, word, inside, start, end, report)
    if index is None:
        return Reference(None, start, end)
    found = READER.indexed(bank, index, report.text.span(start, end), lambda: report.text.value[start:end])
    if isinstance(found, Fault):
        return _refused(found, word, inside, start, end, report)
    return Reference(found, start, end)


def _index(inside: Inside | Slice) -> Index | None:
    """What is between the brackets; None for an address whose mistake was told."""
    if isinstance(inside, tuple):
        return Bounds(*(None if bound is None else _number(bound) for bound in inside))
    if isinstance(inside, Reference):
        return inside.ref
    if isinstance(inside, Token) and inside.type == "STRING":
        text: str = inside.value[1:-1]
        return text
    return _number(inside)


def _number(part: Inside) -> int | Odd:
    if isinstance(part, Negative):
        return part.value
    if isinstance(part, Token) and part.type == "NUMBER" and part.value.isdigit():
        return int(part.value)
    if isinstance(part, Token) and part.type == "HEX":
        if part.value[:2] in ("0x", "0X"):
            return int(part.value[2:], 16)
        return Odd(hexadecimal=int(part.value[:-1], 16))
    return NO_NUMBER


def _refused(
    fault: Fault, word: Token, inside: Inside | Slice | None, start: int, end: int, report: Report
) -> Reference:
    """A reference whose fault is told at the part that has it."""
    at = (start, end)
    if fault.part is Part.BANK:
        at = (start_of(word), end_of(word))
    elif fault.part is Part.INDEX:
        assert inside is not None
        assert not isinstance(inside, tuple)
        at = (start_of(inside), end_of(inside))
    report.add(fault.code, *at, fault.message, fault.help, fault.bank)
    return Reference(None, start, end)
