"""CLICK's own points: the names of its system relays and registers, and which of them a program may write."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from clickgen.device.banks import Address

ALWAYS_ON = Address("SC", 1)

WRITABLE_SC = frozenset((50, 51, 53, 55, 60, 61, 65, 66, 67, 75, 76, 120, 121, 303, 304, 323, 324))
"""The numbers of the SC bits that a coil may drive (click-facts, section 3)."""

WRITABLE_SD = frozenset(
    (29, 31, 32, 34, 35, 36, 40, 41, 42, 50, 51, 60, 61, 106, 107, 108, 112, 113, 114, *range(140, 148), 214, 215)
)
"""The numbers of the SD registers that an instruction may write (click-facts, section 3)."""

_STEADY = {"SC": frozenset((1, 2, 3, 40, 43, 44, 202)), "SD": frozenset((5, 6, 7, 8, 9, 13, *range(188, 200)))}
"""The system points that stay as they are until the next scan, unless an instruction of the program changes them.

SC1 to SC3 and SD9 count scans. SC40, SC43 and SC44 are results of instructions (click-facts, sections 4 and 8). SC202,
SD13, the firmware's versions (SD5 to SD8) and the MAC addresses (SD188 to SD199) are settings. So their names say in
CLICK's own export (click-facts, section 1, E341). No source says when CLICK changes the others, such as its clocks and
what a port reports.
"""

_DATA = Path(__file__).with_name("system_nicknames.csv")


@cache
def system_nicknames() -> dict[str, tuple[str, Address]]:
    """CLICK's own nicknames: lowercase name to the name as CLICK writes it and its address.

    Where two addresses share a name, the first of them has it here; ``system_name_of`` knows both.
    """
    names: dict[str, tuple[str, Address]] = {}
    for address, name in _names_by_address().items():
        names.setdefault(name.lower(), (name, address))
    return names


def changes_by_itself(address: Address) -> bool:
    """True for a system point that CLICK may change in the middle of a scan."""
    return address.bank in _STEADY and address.number not in _STEADY[address.bank]


def find_system_name(name: str) -> tuple[str, Address] | None:
    """The system point of this name, whatever its case and spaces.

    CLICK sets a space before some brackets and not before others (``_RTC_Year (4 digits)``); nobody remembers which.
    """
    return system_nicknames().get(name.lower()) or _names_without_spaces().get(name.lower().replace(" ", ""))


@cache
def _names_without_spaces() -> dict[str, tuple[str, Address]]:
    return {lower.replace(" ", ""): point for lower, point in reversed(system_nicknames().items())}


def system_name_of(address: Address) -> str | None:
    """CLICK's own nickname of an address, or None."""
    return _names_by_address().get(address)


@cache
def _names_by_address() -> dict[Address, str]:
    # Made by scripts/make_system_nicknames.py: SC and SD only, no quotes, a name may hold anything but a comma.
    names: dict[Address, str] = {}
    for line in _DATA.read_text("utf-8").splitlines()[1:]:
        address, _, name = line.partition(",")
        names[Address(address[:2], int(address[2:]))] = name
    return names
