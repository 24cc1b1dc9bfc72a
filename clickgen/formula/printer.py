"""A formula in CLICK's native form: one space between all tokens (click-facts [math.spaces]).

It prints the formula as written, parentheses included. Parentheses are added where a lowering needs them (``NOT x`` is
``x XOR FFFFh``, ``-x`` is ``0 - x``; click-facts [math.unary-minus]) and between operators whose order on CLICK is
unknown, so that CLICK computes what the source means.
"""

from __future__ import annotations

from collections.abc import Callable

from clickgen.formula.spelling import SPELL
from clickgen.formula.words import SHIFTS
from clickgen.ir.formula_nodes import (
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
)
from clickgen.ir.operands import Cell, Named, Pointer, Range

OperandText = Callable[[Named | Cell | Pointer | Range], str]

_CALLS = frozenset(SHIFTS.values())

# Usual maths, which CLICK is assumed to follow: (operator, operator inside it) needs no parentheses on the left or on
# the right. No source says how CLICK groups MOD, or AND, OR, XOR among themselves, or several ^ in a row
# (click-facts [math.grouping]).
_LEFT = {
    "+": frozenset("+-*/^"),
    "-": frozenset("+-*/^"),
    "*": frozenset("*/^"),
    "/": frozenset("*/^"),
    "AND": frozenset(("AND",)),
    "OR": frozenset(("OR",)),
    "XOR": frozenset(("XOR",)),
}
_RIGHT = {"+": frozenset("*/^"), "-": frozenset("*/^"), "*": frozenset("^"), "/": frozenset("^")}
_NONE: frozenset[str] = frozenset()


def print_formula(formula: Formula, operand_text: OperandText) -> str:
    """Return the formula in CLICK's form. ``operand_text`` gives ``DS5`` for a cell and ``DS1 : DS10`` for a range."""
    return _print(formula.root, formula.mode, operand_text)


def _print(node: Node, mode: Mode, operand_text: OperandText) -> str:
    """Return one node by itself: at the top or between parentheses."""
    if isinstance(node, Operand):
        return operand_text(node.ref)
    if isinstance(node, Number):
        return number_text(node)
    if isinstance(node, HexNumber):
        return node.text
    if isinstance(node, Pi):
        return "PI"
    if isinstance(node, Group):
        return f"( {_print(node.inner, mode, operand_text)} )"
    if isinstance(node, Call):
        return f"{node.name} ( {_print(node.argument, mode, operand_text)} )"
    if isinstance(node, Sum):
        return f"SUM ( {operand_text(node.range)} )"
    if isinstance(node, Unary):
        if node.op == "-":
            zero = "0h" if mode == "hex" else "0"
            return f"{zero} - {_inside(node.operand, _RIGHT['-'], mode, operand_text)}"
        return f"{_inside(node.operand, _NONE, mode, operand_text)} XOR FFFFh"
    if node.op in _CALLS:
        left, right = _print(node.left, mode, operand_text), _print(node.right, mode, operand_text)
        return f"{node.op} ( {left} , {right} )"
    left = _inside(node.left, _LEFT.get(node.op, _NONE), mode, operand_text)
    right = _inside(node.right, _RIGHT.get(node.op, _NONE), mode, operand_text)
    return f"{left} {node.op} {right}"


def _inside(node: Node, bare: frozenset[str], mode: Mode, operand_text: OperandText) -> str:
    """Return one node beside an operator, in parentheses unless its own operator is one of ``bare``."""
    text = _print(node, mode, operand_text)
    if isinstance(node, Unary) or (isinstance(node, Binary) and node.op not in _CALLS and node.op not in bare):
        return f"( {text} )"
    return text


def number_text(number: Number) -> str:
    """Return the number as written, with a digit on both sides of the point and without an exponent."""
    text = number.text
    if "e" in text or "E" in text:
        from decimal import Decimal

        text = format(Decimal(repr(float(number.value))), "f")
        return text if "." in text else f"{text}.0"
    if text.startswith("."):
        text = f"0{text}"
    return f"{text}0" if text.endswith(".") else text


def print_source(formula: Formula) -> str:
    """Return the formula as a program would hold it; reading it gives the same formula again."""
    return _source(formula.root)


def _source(node: Node) -> str:
    if isinstance(node, Operand):
        return SPELL.reference(node.ref)
    if isinstance(node, Number):
        return node.text
    if isinstance(node, HexNumber):
        return f"0x{node.value:0{node.digits}X}"
    if isinstance(node, Pi):
        return "PI"
    if isinstance(node, Group):
        return f"({_source(node.inner)})"
    if isinstance(node, Call):
        return f"{node.name}({_source(node.argument)})"
    if isinstance(node, Sum):
        return f"SUM({SPELL.reference(node.range)})"
    if isinstance(node, Unary):
        return f"{node.op}{' ' if node.op == 'NOT' else ''}{_source(node.operand)}"
    if node.op in _CALLS:
        return f"{node.op}({_source(node.left)}, {_source(node.right)})"
    return f"{_source(node.left)} {node.op} {_source(node.right)}"
