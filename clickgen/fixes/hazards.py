"""Decides whether rungs or branches in place of elif and else do the same, although they all look and all run.

A rung of its own looks after the actions of those before it. An output whose rung or branch is off is turned off.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, pairwise

from clickgen.device.banks import MOVING_BANKS, Address
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import Condition
from clickgen.ir.operands import Cell, Named, form_of
from clickgen.ir.program import Action, Branch, Item, Loop, Program, actions_in, rungs_in
from clickgen.ir.proposals import Alternative, Proposal
from clickgen.ir.walk import action_operands, condition_operands
from clickgen.lower.effects import Cells, Effects, has_edge, is_volatile, reads
from clickgen.lower.expand import OffDelays


class Hazards:
    """The changes by the actions of a resolved program, and the cells that change by themselves.

    ``is_whole`` is False if there may be instructions that nobody has read. Arms that the program has no room for
    are in ``proposals``.
    """

    def __init__(self, program: Program, proposals: Iterable[Proposal], is_whole: bool) -> None:
        self._routines = {routine.name: routine for routine in program.routines}
        arms = [arm for proposal in proposals for arm in proposal.arms]
        rungs = [rung for routine in program.routines for rung in rungs_in(routine.rungs)]
        actions = [
            action
            for items in (*(rung.items for rung in rungs), *(arm.items for arm in arms))
            for action in _all_actions(items)
        ]
        delays = OffDelays(lambda bank, _, span: Cell(Address(bank, 0), span))
        for action in actions:
            if action.spec.built_from is not None and action.owned is not None:
                delays.add(action)
        self._effects = Effects(program.routines, delays)
        self._arriving = self._arriving_in(actions) if is_whole else None

    def may_undo(self, arms: Sequence[Alternative]) -> bool:
        """True if an arm that does not run may undo what an earlier one did: out turns its bit off then."""
        for earlier, later in combinations(arms, 2):
            loud = [action for action in _all_actions(later.items) if not action.effects.needs_power]
            if loud:
                done, undone = self._written(earlier.items), self._written_by(loud)
                if done is None or undone is None or done.meets(undone):
                    return True
        return False

    def may_look_again(self, arms: Sequence[Alternative]) -> bool:
        """True if the condition of each later arm is the same before and after the actions of the arms before it."""
        if self._arriving is None:
            return False
        written = Cells()
        for earlier, later in pairwise(arms):
            done = self._written(earlier.items)
            if done is None or any(map(_may_leave, _all_actions(earlier.items))):
                return False
            written.update(done)
            looked_at = reads(later.alone)
            if _is_unsteady(later.alone) or looked_at.meets(self._arriving):
                return False
            for condition in _conditions(later.items):
                looked_at.update(reads(condition))
            if looked_at.meets(written):
                return False
        return True

    def _written(self, items: tuple[Item, ...]) -> Cells | None:
        return self._written_by(_all_actions(items))

    def _written_by(self, actions: Iterable[Action]) -> Cells | None:
        """The cells that these actions may change; None if that is not known."""
        cells = Cells()
        for action in actions:
            if action.effects.flow is Flow.LOOP or action.effects.is_unknown or not _is_resolved(action):
                return None
            if action.effects.flow is Flow.CALL:
                routine = self._routines.get(action.called)
                if routine is None or not routine.is_whole:
                    return None
                called = [inner for rung in rungs_in(routine.rungs) for inner in actions_in(rung.items)]
                if not all(map(_is_resolved, called)):
                    return None
            cells.update(self._effects.writes(action))
        return cells

    def _arriving_in(self, actions: Iterable[Action]) -> Cells | None:
        """The cells that other devices change in their own time: data and message status. None if that is not known."""
        cells = Cells()
        for action in actions:
            if action.effects.is_unknown:
                return None
            if action.effects.is_late:
                if not _is_resolved(action):
                    return None
                cells.update(self._effects.writes(action))
        return cells


def _all_actions(items: tuple[Item, ...]) -> Iterator[Action]:
    """Yield every action, including those in the bodies of loops."""
    for item in items:
        if isinstance(item, Branch):
            yield from _all_actions(item.items)
        elif isinstance(item, Loop):
            yield item.action
            for rung in item.body or ():
                yield from _all_actions(rung.items)
        else:
            yield item


def _may_leave(action: Action) -> bool:
    """True where the rungs below may not run in this scan, or run again."""
    return action.effects.leaves or action.effects.flow is Flow.NEXT


def _is_resolved(action: Action) -> bool:
    return not any(isinstance(operand, Named) for operand in action_operands(action))


def _is_unsteady(condition: Condition) -> bool:
    """True if it may be different later in the scan, or if looking at it twice is not looking once."""
    is_moving = any(form_of(operand) in MOVING_BANKS for operand in condition_operands(condition))
    return is_moving or has_edge(condition) or is_volatile(condition)


def _conditions(items: Iterable[Item]) -> Iterator[Condition]:
    """The conditions of branches and pins."""
    for item in items:
        if isinstance(item, Branch):
            yield item.condition
            yield from _conditions(item.items)
        elif not isinstance(item, Loop):
            yield from (pin for param in item.spec.pins if (pin := item.pin(param.name)) is not None)
