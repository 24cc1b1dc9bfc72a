"""The value of a part of a formula, as far as it is known without running it."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping

from clickgen.device.banks import Address
from clickgen.ir.formula_nodes import Binary, Call, Group, HexNumber, Node, Number, Operand, Pi, Unary
from clickgen.ir.operands import Cell

_WORKED_OUT: Mapping[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "AND": lambda one, other: int(one) & int(other),
    "OR": lambda one, other: int(one) | int(other),
}
# click-facts [math.trigonometry]
_CALLS: Mapping[str, Callable[[float], float]] = {"RAD": math.radians, "DEG": math.degrees}


def value_of(node: Node, registers: Mapping[Address, float] | None = None) -> float | None:
    """The value of a part of a formula; None if it depends on a register, or on how CLICK computes it.

    ``registers`` has the registers whose values are taken as known.
    """
    if isinstance(node, Group):
        return value_of(node.inner, registers)
    if isinstance(node, Number | HexNumber):
        return node.value
    if isinstance(node, Pi):
        return math.pi
    if isinstance(node, Operand):
        return (registers or {}).get(node.ref.address) if isinstance(node.ref, Cell) else None
    if isinstance(node, Unary) and node.op == "-":
        value = value_of(node.operand, registers)
        return None if value is None else -value
    if isinstance(node, Call) and node.name in _CALLS:
        value = value_of(node.argument, registers)
        return None if value is None else _finite(lambda: _CALLS[node.name](value))
    if isinstance(node, Binary):
        left, right = value_of(node.left, registers), value_of(node.right, registers)
        if left is None or right is None:
            return None
        if node.op in _WORKED_OUT:
            return _finite(lambda: _WORKED_OUT[node.op](left, right))
        # Nobody knows the sign that CLICK gives the remainder of a negative number.
        if node.op == "MOD" and left >= 0 and right > 0:
            return _finite(lambda: left % right)
    return None


def _finite(work: Callable[[], float]) -> float | None:
    """The result; None if it is too large for any register."""
    try:
        value = work()
        return value if math.isfinite(value) else None
    except OverflowError:
        return None


def register_of(node: Node) -> Cell | None:
    """The register that a part of a formula is, with or without parentheses; None for anything else."""
    if isinstance(node, Group):
        return register_of(node.inner)
    return node.ref if isinstance(node, Operand) and isinstance(node.ref, Cell) else None
