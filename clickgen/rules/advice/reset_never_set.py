"""A bit that is reset and never set: the reset has nothing to do."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.device.banks import Address
from clickgen.facts.facts import STARTING, Facts, Placed
from clickgen.facts.uses import addresses_of
from clickgen.ir.conditions import Contact
from clickgen.ir.operands import Cell
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands
from clickgen.logic.conditions import implies
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG503"

_WRITERS_MAX = 2000
"""Beyond this many instructions the way back from a reset is not followed."""


def find(facts: Facts) -> Findings:
    turning_off = (placed for placed in facts.actions if placed.action.turns is False)
    resets = [(placed, addresses_of(placed.action.driven)) for placed in turning_off]
    never_on = {bit for bit in {bit for _, bits in resets for bit in bits} if _stays_off(facts, bit)}
    answers = _Answers(facts)
    asked = {bit for placed, bits in resets for bit in answers.of(placed, never_on.intersection(bits))}
    said: set[Address] = set()
    for placed, bits in resets:
        # A range may hold spare bits beside those that are set.
        if said.issuperset(bits) or not never_on.issuperset(bits) or not asked.isdisjoint(bits):
            continue
        # Cleared in the first scan: a bit that a panel sets begins in a known state.
        if placed.depends_only_on(STARTING) and any(facts.uses.reads(bit) for bit in bits):
            continue
        said.update(bits)
        one = len(bits) == 1
        yield finding(
            CODE,
            placed.action.span,
            f"{facts.listed(bits)} {'is' if one else 'are'} reset here and never set: "
            f"nothing in the program turns {'it' if one else 'them'} on",
            f"add the set, or correct the name; where a panel turns it on, write {facts.spell.ignore(CODE)}",
        )


def _stays_off(facts: Facts, bit: Address) -> bool:
    if bit.bank not in ("Y", "C") or facts.uses.is_pointed(bit.bank, is_written=True):
        return False
    if facts.initial(bit) == "1":
        return False
    return all(placed.action.turns is False for placed in facts.writers(bit))


class _Answers:
    """Which resets answer a panel: it asks by setting a bit, and the reset waits for the bit or for what came of it."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        self._behind: dict[int, set[Address]] = {}
        """The addresses that each action depends on, by its id."""

    def of(self, placed: Placed, bits: set[Address]) -> set[Address]:
        """Those of the bits whose reset waits for them, or for what the program does because of them.

        The way may be long: a step, a timer, the end of a batch. If it is too long, it is assumed to lead to the bits.
        """
        if not bits:
            return bits
        span = placed.action.span
        signs = _looked_at([placed])
        direct = {bit for bit in bits & signs if implies(placed.condition, Contact(Cell(bit, span), span))}
        waiting = [writer for sign in signs for writer in self._facts.writers(sign)]
        seen: set[Address] = set()
        done: set[int] = set()
        while waiting and not bits <= seen:
            writer = waiting.pop()
            if id(writer.action) in done:
                continue
            done.add(id(writer.action))
            if len(done) > _WRITERS_MAX:
                return bits
            behind = self._depends_on(writer) - seen
            seen |= behind
            waiting += [before for address in behind for before in self._facts.writers(address)]
        return direct | (bits & seen)

    def _depends_on(self, writer: Placed) -> set[Address]:
        known = self._behind.get(id(writer.action))
        if known is None:
            calls = self._facts.calls.get(writer.routine.name, ())
            known = self._behind[id(writer.action)] = _looked_at([writer, *calls]) | _read_by(writer)
        return known


def _looked_at(actions: Iterable[Placed]) -> set[Address]:
    """The addresses that decide whether any of these runs."""
    return {
        address
        for placed in actions
        for operand in condition_operands(placed.condition)
        for address in addresses_of(operand)
    }


def _read_by(placed: Placed) -> set[Address]:
    """The addresses that an action reads by itself: the source of a copy, the operands of a formula, a box's inputs."""
    return {
        address for touch in touches(placed.action) if not touch.is_written for address in addresses_of(touch.operand)
    }


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a bit is reset and never set",
    """
A `reset` of a bit that no rung ever turns on does nothing, and every contact on that bit waits forever. Most often
the name is a little wrong here or where the bit is set, or the rung that sets it is gone.

Any other instruction that writes the bit counts as a set: `out`, a copy, a pointer, a drum. The rule is silent about a
request from a panel: a bit whose reset waits for the bit itself, or for what the program does on account of it, such
as the end of the batch that it asked for.
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
if c.RinseOnly:
    copy(9, ds.Step)

if ds.Step == 9:
    ton(t.Rinsing, 30, Ts)

if t.Rinsing:
    copy(10, ds.Step)

if ds.Step == 10:
    reset(c.RinseOnly)
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

RULE = Rule(find, (ABOUT,))
