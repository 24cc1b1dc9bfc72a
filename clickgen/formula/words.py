"""The words of formulas: those of each mode, and CLICK's own names for those it calls otherwise."""

from __future__ import annotations

from clickgen.ir.formula_nodes import Mode

# click-facts [math.functions, math.operators]. SHL, SHR and NOT do not exist on CLICK and are lowered.
OPERATORS: dict[Mode, frozenset[str]] = {
    "decimal": frozenset(("+", "-", "*", "/", "^", "MOD")),
    "hex": frozenset(("+", "-", "*", "/", "MOD", "AND", "OR", "XOR", "NOT", "LSH", "RSH", "LRO", "RRO")),
}

FUNCTIONS: dict[Mode, frozenset[str]] = {
    "decimal": frozenset(("SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "LOG", "LN", "SQRT", "RAD", "DEG", "SUM")),
    "hex": frozenset(("SUM",)),
}

ALL_FUNCTIONS = FUNCTIONS["decimal"]

INSTRUCTION: dict[Mode, str] = {"decimal": "calc", "hex": "math_hex"}
OTHER: dict[Mode, Mode] = {"decimal": "hex", "hex": "decimal"}

SHIFTS = {"SHL": "LSH", "SHR": "RSH", "LSH": "LSH", "RSH": "RSH", "LRO": "LRO", "RRO": "RRO"}
"""Every spelling of a shift or a rotation, and CLICK's own."""

TERMINAL = {word: word for word in ("AND", "OR", "XOR", "NOT", "MOD")} | dict.fromkeys(SHIFTS, "SHIFT")
"""The words that are operators, and their terminal in the grammar; any case."""
