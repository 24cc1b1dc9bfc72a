"""Replacing the operands inside a formula."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from clickgen.formula.nodes import Binary, Call, Formula, Group, Node, Operand, Unary
from clickgen.ir.operands import Cell, Named, Pointer

Ref = Named | Cell | Pointer


def map_refs(formula: Formula, change: Callable[[Ref], Ref]) -> Formula:
    """The same formula with each single operand replaced by what ``change`` gives for it."""
    return Formula(_map(formula.root, change), formula.mode)


def _map(node: Node, change: Callable[[Ref], Ref]) -> Node:
    if isinstance(node, Operand):
        return replace(node, ref=change(node.ref))
    if isinstance(node, Binary):
        return replace(node, left=_map(node.left, change), right=_map(node.right, change))
    if isinstance(node, Unary):
        return replace(node, operand=_map(node.operand, change))
    if isinstance(node, Call):
        return replace(node, argument=_map(node.argument, change))
    if isinstance(node, Group):
        return replace(node, inner=_map(node.inner, change))
    return node
