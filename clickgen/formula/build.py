"""Turns the rules of ``grammar/formula.lark`` into nodes: one method for each rule, called while lark parses.

Mistakes that are not syntax errors are reported here, all of them; parsing goes on with a ``Told`` in place of the
part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from lark import Token

from clickgen.device.banks import BANKS, FLOAT_MAX, FLOAT_MIN, INTEGER_RANGES, Address, Kind, parse_address
from clickgen.formula import addresses
from clickgen.formula.addresses import Inside, Negative, Reference
from clickgen.formula.report import Report
from clickgen.formula.spelling import SPELL
from clickgen.formula.words import ALL_FUNCTIONS, FUNCTIONS, INSTRUCTION, OPERATORS, OTHER, SHIFTS, TERMINAL
from clickgen.ir.formula_nodes import Binary, Call, Group, HexNumber, Mode, Node, Number, Operand, Pi, Sum, Unary
from clickgen.ir.operands import WHOLE, Named, Range, Section
from clickgen.problems.diagnostics import did_you_mean

# A constant beyond the ranges of DD and DF fits no register.
_LARGEST_INTEGER = INTEGER_RANGES[Kind.INT32][1]
_TEN = SPELL.range("DS", 1, 10)


@dataclass(frozen=True, slots=True)
class Slice:
    """A range on its way into SUM, the only place for one."""

    range: Range | Named
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Told:
    """Placeholder for a part whose mistake has been reported."""

    start: int
    end: int


Part = Node | Slice | Told
"""The result of a rule of the grammar. A formula without mistakes has no Slice or Told left."""


class Builder:
    """The parts of one formula, and how many operands CLICK will count in it."""

    report: Report
    mode: Mode
    operands: list[tuple[int, int]]
    loose: list[Slice]

    def begin(self, report: Report, mode: Mode) -> None:
        """Forget the previous formula."""
        self.report = report
        self.mode = mode
        self.operands = []
        self.loose = []

    def finish(self) -> None:
        """Report ranges that ended up outside SUM."""
        for part in self.loose:
            help = f"SUM({self.report.text.value[part.start : part.end]}) adds it up"
            self.report.add("CG116", part.start, part.end, "a range has a place only in SUM", help)

    # -- operators ------------------------------------------------------------------------------------------------

    def binary(self, parts: Sequence[Any]) -> Part:
        left, token, right = parts
        op = token.value.upper()
        op = SHIFTS.get(op, op)
        self._check_operator(op, token)
        return Binary(op, left, right, left.start, right.end)

    def unary(self, parts: Sequence[Any]) -> Part:
        token, operand = parts
        op = token.value.upper()
        self._check_operator(op, token)
        # CLICK gets 0 - x or x XOR FFFFh: one operand more.
        self.operands.append((token.start_pos, operand.end))
        return Unary(op, operand, token.start_pos, operand.end)

    def plus(self, parts: Sequence[Any]) -> Part:
        part: Part = parts[1]
        return part

    def group(self, parts: Sequence[Any]) -> Part:
        opening, inner, closing = parts
        return Group(inner, opening.start_pos, closing.end_pos)

    # -- functions ------------------------------------------------------------------------------------------------

    def arguments(self, parts: Sequence[Any]) -> list[Part]:
        return list(parts[::2])

    def call(self, parts: Sequence[Any]) -> Part:
        token, _, arguments, closing = parts
        start, end = token.start_pos, closing.end_pos
        name = token.value.upper()
        if token.type == "SHIFT":
            op = SHIFTS[name]
            self._check_operator(op, token)
            if len(arguments) != 2:
                help = f"write {name}(x, n)"
                self.report.add("CG116", start, end, f"{name} takes a value and a number of bits", help)
                return Told(start, end)
            return Binary(op, arguments[0], arguments[1], start, end)
        if name not in FUNCTIONS[self.mode]:
            self._no_function(name, token, arguments)
            return Told(start, end)
        if name == "SUM":
            return self._sum(arguments, start, end)
        if len(arguments) != 1:
            self.report.add("CG116", start, end, f"{name} takes one value", f"write {name}(x)")
            return Told(start, end)
        return Call(name, arguments[0], start, end)

    def _sum(self, arguments: list[Part], start: int, end: int) -> Part:
        only = arguments[0]
        if len(arguments) == 1 and isinstance(only, Slice):
            self.loose.remove(only)
            return Sum(only.range, start, end)
        if len(arguments) == 1 and isinstance(only, Operand) and isinstance(only.ref, Named) and only.ref.part is None:
            return Sum(replace(only.ref, part=WHOLE), start, end)
        if len(arguments) > 1 or not isinstance(only, Told):
            self.report.add("CG116", start, end, "SUM adds up one range", f"SUM({_TEN}) adds up DS1 to DS10")
            self.loose = [part for part in self.loose if part.start < start]
        return Told(start, end)

    def _no_function(self, name: str, token: Token, arguments: Sequence[Part]) -> None:
        found = self.report.foreign(name, (), "")
        message = f"CLICK has no function {token.value}"
        if name in ALL_FUNCTIONS:
            message, help = self._other_mode(name)
        elif found:
            # An argument that is a calculation would need parentheses of its own.
            is_plain = all(isinstance(part, Operand | Number | HexNumber) for part in arguments)
            whole = self.report.text.value
            texts = [whole[part.start : part.end] for part in arguments]
            # The result of a function goes where that of the formula goes only if the function is the whole formula.
            is_whole = whole.lstrip().startswith(token.value) and whole.rstrip().endswith(")") and whole.count("(") == 1
            help = self.report.foreign(name, texts, self.report.target if is_whole else "") if is_plain else found
        else:
            known = sorted(FUNCTIONS[self.mode])
            near = did_you_mean(name, [*known, *ALL_FUNCTIONS, *SHIFTS])
            help = near or f"{INSTRUCTION[self.mode]} has {', '.join(known)}"
        self.report.add("CG117", token.start_pos or 0, token.end_pos or 0, message, help)

    def _check_operator(self, op: str, token: Token) -> None:
        if op not in OPERATORS[self.mode]:
            message, help = self._other_mode(token.value.upper())
            self.report.add("CG117", token.start_pos or 0, token.end_pos or 0, message, help)

    def _other_mode(self, word: str) -> tuple[str, str]:
        here, there = INSTRUCTION[self.mode], INSTRUCTION[OTHER[self.mode]]
        if self.mode == "hex":
            return f"{here} has no {word}", f"calculate this part with {there}; {word} is one of its own"
        return f"{here} has no {word}", f"{word} works on hexadecimal words (dh): use {there}"

    # -- values ---------------------------------------------------------------------------------------------------

    def number(self, parts: Sequence[Any]) -> Part:
        text = parts[0].value
        start, end = parts[0].start_pos, parts[0].end_pos
        self.operands.append((start, end))
        if self.mode == "hex":
            return self._word_in_decimal(text, start, end)
        if text.isdigit():
            value: int | float = int(text)
            if value > _LARGEST_INTEGER:
                help = f"whole numbers go up to {_LARGEST_INTEGER}; for a larger one write {_shorten(text)}.0"
                self.report.add("CG302", start, end, f"{_shorten(text)} does not fit into 32 bits", help)
        else:
            value = float(text)
            if value > FLOAT_MAX or (0 < value < FLOAT_MIN):
                help = f"CLICK's floating-point numbers go from {FLOAT_MIN} to {FLOAT_MAX}"
                self.report.add("CG302", start, end, f"{_shorten(text)} does not fit into a DF register", help)
        return Number(text, value, start, end)

    def _word_in_decimal(self, text: str, start: int, end: int) -> Part:
        if not text.isdigit():
            help = "a hexadecimal formula has whole numbers 0..FFFFh; calculate with fractions in calc"
            self.report.add("CG302", start, end, f"{_shorten(text)} is no whole number", help)
            return Told(start, end)
        value = int(text)
        if value > 0xFFFF:
            self._too_large(text, start, end)
            return Told(start, end)
        number = HexNumber(value, start, end, len(f"{value:X}"))
        if value > 9:
            message = f"{text} is a decimal number, and CLICK will show {number.text}"
            help = f"write 0x{value:X} to say so; 0x{text} is {int(text, 16)}" if len(text) <= 4 else ""
            self.report.add("CG315", start, end, message, help or f"write 0x{value:X} to say so")
        return number

    def hexadecimal(self, parts: Sequence[Any]) -> Part:
        text = parts[0].value
        start, end = parts[0].start_pos, parts[0].end_pos
        self.operands.append((start, end))
        digits = text[2:] if text[:2] in ("0x", "0X") else text[:-1]
        value = int(digits, 16)
        if self.mode == "decimal":
            help = f"write {value}, or calculate with math_hex" if value < 2**31 else "calculate with math_hex"
            self.report.add("CG309", start, end, f"{_shorten(text)} is hexadecimal, and calc is decimal", help)
            return Told(start, end)
        if value > 0xFFFF:
            self._too_large(text, start, end)
            return Told(start, end)
        return HexNumber(value, start, end, min(len(digits), 4))

    def _too_large(self, text: str, start: int, end: int) -> None:
        self.report.add("CG302", start, end, f"{_shorten(text)} does not fit into 16 bits", "the largest is 0xFFFF")

    def word(self, parts: Sequence[Any]) -> Part:
        token = parts[0]
        text, start, end = token.value, token.start_pos, token.end_pos
        name = text.upper()
        if name == "PI":
            self.operands.append((start, end))
            if self.mode == "decimal":
                return Pi(start, end)
            self.report.add("CG117", start, end, *self._other_mode(name))
        elif name in ALL_FUNCTIONS:
            help = f"write SUM({_TEN})" if name == "SUM" else f"write {name}(x)"
            self.report.add("CG116", start, end, f"{name} lacks its value in parentheses", help)
        elif address := parse_address(text):
            message = f"{text} is CLICK's way to write an address"
            self.report.add("CG113", start, end, message, f"write {SPELL.cell(address)}")
        elif name in BANKS:
            help = f"write {SPELL.name(name, 'Name')} or {SPELL.cell(Address(name, BANKS[name].first))}"
            if name == "DH":
                help += "; the hexadecimal number is 0xD"
            self.report.add("CG113", start, end, f"`{text}` lacks a nickname or a number", help)
        else:
            message = f"`{_shorten(text)}` is neither an address nor a number"
            help = f"a nickname follows its bank: {SPELL.name('DS', _shorten(text))}"
            self.report.add("CG113", start, end, message, help)
        return Told(start, end)

    def text(self, parts: Sequence[Any]) -> Part:
        start, end = parts[0].start_pos, parts[0].end_pos
        help = f"a nickname follows its bank: {SPELL.pointer('DS', _shorten(parts[0].value))}"
        self.report.add("CG116", start, end, "text has no place in a formula", help)
        return Told(start, end)

    # -- addresses ------------------------------------------------------------------------------------------------

    def operand(self, parts: Sequence[Any]) -> Part:
        reference: Reference = parts[0]
        ref, start, end = reference.ref, reference.start, reference.end
        self.operands.append((start, end))
        if ref is None:
            return Told(start, end)
        if isinstance(ref, Range) or (isinstance(ref, Named) and isinstance(ref.part, Section)):
            if not self._runs_upwards(ref, start, end):
                return Told(start, end)
            part = Slice(ref, start, end)
            self.loose.append(part)
            return part
        return Operand(ref, start, end)

    def _runs_upwards(self, ref: Range | Named, start: int, end: int) -> bool:
        """True for a range that a formula can add up; any other is told."""
        step = ref.part.step if isinstance(ref, Named) and isinstance(ref.part, Section) else 1
        is_reversed = step < 0 or (isinstance(ref, Range) and ref.is_reversed)
        if step == 1 and not is_reversed:
            return True
        fault = "the range is reversed" if is_reversed else "the range skips addresses"
        way = f"a formula adds up consecutive addresses from the lowest upwards: {SPELL.range('DS', 1, 10)}"
        self.report.add("CG202", start, end, fault, way)
        return False

    def named(self, parts: Sequence[Any]) -> Reference:
        return addresses.named(parts[0], parts[1], self.report)

    def member(self, parts: Sequence[Any]) -> Reference:
        word, member, _, index, closing = parts
        return addresses.member(word, member, index, closing, self.report)

    def section(self, parts: Sequence[Any]) -> Reference:
        word, member, _, first, _, stop, _, step, closing = parts
        return addresses.member(word, member, (first, stop, step), closing, self.report)

    def indexed(self, parts: Sequence[Any]) -> Reference:
        return addresses.indexed(parts[0], parts[2], parts[3], self.report)

    def slice(self, parts: Sequence[Any]) -> Reference:
        word, _, first, _, stop, _, step, closing = parts
        return addresses.indexed(word, (first, stop, step), closing, self.report)

    def negative(self, parts: Sequence[Any]) -> Inside:
        sign, number = parts
        if not number.value.isdigit():
            return Token.new_borrow_pos("NUMBER", f"-{number.value}", number)
        return Negative(-int(number.value), sign.start_pos, number.end_pos)


def tell_word(token: Token) -> Token:
    """Give a word that is an operator its own terminal."""
    token.type = TERMINAL.get(token.value.upper(), "WORD")
    return token


def _shorten(text: str) -> str:
    return text if len(text) <= 40 else f"{text[:37]}..."
