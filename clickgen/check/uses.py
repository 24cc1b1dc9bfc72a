"""Where each address is read and written: an index over a resolved program."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from clickgen.device.banks import Address
from clickgen.instructions.spec import ParamKind
from clickgen.ir.conditions import Compare, Condition, Contact
from clickgen.ir.operands import Cell, Immediate, Operand, Pointer, Range
from clickgen.ir.program import Action, Branch, Item, Loop, Program, Routine, Rung
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands, leaves

_LONG = 64
"""A range of more addresses is kept as a range."""


@dataclass(frozen=True, slots=True)
class Use:
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
    """Every use of a program in source order, and what is known of an address."""

    every: list[Use] = field(default_factory=list)
    _by_address: dict[Address, list[Use]] = field(default_factory=lambda: defaultdict(list))
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
        for address in _addresses(operand):
            self._by_address[address].append(use)

    @property
    def addresses(self) -> Iterable[Address]:
        """Every address that is named, those of long ranges aside."""
        return self._by_address

    def at(self, address: Address) -> list[Use]:
        """Every use of an address by its own number, in source order, ranges included."""
        near = self._by_address.get(address, [])
        far = [use for use in self._ranges.get(address.bank, ()) if _covers(use.operand, address)]
        return near + far

    def writes(self, address: Address) -> list[Use]:
        return [use for use in self.at(address) if use.is_written]

    def reads(self, address: Address) -> list[Use]:
        return [use for use in self.at(address) if not use.is_written]

    def may_be_written(self, address: Address) -> bool:
        """True also where a pointer may lead to it."""
        return bool(self.writes(address)) or bool(self._pointed.get((address.bank, True)))

    def may_be_read(self, address: Address) -> bool:
        """True also where a pointer may lead to it."""
        return bool(self.reads(address)) or bool(self._pointed.get((address.bank, False)))


def _covers(operand: Operand, address: Address) -> bool:
    target = operand.target if isinstance(operand, Immediate) else operand
    if not isinstance(target, Range):
        return False
    return min(target.first, target.last) <= address.number <= max(target.first, target.last)


def _addresses(operand: Operand) -> Iterator[Address]:
    if isinstance(operand, Cell):
        yield operand.address
        yield from _points(operand.address)
    elif isinstance(operand, Range) and len(operand) <= _LONG:
        for address in operand.addresses():
            yield address
            yield from _points(address)


def _points(word: Address) -> Iterator[Address]:
    """The inputs or outputs that a word of XD or YD holds: XD0 is X001 to X016, XD0u X021 to X036, XD3 X301 to X316."""
    if word.bank in ("XD", "YD"):
        first = 21 if word.upper else word.number * 100 + 1
        yield from (Address(word.bank[0], number) for number in range(first, first + 16))


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
