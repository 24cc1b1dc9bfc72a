"""Pointers that may write a bit which clickgen needs for itself. The bits are known once rungs are lowered.

Scratch registers are in no danger: what they hold is copied there directly before its use.
"""

from __future__ import annotations

from clickgen.device.banks import BANKS
from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Shape
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, Integer, Pointer
from clickgen.ir.reach import touches
from clickgen.logic.conditions import are_exclusive
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.table.rows import Row


def find(facts: Facts) -> Findings:
    scratch = facts.scratch_rows()
    bits = sorted((row for row in scratch if BANKS[row.address.bank].is_bit), key=lambda row: row.address.number)
    for placed in facts.actions:
        for touch in touches(placed.action) if bits else ():
            if touch.is_written and isinstance(touch.operand, Pointer) and isinstance(touch.operand.register, Cell):
                reached = next((row for row in bits if _may_lead_to(facts, placed, touch.operand, row)), None)
                if reached is not None:
                    yield from _report(facts, placed, touch.operand, touch.operand.register, reached)


def _report(facts: Facts, placed: Placed, pointer: Pointer, register: Cell, row: Row) -> Findings:
    test = facts.spell.compared(facts.text(register.span), "<", str(row.address.number))
    yield finding(
        "CG428",
        pointer.span,
        f"{facts.shown(register.address)} may lead to {row.address}, which clickgen uses for itself ({row.comment})",
        f"test the pointer in this rung: {facts.spell.rung(facts.with_test(placed, test))}",
    )


def _may_lead_to(facts: Facts, placed: Placed, pointer: Pointer, row: Row) -> bool:
    if row.address.bank != pointer.bank:
        return False
    register, number = pointer.register, row.address.number
    assert isinstance(register, Cell)
    is_there = Compare("==", register, Integer(number, register.span), register.span)
    return not are_exclusive(placed.condition, is_there) and not _is_kept_away(facts, register, number)


def _is_kept_away(facts: Facts, register: Cell, number: int) -> bool:
    """True when the program gives the register constants alone, and never this number."""
    writers = facts.writers(register.address)
    if not writers or facts.uses.is_pointed("DS", is_written=True):
        return False
    moved = [writer.action.moved for writer in writers if writer.effects.shape in (Shape.VALUE, Shape.FILL)]
    numbers = [value.value for value in moved if isinstance(value, Integer)]
    return len(numbers) == len(writers) and number not in numbers


ABOUT = Code(
    "CG428",
    Severity.WARNING,
    "a pointer may write a scratch bit",
    """
clickgen keeps some conditions in scratch bits, at the top of C. A pointer that writes into C can also
reach them: then an instruction runs that should not, or does not run when it should. In the rung that writes through
the pointer, test that it stays below the scratch bits. The warning also goes away if the program gives the pointer's
register only constants, and none of them is the number of a scratch bit.
""",
    wrong=(
        Wrong(
            """
if x[1]:
    copy(c.Ready, c[ds.Index])  # <-
    ctu(ct.Parts, 5, reset=lambda: c.Ready)
""",
        ),
    ),
    right=(
        """
if all(x[1], ds.Index < 1000):
    copy(c.Ready, c[ds.Index])
if re(x[2]):
    ctu(ct.Parts, 5, reset=lambda: c.Ready)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
