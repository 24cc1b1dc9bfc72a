"""Conditions that are on for one scan at a time: edges, and the bits that represent one.

A condition that cannot be proven a pulse counts as a level.
"""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.facts import FIRST_SCAN, Facts, Placed
from clickgen.ir.conditions import All, Any, Condition, Contact, Edge
from clickgen.ir.operands import Cell
from clickgen.ir.program import Routine
from clickgen.logic.conditions import implies

_DEPTH_MAX = 20
"""A bit that represents an edge through more bits than this counts as a level."""


class Pulses:
    """Which conditions of a program are pulses."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        self._known: dict[tuple[Address, str], bool] = {}
        """The bits that were asked for, each with the routine that looks at it; False while one is being examined."""
        self._depth = 0

    def has(self, condition: Condition, routine: Routine) -> bool:
        """True if a condition is on in one scan and then off, for whoever looks at it in this routine."""
        if isinstance(condition, All):
            return any(self.has(term, routine) for term in condition.terms)
        if isinstance(condition, Any):
            return all(self.has(term, routine) for term in condition.terms)
        if not isinstance(condition, Contact) or condition.negated:
            return False
        return bool(condition.edge) or (isinstance(condition.operand, Cell) and self._knows(condition.operand, routine))

    def _knows(self, cell: Cell, routine: Routine) -> bool:
        key = cell.address, routine.name
        if key not in self._known:
            self._known[key] = False
            self._depth += 1
            self._known[key] = self._depth <= _DEPTH_MAX and self._is_short(cell.address, routine)
            self._depth -= 1
        return self._known[key]

    def _is_short(self, bit: Address, routine: Routine) -> bool:
        """True if a bit that comes on is off again before this routine looks at it a second time."""
        if bit == FIRST_SCAN:
            return True
        writers = self._facts.writers(bit)
        if self._facts.uses.is_pointed(bit.bank, is_written=True):
            return False
        if any(writer.action.turns for writer in writers):
            return self._is_taken_back(bit, writers, routine)
        return len(writers) == 1 and self._keeps_up(writers[0], routine) and self._ends(writers[0], bit)

    def _ends(self, writer: Placed, bit: Address) -> bool:
        """True if the only instruction that writes a bit turns it off when it runs again."""
        if writer.effects.follows_power:
            return writer.action.flag("oneshot") or self.has(writer.condition, writer.routine)
        if writer.effects.falls_back:
            return implies(writer.condition, _contact(writer, bit, negated=True))
        reset = writer.action.pin(writer.effects.reset_by)
        resets_itself = reset is not None and implies(_contact(writer, bit, edge=Edge.RISE), reset)
        return resets_itself and writer.effects.done is True

    def _is_taken_back(self, bit: Address, writers: tuple[Placed, ...], routine: Routine) -> bool:
        """True if only edges set a bit and every scan resets it."""
        resets = [writer for writer in writers if writer.action.turns is False]
        sets = [writer for writer in writers if writer.action.turns is True]
        if len(resets) + len(sets) < len(writers):
            return False
        always = (writer for writer in resets if self._keeps_up(writer, routine))
        return any(implies(_contact(writer, bit), writer.condition) for writer in always) and all(
            self.has(writer.condition, writer.routine) for writer in sets
        )

    def _keeps_up(self, writer: Placed, routine: Routine) -> bool:
        """True if an action is looked at as often as the routine runs: in every scan, or because it is part of it."""
        if writer.loop:
            return False
        calls = self._facts.calls.get(writer.routine.name, ())
        return writer.routine is routine or writer.routine.is_main or any(call.is_unconditional for call in calls)


def _contact(writer: Placed, bit: Address, negated: bool = False, edge: Edge | None = None) -> Contact:
    return Contact(Cell(bit, writer.action.span), writer.action.span, negated, edge)
