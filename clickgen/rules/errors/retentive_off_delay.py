"""rtof is built from other instructions; its bit cannot be read as part of a range."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.facts.refusals import refused
from clickgen.facts.uses import addresses_of
from clickgen.ir.operands import Operand, Range
from clickgen.ir.program import KeptToken
from clickgen.ir.walk import program_operands
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    timers: set[Address] = set()
    for placed in facts.actions:
        timer = placed.action.owned
        if placed.spec.built_from is not None and timer is not None:
            timers.add(timer.address)
            yield finding(
                "CG420",
                placed.action.span,
                f"CLICK has no retentive off-delay: {timer.address} becomes a retentive on-delay with two scratch bits",
                "the listing shows the rungs; reading the timer's bit reads one of the scratch bits",
            )
    if not timers:
        return
    kept = list(_in_kept_tokens(facts))
    for operand in kept:
        if not timers.isdisjoint(addresses_of(operand)):
            yield finding(
                "CG301",
                operand.span,
                "this ladder token names the bit of an rtof, which stands elsewhere",
                "give the rtof another timer",
            )
    said = {operand.span for operand in kept}.union(*(refused(placed.action) for placed in facts.actions))
    for operand in program_operands(facts.program):
        if operand.span in said:
            continue
        if isinstance(operand, Range) and operand.bank == "T" and not timers.isdisjoint(operand.addresses()):
            yield finding(
                "CG301",
                operand.span,
                "this range holds the bit of an rtof, which stands elsewhere",
                "name the bits one by one",
            )


def _in_kept_tokens(facts: Facts) -> Iterator[Operand]:
    """The addresses in kept instructions: nothing can be put in the place of the bit of an rtof there."""
    for placed in facts.actions:
        token = placed.action.args.get("token")
        if isinstance(token, KeptToken):
            yield from token.operands


ABOUT = Code(
    "CG420",
    Severity.INFO,
    "rtof is emulated",
    """
CLICK has no retentive off-delay timer. clickgen builds it from a retentive on-delay timer and two
scratch bits; the listing shows the rungs. In CLICK, look at the scratch bit to see the output of the timer.
""",
    wrong=(
        Wrong(
            """
if x[1]:
    rtof(t.Idle, setpoint=30, unit=Tm, reset=lambda: c.Awake)  # <-
""",
        ),
    ),
    right=(
        """
if x[1]:
    tof(t.Idle, setpoint=30, unit=Tm)
""",
    ),
)

RULE = Rule(find, (ABOUT,), also=("CG301",), holds_in_parts=True)
