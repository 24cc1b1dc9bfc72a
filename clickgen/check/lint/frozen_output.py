"""An output coil or a timer in a subroutine that does not run in every scan: it stays as it is while nobody looks."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.check.facts import Facts, Placed
from clickgen.check.rule import Rule, Wrong
from clickgen.check.uses import Use, addresses_of
from clickgen.device.banks import Address, current_value
from clickgen.diagnostics import Diagnostics, Label
from clickgen.instructions.coils import OUT
from clickgen.instructions.timers import TOF, TON
from clickgen.ir.conditions import Any, Contact
from clickgen.ir.logic import implies
from clickgen.ir.operands import Cell
from clickgen.ir.program import Routine

CODE = "CG545"

_LABELS_MAX = 5
"""So many further places a finding names."""

_Frozen = list[tuple[Placed, Address]]


def check(facts: Facts, problems: Diagnostics) -> None:
    sometimes = {
        routine.name: condition for routine in facts.program.subroutines if (condition := facts.sometimes(routine))
    }
    for routine in facts.program.subroutines:
        when = sometimes.get(routine.name)
        if when is None:
            continue
        outputs = [*_outputs(facts, routine, when, sometimes)]
        timers = [*_timers(facts, routine, when, sometimes)]
        if outputs:
            named = facts.listed(_bits(outputs))
            stay, left = ("stays", "it") if len(_bits(outputs)) == 1 else ("stay", "them")
            fault = f"while {routine.name} is not called, {named} {stay} as the last call left {left}, on if it was on"
            help = "drive outputs in a rung that every scan looks at, or reset them where the subroutine is not called"
            _report(facts, problems, routine, outputs, fault, help)
        if timers:
            named = facts.listed(_bits(timers))
            stand, go = ("stands", "goes") if len(_bits(timers)) == 1 else ("stand", "go")
            fault = (
                f"while {routine.name} is not called, {named} {stand} still, and {go} on from there with the next call"
            )
            help = "put the timer into a rung that every scan looks at, with the condition of the call in its own"
            _report(facts, problems, routine, timers, fault, help)


def _bits(frozen: _Frozen) -> list[Address]:
    return list(dict.fromkeys(bit for _, bit in frozen))


def _outputs(facts: Facts, routine: Routine, when: Any, sometimes: dict[str, Any]) -> Iterator[tuple[Placed, Address]]:
    for placed in facts.actions:
        if placed.routine is not routine or placed.spec is not OUT:
            continue
        for bit in addresses_of(placed.action.args["address"]):
            # Whoever else writes it may turn it off.
            writers = facts.writers(bit)
            if facts.uses.is_pointed(bit.bank, True) or any(
                one.spec is not OUT or one.routine is not routine for one in writers
            ):
                continue
            # It is called for as long as its output is on.
            if implies(Contact(Cell(bit, routine.span), routine.span), when):
                continue
            if bit.bank == "Y" or any(_looks_alone(use, routine, when, sometimes) for use in facts.uses.reads(bit)):
                yield placed, bit


def _timers(facts: Facts, routine: Routine, when: Any, sometimes: dict[str, Any]) -> Iterator[tuple[Placed, Address]]:
    for placed in facts.actions:
        if placed.routine is not routine or placed.spec not in (TON, TOF):
            continue
        timer = placed.action.args["timer"]
        if not isinstance(timer, Cell):
            continue
        bit, value = timer.address, current_value(timer.address)
        uses = [*facts.uses.reads(bit), *facts.uses.reads(value)]
        # Whoever writes the current value starts it anew; a timer that looks at its own bit restarts by itself.
        if any(one.action is not placed.action for one in facts.writers(value)) or facts.uses.is_pointed("TD", True):
            continue
        if implies(placed.condition, Contact(timer, timer.span, negated=True)):
            continue
        starts_on = placed.spec is TON and (placed.is_unconditional or implies(when, placed.condition))
        if uses and (starts_on or any(_looks_alone(use, routine, when, sometimes) for use in uses)):
            yield placed, bit


def _looks_alone(use: Use, routine: Routine, when: Any, sometimes: dict[str, Any]) -> bool:
    """True where something looks at a bit or value also in scans in which the subroutine does not run."""
    if use.routine is routine:
        return False
    other = sometimes.get(use.routine.name)
    return other is None or not implies(other, when)


def _report(facts: Facts, problems: Diagnostics, routine: Routine, frozen: _Frozen, fault: str, help: str) -> None:
    first, *others = dict.fromkeys(placed.action.span for placed, _ in frozen)
    call = facts.calls[routine.name][0].action.span
    labels = [Label(call, "called under a condition"), *(Label(span, "this one too") for span in others[:_LABELS_MAX])]
    problems.add(CODE, first, fault, help, tuple(labels))


RULE = Rule(
    CODE,
    check,
    """
Rungs of a subroutine that is not called are not looked at. An `out` there writes nothing then, not even off: its bit
stays as the last call left it, and the motor runs on after the mode was switched. A timer there neither counts nor
resets: with the next call it goes on from where it was, or is over at once because its bit never went off.

Drive outputs in a rung that every scan looks at, from bits that tell what the subroutine wants and that are reset where
it is not called. Put the timer beside the call, with the condition of the call in its rung.

The rule is silent where anything else writes the bit, such as a `reset` in main or another subroutine with an `out`, or
writes the current value of the timer, and where the bit itself keeps the subroutine called. It is silent about C bits
and timers that only the subroutine looks at, unless the timer starts with the call; about retentive timers, which are
meant to wait; and about a timer that restarts itself.
""",
    wrong=(
        Wrong(
            """
def main():
    if c.Auto:
        call(automatic)
    if True:
        end()


@sub
def automatic():
    if c.Run:
        out(y.Motor)  # <-
        out(y.Lamp)
    if True:
        return
"""
        ),
        Wrong(
            """
def main():
    if ds.Step == 3:
        call(soak)
    if c.Soaking:
        out(y.Heater)
    if True:
        end()


@sub
def soak():
    if True:
        out(c.Soaking)  # <-
        ton(t.Soak, 30, Ts)  # <-
    if t.Soak:
        copy(4, ds.Step)
    if True:
        return
"""
        ),
    ),
    right=(
        """
def main():
    if c.Auto:
        call(automatic)
    if nc(c.Auto):
        reset(c.MotorWanted)
    if c.MotorWanted:
        out(y.Motor)
    if True:
        end()


@sub
def automatic():
    if c.Run:
        out(c.MotorWanted)
    if x.Part:
        out(c.Seen)
    if all(c.Seen, c.Run):
        ton(t.Jam, 5, Ts)
    if t.Jam:
        set(c.Jammed)
    if True:
        return
""",
        """
def main():
    if ds.Step == 3:
        ton(t.Soak, 30, Ts)
        call(soak)
    if all(ds.Step == 3, t.Soak):
        copy(4, ds.Step)
    if True:
        end()


@sub
def soak():
    if x.Low:
        set(y.Valve)
    if x.High:
        reset(y.Valve)
    if True:
        return
""",
        """
def main():
    if any(c.Call, y.Pump):
        call(pump)
    if ds.Mode == 1:
        call(day)
    if ds.Mode != 1:
        call(night)
    if True:
        end()


@sub
def pump():
    if all(c.Call, x.Level):
        out(y.Pump)
    if True:
        return


@sub
def day():
    if c.DayLamp:
        out(y.Lamp)
    if True:
        return


@sub
def night():
    if c.NightLamp:
        out(y.Lamp)
    if True:
        return
""",
    ),
)
