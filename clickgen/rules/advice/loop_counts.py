"""A loop that runs as often as a register says, which may be 0 or less."""

from __future__ import annotations

from collections.abc import Sequence

from clickgen.device.banks import Address
from clickgen.facts.facts import FIRST_SCAN, Facts, Placed
from clickgen.facts.written import equals, is_relative, left_in, whole_condition
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import MIRRORED, All, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Integer
from clickgen.logic.conditions import are_exclusive, implies, looked_at, terms_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [control.for-count]
CODE = "CG528"


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        count = placed.action.args.get("count")
        if placed.effects.flow is not Flow.LOOP or not isinstance(count, Cell):
            continue
        zero_or_less = Compare("<=", count, Integer(0, count.span), count.span)
        if any(are_exclusive(way, zero_or_less) for way in facts.ways_to(placed)):
            continue
        above = facts.spell.compared(facts.text(count.span), ">", "0")
        reason = _why_not_positive(facts, placed, count.address)
        if reason:
            yield finding(
                CODE,
                count.span,
                f"{facts.shown(count.address)} may be 0 or less: {reason}, and no source says what CLICK does then",
                f"run the loop only above 0: {facts.spell.rung(facts.with_test(placed, above))}",
            )


def _why_not_positive(facts: Facts, loop: Placed, count: Address) -> str:
    """What gives the register such a number, or may; "" if the program keeps it above 0. Pointers lead elsewhere."""
    writers = facts.writers(count)
    values = {id(writer): _value(writer, count) for writer in writers}
    good = [writer for writer in writers if (values[id(writer)] or 0) > 0]
    doubtful = [writer for writer in writers if (values[id(writer)] or 0) <= 0]
    if any(_asks_for_too_few(writer.condition, count) and _comes_before(facts, writer, loop) for writer in good):
        return ""
    if any(_is_fresh(facts, writer, loop, doubtful) for writer in good):
        return ""
    least = min((value for value in values.values() if value is not None), default=1)
    if least <= 0:
        return f"the program writes {least} there"
    if doubtful:
        return "the program works it out"
    if _begins_positive(facts, count) or any(_gets_ready(facts, writer, loop, count) for writer in good):
        return ""
    return "it begins with 0" if writers else "nothing in the program writes it"


def _value(writer: Placed, count: Address) -> int | None:
    """The number that an instruction writes; None for one that is not always the same."""
    return None if is_relative(writer, count) else left_in(writer, count, 0)


def _begins_positive(facts: Facts, count: Address) -> bool:
    """True if the source or the table gives the register an initial value above 0."""
    initial = facts.initial(count)
    return initial.isdecimal() and int(initial) > 0


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


# -- actions before the loop ------------------------------------------------------------------------------------------

_Moment = tuple[int, int]
"""When an action runs in a scan: its place in main, or that of the call and its own place in the subroutine."""


def _moments(facts: Facts, placed: Placed) -> list[_Moment]:
    place = facts.places[id(placed.action)]
    calls = () if placed.routine.is_main else facts.calls.get(placed.routine.name, ())
    return [(facts.places[id(call.action)], place) for call in calls] or [(place, -1)]


def _comes_before(facts: Facts, writer: Placed, loop: Placed) -> bool:
    """True if the writer is looked at before the loop, each time that the loop is."""
    if writer.routine is loop.routine:
        return facts.places[id(writer.action)] < facts.places[id(loop.action)]
    first = min(_moments(facts, writer))
    return all(first < moment for moment in _moments(facts, loop))


def _gets_ready(facts: Facts, writer: Placed, loop: Placed, count: Address) -> bool:
    """True for a write of the register in the first scan, or while it is still 0: ``if sc[2]: copy(3, ds.Rows)``."""
    span = writer.action.span
    at_start = All((Contact(Cell(FIRST_SCAN, span), span), equals(count, 0, span)), span)
    return _comes_before(facts, writer, loop) and implies(at_start, whole_condition(facts, writer))


def _is_fresh(facts: Facts, writer: Placed, loop: Placed, others: Sequence[Placed]) -> bool:
    """True if the writer runs whenever the loop does, in the same scan before it, and none of the others between."""
    if writer.action.flag("oneshot") or not _comes_before(facts, writer, loop):
        return False
    is_repeated = loop.loop is not None or any(call.loop for call in facts.calls.get(loop.routine.name, ()))
    if is_repeated and others:
        return False
    if any(_runs_between(facts, other, writer, loop) for other in others):
        return False
    if _is_above(writer, loop):
        return True
    if not implies(whole_condition(facts, loop), whole_condition(facts, writer)):
        return False
    asked = [one for one in looked_at(writer.condition) if isinstance(one, Address)]
    return not any(_runs_between(facts, changer, writer, loop) for one in asked for changer in facts.writers(one))


def _is_above(writer: Placed, loop: Placed) -> bool:
    """True in the loop's own rung, where conditions are looked at once, if the loop's include all the writer's."""
    held = {id(term) for term in terms_of(loop.condition)}
    return writer.rung is loop.rung and all(id(term) in held for term in terms_of(writer.condition))


def _runs_between(facts: Facts, other: Placed, writer: Placed, loop: Placed) -> bool:
    """True if it may run after the writer and before the loop."""
    if writer.routine is loop.routine:
        first, last = facts.places[id(writer.action)], facts.places[id(loop.action)]
        spots = [facts.places[id(other.action)]] if other.routine is loop.routine else []
        spots += [place for place, own in _moments(facts, other) if own >= 0 and other.routine is not loop.routine]
        return any(first < spot < last for spot in spots)
    return any(
        min(_moments(facts, writer)) < moment < until
        for moment in _moments(facts, other)
        for until in _moments(facts, loop)
    )


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a loop's count may be 0 or less",
    """
A loop runs as often as its register says. The vendor does not say what CLICK does when the register is 0 or negative:
the loop may be skipped, run once, or run until the watchdog stops the PLC. An empty list, a recipe that nobody has
loaded or a register that was cleared brings such a number soon enough.

Test the register in the rung of the loop, or give it a number above 0 in a rung before, and the rule is silent. It is
silent too where the register begins above 0, or the first scan gives it such a number, and the program writes nothing
else there.
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
if sc._1st_SCAN:
    copy(3, ds.Rows)
if c.SumUp:
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

RULE = Rule(find, (ABOUT,))
