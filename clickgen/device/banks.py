"""The 16 memory banks and addresses in them (click-facts [bank.ranges])."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from typing import NamedTuple


class Kind(Enum):
    """The content of one cell of a bank; the value is CLICK's word for it in a nickname CSV."""

    BIT = "BIT"
    INT16 = "INT"
    INT32 = "INT2"
    HEX = "HEX"
    FLOAT = "FLOAT"
    TEXT = "TEXT"


INTEGER_RANGES = {Kind.INT16: (-32768, 32767), Kind.INT32: (-(2**31), 2**31 - 1)}
"""The least and greatest whole number of a cell (click-facts [value.integers])."""

VALUE_CLASSES = {
    Kind.INT16: "decimal",
    Kind.INT32: "decimal",
    Kind.FLOAT: "decimal",
    Kind.HEX: "hexadecimal",
    Kind.TEXT: "text",
    Kind.BIT: "bit",
}
"""Kinds that can be compared only with their own class (click-facts [compare.classes])."""

FLOAT_MAX = 3.4028235e38
FLOAT_MIN = 1.1754944e-38
"""The greatest and the least magnitude of a 32-bit floating-point number, 0 aside (click-facts [value.floats])."""

TEXT_WIDTHS = {Kind.INT16: 6, Kind.INT32: 11, Kind.HEX: 4, Kind.FLOAT: 15}
"""The most characters that a number becomes, its sign included (click-facts [value.float-text, value.number-text])."""

PADDED_DIGITS = {Kind.INT16: 5, Kind.INT32: 10, Kind.HEX: 4}
"""The digits of a number in text that keeps its zeros (click-facts [value.number-text])."""

# Ten slots of 16 points; X017..X020 and the like do not exist (click-facts [bank.slots]).
_SLOTS = ((1, 16), (21, 36), *((n * 100 + 1, n * 100 + 16) for n in range(1, 9)))


@dataclass(frozen=True)
class Bank:
    """One memory bank. ``ranges`` are inclusive; ``retentive`` is CLICK's default for its cells.

    click-facts [bank.defaults]
    """

    name: str
    kind: Kind
    ranges: tuple[tuple[int, int], ...]
    title: str
    retentive: bool = False
    settings_fixed: bool = False
    """True if nobody can edit initial value and retention in CLICK: SC, SD, XD, YD (click-facts [bank.fixed])."""
    allocatable: bool = True
    """True if clickgen may choose an address for a name here."""
    digits: int = 1

    @property
    def first(self) -> int:
        return self.ranges[0][0]

    @property
    def last(self) -> int:
        return self.ranges[-1][1]

    @property
    def is_bit(self) -> bool:
        return self.kind is Kind.BIT

    @property
    def dsl(self) -> str:
        """The bank's name in a program: ``ds``."""
        return self.name.lower()

    def has(self, number: int) -> bool:
        for first, last in self.ranges:  # noqa: SIM110  any() takes twice the time, and every address asks.
            if first <= number <= last:
                return True
        return False

    def gap_in(self, first: int, last: int) -> int | None:
        """The first number of a stretch that the bank does not have; None if it has them all."""
        for start, end in self.ranges:
            if start <= first <= end:
                first = end + 1
        return first if first <= last else None

    def numbers(self) -> Iterator[int]:
        for first, last in self.ranges:
            yield from range(first, last + 1)

    def describe_range(self) -> str:
        """The legal numbers for a message: ``1..16, 21..36, 101..116``."""
        return ", ".join(f"{first}..{last}" for first, last in self.ranges)


def _bank(name: str, kind: Kind, last: int, title: str, retentive: bool = False, **more: bool) -> Bank:
    return Bank(name, kind, ((1, last),), title, retentive, **more)


_ALL = (
    Bank("X", Kind.BIT, _SLOTS, "input bits", digits=3),
    Bank("Y", Kind.BIT, _SLOTS, "output bits", digits=3),
    _bank("C", Kind.BIT, 2000, "control relays"),
    _bank("T", Kind.BIT, 500, "timer bits"),
    _bank("CT", Kind.BIT, 250, "counter bits", retentive=True),
    _bank("SC", Kind.BIT, 1000, "system control relays", settings_fixed=True, allocatable=False),
    _bank("DS", Kind.INT16, 4500, "16-bit integers", retentive=True),
    _bank("DD", Kind.INT32, 1000, "32-bit integers", retentive=True),
    _bank("DH", Kind.HEX, 500, "hexadecimal words", retentive=True),
    _bank("DF", Kind.FLOAT, 500, "floating-point numbers", retentive=True),
    Bank("XD", Kind.HEX, ((0, 8),), "input words", settings_fixed=True, allocatable=False),
    Bank("YD", Kind.HEX, ((0, 8),), "output words", settings_fixed=True, allocatable=False),
    _bank("TD", Kind.INT16, 500, "timer current values", allocatable=False),
    _bank("CTD", Kind.INT32, 250, "counter current values", retentive=True, allocatable=False),
    _bank("SD", Kind.INT16, 1000, "system data registers", settings_fixed=True, allocatable=False),
    _bank("TXT", Kind.TEXT, 1000, "text characters", retentive=True),
)

BANKS: dict[str, Bank] = {bank.name: bank for bank in _ALL}
"""Every bank by name, in the row order of CLICK's nickname CSV (click-facts [nickname-file.order])."""

ORDER: dict[str, int] = {name: index for index, name in enumerate(BANKS)}

CURRENT_VALUE_OF = {"TD": "T", "CTD": "CT"}
"""The banks of current values, each with the bank of its bits, which have the same numbers
(click-facts [bank.current-values])."""

VALUE_BANK = {bit: value for value, bit in CURRENT_VALUE_OF.items()}

POINTED = ("C", "DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "TXT")
"""The banks that a pointer can point into (click-facts [copy.pointers])."""

READ_ONLY = {"X": "an input", "T": "a timer's bit", "CT": "a counter's bit", "XD": "an input word"}
"""The banks that no instruction writes, with a description (click-facts [bank.read-only])."""

WORD_TWINS = {"X": "XD", "XD": "X", "Y": "YD", "YD": "Y"}
"""Bits and the words that hold the same points: changing either changes the other."""

TWIN_BANKS = {**WORD_TWINS, **VALUE_BANK, **CURRENT_VALUE_OF}
"""Banks whose cells change with those of another: points and words, bits of timers and counters and current values.

No source says when a bit follows a current value that an instruction writes: it may be at once (click-facts
[bank.bit-and-value]).
"""

MOVING_BANKS = ("T", "TD", "SC", "SD")
"""Banks whose cells may change between two rungs though no instruction there writes them, for callers who must be sure.

``device/system.py`` knows which points of SC and SD do not change. ``lower/effects.py`` says why splitting assumes
that timers do not either.
"""

UPPER_BYTE_BANKS = ("XD", "YD")
"""Banks that also have an address ``0u``."""


class Address(NamedTuple):
    """One cell of the machine, such as X001 or DS17; ``upper`` is the ``u`` of XD0u and YD0u."""

    bank: str
    number: int
    upper: bool = False

    def __str__(self) -> str:
        if self.bank == "X" or self.bank == "Y":
            return f"{self.bank}{self.number:03d}"
        return f"{self.bank}{self.number}{'u' if self.upper else ''}"

    @property
    def kind(self) -> Kind:
        return BANKS[self.bank].kind

    @property
    def sort_key(self) -> tuple[int, int, bool]:
        """CLICK's row order: by bank, then by number."""
        return (ORDER[self.bank], self.number, self.upper)


def current_value(bit: Address) -> Address:
    """The current value of a timer or counter: the same number in TD or CTD; any other address is its own value."""
    return Address(VALUE_BANK.get(bit.bank, bit.bank), bit.number, bit.upper)


def points_of(word: Address) -> list[Address]:
    """The inputs or outputs that a word of XD or YD holds: XD0 is X001 to X016, XD0u X021 to X036, XD3 X301 to X316.

    The numbers of slots and words suggest this (click-facts [bank.words]); any other address holds no points.
    """
    if word.bank not in UPPER_BYTE_BANKS:
        return []
    first = 21 if word.upper else word.number * 100 + 1
    return [Address(WORD_TWINS[word.bank], number) for number in range(first, first + 16)]


def twins_of(address: Address) -> list[Address]:
    """The addresses that may change when an instruction writes this one: see ``TWIN_BANKS``."""
    twin = TWIN_BANKS.get(address.bank)
    if twin is None:
        return []
    if twin in UPPER_BYTE_BANKS:
        is_upper = 16 < address.number < 100
        return [Address(twin, address.number // 100, is_upper)]
    return points_of(address) or [Address(twin, address.number)]


_DIGITS_MAX = 4
"""The largest number is DS4500; int() refuses a text of thousands of digits."""


@lru_cache(maxsize=1 << 15)
def parse_address(text: str) -> Address | None:
    """Read an address as CLICK writes it (``X001``, ``DS17``, ``XD0u``; any case); None if the text is not one."""
    text = text.strip()
    name = text.rstrip("uU0123456789").upper()
    bank = BANKS.get(name)
    digits = text[len(name) :]
    if bank is None or not digits:
        return None
    upper = digits[-1] in "uU"
    if upper:
        digits = digits[:-1]
    if not digits.isascii() or not digits.isdigit():
        return None
    digits = digits.lstrip("0") or "0"
    if len(digits) > _DIGITS_MAX:
        return None
    number = int(digits)
    if upper and (name not in UPPER_BYTE_BANKS or number != 0):
        return None
    return Address(name, number, upper) if bank.has(number) else None
