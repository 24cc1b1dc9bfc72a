"""Operands: cells, ranges, pointers and constants, each with the place where it was written.

A program has ``Named``; resolving replaces each by the ``Cell`` of its nickname.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.instructions.spec import CODE, HEX, INTEGER, REAL, TEXT
from clickgen.records import dataclass
from clickgen.text.source import EmbeddedText, Span


class Section(NamedTuple):
    """``[0:10]`` after the name of a block: half-open, from index 0; None is the block's own end."""

    start: int | None = None
    stop: int | None = None
    step: int = 1


WHOLE = Section()


@dataclass(frozen=True, slots=True)
class Named:
    """``ds.Step``: a nickname seen through a bank, or the name of a block.

    ``part`` is what follows a block's name: an index, -1 for the last member, or a section.
    """

    bank: str
    name: str
    span: Span
    part: int | Section | None = None


@dataclass(frozen=True, slots=True)
class Cell:
    """One address, such as ``ds[5]``."""

    address: Address
    span: Span

    @property
    def bank(self) -> str:
        return self.address.bank


@dataclass(frozen=True, slots=True)
class Range:
    """Consecutive addresses, both ends included; ``first`` above ``last`` is the reversed direction."""

    bank: str
    first: int
    last: int
    span: Span

    def __len__(self) -> int:
        return abs(self.last - self.first) + 1

    @property
    def is_reversed(self) -> bool:
        return self.first > self.last

    def addresses(self) -> list[Address]:
        return list(_addresses(self.bank, self.first, self.last))


@lru_cache(maxsize=256)
def _addresses(bank: str, first: int, last: int) -> tuple[Address, ...]:
    """The addresses of a range, cached: every stage asks for those of a long one many times."""
    step = -1 if first > last else 1
    return tuple(Address(bank, number) for number in range(first, last + step, step))


@dataclass(frozen=True, slots=True)
class Pointer:
    """``ds[ds.Index]``: the cell of ``bank`` whose number the register holds."""

    bank: str
    register: Named | Cell
    span: Span


@dataclass(frozen=True, slots=True)
class Immediate:
    """``x[1].immediate``: the physical point, not the scan's image."""

    target: Named | Cell | Range
    span: Span

    @property
    def bank(self) -> str:
        return self.target.bank


@dataclass(frozen=True, slots=True)
class Integer:
    value: int
    span: Span


@dataclass(frozen=True, slots=True)
class Hex:
    """A constant written in hexadecimal: ``0x00FF`` or ``"00FFh"``."""

    value: int
    span: Span


@dataclass(frozen=True, slots=True)
class Real:
    """A floating-point constant; ``text`` is as written."""

    value: float
    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Text:
    """A string constant; in a formula slot it is the formula."""

    value: str
    span: Span
    embedded: EmbeddedText


@dataclass(frozen=True, slots=True)
class CharCode:
    """A character by its ASCII code: ``"$0D"``."""

    value: int
    span: Span


Constant = Integer | Hex | Real | Text | CharCode
Single = Named | Cell | Pointer | Constant
"""An operand that holds or is one value."""
Operand = Single | Range | Immediate

_FORMS: dict[type, str] = {Integer: INTEGER, Hex: HEX, Real: REAL, Text: TEXT, CharCode: CODE}


def form_of(operand: object) -> str:
    """The bank of an address, or the form of a constant, as the instruction Specs name them; "" for anything else."""
    if isinstance(operand, Named | Cell | Range | Pointer | Immediate):
        return operand.bank
    return _FORMS.get(type(operand), "")
