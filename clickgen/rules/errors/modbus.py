"""What a send or receive moves fits both ends: bits to bits, registers to registers, within Modbus' limits.

click-facts [message.count, modbus.requests]
"""

from __future__ import annotations

import re
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
from clickgen.facts.facts import Facts
from clickgen.instructions.effects import Shape
from clickgen.ir.modbus import Remote, RemoteCell, RemoteModbus, RtuTarget
from clickgen.ir.operands import Cell, Range
from clickgen.ir.program import Action
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.wording import counted


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        if placed.effects.shape is Shape.MESSAGE:
            _check(facts, placed.action, problems)


def _check(facts: Facts, action: Action, problems: Diagnostics) -> None:
    is_send = isinstance(action.moved_to, Remote)
    own, remote = (action.moved, action.moved_to) if is_send else (action.moved_to, action.moved)
    assert isinstance(remote, Remote)
    if isinstance(action.args["target"], RtuTarget) and action.args["target"].device_id == 0 and not is_send:
        problems.add(
            "CG302", action.args["target"].span, "no device answers to number 0: it is for sending to all", "name one"
        )
    _check_writable(remote, is_send, problems)
    if not isinstance(own, Cell | Range):
        return
    is_bits = BANKS[own.bank].is_bit
    if action.flag("word_swap") and is_bits:
        problems.add("CG314", action.args["word_swap"].span, "bits have no words to swap", "leave out word_swap")
    if _is_bits(remote) != is_bits:
        there, here = ("bits", "registers") if _is_bits(remote) else ("registers", "bits")
        problems.add(
            "CG305",
            remote.span,
            f"{_shown(remote)}{' is a coil: it' if _is_short_coil(remote) else ''} holds {there} and {own.bank} holds "
            f"{here}",
            _six_digits(remote) or "name an address of the same kind on both ends",
        )
        return
    if _is_short_coil(remote) and not _SIX_DIGITS.search(facts.text(remote.span)):
        _check_manual(remote, problems)
    _check_length(own, remote, is_send, problems)


# -- numbers as manuals print them ------------------------------------------------------------------------------------

_SIX_DIGITS = re.compile(r"""["']0[0-9]{5}["']""")
"""A coil that is written with all its digits: it is meant."""


def _is_short_coil(remote: Remote) -> bool:
    """True for a coil written as a number: manuals mean something else by many of these."""
    return isinstance(remote, RemoteModbus) and not remote.register_type and register_type_of(remote.number) == COIL


def _six_digits(remote: Remote) -> str:
    """The way out for a coil where a register belongs: what a manual means by the number."""
    if not isinstance(remote, RemoteModbus) or not _is_short_coil(remote):
        return ""
    manual = of_manual(remote.number)
    if manual is None:
        number = NUMBERS_984[HOLDING][0] - 1 + remote.number
        return (
            f"holding registers begin at {NUMBERS_984[HOLDING][0]}: register {remote.number} of a manual that counts "
            f"from 1 is ModbusAddress(address={number})"
        )
    name, number = manual
    into = ", and goes into bits" if name in BIT_TYPES else ""
    meant = f"{remote.number} of a manual, {TYPE_WORDS[name]}"
    return f"CLICK has six digits: {meant}, is ModbusAddress(address={number}){into}"


def _check_manual(remote: Remote, problems: Diagnostics) -> None:
    """A coil whose number a manual has for something else."""
    assert isinstance(remote, RemoteModbus)
    manual = of_manual(remote.number)
    if manual is None:
        return
    name, number = manual
    coil = f'ModbusAddress(address="{remote.number - 1:X}h", register_type="{COIL}")'
    if name in BIT_TYPES:
        way = f"write ModbusAddress(address={number}) for the input"
    else:
        way = f"for the register write ModbusAddress(address={number}), and registers on this end"
    problems.add(
        "CG551",
        remote.span,
        f"{remote.number} is a coil here, because CLICK has six digits; in a manual it is {TYPE_WORDS[name]}",
        f"{way}; for the coil write {coil}",
    )


# -- what fits --------------------------------------------------------------------------------------------------------


def _check_writable(remote: Remote, is_send: bool, problems: Diagnostics) -> None:
    # click-facts [bank.read-only, message.remote-system]
    if not is_send:
        return
    if isinstance(remote, RemoteModbus) and _register_type(remote) in READ_ONLY_TYPES:
        problems.add("CG304", remote.span, f"{_shown(remote)} is an input: Modbus only reads it", "receive it")
    elif isinstance(remote, RemoteCell) and remote.address.bank in (*READ_ONLY, "SC", "SD"):
        problems.add(
            "CG304",
            remote.span,
            f"{remote.address} of the other CLICK cannot be written from here",
            "send to Y, C, or a register",
        )


def _check_length(own: Cell | Range, remote: Remote, is_send: bool, problems: Diagnostics) -> None:
    length = len(own) if isinstance(own, Range) else 1
    is_bits = BANKS[own.bank].is_bit
    size = length * _words(own.bank)
    if is_bits:
        most, what = BITS_WRITTEN_MAX if is_send else BITS_READ_MAX, "bits"
    else:
        most, what = WORDS_WRITTEN_MAX if is_send else WORDS_READ_MAX, "words"
    if size > most:
        problems.add(
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
            problems.add(
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
