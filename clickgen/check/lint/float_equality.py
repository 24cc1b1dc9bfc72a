"""Floating-point values compared with == or !=: what was calculated is seldom exactly the number that is expected."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import cycle

from clickgen.check.facts import Facts
from clickgen.check.rule import Rule, Wrong
from clickgen.check.uses import addresses_of
from clickgen.device.banks import Address
from clickgen.diagnostics import Diagnostics
from clickgen.instructions.copies import COPY, COPY_BLOCK, COPY_FILL
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, Integer, Real, Single
from clickgen.ir.reach import touches

CODE = "CG520"


def check(facts: Facts, problems: Diagnostics) -> None:
    for compare in facts.comparisons:
        if compare.op not in ("==", "!=") or not (_is_float(compare.left) or _is_float(compare.right)):
            continue
        if not _is_exact(facts, compare.left, compare.right) and not _is_exact(facts, compare.right, compare.left):
            register = compare.left if _is_float(compare.left) else compare.right
            assert isinstance(register, Cell)
            name = facts.shown(register.address)
            problems.add(
                CODE,
                compare.span,
                f"{name} is a floating-point number: a measured or calculated value is seldom exactly equal to another",
                _help(facts, compare, register),
            )


def _is_float(operand: Single) -> bool:
    return isinstance(operand, Cell) and operand.bank == "DF"


def _help(facts: Facts, compare: Compare, register: Cell) -> str:
    name = facts.text(register.span)
    margin = f"all({name} > ..., {name} < ...)" if compare.op == "==" else f"any({name} < ..., {name} > ...)"
    return f"compare with a margin: {margin}"


def _is_exact(facts: Facts, one: Single, other: Single) -> bool:
    """True where equality comes for sure: with 0, with a number that is copied in, with a copy of the register."""
    if not isinstance(one, Cell):
        return False
    if isinstance(other, Integer | Real):
        return other.value == 0 or other.value in _copied_numbers(facts, one.address)
    return isinstance(other, Cell) and other.address in _copied_registers(facts, one.address)


def _copied_numbers(facts: Facts, address: Address) -> Iterator[int | float]:
    """The constants that copies put into a register, and what it begins with."""
    sources = [
        writer.action.args.get("source") for writer in facts.writers(address) if writer.spec in (COPY, COPY_FILL)
    ]
    for constant in sources:
        if isinstance(constant, Integer | Real):
            yield constant.value
    yield float(facts.initial(address) or 0)


def _copied_registers(facts: Facts, address: Address) -> Iterator[Address]:
    """The registers that copies put into a register."""
    for writer in facts.writers(address):
        if writer.spec in (COPY, COPY_FILL, COPY_BLOCK):
            read, written = (
                [
                    one
                    for touch in touches(writer.action)
                    if touch.is_written is side
                    for one in addresses_of(touch.operand)
                ]
                for side in (False, True)
            )
            yield from (one for one, other in zip(cycle(read), written, strict=False) if other == address)


RULE = Rule(
    CODE,
    check,
    """
A floating-point register holds about seven digits, and a measured or calculated value is almost never exactly the
number that is asked for: `df.Level == 2.5` may stay off for ever at 2.4999998, and `!=` is then always on. Ask for a
margin instead: `all(df.Level > 2.49, df.Level < 2.51)`.

Equality is fine, and the rule quiet, with 0, with a number that the program itself copies into the register or declares
as its initial value, and between a register and its copy: that is how a change of a setpoint is found.
""",
    wrong=(
        Wrong(
            """
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
if all(df.Level > 2.49, df.Level < 2.51):
    set(c.Half)
if any(df.Level == 0.0, df.Level == 0, df.Level, df.Level >= 2.5):
    set(c.Seen)
""",
        """
if c.Clear:
    copy(-1.0, df.Found)
if df.Found != -1.0:
    set(c.Seen)
if df.Setpoint != df.Last:
    copy(df.Setpoint, df.Last)
if any(df[1] != df[11], df[12] == df[2]):
    copy_block(df[1:5], df[11])
""",
        """
if ds.Percent == 50:
    set(c.Half)
""",
    ),
)
