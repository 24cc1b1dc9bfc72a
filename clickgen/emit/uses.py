"""Where the rungs of CLICK read and write each address: for the cross-references of the listing and the workbook."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple

from clickgen.device.banks import Address, points_of
from clickgen.facts.uses import addresses_of
from clickgen.instructions.spec import ParamKind
from clickgen.ir.conditions import Compare, Condition, Contact
from clickgen.ir.operands import Cell, Immediate, Operand, Range
from clickgen.ir.program import Action, Branch, Item
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands, leaves

if TYPE_CHECKING:
    from clickgen.emit.rung_words import Names
    from clickgen.lower.split import ClickRoutine

_LONG = 64
"""The index keeps a range of more addresses as a range."""


class RungUse(NamedTuple):
    """One operand in a rung of CLICK. ``rung`` counts from 1 in its routine.

    ``action`` is None in the condition of a rung or a branch. ``leaf`` is the contact or comparison that reads the
    operand; an operand in an action's pin has both.
    """

    operand: Operand
    is_written: bool
    routine: str
    rung: int
    action: Action | None = None
    leaf: Contact | Compare | None = None

    @property
    def target(self) -> Operand:
        """The operand, without its ``immediate``."""
        return self.operand.target if isinstance(self.operand, Immediate) else self.operand


class RungUses:
    """Every use in the rungs of some routines, in their order, and the uses of one address."""

    def __init__(self, routines: Iterable[ClickRoutine]) -> None:
        self.every = tuple(_uses(routines))

    def writes(self, address: Address) -> list[RungUse]:
        return [use for use in self._at(address) if use.is_written]

    def reads(self, address: Address) -> list[RungUse]:
        return [use for use in self._at(address) if not use.is_written]

    def _at(self, address: Address) -> list[RungUse]:
        """Every use of an address by its own number: in the order of the rungs, but those in long ranges last."""
        far = (use for use in self._long_ranges.get(address.bank, ()) if _covers(use.target, address))
        return [*self._by_address.get(address, ()), *far]

    @cached_property
    def _by_address(self) -> Mapping[Address, list[RungUse]]:
        found: dict[Address, list[RungUse]] = defaultdict(list)
        for use in self.every:
            if not _is_long(use.target):
                for address in addresses_of(use.target):
                    for one in (address, *points_of(address)):
                        found[one].append(use)
        return found

    @cached_property
    def _long_ranges(self) -> Mapping[str, list[RungUse]]:
        found: dict[str, list[RungUse]] = defaultdict(list)
        for use in self.every:
            if isinstance(use.target, Range) and _is_long(use.target):
                found[use.target.bank].append(use)
        return found


def known_numbers(names: Names, uses: Iterable[RungUse]) -> Mapping[str, Sequence[int]]:
    """The addresses that have a nickname or that some operand names by itself: numbers in order, by bank."""
    known: dict[str, set[int]] = defaultdict(set)
    cells = (target.address for target in (use.target for use in uses) if isinstance(target, Cell))
    for address in chain(names.addresses(), cells):
        if not address.upper:
            known[address.bank].add(address.number)
    return {bank: sorted(numbers) for bank, numbers in known.items()}


def _is_long(target: Operand) -> bool:
    return isinstance(target, Range) and len(target) > _LONG


def _covers(target: Operand, address: Address) -> bool:
    return isinstance(target, Range) and min(target.first, target.last) <= address.number <= max(
        target.first, target.last
    )


# -- walking ----------------------------------------------------------------------------------------------------------


def _uses(routines: Iterable[ClickRoutine]) -> Iterator[RungUse]:
    for routine in routines:
        for number, rung in enumerate(routine.rungs, 1):
            yield from _condition_uses(rung.condition, routine.name, number)
            yield from _item_uses(rung.items, routine.name, number)


def _item_uses(items: tuple[Item, ...], routine: str, rung: int) -> Iterator[RungUse]:
    for item in items:
        if isinstance(item, Branch):
            yield from _condition_uses(item.condition, routine, rung)
            yield from _item_uses(item.items, routine, rung)
        else:
            assert isinstance(item, Action)
            yield from _action_uses(item, routine, rung)


def _condition_uses(condition: Condition, routine: str, rung: int, action: Action | None = None) -> Iterator[RungUse]:
    for leaf in leaves(condition):
        for operand in condition_operands(leaf):
            yield RungUse(operand, False, routine, rung, action, leaf)


def _action_uses(action: Action, routine: str, rung: int) -> Iterator[RungUse]:
    for touch in touches(action):
        if touch.param.kind is not ParamKind.PIN:
            yield RungUse(touch.operand, touch.is_written, routine, rung, action)
    for param in action.spec.pins:
        condition = action.pin(param.name)
        if condition is not None:
            yield from _condition_uses(condition, routine, rung, action)
