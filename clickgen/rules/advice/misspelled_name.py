"""A name that only reads, or only writes, beside one that looks like it: one of the two is misspelled."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.facts.uses import Use
from clickgen.problems.diagnostics import Label
from clickgen.problems.name_slips import Spellings
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG540"

_BANKS = ("X", "Y", "C", "DS", "DD", "DH", "DF", "TXT")
"""CG521 reports a timer or counter that no instruction drives."""


class _Name(NamedTuple):
    """A name of the program and its uses."""

    name: str
    address: Address
    reads: list[Use]
    writes: list[Use]
    is_given: bool
    """True if something gives it a value: an instruction, a declaration, the world outside."""
    is_declared: bool


def find(facts: Facts) -> Findings:
    by_bank: dict[str, dict[str, _Name]] = defaultdict(dict)
    for address in facts.uses.addresses:
        nickname = facts.nickname(address)
        if nickname and address.bank in _BANKS:
            by_bank[address.bank][nickname] = _described(facts, address, nickname)
    for bank, names in by_bank.items():
        spellings = Spellings(names)
        said: set[str] = set()
        # A reader of a misspelled name waits in vain: it is reported first, and the pair once.
        for one in sorted(names.values(), key=lambda name: not name.reads or name.is_given):
            if one.is_declared or one.name in said:
                continue
            for other in (names[near] for near in spellings.near(one.name)):
                if _is_suspect(bank, one, other):
                    said.update((one.name, other.name))
                    yield from _report(facts, one, other)
                    break


def _described(facts: Facts, address: Address, nickname: str) -> _Name:
    reads, writes = facts.uses.reads(address), facts.uses.writes(address)
    is_given = facts.uses.is_pointed(address.bank, is_written=True) or facts.is_set_up(address)
    # A reset gives a bit nothing: a bit that is only reset is never on. Nobody knows what a kept instruction does.
    is_given = is_given or any(use.action is None or use.action.turns is not False for use in writes)
    return _Name(nickname, address, reads, writes, is_given, address in facts.declared)


def _is_suspect(bank: str, one: _Name, other: _Name) -> bool:
    """True if one of two names that look alike lacks a half that the other has, and nobody declared it."""
    if any(use.action and use.action.effects.is_unknown for use in (*one.reads, *one.writes)):
        return False
    if bank == "X":
        # An input is given from outside; a build has chosen an undeclared name beside a declared one.
        return other.is_declared
    if one.reads and not one.is_given:
        return other.is_given or not other.reads
    if bank == "Y":
        # An output acts by itself: it is suspect only if the other one waits for it.
        return bool(one.writes) and not one.reads and bool(other.reads) and not other.is_given
    return bool(one.writes) and not one.reads and bool(other.reads)


def _report(facts: Facts, one: _Name, other: _Name) -> Findings:
    is_read = bool(one.reads)
    use = one.reads[0] if is_read else one.writes[0]
    there = next(iter((other.writes if is_read else other.reads) or [*other.writes, *other.reads]))
    declared = facts.spell.declaration(facts.spell.name(one.address.bank, one.name), facts.spell.cell(one.address))
    what = "never written" if is_read else "never read"
    if one.address.bank == "X":
        what = "not declared"
    yield finding(
        CODE,
        use.operand.span,
        f"{facts.shown(one.address)} is {what}, and {facts.shown(other.address)} in "
        f"{there.operand.span.seen_from(use.operand.span)} has a name that looks like it",
        f"write {other.name} in both places; where both are meant, declare this one: {declared}",
        (Label(there.operand.span, f"{other.name} is here"),),
    )


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a name looks like a misspelling of another",
    """
clickgen gives every new name an address. A misspelled name is a new name, so it builds: the contact on it waits for
ever for a bit that nobody sets, and the guard that was to stop the machine does not.

The rule speaks where a name is read and nothing writes it, or is written and nothing reads it, and another name of the
bank is the same but for a slip of the hand: two letters swapped, one dropped, doubled or mistaken, another separator.
Names that differ in a number, in a letter at the end, or by two words of the trade such as `Fill` and `Full` are left
alone. So is a name that `nickname(...)` declares: somebody meant it. Declare what a panel or another device writes.
""",
    wrong=(
        Wrong(
            """
if x.GuardOpen:
    set(c.Guard_Fault)

if x.Acknowledge:
    reset(c.Guard_Fault)

if all(c.Run, nc(c.Gaurd_Fault)):  # <-
    out(y.Motor)
"""
        ),
        Wrong(
            """
if x.Part:
    calc("sd[1] * 10", ds.Weigth)

if ds.Weight > 500:  # <-
    out(y.Reject)
"""
        ),
        Wrong(
            """
if x.Start:
    set(c.MotorRunning)

if x.Stop:
    reset(c.Motor_Running)  # <-

if c.MotorRunning:
    out(y.Motor)
"""
        ),
        Wrong(
            """
nickname(x.StopButton, x[2])


def main():
    if all(any(x[1], y.Motor), x.StopButton):
        out(y.Motor)

    if x.StopButon:  # <-
        out(y.Lamp)

    if True:
        end()
"""
        ),
    ),
    right=(
        """
if x.Start1:
    set(c.Pump1)

if c.Pump2:
    out(y.Motor)
""",
        """
if x.Level:
    set(c.TankFull)

if x.Empty:
    reset(c.TankFull)

if c.TankFill:
    out(y.Valve)
""",
        """
nickname(ds.Speeed, ds[10], comment="the panel writes it")


def main():
    if ds.Speeed > 10:
        copy(5, ds.Speed)

    if ds.Speed > 3:
        out(y.Lamp)

    if True:
        end()
""",
    ),
)

RULE = Rule(find, (ABOUT,))
