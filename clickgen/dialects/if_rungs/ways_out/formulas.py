"""Calculations in Python's signs as the text of a formula, and the rung that makes them for a condition."""

from __future__ import annotations

import ast
from typing import NamedTuple

from clickgen.device.banks import Kind
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, own
from clickgen.formula.words import ALL_FUNCTIONS
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile

_DECIMAL: dict[type[ast.operator], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "/",
    ast.Mod: "MOD",
    ast.Pow: "^",
}
_HEX: dict[type[ast.operator], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "/",
    ast.Mod: "MOD",
    ast.BitAnd: "AND",
    ast.BitOr: "OR",
    ast.BitXor: "XOR",
    ast.LShift: "SHL",
    ast.RShift: "SHR",
}
_BITWISE = (ast.BitAnd, ast.BitOr, ast.BitXor, ast.LShift, ast.RShift)
_WORDS = ("DS", "TD", "SD")
"""The decimal banks with 16 bits: a copy to DH keeps them all."""


class Calculation(NamedTuple):
    """Rungs that calculate, and the register that has the result."""

    rungs: tuple[str, ...]
    result: str


def is_formula(text: str, is_hex: bool) -> bool:
    """True for the text of a formula without a fault."""
    from clickgen.formula import parse_formula

    trial = Context(SourceFile("", f"{text!r}"), Diagnostics())
    node = ast.parse(trial.source.text, mode="eval").body
    assert isinstance(node, ast.Constant)
    parsed = parse_formula(trial.embedded(node), "hex" if is_hex else "decimal", trial.problems)
    return parsed is not None and not trial.problems.found


def calculated(context: Context, node: ast.expr, count: int = 0) -> Calculation | None:
    """The rungs that calculate an expression; ``count`` are results that there are. None for what CLICK has not."""
    banks = [bank for part in ast.walk(node) if isinstance(part, ast.expr) and (bank := bank_of(part)) is not None]
    if not banks or any(bank.is_bit or bank.kind is Kind.TEXT for bank in banks):
        return None
    signs = [part.op for part in ast.walk(node) if isinstance(part, ast.BinOp)]
    is_bitwise = any(isinstance(sign, _BITWISE) for sign in signs) or any(
        isinstance(part, ast.Invert) for part in ast.walk(node)
    )
    is_hex = is_bitwise or any(bank.kind is Kind.HEX for bank in banks)
    if is_hex and any(bank.kind is not Kind.HEX and bank.name not in _WORDS for bank in banks):
        return None
    writer = _Writer(context, is_hex)
    text = writer.written(node)
    quote = "'" if '"' in text else '"'
    if not text or (quote in text) or not is_formula(text, is_hex):
        return None
    is_real = any(bank.kind is Kind.FLOAT for bank in banks) or _is_real(node)
    number = str(count + 1) if count else ""
    result = f"{'dh' if is_hex else 'df' if is_real else 'dd'}.Result{number}"
    action = f"{'math_hex' if is_hex else 'calc'}({quote}{text}{quote}, {result})"
    return Calculation((*writer.copies, f"if True: {action}"), result)


def bit_under_mask(context: Context, node: ast.expr) -> Calculation | None:
    """``dd.A & 0x0001``: a double word has no place in math_hex, and its bits are copied out."""
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.BitAnd):
        return None
    word, mask = (node.right, node.left) if isinstance(node.left, ast.Constant) else (node.left, node.right)
    bank, text = bank_of(word), own(context, word)
    value = mask.value if isinstance(mask, ast.Constant) and type(mask.value) is int else 0
    if bank is None or bank.name != "DD" or not text or not 0 < value < 1 << 32 or value & (value - 1):
        return None
    rung = f"if True: copy_unpack({text}, c[1001:1033])"
    return Calculation((rung,), f"c[{1001 + value.bit_length() - 1}]")


def _is_real(node: ast.expr) -> bool:
    return any(
        (isinstance(part, ast.Constant) and isinstance(part.value, float))
        or (isinstance(part, ast.Call) and isinstance(part.func, ast.Name) and part.func.id.upper() != "SUM")
        for part in ast.walk(node)
    )


class _Writer:
    def __init__(self, context: Context, is_hex: bool) -> None:
        self._context = context
        self._is_hex = is_hex
        self._signs = _HEX if is_hex else _DECIMAL
        self.copies: list[str] = []

    def written(self, node: ast.expr) -> str:
        """An expression as a formula has it; "" for what none takes."""
        if isinstance(node, ast.BinOp):
            sign = self._signs.get(type(node.op), "")
            left, right = (self._side(side, node.op) for side in (node.left, node.right))
            return f"{left} {sign} {right}" if sign and left and right else ""
        if isinstance(node, ast.UnaryOp):
            sign = {ast.USub: "-", ast.Invert: "NOT " if self._is_hex else ""}.get(type(node.op), "")
            inner = self._side(node.operand, None)
            return f"{sign}{inner}" if sign and inner else ""
        if isinstance(node, ast.Call):
            name = node.func.id.upper() if isinstance(node.func, ast.Name) else ""
            inners = [own(self._context, argument) for argument in node.args]
            return f"{name}({', '.join(inners)})" if name in ALL_FUNCTIONS and all(inners) and not node.keywords else ""
        if isinstance(node, ast.Constant):
            number = node.value
            is_hex = self._is_hex and isinstance(number, int) and not isinstance(number, bool)
            return f"0x{number:04X}" if is_hex and isinstance(number, int) else own(self._context, node)
        bank, text = bank_of(node), own(self._context, node)
        if bank is None or not self._is_hex or bank.kind is Kind.HEX:
            return text if bank is not None else ""
        word = f"dh.Word{len(self.copies) + 1 if self.copies else ''}"
        self.copies.append(f"if True: copy({text}, {word})")
        return word

    def _side(self, node: ast.expr, op: ast.operator | None) -> str:
        text = self.written(node)
        is_sum = isinstance(op, ast.Add) and isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)
        return f"({text})" if text and isinstance(node, ast.BinOp | ast.UnaryOp) and not is_sum else text
