"""Formulas by property: reading a printed one gives it back, CLICK computes what was meant, nothing raises.

CLICK's grouping is known only where usual maths settles it, so the reader of CLICK's form below runs with several
grammars that agree only on usual maths: the printed formula must mean the same to all of them.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, fields, is_dataclass
from decimal import Decimal
from typing import Any

import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st

from clickgen.device.banks import Address
from clickgen.formula import (
    Binary,
    Call,
    Formula,
    Group,
    HexNumber,
    Mode,
    Node,
    Number,
    Operand,
    Pi,
    Sum,
    Unary,
    parse_formula,
    print_formula,
    print_source,
)
from clickgen.ir.operands import Cell, Named, Pointer, Range
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile, Span, embedded_text

NOWHERE = Span("", 0, 0, 0, 0)
SHIFTS = ("LSH", "RSH", "LRO", "RRO")
FUNCTIONS = ("SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "LOG", "LN", "SQRT", "RAD", "DEG")
LEVEL = {"OR": 1, "XOR": 2, "AND": 3, "+": 4, "-": 4, "*": 5, "/": 5, "MOD": 5, "^": 7}


def parse(text: str, mode: Mode, problems: Diagnostics | None = None) -> Formula | None:
    raw = repr(text)
    embedded = embedded_text(SourceFile("prog.py", raw), [(raw, 1, 1)], text)
    return parse_formula(embedded, mode, problems if problems is not None else Diagnostics())


# -- random trees, as a person could write them -----------------------------------------------------------------------


def level(node: Node) -> int:
    """How tightly the source form of a node holds together."""
    if isinstance(node, Binary):
        return LEVEL.get(node.op, 9)
    return 6 if isinstance(node, Unary) else 9


def grouped(node: Node, wanted: int) -> Node:
    return node if level(node) >= wanted else Group(node, 0, 0)


def binary(op: str, left: Node, right: Node) -> Node:
    if op in SHIFTS:
        return Binary(op, left, right, 0, 0)
    own = LEVEL[op]
    # Only ^ groups from the right; its exponent may carry a sign.
    lowest_left, lowest_right = (8, 6) if op == "^" else (own, own + 1)
    return Binary(op, grouped(left, lowest_left), grouped(right, lowest_right), 0, 0)


identifiers = st.from_regex(r"[A-Za-z][A-Za-z0-9_]{0,8}", fullmatch=True)
any_names = st.text("abcXYZ 019()_%", min_size=1, max_size=10).filter(lambda name: name.strip() not in ("", "0u", "0U"))
banks = st.sampled_from(("DS", "DD", "DH", "DF", "TD"))
registers: st.SearchStrategy[Named | Cell] = st.one_of(
    st.builds(lambda name: Named("DS", name, NOWHERE), identifiers),
    st.builds(lambda number: Cell(Address("DS", number), NOWHERE), st.integers(1, 4500)),
)
refs: st.SearchStrategy[Named | Cell | Pointer] = st.one_of(
    st.builds(lambda bank, name: Named(bank, name, NOWHERE), banks, identifiers | any_names),
    st.builds(lambda bank, number: Cell(Address(bank, number), NOWHERE), banks, st.integers(1, 500)),
    st.just(Cell(Address("XD", 0, True), NOWHERE)),
    st.builds(lambda bank, register: Pointer(bank, register, NOWHERE), banks, registers),
)
ranges = st.builds(
    lambda bank, first, more: Range(bank, first, first + more, NOWHERE), banks, st.integers(1, 400), st.integers(0, 99)
)
number_texts = st.one_of(
    st.integers(0, 99999).map(str),
    st.from_regex(r"\A(?:[0-9]{1,4}\.[0-9]{0,4}|\.[0-9]{1,4})(?:[eE][+-]?[0-9]{1,2})?\Z").filter(
        lambda text: float(text) == 0 or 1e-30 < float(text) < 1e30
    ),
)


def number(text: str) -> Node:
    return Number(text, int(text) if text.isdigit() else float(text), 0, 0)


leaves: st.SearchStrategy[Node] = st.one_of(
    st.builds(lambda ref: Operand(ref, 0, 0), refs), st.builds(lambda range_: Sum(range_, 0, 0), ranges)
)
decimal_leaves: st.SearchStrategy[Node] = st.one_of(leaves, number_texts.map(number), st.just(Pi(0, 0)))
hex_leaves: st.SearchStrategy[Node] = st.one_of(
    leaves,
    st.builds(
        lambda value, digits: HexNumber(value, 0, 0, max(digits, len(f"{value:X}"))),
        st.integers(0, 0xFFFF),
        st.integers(1, 4),
    ),
)
decimal_trees = st.recursive(
    decimal_leaves,
    lambda parts: st.one_of(
        st.builds(binary, st.sampled_from(("+", "-", "*", "/", "^", "MOD")), parts, parts),
        st.builds(lambda part: Unary("-", grouped(part, 6), 0, 0), parts),
        st.builds(lambda name, part: Call(name, part, 0, 0), st.sampled_from(FUNCTIONS), parts),
        st.builds(lambda part: Group(part, 0, 0), parts),
    ),
    max_leaves=12,
)
hex_trees = st.recursive(
    hex_leaves,
    lambda parts: st.one_of(
        st.builds(binary, st.sampled_from(("+", "-", "*", "/", "MOD", "AND", "OR", "XOR", *SHIFTS)), parts, parts),
        st.builds(lambda op, part: Unary(op, grouped(part, 6), 0, 0), st.sampled_from(("-", "NOT")), parts),
        st.builds(lambda part: Group(part, 0, 0), parts),
    ),
    max_leaves=12,
)
formulas = st.one_of(
    st.builds(lambda root: Formula(root, "decimal"), decimal_trees),
    st.builds(lambda root: Formula(root, "hex"), hex_trees),
)


def without_places(thing: Any) -> Any:
    """A tree as plain tuples, offsets and spans left out."""
    if is_dataclass(thing):
        kept = (field.name for field in fields(thing) if field.name not in ("start", "end", "span"))
        return (type(thing).__name__, *(without_places(getattr(thing, name)) for name in kept))
    return thing


@examples(100)
@given(formulas)
def test_reading_the_printed_source_gives_it_back(formula: Formula) -> None:
    problems = Diagnostics()
    again = parse(print_source(formula), formula.mode, problems)
    if again is None:  # Only the limits may refuse it.
        assert {problem.code for problem in problems.found} <= {"CG310", "CG311"}
    else:
        assert without_places(again) == without_places(formula)
        assert print_formula(again, native) == print_formula(formula, native)


# -- meaning ----------------------------------------------------------------------------------------------------------

P = 1_000_003
"""Decimal formulas are evaluated modulo a prime: every operation is defined and the order of operations shows."""


def scrambled(*parts: object) -> int:
    """A number that depends on everything in ``parts``, the same in every run."""
    value = 17
    for character in repr(parts):
        value = (value * 31 + ord(character)) % P
    return value


def apply(op: str, left: int, right: int, mode: Mode) -> int:
    if mode == "hex":
        results: dict[str, Callable[[], int]] = {
            "+": lambda: left + right,
            "-": lambda: left - right,
            "*": lambda: left * right,
            "/": lambda: left // right if right else 0,
            "MOD": lambda: left % right if right else 0,
            "AND": lambda: left & right,
            "OR": lambda: left | right,
            "XOR": lambda: left ^ right,
            "LSH": lambda: left << right % 16,
            "RSH": lambda: left >> right % 16,
            "LRO": lambda: (left << right % 16) | (left >> 16 - right % 16),
            "RRO": lambda: (left >> right % 16) | (left << 16 - right % 16),
        }
        return results[op]() & 0xFFFF
    if op == "+":
        return (left + right) % P
    if op == "-":
        return (left - right) % P
    if op == "*":
        return left * right % P
    if op == "/":
        return left * pow(right, -1, P) % P if right else 0
    return scrambled(op, left, right)


def native(ref: Named | Cell | Pointer | Range) -> str:
    """One token for any operand: the reader of CLICK's form below need not know addresses."""
    if isinstance(ref, Range):
        return f"{ref.bank}{ref.first} : {ref.bank}{ref.last}"
    return "V" + format(scrambled(without_places(ref)), "d")


def operand(text: str, mode: Mode) -> int:
    return scrambled(text) % (65536 if mode == "hex" else P)


def value_of(text: str) -> int:
    """A decimal number, exactly, as a number modulo P."""
    numerator, denominator = Decimal(text).as_integer_ratio()
    return numerator * pow(denominator, -1, P) % P


def meaning(node: Node, mode: Mode) -> int:
    """The value by the source."""
    if isinstance(node, Number):
        exponent = "e" in node.text.lower()
        return value_of(repr(float(node.text)) if exponent else node.text)
    if isinstance(node, HexNumber):
        return node.value
    if isinstance(node, Pi):
        return operand("PI", mode)
    if isinstance(node, Operand):
        return operand(native(node.ref), mode)
    if isinstance(node, Sum):
        return operand(native(node.range), mode)
    if isinstance(node, Group):
        return meaning(node.inner, mode)
    if isinstance(node, Call):
        return scrambled(node.name, meaning(node.argument, mode))
    if isinstance(node, Unary):
        inner = meaning(node.operand, mode)
        if node.op == "NOT":
            return ~inner & 0xFFFF
        return -inner % (65536 if mode == "hex" else P)
    return apply(node.op, meaning(node.left, mode), meaning(node.right, mode), mode)


@dataclass(frozen=True)
class Rules:
    """One way CLICK could group operators."""

    levels: dict[str, int]
    power_from_the_right: bool = False
    others_from_the_right: bool = False


MATHS = {"+": 10, "-": 10, "*": 20, "/": 20, "^": 30}
CLICKS = (
    Rules(MATHS | {"OR": 1, "XOR": 2, "AND": 3, "MOD": 20}, power_from_the_right=True),
    Rules(MATHS | {"OR": 5, "XOR": 5, "AND": 5, "MOD": 5}, others_from_the_right=True),
    Rules(MATHS | {"OR": 40, "XOR": 41, "AND": 42, "MOD": 43}),
    Rules(MATHS | {"OR": 12, "XOR": 11, "AND": 10, "MOD": 15}, others_from_the_right=True),
    Rules(MATHS | {"OR": 9, "XOR": 25, "AND": 2, "MOD": 22}, power_from_the_right=True),
)


class ClickReader:
    """A small evaluator of CLICK's form. Tokens are one space apart."""

    def __init__(self, text: str, mode: Mode, rules: Rules) -> None:
        self.tokens = text.split(" ")
        self.mode = mode
        self.rules = rules

    def evaluate(self) -> int:
        value = self.expression(0)
        assert not self.tokens
        return value

    def take(self, wanted: str = "") -> str:
        token = self.tokens.pop(0)
        assert token
        assert wanted in ("", token)
        return token

    def expression(self, lowest: int) -> int:
        left = self.value()
        while self.tokens and self.tokens[0] in self.rules.levels and self.rules.levels[self.tokens[0]] >= lowest:
            op = self.take()
            if op == "^":
                from_the_right = self.rules.power_from_the_right
            else:
                from_the_right = self.rules.others_from_the_right and op not in MATHS
            right = self.expression(self.rules.levels[op] + (0 if from_the_right else 1))
            left = apply(op, left, right, self.mode)
        return left

    def value(self) -> int:
        token = self.take()
        if token == "(":
            inner = self.expression(0)
            self.take(")")
            return inner
        if token == "SUM":
            self.take("(")
            text = " ".join(self.take() for _ in range(3))
            self.take(")")
            return operand(text, self.mode)
        if token in SHIFTS:
            self.take("(")
            left = self.expression(0)
            self.take(",")
            right = self.expression(0)
            self.take(")")
            return apply(token, left, right, self.mode)
        if token in FUNCTIONS:
            self.take("(")
            argument = self.expression(0)
            self.take(")")
            return scrambled(token, argument)
        if token.startswith("V") or token == "PI":
            return operand(token, self.mode)
        if self.mode == "hex":
            assert re.fullmatch(r"[0-9A-F]{1,4}h", token)
            return int(token[:-1], 16)
        assert re.fullmatch(r"[0-9]+(\.[0-9]+)?", token)
        return value_of(token)


@examples(100)
@given(formulas)
def test_click_computes_what_the_source_means(formula: Formula) -> None:
    printed = print_formula(formula, native)
    expected = meaning(formula.root, formula.mode)
    for rules in CLICKS:
        assert ClickReader(printed, formula.mode, rules).evaluate() == expected, printed


OPERATORS: dict[Mode, tuple[str, ...]] = {
    "decimal": ("+", "-", "*", "/", "^", "MOD"),
    "hex": ("+", "-", "*", "/", "MOD", "AND", "OR", "XOR", *SHIFTS),
}


@pytest.mark.parametrize("mode", OPERATORS)
def test_every_pair_of_operators(mode: Mode) -> None:
    a, b, c = (Operand(Cell(Address("DS", number), NOWHERE), 0, 0) for number in (11, 22, 33))
    signs: tuple[str, ...] = ("-", "NOT") if mode == "hex" else ("-",)
    for outer in OPERATORS[mode]:
        for inner in OPERATORS[mode]:
            roots = [binary(outer, binary(inner, a, b), c), binary(outer, a, binary(inner, b, c))]
            for sign in signs:
                negated = Unary(sign, b, 0, 0)  # type: ignore[arg-type]
                roots += [binary(outer, binary(inner, negated, a), c), binary(outer, a, binary(inner, c, negated))]
                roots.append(binary(outer, Unary(sign, grouped(binary(inner, a, b), 6), 0, 0), c))  # type: ignore[arg-type]
            for root in roots:
                formula = Formula(root, mode)
                again = parse(print_source(formula), mode)
                assert without_places(again) == without_places(formula)
                printed = print_formula(formula, native)
                for rules in CLICKS:
                    assert ClickReader(printed, mode, rules).evaluate() == meaning(root, mode), printed


# -- nothing raises ---------------------------------------------------------------------------------------------------

SCRAPS = """
ds dh x xd DS5 .Name [ ] [5] [ds.I] [1:9] : ( ) , + - * / ^ ** // % & | ~ << >> = == != MOD AND OR XOR NOT SHL LSH RRO
SIN SUM PI foo 5 1.5 1e3 .5 1e99 0xFF 00FFh FFh dh. 0x _ ' " 'a' "0u" # $ { } @ \\ ² ä
"""
scraps = st.lists(st.sampled_from((*SCRAPS.split(), " ", "\n", "\t")), max_size=14).map("".join)


@examples(150)
@given(scraps | st.text(max_size=40), st.sampled_from(("decimal", "hex")))
def test_any_text_is_read_or_told(text: str, mode: Mode) -> None:
    problems = Diagnostics()
    formula = parse(text, mode, problems)
    assert (formula is None) == problems.has_errors
    for problem in problems.found:
        assert problem.message
        assert problem.span is not None
    if formula is not None:
        again = parse(print_source(formula), mode)
        assert again is not None
        assert without_places(again) == without_places(formula)


@pytest.mark.parametrize("mode", ["decimal", "hex"])
def test_a_mistake_leaves_nothing_behind(mode: Mode) -> None:
    assert parse("di.A + ds[1:5] + (", mode) is None
    problems = Diagnostics()
    assert parse("ds.A", mode, problems) is not None
    assert problems.found == []
