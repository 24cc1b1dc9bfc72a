"""A resolved program laid out flat for the rules: every action with where it stands, every contact, comparison."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from clickgen.instructions.spec import Spec
from clickgen.ir.conditions import Always, Compare, Condition, Contact
from clickgen.ir.program import CONDITION_TYPES, Action, Branch, Item, Loop, Program, Routine, Rung
from clickgen.ir.walk import leaves


@dataclass(frozen=True, slots=True)
class Placed:
    """An action and where it stands."""

    action: Action
    routine: Routine
    rung: Rung
    is_unconditional: bool
    """True when nothing but the scan itself decides whether the action runs."""
    loop: Loop | None
    """The loop whose body it stands in."""
    is_top: bool
    """True in a rung of the routine itself, False in a rung of a loop's body."""

    @property
    def spec(self) -> Spec:
        return self.action.spec


@dataclass(frozen=True)
class Facts:
    program: Program

    @cached_property
    def actions(self) -> tuple[Placed, ...]:
        """Every action in source order; a loop comes before its body."""
        return tuple(
            placed
            for routine in self.program.routines
            for rung in routine.rungs
            for placed in _placed(rung.items, routine, rung, isinstance(rung.condition, Always), None)
        )

    @cached_property
    def conditions(self) -> tuple[Condition, ...]:
        """Every condition: of rungs, branches and pins."""
        found: list[Condition] = []
        for routine in self.program.routines:
            for rung in routine.rungs:
                found += _conditions(rung)
        return tuple(found)

    @cached_property
    def contacts(self) -> tuple[Contact, ...]:
        return tuple(leaf for leaf in self._leaves if isinstance(leaf, Contact))

    @cached_property
    def comparisons(self) -> tuple[Compare, ...]:
        return tuple(leaf for leaf in self._leaves if isinstance(leaf, Compare))

    @cached_property
    def _leaves(self) -> tuple[Contact | Compare, ...]:
        return tuple(leaf for condition in self.conditions for leaf in leaves(condition))


def _placed(
    items: tuple[Item, ...], routine: Routine, rung: Rung, unconditional: bool, loop: Loop | None
) -> Iterator[Placed]:
    for item in items:
        if isinstance(item, Branch):
            always = unconditional and isinstance(item.condition, Always)
            yield from _placed(item.items, routine, rung, always, loop)
        elif isinstance(item, Loop):
            yield Placed(item.action, routine, rung, unconditional, loop, loop is None)
            for inner in item.body or ():
                always = unconditional and isinstance(inner.condition, Always)
                yield from _placed(inner.items, routine, inner, always, item)
        else:
            yield Placed(item, routine, rung, unconditional, loop, loop is None)


def _conditions(rung: Rung) -> Iterator[Condition]:
    yield rung.condition
    yield from _item_conditions(rung.items)


def _item_conditions(items: tuple[Item, ...]) -> Iterator[Condition]:
    for item in items:
        if isinstance(item, Action):
            yield from (value for value in item.args.values() if isinstance(value, CONDITION_TYPES))
        elif isinstance(item, Branch):
            yield item.condition
            yield from _item_conditions(item.items)
        else:
            for rung in item.body or ():
                yield from _conditions(rung)
