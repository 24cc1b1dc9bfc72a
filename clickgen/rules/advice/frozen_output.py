"""An output coil or a timer in a subroutine that does not run in every scan: it stays as it is while nobody looks."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from clickgen.device.banks import Address, current_value
from clickgen.device.system import ALWAYS_ON
from clickgen.facts.facts import Facts, Placed, Site
from clickgen.facts.uses import addresses_of
from clickgen.instructions.coils import OUT
from clickgen.instructions.timers import TOF, TON
from clickgen.ir.conditions import All, Always, Any, Condition, Contact
from clickgen.ir.operands import Cell
from clickgen.ir.program import Routine
from clickgen.ir.walk import condition_operands
from clickgen.logic.conditions import implies
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.rules.rule import Rule, Wrong

# click-facts [scan.skipped]
CODE = "CG545"

_LABELS_MAX = 5
"""So many further places a finding names."""

_Frozen = list[tuple[Placed, Address]]


def check(facts: Facts, problems: Diagnostics) -> None:
    watch = _Watch(facts)
    for routine in facts.program.subroutines:
        if routine.name not in watch.sometimes:
            continue
        outputs, timers = [*_outputs(facts, watch, routine)], [*_timers(facts, watch, routine)]
        if outputs:
            named = facts.listed(_bits(outputs))
            stay, left, on = ("stays", "it", "it was") if len(_bits(outputs)) == 1 else ("stay", "them", "they were")
            fault = f"while {routine.name} is not called, {named} {stay} as the last call left {left}, on if {on} on"
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


def _outputs(facts: Facts, watch: _Watch, routine: Routine) -> Iterator[tuple[Placed, Address]]:
    for placed in facts.actions_of(routine):
        if placed.spec is not OUT:
            continue
        for bit in addresses_of(placed.action.args["address"]):
            # Whoever else writes it may turn it off.
            writers = facts.writers(bit)
            if any(one.spec is not OUT or one.routine is not routine for one in writers):
                continue
            # It is called for as long as its output is on.
            is_held = implies(Contact(Cell(bit, routine.span), routine.span), watch.sometimes[routine.name])
            if is_held or facts.uses.is_pointed(bit.bank, is_written=True):
                continue
            if bit.bank == "Y" or watch.is_felt(bit, routine):
                yield placed, bit


def _timers(facts: Facts, watch: _Watch, routine: Routine) -> Iterator[tuple[Placed, Address]]:
    when = watch.sometimes[routine.name]
    for placed in facts.actions_of(routine):
        timer = placed.action.args.get("timer")
        if placed.spec not in (TON, TOF) or not isinstance(timer, Cell):
            continue
        bit, value = timer.address, current_value(timer.address)
        # Whoever writes the current value starts it anew; a timer that looks at its own bit restarts by itself.
        if any(one.action is not placed.action for one in facts.writers(value)):
            continue
        is_own_reset = implies(placed.condition, Contact(timer, timer.span, negated=True))
        if is_own_reset or facts.uses.is_pointed("TD", is_written=True):
            continue
        starts_with_call = placed.spec is TON and (placed.is_unconditional or implies(when, placed.condition))
        is_used = bool(facts.uses.reads(bit) or facts.uses.reads(value))
        if (starts_with_call and is_used) or watch.is_felt(bit, routine) or watch.is_felt(value, routine):
            yield placed, bit


class _Watch:
    """Who feels it that a bit or value stands still while a subroutine is not called."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        found = ((routine.name, facts.sometimes(routine)) for routine in facts.program.subroutines)
        self.sometimes: dict[str, Any] = {name: condition for name, condition in found if condition}
        """When each subroutine is called that is not called in every scan."""
        self._sites: dict[Address, list[Site]] = defaultdict(list)
        for site in facts.sites:
            for address in {one for operand in condition_operands(site.condition) for one in addresses_of(operand)}:
                self._sites[address].append(site)

    def is_felt(self, address: Address, routine: Routine) -> bool:
        """True where something outside the subroutine looks at an address also while the subroutine is not called."""
        when = self.sometimes[routine.name]
        for use in self._facts.uses.reads(address):
            if use.routine is not routine and use.leaf is None:
                placed = self._facts.place_of(use.action) if use.action else None
                if placed is None or not implies(All(self._way(placed.routine, placed.condition), routine.span), when):
                    return True
        return any(
            site.routine is not routine and self._makes_a_difference(address, site, when)
            for site in self._sites.get(address, ())
        )

    def _makes_a_difference(self, address: Address, site: Site, when: Any) -> bool:
        way = All(self._way(site.routine, *site.above, site.condition), site.condition.span)
        if implies(way, when):
            return False
        on, off = _with(way, address, True), _with(way, address, False)
        if on is None or off is None:
            return True
        return not implies(on, Any((when, off), way.span)) or not implies(off, Any((when, on), way.span))

    def _way(self, routine: Routine, *conditions: Condition) -> tuple[Condition, ...]:
        call = self.sometimes.get(routine.name)
        return (*conditions, call) if call else conditions


def _with(condition: Condition, bit: Address, is_on: bool) -> Condition | None:
    """A condition with a bit that stands still, on or off; None where it looks at the address as a value."""
    if isinstance(condition, All | Any):
        terms = [_with(term, bit, is_on) for term in condition.terms]
        known = [term for term in terms if term is not None]
        return type(condition)(tuple(known), condition.span) if len(known) == len(terms) else None
    if not any(bit in addresses_of(operand) for operand in condition_operands(condition)):
        return condition
    if not isinstance(condition, Contact) or not isinstance(condition.operand, Cell):
        return None
    if not condition.edge and is_on is not condition.negated:
        return Always(condition.span)
    return Contact(Cell(ALWAYS_ON, condition.span), condition.span, negated=True)


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
