"""Reads operands and contacts from CLICK's ladder tokens: the way back from ``lower/tokens.py``."""

from __future__ import annotations

import re
from collections.abc import Callable

from clickgen.click.read.calls import unquoted
from clickgen.device.banks import BANKS, FLOAT_MAX, POINTED, parse_address
from clickgen.ir.conditions import Compare, Contact, Edge
from clickgen.ir.operands import Cell, CharCode, Hex, Immediate, Integer, Operand, Pointer, Range, Real, Text
from clickgen.text.source import EmbeddedText, SourceFile, Span

ADDRESS = r"[A-Z]{1,3}[0-9]{1,4}u?"
_TEXT = r'"(?:[^"]|"")*"'
_NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?"
_SIDE = rf"{ADDRESS}|[0-9A-Fa-f]{{1,8}}h|{_NUMBER}|{_TEXT}|\$[0-9A-Fa-f]{{2}}"
_COMPARE = re.compile(rf"({_SIDE})\s*(==|!=|<=|>=|<|>)\s*({_SIDE})")
_EDGE = re.compile(rf"(rise|fall)\(\s*({ADDRESS})\s*\)")
_CODE = re.compile(r"\$([0-9A-Fa-f]{2})")
_CONTACT = re.compile(rf"(~?)\s*(?:({ADDRESS})(\.immediate)?|immediate\(\s*({ADDRESS})\s*\))")
_LIKE_ADDRESS = re.compile(r"\b([A-Z]{1,3})[0-9]{1,9}u?\b")
_LARGEST_WORD = 0xFFFFFFFF
"""The largest hexadecimal constant for laddercodec; a build knows which of them an instruction takes."""


def operand_of(text: str, span: Span) -> Operand | None:
    """``DS5``, ``C1..C8``, ``DS[DS1]``, ``immediate(Y001)``, ``5``, ``00FFh``, ``1.5``, ``"ABC"``, ``$0D``; or None."""
    text = text.strip()
    for pattern, read in _FORMS:
        match = pattern.fullmatch(text)
        if match:
            return read(match, span)
    return None


def condition_of(text: str, span: Span) -> Contact | Compare | None:
    """Read ``X001``, ``~X001``, ``X001.immediate``, ``rise(C1)``, ``DS1==5``; or None."""
    edge = _EDGE.fullmatch(text)
    if edge:
        cell = _cell(edge[2], span)
        return Contact(cell, span, edge=Edge(edge[1])) if cell and BANKS[cell.bank].is_bit else None
    contact = _CONTACT.fullmatch(text)
    if contact:
        cell = _cell(contact[2] or contact[4], span)
        is_immediate = bool(contact[3] or contact[4])
        if cell is None or not BANKS[cell.bank].is_bit or (is_immediate and cell.bank != "X"):
            return None
        return Contact(Immediate(cell, span) if is_immediate else cell, span, negated=bool(contact[1]))
    compare = _COMPARE.fullmatch(text)
    if compare:
        left, right = operand_of(compare[1], span), operand_of(compare[3], span)
        if left is None or right is None or isinstance(left, Range | Immediate) or isinstance(right, Range | Immediate):
            return None
        return Compare(compare[2], left, right, span)
    return None


def missing_address(text: str) -> str:
    """The first address in a token that its bank does not have, such as X017; "" if all exist."""
    for match in _LIKE_ADDRESS.finditer(re.sub(_TEXT, "", text)):
        if match[1] in BANKS and parse_address(match[0]) is None:
            return match[0]
    return ""


def embedded(text: str, span: Span) -> EmbeddedText:
    """A text that is in no source yet."""
    positions = tuple((span.line, span.col + index) for index in range(len(text) + 1))
    return EmbeddedText(SourceFile(span.path, text), text, positions)


def _cell(text: str, span: Span) -> Cell | None:
    address = parse_address(text)
    return Cell(address, span) if address else None


def _range(match: re.Match[str], span: Span) -> Range | None:
    first, last = parse_address(match[1]), parse_address(match[2])
    if first is None or last is None or first.bank != last.bank or first.upper or last.upper:
        return None
    low, high = sorted((first.number, last.number))
    if not any(start <= low and high <= stop for start, stop in BANKS[first.bank].ranges):
        return None
    return Range(first.bank, first.number, last.number, span)


def _pointer(match: re.Match[str], span: Span) -> Pointer | None:
    register = _cell(match[2], span)
    return Pointer(match[1], register, span) if register and register.bank == "DS" and match[1] in POINTED else None


def _immediate(match: re.Match[str], span: Span) -> Immediate | None:
    target = operand_of(match[1], span)
    return Immediate(target, span) if isinstance(target, Cell | Range) else None


def _hex(match: re.Match[str], span: Span) -> Hex | None:
    value = int(match[1], 16)
    return Hex(value, span) if value <= _LARGEST_WORD else None


def _real(match: re.Match[str], span: Span) -> Real | None:
    value = float(match[0])
    return Real(value, match[0].lower().replace("+", ""), span) if abs(value) <= FLOAT_MAX else None


def _text(match: re.Match[str], span: Span) -> Text | None:
    value = unquoted(match[0])
    # A text like $0D would be a character code in a program.
    if value is None or _CODE.fullmatch(value):
        return None
    return Text(value, span, embedded(value, span))


_FORMS: tuple[tuple[re.Pattern[str], Callable[[re.Match[str], Span], Operand | None]], ...] = (
    (re.compile(rf"({ADDRESS})\s*\.\.\s*({ADDRESS})"), _range),
    (re.compile(rf"({ADDRESS})"), lambda match, span: _cell(match[1], span)),
    (re.compile(r"([A-Z]{1,3})\[\s*(DS[0-9]{1,4})\s*\]"), _pointer),
    (re.compile(rf"immediate\(\s*({ADDRESS}(?:\s*\.\.\s*{ADDRESS})?)\s*\)"), _immediate),
    (re.compile(rf"({ADDRESS}(?:\s*\.\.\s*{ADDRESS})?)\.immediate"), _immediate),
    (re.compile(r"([+-]?[0-9]{1,20})"), lambda match, span: Integer(int(match[1]), span)),
    (re.compile(r"([0-9A-Fa-f]{1,8})h"), _hex),
    (re.compile(_NUMBER), _real),
    (re.compile(_TEXT, re.DOTALL), _text),
    (_CODE, lambda match, span: CharCode(int(match[1], 16), span)),
)
