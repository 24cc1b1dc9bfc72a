"""An output coil that two places drive: the last one that runs wins, and the other does nothing."""

from __future__ import annotations

from collections import defaultdict

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.idle import never_run
from clickgen.facts.uses import addresses_of
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [coil.two-outs]
CODE = "CG501"

_COILS_MAX = 100
"""A coil is compared with this many coils of the same bit before it."""


def find(facts: Facts) -> Findings:
    driven: dict[Address, list[Placed]] = defaultdict(list)
    idle = never_run(facts)
    for placed in facts.actions:
        if not placed.effects.follows_power or id(placed.action) in idle:
            continue
        bits = addresses_of(placed.action.driven)
        for address in bits:
            before = driven[address][:_COILS_MAX]
            earlier = next((one for one in before if not facts.run_apart(one.routine, placed.routine)), None)
            if earlier is not None:
                yield finding(
                    CODE,
                    placed.action.span,
                    f"{facts.shown(address)} is driven by out in {earlier.action.span.seen_from(placed.action.span)} "
                    "already: whichever runs last decides, also when it turns the bit off",
                    f"join the conditions in one rung with {facts.spell.some('...')}, or use set and reset",
                    (Label(earlier.action.span, "driven here first"),),
                )
                break
        for address in bits:
            driven[address].append(placed)


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "an output coil is driven in two places",
    """
`out` writes its bit in every scan in which its rung is looked at: on when the rung is true and off when it is false.
With two of them the later rung decides alone, and the earlier one does nothing but flicker: a classic reason why a
motor does not start although its rung is green. CLICK warns about it too (C1001).

Subroutines that are never called in the same scan may drive the same bit: their calls must have conditions that
exclude each other; a coil of main that `out` alone drives counts as its condition. When one of them changes the step
that the calls look at, both run in that one scan; the rule takes this for intended, because a sequence hands over so.
A subroutine that nothing calls, or a rung after an unconditional `end()`, never runs and drives nothing: other rules
report these.
""",
    wrong=(
        Wrong(
            """
if c.Auto:
    out(y.Motor)

if c.Manual:
    out(y.Motor)  # <-
"""
        ),
        Wrong(
            """
if c.Fill:
    out(y[1:5])
    if c.Drain:
        out(y[3])  # <-
"""
        ),
    ),
    right=(
        """
if any(c.Auto, c.Manual):
    out(y.Motor)
""",
        """
if c.Start:
    set(y.Motor)

if c.Stop:
    reset(y.Motor)
""",
        """
def main():
    if ds.Mode == 1:
        call(auto)
    if ds.Mode == 2:
        call(manual)
    if True:
        end()


@sub
def auto():
    if c.Run:
        out(y.Motor)
    if True:
        return


@sub
def manual():
    if c.Jog:
        out(y.Motor)
    if True:
        return
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
