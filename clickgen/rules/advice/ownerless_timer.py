"""A timer or counter that is looked at but that no instruction drives."""

from __future__ import annotations

from clickgen.device.banks import CURRENT_VALUE_OF, VALUE_BANK, Address, current_value
from clickgen.facts.facts import Facts
from clickgen.facts.uses import addresses_of
from clickgen.ir.operands import Operand, form_of
from clickgen.problems.diagnostics import did_you_mean
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [timer.unowned]
CODE = "CG521"

_INSTRUCTIONS = {"T": "ton, tof, rton or rtof", "CT": "ctu, ctd or ctud"}


def find(facts: Facts) -> Findings:
    said: set[Address] = set()
    for use in facts.uses.every:
        bank = form_of(use.operand)
        if use.is_written or (bank not in VALUE_BANK and bank not in CURRENT_VALUE_OF):
            continue
        addresses = addresses_of(use.operand)
        # A range may hold spare numbers beside those that are driven.
        if said.issuperset(map(_number, addresses)) or any(_is_driven(facts, address) for address in addresses):
            continue
        said.update(map(_number, addresses))
        yield from _report(facts, use.operand, addresses)


def _number(address: Address) -> Address:
    """The timer or counter that a bit or a current value belongs to."""
    return address._replace(bank=CURRENT_VALUE_OF.get(address.bank, address.bank))


def _is_driven(facts: Facts, address: Address) -> bool:
    """True if an instruction owns it, and for a current value that any other instruction writes."""
    return bool(facts.uses.writes(address)) or facts.uses.is_pointed(address.bank, is_written=True)


def _report(facts: Facts, operand: Operand, addresses: list[Address]) -> Findings:
    first, number = addresses[0], _number(addresses[0])
    value = current_value(first)
    without_bit = (one.spec.name for one in facts.writers(value) if one.spec.owns and one.effects.done is None)
    owner = next(without_bit, "") if len(addresses) == 1 else ""
    if owner:
        fault = f"{facts.shown(value)} belongs to a {owner}, which has no bit: {first} never comes on"
        help = "use the completion flag of the drum, or compare its current value"
    else:
        fate = "the bit never comes on" if first == number else "the value never changes"
        fault = f"no {_INSTRUCTIONS[number.bank]} drives {facts.listed(addresses)}: {fate} (C1002)"
        help = _near_name(facts, number) or "add its instruction, or correct the address"
    yield finding(CODE, operand.span, fault, help)


def _near_name(facts: Facts, number: Address) -> str:
    others = (address for address in facts.uses.addresses if address.bank == number.bank and facts.uses.writes(address))
    return did_you_mean(facts.nickname(number), filter(None, map(facts.nickname, others)))


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a timer's or counter's bit is used without its instruction",
    """
A contact on a timer or counter that has no instruction anywhere stays as it is for ever: the delay never ends, the
batch is never full. CLICK warns of it too (C1002). Mostly the name is a little wrong, or the timer's rung was removed
and its contact stayed.

The current value of a time drum is fine, and so is one that a copy writes.
""",
    wrong=(
        Wrong(
            """
if c.Running:
    ton(t.StartDelay, setpoint=5, unit=Ts)

if t.StartDely:  # <-
    out(y.Motor)
"""
        ),
        Wrong(
            """
if td[7] > 100:  # <-
    out(y.Lamp)

if t[7]:
    out(y.Horn)
"""
        ),
        Wrong(
            """
if c.Run:
    time_drum([y.Red, y.Green], [20, 30], Ts, [[1, 0], [0, 1]], ds.Phase, td[3], c.Done, reset=lambda: c.Stop)

if t[3]:  # <-
    out(y.Bell)
"""
        ),
    ),
    right=(
        """
if c.Running:
    ton(t.StartDelay, setpoint=5, unit=Ts)

if all(t.StartDelay, td.StartDelay < 30000):
    out(y.Motor)
""",
        """
if c.Run:
    time_drum([y.Red, y.Green], [20, 30], Ts, [[1, 0], [0, 1]], ds.Phase, td[3], c.Done, reset=lambda: c.Stop)

if td[3] > 15:
    out(y.Soon)
""",
        """
if x.Reset:
    copy(0, ctd[5])

if ctd[5] > 10:
    out(y.Lamp)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
