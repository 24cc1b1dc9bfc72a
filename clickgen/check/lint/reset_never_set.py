"""A bit that is reset and never set: the reset has nothing to do."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.check.facts import STARTING, Facts, Placed
from clickgen.check.rule import Rule, Wrong
from clickgen.check.uses import addresses_of
from clickgen.device.banks import Address
from clickgen.diagnostics import Diagnostics
from clickgen.instructions.coils import RESET
from clickgen.ir.conditions import Contact
from clickgen.ir.logic import implies
from clickgen.ir.operands import Cell
from clickgen.ir.walk import condition_operands

CODE = "CG503"


def check(facts: Facts, problems: Diagnostics) -> None:
    resets = [(placed, addresses_of(placed.action.args["address"])) for placed in facts.actions if placed.spec is RESET]
    never_on = {bit for bit in {bit for _, bits in resets for bit in bits} if _stays_off(facts, bit)}
    asked = {bit for placed, bits in resets for bit in _answered(facts, placed, never_on.intersection(bits))}
    said: set[Address] = set()
    for placed, bits in resets:
        # A range may hold spare bits beside those that are set.
        if said.issuperset(bits) or not never_on.issuperset(bits) or not asked.isdisjoint(bits):
            continue
        # Cleared in the first scan: what a panel sets begins in a known state.
        if placed.depends_only_on(STARTING) and any(facts.uses.reads(bit) for bit in bits):
            continue
        said.update(bits)
        one = len(bits) == 1
        problems.add(
            CODE,
            placed.action.span,
            f"{facts.listed(bits)} {'is' if one else 'are'} reset here and never set: "
            f"nothing in the program turns {'it' if one else 'them'} on",
            f"add the set, or correct the name; where a panel turns it on, write # clickgen: ignore[{CODE}]",
        )


def _stays_off(facts: Facts, bit: Address) -> bool:
    if bit.bank not in ("Y", "C") or facts.uses.is_pointed(bit.bank, is_written=True):
        return False
    if facts.initial(bit) == "1":
        return False
    return all(placed.spec is RESET for placed in facts.writers(bit))


def _answered(facts: Facts, placed: Placed, bits: set[Address]) -> set[Address]:
    """Those of the bits whose reset waits for them: a panel asks by setting a bit, and the program has answered.

    It waits for the bit itself, or for what the program writes on account of it: a timer, a step, a flag.
    """
    if not bits:
        return bits
    span = placed.action.span
    signs = _looked_at([placed])
    direct = {bit for bit in bits & signs if implies(placed.condition, Contact(Cell(bit, span), span))}
    writers = [writer for sign in signs for writer in facts.writers(sign)]
    calls = [call for writer in writers for call in facts.calls.get(writer.routine.name, ())]
    return direct | (bits & _looked_at([*writers, *calls]))


def _looked_at(actions: Iterable[Placed]) -> set[Address]:
    """The addresses that decide whether any of these runs."""
    return {
        address
        for placed in actions
        for operand in condition_operands(placed.condition)
        for address in addresses_of(operand)
    }


RULE = Rule(
    CODE,
    check,
    """
A `reset` of a bit that no rung ever turns on does nothing, and every contact on that bit waits forever. Most often
the name is a little wrong here or where the bit is set, or the rung that sets it is gone.

Any other instruction that writes the bit counts as a set: `out`, a copy, a pointer, a drum. The rule is silent about a
request from a panel: a bit whose reset waits for the bit itself, or for what the program does on account of it.
""",
    wrong=(
        Wrong(
            """
if x.Stop:
    reset(c.Running)  # <-

if c.Running:
    out(y.Motor)
"""
        ),
        Wrong(
            """
if x.Stop:
    reset(y[1:5])  # <-
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
if x.Fault:
    set(c[1])

if x.Acknowledge:
    reset(c[1:17])
""",
        """
if c.AverageRequest:
    calc("(ds[1] + ds[2]) / 2", ds.Average)
    reset(c.AverageRequest)

if c.LoadRequest:
    ton(t.Loaded, setpoint=200)

if t.Loaded:
    reset(c.LoadRequest)
""",
        """
nickname(c.Enabled, c[1], initial=1)


def main():
    if x.Fault:
        reset(c.Enabled)

    if c.Enabled:
        out(y.Motor)

    if True:
        end()
""",
    ),
)
