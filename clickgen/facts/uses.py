"""Where each address is read and written: an index over a resolved program."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from clickgen.device.banks import WORD_TWINS, Address, points_of
from clickgen.instructions.spec import ParamKind
from clickgen.ir.conditions import Compare, Condition, Contact
from clickgen.ir.operands import Cell, Immediate, Operand, Pointer, Range
from clickgen.ir.program import Action, Branch, Item, Loop, Program, Routine, Rung
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands, leaves

_LONG = 64
"""A range of more addresses is kept as a range."""
_STRETCHES_MAX = 64
"""For this many stretches the ranges that cover them are cached."""


class Use(NamedTuple):
    """One operand in one place. ``action`` is None in the condition of a rung or a branch.

    ``leaf`` is the contact or comparison that reads it; in an action's pin there is both an action and a leaf.
    """

    operand: Operand
    is_written: bool
    routine: Routine
    rung: Rung
    action: Action | None = None
    leaf: Contact | Compare | None = None


@dataclass
class Uses:
    """Every use of a program in source order, indexed by address."""

    every: list[Use] = field(default_factory=list)
    _by_address: dict[Address, list[Use]] = field(default_factory=lambda: defaultdict(list))
    _written: dict[Address, list[Use]] = field(default_factory=lambda: defaultdict(list))
    """The uses in ``_by_address`` that write."""
    _ranges: dict[str, list[Use]] = field(default_factory=lambda: defaultdict(list))
    _pointed: dict[tuple[str, bool], list[Use]] = field(default_factory=lambda: defaultdict(list))

    @classmethod
    def of(cls, program: Program) -> Uses:
        uses = cls()
        for routine in program.routines:
            for rung in routine.rungs:
                for use in _rung_uses(routine, rung):
                    uses._add(use)
        return uses

    def _add(self, use: Use) -> None:
        self.every.append(use)
        operand = use.operand.target if isinstance(use.operand, Immediate) else use.operand
        if isinstance(operand, Range) and len(operand) > _LONG:
            self._ranges[operand.bank].append(use)
        elif isinstance(operand, Pointer):
            self._pointed[operand.bank, use.is_written].append(use)
        else:
            for address in addresses_of(operand):
                for one in (address, *points_of(address)):
                    self._by_address[one].append(use)
                    if use.is_written:
                        self._written[one].append(use)

    @property
    def addresses(self) -> Iterable[Address]:
        """Every address that is named, except those of long ranges."""
        return self._by_address

    def at(self, address: Address) -> list[Use]:
        """Every use of an address by its own number: in source order, but those in long ranges last."""
        return self._by_address.get(address, []) + self._far(address)

    def writes(self, address: Address) -> list[Use]:
        return self._written.get(address, []) + [use for use in self._far(address) if use.is_written]

    def reads(self, address: Address) -> list[Use]:
        return [use for use in self.at(address) if not use.is_written]

    def is_in_long_range(self, bank: str) -> bool:
        """True if some range of the bank is so long that its uses are not kept for each address."""
        return bank in self._ranges

    def _far(self, address: Address) -> list[Use]:
        ranges = self._ranges.get(address.bank)
        if not ranges:
            return []
        # Between two ends of ranges every address has the same uses.
        key = address.bank, bisect_right(self._ends[address.bank], address.number)
        if key not in self._known:
            if len(self._known) >= _STRETCHES_MAX:
                self._known.clear()
            self._known[key] = [use for use in ranges if _covers(use.operand, address)]
        return self._known[key]

    @cached_property
    def _known(self) -> dict[tuple[str, int], list[Use]]:
        """The long ranges over stretches that were asked for."""
        return {}

    @cached_property
    def _ends(self) -> Mapping[str, list[int]]:
        """Where long ranges of each bank begin, and where they are over."""
        return {
            bank: sorted(
                {end for use in uses for _, low, high in extents_of(use.operand)[:1] for end in (low, high + 1)}
            )
            for bank, uses in self._ranges.items()
        }

    def may_be_written(self, operand: Operand) -> bool:
        """True if some address of a cell or a range is written anywhere, or a pointer may lead to it."""
        return self._may_be(operand, True)

    def may_be_read(self, operand: Operand) -> bool:
        """True if some address of a cell or a range is read anywhere, or a pointer may lead to it."""
        return self._may_be(operand, False)

    def is_pointed(self, bank: str, is_written: bool) -> bool:
        """True if a pointer writes (or reads) some address of the bank, or a word that holds its points."""
        return any(self._pointed.get((name, is_written)) for name in (bank, WORD_TWINS.get(bank, "")))

    def _may_be(self, operand: Operand, is_written: bool) -> bool:
        return any(
            self.is_pointed(bank, is_written) or _meets(self._stretches.get((bank, is_written), ()), first, last)
            for bank, first, last in extents_of(operand)
        )

    @cached_property
    def _stretches(self) -> Mapping[tuple[str, bool], list[tuple[int, int]]]:
        """The numbers of each bank that are written, and that are read: stretches in order, none touching another."""
        found: dict[tuple[str, bool], set[tuple[int, int]]] = defaultdict(set)
        for operand, is_written, *_ in self.every:
            for bank, first, last in extents_of(operand):
                found[bank, is_written].add((first, last))
        return {key: _joined(stretches) for key, stretches in found.items()}


def addresses_of(operand: object) -> list[Address]:
    """The addresses that an operand itself names; none for a pointer, a constant, or anything else."""
    target = operand.target if isinstance(operand, Immediate) else operand
    if isinstance(target, Cell):
        return [target.address]
    return target.addresses() if isinstance(target, Range) else []


def extents_of(operand: Operand) -> list[tuple[str, int, int]]:
    """The bank, first and last number of the cells that an operand itself names, and of the points of its words."""
    if isinstance(operand, Immediate):
        operand = operand.target
    if isinstance(operand, Cell):
        first = last = operand.address.number
    elif isinstance(operand, Range):
        first, last = min(operand.first, operand.last), max(operand.first, operand.last)
    else:
        return []
    bank = operand.bank
    extents = [(bank, first, last)]
    if bank in ("XD", "YD"):
        for word in addresses_of(operand):
            points = points_of(word)
            extents.append((bank[0], points[0].number, points[-1].number))
    return extents


def _joined(stretches: Iterable[tuple[int, int]]) -> list[tuple[int, int]]:
    joined: list[tuple[int, int]] = []
    for first, last in sorted(stretches):
        if joined and first <= joined[-1][1] + 1:
            joined[-1] = (joined[-1][0], max(joined[-1][1], last))
        else:
            joined.append((first, last))
    return joined


def _meets(stretches: Sequence[tuple[int, int]], first: int, last: int) -> bool:
    index = bisect_right(stretches, last, key=lambda stretch: stretch[0]) - 1
    return index >= 0 and stretches[index][1] >= first


def _covers(operand: Operand, address: Address) -> bool:
    target = operand.target if isinstance(operand, Immediate) else operand
    if not isinstance(target, Range):
        return False
    return min(target.first, target.last) <= address.number <= max(target.first, target.last)


# -- walking ----------------------------------------------------------------------------------------------------------


def _rung_uses(routine: Routine, rung: Rung) -> Iterator[Use]:
    yield from _condition_uses(rung.condition, routine, rung)
    yield from _item_uses(rung.items, routine, rung)


def _item_uses(items: tuple[Item, ...], routine: Routine, rung: Rung) -> Iterator[Use]:
    for item in items:
        if isinstance(item, Branch):
            yield from _condition_uses(item.condition, routine, rung)
            yield from _item_uses(item.items, routine, rung)
        elif isinstance(item, Loop):
            yield from _action_uses(item.action, routine, rung)
            for inner in item.body or ():
                yield from _rung_uses(routine, inner)
        else:
            yield from _action_uses(item, routine, rung)


def _condition_uses(condition: Condition, routine: Routine, rung: Rung, action: Action | None = None) -> Iterator[Use]:
    for leaf in leaves(condition):
        for operand in condition_operands(leaf):
            yield Use(operand, False, routine, rung, action, leaf)


def _action_uses(action: Action, routine: Routine, rung: Rung) -> Iterator[Use]:
    for touch in touches(action):
        if touch.param.kind is not ParamKind.PIN:
            yield Use(touch.operand, touch.is_written, routine, rung, action)
    for param in action.spec.pins:
        condition = action.pin(param.name)
        if condition is not None:
            yield from _condition_uses(condition, routine, rung, action)
