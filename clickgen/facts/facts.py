"""A resolved program flattened for the rules: every action with its place, every contact, every comparison."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address
from clickgen.device.system import ALWAYS_ON, system_name_of
from clickgen.dialects.base import Dialect, Mender, Spelling
from clickgen.facts.uses import Uses, addresses_of
from clickgen.instructions.effects import Effects, Flow
from clickgen.instructions.spec import Spec
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Single
from clickgen.ir.program import Action, Branch, Declaration, Item, Loop, Program, Routine, Rung
from clickgen.ir.walk import condition_operands, leaves
from clickgen.logic.conditions import always_holds, are_exclusive
from clickgen.table.blocks import Block
from clickgen.table.rows import Row
from clickgen.text.source import SourceFile, Span
from clickgen.text.wording import shorten

FIRST_SCAN = Address("SC", 2)
STARTING = frozenset((ALWAYS_ON, FIRST_SCAN))
"""The bits that are always on, and on in the first scan: an action on these alone prepares the program."""


@dataclass(frozen=True, slots=True)
class Placed:
    """An action and its place."""

    action: Action
    routine: Routine
    rung: Rung
    loop: Action | None
    """The ``for`` of the loop around it, whether its body closes it or next_loop()."""
    in_body: bool
    """True in a rung of a loop's body, False in a rung of the routine itself."""
    condition: Condition
    """Everything that must hold for the action to run: its rung's condition, those of branches, of an outer loop."""
    opens_loop: bool = False
    """True for a ``for`` that next_loop() closes."""

    @property
    def spec(self) -> Spec:
        return self.action.spec

    @property
    def effects(self) -> Effects:
        return self.action.spec.effects

    @property
    def is_unconditional(self) -> bool:
        """True if only the scan itself decides whether the action runs."""
        terms = self.condition.terms if isinstance(self.condition, All) else (self.condition,)
        return all(isinstance(term, Always) for term in terms)

    def depends_only_on(self, addresses: Collection[Address]) -> bool:
        """True if its condition looks at none but these."""
        operands = condition_operands(self.condition)
        return all(address in addresses for operand in operands for address in addresses_of(operand))


@dataclass(frozen=True, slots=True)
class Site:
    """A condition and its place."""

    condition: Condition
    above: tuple[Condition, ...]
    """The conditions in series with it and looked at at the same moment: its rung's condition, those of branches."""
    routine: Routine
    rung: Rung
    pin: str = ""
    """The input of a box that it belongs to: ``reset``."""


@dataclass(frozen=True)
class Facts:
    """``sources`` are the program's files by path, ``rows`` the rows of the address table after a build.

    ``blocks`` are those of the source and of the table.
    """

    program: Program
    dialect: Dialect
    sources: Mapping[str, SourceFile] = field(default_factory=dict)
    rows: Mapping[Address, Row] = field(default_factory=dict)
    placed: frozenset[Address] = frozenset()
    """The addresses that clickgen chose for a name, in this build or before."""
    blocks: Collection[Block] = ()
    scratch_rows: Callable[[], Collection[Row]] = tuple
    """The rows of the scratch cells; none before the program is lowered."""
    importers: Callable[[], Sequence[str]] = tuple
    """The programs beside this one that import its file."""

    @property
    def spell(self) -> Spelling:
        """How the program's dialect writes what messages show."""
        return self.dialect.spell

    def mender(self, path: str) -> Mender | None:
        """What writes fixes in one of the files; None in a dialect without fixes."""
        if path not in self._menders:
            self._menders[path] = self.dialect.mender(self.sources[path])
        return self._menders[path]

    @cached_property
    def _menders(self) -> dict[str, Mender | None]:
        return {}

    def shown(self, address: Address) -> str:
        """An address with its nickname, for a message: ``C5 (Motor)``."""
        own = self.nickname(address) or system_name_of(address)
        bit = Address(CURRENT_VALUE_OF.get(address.bank, address.bank), address.number)
        name = own or self.nickname(bit)
        return f"{address} ({name})" if name else str(address)

    def nickname(self, address: Address) -> str:
        """The nickname of an address; ``""`` if it has none."""
        row = self.rows.get(address)
        return row.nickname if row else ""

    def listed(self, addresses: Sequence[Address]) -> str:
        """Several addresses for a message: up to three with their nicknames, a long run by its ends."""
        first, last = addresses[0], addresses[-1]
        if len(addresses) > 3 and abs(last.number - first.number) == len(addresses) - 1:
            return f"{self.shown(first)} to {self.shown(last)}"
        shown = [self.shown(address) for address in addresses[:3]]
        if len(addresses) > len(shown):
            shown.append(f"{len(addresses) - len(shown)} more")
        return shown[0] if len(shown) == 1 else f"{', '.join(shown[:-1])} and {shown[-1]}"

    def described(self, condition: Condition) -> str:
        """A condition for a message, addresses with their nicknames: ``C5 (Motor)``, ``DS1 (Step) == 3``."""
        if isinstance(condition, Compare):
            return f"{self._side(condition, condition.left)} {condition.op} {self._side(condition, condition.right)}"
        if isinstance(condition, Contact) and isinstance(condition.operand, Cell):
            shown = self.shown(condition.operand.address)
            edge = f"the {condition.edge.word} edge of " if condition.edge else ""
            return f"not {shown}" if condition.negated else edge + shown
        return shorten(self.text(condition.span))

    def _side(self, compare: Compare, side: Single) -> str:
        if isinstance(side, Cell):
            return self.shown(side.address)
        # A register by itself is compared with an unwritten 0.
        return "0" if compare.left.span == compare.right.span else self.text(side.span)

    def text(self, span: Span) -> str:
        """The source text of a span."""
        source = self.sources[span.path]
        if span.line == span.end_line:
            return source.line(span.line)[span.col - 1 : span.end_col - 1]
        lines = source.lines[span.line - 1 : span.end_line]
        return "\n".join([lines[0][span.col - 1 :], *lines[1:-1], lines[-1][: span.end_col - 1]])

    def with_test(self, placed: Placed, test: str) -> str:
        """An action's rung with one more test in series, for a way out: ``all(c.Run, ds.Rows > 0)``."""
        condition = placed.rung.condition
        is_free = isinstance(condition, Always)
        return test if is_free else self.spell.every(shorten(self.text(condition.span)), test)

    @cached_property
    def uses(self) -> Uses:
        return Uses.of(self.program)

    @cached_property
    def actions(self) -> tuple[Placed, ...]:
        """Every action in source order; a loop comes before its body."""
        return tuple(placed for routine in self.program.routines for placed in _placed_in(routine))

    def actions_of(self, routine: Routine) -> Sequence[Placed]:
        """The actions of one routine in source order."""
        return self._by_routine.get(routine.name, ())

    @cached_property
    def _by_routine(self) -> Mapping[str, Sequence[Placed]]:
        found: dict[str, list[Placed]] = {}
        for placed in self.actions:
            found.setdefault(placed.routine.name, []).append(placed)
        return found

    @cached_property
    def declared(self) -> Mapping[Address, Declaration]:
        """The ``nickname(...)`` of each address in the source."""
        return {declaration.cell.address: declaration for declaration in self.program.declarations}

    def initial(self, address: Address) -> str:
        """The initial value of the address as in the table; ``""`` if it has none."""
        row = self.rows.get(address)
        return row.initial if row else ""

    def is_retentive(self, address: Address) -> bool:
        """True if the address keeps its value over a power cycle."""
        row = self.rows.get(address)
        return row.retentive if row else BANKS[address.bank].retentive

    def is_set_up(self, address: Address) -> bool:
        """True if the source or the table gives initial value or retention beyond CLICK's defaults."""
        declared = self.declared.get(address)
        if declared and (declared.initial is not None or declared.retentive is not None):
            return True
        row = self.rows.get(address)
        return row is not None and not replace(row, nickname="", comment="").is_default

    def writers(self, address: Address) -> tuple[Placed, ...]:
        """The actions that write an address by its own number, each once, in source order."""
        if address not in self._writers:
            actions = {id(use.action): None for use in self.uses.writes(address)}
            writers = tuple(self._by_action[action] for action in actions)
            if self.uses.is_in_long_range(address.bank):
                return writers  # Caching these for each address of many long ranges takes too much memory.
            self._writers[address] = writers
        return self._writers[address]

    def place_of(self, action: Action) -> Placed:
        """The place of an action of the program."""
        return self._by_action[id(action)]

    @cached_property
    def _writers(self) -> dict[Address, tuple[Placed, ...]]:
        return {}

    @cached_property
    def places(self) -> Mapping[int, int]:
        """The place of each action in ``actions``, by its id."""
        return {id(placed.action): place for place, placed in enumerate(self.actions)}

    @cached_property
    def _by_action(self) -> Mapping[int, Placed]:
        return {id(placed.action): placed for placed in self.actions}

    @cached_property
    def calls(self) -> Mapping[str, tuple[Placed, ...]]:
        """The calls of each subroutine that is called, by its name."""
        calls: dict[str, list[Placed]] = {}
        for placed in self.actions:
            if placed.effects.flow is Flow.CALL:
                calls.setdefault(placed.action.called, []).append(placed)
        return {name: tuple(placed) for name, placed in calls.items()}

    def sometimes(self, routine: Routine) -> Any | None:
        """The condition under which a subroutine is called; None if that is in every scan, or never."""
        calls = self.calls.get(routine.name, ())
        conditions = tuple(self.seen_through(call.condition) for call in calls)
        never = Contact(Cell(ALWAYS_ON, routine.span), routine.span, negated=True)
        if not calls or always_holds(Any((*conditions, never), routine.span)):
            return None
        return Any(conditions, routine.span)

    @cached_property
    def left_early(self) -> frozenset[str]:
        """The names of the routines that an end() or return under a condition may leave before their last rung."""
        exits = (placed for placed in self.actions if placed.effects.leaves)
        return frozenset(placed.routine.name for placed in exits if not placed.is_unconditional)

    def run_apart(self, one: Routine, other: Routine) -> bool:
        """True for two subroutines that are never called in the same scan: all their calls exclude each other."""
        if one is other or one.is_main or other.is_main:
            return False
        key = frozenset((one.name, other.name))
        if key not in self._apart:
            pairs = product(self.calls.get(one.name, ()), self.calls.get(other.name, ()))
            self._apart[key] = all(self.exclude_each_other(first, second) for first, second in pairs)
        return self._apart[key]

    @cached_property
    def _apart(self) -> dict[frozenset[str], bool]:
        return {}

    def exclude_each_other(self, one: Placed, other: Placed) -> bool:
        """True if two actions never run in the same scan, as far as the program changes nothing in between."""
        return are_exclusive(*self.ways_to(one), *self.ways_to(other))

    def ways_to(self, placed: Placed) -> tuple[Condition, Condition]:
        """What must hold for an action to run, and the same seen through the coils that represent conditions."""
        return placed.condition, self.seen_through(placed.condition)

    def seen_through(self, condition: Condition) -> Condition:
        """The condition with each coil of main that only ``out`` drives replaced by what drives it."""
        if isinstance(condition, All | Any):
            return type(condition)(tuple(map(self.seen_through, condition.terms)), condition.span)
        if not isinstance(condition, Contact) or condition.negated or condition.edge:
            return condition
        operand = condition.operand
        return (isinstance(operand, Cell) and self._stands_for(operand.address)) or condition

    @cached_property
    def _standing(self) -> dict[Address, Condition | None]:
        return {}

    def _stands_for(self, bit: Address) -> Condition | None:
        if bit not in self._standing:
            self._standing[bit] = self._driver_of(bit)
        return self._standing[bit]

    def _driver_of(self, bit: Address) -> Condition | None:
        writers = self.writers(bit)
        if len(writers) != 1 or self.uses.is_pointed(bit.bank, is_written=True):
            return None
        (writer,) = writers
        is_level = not any(isinstance(leaf, Contact) and leaf.edge for leaf in leaves(writer.condition))
        is_steady = writer.routine.is_main and not writer.loop and not writer.action.flag("oneshot")
        return writer.condition if writer.effects.follows_power and is_steady and is_level else None

    @cached_property
    def sites(self) -> tuple[Site, ...]:
        """Every condition of rungs, branches and pins with its place, in source order."""
        return tuple(
            site for routine in self.program.routines for rung in routine.rungs for site in _rung_sites(rung, routine)
        )

    @cached_property
    def conditions(self) -> tuple[Condition, ...]:
        """Every condition: of rungs, branches and pins."""
        return tuple(site.condition for site in self.sites)

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


def _placed_in(routine: Routine) -> Iterator[Placed]:
    opened: Action | None = None
    for rung in routine.rungs:
        for placed in _placed(rung.items, routine, rung, None, (rung.condition,)):
            yield replace(placed, loop=opened) if opened and placed.loop is None else placed
            if placed.effects.flow is Flow.NEXT:
                opened = None
            elif placed.opens_loop:
                opened = opened or placed.action


def _placed(
    items: tuple[Item, ...], routine: Routine, rung: Rung, loop: Action | None, path: _Path
) -> Iterator[Placed]:
    condition = path[0] if len(path) == 1 else All(path, path[0].span)
    in_body = loop is not None
    for item in items:
        if isinstance(item, Branch):
            yield from _placed(item.items, routine, rung, loop, (*path, item.condition))
        elif isinstance(item, Loop):
            yield Placed(item.action, routine, rung, loop, in_body, condition, item.body is None)
            for inner in item.body or ():
                yield from _placed(inner.items, routine, inner, item.action, (*path, inner.condition))
        else:
            yield Placed(item, routine, rung, loop, in_body, condition)


def _rung_sites(rung: Rung, routine: Routine) -> Iterator[Site]:
    yield Site(rung.condition, (), routine, rung)
    yield from _item_sites(rung.items, (rung.condition,), routine, rung)


def _item_sites(items: tuple[Item, ...], above: _Path, routine: Routine, rung: Rung) -> Iterator[Site]:
    for item in items:
        if isinstance(item, Action):
            for param in item.spec.pins:
                condition = item.pin(param.name)
                if condition is not None:
                    yield Site(condition, (), routine, rung, param.name)
        elif isinstance(item, Branch):
            yield Site(item.condition, above, routine, rung)
            yield from _item_sites(item.items, (*above, item.condition), routine, rung)
        else:
            for inner in item.body or ():
                yield from _rung_sites(inner, routine)
