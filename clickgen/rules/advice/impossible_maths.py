"""A formula that has no result: the root of a negative number, the logarithm of 0, the arc sine of 2."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from clickgen.facts.copied import put_in
from clickgen.facts.facts import Facts
from clickgen.facts.formulas import Calculation, calculations, place_of
from clickgen.formula.values import register_of, value_of
from clickgen.ir.conditions import Compare, Condition
from clickgen.ir.formula_nodes import Binary, Call, Node, walk
from clickgen.ir.operands import Cell, Integer, Real
from clickgen.logic.conditions import are_exclusive, can_hold
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [math.no-value]
CODE = "CG553"


class _Domain(NamedTuple):
    """The values that a function takes: from ``low`` to ``high``, ``low`` itself only if it is not open."""

    words: str
    low: float
    high: float = math.inf
    is_open: bool = False

    def takes(self, value: float) -> bool:
        return self.low <= value <= self.high and not (self.is_open and value == self.low)

    def asks(self, cell: Cell) -> list[Condition]:
        """The conditions on a register for the function to take its value."""
        span = cell.span
        asked: list[Condition] = [Compare(">" if self.is_open else ">=", cell, Integer(int(self.low), span), span)]
        if self.high < math.inf:
            asked.append(Compare("<=", cell, Integer(int(self.high), span), span))
        return asked


_ARC = _Domain("a number from -1 to 1", -1, 1)
_LOG = _Domain("a number above 0", 0, is_open=True)
_DOMAINS: Mapping[str, _Domain] = {
    "SQRT": _Domain("a number that is not negative", 0),
    "LN": _LOG,
    "LOG": _LOG,
    "ASIN": _ARC,
    "ACOS": _ARC,
}


def find(facts: Facts) -> Findings:
    for calculation in calculations(facts):
        for node in walk(calculation.formula.formula):
            if isinstance(node, Call) and node.name in _DOMAINS:
                fault, help = _function(facts, calculation, node.name, node.argument)
                place: Node = node.argument
            elif isinstance(node, Binary) and node.op == "^":
                fault, help = _power(value_of(node.left), value_of(node.right))
                place = node
            else:
                continue
            if fault:
                destination = calculation.destination
                name = facts.shown(destination.address) if destination else "the destination"
                said = f"{fault}: nobody knows what CLICK puts into {name}"
                yield finding(CODE, place_of(facts, calculation.formula, place), said, help)


def _function(facts: Facts, calculation: Calculation, name: str, argument: Node) -> tuple[str, str]:
    domain, value = _DOMAINS[name], value_of(argument)
    takes = f"{name} takes {domain.words}"
    if value is not None:
        return ("", "") if domain.takes(value) else (f"{takes}, and this is {value:g}", "correct the number")
    cell = register_of(argument)
    if cell is None:
        return "", ""
    shown = facts.shown(cell.address)
    condition = calculation.placed.condition
    if can_hold(condition) and are_exclusive(condition, *domain.asks(cell)):
        return f"{takes}, and the condition of this rung holds only while {shown} is none", "reverse the comparison"
    put = _only_put(facts, cell)
    if put and not any(map(domain.takes, put)):
        listed = ", ".join(f"{number:g}" for number in put)
        return f"{takes}, and the program writes nothing but {listed} to {shown}", "correct the number or the formula"
    return "", ""


def _only_put(facts: Facts, cell: Cell) -> list[float]:
    """The numbers that a register gets, if it gets nothing else; none if it may get any."""
    if facts.uses.is_pointed(cell.bank, is_written=True):
        return []
    writers = facts.writers(cell.address)
    put = [put_in(writer, cell.address) for writer in writers]
    numbers = sorted({float(one.value) for one in put if isinstance(one, Integer | Real)})
    return numbers if all(isinstance(one, Integer | Real) for one in put) else []


def _power(base: float | None, exponent: float | None) -> tuple[str, str]:
    if base is None or exponent is None:
        return "", ""
    if base == 0 and exponent < 0:
        return "0 has no negative power", "correct the exponent"
    if base < 0 and exponent != int(exponent):
        return f"{base:g} has no power {exponent:g}", "correct the exponent"
    return "", ""


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a formula has no result",
    """
The square root of a negative number, the logarithm of 0 or less, and the arc sine or arc cosine of more than 1 have no
value. CLICK does not say what it stores then, so a controlled variable may jump to anything. A fault that looks like
this is often a missing pair of parentheses, degrees where radians belong, or a sensor whose zero was taken away twice.

Found are numbers as they are written, a register while the condition of the rung says that it is outside, and one that
gets nothing but such constants. Of a register that can be both the rule says nothing: test it in the condition,
`if df.Pressure >= 0:`.
""",
    wrong=(
        Wrong(
            """
if True:
    calc("SQRT(-1)", df.Flow)  # <-
    calc("LN(0) + df.Offset", df.Level)  # <-
    calc("LOG(1 - 2)", df.Decades)  # <-
    calc("ASIN(2) + ACOS(-1.5)", df.Angle)  # <- # <-
    calc("0 ^ -1", df.Factor)  # <-
"""
        ),
        Wrong(
            """
if df.Pressure < 0:
    calc("SQRT(df.Pressure)", df.Flow)  # <-
if x.Test:
    copy(-4.5, df.Simulated)
if True:
    calc("SQRT(df.Simulated)", df.Root)  # <-
"""
        ),
    ),
    right=(
        """
if df.Pressure >= 0:
    calc("SQRT(df.Pressure)", df.Flow)
if df.Ratio > 0:
    calc("LN(df.Ratio) + LOG(10) + SQRT(0)", df.Level)
    calc("ASIN(0.5) + ACOS(-1) + 2 ^ -1 + (-2) ^ 2", df.Angle)
    calc("df.Raw / 100", df.Ratio)
    calc("SQRT(df.Given)", df.Root)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
