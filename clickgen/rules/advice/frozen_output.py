"""An output coil or a timer in a subroutine that does not run in every scan: it stays unchanged meanwhile."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.device.banks import Address, current_value
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.meanwhile import Watch
from clickgen.facts.uses import addresses_of
from clickgen.ir.conditions import Contact
from clickgen.ir.operands import Cell
from clickgen.ir.program import Routine
from clickgen.ir.reach import touches
from clickgen.logic.conditions import are_exclusive, can_hold, implies
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [scan.skipped]
CODE = "CG545"

_LABELS_MAX = 5
"""A finding names this many further places."""

_Frozen = list[tuple[Placed, Address]]


def find(facts: Facts) -> Findings:
    watch = Watch(facts)
    for routine in facts.program.subroutines:
        if routine.name not in watch.sometimes:
            continue
        outputs, timers = [*_outputs(facts, watch, routine)], [*_timers(facts, watch, routine)]
        lasting = [*_lasting_timers(facts, watch, routine)]
        if outputs:
            named = facts.listed(_bits(outputs))
            stay, left, on = ("stays", "it", "it was") if len(_bits(outputs)) == 1 else ("stay", "them", "they were")
            fault = f"while {routine.name} is not called, {named} {stay} as the last call left {left}, on if {on} on"
            help = "drive outputs in a rung that every scan looks at, or reset them where the subroutine is not called"
            yield from _report(facts, routine, outputs, fault, help)
        if timers:
            named = facts.listed(_bits(timers))
            stop, go = ("stops", "goes") if len(_bits(timers)) == 1 else ("stop", "go")
            fault = f"while {routine.name} is not called, {named} {stop}, and {go} on from there with the next call"
            help = "put the timer into a rung that every scan looks at, with the condition of the call in its own"
            yield from _report(facts, routine, timers, fault, help)
        if lasting:
            named = facts.listed(_bits(lasting))
            count, reset = ("counts", "resets") if len(_bits(lasting)) == 1 else ("count", "reset")
            fault = f"while {routine.name} is not called, {named} neither {count} nor {reset}"
            help = "put the timer into a rung that every scan looks at, with the condition of the call in its own"
            yield from _report(facts, routine, lasting, fault, help)


def _bits(frozen: _Frozen) -> list[Address]:
    return list(dict.fromkeys(bit for _, bit in frozen))


def _outputs(facts: Facts, watch: Watch, routine: Routine) -> Iterator[tuple[Placed, Address]]:
    for placed in facts.actions_of(routine):
        for bit in _driven(placed):
            if facts.uses.is_pointed(bit.bank, is_written=True) or watch.is_written_meanwhile(bit, routine):
                continue
            # It is called for as long as its output is on.
            if implies(Contact(Cell(bit, routine.span), routine.span), watch.sometimes[routine.name]):
                continue
            if bit.bank == "Y" or watch.is_felt(bit, routine) or watch.is_taken_up(bit, placed):
                yield placed, bit


def _driven(placed: Placed) -> list[Address]:
    """The bits that an out or a drum turns on and off."""
    drives = placed.effects.drives
    if drives is None or placed.action.turns is not None:
        return []
    operands = (touch.operand for touch in touches(placed.action) if touch.param.name == drives.target)
    return [bit for operand in operands for bit in addresses_of(operand)]


def _timers(facts: Facts, watch: Watch, routine: Routine) -> Iterator[tuple[Placed, Address]]:
    for placed, timer in _timers_of(facts, routine, is_retentive=False):
        bit, value = timer.address, current_value(timer.address)
        # A timer that looks at its own bit restarts by itself.
        if implies(placed.condition, Contact(timer, timer.span, negated=True)):
            continue
        is_used = bool(facts.uses.reads(bit) or facts.uses.reads(value))
        if is_used and not watch.is_stopped_meanwhile(placed):
            yield placed, bit


def _lasting_timers(facts: Facts, watch: Watch, routine: Routine) -> Iterator[tuple[Placed, Address]]:
    """The retentive timers that somebody watches while they wait, or whose reset waits for the subroutine to end."""
    when = watch.sometimes[routine.name]
    for placed, timer in _timers_of(facts, routine, is_retentive=True):
        bit, reset = timer.address, placed.action.pin(placed.effects.reset_by)
        is_felt = watch.is_felt(bit, routine) or watch.is_felt(current_value(bit), routine)
        if is_felt or (reset is not None and can_hold(reset) and are_exclusive(when, reset)):
            yield placed, bit


def _timers_of(facts: Facts, routine: Routine, is_retentive: bool) -> Iterator[tuple[Placed, Cell]]:
    """The timers of a routine whose current values nothing else writes."""
    for placed in facts.actions_of(routine):
        effects, timer = placed.effects, placed.action.owned
        is_timer = effects.is_timed and effects.done is not None and bool(effects.reset_by) is is_retentive
        if not is_timer or timer is None:
            continue
        # Any instruction that writes the current value starts it again.
        others = (one for one in facts.writers(current_value(timer.address)) if one.action is not placed.action)
        if not any(others) and not facts.uses.is_pointed("TD", is_written=True):
            yield placed, timer


def _report(facts: Facts, routine: Routine, frozen: _Frozen, fault: str, help: str) -> Findings:
    first, *others = dict.fromkeys(placed.action.span for placed, _ in frozen)
    call = facts.calls[routine.name][0].action.span
    labels = [Label(call, "called under a condition"), *(Label(span, "this one too") for span in others[:_LABELS_MAX])]
    yield finding(CODE, first, fault, help, tuple(labels))


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "an output or timer may freeze in a subroutine that does not always run",
    """
Rungs of a subroutine that is not called are not looked at. An `out` there writes nothing then, not even off: its bit
stays as the last call left it, and the motor runs on after the mode was switched. The outputs of a drum do the same. A
timer there neither counts nor resets: with the next call it goes on from where it was, or is over at once because its
bit never went off.

Drive outputs in a rung that every scan looks at, from bits that tell what the subroutine wants and that are reset where
it is not called. Put the timer beside the call, with the condition of the call in its rung.

The rule goes by the harm:

- A Y stays on, whoever looks at it.
- A C bit matters where a rung looks at it while the subroutine is not called, and where nothing in the program reads
  it: then it is for a panel. A bit that only its own subroutine reads matters where the next call looks at it before it
  is written again. A coil that seals itself in then starts by itself.
- `ton` and `tof` go on from where they were, which makes the next delay too short, also where only their own subroutine
  reads them.
- `rton` and `rtof` are meant to wait. They matter where something outside looks at them, because their reset does not
  work in the meantime, and where the reset is one that never comes while the subroutine is called.

The rule is silent where something outside writes the bit while the subroutine is not called, such as a `reset` in main,
or writes the current value of the timer; where the subroutine resets the bit and ends its own calls; where something
outside turns off what a `ton` waits for; where the bit itself keeps the subroutine called; and about a timer that
restarts itself.
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
        Wrong(
            """
def main():
    if c.Auto:
        call(automatic)
    if all(c.Auto, c.Running):
        out(y.Motor)
    if t.Worn:
        out(y.Lamp)
    if True:
        end()


@sub
def automatic():
    if all(any(x.Start, c.Running), x.Stop):
        out(c.Running)  # <-
        out(c[101:105])
    if all(c.Running, x.Part):
        ton(t.Jam, 5, Ts)  # <-
    if t.Jam:
        set(c.Jammed)
    if c.Running:
        rton(t.Worn, 100, unit=Th).reset(x.Serviced)  # <-
    if True:
        return
"""
        ),
        Wrong(
            """
def main():
    if c.Wash:
        call(wash)
    if True:
        end()


@sub
def wash():
    if True:
        event_drum(  # <-
            outputs=[y.Fill, y.Drain],
            events=[x.Full, x.Empty],
            pattern=[[1, 0], [0, 1]],
            current_step=ds.Step,
            completion_flag=c.Washed,
            reset=lambda: c.Again,
        )
    if c.Washed:
        rton(t.Rest, 30, unit=Tm).reset(nc(c.Wash))  # <-
    if t.Rest:
        set(c.Rested)
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
        copy(0, ds.Step)
    if c.MotorWanted:
        out(y.Motor)
    if all(c.Auto, c.LampWanted):
        out(y.Lamp)
    if True:
        end()


@sub
def automatic():
    if c.Run:
        out(c.MotorWanted)
        out(c.LampWanted)
    if x.Part:
        out(c.Seen)
    if all(c.Seen, c.Run):
        copy(3, ds.Step)
    if ds.Step == 3:
        out(c.Heating)
    if c.Heating:
        ton(t.Heat, 5, Ts)
        rton(t.Hours, 100, unit=Th).reset(x.Serviced)
    if t.Heat:
        set(c.Heated)
    if t.Hours:
        set(c.Worn)
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

RULE = Rule(find, (ABOUT,))
