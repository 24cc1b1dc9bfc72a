"""A bit that is set and never reset: a latch that nothing opens."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.facts import STARTING, Facts
from clickgen.facts.uses import addresses_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG502"


def find(facts: Facts) -> Findings:
    seen: set[Address] = set()
    for placed in facts.actions:
        # A bit that the first scan sets is meant to stay on.
        if placed.action.turns is not True or placed.depends_only_on(STARTING):
            continue
        bits = [bit for bit in addresses_of(placed.action.driven) if bit not in seen]
        # So is a bit that is set once, whatever happens.
        if len(bits) == 1 and placed.depends_only_on(STARTING.union(bits)):
            continue
        seen.update(bits)
        held = [bit for bit in bits if _stays_on(facts, bit)]
        if held:
            one = len(held) == 1
            is_for_good = all(map(facts.is_retentive, held))
            until = "for good" if is_for_good else "until the PLC restarts"
            meant = "where a panel turns it off" + ("" if is_for_good else ", or where only a restart is to end it")
            yield finding(
                CODE,
                placed.action.span,
                f"{facts.listed(held)} {'is' if one else 'are'} set here and never reset: once on, "
                f"{'it stays' if one else 'they stay'} on {until}",
                f"add the reset that ends it; {meant}, write {facts.spell.ignore(CODE)}",
            )


def _stays_on(facts: Facts, bit: Address) -> bool:
    # Some SC bits are commands to the CLICK, which turns them off itself (click-facts [bank.writable-sc]).
    if bit.bank not in ("Y", "C") or facts.uses.is_pointed(bit.bank, is_written=True):
        return False
    return all(placed.action.turns for placed in facts.writers(bit))


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a bit is set and never reset",
    """
`set` turns a bit on and nobody turns it off again: the machine runs on although its stop button is pressed, or an alarm
can never be acknowledged. Look for a `reset` that was forgotten, or that is on a bit with a similar name.

Any other instruction that writes the bit counts as a reset: `out`, a copy, a pointer, a drum. A bit that is set in the
first scan, or by nothing but itself, is meant to stay on.
""",
    wrong=(
        Wrong(
            """
if all(x.Start, nc(c.Faulted)):
    set(c.Running)  # <-

if x.Stop:
    reset(c.Runing)

if c.Running:
    out(y.Motor)
"""
        ),
        Wrong(
            """
if x.Overload:
    set(y[1:5])  # <-

if x.Acknowledge:
    reset(y[1:4])
"""
        ),
    ),
    right=(
        """
if x.Start:
    set(c.Running)

if x.Stop:
    reset(c.Running)
""",
        """
if x.Start:
    set(c[1:5])

if x.Stop:
    copy_unpack(dh.Nothing, c[1:17])
""",
        """
if nc(c.Prepared):
    copy(100, ds.Speed)
    set(c.Prepared)

if sc._1st_SCAN:
    set(c.Enabled)

if x.Restart:
    set(sc[50])
""",
    ),
)

RULE = Rule(find, (ABOUT,))
