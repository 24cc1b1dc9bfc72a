"""An output coil that two places drive: the last one that runs wins, and the other does nothing."""

from __future__ import annotations

from clickgen.check.facts import Facts, Placed
from clickgen.check.rule import Rule, Wrong
from clickgen.device.banks import Address
from clickgen.diagnostics import Diagnostics, Label
from clickgen.instructions.coils import OUT
from clickgen.ir.operands import Cell, Immediate, Range

CODE = "CG501"


def check(facts: Facts, problems: Diagnostics) -> None:
    driven: dict[Address, Placed] = {}
    for placed in facts.actions:
        if placed.spec is not OUT:
            continue
        for address in _bits(placed):
            earlier = driven.setdefault(address, placed)
            if earlier is not placed and not facts.run_apart(earlier.routine, placed.routine):
                problems.add(
                    CODE,
                    placed.action.span,
                    f"{facts.shown(address)} is driven by out in {earlier.action.span.seen_from(placed.action.span)} "
                    "already: whichever runs last decides, also when it turns the bit off",
                    "join the conditions in one rung with any(...), or use set and reset",
                    (Label(earlier.action.span, "driven here first"),),
                )
                break


def _bits(placed: Placed) -> list[Address]:
    operand = placed.action.args["address"]
    target = operand.target if isinstance(operand, Immediate) else operand
    if isinstance(target, Cell):
        return [target.address]
    return target.addresses() if isinstance(target, Range) else []


RULE = Rule(
    CODE,
    check,
    """
`out` writes its bit in every scan in which its rung is looked at: on when the rung is true and off when it is false.
With two of them the later rung decides alone, and the earlier one does nothing but flicker: a classic reason why a
motor does not start although its rung is green. CLICK warns about it too (C1001).

Subroutines that are never called in the same scan may drive the same bit: their calls must stand on conditions that
exclude each other.
""",
    wrong=(
        Wrong(
            """
if c.Auto:
    out(y.Motor)

if c.Manual:
    out(y.Motor)  # <-
"""
        ),
        Wrong(
            """
if c.Fill:
    out(y[1:5])
    if c.Drain:
        out(y[3])  # <-
"""
        ),
    ),
    right=(
        """
if any(c.Auto, c.Manual):
    out(y.Motor)
""",
        """
if c.Start:
    set(y.Motor)

if c.Stop:
    reset(y.Motor)
""",
        """
def main():
    if ds.Mode == 1:
        call(auto)
    if ds.Mode == 2:
        call(manual)
    if True:
        end()


@sub
def auto():
    if c.Run:
        out(y.Motor)
    if True:
        return


@sub
def manual():
    if c.Jog:
        out(y.Motor)
    if True:
        return
""",
    ),
)
