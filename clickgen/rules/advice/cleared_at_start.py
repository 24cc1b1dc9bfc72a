"""A value that is kept over a power cycle but cleared in the first scan."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address
from clickgen.facts.facts import FIRST_SCAN, Facts, Placed
from clickgen.facts.uses import addresses_of
from clickgen.facts.written import left_in
from clickgen.ir.conditions import All, Condition, Contact
from clickgen.ir.operands import Cell
from clickgen.ir.reach import touches
from clickgen.logic.conditions import implies, looked_at
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

# click-facts [scan.power-up]
CODE = "CG557"


def find(facts: Facts) -> Findings:
    said: set[Address] = set()
    for placed in facts.actions:
        lost: dict[Address, Span] = {}
        for address, span in _cleared(facts, placed):
            bit = Address(CURRENT_VALUE_OF.get(address.bank, address.bank), address.number, address.upper)
            if bit not in said and facts.is_retentive(bit) and _is_meant(facts, bit):
                said.add(bit)
                lost[bit] = span
        if lost:
            yield from _report(facts, lost)


def _report(facts: Facts, lost: Mapping[Address, Span]) -> Findings:
    """Report one finding for everything that one instruction clears."""
    first, span = next(iter(lost.items()))
    written = facts.spell.name(first.bank, facts.nickname(first) or "Total")
    declared = facts.spell.declaration(written, facts.spell.cell(first), retentive="False")
    one = len(lost) == 1
    are, they, them = ("is", "it", "it") if one else ("are", "they", "them")
    yield finding(
        CODE,
        span,
        f"{facts.listed([*lost])} {are} retentive and cleared here in the first scan: what {they} kept is lost at "
        "every power-up",
        f"clear {them} on a condition of its own to keep the value; if {they} should start again, declare that"
        f"{'' if one else ' for each'}: {declared}",
    )


def _cleared(facts: Facts, placed: Placed) -> Iterator[tuple[Address, Span]]:
    """The addresses that an action clears in the first scan, and where that is written."""
    if placed.effects.done is not None:
        owned, pin = placed.action.owned, placed.action.pin(placed.effects.reset_by)
        if pin is not None and owned is not None and _holds_at_start(facts, placed, pin):
            yield owned.address, pin.span
    elif _holds_at_start(facts, placed, placed.condition):
        for touch in touches(placed.action):
            if touch.is_written:
                for address in addresses_of(touch.operand):
                    if placed.action.turns is False or left_in(placed, address, 1) == 0:
                        yield address, placed.action.span


def _holds_at_start(facts: Facts, placed: Placed, condition: Condition) -> bool:
    """True for a condition that only the first scan makes true, in a subroutine that is called then."""
    call, seen = facts.sometimes(placed.routine), facts.seen_through(condition)
    whole = seen if call is None else All((seen, call), condition.span)
    first = Contact(Cell(FIRST_SCAN, condition.span), condition.span)
    return FIRST_SCAN in looked_at(whole) and implies(first, whole)


def _is_meant(facts: Facts, address: Address) -> bool:
    """True if retention is intended: a counter's, one that the source declares, one that is not the bank's default.

    Most registers are retentive because CLICK makes them so, and clearing a step in the first scan is good practice.
    """
    if address.bank == "CT" or not BANKS[address.bank].retentive:
        return True
    declared = facts.declared.get(address)
    in_block = any(
        block.retentive and block.range.bank == address.bank and block.range.first <= address.number <= block.range.last
        for block in facts.program.blocks
    )
    return bool(declared and declared.retentive) or in_block


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a value that is to be kept is cleared in the first scan",
    """
A counter is retentive in CLICK unless the table says No: it goes on counting after a power failure. The first scan in
its reset undoes that, and a batch or an hour meter starts again after every short dip of the supply. The same holds for
a bit or register that was declared `retentive=True`.

If it should start again, `retentive=False` says so, and the rule is silent. Registers that are retentive only because
CLICK makes them so are left alone: to clear a step in the first scan is good practice.
""",
    wrong=(
        Wrong(
            """
if re(x.Part):
    ctu(ct.Parts, 1000).reset(any(c.NewBatch, sc._1st_SCAN))  # <-
"""
        ),
        Wrong(
            """
if sc._1st_SCAN:
    copy_fill(0, ctd[10:20])  # <-
if re(x.Part):
    ctu(ct[10], 1000).reset(c.NewBatch)
if re(x.Bad):
    ctu(ct[11], 1000).reset(c.NewBatch)
"""
        ),
        Wrong(
            """
nickname(ds.Hours, ds[10], retentive=True, comment="of the spindle")
nickname(c.Homed, c[5], retentive=True)


def main():
    if sc._1st_SCAN:
        out(c.Starting)

    if c.Starting:
        copy(0, ds.Hours)  # <-
        copy(0, ctd.Strokes)  # <-
        reset(c.Homed)  # <-

    if re(x.Stroke):
        ctu(ct.Strokes, ds.Hours).reset(c.Clear)

    if c.Service:
        set(c.Homed)

    if all(ct.Strokes, c.Homed):
        calc("ds.Hours + 1", ds.Hours)

    if True:
        end()
"""
        ),
    ),
    right=(
        """
nickname(ct.Parts, ct[1], retentive=False)


def main():
    if re(x.Part):
        ctu(ct.Parts, 1000).reset(any(c.NewBatch, sc._1st_SCAN))

    if True:
        end()
""",
        """
if sc._1st_SCAN:
    copy(0, ds.Step)
    reset(c.Alarm)
if re(x.Part):
    ctu(ct.Parts, 1000).reset(all(c.NewBatch, sc._1st_SCAN))
if x.Trip:
    set(c.Alarm)
if x.Heat:
    rton(t.Soak, 30, unit=Tm).reset(any(c.Again, sc._1st_SCAN))
if all(c.Alarm, ds.Step == 3):
    copy(0, ds.Step)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
