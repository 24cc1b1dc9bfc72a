"""A formula that divides by the constant 0."""

from __future__ import annotations

from clickgen.check.facts import Facts
from clickgen.check.rule import Rule, Wrong
from clickgen.diagnostics import Diagnostics
from clickgen.formula.nodes import Binary, Group, HexNumber, Node, Number, Unary, walk
from clickgen.instructions import maths
from clickgen.ir.operands import Cell
from clickgen.ir.program import FormulaText
from clickgen.source import Span

CODE = "CG517"


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        formula = placed.action.args.get("formula")
        if placed.spec not in maths.SPECS or not isinstance(formula, FormulaText):
            continue
        for node in walk(formula.formula):
            if isinstance(node, Binary) and node.op in ("/", "MOD") and _is_zero(node.right):
                destination = placed.action.args["destination"]
                name = facts.shown(destination.address) if isinstance(destination, Cell) else "the destination"
                problems.add(
                    CODE,
                    _place(facts, formula, node.right),
                    f"{_happens(node.op)} {name}",
                    "correct the divisor",
                )


def _happens(op: str) -> str:
    # What is known of a division is in click-facts, section 4; of MOD nothing is.
    if op == "MOD":
        return "MOD by 0 has no result: nobody knows what CLICK puts into"
    return "division by 0: CLICK sets SC40 (_Division_Error) and puts 0 into"


def _is_zero(node: Node) -> bool:
    if isinstance(node, Group):
        return _is_zero(node.inner)
    if isinstance(node, Unary) and node.op == "-":
        return _is_zero(node.operand)
    return isinstance(node, Number | HexNumber) and node.value == 0


def _place(facts: Facts, formula: FormulaText, node: Node) -> Span:
    """Where a part of the formula stands; the whole formula where its literal is more than quotes around it."""
    span = formula.span
    text = facts.text(span)
    if text[:1] not in ('"', "'") or text[:2] in ('""', "''") or "\\" in text or text.count(text[0]) != 2:
        return span
    return Span(span.path, span.line, span.col + 1 + node.start, span.line, span.col + 1 + node.end)


RULE = Rule(
    CODE,
    check,
    """
CLICK does not stop at a division by zero: it stores 0, sets the system bit SC40 and goes on, so that a speed or a
setpoint is suddenly 0. What `MOD 0` gives is not documented.

Only a divisor that is written as 0 is found. A register may be 0 too, but nobody knows what a panel or another device
writes into it; test it in the rung's condition, `if ds.Count != 0:`, where it may be.
""",
    wrong=(
        Wrong(
            """
if True:
    calc("ds.Total / 0", ds.Mean)  # <-
    calc("ds.Total MOD (-0.0) + 1", df.Rest)  # <-
    math_hex("dh.Word / 0x0000", dh.Part)  # <-
"""
        ),
    ),
    right=(
        """
if ds.Count != 0:
    calc("ds.Total / ds.Count", ds.Mean)
if True:
    calc("0 / ds.Count + ds.Total / 10 - 0", ds.Half)
""",
    ),
)
