"""The state of every cell that a program can have: used, named only, in a block, scratch, reserved, free."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from itertools import groupby
from typing import NamedTuple

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address, Bank
from clickgen.emit.uses import RungUse
from clickgen.emit.workbook.sheet import Look
from clickgen.facts.uses import extents_of
from clickgen.table.rows import Row, is_scratch


class State(Enum):
    """A letter for maps, words for lists, a meaning, a look."""

    USED = ("U", "used", "a rung reads or writes it", Look.USED)
    NAMED = ("N", "named, not used", "only the address table speaks of it", Look.NAMED)
    BLOCK = ("B", "in a block", "a block holds it; a pointer or a panel may use it", Look.BLOCK)
    SCRATCH = ("S", "scratch", "clickgen needs it for itself", Look.SCRATCH)
    RESERVED = ("R", "reserved", "the settings keep it free", Look.RESERVED)
    FREE = ("", "free", "nothing names it or uses it", Look.FAINT)

    def __init__(self, letter: str, words: str, meaning: str, look: Look) -> None:
        self.letter = letter
        self.words = words
        self.meaning = meaning
        self.look = look


GIVEN = tuple(bank for bank in BANKS.values() if bank.allocatable)
"""The banks whose cells a program can have; the others are CLICK's own or follow one of these."""


class Stretch(NamedTuple):
    """Cells of one state in a row, both ends included."""

    first: Address
    last: Address
    state: State

    @property
    def length(self) -> int:
        return self.last.number - self.first.number + 1


@dataclass(frozen=True)
class States:
    """The state of each cell, by bank and number."""

    _by_bank: Mapping[str, list[State]]

    @staticmethod
    def of(
        rows: Iterable[Row], blocks: Iterable[Address], reserved: Iterable[Address], uses: Iterable[RungUse]
    ) -> States:
        return States(_states(tuple(rows), blocks, reserved, uses))

    def at(self, address: Address) -> State:
        return self._by_bank[address.bank][address.number]

    def count(self, bank: Bank) -> Counter[State]:
        states = self._by_bank[bank.name]
        return Counter(states[number] for number in bank.numbers())

    def stretches(self, bank: Bank) -> Iterator[Stretch]:
        """Yield the stretches in order; none spans a gap of the bank's numbers."""
        states = self._by_bank[bank.name]
        for first, last in bank.ranges:
            for state, group in groupby(range(first, last + 1), key=states.__getitem__):
                numbers = list(group)
                yield Stretch(Address(bank.name, numbers[0]), Address(bank.name, numbers[-1]), state)


def _states(
    rows: tuple[Row, ...], blocks: Iterable[Address], reserved: Iterable[Address], uses: Iterable[RungUse]
) -> dict[str, list[State]]:
    states = {bank.name: [State.FREE] * (bank.last + 1) for bank in GIVEN}

    def mark(addresses: Iterable[Address], state: State) -> None:
        for address in addresses:
            # A timer's bit and its current value share a number: taking either takes both.
            bank = CURRENT_VALUE_OF.get(address.bank, address.bank)
            if bank in states and not address.upper:
                states[bank][address.number] = state

    mark(reserved, State.RESERVED)
    mark((row.address for row in rows if not row.is_default), State.NAMED)
    mark(blocks, State.BLOCK)
    mark((row.address for row in rows if row.nickname), State.NAMED)
    for name, first, last in {extent for use in uses for extent in extents_of(use.operand)}:
        bank = CURRENT_VALUE_OF.get(name, name)
        if bank in states:
            states[bank][first : last + 1] = [State.USED] * (last - first + 1)
    mark((row.address for row in rows if is_scratch(row)), State.SCRATCH)
    return states
