"""A formula that divides by 0: by the constant, or by a register that the program gives nothing else."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping

from clickgen.check.facts import Facts, Placed
from clickgen.check.rule import Rule, Wrong
from clickgen.check.uses import Use
from clickgen.diagnostics import Diagnostics
from clickgen.formula.nodes import Binary, Group, HexNumber, Node, Number, Operand, Unary, walk
from clickgen.instructions import maths
from clickgen.instructions.copies import COPY, COPY_FILL
from clickgen.ir.conditions import Compare
from clickgen.ir.logic import are_exclusive
from clickgen.ir.operands import Cell, Hex, Integer, Real
from clickgen.ir.program import FormulaText
from clickgen.source import Span

CODE = "CG517"

_BANKS = ("DS", "DD", "DH", "DF")
"""Banks whose registers hold what the program puts there, and what a panel does."""
_WORKED_OUT: Mapping[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "AND": lambda one, other: int(one) & int(other),
    "OR": lambda one, other: int(one) | int(other),
}


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        formula = placed.action.args.get("formula")
        if placed.spec not in maths.SPECS or not isinstance(formula, FormulaText):
            continue
        for node in walk(formula.formula):
            if isinstance(node, Binary) and node.op in ("/", "MOD"):
                reason, help = _zero(facts, placed, node.right)
                if help:
                    destination = placed.action.args["destination"]
                    name = facts.shown(destination.address) if isinstance(destination, Cell) else "the destination"
                    fault = f"{_happens(node.op)} {name}{reason}"
                    problems.add(CODE, _place(facts, formula, node.right), fault, help)


def _zero(facts: Facts, placed: Placed, divisor: Node) -> tuple[str, str]:
    """Why a divisor is 0, and the way out; nothing where it may be another number."""
    if _value(divisor) == 0:
        return "", "correct the divisor"
    cell = _register(divisor)
    if cell is None or cell.bank not in _BANKS or facts.is_set_up(cell.address):
        return "", ""
    if facts.uses.is_pointed(cell.bank, is_written=True) or _is_tested(placed, cell):
        return "", ""
    writes = facts.uses.writes(cell.address)
    if not all(map(_writes_zero, writes)):
        return "", ""
    said = "nothing but 0" if writes else "nothing"
    return (
        f", unless a panel or another device writes {facts.shown(cell.address)}: the program writes {said} there",
        f"correct the name, declare a value with nickname(..., initial=..., retentive=False), test "
        f"{_shown(facts, cell)} != 0, or write # clickgen: ignore[{CODE}] where a panel or another device writes it",
    )


def _shown(facts: Facts, cell: Cell) -> str:
    """A register as the language writes it."""
    return facts.text(cell.span) or f"{cell.bank.lower()}[{cell.address.number}]"


def _is_tested(placed: Placed, cell: Cell) -> bool:
    """True when the formula only runs while the register is not 0."""
    zero = Hex(0, cell.span) if cell.bank == "DH" else Integer(0, cell.span)
    return are_exclusive(placed.condition, Compare("==", cell, zero, cell.span))


def _writes_zero(use: Use) -> bool:
    """True for an instruction that writes nothing but 0."""
    assert use.action is not None
    formula = use.action.args.get("formula")
    if isinstance(formula, FormulaText):
        return _value(formula.formula.root) == 0
    source = use.action.args.get("source")
    return use.action.spec in (COPY, COPY_FILL) and isinstance(source, Integer | Hex | Real) and source.value == 0


def _register(node: Node) -> Cell | None:
    """The register that a divisor is, in parentheses or with its sign changed; None for anything else."""
    if isinstance(node, Group):
        return _register(node.inner)
    if isinstance(node, Unary) and node.op == "-":
        return _register(node.operand)
    return node.ref if isinstance(node, Operand) and isinstance(node.ref, Cell) else None


def _value(node: Node) -> float | None:
    """What a part of a formula is worth; None where a register decides, or CLICK's way to work it out."""
    if isinstance(node, Group):
        return _value(node.inner)
    if isinstance(node, Number | HexNumber):
        return node.value
    if isinstance(node, Unary) and node.op == "-":
        value = _value(node.operand)
        return None if value is None else -value
    if isinstance(node, Binary) and node.op in _WORKED_OUT:
        left, right = _value(node.left), _value(node.right)
        return None if left is None or right is None else _WORKED_OUT[node.op](left, right)
    return None


def _happens(op: str) -> str:
    # What is known of a division is in click-facts, section 4; of MOD nothing is.
    if op == "MOD":
        return "MOD by 0 has no result: nobody knows what CLICK puts into"
    return "division by 0: CLICK sets SC40 (_Division_Error) and puts 0 into"


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

A divisor is found that is 0 as it is written, and a register that nothing in the program writes, or nothing but 0, and
that begins with 0. A panel or another device may write such a register; until it has, the division is by 0 all the
same. Test it in the rung's condition, `if ds.Count != 0:`, or give it a value to begin with, and the rule is silent. Of
a register that the program does write it says nothing.
""",
    wrong=(
        Wrong(
            """
if True:
    calc("ds.Total / 0", ds.Mean)  # <-
    calc("ds.Total MOD (-0.0) + 1", df.Rest)  # <-
    math_hex("dh.Word / 0x0000", dh.Part)  # <-
    calc("ds.Total / (1 - 1)", ds.Most)  # <-
"""
        ),
        Wrong(
            """
if x.Next:
    calc("ds.Total / ds.Cuont", ds.Mean)  # <-
    calc("ds.Count + 1", ds.Count)
"""
        ),
    ),
    right=(
        """
if ds.Count != 0:
    calc("ds.Total / ds.Count", ds.Mean)
if True:
    calc("0 / df.Parts + ds.Total / 10 - 0", ds.Half)
    calc("sd[9] + 1", df.Parts)
""",
    ),
)
