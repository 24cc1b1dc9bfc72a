"""Formulas read registers of their own kind: decimal or hexadecimal (click-facts [math.kinds])."""

from __future__ import annotations

from clickgen.device.banks import BANKS, Kind
from clickgen.facts.facts import Facts
from clickgen.facts.refusals import holds_no_number
from clickgen.ir.formula_nodes import Operand as FormulaOperand
from clickgen.ir.formula_nodes import references
from clickgen.ir.operands import Pointer
from clickgen.ir.program import FormulaText
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

_DECIMAL = (Kind.INT16, Kind.INT32, Kind.FLOAT)


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        text = placed.action.args.get("formula")
        if isinstance(text, FormulaText):
            yield from _check(placed.spec.name, text)


def _check(name: str, text: FormulaText) -> Findings:
    is_hex = text.formula.mode == "hex"
    for node in references(text.formula):
        operand = node.ref if isinstance(node, FormulaOperand) else node.range
        kind = BANKS[operand.bank].kind
        if holds_no_number(operand.bank):
            yield finding(
                "CG301",
                operand.span,
                f"a formula cannot read {operand.bank}: it holds {BANKS[operand.bank].title}",
                "pack bits into a DH register, or copy text to a number, in a rung before",
            )
        elif (kind is Kind.HEX) != is_hex:
            kinds = "hexadecimal" if is_hex else "decimal"
            other = "calc" if is_hex else "math_hex"
            way = "copy it to a DH register first" if is_hex else "copy it to a DS register first"
            yield finding(
                "CG309", operand.span, f"{name} is {kinds} and {operand.bank} is not", f"{way}, or use {other}"
            )
        elif operand.bank in ("XD", "YD") and not isinstance(node, FormulaOperand):
            yield finding(
                "CG301", operand.span, f"SUM cannot read {operand.bank} words", "copy them to DH registers first"
            )
        elif isinstance(operand, Pointer) and operand.bank == "TXT":
            yield finding("CG301", operand.span, "a formula cannot read text", "copy it to a number first")


ABOUT = Code(
    "CG309",
    Severity.ERROR,
    "hexadecimal and decimal values are mixed in one formula",
    """
`calc` reads decimal registers, and `math_hex` reads hexadecimal ones. First copy the value to a register
of the right kind.
""",
    wrong=(
        Wrong(
            """
if x[1]:
    calc("ds.Level + dh.Offset", ds.Total)  # <-
""",
        ),
    ),
    right=(
        """
if x[1]:
    calc("ds.Level + ds.Offset", ds.Total)
    math_hex("dh.Word AND 0x00FF", dh.Low)
""",
    ),
)

RULE = Rule(find, (ABOUT,), also=("CG301",), holds_in_parts=True)
