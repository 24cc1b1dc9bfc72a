"""Formulas read registers of their own kind: decimal or hexadecimal (click-facts [math.kinds])."""

from __future__ import annotations

from clickgen.device.banks import BANKS, Kind
from clickgen.facts.facts import Facts
from clickgen.ir.formula_nodes import Operand as FormulaOperand
from clickgen.ir.formula_nodes import references
from clickgen.ir.operands import Pointer
from clickgen.ir.program import FormulaText
from clickgen.problems.diagnostics import Diagnostics

_DECIMAL = (Kind.INT16, Kind.INT32, Kind.FLOAT)


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        text = placed.action.args.get("formula")
        if isinstance(text, FormulaText):
            _check(placed.spec.name, text, problems)


def _check(name: str, text: FormulaText, problems: Diagnostics) -> None:
    is_hex = text.formula.mode == "hex"
    for node in references(text.formula):
        operand = node.ref if isinstance(node, FormulaOperand) else node.range
        kind = BANKS[operand.bank].kind
        if kind in (Kind.BIT, Kind.TEXT):
            problems.add(
                "CG301",
                operand.span,
                f"a formula cannot read {operand.bank}: it holds {BANKS[operand.bank].title}",
                "pack bits into a DH register, or copy text to a number, in a rung before",
            )
        elif (kind is Kind.HEX) != is_hex:
            kinds = "hexadecimal" if is_hex else "decimal"
            other = "calc" if is_hex else "math_hex"
            way = "copy it to a DH register first" if is_hex else "copy it to a DS register first"
            problems.add(
                "CG309", operand.span, f"{name} is {kinds} and {operand.bank} is not", f"{way}, or use {other}"
            )
        elif operand.bank in ("XD", "YD") and not isinstance(node, FormulaOperand):
            problems.add(
                "CG301", operand.span, f"SUM cannot read {operand.bank} words", "copy them to DH registers first"
            )
        elif isinstance(operand, Pointer) and operand.bank == "TXT":
            problems.add("CG301", operand.span, "a formula cannot read text", "copy it to a number first")
