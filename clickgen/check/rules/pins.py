"""Counters have a reset, shift registers a clock and a reset: what is left out is never on."""

from __future__ import annotations

from clickgen.check.facts import Facts
from clickgen.diagnostics import Diagnostics


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        action = placed.action
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
