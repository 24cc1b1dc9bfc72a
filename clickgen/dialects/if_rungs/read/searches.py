"""The other form of a search: ``search(ds[1:101] >= 100, result=ds.At, found=c.Found)``."""

from __future__ import annotations

from dataclasses import replace

import libcst as cst

from clickgen.device.banks import Address
from clickgen.dialects.if_rungs.read.conditions import COMPARISONS
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import Node
from clickgen.dialects.if_rungs.read.operands import read_operand
from clickgen.ir.conditions import MIRRORED
from clickgen.ir.operands import WHOLE, Cell, Named, Operand, Range, Section
from clickgen.ir.program import Value, Word

_EXAMPLE = "search(ds[1:101] >= 100, result=ds.At, found=c.Found)"


def read_range_comparison(context: Context, node: Node) -> dict[str, Value] | None:
    """The arguments ``condition``, ``value``, ``start`` and ``end`` that a comparison with a range means."""
    if not isinstance(node, cst.Comparison):
        context.problem("CG115", node, "a search compares a range with a value", _EXAMPLE)
        return None
    if len(node.comparisons) > 1:
        context.problem("CG106", node, "comparisons do not chain", "a search has one comparison")
        return None
    target = node.comparisons[0]
    operator = COMPARISONS.get(target.operator.__class__)
    if operator is None:
        context.problem("CG107", node, "CLICK has no such comparison", f"the comparisons: {' '.join(MIRRORED)}")
        return None
    left, right = read_operand(context, node.left), read_operand(context, target.comparator)
    if left is None or right is None:
        return None
    if _is_section(right) and not _is_section(left):
        left, right, operator = right, left, MIRRORED[operator]
    if isinstance(left, Named) and not isinstance(left.part, int) and not _is_section(right):
        ends = _ends(context, left)
        return ends and {"condition": Word(operator, context.span(node)), "value": right, **ends}
    if not isinstance(left, Range) or _is_section(right):
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


def _is_section(operand: Operand) -> bool:
    """True for a range, be it a part of a block."""
    return isinstance(operand, Range) or (isinstance(operand, Named) and isinstance(operand.part, Section))


def _ends(context: Context, block: Named) -> dict[str, Value] | None:
    """The first and last member of a block or of a section of it; None with a problem."""
    section = block.part if isinstance(block.part, Section) else WHOLE
    first = section.start or 0
    if section.step != 1 or (section.stop is not None and section.stop <= first):
        context.problems.add("CG202", block.span, "a search goes upward through at least one address", _EXAMPLE)
        return None
    last = -1 if section.stop is None else section.stop - 1
    return {"start": replace(block, part=first), "end": replace(block, part=last)}
