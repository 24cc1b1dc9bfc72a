"""Addresses inside a formula: ``ds.Name``, ``ds["Any name"]``, ``ds[5]``, ``xd["0u"]``, ``ds[ds.Index]``, ``ds[1:9]``.

Another module checks whether a formula takes the operand; here it only has to exist.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from lark import Token

from clickgen.device.banks import BANKS, POINTED, UPPER_BYTE_BANKS, Address, Bank
from clickgen.dialects.if_rungs.trade import bank_hint
from clickgen.formula.report import Report
from clickgen.ir.operands import Cell, Named, Pointer, Range, Section
from clickgen.problems.diagnostics import did_you_mean


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


Index = Token | Negative | Reference


def start_of(part: Index) -> int:
    return part.start if isinstance(part, Negative | Reference) else part.start_pos or 0


def end_of(part: Index) -> int:
    return part.end if isinstance(part, Negative | Reference) else part.end_pos or 0


def named(word: Token, member: Token, report: Report) -> Reference:
    """``ds.Name``"""
    start, end = start_of(word), end_of(member)
    bank = _bank(word, report)
    if bank is None:
        return Reference(None, start, end)
    return Reference(Named(bank.name, member.value[1:].lstrip(), report.text.span(start, end)), start, end)


def member(word: Token, name: Token, index: Index, close: Token, report: Report) -> Reference:
    """``ds.Recipe[3]``: one member of a block, counted from 0."""
    whole = named(word, name, report)
    start, end = whole.start, end_of(close)
    if isinstance(index, Reference):
        help = "point into the bank, ds[ds.Index], with the block's first address added to the index"
        report.add("CG214", index.start, index.end, "a pointer cannot count inside a block", help)
        return Reference(None, start, end)
    return _part(whole, _count(index, report), end, report)


def section(
    word: Token, name: Token, bounds: tuple[Index | None, Index | None, Index | None], close: Token, report: Report
) -> Reference:
    """``ds.Recipe[0:10]``: a part of a block, half-open."""
    whole = named(word, name, report)
    numbers = [None if bound is None else _count(bound, report) for bound in bounds]
    if any(number is None and bound is not None for number, bound in zip(numbers, bounds, strict=True)):
        return Reference(None, whole.start, end_of(close))
    first, stop, step = numbers
    if step not in (None, 1):
        report.add("CG202", whole.start, end_of(close), "the range skips addresses", "a formula adds up all of them")
        return Reference(None, whole.start, end_of(close))
    return _part(whole, Section(first, stop), end_of(close), report)


def _part(whole: Reference, part: int | Section | None, end: int, report: Report) -> Reference:
    if not isinstance(whole.ref, Named) or part is None:
        return Reference(None, whole.start, end)
    return Reference(replace(whole.ref, part=part, span=report.text.span(whole.start, end)), whole.start, end)


def _count(index: Index, report: Report) -> int | None:
    """The index in a block, or None after reporting its fault."""
    number = _number(index, report)
    if number is not None and number < 0:
        report.add("CG214", start_of(index), end_of(index), "the members of a block are counted from 0", "ds.Recipe[0]")
        return None
    return number


def indexed(word: Token, index: Index, close: Token, report: Report) -> Reference:
    """``ds[5]``, ``ds["Any name"]``, ``xd["0u"]`` or a pointer."""
    start, end = start_of(word), end_of(close)
    bank = _bank(word, report)
    if isinstance(index, Reference):
        return Reference(_pointer(bank, index, start, end, report), start, end)
    if bank is None:
        return Reference(None, start, end)
    ref: Named | Cell | None
    if isinstance(index, Token) and index.type == "STRING":
        ref = _quoted(bank, index, start, end, report)
    else:
        number = _number(index, report)
        ref = None
        if number is not None and _exists(bank, number, index, report):
            ref = Cell(Address(bank.name, number), report.text.span(start, end))
    return Reference(ref, start, end)


def sliced(
    word: Token, first: Index | None, stop: Index | None, step: Index | None, close: Token, report: Report
) -> Reference:
    """``ds[1:11]``, half-open like every slice: DS1 to DS10."""
    start, end = start_of(word), end_of(close)
    told = Reference(None, start, end)
    bank = _bank(word, report)
    if first is None or stop is None:
        report.add("CG202", start, end, "the range lacks an end", "write both ends: ds[1:11] is DS1 to DS10")
        return told
    low, high = _number(first, report), _number(stop, report)
    pace = 1 if step is None else _number(step, report)
    if bank is None or low is None or high is None or pace is None:
        return told
    if pace != 1:
        report.add(
            "CG202",
            start,
            end,
            "the range is reversed" if pace < 0 else "the range skips addresses",
            "a formula adds up consecutive addresses from the lowest upwards: ds[1:11]",
        )
        return told
    last = high - 1
    if last < low:
        report.add(
            "CG202",
            start,
            end,
            "the range is empty" if last == low - 1 else "the range is reversed",
            f"the end of a slice is not included, as in Python: {word.value}[{low}:{low + 10}] is "
            f"{bank.name}{low} to {bank.name}{low + 9}",
        )
        return told
    fits = _exists(bank, low, first, report)
    if not bank.has(last):
        _outside(bank, last, start_of(stop), end_of(stop), report)
        fits = False
    if not fits:
        return told
    if not any(lowest <= low and last <= highest for lowest, highest in bank.ranges):
        report.add(
            "CG202",
            start,
            end,
            f"the range runs over a gap: {bank.name} has the numbers {bank.describe_range()}",
            "keep the range inside one module",
        )
        return told
    return Reference(Range(bank.name, low, last, report.text.span(start, end)), start, end)


def _bank(word: Token, report: Report) -> Bank | None:
    bank = BANKS.get(word.value.upper())
    if bank is not None and word.value == bank.dsl:
        return bank
    if bank is not None:
        message, help = f"banks are written in lower case: `{bank.dsl}`", f"write {bank.dsl} instead of {word.value}"
    else:
        names = [known.dsl for known in BANKS.values()]
        message = f"there is no bank `{word.value}`"
        help = bank_hint(word.value) or did_you_mean(word.value, names) or f"the banks are {', '.join(names)}"
    report.add("CG113", start_of(word), end_of(word), message, help)
    return None


def _quoted(bank: Bank, token: Token, start: int, end: int, report: Report) -> Named | Cell | None:
    name = token.value[1:-1]
    span = report.text.span(start, end)
    if name in ("0u", "0U") and bank.name in UPPER_BYTE_BANKS:
        return Cell(Address(bank.name, 0, True), span)
    if not name.strip():
        report.add(
            "CG113",
            start_of(token),
            end_of(token),
            "there is no nickname between the quotes",
            f'write {bank.dsl}["Any name"], {bank.dsl}.Name or {bank.dsl}[{bank.first}]',
        )
        return None
    return Named(bank.name, name, span)


def _pointer(bank: Bank | None, index: Reference, start: int, end: int, report: Report) -> Pointer | None:
    if bank is not None and bank.name not in POINTED:
        report.add(
            "CG213",
            start,
            end,
            f"CLICK has no pointers into {bank.name}",
            f"a pointer reaches into {', '.join(name.lower() for name in POINTED)}",
        )
        bank = None
    register = index.ref
    if register is None:
        return None
    if isinstance(register, Pointer | Range):
        kind = "another pointer" if isinstance(register, Pointer) else "a range"
        help = "copy the number to a DS register first, and point through that one"
        report.add("CG212", index.start, index.end, f"a pointer goes through one DS register, not {kind}", help)
        return None
    if register.bank != "DS":
        report.add(
            "CG212",
            index.start,
            index.end,
            f"a pointer goes through a DS register, and this one is {register.bank}",
            "copy it to a DS register first, and point through that one",
        )
        return None
    if bank is None:
        return None
    return Pointer(bank.name, register, report.text.span(start, end))


def _number(index: Index, report: Report) -> int | None:
    """The number in brackets, or None after reporting its fault."""
    if isinstance(index, Negative):
        return index.value
    if isinstance(index, Token):
        if index.type == "NUMBER" and index.value.isdigit():
            return int(index.value)
        digits = index.value
        if index.type == "HEX":
            value = int(digits[2:] if digits[:2] in ("0x", "0X") else digits[:-1], 16)
            message, help = "addresses are numbered in decimal", f"write {value} instead of {digits}"
        elif index.type == "STRING":
            message, help = "the ends of a range are numbers", "write ds[1:11]"
        else:
            message, help = f"`{digits}` is not a whole number", "write ds[5]"
        report.add("CG201", start_of(index), end_of(index), message, help)
    elif index.ref is not None:
        report.add("CG202", index.start, index.end, "the ends of a range are numbers", "write ds[1:11]")
    return None


def _exists(bank: Bank, number: int, index: Index, report: Report) -> bool:
    if bank.has(number):
        return True
    _outside(bank, number, start_of(index), end_of(index), report)
    return False


def _outside(bank: Bank, number: int, start: int, end: int, report: Report) -> None:
    shown = str(number) if abs(number) < 10**9 else "of that number"
    also = f', and {bank.dsl}["0u"]' if bank.name in UPPER_BYTE_BANKS else ""
    report.add(
        "CG201", start, end, f"{bank.name} has no address {shown}", f"{bank.name} has {bank.describe_range()}{also}"
    )
