"""A subroutine that runs twice in one scan but holds things that must run once: timers, counters, edges, one-shots."""

from __future__ import annotations

from itertools import combinations

from clickgen.facts.facts import Facts, Placed
from clickgen.ir.conditions import Contact
from clickgen.ir.program import Routine
from clickgen.ir.walk import leaves
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

CODE = "CG527"


def find(facts: Facts) -> Findings:
    for routine in facts.program.subroutines:
        again = _second_run(facts, facts.calls.get(routine.name, ()))
        held = _once(facts, routine) if again else None
        if again and held:
            call, other = again
            span, what = held
            yield finding(
                CODE,
                call.action.span,
                f"{routine.name} may run more than once in a scan, and {what}",
                f"call it in one rung, with {facts.spell.some('...')} of the conditions, or give each place a "
                "subroutine of its own"
                if not call.loop
                else "call it outside the loop, or move what must run once out of the subroutine",
                (Label(other, "the loop" if call.loop else "called here too"), Label(span, "this one")),
            )


def _second_run(facts: Facts, calls: tuple[Placed, ...]) -> tuple[Placed, Span] | None:
    """A call that may run the subroutine once more in a scan, and the loop or the earlier call that causes it."""
    for call in calls:
        if call.loop:
            return call, call.loop.span
    for first, second in combinations(calls, 2):
        if not facts.exclude_each_other(first, second):
            return second, first.action.span
    return None


def _once(facts: Facts, routine: Routine) -> tuple[Span, str] | None:
    """The first thing in a routine that must run once in a scan, and its effect otherwise."""
    for placed in facts.actions:
        if placed.routine is routine:
            if placed.effects.keeps:
                return placed.action.span, f"each run may advance its {placed.spec.name}"
            if placed.action.flag("oneshot"):
                return placed.action.span, f"only one run does its one-shot {placed.spec.name}"
    for site in facts.sites:
        if site.routine is routine:
            for leaf in leaves(site.condition):
                if isinstance(leaf, Contact) and leaf.edge:
                    return leaf.span, f"only one run sees {facts.described(leaf)}"
    return None


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a subroutine with timers or edges may run twice in a scan",
    """
A subroutine keeps one memory, however often it is called. When two calls run in one scan, or a call is in a loop, a
timer in it may add the time of the scan twice, a counter may count twice, and an edge or a one-shot is there for the
first of the runs and gone for the others. It is the fault of a timer inside a loop (CG423) by another door.

A subroutine is no function block with data of its own. Call it once, with `any(...)` of the conditions, or give each
motor a subroutine with timers of its own. Calls that exclude each other, such as those of the steps of one sequence,
are left alone.
""",
    wrong=(
        Wrong(
            """
def main():
    if x.Start:
        call(home)
    if c.AlarmReset:
        call(home)  # <-
    if c.Many:
        for _ in range(3):
            if c.Auto:
                call(step)  # <-
    if True:
        end()


@sub
def home():
    if nc(x.Home):
        ton(t.TooLong, setpoint=5, unit=Ts)
    if True:
        return


@sub
def step():
    if re(x.Part):
        set(c.There)
    if True:
        return
"""
        ),
    ),
    right=(
        """
def main():
    if any(x.Start, c.AlarmReset):
        call(home)
    if ds.Step == 1:
        call(move)
    if ds.Step == 2:
        call(move)
    if x.Left:
        call(note)
    if x.Right:
        call(note)
    if True:
        end()


@sub
def home():
    if nc(x.Home):
        ton(t.TooLong, setpoint=5, unit=Ts)
    if True:
        return


@sub
def move():
    if re(x.Part):
        set(c.There)
    if True:
        return


@sub
def note():
    if x.Seen:
        copy(ds.Place, ds.Noted)
    if True:
        return
""",
    ),
)

RULE = Rule(find, (ABOUT,))
