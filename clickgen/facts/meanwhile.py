"""The bits and values of a subroutine while it is not called, and who notices that they stay."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping

from clickgen.device.banks import Address
from clickgen.device.system import ALWAYS_ON
from clickgen.facts.facts import STARTING, Facts, Placed, Site
from clickgen.facts.uses import addresses_of
from clickgen.facts.written import equals, left_in
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell
from clickgen.ir.program import Routine, rungs_in
from clickgen.ir.walk import condition_operands
from clickgen.logic.conditions import are_exclusive, implies, looked_at, terms_of

_DEPTH_MAX = 5
"""A rung is followed through this many coils."""
_WRITERS_MAX = 20
"""If more instructions than this write an address, it is not reported as frozen."""


class Watch:
    """Finds who notices that a bit or value freezes while a subroutine is not called."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        found = ((routine.name, facts.sometimes(routine)) for routine in facts.program.subroutines)
        self.sometimes: dict[str, Any] = {name: condition for name, condition in found if condition}
        """The condition for each subroutine that is not called in every scan."""
        self._sites: dict[Address, list[Site]] = defaultdict(list)
        for site in facts.sites:
            for address in {one for operand in condition_operands(site.condition) for one in addresses_of(operand)}:
                self._sites[address].append(site)
        self._orders: dict[str, Mapping[int, int]] = {}

    def is_felt(self, address: Address, routine: Routine) -> bool:
        """True if something outside the subroutine looks at an address while the subroutine is not called."""
        when = self.sometimes[routine.name]
        for use in self._facts.uses.reads(address):
            if use.routine is not routine and use.leaf is None:
                placed = self._facts.place_of(use.action) if use.action else None
                if placed is None or self._runs_meanwhile(placed, routine):
                    return True
        return any(
            site.routine is not routine and self._makes_a_difference(address, site, when)
            for site in self._sites.get(address, ())
        )

    def is_taken_up(self, bit: Address, placed: Placed) -> bool:
        """True if the next call looks at a bit before this action rewrites it, or nobody in the program does.

        A coil that seals itself in starts from its old state. A bit that nothing reads is for a panel.
        """
        reads = self._facts.uses.reads(bit)
        own = self._order(placed.routine)
        return not reads or any(
            use.routine is placed.routine and own[id(use.rung)] <= own[id(placed.rung)] for use in reads
        )

    def is_written_meanwhile(self, bit: Address, routine: Routine) -> bool:
        """True if something may turn a bit off while the subroutine is not called, or before that ends the calls."""
        ends_itself = any(
            writer.routine is routine
            for key in looked_at(self.sometimes[routine.name])
            if isinstance(key, Address)
            for writer in self._facts.writers(key)
        )
        writers = self._facts.writers(bit)
        return len(writers) > _WRITERS_MAX or any(
            self._runs_meanwhile(writer, routine) or (ends_itself and writer.action.turns is False)
            for writer in writers
        )

    def is_stopped_meanwhile(self, timer: Placed) -> bool:
        """True if something turns the rung of a timer off while its subroutine is not called: it starts again."""
        return timer.effects.falls_back and any(
            self._is_stopped(term, timer.routine) for term in self._needed(timer.condition, timer.routine)
        )

    def _needed(self, condition: Condition, routine: Routine, depth: int = 0) -> Iterator[Contact | Compare]:
        """The contacts that a condition needs, through the coils of its own routine, which every call rewrites."""
        for term in terms_of(condition):
            if isinstance(term, Contact) and not term.negated and not term.edge and isinstance(term.operand, Cell):
                writers = self._facts.writers(term.operand.address)
                is_coil = len(writers) == 1 and writers[0].effects.follows_power
                if is_coil and writers[0].routine is routine and depth < _DEPTH_MAX:
                    yield from self._needed(writers[0].condition, routine, depth + 1)
                else:
                    yield term
            elif isinstance(term, Compare):
                yield term

    def _is_stopped(self, term: Contact | Compare, routine: Routine) -> bool:
        """True if something resets a bit, or writes another number, while the subroutine is not called."""
        for address in {one for operand in condition_operands(term) for one in addresses_of(operand)}:
            for writer in self._facts.writers(address)[:_WRITERS_MAX]:
                if writer.depends_only_on(STARTING) or not self._runs_meanwhile(writer, routine):
                    continue
                left = left_in(writer, address, 0)
                is_other = left is not None and are_exclusive(term, equals(address, left, term.span))
                if writer.action.turns is False or is_other:
                    return True
        return False

    def _runs_meanwhile(self, placed: Placed, routine: Routine) -> bool:
        if placed.routine is routine:
            return False
        way = All(self._way(placed.routine, placed.condition), routine.span)
        return not implies(way, self.sometimes[routine.name])

    def _order(self, routine: Routine) -> Mapping[int, int]:
        """The place of each rung in its routine, by its id."""
        if routine.name not in self._orders:
            self._orders[routine.name] = {id(rung): place for place, rung in enumerate(rungs_in(routine.rungs))}
        return self._orders[routine.name]

    def _makes_a_difference(self, address: Address, site: Site, when: Any) -> bool:
        way = All(self._way(site.routine, *site.above, site.condition), site.condition.span)
        if implies(way, when):
            return False
        on, off = _with(way, address, True), _with(way, address, False)
        if on is None or off is None:
            return True
        return not implies(on, Any((when, off), way.span)) or not implies(off, Any((when, on), way.span))

    def _way(self, routine: Routine, *conditions: Condition) -> tuple[Condition, ...]:
        call = self.sometimes.get(routine.name)
        return (*conditions, call) if call else conditions


def _with(condition: Condition, bit: Address, is_on: bool) -> Condition | None:
    """A condition with a frozen bit, on or off; None if it looks at the address as a value."""
    if isinstance(condition, All | Any):
        terms = [_with(term, bit, is_on) for term in condition.terms]
        known = [term for term in terms if term is not None]
        return type(condition)(tuple(known), condition.span) if len(known) == len(terms) else None
    if not any(bit in addresses_of(operand) for operand in condition_operands(condition)):
        return condition
    if not isinstance(condition, Contact) or not isinstance(condition.operand, Cell):
        return None
    if not condition.edge and is_on is not condition.negated:
        return Always(condition.span)
    return Contact(Cell(ALWAYS_ON, condition.span), condition.span, negated=True)
