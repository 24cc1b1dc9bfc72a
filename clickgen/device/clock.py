"""CLICK's clock: the registers that show the time, those that set it, and the range of each.

CLICK's help gives the ranges, and 1 for Sunday to 7 for Saturday (click-facts [system.clock]).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from clickgen.device.banks import Address


class Part(NamedTuple):
    """A part of the time, and its least and greatest value."""

    name: str
    low: int
    high: int
    note: str = ""


_YEAR = Part("year", 1000, 9999, "in 4 digits")
_MONTH, _DAY = Part("month", 1, 12), Part("day", 1, 31)
_HOUR, _MINUTE, _SECOND = Part("hour", 0, 23), Part("minute", 0, 59), Part("second", 0, 59)

_SHOWN = {
    19: _YEAR,
    20: Part("year", 0, 99, "in 2 digits"),
    21: _MONTH,
    22: _DAY,
    23: Part("day of the week", 1, 7, "1 is Sunday, 7 Saturday"),
    24: _HOUR,
    25: _MINUTE,
    26: _SECOND,
}
_SET = {29: _YEAR, 31: _MONTH, 32: _DAY, 34: _HOUR, 35: _MINUTE, 36: _SECOND}

CLOCK: Mapping[Address, Part] = {Address("SD", number): part for number, part in (_SHOWN | _SET).items()}
"""The registers of the clock, including those that set it."""

SETS_CLOCK = frozenset(Address("SD", number) for number in _SET)
"""The registers that SC53 (date) and SC55 (time) take over (click-facts [system.clock-set])."""
