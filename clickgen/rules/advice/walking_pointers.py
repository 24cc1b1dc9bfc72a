"""A pointer that writes over cells of other names: those that clickgen chose, or its own register."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.walks import Step, Walk, each_turn, walk_of
from clickgen.facts.written import Asked, whole_condition
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, Integer, Pointer
from clickgen.ir.reach import touches
from clickgen.logic.conditions import implies
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

# click-facts [copy.pointers]
CODE = "CG555"


class _Reach(NamedTuple):
    """The cells that a pointer can lead to; ``is_open`` if nothing ends the way up."""

    numbers: range | tuple[int, ...]
    is_open: bool


def find(facts: Facts) -> Findings:
    walks: dict[Address, Walk | None] = {}
    for placed in facts.actions:
        if placed.effects.is_unknown:
            continue
        for touch in touches(placed.action):
            pointer = touch.operand
            if not touch.is_written or not isinstance(pointer, Pointer) or not isinstance(pointer.register, Cell):
                continue
            address = pointer.register.address
            if address not in walks:
                walks[address] = walk_of(facts, address)
            walk = walks[address]
            reach = _reach(facts, placed, address, pointer.bank, walk) if walk else None
            if walk and reach:
                hit = _hit(facts, address, pointer.bank, reach)
                if hit:
                    yield from _report(facts, pointer, walk, reach, hit)


def _hit(facts: Facts, address: Address, bank: str, reach: _Reach) -> list[Address]:
    """The cells that the pointer must not write.

    These are its own register, those that clickgen gave a name, and any name after the block in which it begins.
    """
    reached = reach.numbers if isinstance(reach.numbers, range) else set(reach.numbers)
    guarded = {*facts.placed, address}
    for block in facts.program.blocks:
        if block.range.bank == bank and block.range.first <= reach.numbers[0] <= block.range.last:
            guarded.update(row.address for row in facts.rows.values() if row.nickname)
            guarded.difference_update(block.range.addresses())
    hit = [one for one in guarded if one.bank == bank and one.number in reached]
    return sorted(hit, key=lambda one: one.sort_key)


def _report(facts: Facts, pointer: Pointer, walk: Walk, reach: _Reach, hit: list[Address]) -> Findings:
    assert isinstance(pointer.register, Cell)
    name, bank = facts.text(pointer.register.span), pointer.bank
    shown = facts.shown(pointer.register.address)
    if reach.is_open:
        says = f"nothing stops {shown} on its way up from {reach.numbers[0]}"
    elif walk.steps:
        says = f"{shown} goes from {reach.numbers[0]} to {reach.numbers[-1]}"
    else:
        says = f"{shown} can be {', '.join(map(str, sorted(set(reach.numbers))))}"
    one = len(hit) == 1
    table = facts.spell.declaration(facts.spell.name(bank, "Table"), _place(facts, bank))
    labels = (Label(walk.steps[0].placed.action.span, "counted on here"),) if walk.steps else ()
    yield finding(
        CODE,
        pointer.span,
        f"{says}, so this can write over {facts.listed(hit)}, which {'is' if one else 'are'} not of the table",
        f"give the table a place of its own, {table}, let {name} begin there, and take it back after the last cell",
        labels,
    )


def _place(facts: Facts, bank: str) -> str:
    """A free place for a table, as an example: after everything that the bank is used for."""
    last = max((address.number for address in facts.rows if address.bank == bank), default=0)
    first = (last // 100 + 1) * 100 + 1
    size = BANKS[bank]
    spell = facts.spell
    return spell.range(bank, first, first + 49) if first + 49 <= size.last else spell.pointer(bank, "...")


# -- the range of the register ----------------------------------------------------------------------------------------


def _reach(facts: Facts, use: Placed, address: Address, bank: str, walk: Walk) -> _Reach | None:
    """The numbers that the register can have when it is used; None if unknown."""
    is_shared = any(_share_loop(step, use) for step in walk.steps)
    asked = Asked(facts, each_turn(facts, use) if is_shared else use, address)
    if not walk.steps:
        numbers = tuple(number for number in walk.numbers if asked.may_be(number) and BANKS[bank].has(number))
        return _Reach(numbers, False) if numbers else None
    starts = [number for number in walk.numbers if number > 0]
    begins = facts.initial(address)
    if begins not in ("", "0"):
        starts.append(int(begins))
    if not starts or 0 in walk.numbers:
        starts.append(0)
    places = facts.places
    before = [
        step
        for step in walk.steps
        if step.placed.rung is use.rung and places[id(step.placed.action)] < places[id(use.action)]
    ]
    # From 0 the pointer leads nowhere until it is counted up.
    low = min(starts)
    if before or low == 0:
        low += min(step.size for step in before or walk.steps)
    high = _bound(facts, use, asked, address, walk, low)
    last = max((_last(facts, use, walk.steps, *start) for start in walk.starts), default=None)
    if last is not None:
        high = last if high is None else min(high, last)
    if high is not None:
        return _Reach(range(low, high + 1), False) if low <= high else None
    if any(address in _looked_at(leaf) for leaf in facts.comparisons):
        return None
    return _Reach(range(low, BANKS[bank].last + 1), True)


def _last(facts: Facts, use: Placed, steps: Sequence[Step], giver: Placed, number: int) -> int:
    """The greatest number that the register has when it is used, counted from what gives it a number."""
    places = facts.places
    given, used = places[id(giver.action)], places[id(use.action)]
    for step in steps:
        at = places[id(step.placed.action)]
        if _share_loop(step, use) and giver.loop is not use.loop:
            number += _in_loop(facts, step, use)
            continue
        is_between = given < at < used if given < used else at > given or at < used
        if is_between or not use.routine is giver.routine is step.placed.routine:
            number += step.size * (step.times or 1)
    return number


def _share_loop(step: Step, use: Placed) -> bool:
    return step.times is not None and step.placed.loop is use.loop


def _in_loop(facts: Facts, step: Step, use: Placed) -> int:
    """How much a step has counted when their loop comes to the use for the last time."""
    is_before = facts.places[id(step.placed.action)] < facts.places[id(use.action)]
    return step.size * ((step.times or 1) - (0 if is_before else 1))


def _looked_at(compare: Compare) -> list[Address]:
    return [side.address for side in (compare.left, compare.right) if isinstance(side, Cell)]


def _bound(facts: Facts, use: Placed, asked: Asked, address: Address, walk: Walk, low: int) -> int | None:
    """The greatest number that the register can have when it is used; None if unknown."""
    limits = sorted(limit for limit in set(_limits(facts, address)) if limit >= low)
    span = use.action.span
    shared = [step for step in walk.steps if _share_loop(step, use) and step.moves is not step.placed]
    inside = sum(_in_loop(facts, step, use) for step in shared)
    for limit in limits:
        if asked.implies(_at_most(address, limit, span)):
            return limit
    for limit in limits:
        bound = _at_most(address, limit, span)
        if all(Asked(facts, step.moves, address).implies(bound) for step in walk.steps):
            return max(limit + (inside or walk.size), *walk.numbers, 0)
    for limit in limits:
        # Counting by more than 1 may pass a number that is only tested with ==.
        beyond = Compare(">", Cell(address, span), Integer(limit, span), span)
        if walk.size == 1:
            beyond = Compare("==", Cell(address, span), Integer(limit + 1, span), span)
        if any(implies(beyond, whole_condition(facts, wrap)) for wrap in walk.wraps):
            return limit + (inside or (walk.size if _is_ahead_of_wrap(use, walk) else 0))
    return None


def _is_ahead_of_wrap(use: Placed, walk: Walk) -> bool:
    """True if the register is counted up, then used, then taken back, in this order of rungs."""
    rungs = [id(rung) for rung in use.routine.rungs]
    if any(other.routine is not use.routine for other in (*(step.placed for step in walk.steps), *walk.wraps)):
        return False
    try:
        at = rungs.index(id(use.rung))
        steps = [rungs.index(id(step.placed.rung)) for step in walk.steps]
        wraps = [rungs.index(id(wrap.rung)) for wrap in walk.wraps]
    except ValueError:
        return False
    return max(steps) < at < min(wraps)


def _limits(facts: Facts, address: Address) -> Sequence[int]:
    """Numbers that may bound the register: those that comparisons of it name, and their neighbours."""
    limits: list[int] = []
    for compare in facts.comparisons:
        for side, other in ((compare.left, compare.right), (compare.right, compare.left)):
            if isinstance(side, Cell) and side.address == address and isinstance(other, Integer):
                limits += (other.value - 1, other.value)
    return limits


def _at_most(address: Address, limit: int, span: Span) -> Compare:
    return Compare("<=", Cell(address, span), Integer(limit, span), span)


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a pointer can walk over cells of other names",
    """
A pointer does not know where a table ends, nor what clickgen put into its bank. A log that counts `ds.Row` on from 1
writes DS1, DS2, DS3. That is where clickgen has placed setpoints and the pointer itself, unless the table was given a
place. The machine then works with a weight for a setpoint.

The rule speaks where the program alone moves the register, by constants and by counting up, and the cells that it can
reach hold a name whose address clickgen chose, or the register itself. A condition that bounds the register counts: in
the rung of the pointer, where it is counted on, or where it is taken back. Where it is compared in a way that gives no
number, or moved by a panel, a calculation or a loop of unknown length, the rule is silent. So it is where every run
begins with a number of its own and ends inside the table. A pointer that only reads harms nobody.

Give the table a block, and begin in it: clickgen places no name in a block.
""",
    wrong=(
        Wrong(
            """
if ds.Row == 0:
    copy(1, ds.Row)
if re(x.Sample):
    copy(ds.Weight, ds[ds.Row])  # <-
    calc("ds.Row + 1", ds.Row)
if ds.Row > 50:
    copy(1, ds.Row)
"""
        ),
        Wrong(
            """
nickname(ds.History, ds[1001:1051])
nickname(ds.Speed, ds[1051], comment="of the belt")


def main():
    if ds.Row < 1001:
        copy(1001, ds.Row)

    if re(x.Sample):
        copy(ds.Weight, ds[ds.Row])  # <-
        calc("ds.Row + 1", ds.Row)

    if ds.Row > 1051:
        copy(1001, ds.Row)

    if ds.Speed > 10:
        out(y.Belt)

    if True:
        end()
"""
        ),
        Wrong(
            """
if re(x.Reset):
    copy(5, ds.Place)
if re(x.Part):
    calc("ds.Place + 1", ds.Place)
    copy(1, ds[ds.Place])  # <-
if all(c.A, ds.B == ds.C, ds.D == ds.E, ds.F == 7):
    copy(ds.G, ds.Pick)
if re(x.Choose):
    copy(3, ds.Slot)
    copy(9, ds[ds.Slot])  # <-
"""
        ),
        Wrong(
            """
nickname(ds.History, ds[1001:1051])
nickname(ds.Speed, ds[1051], comment="of the belt")


def main():
    if re(x.Clear):
        copy(1001, ds.Row)

    if re(x.Clear):
        for _ in range(60):
            if True:
                copy(0, ds[ds.Row])  # <-
                calc("ds.Row + 1", ds.Row)

    if ds.Speed > 10:
        out(y.Belt)

    if True:
        end()
"""
        ),
    ),
    right=(
        """
nickname(ds.History, ds[1001:1051])


def main():
    if any(ds.Row < 1001, ds.Row > 1050):
        copy(1001, ds.Row)

    if re(x.Sample):
        copy(ds.Weight, ds[ds.Row])
        calc("ds.Row + 1", ds.Row)

    if True:
        end()
""",
        """
nickname(ds.History, ds[1001:1051])
nickname(ds.Speed, ds[1051], comment="of the belt")


def main():
    if re(x.Clear):
        copy(1001, ds.Row)

    if re(x.Clear):
        for _ in range(50):
            if True:
                copy(0, ds[ds.Row])
                calc("ds.Row + 1", ds.Row)

    if ds.Speed > 10:
        out(y.Belt)

    if True:
        end()
""",
        """
if re(x.Reset):
    copy(1000, ds.Place)
if all(re(x.Part), ds.Place < 1010):
    calc("ds.Place + 1", ds.Place)
    copy(1, ds[ds.Place])
if re(x.Load):
    copy(ds.FromPanel, ds.Slot)
    copy(9, ds[ds.Slot])
if ds.Line == 0:
    copy(1, ds.Line)
if re(x.Store):
    copy(ds.Weight, dd[ds.Line])
    calc("ds.Line + 1", ds.Line)
if ds.Line > ds.Lines:
    copy(1, ds.Line)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
