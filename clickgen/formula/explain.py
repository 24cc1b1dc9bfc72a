"""Explains a syntax error that lark found, in the words of the table of mistakes."""

from __future__ import annotations

import re

from lark import UnexpectedCharacters, UnexpectedInput, UnexpectedToken

from clickgen.device.banks import Bank, parse_address
from clickgen.formula.addresses import READER
from clickgen.formula.mistakes import MISTAKES, SPELLINGS, Mistake, Situation, Spelling
from clickgen.formula.report import Report
from clickgen.formula.spelling import SPELL
from clickgen.formula.words import INSTRUCTION, OPERATORS, OTHER, SHIFTS
from clickgen.ir.addresses import NO_NUMBER, Bounds, Fault, Odd, Part
from clickgen.ir.formula_nodes import Mode
from clickgen.ir.operands import Named

_QUOTES = "\"'"
_LAST = re.compile(r"([\w.]+|\S)\s*$")
_BRACKET = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'|[()\[\]]")
_NATIVE_RANGE = re.compile(r"(\w+)\s*:\s*(\w+)")


def explain(error: UnexpectedInput, mode: Mode, report: Report) -> None:
    """Add the one problem for a syntax error."""
    value = report.text.value
    start = error.pos_in_stream if error.pos_in_stream is not None and error.pos_in_stream >= 0 else len(value)
    found = "$END"
    end = start
    if isinstance(error, UnexpectedToken) and error.token.type != "$END":
        found = error.token.type
        start = error.token.start_pos or 0
        end = error.token.end_pos or start + 1
    elif isinstance(error, UnexpectedToken):
        start = end = len(value)
    sign = spelling_at(value, start, isinstance(error, UnexpectedCharacters))
    if sign is not None:
        at, written = sign
        _explain_spelling(SPELLINGS[written], at, at + len(written), mode, report)
        return
    if isinstance(error, UnexpectedCharacters):
        fault = f"`{_printable(value[start])}` has no place in a formula"
        report.add("CG116", start, start + 1, fault, "take it out; the signs of formulas are + - * / ^ ( ) , : and [ ]")
        return
    expected = error.expected if isinstance(error, UnexpectedToken) else set()
    if situation_of(expected) == "index" and _explain_index(value, start, report):
        return
    before = _LAST.search(value, max(0, start - 100), start)
    touching = before is not None and before.end() == before.end(1)
    mistake = find_mistake(situation_of(expected), found, before.group(1) if before else "", touching)
    names = {"found": _printable(value[start:end]), "before": _printable(before.group(1)) if before else ""}
    help = mistake.help.format(**names)
    if found == "COLON" and (help_range := _native_range(value, start)):
        help = help_range
    if mistake.place == "before" and before:
        start, end = before.span(1)
    elif mistake.place == "open":
        start = _innermost_open(value, start)
        end = start + 1
    report.add("CG116", start, end, mistake.message.format(**names), help)


def _explain_index(value: str, at: int, report: Report) -> bool:
    """Tell of an address with something between its brackets that says no number; True when that was told."""
    opening = _innermost_open(value, at)
    head = _HEAD.search(value, 0, opening) if value[opening : opening + 1] == "[" else None
    closing = _closing(value, opening)
    odd = _odd(value[opening + 1 : closing].strip()) if head and closing > 0 else None
    if head is None or odd is None:
        return False
    inside = (opening + 1, closing)
    whole = (head.start("bank"), closing + 1)
    shown = value[whole[0] : head.end("name")] if head["name"] else value[slice(*whole)]
    found: object = READER.bank(head["bank"], odd, lambda: shown)
    if isinstance(found, Bank):
        span = report.text.span(*whole)
        if head["name"]:
            found = READER.part(Named(found.name, head["name"], span), odd, span, shown)
        else:
            found = READER.indexed(found, odd, span, lambda: shown)
    if not isinstance(found, Fault):
        return False
    places = {Part.WHOLE: whole, Part.BANK: head.span("bank"), Part.INDEX: inside}
    report.add(found.code, *places[found.part], found.message, found.help, found.bank)
    return True


_HEAD = re.compile(r"(?P<bank>[^\W\d]\w*)\s*(?:\.\s*(?P<name>[^\W\d]\w*)\s*)?$")
_WORD = re.compile(r"[^\W\d]\w*")
_DIFFERENCE = re.compile(r"([0-9]{1,9})\s*-\s*([0-9]{1,9})")
_CALCULATED = re.compile(r"\S\s*[-+*/]|\w\s*\(|\w\s+(?:MOD|AND|OR|XOR|SHL|SHR|LSH|RSH|LRO|RRO)\s", re.IGNORECASE)


def _odd(inside: str) -> Odd | Bounds | None:
    """What no number is, of a text between brackets; None for what the table of mistakes tells better."""
    difference = _DIFFERENCE.fullmatch(inside)
    if _WORD.fullmatch(inside):
        return Odd(word=inside)
    if difference:
        return Odd(difference=(int(difference[1]), int(difference[2])), is_calculated=True)
    if inside.count(":") in (1, 2) and "[" not in inside and '"' not in inside:
        return Bounds(NO_NUMBER, NO_NUMBER)
    if _CALCULATED.search(inside):
        return Odd(is_calculated=True)
    if "," in inside:
        return Odd(is_list=True)
    return NO_NUMBER if inside[:1] in ("+", "-") else None


def _closing(value: str, opening: int) -> int:
    """Where a square bracket is closed; -1 where it is not."""
    depth = 0
    for match in _BRACKET.finditer(value, opening):
        depth += (match.group() in ("(", "[")) - (match.group() in (")", "]"))
        if depth == 0:
            return match.start() if match.group() == "]" else -1
    return -1


def situation_of(expected: set[str]) -> Situation:
    """The meaning, to a person, of the terminals that lark would have taken."""
    if "LPAR" in expected and "NUMBER" in expected:
        return "value"
    if "OR" in expected or "COMMA" in expected or "LPAR" in expected:
        return "operator"
    return "index"


def find_mistake(situation: Situation, found: str, before: str, touching: bool) -> Mistake:
    """The first entry that fits. ``before`` is the word or sign before the error, empty at the start."""
    for mistake in MISTAKES:
        if (
            mistake.situation == situation
            and (not mistake.found or found in mistake.found)
            and (not mistake.before or re.fullmatch(mistake.before, before))
            and (touching or not mistake.touching)
        ):
            return mistake
    raise AssertionError(situation)  # The last entry of each situation takes anything.


def spelling_at(value: str, start: int, unreadable: bool) -> tuple[int, str] | None:
    """A sign of another language that covers the place of the error, and where it starts.

    A quote counts only if it is ``unreadable``, which means that it has no partner.
    """
    for at in (start, start - 1):
        for width in (2, 1):
            written = value[at : at + width] if at >= 0 else ""
            if written in SPELLINGS and at + len(written) > start and (unreadable or written not in _QUOTES):
                return at, written
    return None


def _explain_spelling(spelling: Spelling, start: int, end: int, mode: Mode, report: Report) -> None:
    message, help, operator = spelling.message, spelling.help, spelling.operator
    if operator:
        message = f"{message}; a formula has `{operator}`"
        help = f"write {operator}"
        if SHIFTS.get(operator, operator) not in OPERATORS[mode]:
            help = f"{operator} works in {INSTRUCTION[OTHER[mode]]} only, not in {INSTRUCTION[mode]}"
    report.add("CG116", start, end, message, help)


def _native_range(value: str, colon: int) -> str:
    """The advice for ``DS1 : DS10``, CLICK's notation for ranges."""
    for match in _NATIVE_RANGE.finditer(value):
        if match.start() <= colon < match.end():
            first, last = parse_address(match.group(1)), parse_address(match.group(2))
            if first and last and first.bank == last.bank:
                return f"write SUM({SPELL.range(first.bank, first.number, last.number)}): {SPELL.range_end}"
    return ""


def _innermost_open(value: str, stop: int) -> int:
    opened: list[int] = []
    for match in _BRACKET.finditer(value, 0, stop):
        if match.group() in "([":
            opened.append(match.start())
        elif match.group() in ")]" and opened:
            opened.pop()
    return opened[-1] if opened else 0


def _printable(text: str) -> str:
    text = text if len(text) <= 40 else f"{text[:37]}..."
    return "".join(character if character.isprintable() else f"U+{ord(character):04X}" for character in text)
