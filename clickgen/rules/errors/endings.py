"""main has an unconditional end() (C0201); each subroutine ends in an unconditional return (C0105).

click-facts [control.end, control.return]
"""

from __future__ import annotations

from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Flow
from clickgen.ir.program import Routine
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.edits import Edit, Fix


def check(facts: Facts, problems: Diagnostics) -> None:
    ended: set[int] = set()
    closed = {id(placed.loop) for placed in facts.actions if placed.effects.flow is Flow.NEXT}
    for placed in facts.actions:
        routine = placed.routine
        if placed.effects.flow is Flow.END:
            if not routine.is_main:
                problems.add(
                    "CG410", placed.action.span, "end() belongs in main; a subroutine ends in return", "write return"
                )
            elif placed.is_unconditional and _is_reached(placed, closed):
                ended.add(id(routine))
        elif placed.effects.flow is Flow.RETURN:
            if routine.is_main:
                problems.add(
                    "CG411", placed.action.span, "return belongs in a subroutine; main ends in end()", "write end()"
                )
            elif placed.is_unconditional and _is_reached(placed, closed) and placed.rung is routine.rungs[-1]:
                ended.add(id(routine))
    for routine in facts.program.routines:
        if id(routine) in ended or not routine.is_whole:
            continue
        if routine.is_main:
            help = "add at its end: if True: end()"
            fix = _added(facts, routine, "end()")
            problems.add("CG403", routine.span, "main has no unconditional end()", help, fix=fix)
        else:
            problems.add(
                "CG404",
                routine.span,
                f"{routine.name} does not end in an unconditional return",
                "add as its last rung: if True: return",
                fix=_added(facts, routine, "return"),
            )


def _is_reached(placed: Placed, closed: set[int]) -> bool:
    """True outside of loops, which may run no times; a loop that nothing closes is CG408's."""
    return placed.loop is None or not (placed.in_body or id(placed.loop) in closed)


def _added(facts: Facts, routine: Routine, action: str) -> Fix | None:
    """A last rung with this action; None in a routine without rungs, and where it does not fit below the last one."""
    source = facts.sources.get(routine.span.path, facts.program.source)
    if not routine.rungs or source.path != routine.span.path:
        return None
    last = routine.rungs[-1].span
    if source.line(last.end_line).endswith("\\"):
        return None  # Python would read the new rung as the rest of that line.
    indent = source.line(last.line)[: last.col - 1]
    # A blank line goes in front where the rungs before have one between them.
    between = range(routine.rungs[-2].span.end_line + 1, last.line) if len(routine.rungs) > 1 else ()
    blank = "\n" if any(not source.line(line).strip() for line in between) else ""
    col = len(source.line(last.end_line)) + 1
    place = source.span(last.end_line, col, last.end_line, col)
    return Fix((Edit(place, f"\n{blank}{indent}if True:\n{indent * 2}{action}"),))
