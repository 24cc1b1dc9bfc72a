"""Floating-point values compared with == or !=: a calculated number is seldom exactly the expected one."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.device.banks import BANKS, Address, Kind
from clickgen.facts.copied import origin_registers, origins, put_in
from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Shape
from clickgen.ir.conditions import Compare
from clickgen.ir.formula_nodes import Binary, Call, Node, Number, Operand, Pi, Sum, walk
from clickgen.ir.operands import Cell, Integer, Pointer, Real, Single
from clickgen.ir.program import FormulaText
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [value.floats]
CODE = "CG520"

_WHOLE = (Kind.INT16, Kind.INT32, Kind.HEX)


def find(facts: Facts) -> Findings:
    compares = [compare for compare in facts.comparisons if compare.op in ("==", "!=") and _has_float(compare)]
    by_pointer = [placed for placed in facts.actions if _goes_by_pointer(placed)] if compares else []
    for compare in compares:
        sides = ((compare.left, compare.right), (compare.right, compare.left))
        register = next((one for one, other in sides if _is_inexact(facts, by_pointer, one, other)), None)
        if isinstance(register, Cell) and not any(_meets_surely(facts, *pair) for pair in sides):
            name = facts.shown(register.address)
            yield finding(
                CODE,
                compare.span,
                f"{name} is a floating-point number: a measured or calculated value is seldom exactly equal to another",
                _help(facts, compare, register),
            )


def _has_float(compare: Compare) -> bool:
    return any(isinstance(side, Cell) and side.bank == "DF" for side in (compare.left, compare.right))


def _help(facts: Facts, compare: Compare, register: Cell) -> str:
    name = facts.text(register.span)
    above, below = (facts.spell.compared(name, sign, "...") for sign in (">", "<"))
    margin = facts.spell.every(above, below) if compare.op == "==" else facts.spell.some(below, above)
    return f"compare with a margin: {margin}"


def _meets_surely(facts: Facts, one: Single, other: Single) -> bool:
    """True if equality is certain to come: with 0, with a number that is copied in, with a copy of the register."""
    if not isinstance(one, Cell):
        return False
    if isinstance(other, Integer | Real):
        return other.value == 0 or other.value in _given_numbers(facts, one.address)
    if not isinstance(other, Cell):
        return False
    return not origin_registers(facts, one.address).isdisjoint(origin_registers(facts, other.address))


def _given_numbers(facts: Facts, address: Address) -> Iterator[int | float]:
    """The constants that copies put into a register, and the initial values of it and of those that it is a copy of."""
    yield from (put.value for put in origins(facts, address) if isinstance(put, Integer | Real))
    yield from (float(facts.initial(one) or 0) for one in origin_registers(facts, address) if one.bank == "DF")


# -- the origin of a value --------------------------------------------------------------------------------------------


def _is_inexact(facts: Facts, by_pointer: list[Placed], one: Single, other: Single) -> bool:
    """True for a register that may hold a measured or calculated value.

    It does not if only copies write it, and give it constants, a panel's values, or whole numbers. These are no
    use if it is compared with a fraction.
    """
    if not isinstance(one, Cell) or one.bank != "DF":
        return False
    is_fraction = isinstance(other, Real) and not other.value.is_integer()
    seen = {one.address}
    waiting = [one.address]
    while waiting:
        at = waiting.pop()
        for writer in (*facts.writers(at), *by_pointer):
            put = put_in(writer, at)
            if isinstance(put, Cell) and put.bank == "DF":
                if put.address not in seen:
                    seen.add(put.address)
                    waiting.append(put.address)
            elif isinstance(put, Cell | Pointer):
                if is_fraction or BANKS[put.bank].kind not in _WHOLE:
                    return True
            elif put is None and (is_fraction or not _is_whole(writer)):
                return True
    return False


def _goes_by_pointer(placed: Placed) -> bool:
    target = placed.action.moved_to if placed.effects.shape is Shape.VALUE else None
    return isinstance(target, Pointer) and target.bank == "DF"


def _is_whole(writer: Placed) -> bool:
    """True for a formula that adds, subtracts and multiplies whole numbers."""
    formula = writer.action.args.get("formula")
    return isinstance(formula, FormulaText) and all(map(_stays_whole, walk(formula.formula)))


def _stays_whole(node: Node) -> bool:
    if isinstance(node, Number):
        return float(node.value).is_integer()
    if isinstance(node, Operand):
        return BANKS[node.ref.bank].kind in _WHOLE
    if isinstance(node, Sum):
        return BANKS[node.range.bank].kind in _WHOLE
    return not isinstance(node, Pi | Call) and not (isinstance(node, Binary) and node.op not in ("+", "-", "*"))


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "floating-point values are compared for equality",
    """
A floating-point register holds about seven digits, and a measured or calculated value is almost never exactly the
number that is asked for: `df.Level == 2.5` may stay off for ever at 2.4999998, and `!=` is then always on. Ask for a
margin instead: `all(df.Level > 2.49, df.Level < 2.51)`.

Equality is fine, and the rule quiet, with 0, with a number that the program itself copies into the register or declares
as its initial value, and between a register and its copy: that is how a change of a setpoint is found. So it is with
registers that nothing in the program writes, since a panel writes the very number, and with whole numbers in registers
that are copied or added up from whole numbers alone.
""",
    wrong=(
        Wrong(
            """
if True:
    calc("sd[1] * 0.1", df.Level)
if df.Level == 2.5:  # <-
    set(c.Half)
if all(c.Run, df.Level != df.Target):  # <-
    out(y.Pump)
if ds.Percent == df.Level:  # <-
    set(c.Same)
"""
        ),
    ),
    right=(
        """
if True:
    calc("sd[1] * 0.1", df.Level)
if all(df.Level > 2.49, df.Level < 2.51):
    set(c.Half)
if any(df.Level == 0.0, df.Level == 0, df.Level, df.Level >= 2.5):
    set(c.Seen)
""",
        """
if c.Clear:
    copy(-1.0, df.Found)
if x.Measure:
    calc("sd[1] * 0.1", df.Found)
if df.Found != -1.0:
    set(c.Seen)
""",
        """
if df.Setpoint != df.Last:
    copy(df.Setpoint, df.Last)
if any(df[1] != df[11], df[12] == df[2]):
    copy_block(df[1:5], df[11])
if True:
    receive(ModbusTcpTarget(ip="192.168.1.10"), "DF1", df[1:5])
""",
        """
if df.Recipe == 2.5:
    set(c.Fine)
if x.Part:
    calc("ds.Rows * ds.Columns", df.Pieces)
if df.Pieces == 24:
    set(c.Full)
if ds.Percent == 50:
    set(c.Half)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
