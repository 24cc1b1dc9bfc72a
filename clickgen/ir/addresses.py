"""Addresses as text has them, read once for all: for each dialect and for formulas, with one set of words.

A caller translates its own nodes to a bank's word and an ``Index``, and gets the operand or the one ``Fault`` of it.
The caller knows where its nodes are, so a fault says which part of the address is wrong, and not where that is.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import NamedTuple, Protocol

from clickgen.device.banks import BANKS, POINTED, UPPER_BYTE_BANKS, Address, Bank
from clickgen.device.elsewhere import BANKS as FOREIGN_BANKS
from clickgen.ir.operands import Cell, Immediate, Named, Pointer, Range, Section
from clickgen.problems.diagnostics import did_you_mean
from clickgen.text.source import Span
from clickgen.text.wording import shorten

BANK_NAMES: dict[str, Bank] = {bank.dsl: bank for bank in BANKS.values()}
"""The banks by the words that stand for them in a program."""


class AddressSpelling(Protocol):
    """How a dialect, or a formula, writes addresses."""

    def cell(self, address: Address) -> str:
        """One address by its number: ``ds[5]``."""

    def name(self, bank: str, name: str) -> str:
        """A nickname seen through a bank: ``ds.Speed``."""

    def range(self, bank: str, first: int, last: int) -> str:
        """Consecutive addresses, both ends included; ``first`` above ``last`` runs backwards."""

    def member(self, block: str, index: int) -> str:
        """One member of a block that is written so; the first one has the index 0."""

    def members(self, block: str, count: int) -> str:
        """The first members of a block that is written so."""

    def pointer(self, bank: str, register: str) -> str:
        """The cell of a bank whose number is in a register that is written so: ``ds[ds.Index]``."""

    @property
    def range_end(self) -> str:
        """A remark on how the end of a range is written; "" where nothing is to be said."""


class Bounds(NamedTuple):
    """The ends and the step of a slice, half-open: None is what was left out, NO_NUMBER what is no whole number."""

    first: int | Odd | None
    stop: int | Odd | None
    step: int | Odd | None = None

    @property
    def has_odd(self) -> bool:
        return any(isinstance(bound, Odd) for bound in self)


class Odd(NamedTuple):
    """Something between the brackets that says no number."""

    word: str = ""
    """The word, where it is one."""
    difference: tuple[int, int] | None = None
    """The numbers of ``1-16``."""
    is_calculated: bool = False
    """True for a calculation."""
    is_list: bool = False
    """True for several with commas between them."""
    hexadecimal: int | None = None
    """The value of ``10h``."""


NO_NUMBER = Odd()

Addressed = Named | Cell | Range | Pointer | Immediate
Index = int | str | Bounds | Addressed | Odd
"""What is between the brackets: a number, a text in quotes, a slice, another address, or something else."""


class Part(Enum):
    """The part of an address that is wrong."""

    WHOLE = "whole"
    BANK = "bank"
    INDEX = "index"


class Fault(NamedTuple):
    """What is wrong with an address, and the way out."""

    code: str
    part: Part
    message: str
    help: str
    bank: str = ""
    """The word that mends the bank's, where that is all."""


class AddressReader:
    """Reads addresses, and speaks of them as ``spell`` writes them."""

    def __init__(self, spell: AddressSpelling) -> None:
        self._spell = spell

    def bank(self, word: str, index: Index | None, shown: Callable[[], str]) -> Bank | Fault:
        """The bank of a word. ``shown`` gives the whole address as the person wrote it."""
        bank = BANK_NAMES.get(word)
        if bank is not None:
            return bank
        message, lower = f"there is no bank {word!r}", word.lower()
        if lower in BANK_NAMES:
            way = f"banks are written in small letters: {lower}{shown().removeprefix(word)}"
            return Fault("CG113", Part.BANK, message, way, lower)
        stem = lower.rstrip("0123456789")
        digits = lower[len(stem) :]
        if stem in BANK_NAMES and 0 < len(digits) <= _DIGITS_MAX and digits.isascii():
            cell, name = self._spell.cell(Address(BANK_NAMES[stem].name, int(digits))), self._name(stem)
            return Fault("CG113", Part.BANK, message, f"a nickname stands alone after its bank: {cell} or {name}")
        number = index if isinstance(index, int) else 0
        known = self.foreign_bank(lower, number) or did_you_mean(word, BANK_NAMES) or self.banks
        return Fault("CG113", Part.BANK, message, known)

    def indexed(
        self, bank: Bank, index: Index, span: Span, shown: Callable[[], str]
    ) -> Cell | Named | Range | Pointer | Fault:
        """An address by what is between its brackets: ``ds[5]``, ``xd["0u"]``, ``ds[1:11]``, ``ds[ds.Index]``.

        ``shown`` gives the whole address as the person wrote it.
        """
        if isinstance(index, int):
            if bank.has(index):
                return Cell(Address(bank.name, index), span)
            written = self._spell.cell(Address(bank.name, index)) if abs(index) < _SHOWN_MAX else "such address"
            return Fault("CG201", Part.WHOLE, f"there is no {written}", self._has(bank))
        if isinstance(index, str):
            if bank.name in UPPER_BYTE_BANKS and index.lower() == "0u":
                return Cell(Address(bank.name, 0, True), span)
            if not index.strip():
                ways = (self._spell.name(bank.name, "Any name"), self._name(bank.dsl), self._first(bank))
                way = "write {}, {} or {}".format(*ways)
                return Fault("CG203", Part.INDEX, "there is no nickname between the quotes", way)
            return Named(bank.name, index, span)
        if isinstance(index, Bounds):
            return self._range(bank, index, span, shown)
        if isinstance(index, Odd):
            any_index = self._spell.pointer(bank.name, "...")
            message = f"{any_index} takes a number, a name in quotes, a range or a DS register"
            return Fault("CG113", Part.INDEX, message, self._instead(bank, index))
        return self._pointer(bank, index, span)

    def part(self, block: Named, index: Index, span: Span, shown: str) -> Named | Fault:
        """``ds.Recipe[3]`` and ``ds.Recipe[0:10]``: members of a block, which is ``shown`` as the person wrote it."""
        if isinstance(index, int) and index >= 0:
            return Named(block.bank, block.name, span, index)
        if isinstance(index, Bounds) and not index.has_odd:
            first, stop, step = (bound for bound in index if not isinstance(bound, Odd))
            return Named(block.bank, block.name, span, Section(first, stop, 1 if step is None else step))
        example = f"{self._spell.member(shown, 3)} and {self._spell.members(shown, 10)}"
        if isinstance(index, int):
            return Fault("CG214", Part.INDEX, "the members of a block are counted from 0", example)
        if isinstance(index, str | Bounds | Odd):
            part = Part.WHOLE if isinstance(index, Bounds) else Part.INDEX
            return Fault("CG214", part, "a block takes a number or a range after its name", example)
        fault = f"a pointer cannot count inside {shown}"
        if block.bank not in POINTED:
            return Fault("CG214", Part.INDEX, fault, f"name the members: {example}")
        pointer = self._spell.pointer(block.bank, self._name("ds", "Index"))
        way = f"point into the bank: {pointer}, with the block's first address added to the index"
        return Fault("CG214", Part.INDEX, fault, way)

    @property
    def banks(self) -> str:
        """All banks, and how an address of one is written."""
        return f"the banks: {', '.join(BANK_NAMES)}; {self.forms}"

    @property
    def forms(self) -> str:
        """How an address is written."""
        return f"an address is written {self._spell.cell(Address('DS', 5))} or {self._name('ds')}"

    def foreign_bank(self, word: str, number: int = 0) -> str:
        """What a bank of another machine is here, with the number where it fits; "" for a word that is none."""
        found = FOREIGN_BANKS.get(word.lower())
        if found is None:
            return ""
        bank = BANK_NAMES[found]
        cell = self._spell.cell(Address(bank.name, number if bank.has(number) else bank.first))
        return f"{bank.title} are in {bank.name}: write {cell}, or {self._name(found)}"

    # -- ranges -------------------------------------------------------------------------------------------------------

    def _range(self, bank: Bank, bounds: Bounds, span: Span, written: Callable[[], str]) -> Range | Fault:
        """A half-open slice to a range with both ends included; step -1 is the reversed direction."""
        first, stop, step = bounds.first, bounds.stop, 1 if bounds.step is None else bounds.step
        if not isinstance(first, int) or not isinstance(stop, int) or step not in (1, -1):
            low, high = bank.first, min(bank.first + 15, bank.ranges[0][1])
            message = "a range is written with two numbers: the first address and the one after the last"
            forward, back = self._spell.range(bank.name, low, high), self._spell.range(bank.name, high, low)
            way = f"{forward} is {Address(bank.name, low)} to {Address(bank.name, high)}; {back} is the same backwards"
            return Fault("CG202", Part.WHOLE, message, way)
        assert isinstance(step, int)
        last = stop - step
        if (last - first) * step < 0:
            start = first if bank.has(first) else bank.first
            way = f"{self._spell.range(bank.name, start, start)} is one address"
            return Fault("CG202", Part.WHOLE, f"{shorten(written())} is empty", self._with_end(way))
        low, high = min(first, last), max(first, last)
        if any(lowest <= low and high <= highest for lowest, highest in bank.ranges):
            return Range(bank.name, first, last, span)
        fault = "crosses a gap" if bank.has(low) and bank.has(high) else "leaves the bank"
        ends = f"{_shown(bank, low)} to {_shown(bank, high)}"
        return Fault("CG202", Part.WHOLE, f"the range {ends} {fault}", self._with_end(self._has(bank)))

    def _with_end(self, way: str) -> str:
        return f"{way}; {self._spell.range_end}" if self._spell.range_end else way

    # -- what is no number --------------------------------------------------------------------------------------------

    def _pointer(self, bank: Bank, register: Addressed, span: Span) -> Pointer | Fault:
        is_section = isinstance(register, Named) and isinstance(register.part, Section)
        if not isinstance(register, Named | Cell) or is_section or register.bank != "DS":
            is_one = isinstance(register, Named | Cell) and not is_section
            kind = f"one in {register.bank}" if is_one else _KINDS.get(type(register), "a range")
            way = "copy the index to a DS register first, and point through that one"
            return Fault("CG212", Part.INDEX, f"a pointer goes through a single DS register, not {kind}", way)
        if bank.name not in POINTED:
            reach = f"pointers reach {', '.join(POINTED)}"
            return Fault("CG213", Part.WHOLE, f"{bank.name} cannot be pointed into", reach)
        return Pointer(bank.name, register, span)

    def _instead(self, bank: Bank, odd: Odd) -> str:
        """The way out for something between brackets that says no number."""
        if odd.difference is not None and odd.difference[0] < odd.difference[1]:
            first, last = odd.difference
            is_there = bank.has(first) and bank.gap_in(first, last) is None
            ends = (first, last) if is_there else (bank.first, bank.first + 1)
            return self._with_end(f"a range is written {self._spell.range(bank.name, *ends)}")
        if odd.hexadecimal is not None:
            number = odd.hexadecimal if bank.has(odd.hexadecimal) else bank.first
            return f"addresses are numbered in decimal: write {self._spell.cell(Address(bank.name, number))}"
        if odd.is_list:
            return f"write one number, or a range: {self._spell.range(bank.name, bank.first, bank.first + 1)}"
        index = self._spell.pointer(bank.name, self._name("ds", "Index"))
        if odd.is_calculated:
            if bank.name not in POINTED:
                return self._first(bank)
            return f"brackets do not calculate: calculate the number into a DS register first, and write {index}"
        if odd.word:
            pointer = self._spell.pointer(bank.name, self._name("ds", odd.word))
            through = f"; a pointer goes through a register, {pointer}" if bank.name in POINTED else ""
            return f"a nickname is written {self._spell.name(bank.name, odd.word)}{through}"
        return self._first(bank)

    def _first(self, bank: Bank) -> str:
        return self._spell.cell(Address(bank.name, bank.first))

    def _name(self, word: str, name: str = "Name") -> str:
        return self._spell.name(BANK_NAMES[word].name, name)

    def _has(self, bank: Bank) -> str:
        upper = f", and {self._spell.cell(Address(bank.name, 0, True))}" if bank.name in UPPER_BYTE_BANKS else ""
        return f"{bank.name} has {bank.describe_range()}{upper}"


_DIGITS_MAX = 4
_SHOWN_MAX = 10**9
"""Longer numbers are not repeated in a message."""
_KINDS: dict[type, str] = {Pointer: "another pointer", Immediate: "a point"}


def _shown(bank: Bank, number: int) -> str:
    return str(Address(bank.name, number)) if abs(number) < _SHOWN_MAX else f"{bank.name}..."
