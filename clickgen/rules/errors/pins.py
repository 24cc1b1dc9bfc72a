"""Inputs of boxes: what is left out is never on, and what belongs to an input comes with it.

click-facts [counter.forms, drum.inputs, grid.pin-contact]
"""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.ir.program import Action
from clickgen.problems.diagnostics import Diagnostics


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        _check_missing(placed.action, problems)
        _check_belongings(placed.action, problems)


def _check_missing(action: Action, problems: Diagnostics) -> None:
    """Counters have a reset, shift registers a clock and a reset."""
    missing = [param for param in action.spec.pins if param.missing_pin and param.name not in action.args]
    if missing:
        names = " and no ".join(param.name for param in missing)
        gets = "that input gets" if len(missing) == 1 else "those inputs get"
        problems.add(
            missing[0].missing_pin,
            action.span,
            f"this {action.spec.name} has no {names}: {gets} ~SC1, which is never on",
            ", ".join(f"{param.name}=lambda: c.Name" for param in missing),
        )


def _check_belongings(action: Action, problems: Diagnostics) -> None:
    """A drum's jump comes with its step."""
    for param in action.spec.params:
        if not param.of_pin or (param.name in action.args) == (param.of_pin in action.args):
            continue
        given, missing = param.name, param.of_pin
        if missing in action.args:
            given, missing = missing, given
        problems.add(
            "CG110",
            action.args[given].span,
            f"{given!r} of {action.spec.name} needs {missing!r}",
            f"{action.spec.name}(..., {param.of_pin}=lambda: c.Name, {param.name}=2), or "
            f".{param.of_pin}(c.Name, {param.chained}=2) behind it",
        )
