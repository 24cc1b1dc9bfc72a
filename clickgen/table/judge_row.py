"""The faults that CLICK finds in a row of the address table, in words: the same for a CSV and a workbook."""

from __future__ import annotations

import re
from typing import NamedTuple

from clickgen.device.banks import BANKS, Address
from clickgen.device.nicknames import comment_fault, nickname_fault_at
from clickgen.table.rows import initial_fault

_FIXED = ("XD", "YD")
"""The banks of words whose settings nobody can change; an import accepts their rows all the same."""


class Fault(NamedTuple):
    """A fault in a field, and the way out."""

    message: str
    way_out: str


def no_address(text: str) -> Fault:
    """The fault of a text that ``parse_address`` cannot read."""
    name = re.match(r"[A-Za-z]{0,4}", text.strip())
    bank = BANKS.get(name[0].upper()) if name else None
    way_out = f"{bank.name} has {bank.describe_range()}" if bank else f"the banks are {' '.join(BANKS)}"
    return Fault(f"CLICK has no address {short(text)}", way_out)


def initial_value_fault(address: Address, text: str) -> Fault | None:
    """The fault of an initial value in CLICK's form, or None."""
    expected = initial_fault(address.kind, text)
    if expected is not None:
        return Fault(f"{address} cannot start with the value {short(text)}", f"write {expected}")
    return _fixed(address, "initial value", "0") if address.bank in _FIXED and int(text, 16) else None


def retention_fault(address: Address, retentive: bool) -> Fault | None:
    """The fault of a row that says an address keeps its value without power, or does not; or None."""
    return _fixed(address, "retentive", "No") if retentive and address.bank in _FIXED else None


def address_comment_fault(address: Address, comment: str) -> Fault | None:
    """The fault of the comment of an address, or None."""
    fault = comment_fault(comment)
    if fault is None:
        return None
    way_out = "shorten the comment" if "takes" in fault else "take the character out of the comment"
    return Fault(f"CLICK does not take the comment of {address}: {fault}", way_out)


def address_nickname_fault(address: Address, name: str) -> Fault | None:
    """The fault of the nickname of an address, or None; CLICK's own names pass on CLICK's own points."""
    fault = nickname_fault_at(address, name)
    if fault is None:
        return None
    return Fault(
        f"CLICK does not take the nickname {short(name)} of {address}: {fault}",
        "rename it in CLICK and export again, or rename it here and in the program",
    )


def may_share_a_name(one: Address, other: Address) -> bool:
    """True for two of CLICK's own points: CLICK sometimes gives one name to two of them.

    click-facts [system.doubles]
    """
    return not {one.bank, other.bank} - {"SC", "SD"}


def short(text: str) -> str:
    """A field for a message: on one line and not too long."""
    if not text:
        return '""'
    if len(text) > 40:
        text = text[:40] + "..."
    return text if text.isprintable() else ascii(text)


def _fixed(address: Address, setting: str, expected: str) -> Fault:
    return Fault(f"CLICK lets nobody change the {setting} setting of {address}", f"write {expected}")
