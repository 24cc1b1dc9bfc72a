"""Writes calculations in Python's operators as the text of a formula, and the rung that makes it for a condition."""

from __future__ import annotations

from typing import NamedTuple

import libcst as cst

from clickgen.device.banks import Kind
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    every,
    is_literal,
    keywords,
    whole_number,
)
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, own
from clickgen.formula.words import ALL_FUNCTIONS

_DECIMAL: dict[type[Node], str] = {
    cst.Add: "+",
    cst.Subtract: "-",
    cst.Multiply: "*",
    cst.Divide: "/",
    cst.FloorDivide: "/",
    cst.Modulo: "MOD",
    cst.Power: "^",
}
_HEX: dict[type[Node], str] = {
    cst.Add: "+",
    cst.Subtract: "-",
    cst.Multiply: "*",
    cst.Divide: "/",
    cst.FloorDivide: "/",
    cst.Modulo: "MOD",
    cst.BitAnd: "AND",
    cst.BitOr: "OR",
    cst.BitXor: "XOR",
    cst.LeftShift: "SHL",
    cst.RightShift: "SHR",
}
_BITWISE = (cst.BitAnd, cst.BitOr, cst.BitXor, cst.LeftShift, cst.RightShift)
_WORDS = ("DS", "TD", "SD")
"""The decimal banks with 16 bits: a copy to DH keeps them all."""


class Calculation(NamedTuple):
    """Rungs that calculate, and the register that has the result."""

    rungs: tuple[str, ...]
    result: str


def is_formula(context: Context, text: str, is_hex: bool) -> bool:
    """True for the text of a formula without a fault."""
    from clickgen.formula import parse_formula

    trial = context.of_text(f"{text!r}")
    node = trial.expression()
    if node is None:
        return False
    parsed = parse_formula(trial.embedded(node), "hex" if is_hex else "decimal", trial.problems)
    return parsed is not None and not trial.problems.found


def calculated(context: Context, node: cst.BaseExpression, count: int = 0) -> Calculation | None:
    """The rungs that calculate an expression after ``count`` earlier results. None for what CLICK does not have."""
    banks = [bank for part in every(node) if (bank := bank_of(part)) is not None]
    if not banks or any(bank.is_bit or bank.kind is Kind.TEXT for bank in banks):
        return None
    signs = [part.operator for part in every(node) if isinstance(part, cst.BinaryOperation)]
    is_bitwise = any(isinstance(sign, _BITWISE) for sign in signs) or any(
        isinstance(part, cst.BitInvert) for part in every(node)
    )
    is_hex = is_bitwise or any(bank.kind is Kind.HEX for bank in banks)
    if is_hex and any(bank.kind is not Kind.HEX and bank.name not in _WORDS for bank in banks):
        return None
    writer = _Writer(context, is_hex)
    text = writer.written(node)
    quote = "'" if '"' in text else '"'
    if not text or (quote in text) or not is_formula(context, text, is_hex):
        return None
    is_real = any(bank.kind is Kind.FLOAT for bank in banks) or _is_real(node)
    number = str(count + 1) if count else ""
    result = f"{'dh' if is_hex else 'df' if is_real else 'dd'}.Result{number}"
    action = f"{'math_hex' if is_hex else 'calc'}({quote}{text}{quote}, {result})"
    return Calculation((*writer.copies, f"if True: {action}"), result)


def bit_under_mask(context: Context, node: Node) -> Calculation | None:
    """``dd.A & 0x0001``: math_hex takes no double word, so its bits are copied out."""
    if not isinstance(node, cst.BinaryOperation) or not isinstance(node.operator, cst.BitAnd):
        return None
    word, mask = (node.right, node.left) if is_literal(node.left) else (node.left, node.right)
    bank, text = bank_of(word), own(context, word)
    value = whole_number(mask) or 0
    if bank is None or bank.name != "DD" or not text or not 0 < value < 1 << 32 or value & (value - 1):
        return None
    rung = f"if True: copy_unpack({text}, c[1001:1033])"
    return Calculation((rung,), f"c[{1001 + value.bit_length() - 1}]")


def _is_real(node: Node) -> bool:
    return any(isinstance(part, cst.Float) or called(part).upper() not in ("", "SUM") for part in every(node))


class _Writer:
    def __init__(self, context: Context, is_hex: bool) -> None:
        self._context = context
        self._is_hex = is_hex
        self._signs = _HEX if is_hex else _DECIMAL
        self.copies: list[str] = []

    def written(self, node: cst.BaseExpression) -> str:
        """Return an expression as the text of a formula; "" for one that no formula takes."""
        if isinstance(node, cst.BinaryOperation):
            sign = self._signs.get(node.operator.__class__, "")
            left, right = (self._side(side, node.operator) for side in (node.left, node.right))
            return f"{left} {sign} {right}" if sign and left and right else ""
        if isinstance(node, cst.UnaryOperation):
            signs: dict[type[Node], str] = {cst.Minus: "-", cst.BitInvert: "NOT " if self._is_hex else ""}
            sign = signs.get(node.operator.__class__, "")
            inner = self._side(node.expression, None)
            return f"{sign}{inner}" if sign and inner else ""
        if isinstance(node, cst.Call):
            name = called(node).upper()
            inners = [own(self._context, argument) for argument in arguments(node)]
            is_known = name in ALL_FUNCTIONS and all(inners) and not keywords(node)
            return f"{name}({', '.join(inners)})" if is_known else ""
        if is_literal(node):
            number = whole_number(node)
            return f"0x{number:04X}" if self._is_hex and number is not None else own(self._context, node)
        bank, text = bank_of(node), own(self._context, node)
        if bank is None or not self._is_hex or bank.kind is Kind.HEX:
            return text if bank is not None else ""
        word = f"dh.Word{len(self.copies) + 1 if self.copies else ''}"
        self.copies.append(f"if True: copy({text}, {word})")
        return word

    def _side(self, node: cst.BaseExpression, operator: cst.BaseBinaryOp | None) -> str:
        text = self.written(node)
        is_sum = (
            isinstance(operator, cst.Add)
            and isinstance(node, cst.BinaryOperation)
            and isinstance(node.operator, cst.Add | cst.Subtract)
        )
        is_loose = isinstance(node, cst.BinaryOperation | cst.UnaryOperation) and not is_sum
        return f"({text})" if text and is_loose else text
