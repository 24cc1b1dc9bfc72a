"""The sheet that lists where each address is written and read."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from heapq import heappop, heappush
from itertools import islice
from typing import NamedTuple

from clickgen.click.draw.tokens import operand_token
from clickgen.device.banks import UPPER_BYTE_BANKS, Address, points_of
from clickgen.emit.uses import RungUse, known_numbers
from clickgen.emit.workbook.project import Project, listed
from clickgen.emit.workbook.sheet import Cells, Column, Sheet
from clickgen.facts.uses import addresses_of
from clickgen.ir.conditions import Compare, Contact
from clickgen.ir.operands import Cell, Immediate, Pointer, Range

_LONG = 64
"""A longer range is not repeated with every place for each name in it: one line lists the ranges."""
_SHOWN = 3
"""This many of the long ranges around an address are named."""


def cross_reference(project: Project) -> Sheet:
    return Sheet(
        "Cross-reference",
        "Where each address is written and read: rungs are those of CLICK, sources are file and line.",
        (
            Column("Cell or range", 16),
            Column("Nickname", 27),
            Column("Access", 9),
            Column("Routine", 20, wraps=True),
            Column("Rung", 9, wraps=True),
            Column("Source", 24, wraps=True),
            Column("As", 30, wraps=True),
            Column("Through", 24, wraps=True),
        ),
        _rows(project),
    )


class _Key(NamedTuple):
    """An operand as it is listed, and the range or word through which a rung leads to it."""

    place: tuple[int, int, bool]
    length: int
    text: str
    through: str = ""

    @staticmethod
    def of(address: Address, through: str = "") -> _Key:
        return _Key(address.sort_key, 0, str(address), through)


class _Line(NamedTuple):
    """The content of one line, without its rungs."""

    key: _Key
    is_read: bool
    routine: str
    source: str
    form: str

    @property
    def order(self) -> tuple[object, ...]:
        """In CLICK's order, a pointer before its bank, a range after its first address; writes come first."""
        place, length, text, through = self.key
        return place, length, text, self.is_read, through


def _rows(project: Project) -> Iterator[Cells]:
    lines = _Lines(project)
    for use in project.built.uses.every:
        lines.add(use)
    lines.add_long_ranges()
    for line, rungs in sorted(lines.found.items(), key=lambda item: item[0].order):
        key = line.key
        address = lines.addresses.get(key.text)
        yield (
            key.text,
            project.built.names.nickname(address) if address else "",
            "read" if line.is_read else "written",
            line.routine,
            listed(rungs) if len(rungs) != 1 else rungs[0],
            line.source,
            line.form,
            key.through,
        )


@dataclass
class _Lines:
    project: Project
    found: dict[_Line, list[int]] = field(default_factory=dict)
    """Each line and its rungs, in the order of the program."""
    addresses: dict[str, Address] = field(default_factory=dict)
    _long: dict[tuple[str, bool], set[tuple[int, int]]] = field(default_factory=lambda: defaultdict(set))

    def add(self, use: RungUse) -> None:
        """Add the lines of one use: its operand, and every known address that a range or a word leads to."""
        operand = use.target
        if isinstance(operand, Cell):
            self._note(operand.address, use)
            self._add_points(operand, use, str(operand.address))
        elif isinstance(operand, Range):
            self._add_range(operand, use)
        elif isinstance(operand, Pointer):
            self._put(_Key(Address(operand.bank, -1).sort_key, 0, operand_token(operand)), use)

    def _add_range(self, operand: Range, use: RungUse) -> None:
        bank = operand.bank
        low, high = sorted((operand.first, operand.last))
        if low == high:
            self._note(Address(bank, low), use)
            return
        text = _range_text(bank, low, high)
        self._put(_Key(Address(bank, low).sort_key, high - low, text), use)
        self._add_points(operand, use, text)
        if len(operand) > _LONG:
            self._long[bank, use.is_written].add((low, high))
            return
        numbers = self._known.get(bank, [])
        for number in numbers[bisect_left(numbers, low) : bisect_left(numbers, high + 1)]:
            self._note(Address(bank, number), use, text)

    def _add_points(self, operand: Cell | Range, use: RungUse, text: str) -> None:
        """Add the known inputs or outputs that words hold."""
        if operand.bank in UPPER_BYTE_BANKS:
            for point in (point for word in addresses_of(operand) for point in points_of(word)):
                if point.number in self._known.get(point.bank, ()):
                    self._note(point, use, text)

    def add_long_ranges(self) -> None:
        """Add one line for each known address in long ranges, which names them."""
        for (bank, is_written), ranges in self._long.items():
            for number, around, more in _covered(self._known.get(bank, []), ranges):
                texts = [_range_text(bank, low, high) for low, high in around]
                address = Address(bank, number)
                self.addresses[str(address)] = address
                key = _Key.of(address, ", ".join(texts) + (f" and {more} more" if more else ""))
                self.found[_Line(key, not is_written, "", "", "in a long range: see there")] = []

    def _note(self, address: Address, use: RungUse, through: str = "") -> None:
        key = _Key.of(address, through)
        self.addresses[key.text] = address
        self._put(key, use)

    def _put(self, key: _Key, use: RungUse) -> None:
        source = self.project.line(use.operand.span)
        line = _Line(key, not use.is_written, use.routine, source, _form(use))
        rungs = self.found.setdefault(line, [])
        number = use.rung
        if not rungs or rungs[-1] != number:
            rungs.append(number)

    @cached_property
    def _known(self) -> Mapping[str, Sequence[int]]:
        return known_numbers(self.project.built.names, self.project.built.uses.every)


def _range_text(bank: str, low: int, high: int) -> str:
    return f"{Address(bank, low)}..{Address(bank, high)}"


def _covered(numbers: Sequence[int], ranges: set[tuple[int, int]]) -> Iterator[tuple[int, list[tuple[int, int]], int]]:
    """Yield each number that is in ranges, the first of those ranges, and how many more: one walk over both."""
    waiting = sorted(ranges, reverse=True)
    around: dict[tuple[int, int], None] = {}
    ends: list[tuple[int, tuple[int, int]]] = []
    for number in numbers:
        while waiting and waiting[-1][0] <= number:
            opened = waiting.pop()
            around[opened] = None
            heappush(ends, (opened[1], opened))
        while ends and ends[0][0] < number:
            del around[heappop(ends)[1]]
        if around:
            yield number, list(islice(around, _SHOWN)), max(len(around) - _SHOWN, 0)


def _form(use: RungUse) -> str:
    """How an operand is used in a rung: ``NC contact``, ``comparison >=``, ``copy``, ``ctu input: rising edge``."""
    words = _leaf(use.leaf) if use.leaf else ""
    if use.action is not None:
        words = f"{use.action.spec.name} input: {words}" if words else use.action.spec.name
    return f"{words}, immediate" if isinstance(use.operand, Immediate) else words


def _leaf(leaf: Contact | Compare) -> str:
    if isinstance(leaf, Compare):
        return f"comparison {leaf.op}"
    if leaf.edge:
        return f"{leaf.edge.word} edge"
    return "NC contact" if leaf.negated else "NO contact"
