"""The actions that never run, for rules that compare actions with each other."""

from __future__ import annotations

from clickgen.facts.facts import Facts


def never_run(facts: Facts) -> set[int]:
    """The ids of actions that never run: in subroutines that nothing calls, and after an end() or return."""
    # This rule's file is part of a package that loads every rule, the ones that import this file too.
    from clickgen.rules.advice.unreached_rung import unreached

    idle = {id(missed.action) for routine in facts.program.routines for missed in unreached(routine.rungs)}
    if facts.program.main is None:  # A part of a program: what runs, another file says.
        return idle
    uncalled = (one for one in facts.actions if not one.routine.is_main and one.routine.name not in facts.calls)
    return idle | {id(placed.action) for placed in uncalled}
