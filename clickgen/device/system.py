"""CLICK's own points: the names of its system relays and registers, and which of them a program may write.

The names are those that CLICK PLUS 3.41 shows (click-facts [system.names]). Spellings of other lists are known too,
so a program that was written with them still builds (click-facts [system.moved, system.spellings]);
scripts/make_system_nicknames.py says where each comes from.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple, TypeVar

from clickgen.device.banks import Address

ALWAYS_ON = Address("SC", 1)

WRITABLE_SC = frozenset((50, 51, 53, 55, 60, 61, 65, 66, 67, 75, 76, 120, 121, 303, 304, 305, 306, 323, 324, 325, 326))
"""The numbers of the SC bits that a coil may drive (click-facts [bank.writable-sc]), including the disputed ones."""

DISPUTED_SC = frozenset((305, 306, 325, 326))
"""SC bits that are writable in one list, taken from an export, but not in CLICK PLUS 3.41
(click-facts [bank.writable-sc-disputed])."""

WRITABLE_SD = frozenset(
    (29, 31, 32, 34, 35, 36, 40, 41, 42, 50, 51, 60, 61, 106, 107, 108, 112, 113, 114, *range(140, 148), 214, 215)
)
"""The numbers of the SD registers that an instruction may write (click-facts [bank.writable-sd]); CLICK 3.41 agrees."""

_STEADY = {"SC": frozenset((1, 2, 3, 40, 43, 44, 202)), "SD": frozenset((5, 6, 7, 8, 9, 13, *range(188, 200)))}
"""The system points that do not change until the next scan, unless an instruction of the program changes them.

SC1 to SC3 and SD9 count scans. SC40, SC43 and SC44 are results of instructions (click-facts [scan.flags]). SC202,
SD13, the firmware's versions (SD5 to SD8) and the MAC addresses (SD188 to SD199) are settings, by their names in
CLICK's own export (click-facts [scan.system-points]). No source says when CLICK changes the others, such as its clocks
and the reports of its ports.
"""

_Key = TypeVar("_Key", str, tuple[str, ...])
_DATA = Path(__file__).with_name("system_nicknames.csv")


class SystemPoint(NamedTuple):
    """One of CLICK's own points. ``name`` is "" if CLICK 3.41 shows none, ``other`` is the name in another list."""

    address: Address
    name: str
    other: str


@cache
def system_points() -> tuple[SystemPoint, ...]:
    """Every point that CLICK names itself, in CLICK's row order."""
    # Made by scripts/make_system_nicknames.py: SC and SD only, no quotes, a name may hold anything but a comma.
    rows = (line.split(",") for line in _DATA.read_text("utf-8").splitlines()[1:])
    return tuple(SystemPoint(Address(address[:2], int(address[2:])), name, other) for address, name, other in rows)


@cache
def system_nicknames() -> dict[str, tuple[str, Address]]:
    """The names that CLICK shows and that mean one address: lowercase name to the name and its address."""
    return {
        point.name.lower(): (point.name, point.address)
        for point in system_points()
        if point.name and len(addresses_of_system_name(point.name)) == 1
    }


def addresses_of_system_name(name: str) -> tuple[Address, ...]:
    """Return the meaning of one of CLICK's own names: several addresses if it is in doubt, none for any other name.

    Case does not count. Nor do spaces, since CLICK puts one before some brackets and not before others
    (``_RTC_Year(4 digits)``) and nobody remembers which. A name has two addresses if it moved between versions of
    CLICK, or if CLICK 3.41 does not show it and it differs only in spaces and underscores from names of two
    addresses: ``_I/O_Module_Error`` is SC22 in an older list, and SC20 is ``_I/O Module Error`` in CLICK 3.41.
    """
    lower = name.lower()
    known = _by_name().get(lower) or _by_name_without_spaces().get(lower.replace(" ", ""), ())
    alike = _by_letters().get(_letters(name), ())
    if len(alike) > 1 and not any(_shown().get(address, "").lower() == lower for address in known):
        return alike
    return known


def doubt_about(name: str) -> str:
    """The reason why a name has several addresses: ``_X is SD132 in CLICK 3.41 and SD134 in another version``."""
    addresses = addresses_of_system_name(name)
    said = [
        (written, f"{address} in {'CLICK 3.41' if written == point.name else 'another version'}")
        for address in addresses
        for point in system_points()
        for written in (point.name, point.other)
        if point.address == address and _letters(written) == _letters(name)
    ]
    if len({written for written, _ in said}) == 1:
        return f"{name} is {' and '.join(where for _, where in said)}"
    return f"{name} reads like {', and like '.join(f'{written!r}, which is {where}' for written, where in said)}"


def changes_by_itself(address: Address) -> bool:
    """True for a system point that CLICK may change in the middle of a scan."""
    return address.bank in _STEADY and address.number not in _STEADY[address.bank]


def find_system_name(name: str) -> tuple[str, Address] | None:
    """The system point with this name, and the name that CLICK shows for it; None if two points have had the name."""
    addresses = addresses_of_system_name(name)
    return (_shown()[addresses[0]], addresses[0]) if len(addresses) == 1 else None


def system_name_of(address: Address) -> str | None:
    """The nickname that CLICK shows for one of its own addresses, or None."""
    return _shown().get(address)


def is_system_name_of(name: str, address: Address) -> bool:
    """True for a name that CLICK gives to this address, even in one version only."""
    return address in addresses_of_system_name(name)


def near_system_name(name: str, bank: str) -> str:
    """The only system point of a bank that a misspelled name can mean; "" if there is none, or a doubt.

    A register beside the right one is a wrong register: ``_RTC_New_Hour`` is no spelling of ``_RTC_Hours``. So numbers,
    short words and words that CLICK uses itself must agree, and only one other word may have a slip in it.
    """
    same = {address for address in _by_letters().get(_letters(name), ()) if address.bank == bank}
    if not same:
        words = _words(name)
        points = system_nicknames().values()
        same = {address for shown, address in points if address.bank == bank and _is_slip(words, _words(shown))}
    if not same:
        same = {address for address in _by_meaning().get(_meaning(name), ()) if address.bank == bank}
    shown = {_shown().get(address, "") for address in same}
    return shown.pop() if len(shown) == 1 and all(name.lower() in system_nicknames() for name in shown) else ""


# -- indexes ----------------------------------------------------------------------------------------------------------


@cache
def _shown() -> dict[Address, str]:
    return {point.address: point.name for point in system_points() if point.name}


def _spellings() -> Iterator[tuple[str, Address]]:
    for point in system_points():
        for name in filter(None, (point.name, point.other)):
            yield name.lower(), point.address


def _grouped(pairs: Iterator[tuple[_Key, Address]]) -> dict[_Key, tuple[Address, ...]]:
    groups: dict[_Key, tuple[Address, ...]] = {}
    for key, address in pairs:
        known: tuple[Address, ...] = groups.get(key, ())
        groups[key] = known if address in known else (*known, address)
    return groups


@cache
def _by_name() -> dict[str, tuple[Address, ...]]:
    return _grouped(_spellings())


@cache
def _by_name_without_spaces() -> dict[str, tuple[Address, ...]]:
    return _grouped((name.replace(" ", ""), address) for name, address in _spellings())


@cache
def _by_letters() -> dict[str, tuple[Address, ...]]:
    return _grouped((_letters(name), address) for name, address in _spellings())


@cache
def _by_meaning() -> dict[tuple[str, ...], tuple[Address, ...]]:
    return _grouped((_meaning(name), address) for name, address in _spellings())


def _letters(name: str) -> str:
    return re.sub(r"[_ ]", "", name.lower())


# -- the same words otherwise -----------------------------------------------------------------------------------------

_SAME_WORDS = {
    word: meant
    for words, meant in (
        ("1st initial", "first"),
        ("s secs second seconds", "sec"),
        ("msec msecs millisecond milliseconds", "ms"),
        ("minute minutes", "min"),
        ("h hr hrs hours", "hour"),
        ("days", "day"),
        ("months", "month"),
        ("years", "year"),
        ("err errors", "error"),
        ("true", "on"),
        ("cycle", "scan"),
    )
    for word in words.split()
}
_SILENT_WORDS = frozenset(("clock", "flag", "bit", "the"))
"""Words that add nothing to two others: ``_1sec`` can only be ``_1sec_Clock``."""
_WORD = re.compile(r"1st|\d+|[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+", re.ASCII)


def _meaning(name: str) -> tuple[str, ...]:
    """The words of a name in one spelling: ``First_Scan`` is ``_1st_SCAN``, and ``Clock_1s`` is ``_1sec_Clock``.

    Their order stays: nobody knows whether ``_RTC_Hour_New`` is ``_RTC_New_Hour``.
    """
    words = [_SAME_WORDS.get(word.lower(), word.lower()) for word in _WORD.findall(name)]
    telling = [word for word in words if word not in _SILENT_WORDS]
    return tuple(telling if len(telling) > 1 else words)


# -- slips of the pen -------------------------------------------------------------------------------------------------

_SHORTEST_SLIP = 4
"""In a shorter word, another letter makes another word: ``on`` and ``of``, ``day`` and ``dry``."""


def _words(name: str) -> list[str]:
    return [word for word in re.split(r"[_ ]+", name.lower()) if word]


@cache
def _vocabulary() -> frozenset[str]:
    return frozenset(word for name, _ in _spellings() for word in _words(name))


def _is_slip(written: list[str], known: list[str]) -> bool:
    if len(written) != len(known):
        return False
    differing = [(one, other) for one, other in zip(written, known, strict=True) if one != other]
    if len(differing) != 1:
        return False
    [(one, other)] = differing
    return (
        one.isalpha()
        and other.isalpha()
        and max(len(one), len(other)) >= _SHORTEST_SLIP
        and one[0] == other[0]
        and one not in _vocabulary()
        and _is_one_letter_off(one, other)
    )


def _is_one_letter_off(one: str, other: str) -> bool:
    """True for one letter too many, too few or different, or two neighbours exchanged."""
    if len(one) > len(other):
        one, other = other, one
    start = next((index for index, letter in enumerate(one) if letter != other[index]), len(one))
    if len(one) < len(other):
        return one[start:] == other[start + 1 :]
    swapped = one[start : start + 2] == other[start : start + 2][::-1] and one[start + 2 :] == other[start + 2 :]
    return swapped or one[start + 1 :] == other[start + 1 :]
