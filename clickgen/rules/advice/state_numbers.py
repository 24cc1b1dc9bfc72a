"""Bare numbers of states in many places: whoever renumbers a step misses one."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.instructions.effects import Shape
from clickgen.instructions.offered import COIL
from clickgen.ir.operands import Cell, Integer
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

CODE = "CG523"

_PLACES_MIN = 3


def find(facts: Facts) -> Findings:
    places: dict[Address, dict[int, list[Span]]] = {}
    pairs = [
        pair for one in facts.comparisons if one.op == "==" for pair in ((one.left, one.right), (one.right, one.left))
    ]
    copies = [placed.action for placed in facts.actions if placed.effects.shape is Shape.VALUE]
    for register, number in (*pairs, *((action.moved_to, action.moved) for action in copies)):
        if isinstance(register, Cell) and isinstance(number, Integer) and number.value:
            places.setdefault(register.address, {}).setdefault(number.value, []).append(number.span)
    for address, numbers in places.items():
        often = {number: spans for number, spans in numbers.items() if len(spans) >= _PLACES_MIN}
        if often:
            listed = ", ".join(map(str, sorted(often)))
            coil = facts.spell.call(COIL, facts.spell.name("C", "Filling"))
            yield finding(
                CODE,
                min(span for spans in often.values() for span in spans),
                f"{facts.shown(address)} is compared with or set to {listed} in {_PLACES_MIN} or more places each",
                f"give each state a bit of its own in one rung, {coil} on the comparison, and ask the bit",
            )


ABOUT = Code(
    CODE,
    Severity.INFO,
    "a state number is repeated",
    """
A state that is written as a number in many places has to be changed in all of them, and a reader has to know what 30
means. One rung that turns the number into a bit with a name, `if ds.Step == 30: out(c.Filling)`, says both once.

This is advice, so it is off unless it is selected. It speaks once for each register; 0 is not counted.
""",
    wrong=(
        Wrong(
            """
if ds.Step == 30:  # <-
    out(y.Valve)
if all(ds.Step == 30, x.Full):
    copy(40, ds.Step)
if x.Again:
    copy(30, ds.Step)
"""
        ),
    ),
    right=(
        """
if ds.Step == 30:
    out(c.Filling)
if c.Filling:
    out(y.Valve)
if all(c.Filling, x.Full):
    copy(0, ds.Step)
if x.Again:
    copy(30, ds.Step)
if x.Clear:
    copy(0, ds.Step)
if ds.Step == 0:
    out(y.Lamp)
""",
    ),
    is_on=False,
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
