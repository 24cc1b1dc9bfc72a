"""A pointer that is still 0 when it is first used: the program only counts it on, and nothing gives it a beginning."""

from __future__ import annotations

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.written import Asked, is_relative, left_in, whole_condition
from clickgen.instructions.raw import RAW
from clickgen.ir.operands import Cell, Pointer
from clickgen.ir.reach import touches
from clickgen.logic.conditions import can_hold, implies
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.rules.rule import Rule, Wrong

# click-facts [copy.wild-pointer, scan.power-up]
CODE = "CG554"


def check(facts: Facts, problems: Diagnostics) -> None:
    moved: dict[Address, tuple[Placed, ...]] = {}
    said: set[Address] = set()
    places = facts.places
    for placed in facts.actions:
        if placed.spec is RAW or placed.loop is not None:
            continue
        for touch in touches(placed.action):
            pointer = touch.operand
            if not isinstance(pointer, Pointer) or not isinstance(pointer.register, Cell):
                continue
            address = pointer.register.address
            if BANKS[pointer.bank].has(0) or address in said:
                continue
            if address not in moved:
                moved[address] = _movers(facts, address)
            # Another routine may run before this one.
            before = [
                one
                for one in moved[address]
                if one.routine is not placed.routine or places[id(one.action)] < places[id(placed.action)]
            ]
            if not moved[address] or not _may_find_zero(facts, placed, address, before):
                continue
            said.add(address)
            name = facts.text(pointer.register.span)
            problems.add(
                CODE,
                pointer.span,
                f"{facts.shown(address)} begins with 0 on a new PLC and is only counted on, and there is no "
                f"{pointer.bank}0: the first time CLICK skips this and sets SC44 (_Address_Error)",
                f"give it the number of the first cell in a rung above: if {name} == 0:, and in it copy(101, {name}) "
                f"for {pointer.bank}101",
                (Label(moved[address][0].action.span, "nothing but this gives it another number"),),
            )


def _movers(facts: Facts, address: Address) -> tuple[Placed, ...]:
    """What makes another number of a register that holds 0; none where anything else may do so, or 0 is not there."""
    if facts.initial(address) not in ("", "0"):
        return ()
    movers: list[Placed] = []
    for writer in facts.writers(address):
        if not Asked(facts, writer, address).may_be(0):
            continue
        left = left_in(writer, address, 0)
        if left is None or (left != 0 and not is_relative(writer, address)):
            return ()
        if left != 0:
            movers.append(writer)
    return tuple(movers)


def _may_find_zero(facts: Facts, use: Placed, address: Address, before: list[Placed]) -> bool:
    """True when the use runs while the register is 0, and none of these surely runs before it in the same scan."""
    whole = whole_condition(facts, use)
    if not can_hold(whole) or not Asked(facts, use, address).may_be(0):
        return False
    for mover in before:
        is_once = mover.action.flag("oneshot") and not use.action.flag("oneshot")
        if mover.loop is not None or (not is_once and implies(whole, mover.condition)):
            return False
    return True


RULE = Rule(
    CODE,
    check,
    """
A register that nothing has written holds 0 on a new PLC. As a pointer it leads nowhere: CLICK skips the copy and sets
SC44, so that the first entry of a log is lost, and nobody knows why there is one less.

The rule speaks where the program only counts the register on from its own value, or clears it, and the pointer may be
used before. It is silent where anything else gives the register a number, where the rung asks for a number that is not
0, and where the register begins with one that CLICK does not mask (`initial=101, retentive=False`). A register that
nothing in the program moves is a panel's.
""",
    wrong=(
        Wrong(
            """
if re(x.Sample):
    copy(ds.Weight, dd[ds.Row])  # <-
    calc("ds.Row + 1", ds.Row)
if ds.Row > 50:
    copy(1, ds.Row)
"""
        ),
        Wrong(
            """
if re(x.Clear):
    copy(0, ds.Row)
if re(x.Show):
    copy(txt[ds.Row], txt.Shown)  # <-
if re(x.Next):
    calc("ds.Row + 1", ds.Row)
"""
        ),
    ),
    right=(
        """
if ds.Row == 0:
    copy(1, ds.Row)
if re(x.Sample):
    copy(ds.Weight, dd[ds.Row])
    calc("ds.Row + 1", ds.Row)
""",
        """
if re(x.Sample):
    calc("ds.Row + 1", ds.Row)
    copy(ds.Weight, dd[ds.Row])
if any(ds.Line < 1, ds.Line > 20):
    copy(1, ds.Line)
if re(x.Next):
    copy(ds.Weight, dd[ds.Line])
    calc("ds.Line + 1", ds.Line)
if re(x.Load):
    copy(dd[ds.FromPanel], dd.Loaded)
if all(re(x.Show), ds.Page > 0):
    copy(dd[ds.Page], dd.Shown)
if re(x.Turn):
    calc("ds.Page + 1", ds.Page)
""",
        """
nickname(ds.Row, ds[10], initial=1, retentive=False)


def main():
    if re(x.Sample):
        copy(ds.Weight, dd[ds.Row])
        calc("ds.Row + 1", ds.Row)

    if True:
        end()
""",
    ),
)
