"""A bit that out drives and that set or reset latches: out writes it in every scan, so the latch does not hold."""

from __future__ import annotations

from collections import defaultdict
from functools import cached_property
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.facts import STARTING, Facts, Placed
from clickgen.facts.idle import never_run
from clickgen.facts.pulses import Pulses
from clickgen.facts.uses import addresses_of
from clickgen.ir.operands import Cell, Immediate, form_of
from clickgen.ir.walk import condition_operands
from clickgen.logic.conditions import are_exclusive, implies, looked_at
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG543"

_MANY = 100
"""If one bit has more coils or latches than this, the rest is not compared."""


class _Latch(NamedTuple):
    """A set or reset of a bit, with its place among all actions of the program."""

    placed: Placed
    at: int
    is_range: bool
    """True if it is one of several bits that one instruction sets or resets."""


class _Loss(NamedTuple):
    """A latch that a coil undoes."""

    bit: Address
    coil: Placed
    latch: Placed
    is_later: bool
    """True if the latch comes after the coil."""
    is_held: bool
    """True for a reset that works for as long as its rung is on."""


def find(facts: Facts) -> Findings:
    coils: dict[Address, list[tuple[Placed, int]]] = defaultdict(list)
    idle = never_run(facts)
    for at, placed in enumerate(facts.actions):
        if placed.effects.follows_power and id(placed.action) not in idle:
            for bit in addresses_of(placed.action.driven):
                coils[bit].append((placed, at))
    latches: dict[Address, list[_Latch]] = defaultdict(list)
    for at, placed in enumerate(facts.actions):
        if placed.action.turns is not None and id(placed.action) not in idle:
            bits = addresses_of(placed.action.driven)
            for bit in bits:
                if bit in coils:
                    latches[bit].append(_Latch(placed, at, len(bits) > 1))
    judge = _Judge(facts)
    # A range is reported once, with all bits in which it is undone, a single bit once with each coil.
    losses: dict[tuple[int, ...], list[_Loss]] = defaultdict(list)
    for bit, own in coils.items():
        for coil, at in own[:_MANY] if bit in latches else ():
            for latch in latches[bit][:_MANY]:
                loss = judge.loss(bit, coil, at, latch)
                if loss is not None:
                    action = id(latch.placed.action)
                    losses[(action,) if latch.is_range else (action, id(coil.action))].append(loss)
                    break
    for group in losses.values():
        yield from _report(facts, group)


class _Judge:
    """Decides which latches a coil undoes."""

    def __init__(self, facts: Facts) -> None:
        self._facts, self._pulses = facts, Pulses(facts)
        self._reset: dict[Address, bool] = {}

    def loss(self, bit: Address, coil: Placed, at: int, latch: _Latch) -> _Loss | None:
        """How out undoes the latch, in the same scan or in a later one; None if the two work together."""
        facts, placed = self._facts, latch.placed
        if placed.depends_only_on(STARTING) or not self._runs_with(coil, placed):
            return None
        # A coil that seals itself in keeps what the latch did.
        if any(bit in addresses_of(operand) for way in facts.ways_to(coil) for operand in condition_operands(way)):
            return None
        loss = _Loss(bit, coil, placed, latch.at > at, False)
        is_short = self._has_pulse(placed)
        if latch.at < at:
            is_lost = placed.action.turns or not latch.is_range or bit.bank == "Y" or not self._serves_others(placed)
        elif placed.action.turns:
            # Below the coil a level overrides it for as long as it is there: a lamp test.
            is_lost = is_short or not latch.is_range or self._is_reset(bit)
        else:
            is_lost = is_short
            if not is_short and not latch.is_range and self._is_by_inputs(placed) and not self._has_pulse(coil):
                is_answered = are_exclusive(placed.condition, *facts.ways_to(coil)) or self._is_answered(coil, placed)
                is_lost = not is_answered
                loss = loss._replace(is_held=True)
        return loss if is_lost else None

    def _is_answered(self, coil: Placed, latch: Placed) -> bool:
        """True if whatever turns the coil off also removes what the coil waits for: it does not come on again."""
        for address in looked_at(coil.condition):
            for writer in self._facts.writers(address) if isinstance(address, Address) else ():
                turns_on = writer.effects.follows_power or writer.action.turns
                if not turns_on and implies(latch.condition, writer.condition):
                    return True
        return False

    def _runs_with(self, coil: Placed, placed: Placed) -> bool:
        """True if both are in one routine, or if the coil runs in every scan and the latch may run in the same.

        CG522 reports an output that several routines drive. A reset in another routine turns off what a subroutine
        that is no longer called has left on.
        """
        facts = self._facts
        if coil.routine is placed.routine:
            return coil.routine.name not in facts.left_early
        if addresses_of(coil.action.driven)[0].bank == "Y" or facts.sometimes(coil.routine) is not None:
            return False
        return (placed.action.turns or self._has_pulse(placed)) and not facts.run_apart(coil.routine, placed.routine)

    def _has_pulse(self, placed: Placed) -> bool:
        return self._pulses.has(placed.condition, placed.routine)

    def _is_by_inputs(self, placed: Placed) -> bool:
        """True for a condition of inputs alone: the rung goes off when the button is let go."""
        operands = list(condition_operands(self._facts.seen_through(placed.condition)))
        return bool(operands) and all(form_of(operand) == "X" for operand in operands)

    def _is_reset(self, bit: Address) -> bool:
        """True if something resets this bit alone."""
        if bit not in self._reset:
            resets = (one for one in self._facts.writers(bit) if one.action.turns is False)
            alone = (one for one in resets if isinstance(_target(one), Cell))
            self._reset[bit] = any(not one.depends_only_on(STARTING) for one in alone)
        return self._reset[bit]

    def _serves_others(self, reset: Placed) -> bool:
        """True if a reset of a range has bits to turn off that something other than out turns on."""
        return not self._latched.isdisjoint(addresses_of(reset.action.driven))

    @cached_property
    def _latched(self) -> frozenset[Address]:
        """The bits that something other than out and reset writes."""
        return frozenset(
            address
            for use in self._facts.uses.every
            if use.is_written and use.action and not (use.action.effects.follows_power or use.action.turns is False)
            for address in addresses_of(use.operand)
        )


def _target(placed: Placed) -> object:
    operand = placed.action.driven
    return operand.target if isinstance(operand, Immediate) else operand


def _report(facts: Facts, losses: list[_Loss]) -> Findings:
    _, coil, latch, is_later, is_held = losses[0]
    bits = list(dict.fromkeys(loss.bit for loss in losses))
    others = len({id(loss.coil.action) for loss in losses}) - 1
    name, it, word = facts.listed(bits), "it" if len(bits) == 1 else "them", latch.spec.name
    here, there = (latch, coil) if is_later or others else (coil, latch)
    place = there.action.span.seen_from(here.action.span) + (f" and {others} more" if others else "")
    state = "off while its rung is off" if latch.action.turns else "on while its rung is on"
    help = (
        "drive the bit by set and reset alone, or by one out that seals itself in, or give the latch a bit of its own"
    )
    if is_held:
        fault = f"reset holds {name} off only while its rung is on: out in {place} turns it on again after that"
        help = "put the condition into the rung of the out, negated, or reset what the out waits for too"
    elif here is latch:
        fault = f"{word} does not hold {name}: out in {place} writes {it} again in every scan, {state}"
    else:
        fault = f"this out writes {name} in every scan, so {word} in {place} does not hold {it}, {state}"
    yield finding(CODE, here.action.span, fault, help, (Label(there.action.span, f"{there.spec.name} is here"),))


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "out and set or reset drive one bit",
    """
`out` writes its bit in every scan in which its rung is looked at: on when the rung is on, off when it is off. `set` and
`reset` write only while their rung is on, and leave the bit as it is otherwise. On one bit the two do not mix: what was
set is off again as soon as the scan comes to the `out`, and what was reset comes back. The start button works only
while it is pressed, the alarm goes off by itself.

Drive the bit by `set` and `reset` alone, by one `out` that seals itself in, or give the latch a bit of its own and put
that into the rung of the `out`.

A `reset` below the `out` holds for as long as its rung is on. A button lets go, and the motor starts again by itself.

The rule is silent where the two work together: an `out` that looks at its own bit takes up what was set or reset; a
`reset` below the `out` is an interlock where more than inputs decide it, where it is a range that is kept off for as
long as an emergency stop is pressed, and where it also takes away what the `out` waits for; a `set` of several bits
there that nothing resets is a lamp test; a `reset` of several C bits above the `out` is there for those that
something else turns on; what only the first scan does prepares the bit. It is silent too about a bit that a
subroutine drives and another routine turns off: `out` in a subroutine that is not called leaves its bit as it is.
""",
    wrong=(
        Wrong(
            """
if x.Start:
    set(y.Motor)

if x.Stop:
    reset(y.Motor)

if c.Jog:
    out(y.Motor)  # <-
"""
        ),
        Wrong(
            """
if c.Manual:
    out(y.Valve)

if re(x.Open):
    set(y.Valve)  # <-

if re(x.Close):
    reset(y.Valve)
"""
        ),
        Wrong(
            """
if x.Acknowledge:
    reset(c.Alarm)

if x.Overload:
    out(c.Alarm)  # <-
"""
        ),
        Wrong(
            """
if x.EmergencyStop:
    reset(y[1:17])  # <-

if c.Run:
    out(y[1])

if c.Jog:
    out(y[2])

if c.Fill:
    out(c.ValveOpen)

if x.Stop:
    reset(c.ValveOpen)  # <-
"""
        ),
        Wrong(
            """
def main():
    if re(x.Acknowledge):
        reset(c.Alarm)
    if True:
        call(alarms)
    if True:
        end()


@sub
def alarms():
    if x.Overload:
        out(c.Alarm)  # <-
    if True:
        return
"""
        ),
    ),
    right=(
        """
if x.Start:
    set(c.Running)

if x.Stop:
    reset(c.Running)

if any(c.Running, c.Jog):
    out(y.Motor)
""",
        """
if all(any(x.Start, y.Motor), x.Stop):
    out(y.Motor)

if re(x.RemoteStart):
    set(y.Motor)

if re(x.RemoteStop):
    reset(y.Motor)
""",
        """
if c.Run:
    out(y.Motor)

if c.Siren:
    out(y.Horn)

if x.EmergencyStop:
    reset(y[1:17])

if x.LampTest:
    set(y[1:5])
""",
        """
if x.Clear:
    reset(c[1:9])
if re(x.Start):
    set(c[1])
if x.Near:
    out(c[2])
if c.Wanted:
    out(y.Valve)
    out(y.Heater)
if nc(x.TankFull):
    out(y.Pump)
if x.TankFull:
    reset(y.Pump)
if x.Stop:
    reset(y.Valve)
    reset(c.Wanted)
if c.Tripped:
    reset(y.Heater)
""",
        """
def main():
    if ds.Mode == 1:
        call(auto)
    if ds.Mode != 1:
        reset(y.Motor)
    if True:
        end()


@sub
def auto():
    if c.Run:
        out(y.Motor)
    if True:
        return
""",
    ),
)

RULE = Rule(find, (ABOUT,))
