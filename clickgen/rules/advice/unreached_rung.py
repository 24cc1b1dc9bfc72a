"""Rungs and actions after an end() or return that leaves before them whenever they could run."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from clickgen.device.system import ALWAYS_ON
from clickgen.facts.facts import Facts
from clickgen.instructions.coils import OUT
from clickgen.instructions.control import END, NEXT, NOP, RETURN
from clickgen.ir.conditions import All, Always, Any, Condition, Contact
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action, Branch, Item, Rung, actions_in, loops_in, rungs_in
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.rules.rule import Rule, Wrong

# click-facts [scan.skipped]
CODE = "CG516"

_EXITS = (END, RETURN)
_IDLE = (END, RETURN, NOP)
"""What is not missed: a routine may end twice, and end in a note."""


def check(facts: Facts, problems: Diagnostics) -> None:
    for routine in facts.program.routines:
        said: set[int] = set()
        for missed in unreached(routine.rungs):
            if missed.action.spec in _IDLE or id(missed.left) in said:
                continue
            said.add(id(missed.left))
            _report(problems, missed)


def _report(problems: Diagnostics, missed: Missed) -> None:
    left, place = missed.left, missed.action.span if missed.is_rung_reached else missed.rung.head
    word = "end()" if left.spec is END else "return"
    line = left.span.seen_from(place)
    if missed.is_looked_at:
        what = "this never turns anything on" if missed.action.spec is OUT else "this never runs"
        problems.add(
            CODE,
            place,
            f"{what}: whenever its rung is on, the {word} of {line} leaves before it",
            f"move the {word} after it, or give the {word} a condition of its own",
            (Label(left.span, "leaves here whenever the rung is on"),),
        )
        return
    what = "this is" if missed.is_rung_reached else "this rung is"
    problems.add(
        CODE,
        place,
        f"{what} never reached: the {word} of {line} always leaves before it",
        f"move the {word} behind it, give it a condition, or remove what stands behind it",
        (Label(left.span, "always leaves here"),),
    )


class Missed(NamedTuple):
    """An action that never runs, and the one that always leaves before it."""

    left: Action
    rung: Rung
    action: Action
    is_rung_reached: bool
    """True when only the end of the rung is never reached."""
    is_looked_at: bool = False
    """True when CLICK gets there while the rung is off: a coil there is turned off, and never on."""


def unreached(rungs: tuple[Rung, ...]) -> Iterator[Missed]:
    """The actions behind what always leaves, of a routine or of a loop's body."""
    left: Action | None = None
    is_open = left_in_loop = False
    for rung in rungs:
        actions = [action for one in rungs_in((rung,)) for action in actions_in(one.items)]
        if any(action.spec is NEXT for action in actions):
            # What leaves inside a loop leaves only when the loop runs at all.
            is_open = False
            if left_in_loop:
                left, left_in_loop = None, False
        elif left is not None:
            for action in actions:
                yield Missed(left, rung, action, False)
        else:
            behind: list[Missed] = []
            is_certain = _is_always(rung.condition)
            leaving = _left_in(rung.items, rung, is_certain, behind)
            left = leaving if is_certain else None
            left_in_loop = left is not None and is_open
            yield from behind
            for loop in loops_in(rung.items):
                is_open = is_open or loop.body is None
                yield from unreached(loop.body or ())


def _left_in(items: tuple[Item, ...], rung: Rung, is_certain: bool, behind: list[Missed]) -> Action | None:
    """What leaves among these items whenever their condition is on; ``behind`` gets what can never run after it."""
    for index, item in enumerate(items):
        left: Action | None = None
        if isinstance(item, Branch):
            is_always = _is_always(item.condition)
            inner = _left_in(item.items, rung, is_certain and is_always, behind)
            left = inner if is_always else None
        elif isinstance(item, Action) and item.spec in _EXITS:
            left = item
        if left is not None:
            behind += [Missed(left, rung, action, True, not is_certain) for action in actions_in(items[index + 1 :])]
            return left
    return None


def _is_always(condition: Condition) -> bool:
    """True for True and for the contact that is always on."""
    if isinstance(condition, All):
        return all(map(_is_always, condition.terms))
    if isinstance(condition, Any):
        return any(map(_is_always, condition.terms))
    if isinstance(condition, Contact):
        is_level = not condition.negated and not condition.edge
        return is_level and isinstance(condition.operand, Cell) and condition.operand.address == ALWAYS_ON
    return isinstance(condition, Always)


RULE = Rule(
    CODE,
    check,
    """
An `end()` in main, or a `return` in a subroutine, that stands under no condition, or under the contact that is always
on, ends the routine in every scan. What stands behind it is in the CLICK and never runs: its outputs stay as they were,
its timers stand still. Mostly an `end()` from a test was left in, or new rungs were added below the last one.

Under a condition it leaves whenever that condition is on. Actions after it in the same rung, and branches there, need
the same condition, so they never run either: write them before the `return`, or give the `return` a branch of its own.
""",
    wrong=(
        Wrong(
            """
def main():
    if x.Start:
        out(y.Motor)

    if True:
        end()

    if x.Overload:  # <-
        out(y.Horn)

    if x.Level:
        out(y.Valve)
"""
        ),
        Wrong(
            """
def main():
    if True:
        call(alarms)
        end()


@sub
def alarms():
    if True:
        return
        set(c.Checked)  # <-

    if x.Overload:
        out(y.Horn)

    if True:
        return
"""
        ),
        Wrong(
            """
def main():
    if True:
        call(alarms)
        end()


@sub
def alarms():
    if x.Overload:
        out(y.Horn)
        return
        set(c.Alarm)  # <-
        if x.Level:
            out(y.Valve)

    if True:
        return
"""
        ),
        Wrong(
            """
if x.Stopped:
    if c.Test:
        end()
        copy(0, ds.Step)  # <-
    copy(1, ds.Stops)
"""
        ),
    ),
    right=(
        """
if x.Stopped:
    if c.Test:
        end()
    copy(0, ds.Step)
""",
        """
if x.Stopped:
    end()

if x.Start:
    out(y.Motor)
""",
        """
if c.SumUp:
    for _ in range(ds.Rows):
        pass

if True:
    end()

if True:
    next_loop()

if x.Start:
    out(y.Motor)
""",
    ),
    holds_in_parts=True,
)
