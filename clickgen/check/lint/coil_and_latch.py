"""A bit that out drives and that set or reset latches: out writes it in every scan, so the latch does not hold."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

from clickgen.check.facts import STARTING, Facts, Placed
from clickgen.check.idle import never_run
from clickgen.check.pulses import Pulses
from clickgen.check.rule import Rule, Wrong
from clickgen.check.uses import addresses_of
from clickgen.device.banks import Address
from clickgen.diagnostics import Diagnostics, Label
from clickgen.instructions.coils import OUT, RESET, SET
from clickgen.ir.walk import condition_operands

CODE = "CG543"

_MANY = 100
"""Of more coils or latches of one bit than this the rest is not compared."""


class _Latch(NamedTuple):
    """A set or reset of a bit, with where it comes among all actions of the program."""

    placed: Placed
    at: int
    is_range: bool
    """True where it is one of several bits that one instruction sets or resets."""


def check(facts: Facts, problems: Diagnostics) -> None:
    coils: dict[Address, list[tuple[Placed, int]]] = defaultdict(list)
    latches: dict[Address, list[_Latch]] = defaultdict(list)
    idle = never_run(facts)
    for at, placed in enumerate(facts.actions):
        if placed.spec not in (OUT, SET, RESET) or id(placed.action) in idle:
            continue
        bits = addresses_of(placed.action.args["address"])
        for bit in bits:
            if placed.spec is OUT:
                coils[bit].append((placed, at))
            else:
                latches[bit].append(_Latch(placed, at, len(bits) > 1))
    said: set[tuple[int, int]] = set()
    pulses = Pulses(facts)
    for bit in coils.keys() & latches.keys():
        for coil, at in coils[bit][:_MANY]:
            lost = next((one for one in latches[bit][:_MANY] if _is_lost(facts, pulses, bit, coil, at, one)), None)
            if lost is None:
                continue
            pair = id(coil.action), id(lost.placed.action)
            if pair not in said:
                said.add(pair)
                _report(facts, problems, bit, coil, lost.placed, is_later=lost.at > at)
            break


def _is_lost(facts: Facts, pulses: Pulses, bit: Address, coil: Placed, at: int, latch: _Latch) -> bool:
    """True where out undoes what the latch does, in the same scan or in the next one."""
    placed = latch.placed
    if placed.depends_only_on(STARTING) or not _runs_with(facts, coil, placed):
        return False
    # A coil that seals itself in takes up what the latch did.
    if any(bit in addresses_of(operand) for way in facts.ways_to(coil) for operand in condition_operands(way)):
        return False
    if latch.at < at:
        return not latch.is_range or placed.spec is SET
    # Below the coil a level overrides it for as long as it is there: an interlock, a lamp test.
    is_short = pulses.has(placed.condition, placed.routine)
    if placed.spec is RESET:
        return is_short
    resets = (writer for writer in facts.writers(bit) if writer.spec is RESET and not writer.depends_only_on(STARTING))
    is_reset = any(len(addresses_of(writer.action.args["address"])) == 1 for writer in resets)
    return is_short or is_reset or not latch.is_range


def _runs_with(facts: Facts, coil: Placed, latch: Placed) -> bool:
    """True where both are in one routine, or where the coil runs in every scan and the latch may run in the same one.

    An output that several routines drive is CG522's. A reset in another routine turns off what a subroutine that is no
    longer called has left on.
    """
    if coil.routine is latch.routine:
        return coil.routine.name not in facts.left_early
    if latch.spec is RESET or addresses_of(coil.action.args["address"])[0].bank == "Y":
        return False
    return facts.sometimes(coil.routine) is None and not facts.run_apart(coil.routine, latch.routine)


def _report(facts: Facts, problems: Diagnostics, bit: Address, coil: Placed, latch: Placed, is_later: bool) -> None:
    name, word = facts.shown(bit), latch.spec.name
    here, there = (latch, coil) if is_later else (coil, latch)
    place = there.action.span.seen_from(here.action.span)
    if is_later:
        fault = f"{word} does not hold {name}: out in {place} writes it again in every scan"
    else:
        fault = f"this out writes {name} in every scan, so {word} in {place} does not hold it"
    problems.add(
        CODE,
        here.action.span,
        f"{fault}, {'off while its rung is off' if latch.spec is SET else 'on while its rung is on'}",
        "drive the bit by set and reset alone, or by one out that seals itself in, or give the latch a bit of its own",
        (Label(there.action.span, f"{there.spec.name} is here"),),
    )


RULE = Rule(
    CODE,
    check,
    """
`out` writes its bit in every scan in which its rung is looked at: on when the rung is on, off when it is off. `set` and
`reset` write only while their rung is on, and leave the bit as it is otherwise. On one bit the two do not mix: what was
set is off again as soon as the scan comes to the `out`, and what was reset comes back. The start button works only
while it is pressed, the alarm goes off by itself.

Drive the bit by `set` and `reset` alone, by one `out` that seals itself in, or give the latch a bit of its own and put
that into the rung of the `out`.

The rule is silent where the two work together: an `out` that looks at its own bit takes up what was set or reset; a
`reset` below the `out` that stays on is an interlock, and a `set` of several bits there that nothing resets is a lamp
test; what only the first scan does prepares the bit. It is silent too about a bit that a subroutine drives and another
routine turns off: `out` in a subroutine that is not called leaves its bit as it is.
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
