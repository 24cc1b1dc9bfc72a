"""What a send or receive moves fits both ends: bits to bits, registers to registers, within Modbus' limits.

click-facts [message.count, modbus.requests]
"""

from __future__ import annotations

import re
from dataclasses import replace
from math import ceil

from clickgen.device.banks import BANKS, READ_ONLY, Kind
from clickgen.device.modbus import (
    BIT_TYPES,
    BITS_READ_MAX,
    BITS_WRITTEN_MAX,
    COIL,
    HOLDING,
    NUMBERS_984,
    READ_ONLY_TYPES,
    TYPE_WORDS,
    WORDS_READ_MAX,
    WORDS_WRITTEN_MAX,
    of_manual,
    register_type_of,
)
from clickgen.dialects.base import Spelling
from clickgen.facts.facts import Facts
from clickgen.instructions.effects import Shape
from clickgen.ir.modbus import Remote, RemoteCell, RemoteModbus, RtuTarget
from clickgen.ir.operands import Cell, Range
from clickgen.ir.program import Action
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.wording import counted


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        if placed.effects.shape is Shape.MESSAGE:
            yield from _check(facts, placed.action)


def _check(facts: Facts, action: Action) -> Findings:
    is_send = isinstance(action.moved_to, Remote)
    own, remote = (action.moved, action.moved_to) if is_send else (action.moved_to, action.moved)
    assert isinstance(remote, Remote)
    if isinstance(action.args["target"], RtuTarget) and action.args["target"].device_id == 0 and not is_send:
        yield finding(
            "CG302", action.args["target"].span, "no device answers to number 0: it is for sending to all", "name one"
        )
    yield from _check_writable(remote, is_send)
    if not isinstance(own, Cell | Range):
        return
    is_bits = BANKS[own.bank].is_bit
    if action.flag("word_swap") and is_bits:
        yield finding("CG314", action.args["word_swap"].span, "bits have no words to swap", "leave out word_swap")
    if _is_bits(remote) != is_bits:
        there, here = ("bits", "registers") if _is_bits(remote) else ("registers", "bits")
        yield finding(
            "CG305",
            remote.span,
            f"{_shown(remote)}{' is a coil: it' if _is_short_coil(remote) else ''} holds {there} and {own.bank} holds "
            f"{here}",
            _six_digits(facts.spell, remote) or "name an address of the same kind on both ends",
        )
        return
    if _is_short_coil(remote) and not _SIX_DIGITS.search(facts.text(remote.span)):
        yield from _check_manual(facts.spell, remote)
    yield from _check_length(own, remote, is_send)


# -- numbers as manuals print them ------------------------------------------------------------------------------------

_SIX_DIGITS = re.compile(r"""["']0[0-9]{5}["']""")
"""A coil that is written with all its digits: it is meant."""


def _is_short_coil(remote: Remote) -> bool:
    """True for a coil written as a number: manuals mean something else by many of these."""
    return isinstance(remote, RemoteModbus) and not remote.register_type and register_type_of(remote.number) == COIL


def _six_digits(spell: Spelling, remote: Remote) -> str:
    """The way out for a coil where a register belongs: what a manual means by the number."""
    if not isinstance(remote, RemoteModbus) or not _is_short_coil(remote):
        return ""
    manual = of_manual(remote.number)
    if manual is None:
        number = NUMBERS_984[HOLDING][0] - 1 + remote.number
        return (
            f"holding registers begin at {NUMBERS_984[HOLDING][0]}: register {remote.number} of a manual that counts "
            f"from 1 is {spell.remote(replace(remote, number=number))}"
        )
    name, number = manual
    into = ", and goes into bits" if name in BIT_TYPES else ""
    meant = f"{remote.number} of a manual, {TYPE_WORDS[name]}"
    return f"CLICK has six digits: {meant}, is {spell.remote(replace(remote, number=number))}{into}"


def _check_manual(spell: Spelling, remote: Remote) -> Findings:
    """A coil whose number a manual has for something else."""
    assert isinstance(remote, RemoteModbus)
    manual = of_manual(remote.number)
    if manual is None:
        return
    name, number = manual
    coil = spell.remote(replace(remote, number=remote.number - 1, register_type=COIL))
    meant = spell.remote(replace(remote, number=number))
    if name in BIT_TYPES:
        way = f"write {meant} for the input"
    else:
        way = f"for the register write {meant}, and registers on this end"
    yield finding(
        "CG551",
        remote.span,
        f"{remote.number} is a coil here, because CLICK has six digits; in a manual it is {TYPE_WORDS[name]}",
        f"{way}; for the coil write {coil}",
    )


# -- what fits --------------------------------------------------------------------------------------------------------


def _check_writable(remote: Remote, is_send: bool) -> Findings:
    # click-facts [bank.read-only, message.remote-system]
    if not is_send:
        return
    if isinstance(remote, RemoteModbus) and _register_type(remote) in READ_ONLY_TYPES:
        yield finding("CG304", remote.span, f"{_shown(remote)} is an input: Modbus only reads it", "receive it")
    elif isinstance(remote, RemoteCell) and remote.address.bank in (*READ_ONLY, "SC", "SD"):
        yield finding(
            "CG304",
            remote.span,
            f"{remote.address} of the other CLICK cannot be written from here",
            "send to Y, C, or a register",
        )


def _check_length(own: Cell | Range, remote: Remote, is_send: bool) -> Findings:
    length = len(own) if isinstance(own, Range) else 1
    is_bits = BANKS[own.bank].is_bit
    size = length * _words(own.bank)
    if is_bits:
        most, what = BITS_WRITTEN_MAX if is_send else BITS_READ_MAX, "bits"
    else:
        most, what = WORDS_WRITTEN_MAX if is_send else WORDS_READ_MAX, "words"
    if size > most:
        yield finding(
            "CG306",
            own.span,
            f"this range is {size} {what} and one Modbus request takes {most}",
            "divide it over several",
        )
    if isinstance(remote, RemoteCell):
        address = remote.address
        bank = BANKS[address.bank]
        reach = ceil(size / _words(address.bank))
        last = address.number + reach - 1
        if not any(low <= address.number and last <= high for low, high in bank.ranges):
            yield finding(
                "CG306",
                remote.span,
                f"{counted(reach, 'address', 'addresses')} from {address} on leave the bank: {bank.name} has "
                f"{bank.describe_range()}",
                "begin earlier, or move fewer",
            )


def _words(bank: str) -> int:
    """The Modbus registers that one address takes; a bit is one coil."""
    return 2 if BANKS[bank].kind in (Kind.INT32, Kind.FLOAT) else 1


def _register_type(remote: RemoteModbus) -> str | None:
    return remote.register_type or register_type_of(remote.number)


def _is_bits(remote: Remote) -> bool:
    if isinstance(remote, RemoteCell):
        return BANKS[remote.address.bank].is_bit
    return _register_type(remote) in BIT_TYPES


def _shown(remote: Remote) -> str:
    if isinstance(remote, RemoteCell):
        return str(remote.address)
    return f"{remote.number:X}h ({remote.register_type})" if remote.register_type else str(remote.number)


ABOUT = Code(
    "CG551",
    Severity.WARNING,
    "a Modbus number means a coil here and another register in a manual",
    """
Manuals print Modbus numbers with five digits. The first digit gives the kind: 40001 is the first holding
register. CLICK uses six digits for the same number, 400001. In CLICK, a number with five digits is a coil: 10001, the
manual's first input, is coil 10001. The device then returns some other bit, or an error.

| In a manual | Meaning | In CLICK |
|---|---|---|
| 00001 | coil 1 | 1 |
| 10001 | discrete input 1 | 100001 |
| 30001 | input register 1 | 300001 |
| 40001 | holding register 1 | 400001 |

The coils 16385 to 18384 are C1 to C2000 of another CLICK, so clickgen does not warn about them. For registers, a
number with five digits does not fit. That is an error, [CG305](CG305.md), whose message gives the six digits.
""",
    wrong=(
        Wrong(
            """
if x[1]:
    receive(ModbusTcpTarget(ip="192.168.1.10"), ModbusAddress(address=10001), c[1:9])  # <-
""",
        ),
    ),
    right=(
        """
if x[1]:
    receive(ModbusTcpTarget(ip="192.168.1.10"), ModbusAddress(address=100001), c[1:9])
    receive(ModbusTcpTarget(ip="192.168.1.10"), ModbusAddress(address="2710h", register_type="coil"), c[11:19])
""",
    ),
)

RULE = Rule(
    find,
    (ABOUT,),
    also=(
        "CG302",
        "CG304",
        "CG305",
        "CG306",
        "CG314",
    ),
    holds_in_parts=True,
)
