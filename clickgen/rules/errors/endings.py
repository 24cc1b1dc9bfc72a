"""main has an unconditional end() (C0201); each subroutine ends in an unconditional return (C0105).

click-facts [control.end, control.return]
"""

from __future__ import annotations

from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Flow
from clickgen.instructions.offered import END, RETURN
from clickgen.ir.program import Routine
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.edits import Edit, Fix


def find(facts: Facts) -> Findings:
    ended: set[int] = set()
    end, leave = facts.spell.call(END), facts.spell.call(RETURN)
    closed = {id(placed.loop) for placed in facts.actions if placed.effects.flow is Flow.NEXT}
    for placed in facts.actions:
        routine = placed.routine
        if placed.effects.flow is Flow.END:
            if not routine.is_main:
                message = f"{end} belongs in main; a subroutine ends in {leave}"
                yield finding("CG410", placed.action.span, message, f"write {leave}")
            elif placed.is_unconditional and _is_reached(placed, closed):
                ended.add(id(routine))
        elif placed.effects.flow is Flow.RETURN:
            if routine.is_main:
                message = f"{leave} belongs in a subroutine; main ends in {end}"
                yield finding("CG411", placed.action.span, message, f"write {end}")
            elif placed.is_unconditional and _is_reached(placed, closed) and placed.rung is routine.rungs[-1]:
                ended.add(id(routine))
    for routine in facts.program.routines:
        if id(routine) in ended or not routine.is_whole:
            continue
        if routine.is_main:
            help = f"add at its end: {facts.spell.rung('', end)}"
            fix = _added(facts, routine, end)
            yield finding("CG403", routine.span, f"main has no unconditional {end}", help, fix=fix)
        else:
            yield finding(
                "CG404",
                routine.span,
                f"{routine.name} does not end in an unconditional {leave}",
                f"add as its last rung: {facts.spell.rung('', leave)}",
                fix=_added(facts, routine, leave),
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
    if facts.spell.goes_on(source.line(last.end_line)):
        return None
    indent = source.line(last.line)[: last.col - 1]
    # A blank line goes in front where the rungs before have one between them.
    between = range(routine.rungs[-2].span.end_line + 1, last.line) if len(routine.rungs) > 1 else ()
    blank = "\n" if any(not source.line(line).strip() for line in between) else ""
    col = len(source.line(last.end_line)) + 1
    place = source.span(last.end_line, col, last.end_line, col)
    return Fix((Edit(place, f"\n{blank}{facts.spell.rung_at(indent, action)}"),))


CODES = (
    Code(
        "CG403",
        Severity.ERROR,
        "main has no unconditional end",
        """
The main program needs an `end()` without a condition (CLICK error C0201). Put it at the end.
""",
        wrong=(
            Wrong(
                """
def main():  # <-
    if c.Run:
        end()
""",
                """
def main():  # <-
    if c.Run:
        end()
    if True:
        end()
""",
            ),
        ),
        right=(
            """
def main():
    if c.Run:
        out(y[1])
    if True:
        end()
""",
        ),
    ),
    Code(
        "CG404",
        Severity.ERROR,
        "a subroutine does not end in an unconditional return",
        """
The last rung of a subroutine must be an unconditional `return` (CLICK error C0105).
""",
        wrong=(
            Wrong(
                """
@sub
def alarms():  # <-
    if c.Run:
        return


def main():
    if True:
        call(alarms)
        end()
""",
                """
@sub
def alarms():  # <-
    if c.Run:
        return
    if True:
        return


def main():
    if True:
        call(alarms)
        end()
""",
            ),
        ),
        right=(
            """
@sub
def alarms():
    if c.Run:
        return
    if True:
        return


def main():
    if True:
        call(alarms)
    if True:
        end()
""",
        ),
    ),
    Code(
        "CG410",
        Severity.ERROR,
        "end belongs in main",
        """
Use `return` to go back from a subroutine.
""",
        wrong=(
            Wrong(
                """
@sub
def alarms():
    if c.Run:
        end()  # <-
    if True:
        return


def main():
    if True:
        call(alarms)
        end()
""",
            ),
        ),
        right=(
            """
@sub
def alarms():
    if c.Run:
        return
    if True:
        return


def main():
    if True:
        call(alarms)
    if True:
        end()
""",
        ),
    ),
    Code(
        "CG411",
        Severity.ERROR,
        "return belongs in a subroutine",
        """
Use `end()` to end the scan in main.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    return  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    end()
""",
        ),
    ),
)

RULE = Rule(find, CODES, holds_in_parts=True)
