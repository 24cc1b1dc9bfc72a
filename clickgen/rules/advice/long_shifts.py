"""A shift or a rotation by as many bits as a word has, or more."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.facts.formulas import calculations, place_of
from clickgen.formula.values import value_of
from clickgen.ir.formula_nodes import Binary, walk
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [math.shift-counts]
CODE = "CG558"

_BITS = 16
_SHIFTS = ("LSH", "RSH")
_ROTATIONS = ("LRO", "RRO")


def find(facts: Facts) -> Findings:
    for calculation in calculations(facts):
        for node in walk(calculation.formula.formula):
            if isinstance(node, Binary) and node.op in (*_SHIFTS, *_ROTATIONS):
                count = value_of(node.right)
                if count is not None and not 0 <= count < _BITS:
                    place = place_of(facts, calculation.formula, node.right)
                    yield finding(CODE, place, *_fault(node.op, int(count)))


def _fault(op: str, count: int) -> tuple[str, str]:
    what = "shift" if op in _SHIFTS else "rotation"
    if count < 0:
        opposite = {"LSH": "RSH", "RSH": "LSH", "LRO": "RRO", "RRO": "LRO"}[op]
        return f"a {what} by {count} bits is none", f"write {opposite}, and {-count}"
    said = f"a word has {_BITS} bits, and this {what} goes over {count}"
    if op in _SHIFTS:
        return f"{said}: nothing of it is left", "correct the number, or copy 0 where the word is to be emptied"
    return f"{said}: what CLICK does then is not known", f"write {count % _BITS}"


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a shift is longer than the word",
    """
A hexadecimal word has 16 bits. Shifted by 16 or more nothing of it is left, and how CLICK takes such a number, or a
negative one, is not documented. In a hexadecimal formula CLICK reads numbers as hexadecimal: `10h` is 16.
""",
    wrong=(
        Wrong(
            """
if True:
    math_hex("dh.Word SHL 0x10", dh.High)  # <-
    math_hex("RSH(dh.Word, 0x20)", dh.Low)  # <-
    math_hex("LRO(dh.Word, 0x11) OR RRO(dh.Word, 0x10)", dh.Turned)  # <- # <-
"""
        ),
    ),
    right=(
        """
if True:
    math_hex("dh.Word SHL 0x0F", dh.High)
    math_hex("RSH(dh.Word, 0x8) OR LRO(dh.Word, dh.Count)", dh.Low)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
