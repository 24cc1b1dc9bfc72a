"""Rungs and actions after an end() or return that leaves before them whenever they could run."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.facts.idle import Missed, unreached
from clickgen.instructions.effects import Flow
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [scan.skipped]
CODE = "CG516"

_IDLE = (Flow.END, Flow.RETURN, Flow.PASS)
"""Instructions that nobody misses: a routine may end twice, and end in a note."""


def find(facts: Facts) -> Findings:
    for routine in facts.program.routines:
        said: set[int] = set()
        for missed in unreached(routine.rungs):
            if missed.action.effects.flow in _IDLE or id(missed.left) in said:
                continue
            said.add(id(missed.left))
            yield from _report(facts, missed)


def _report(facts: Facts, missed: Missed) -> Findings:
    left, place = missed.left, missed.action.span if missed.is_rung_reached else missed.rung.head
    word = facts.spell.call(left.spec)
    line = left.span.seen_from(place)
    if missed.is_looked_at:
        what = "this never turns anything on" if missed.action.effects.follows_power else "this never runs"
        yield finding(
            CODE,
            place,
            f"{what}: whenever its rung is on, the {word} of {line} leaves before it",
            f"move the {word} after it, or give the {word} a condition of its own",
            (Label(left.span, "leaves here whenever the rung is on"),),
        )
        return
    what = "this is" if missed.is_rung_reached else "this rung is"
    yield finding(
        CODE,
        place,
        f"{what} never reached: the {word} of {line} always leaves before it",
        f"move the {word} after it, give it a condition, or remove what comes after the {word}",
        (Label(left.span, "always leaves here"),),
    )


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a rung is never reached",
    """
An `end()` in main, or a `return` in a subroutine, that has no condition, or only the contact that is always
on, ends the routine in every scan. What comes after it is in the CLICK but never runs: its outputs stay as they were,
its timers stop. Mostly an `end()` from a test was left in, or new rungs were added below the last one.

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
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
