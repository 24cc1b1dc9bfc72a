"""A value that CLICK's clock never has: hour 25, weekday 0, month 13."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.device.clock import CLOCK, SETS_CLOCK, Part
from clickgen.facts.copied import put_in
from clickgen.facts.facts import Facts
from clickgen.facts.uses import addresses_of
from clickgen.formula.values import value_of
from clickgen.ir.conditions import MIRRORED, Compare
from clickgen.ir.operands import Cell, Integer, Real
from clickgen.ir.program import FormulaText
from clickgen.ir.reach import touches
from clickgen.logic.conditions import HOLDS
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [system.clock, system.clock-set]
CODE = "CG552"

_COPIES_MAX = 8
"""A register that gets its value through more copies than this is not examined."""


def find(facts: Facts) -> Findings:
    parts: _Parts = {}
    for compare in facts.comparisons:
        yield from _check_comparison(facts, compare, parts)
    for placed in facts.actions:
        for touch in touches(placed.action):
            if touch.is_written:
                for address in SETS_CLOCK.intersection(addresses_of(touch.operand)):
                    formula = placed.action.moved
                    put = put_in(placed, address)
                    value: float | None = None
                    if isinstance(put, Integer | Real):
                        value = put.value
                    elif isinstance(formula, FormulaText):
                        value = value_of(formula.formula.root)
                    part = CLOCK[address]
                    if value is not None and not part.low <= value <= part.high:
                        span = put.span if isinstance(put, Integer | Real) else touch.operand.span
                        fault = f"{facts.shown(address)} takes the {part.name}, {_range(part)}, and not {value:g}"
                        yield finding(CODE, span, fault, f"write a number from {part.low} to {part.high}")


_Parts = dict[Address, Part | None]
"""The known parts of the registers that were asked for."""


def _check_comparison(facts: Facts, compare: Compare, parts: _Parts) -> Findings:
    left, op, right = compare.left, compare.op, compare.right
    if not isinstance(left, Cell):
        left, op, right = right, MIRRORED[op], left
    if not isinstance(left, Cell) or not isinstance(right, Integer | Real):
        return
    # A register alone is compared with an unwritten 0.
    if right.span == left.span:
        return
    if left.address not in parts:
        parts[left.address] = _part(facts, left.address)
    part = parts[left.address]
    if part is None:
        return
    outcome = _outcome(part, op, right.value)
    if outcome is not None:
        shown = facts.shown(left.address)
        yield finding(
            CODE,
            compare.span,
            f"{facts.described(compare)} is {'always' if outcome else 'never'} true: {shown} is the {part.name}, "
            f"{_range(part)}",
            f"compare it with a number from {part.low} to {part.high}",
        )


def _outcome(part: Part, op: str, value: float) -> bool | None:
    """The constant result of a comparison with the clock; None if it varies, or only bounds a range."""
    outcomes = {HOLDS[op](one, value) for one in range(part.low, part.high + 1)}
    if len(outcomes) > 1:
        return None
    (outcome,) = outcomes
    # all(hour >= 22, hour < 24): a bound at the end of the range is how people write a window.
    is_bound = (op, value) in (("<", part.high + 1), (">", part.low - 1)) or part.low <= value <= part.high
    return None if outcome and is_bound else outcome


def _part(facts: Facts, address: Address) -> Part | None:
    """The part of the time that a register holds: one of the clock's own, or one that only copies of it write."""
    for _ in range(_COPIES_MAX):
        if address in CLOCK:
            return CLOCK[address] if address not in SETS_CLOCK else None
        writers = facts.writers(address)
        if not writers or facts.uses.is_pointed(address.bank, is_written=True):
            return None
        sources = {put.address if isinstance(put, Cell) else None for put in (put_in(one, address) for one in writers)}
        (source, *others) = sources
        if source is None or others:
            return None
        address = source
    return None


def _range(part: Part) -> str:
    return f"{part.low} to {part.high}" + (f" ({part.note})" if part.note else "")


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "the clock has no such value",
    """
The registers of the clock hold hours from 0 to 23, minutes and seconds from 0 to 59, months from 1 to 12, days from 1
to 31, and weekdays from 1, which is Sunday, to 7. A comparison with another number is never true, or always, so that a
schedule does not run at all or never ends. Where the program sets the clock to such a number, SC54 and SC56 are there
to say that CLICK did not take the date or the time.

A register that only copies of the clock write is looked at as the clock. A bound at the end of the range is left alone:
`all(sd[24] >= 22, sd[24] < 24)` is a window of time.
""",
    wrong=(
        Wrong(
            """
if sd[24] == 25:  # <-
    out(y.Lamp)
if all(sd[23] != 0, sd[25] <= 60):  # <- # <-
    out(y.Pump)
if any(sd[23] == 0, sd[21] > 12, 31 < sd[22]):  # <- # <- # <-
    out(y.Bell)
if sd[19] == 26:  # <-
    out(y.Horn)
"""
        ),
        Wrong(
            """
if True:
    copy_block(sd[24:27], ds[24])
    copy(sd[23], ds.Weekday)
if any(ds[24] == 24, ds.Weekday == 8):  # <- # <-
    out(y.Lamp)
if x.SetClock:
    copy(24, sd[34])  # <-
    calc("30 * 2", sd[35])  # <-
    copy_fill(0, sd[31:33])  # <- # <-
"""
        ),
    ),
    right=(
        """
if all(sd[24] >= 22, sd[24] < 24, sd[23] > 0, sd[25] >= 0):
    out(y.Lamp)
if any(sd[23] == 1, sd[23] == 7, sd[24] == 0, sd[25] == 59, sd[20] == 0, sd[19] > 2025):
    out(y.Pump)
if sd[24]:
    out(y.Bell)
""",
        """
if True:
    copy(sd[24], ds.Hour)
if x.SetClock:
    copy(30, ds.Hour)
    copy(ds.NewHour, sd[34])
    copy(23, sd[34])
if ds.Hour == 30:
    out(y.Lamp)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
