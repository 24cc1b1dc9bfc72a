"""Loops are closed, are in no other loop, and close in a rung of their own (C0103, C0009).

click-facts [control.loops, control.next, timer.in-loop]
"""

from __future__ import annotations

from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Flow
from clickgen.ir.program import Action, Routine, actions_in
from clickgen.problems.diagnostics import Diagnostics, Label


def check(facts: Facts, problems: Diagnostics) -> None:
    open_loop: Placed | None = None
    routine: Routine | None = None
    for placed in facts.actions:
        if placed.routine is not routine:
            _refuse_open(open_loop, problems)
            open_loop, routine = None, placed.routine
        outer = placed.loop
        if placed.effects.flow is Flow.LOOP:
            if outer is not None:
                problems.add(
                    "CG407",
                    placed.action.span,
                    f"this loop stands inside the loop of line {outer.span.line}",
                    "CLICK has no loop in a loop: unroll one of them, or close the first with next_loop() before",
                    (Label(outer.span, "the outer loop"),),
                )
            elif placed.opens_loop:
                open_loop = placed
                _check_opening(placed, problems)
        elif placed.effects.flow is Flow.NEXT:
            _check_next(placed, open_loop, problems)
            open_loop = None
        elif outer is not None and placed.effects.flow is Flow.CALL:
            _check_call(facts, placed, outer, problems)
        elif outer is not None and placed.effects.is_timed:
            problems.add(
                "CG423",
                placed.action.span,
                f"this {placed.spec.name} stands inside a loop and would run several times in a scan (C1004)",
                "move it out of the loop",
            )
    _refuse_open(open_loop, problems)


def _check_call(facts: Facts, call: Placed, outer: Action, problems: Diagnostics) -> None:
    """CLICK allows no loop in a loop (C0103). Whether it finds one through a call, no source says.

    click-facts [control.loops]
    """
    name = call.action.called
    loops = (each for each in facts.actions if each.effects.flow is Flow.LOOP)
    inner = next((each for each in loops if each.routine.name == name), None)
    if inner is not None:
        problems.add(
            "CG427",
            call.action.span,
            f"{name} has a loop, and this call stands in the loop of line {outer.span.line}: CLICK has no loop in a "
            "loop (C0103)",
            "move the call out of the loop, or unroll one of the two loops",
            (Label(outer.span, "the outer loop"), Label(inner.action.span, "the inner loop")),
        )


def _check_opening(placed: Placed, problems: Diagnostics) -> None:
    """What stands behind an opening for in its rung would be repeated with the loop, its condition included."""
    actions = list(actions_in(placed.rung.items))
    if actions[-1] is not placed.action:
        behind = actions[actions.index(placed.action) + 1]
        problems.add(
            "CG425",
            behind.span,
            f"this stands behind the for of line {placed.action.span.line}, so the loop would repeat it",
            "put it before the for, into a rung of the loop, or behind next_loop()",
        )


def _refuse_open(loop: Placed | None, problems: Diagnostics) -> None:
    if loop is not None and loop.routine.is_whole:
        problems.add(
            "CG408",
            loop.action.span,
            f"this loop is not closed in {loop.routine.name}",
            "put the repeated rungs into its body, or close it with if True: next_loop()",
        )


def _check_next(placed: Placed, open_loop: Placed | None, problems: Diagnostics) -> None:
    span = placed.action.span
    if placed.in_body:
        problems.add("CG409", span, "a loop with a body closes by itself", "leave next_loop() out")
    elif open_loop is None and not placed.routine.is_whole:
        return
    elif open_loop is None:
        problems.add("CG409", span, "there is no open loop here", "open one with for _ in range(n): pass")
    elif not placed.is_unconditional or len(placed.rung.items) != 1:
        problems.add(
            "CG422", span, "next_loop() stands alone in an unconditional rung (C0009)", "write if True: next_loop()"
        )
