"""Inputs of boxes: what is left out is never on, and what belongs to an input comes with it.

click-facts [counter.forms, drum.inputs, grid.pin-contact]
"""

from __future__ import annotations

from clickgen.dialects.base import Spelling
from clickgen.facts.facts import Facts
from clickgen.ir.program import Action
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        yield from _check_missing(facts.spell, placed.action)
        yield from _check_belongings(facts.spell, placed.action)


def _check_missing(spell: Spelling, action: Action) -> Findings:
    """Counters have a reset, shift registers a clock and a reset."""
    missing = [param for param in action.spec.pins if param.missing_pin and param.name not in action.args]
    if missing:
        names = " and no ".join(param.name for param in missing)
        gets = "that input gets" if len(missing) == 1 else "those inputs get"
        yield finding(
            missing[0].missing_pin,
            action.span,
            f"this {action.spec.name} has no {names}: {gets} ~SC1, which is never on",
            ", ".join(spell.pin(param.name, spell.name("C", "Name")) for param in missing),
        )


def _check_belongings(spell: Spelling, action: Action) -> Findings:
    """A drum's jump comes with its step."""
    for param in action.spec.params:
        if not param.of_pin or (param.name in action.args) == (param.of_pin in action.args):
            continue
        given, missing = param.name, param.of_pin
        if missing in action.args:
            given, missing = missing, given
        bit = spell.name("C", "Name")
        whole = spell.call(action.spec, "...", spell.pin(param.of_pin, bit), spell.setting(param.name, "2"))
        chained = spell.chained(param.of_pin, bit, **{param.chained: "2"})
        yield finding(
            "CG110",
            action.args[given].span,
            f"{given!r} of {action.spec.name} needs {missing!r}",
            f"{whole}, or {chained} after it" if chained else whole,
        )


CODES = (
    Code(
        "CG418",
        Severity.WARNING,
        "a counter has no reset",
        """
The counter's reset input gets `~SC1`, a contact that is never on, because CLICK needs a contact there
(C0205 and following). If you need to reset the counter, write `.reset(c.Name)` after it.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    ctu(ct.Parts, setpoint=100)  # <-
""",
            ),
        ),
        right=(
            """
if re(x[1]):
    ctu(ct.Parts, setpoint=100, reset=lambda: c.Clear)
""",
        ),
    ),
    Code(
        "CG419",
        Severity.WARNING,
        "a shift register has no clock or no reset",
        """
A missing input of the shift register gets `~SC1`, a contact that is never on. Without a clock, the
register never shifts.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    shift(c[1:9], clock=lambda: c.Step)  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    shift(c[1:9], clock=lambda: c.Step, reset=lambda: c.Clear)
""",
        ),
    ),
)

RULE = Rule(find, CODES, also=("CG110",), holds_in_parts=True)
