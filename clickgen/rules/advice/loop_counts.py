"""A loop that runs as often as a register says, which may be 0 or less."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.control import FOR
from clickgen.instructions.copies import COPY, COPY_FILL
from clickgen.ir.conditions import MIRRORED, Compare, Condition
from clickgen.ir.operands import Cell, Integer
from clickgen.logic.conditions import are_exclusive
from clickgen.problems.diagnostics import Diagnostics
from clickgen.rules.rule import Rule, Wrong

# click-facts [control.for-count]
CODE = "CG528"


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        count = placed.action.args.get("count")
        if placed.spec is not FOR or not isinstance(count, Cell):
            continue
        zero_or_less = Compare("<=", count, Integer(0, count.span), count.span)
        if any(are_exclusive(way, zero_or_less) for way in facts.ways_to(placed)):
            continue
        reason = _why_not_positive(facts, placed, count.address)
        if reason:
            problems.add(
                CODE,
                count.span,
                f"{facts.shown(count.address)} may be 0 or less: {reason}, and what CLICK does then, no source says",
                f"run the loop only above 0: if {facts.with_test(placed, f'{facts.text(count.span)} > 0')}:",
            )


def _why_not_positive(facts: Facts, loop: Placed, count: Address) -> str:
    """What gives the register such a number, or may; "" where the program keeps it above 0. Pointers lead elsewhere."""
    writers = facts.writers(count)
    if any(_raises(writer, count) and _comes_before(facts, writer, loop) for writer in writers):
        return ""
    values = [_value(writer) for writer in writers]
    if any(value is not None and value <= 0 for value in values):
        return f"the program writes {min(value for value in values if value is not None)} there"
    if not _begins_positive(facts, count):
        is_set_before = any(
            writer.is_unconditional and (_value(writer) or 0) > 0 and _comes_before(facts, writer, loop)
            for writer in writers
        )
        if not is_set_before:
            return "it begins with 0" if writers else "nothing in the program writes it"
    return "" if None not in values else "the program works it out"


def _value(writer: Placed) -> int | None:
    """The number that an instruction writes; None for one that is not always the same."""
    source = writer.action.args.get("source")
    is_constant = writer.spec in (COPY, COPY_FILL) and isinstance(source, Integer)
    return source.value if is_constant and isinstance(source, Integer) else None


def _begins_positive(facts: Facts, count: Address) -> bool:
    """True where the source or the table gives the register a number above 0 to begin with."""
    initial = facts.initial(count)
    return initial.isdecimal() and int(initial) > 0


def _raises(writer: Placed, count: Address) -> bool:
    """True for ``if ds.Rows < 1: copy(1, ds.Rows)``, which leaves no number of 0 or less."""
    value = _value(writer)
    return value is not None and value > 0 and _asks_for_too_few(writer.condition, count)


def _asks_for_too_few(condition: Condition, count: Address) -> bool:
    """True for a comparison that holds for every number of 0 or less."""
    if not isinstance(condition, Compare):
        return False
    left, right, op = condition.left, condition.right, condition.op
    if isinstance(right, Cell):
        left, right, op = right, left, MIRRORED[op]
    if not (isinstance(left, Cell) and left.address == count and isinstance(right, Integer)):
        return False
    return (op == "<" and right.value > 0) or (op == "<=" and right.value >= 0)


def _comes_before(facts: Facts, writer: Placed, loop: Placed) -> bool:
    """True for an earlier rung of the loop's own routine."""
    return writer.routine is loop.routine and writer.rung is not loop.rung and _is_first(facts.actions, writer, loop)


def _is_first(actions: Iterable[Placed], one: Placed, other: Placed) -> bool:
    return next(action for action in actions if action is one or action is other) is one


RULE = Rule(
    CODE,
    check,
    """
A loop runs as often as its register says. What CLICK does when the register is 0 or negative, its vendor does not say:
the loop may be skipped, run once, or run until the watchdog stops the PLC. An empty list, a recipe that nobody has
loaded or a register that was cleared brings such a number soon enough.

Test the register in the rung of the loop, or give it a number above 0 in a rung before, and the rule is silent. It is
silent too where the register begins above 0 and the program writes nothing else there.
""",
    wrong=(
        Wrong(
            """
if c.SumUp:
    for _ in range(ds.Rows):  # <-
        if True:
            calc("ds.Total + ds[ds.Row]", ds.Total)
            calc("ds.Row + 1", ds.Row)
"""
        ),
        Wrong(
            """
nickname(ds.Rows, ds[10], initial=5, retentive=False)


def main():
    if x[1]:
        copy(0, ds.Rows)
    if x[2]:
        for _ in range(ds.Rows):  # <-
            if True:
                calc("ds.Total + 1", ds.Total)
    if ds.Total > 5:
        out(y[1])
    if True:
        end()
"""
        ),
        Wrong(
            """
if x[1]:
    calc("ds.Last - ds.First", ds.Rows)
if x[2]:
    for _ in range(ds.Rows):  # <-
        if True:
            calc("ds.Total + 1", ds.Total)
"""
        ),
    ),
    right=(
        """
if all(c.SumUp, ds.Rows > 0):
    for _ in range(ds.Rows):
        if True:
            calc("ds.Total + 1", ds.Total)
""",
        """
if ds.Rows < 1:
    copy(1, ds.Rows)
if c.SumUp:
    for _ in range(ds.Rows):
        if True:
            calc("ds.Total + 1", ds.Total)
""",
        """
if True:
    copy(8, ds.Rows)
if c.SumUp:
    for _ in range(ds.Rows):
        if True:
            calc("ds.Total + 1", ds.Total)
if c.Again:
    for _ in range(3):
        if True:
            calc("ds.Total + 1", ds.Total)
""",
    ),
)
