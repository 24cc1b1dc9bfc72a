"""Loops are closed, are in no other loop, and close in a rung of their own (C0103, C0009).

click-facts [control.loops, control.next, timer.in-loop]
"""

from __future__ import annotations

from clickgen.dialects.base import Spelling
from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Flow
from clickgen.instructions.offered import NEXT
from clickgen.ir.program import Action, Routine, actions_in
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    open_loop: Placed | None = None
    routine: Routine | None = None
    closing = facts.spell.call(NEXT)
    for placed in facts.actions:
        if placed.routine is not routine:
            yield from _refuse_open(facts.spell, open_loop)
            open_loop, routine = None, placed.routine
        outer = placed.loop
        if placed.effects.flow is Flow.LOOP:
            if outer is not None:
                yield finding(
                    "CG407",
                    placed.action.span,
                    f"this loop stands inside the loop of line {outer.span.line}",
                    f"CLICK has no loop in a loop: unroll one of them, or close the first with {closing} before",
                    (Label(outer.span, "the outer loop"),),
                )
            elif placed.opens_loop:
                open_loop = placed
                yield from _check_opening(facts.spell, placed)
        elif placed.effects.flow is Flow.NEXT:
            yield from _check_next(facts.spell, placed, open_loop)
            open_loop = None
        elif outer is not None and placed.effects.flow is Flow.CALL:
            yield from _check_call(facts, placed, outer)
        elif outer is not None and placed.effects.is_timed:
            yield finding(
                "CG423",
                placed.action.span,
                f"this {placed.spec.name} stands inside a loop and would run several times in a scan (C1004)",
                "move it out of the loop",
            )
    yield from _refuse_open(facts.spell, open_loop)


def _check_call(facts: Facts, call: Placed, outer: Action) -> Findings:
    """CLICK allows no loop in a loop (C0103). Whether it finds one through a call, no source says.

    click-facts [control.loops]
    """
    name = call.action.called
    loops = (each for each in facts.actions if each.effects.flow is Flow.LOOP)
    inner = next((each for each in loops if each.routine.name == name), None)
    if inner is not None:
        yield finding(
            "CG427",
            call.action.span,
            f"{name} has a loop, and this call stands in the loop of line {outer.span.line}: CLICK has no loop in a "
            "loop (C0103)",
            "move the call out of the loop, or unroll one of the two loops",
            (Label(outer.span, "the outer loop"), Label(inner.action.span, "the inner loop")),
        )


def _check_opening(spell: Spelling, placed: Placed) -> Findings:
    """What stands behind an opening for in its rung would be repeated with the loop, its condition included."""
    actions = list(actions_in(placed.rung.items))
    if actions[-1] is not placed.action:
        behind = actions[actions.index(placed.action) + 1]
        yield finding(
            "CG425",
            behind.span,
            f"this comes after the loop of line {placed.action.span.line} is opened, so the loop would repeat it",
            f"put it before the loop, into a rung of the loop, or after {spell.call(NEXT)}",
        )


def _refuse_open(spell: Spelling, loop: Placed | None) -> Findings:
    if loop is not None and loop.routine.is_whole:
        yield finding(
            "CG408",
            loop.action.span,
            f"this loop is not closed in {loop.routine.name}",
            f"put the repeated rungs into its body, or close it with {spell.rung('', spell.call(NEXT))}",
        )


def _check_next(spell: Spelling, placed: Placed, open_loop: Placed | None) -> Findings:
    span, closing = placed.action.span, spell.call(NEXT)
    if placed.in_body:
        yield finding("CG409", span, "a loop with a body closes by itself", f"leave {closing} out")
    elif open_loop is None and not placed.routine.is_whole:
        return
    elif open_loop is None:
        yield finding("CG409", span, "there is no open loop here", f"open one with {spell.loop('n')}")
    elif not placed.is_unconditional or len(placed.rung.items) != 1:
        yield finding(
            "CG422",
            span,
            f"{closing} is alone in an unconditional rung (C0009)",
            f"write {spell.rung('', closing)}",
        )


CODES = (
    Code(
        "CG407",
        Severity.ERROR,
        "a loop stands inside a loop",
        """
CLICK does not allow a loop inside a loop (C0103). Unroll one of them, or close the first with
`next_loop()` before the second.
""",
        wrong=(
            Wrong(
                """
if True:
    for _ in range(3):
        if True:
            for _ in range(2):  # <-
                if c.Run:
                    out(y[1])
""",
            ),
        ),
        right=(
            """
if True:
    for _ in range(3):
        if c.Run:
            calc("ds.Rounds + 1", ds.Rounds)
if True:
    for _ in range(2):
        if c.Run:
            calc("ds.Others + 1", ds.Others)
""",
        ),
    ),
    Code(
        "CG408",
        Severity.ERROR,
        "a loop is not closed",
        """
A loop that `pass` opens needs a rung `if True: next_loop()` in the same routine. Or write the rungs
inside the loop.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    for _ in range(3):  # <-
        pass
""",
            ),
        ),
        right=(
            """
if x[1]:
    for _ in range(3):
        pass
if c.Run:
    calc("ds.Rounds + 1", ds.Rounds)
if True:
    next_loop()
""",
        ),
    ),
    Code(
        "CG409",
        Severity.ERROR,
        "a loop is closed that is not open",
        """
There is no loop to close here, or the loop has rungs inside and closes by itself.
""",
        wrong=(
            Wrong(
                """
if True:
    next_loop()  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    for _ in range(3):
        pass
if c.Run:
    calc("ds.Rounds + 1", ds.Rounds)
if True:
    next_loop()
""",
        ),
    ),
    Code(
        "CG422",
        Severity.ERROR,
        "the end of a loop is not alone in an unconditional rung",
        """
The rung of `next_loop()` must have no condition and nothing else in it (CLICK error C0009).
""",
        wrong=(
            Wrong(
                """
if c.Run:
    for _ in range(3):
        pass
if c.Run:
    next_loop()  # <-
""",
            ),
        ),
        right=(
            """
if c.Run:
    for _ in range(3):
        pass
if c.Run:
    calc("ds.Rounds + 1", ds.Rounds)
if True:
    next_loop()
""",
        ),
    ),
    Code(
        "CG423",
        Severity.WARNING,
        "a timer stands inside a loop",
        """
The timer would run several times in one scan; CLICK also warns about this (C1004). Move it before or
after the loop.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    for _ in range(3):
        if c.Run:
            ton(t.Delay, 5)  # <-
""",
            ),
        ),
        right=(
            """
if c.Run:
    ton(t.Delay, 5)
if x[1]:
    for _ in range(3):
        if t.Delay:
            calc("ds.Rounds + 1", ds.Rounds)
""",
        ),
    ),
    Code(
        "CG425",
        Severity.ERROR,
        "an action comes after the opening of a loop in its rung",
        """
The loop would repeat the instructions that follow the `for` in its rung. Put them before the `for`, into
a rung of the loop, or after `next_loop()`.
""",
        wrong=(
            Wrong(
                """
if c.Run:
    for _ in range(3):
        pass
    out(c.Ready)  # <-
if True:
    next_loop()
""",
            ),
        ),
        right=(
            """
if c.Run:
    out(c.Ready)
    for _ in range(3):
        pass
if True:
    next_loop()
""",
        ),
    ),
    Code(
        "CG427",
        Severity.WARNING,
        "a loop calls a subroutine with a loop",
        """
CLICK does not allow a loop inside a loop (C0103). Here a loop calls a subroutine that has its own loop,
so one still runs inside the other. No source says whether CLICK refuses that or loses count of the rounds. Move the
call out of the loop, or unroll one of the loops.
""",
        wrong=(
            Wrong(
                """
@sub
def add_row():
    if True:
        for _ in range(5):
            if True:
                calc("ds.Total + 1", ds.Total)
    if True:
        return


def main():
    if c.Go:
        for _ in range(3):
            if True:
                call(add_row)  # <-
    if True:
        end()
""",
            ),
        ),
        right=(
            """
@sub
def add_row():
    if True:
        for _ in range(5):
            if True:
                calc("ds.Total + 1", ds.Total)
    if True:
        return


def main():
    if c.Go:
        call(add_row)
    if True:
        end()
""",
        ),
    ),
)

RULE = Rule(find, CODES, holds_in_parts=True)
