"""The other form of a search: ``search(ds[1:101] >= 100, result=ds.At, found=c.Found)``."""

from __future__ import annotations

import ast

from clickgen.device.banks import Address
from clickgen.ir.operands import Cell, Range
from clickgen.ir.program import Value, Word
from clickgen.syntax.conditions import COMPARISONS
from clickgen.syntax.context import Context
from clickgen.syntax.operands import read_operand

_MIRRORED = {"==": "==", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_EXAMPLE = "search(ds[1:101] >= 100, result=ds.At, found=c.Found)"


def read_range_comparison(context: Context, node: ast.expr) -> dict[str, Value] | None:
    """The arguments ``condition``, ``value``, ``start`` and ``end`` that a comparison with a range means."""
    if not isinstance(node, ast.Compare):
        context.problem("CG115", node, "a search compares a range with a value", _EXAMPLE)
        return None
    if len(node.ops) > 1:
        context.problem("CG106", node, "comparisons do not chain", "a search has one comparison")
        return None
    operator = COMPARISONS.get(type(node.ops[0]))
    if operator is None:
        context.problem("CG107", node, "CLICK has no such comparison", f"the comparisons: {' '.join(_MIRRORED)}")
        return None
    left, right = read_operand(context, node.left), read_operand(context, node.comparators[0])
    if left is None or right is None:
        return None
    if isinstance(right, Range) and not isinstance(left, Range):
        left, right, operator = right, left, _MIRRORED[operator]
    if not isinstance(left, Range) or isinstance(right, Range):
        context.problem("CG115", node, "a search compares one range with one value", _EXAMPLE)
        return None
    if left.is_reversed:
        context.problems.add("CG202", left.span, "a search goes upward", "write the slice without :-1")
        return None
    return {
        "condition": Word(operator, context.span(node)),
        "value": right,
        "start": Cell(Address(left.bank, left.first), left.span),
        "end": Cell(Address(left.bank, left.last), left.span),
    }
