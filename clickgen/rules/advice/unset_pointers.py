"""A pointer that is still 0 when it is first used: the program only counts it up, and nothing initializes it."""

from __future__ import annotations

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.written import Asked, is_relative, left_in, whole_condition
from clickgen.instructions.offered import COPY
from clickgen.ir.operands import Cell, Pointer
from clickgen.ir.reach import touches
from clickgen.logic.conditions import can_hold, implies
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [copy.wild-pointer, scan.power-up]
CODE = "CG554"


def find(facts: Facts) -> Findings:
    moved: dict[Address, tuple[Placed, ...]] = {}
    said: set[Address] = set()
    places = facts.places
    # A panel chooses what is read, but seldom where something is written.
    chosen = {
        use.operand.register.address
        for use in facts.uses.every
        if not use.is_written and isinstance(use.operand, Pointer) and isinstance(use.operand.register, Cell)
    }
    for placed in facts.actions:
        if placed.effects.is_unknown:
            continue
        for touch in touches(placed.action):
            pointer = touch.operand
            if not isinstance(pointer, Pointer) or not isinstance(pointer.register, Cell):
                continue
            address = pointer.register.address
            if BANKS[pointer.bank].has(0) or address in said:
                continue
            if address not in moved:
                moved[address] = _movers(facts, address, address not in chosen)
            # Another routine may run before this one. A register that is counted down to -1 leads nowhere either.
            before = [
                one
                for one in moved[address]
                if BANKS[pointer.bank].has(left_in(one, address, 0) or 0)
                and (one.routine is not placed.routine or places[id(one.action)] < places[id(placed.action)])
            ]
            if moved[address] and _may_find_zero(facts, placed, address, before):
                said.add(address)
                yield from _report(facts, pointer, pointer.register, moved[address])


def _report(facts: Facts, pointer: Pointer, register: Cell, moved: tuple[Placed, ...]) -> Findings:
    name, shown, bank = facts.text(register.span), facts.shown(register.address), pointer.bank
    moves = {left_in(mover, register.address, 0) or 0 for mover in moved}
    if moves == {0}:
        fault = f"{shown} is never anything but 0, and there is no {bank}0: CLICK skips this"
        label = "nothing but this writes it"
    else:
        way = "counted down" if max(moves) <= 0 else "counted on"
        fault = (
            f"{shown} begins with 0 on a new PLC and is only {way}, and there is no {bank}0: the first time CLICK "
            "skips this"
        )
        label = "nothing but this gives it another number"
    head = facts.spell.rung(facts.spell.compared(name, "==", "0"))
    copy = facts.spell.call(COPY, "101", name)
    yield finding(
        CODE,
        pointer.span,
        f"{fault} and sets SC44 (_Address_Error)",
        f"give it the number of the first cell in a rung above: {head}, and in it {copy} for {bank}101",
        (Label(moved[0].action.span, label),),
    )


def _movers(facts: Facts, address: Address, is_own: bool) -> tuple[Placed, ...]:
    """The actions that make another number of a register that holds 0; none if anything else may, or it is never 0.

    If the program only clears a register that is its own, these are the actions that clear it.
    """
    if facts.initial(address) not in ("", "0"):
        return ()
    movers: list[Placed] = []
    idle: list[Placed] = []
    for writer in facts.writers(address):
        if not Asked(facts, writer, address).may_be(0):
            continue
        left = left_in(writer, address, 0)
        if left is None or (left != 0 and not is_relative(writer, address)):
            return ()
        (movers if left != 0 else idle).append(writer)
    alone = tuple(writer for writer in idle if isinstance(writer.action.moved_to, Cell))
    return tuple(movers) or (alone if is_own else ())


def _may_find_zero(facts: Facts, use: Placed, address: Address, before: list[Placed]) -> bool:
    """True if the use runs while the register is 0, and none of these certainly runs before it in the same scan."""
    whole = whole_condition(facts, use)
    if not can_hold(whole) or not Asked(facts, use, address).may_be(0):
        return False
    for mover in before:
        is_once = mover.action.flag("oneshot") and not use.action.flag("oneshot")
        if mover.loop is not None or (not is_once and implies(whole, mover.condition)):
            return False
    return True


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a pointer is still 0 when it is used",
    """
A register that nothing has written holds 0 on a new PLC. As a pointer it leads nowhere: CLICK skips the copy and sets
SC44, so that the first entry of a log is lost, and nobody knows why there is one less.

The rule speaks where the program only counts the register on or down from its own value, or clears it, and the pointer
may be used before, in a loop as well. It is silent where anything else gives the register a number, where the rung asks
for a number that is not 0, and where the register begins with one that CLICK does not mask
(`initial=101, retentive=False`). A register that nothing in the program moves is a panel's, and so is one that is only
cleared and says what is read.
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
        Wrong(
            """
if sc._1st_SCAN:
    copy(0, ds.Line)
if re(x.Sample):
    copy(ds.Weight, dd[ds.Line])  # <-
if re(x.Take):
    calc("ds.Last - 1", ds.Last)
    copy(dd[ds.Last], dd.Taken)  # <-
if re(x.Clear):
    for _ in range(50):
        if True:
            copy(0, df[ds.Cell])  # <-
            calc("ds.Cell + 1", ds.Cell)
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
if re(x.Forget):
    copy(0, ds.FromPanel)
if re(x.Fetch):
    copy(0, ds.Cell)
    for _ in range(50):
        if True:
            calc("ds.Cell + 1", ds.Cell)
            copy(dd[ds.Cell], dd.Largest)
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

RULE = Rule(find, (ABOUT,))
