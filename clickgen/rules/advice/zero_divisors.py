"""A formula that divides by 0: by the constant, or by a register that the program never gives anything else."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.facts.formulas import Calculation, calculations, holds_only_zero, place_of, shown_register
from clickgen.formula.values import register_of, value_of
from clickgen.ir.formula_nodes import Binary, Group, Node, Unary, walk
from clickgen.ir.operands import Cell
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG517"


def find(facts: Facts) -> Findings:
    for calculation in calculations(facts):
        for node in walk(calculation.formula.formula):
            if isinstance(node, Binary) and node.op in ("/", "MOD"):
                reason, help = _zero(facts, calculation, node.right)
                if help:
                    destination = calculation.destination
                    name = facts.shown(destination.address) if destination else "the destination"
                    fault = f"{_happens(node.op)} {name}{reason}"
                    yield finding(CODE, place_of(facts, calculation.formula, node.right), fault, help)


def _zero(facts: Facts, calculation: Calculation, divisor: Node) -> tuple[str, str]:
    """The reason why a divisor is 0, and the way out; nothing if it may be another number."""
    if value_of(divisor) == 0:
        return "", "correct the divisor"
    cell = _register(divisor)
    said = holds_only_zero(facts, calculation.placed, cell) if cell else ""
    if cell is None or not said:
        return "", ""
    declared = facts.spell.declaration("...", initial="...", retentive="False")
    return (
        f", unless a panel or another device writes {facts.shown(cell.address)}: the program writes {said} there",
        f"correct the name, declare a value with {declared}, test "
        f"{facts.spell.compared(shown_register(facts, cell), '!=', '0')}, or write {facts.spell.ignore(CODE)} where a "
        "panel or another device writes it",
    )


def _register(node: Node) -> Cell | None:
    """The register that a divisor is, in parentheses or with its sign changed; None for anything else."""
    while isinstance(node, Group) or (isinstance(node, Unary) and node.op == "-"):
        node = node.inner if isinstance(node, Group) else node.operand
    return register_of(node)


def _happens(op: str) -> str:
    # click-facts [math.division, math.mod-sign]
    if op == "MOD":
        return "MOD by 0 has no result: nobody knows what CLICK puts into"
    return "division by 0: CLICK sets SC40 (_Division_Error) and puts 0 into"


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a formula divides by zero",
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

RULE = Rule(find, (ABOUT,))
