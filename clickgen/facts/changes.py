"""The addresses that instructions change, as stretches: after a rung has written, a condition may have changed."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from functools import cached_property

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, MOVING_BANKS, TWIN_BANKS, Address, points_of
from clickgen.facts.facts import Facts
from clickgen.facts.uses import Use, addresses_of, extents_of
from clickgen.instructions.effects import Flow
from clickgen.ir.operands import Immediate, Operand, Pointer
from clickgen.ir.program import Action

Extent = tuple[str, int, int]
"""A bank, and the first and last number."""


def extents_written(operand: Operand) -> list[Extent]:
    """The stretches that writing an operand may change: bits of current values too, and all of a pointer's bank."""
    if isinstance(operand, Pointer):
        return [(bank, 0, BANKS[bank].last) for bank in (operand.bank, TWIN_BANKS.get(operand.bank, operand.bank))]
    extents = extents_of(operand)
    bits = [(CURRENT_VALUE_OF[bank], first, last) for bank, first, last in extents if bank in CURRENT_VALUE_OF]
    return extents + bits


def with_points(operand: Operand) -> set[Address]:
    """The addresses of an operand, and the points that its words hold."""
    return {point for address in addresses_of(operand) for point in (address, *points_of(address))}


def meets(extents: Iterable[Extent], operand: Operand) -> bool:
    """True if any of these stretches holds an address of the operand."""
    own = extents_of(operand)
    return any(
        bank == name and first <= end and start <= last for bank, first, last in own for name, start, end in extents
    )


class Changes:
    """The stretches that each instruction of a program writes; a call writes what its subroutine writes."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts

    def of(self, action: Action) -> list[Extent]:
        """The stretches that running an action may change, except CLICK's status bits."""
        if action.effects.flow is Flow.CALL:
            return self._by_routine.get(action.called, [])
        return self._by_action.get(id(action), [])

    def surely(self, action: Action) -> list[Extent]:
        """The stretches that an action certainly writes if it runs: not a pointer's target, and nothing of a call."""
        return self._named_by_action.get(id(action), [])

    def may_change(self, operand: Operand, extents: Iterable[Extent]) -> bool:
        """True if an operand of a condition may have another value after these changes."""
        if isinstance(operand, Immediate) or not self.arriving.isdisjoint(with_points(operand)):
            return True
        return any(bank in MOVING_BANKS for bank, _, _ in extents_of(operand)) or meets(extents, operand)

    @cached_property
    def arriving(self) -> frozenset[Address]:
        """The addresses that other devices write, in their own time, with the points of words."""
        uses = (use for use in self._written if use.action and use.action.may_be_late)
        return frozenset(address for use in uses for address in with_points(use.operand))

    @cached_property
    def _written(self) -> list[Use]:
        return [use for use in self._facts.uses.every if use.is_written]

    @cached_property
    def _by_action(self) -> Mapping[int, list[Extent]]:
        found: dict[int, list[Extent]] = defaultdict(list)
        for use in self._written:
            found[id(use.action)] += extents_written(use.operand)
        return found

    @cached_property
    def _named_by_action(self) -> Mapping[int, list[Extent]]:
        found: dict[int, list[Extent]] = defaultdict(list)
        for use in self._written:
            found[id(use.action)] += extents_of(use.operand)
        return found

    @cached_property
    def _by_routine(self) -> Mapping[str, list[Extent]]:
        found: dict[str, dict[Extent, None]] = defaultdict(dict)
        for use in self._written:
            found[use.routine.name].update(dict.fromkeys(extents_written(use.operand)))
        return {name: [*extents] for name, extents in found.items()}
