"""A resolved program laid out flat for the rules: every action with where it stands, every contact, comparison."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product

from clickgen.check.logic import are_exclusive
from clickgen.check.uses import Uses
from clickgen.device.banks import CURRENT_VALUE_OF, Address
from clickgen.device.system import system_name_of
from clickgen.instructions.control import CALL
from clickgen.instructions.spec import Spec
from clickgen.ir.conditions import All, Always, Compare, Condition, Contact
from clickgen.ir.program import CONDITION_TYPES, Action, Branch, Item, Loop, Program, Routine, Rung
from clickgen.ir.walk import leaves
from clickgen.source import SourceFile, Span


@dataclass(frozen=True, slots=True)
class Placed:
    """An action and where it stands."""

    action: Action
    routine: Routine
    rung: Rung
    loop: Loop | None
    """The loop whose body it stands in."""
    is_top: bool
    """True in a rung of the routine itself, False in a rung of a loop's body."""
    condition: Condition
    """All that must hold for the action to run: its rung's condition, those of branches, of an outer loop."""

    @property
    def spec(self) -> Spec:
        return self.action.spec

    @property
    def is_unconditional(self) -> bool:
        """True when nothing but the scan itself decides whether the action runs."""
        terms = self.condition.terms if isinstance(self.condition, All) else (self.condition,)
        return all(isinstance(term, Always) for term in terms)


@dataclass(frozen=True)
class Facts:
    """``sources`` are the program's files by path, ``nicknames`` what each address is called."""

    program: Program
    sources: Mapping[str, SourceFile] = field(default_factory=dict)
    nicknames: Mapping[Address, str] = field(default_factory=dict)

    def shown(self, address: Address) -> str:
        """An address with its nickname, for a message: ``C5 (Motor)``."""
        own = self.nicknames.get(address) or system_name_of(address)
        bit = Address(CURRENT_VALUE_OF.get(address.bank, address.bank), address.number)
        name = own or self.nicknames.get(bit)
        return f"{address} ({name})" if name else str(address)

    def text(self, span: Span) -> str:
        """The source text of a span."""
        source = self.sources[span.path]
        if span.line == span.end_line:
            return source.line(span.line)[span.col - 1 : span.end_col - 1]
        lines = source.lines[span.line - 1 : span.end_line]
        return "\n".join([lines[0][span.col - 1 :], *lines[1:-1], lines[-1][: span.end_col - 1]])

    @cached_property
    def uses(self) -> Uses:
        return Uses.of(self.program)

    @cached_property
    def actions(self) -> tuple[Placed, ...]:
        """Every action in source order; a loop comes before its body."""
        return tuple(
            placed
            for routine in self.program.routines
            for rung in routine.rungs
            for placed in _placed(rung.items, routine, rung, None, (rung.condition,))
        )

    @cached_property
    def calls(self) -> Mapping[str, tuple[Placed, ...]]:
        """The calls of each subroutine that is called, by its name."""
        calls: dict[str, list[Placed]] = {}
        for placed in self.actions:
            if placed.spec is CALL:
                calls.setdefault(placed.action.word("subroutine"), []).append(placed)
        return {name: tuple(placed) for name, placed in calls.items()}

    def run_apart(self, one: Routine, other: Routine) -> bool:
        """True for two subroutines that are never called in the same scan: all their calls exclude each other."""
        if one is other or one.is_main or other.is_main:
            return False
        pairs = product(self.calls.get(one.name, ()), self.calls.get(other.name, ()))
        return all(are_exclusive(first.condition, second.condition) for first, second in pairs)

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


_Path = tuple[Condition, ...]
"""The conditions on the way to an action, outermost first."""


def _placed(items: tuple[Item, ...], routine: Routine, rung: Rung, loop: Loop | None, path: _Path) -> Iterator[Placed]:
    condition = path[0] if len(path) == 1 else All(path, path[0].span)
    for item in items:
        if isinstance(item, Branch):
            yield from _placed(item.items, routine, rung, loop, (*path, item.condition))
        elif isinstance(item, Loop):
            yield Placed(item.action, routine, rung, loop, loop is None, condition)
            for inner in item.body or ():
                yield from _placed(inner.items, routine, inner, item, (*path, inner.condition))
        else:
            yield Placed(item, routine, rung, loop, loop is None, condition)


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
