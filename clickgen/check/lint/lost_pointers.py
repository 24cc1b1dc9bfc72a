"""A pointer whose register gets a number that no address of the bank has."""

from __future__ import annotations

from clickgen.check.facts import Facts, Placed
from clickgen.check.logic import are_exclusive, implies
from clickgen.check.rule import Rule, Wrong
from clickgen.device.banks import BANKS
from clickgen.diagnostics import Diagnostics, Label
from clickgen.instructions.copies import COPY, COPY_FILL
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, Integer, Pointer
from clickgen.ir.reach import touches
from clickgen.ir.walk import leaves

CODE = "CG518"


def check(facts: Facts, problems: Diagnostics) -> None:
    through = {id(use.action) for use in facts.uses.every if isinstance(use.operand, Pointer)}
    # Where pointers write DS registers, any of them may write the pointer's own.
    if not through or facts.uses.is_pointed("DS", True):
        return
    for placed in facts.actions:
        if id(placed.action) in through:
            pointers = {touch.operand: None for touch in touches(placed.action) if isinstance(touch.operand, Pointer)}
            for pointer in pointers:
                if isinstance(pointer.register, Cell):
                    _judge(facts, problems, placed, pointer, pointer.register)


def _judge(facts: Facts, problems: Diagnostics, placed: Placed, pointer: Pointer, register: Cell) -> None:
    bank = BANKS[pointer.bank]
    for writer, number in _numbers(facts, placed, register):
        # What CLICK does then: click-facts, section 8, "Bad pointer".
        if not bank.has(number):
            problems.add(
                CODE,
                pointer.span,
                f"{facts.shown(register.address)} is {number} after {writer.action.span.seen_from(pointer.span)}, and "
                f"there is no {bank.name}{number}: CLICK skips this and sets SC44 (_Address_Error)",
                f"{bank.name} has {bank.describe_range()}: give the pointer such a number first, or test it in the "
                "condition of this rung",
                (Label(writer.action.span, f"{number} comes from here"),),
            )
            return


def _numbers(facts: Facts, placed: Placed, register: Cell) -> list[tuple[Placed, int]]:
    """The numbers that the register has when the action runs, with their writers; none where that is not sure."""
    writers = [(writer, _constant(writer)) for writer in facts.writers(register.address)]
    known = [(writer, number) for writer, number in writers if number is not None]
    if len(known) < len(writers):
        return []
    before = [(writer, number) for writer, number in known if _runs_before(writer, placed)]
    for index in range(len(before) - 1, -1, -1):
        writer = before[index][0]
        if implies(placed.condition, writer.condition) and not writer.action.flag("oneshot"):
            return before[index:]
    if _is_asked_elsewhere(facts, placed, register):
        return []
    return [
        (writer, number)
        for writer, number in known
        if not are_exclusive(placed.condition, Compare("==", register, Integer(number, register.span), register.span))
        # A block is cleared whoever fills it.
        and not (writer.spec is COPY_FILL and number == 0)
    ]


def _constant(writer: Placed) -> int | None:
    """The number that an action writes, when that is always the same."""
    source = writer.action.args.get("source")
    return source.value if writer.spec in (COPY, COPY_FILL) and isinstance(source, Integer) else None


def _runs_before(writer: Placed, placed: Placed) -> bool:
    return writer.rung is placed.rung and writer.action.span[1:3] < placed.action.span[1:3]


def _is_asked_elsewhere(facts: Facts, placed: Placed, register: Cell) -> bool:
    """True when some other condition looks at the register: it may keep wrong numbers from coming here."""
    own = {id(leaf) for leaf in leaves(placed.condition)}
    reads = facts.uses.reads(register.address)
    return any(use.leaf is not None and id(use.leaf) not in own for use in reads)


RULE = Rule(
    CODE,
    check,
    """
A pointer whose register holds 0, or a number beyond the bank, leads nowhere: CLICK skips the copy, sets SC44 and goes
on with the old value. Nothing on the panel says why a recipe did not load.

The rule speaks only where the program itself writes such a number: every write of the register is a constant, none goes
through a pointer, and no condition anywhere else looks at the register. What a panel writes is not known, so a register
that the program never writes is left alone, and so is one that a calculation writes.
""",
    wrong=(
        Wrong(
            """
if c.Reset:
    copy(0, ds.Row)
if c.First:
    copy(101, ds.Row)
if c.Load:
    copy(ds[ds.Row], ds.Value)  # <-
"""
        ),
        Wrong(
            """
if c.Load:
    copy(2001, ds.Index)
    copy(c[ds.Index], c.Copy)  # <-
    copy(ds[ds.Index], ds.Value)
if ds.Row < 500:
    copy(600, ds.Row)
    calc("df[ds.Row] / 2", df.Half)  # <-
"""
        ),
    ),
    right=(
        """
if c.Load:
    copy(ds[ds.FromPanel], ds.Value)
""",
        """
if c.Reset:
    copy(0, ds.Row)
    copy(0, ds.Line)
if c.First:
    copy(101, ds.Row)
    copy(1, ds.Line)
if all(c.Load, ds.Row > 0):
    copy(ds[ds.Row], ds.Value)
if ds.Line == 0:
    copy(1, ds.Line)
if c.Load:
    copy(dd[ds.Line], dd.Total)
""",
        """
if c.Reset:
    copy(0, ds.Row)
if c.Next:
    calc("ds.Row + 1", ds.Row)
    copy(ds[ds.Row], ds.Value)
""",
        """
if c.Load:
    copy(101, ds.Row)
    copy(ds[ds.Row], ds.First)
if c.Clear:
    copy(0, ds.Row)
if sc._1st_SCAN:
    copy_fill(0, ds[1:50])
if c.Show:
    copy(txt[ds[7]], txt[1])
""",
    ),
)
