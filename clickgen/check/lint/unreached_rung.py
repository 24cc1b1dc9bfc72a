"""Rungs and actions behind an unconditional end() or return."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.check.facts import Facts
from clickgen.check.rule import Rule, Wrong
from clickgen.diagnostics import Diagnostics, Label
from clickgen.instructions.control import END, NEXT, NOP, RETURN
from clickgen.ir.conditions import Always
from clickgen.ir.program import Action, Branch, Item, Loop, Rung, actions_in, loops_in
from clickgen.source import Span

CODE = "CG516"

_EXITS = (END, RETURN)
_IDLE = (END, RETURN, NOP)
"""What is not missed: a routine may end twice, and end in a note."""


def check(facts: Facts, problems: Diagnostics) -> None:
    for routine in facts.program.routines:
        _check(routine.rungs, problems)


def _check(rungs: tuple[Rung, ...], problems: Diagnostics) -> None:
    """The rungs of a routine, or of a loop's body."""
    left: Action | None = None
    is_open = left_in_loop = is_said = False
    for rung in rungs:
        actions = list(actions_in(rung.items))
        if any(action.spec is NEXT for action in actions):
            # What leaves inside a loop leaves only when the loop runs at all.
            is_open = False
            if left_in_loop:
                left, left_in_loop, is_said = None, False, False
            continue
        place: Span | None = None
        if left is not None:
            place = rung.head if any(action.spec not in _IDLE for action in actions) else None
        else:
            left, place = _leaving(rung)
            left_in_loop = left is not None and is_open
            for loop in loops_in(rung.items):
                is_open = is_open or loop.body is None
                _check(loop.body or (), problems)
        if left is not None and place is not None and not is_said:
            is_said = True
            word = "end()" if left.spec is END else "return"
            what = "this rung is" if place is rung.head else "this is"
            problems.add(
                CODE,
                place,
                f"{what} never reached: the {word} of {left.span.seen_from(place)} always leaves before it",
                f"move the {word} behind it, give it a condition, or remove what stands behind it",
                (Label(left.span, "always leaves here"),),
            )


def _leaving(rung: Rung) -> tuple[Action | None, Span | None]:
    """The action of a rung that always leaves, and the first one behind it that would have done something."""
    left: Action | None = None
    for action, is_certain in _actions(rung.items, isinstance(rung.condition, Always)):
        if left is not None and action.spec not in _IDLE:
            return left, action.span
        if left is None and is_certain and action.spec in _EXITS:
            left = action
    return left, None


def _actions(items: tuple[Item, ...], is_certain: bool) -> Iterator[tuple[Action, bool]]:
    """Every action of a rung, and whether it runs whenever the rung is reached."""
    for item in items:
        if isinstance(item, Branch):
            yield from _actions(item.items, is_certain and isinstance(item.condition, Always))
        else:
            yield (item.action, False) if isinstance(item, Loop) else (item, is_certain)


RULE = Rule(
    CODE,
    check,
    """
An `end()` in main, or a `return` in a subroutine, that stands under no condition ends the routine in every scan. What
stands behind it is in the CLICK and never runs: its outputs stay as they were, its timers stand still. Mostly an
`end()` from a test was left in, or new rungs were added below the last one.
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
    ),
    right=(
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
)
