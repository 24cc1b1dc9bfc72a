"""The words of formulas: which mode has which, and what CLICK calls those it has under another name."""

from __future__ import annotations

from clickgen.formula.nodes import Mode

# click-facts, section 4. SHL, SHR and NOT do not exist on CLICK and are lowered.
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

FOREIGN = {
    "POW": "a power is written x ^ y",
    "POWER": "a power is written x ^ y",
    "EXP": "a power of e is written 2.7182818 ^ x",
    "SQR": "a square is written x ^ 2, a square root SQRT(x)",
    "LOG10": "CLICK's LOG is the logarithm to base 10",
    "ROL": "rotating left is LRO(x, n)",
    "ROR": "rotating right is RRO(x, n)",
    "ABS": "CLICK has no ABS; SQRT(x ^ 2) does the same",
}
"""Functions that other languages have, and the way out."""
