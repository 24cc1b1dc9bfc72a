"""One flattened scan: the actions of main, and at each call those of the subroutine."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import All
from clickgen.ir.program import Routine, Rung

_CALLS_MAX = 4
"""This many calls of one subroutine are followed."""


class Step(NamedTuple):
    """An action in its scan. Its condition holds that of the call too."""

    placed: Placed
    call: Placed | None
    """The call that leads to it; None for an action of the routine with which the scan begins."""
    own: Placed
    """The action as it is in its routine."""

    @property
    def rung(self) -> Rung:
        """The rung of main that it belongs to, or of the routine with which the scan begins."""
        return (self.call or self.placed).rung


def scans(facts: Facts) -> Iterator[Iterator[Step]]:
    """Yield the scan that begins with main, then each routine whose calls are not followed."""
    followed: Counter[str] = Counter()
    routines = {routine.name: routine for routine in facts.program.subroutines}
    if facts.program.main is not None:
        yield _steps(facts, facts.program.main, routines, followed)
    for routine in facts.program.routines:
        if not routine.is_main and routine.name not in followed:
            yield _steps(facts, routine, {}, followed)


def _steps(facts: Facts, routine: Routine, routines: dict[str, Routine], followed: Counter[str]) -> Iterator[Step]:
    for placed in facts.actions_of(routine):
        called = routines.get(placed.action.called)
        if called is None or placed.loop or followed[called.name] >= _CALLS_MAX:
            yield Step(placed, None, placed)
            continue
        followed[called.name] += 1
        for inner in facts.actions_of(called):
            if inner.effects.flow is Flow.RETURN and inner.is_unconditional:
                break
            condition = All((placed.condition, inner.condition), inner.condition.span)
            yield Step(replace(inner, condition=condition), placed, inner)
