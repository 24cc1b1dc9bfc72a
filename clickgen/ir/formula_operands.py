"""Replaces the operands inside a formula."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from clickgen.ir.formula_nodes import Binary, Call, Formula, Group, Node, Operand, Sum, Unary
from clickgen.ir.operands import Cell, Named, Pointer, Range

Ref = Named | Cell | Pointer
Span = Range | Named


def map_refs(
    formula: Formula, change: Callable[[Ref], Ref], change_range: Callable[[Span], Span] = lambda span: span
) -> Formula:
    """Return the formula with each operand, and each range of SUM, replaced by ``change`` of it."""
    return Formula(_map(formula.root, change, change_range), formula.mode)


def _map(node: Node, change: Callable[[Ref], Ref], change_range: Callable[[Span], Span]) -> Node:
    if isinstance(node, Operand):
        return replace(node, ref=change(node.ref))
    if isinstance(node, Sum):
        return replace(node, range=change_range(node.range))
    if isinstance(node, Binary):
        return replace(node, left=_map(node.left, change, change_range), right=_map(node.right, change, change_range))
    if isinstance(node, Unary):
        return replace(node, operand=_map(node.operand, change, change_range))
    if isinstance(node, Call):
        return replace(node, argument=_map(node.argument, change, change_range))
    if isinstance(node, Group):
        return replace(node, inner=_map(node.inner, change, change_range))
    return node
