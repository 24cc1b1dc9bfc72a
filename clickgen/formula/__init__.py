"""Formulas: reads the strings of ``calc`` and ``math_hex`` and prints them in CLICK's form."""

from clickgen.formula.parse import parse_formula
from clickgen.formula.printer import print_formula, print_source
from clickgen.ir.formula_nodes import (
    Binary,
    Call,
    Formula,
    Group,
    HexNumber,
    Mode,
    Node,
    Number,
    Operand,
    Pi,
    Sum,
    Unary,
    references,
    walk,
)

__all__ = [
    "Binary",
    "Call",
    "Formula",
    "Group",
    "HexNumber",
    "Mode",
    "Node",
    "Number",
    "Operand",
    "Pi",
    "Sum",
    "Unary",
    "parse_formula",
    "print_formula",
    "print_source",
    "references",
    "walk",
]
