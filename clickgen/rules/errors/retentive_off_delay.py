"""rtof is built from other instructions; its bit cannot be read as part of a range."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.facts.uses import addresses_of
from clickgen.facts.values import refused_operands
from clickgen.ir.operands import Range
from clickgen.ir.program import KeptToken
from clickgen.ir.walk import program_operands
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import Span


def check(facts: Facts, problems: Diagnostics) -> None:
    timers: set[Address] = set()
    for placed in facts.actions:
        timer = placed.action.owned
        if placed.spec.built_from is not None and timer is not None:
            timers.add(timer.address)
            problems.add(
                "CG420",
                placed.action.span,
                f"CLICK has no retentive off-delay: {timer.address} becomes a retentive on-delay with two scratch bits",
                "the listing shows the rungs; reading the timer's bit reads one of the scratch bits",
            )
    if not timers:
        return
    kept = _in_kept_tokens(facts, timers, problems)
    refused = refused_operands(problems) | kept
    for operand in program_operands(facts.program):
        if operand.span in refused:
            continue
        if isinstance(operand, Range) and operand.bank == "T" and not timers.isdisjoint(operand.addresses()):
            problems.add(
                "CG301",
                operand.span,
                "this range holds the bit of an rtof, which stands elsewhere",
                "name the bits one by one",
            )


def _in_kept_tokens(facts: Facts, timers: set[Address], problems: Diagnostics) -> set[Span]:
    """Report kept instructions that name the bit of an rtof: nothing can be put in its place there.

    Returns the places of all addresses in kept tokens.
    """
    places: set[Span] = set()
    for placed in facts.actions:
        token = placed.action.args.get("token")
        for operand in token.operands if isinstance(token, KeptToken) else ():
            places.add(operand.span)
            if not timers.isdisjoint(addresses_of(operand)):
                problems.add(
                    "CG301",
                    operand.span,
                    "this ladder token names the bit of an rtof, which stands elsewhere",
                    "give the rtof another timer",
                )
    return places
