"""A counter whose inputs are levels: vendor and simulator disagree on whether it counts scans or edges
(click-facts [counter.edges])."""

from __future__ import annotations

from clickgen.facts.facts import Facts, Placed
from clickgen.facts.pulses import Pulses
from clickgen.instructions.effects import Keeps
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

CODE = "CG513"


def find(facts: Facts) -> Findings:
    pulses = Pulses(facts)
    for placed in facts.actions:
        if Keeps.COUNT in placed.effects.keeps:
            for place, span in _levels(pulses, placed):
                yield finding(
                    CODE,
                    span,
                    f"{place} of this {placed.spec.name} is a level, not an edge: sources disagree whether CLICK then "
                    "counts once or in every scan",
                    f"count edges: {facts.spell.rising('...')} on the bit that is counted",
                )


def _levels(pulses: Pulses, placed: Placed) -> list[tuple[str, Span]]:
    """The counted inputs that may be on for longer than a scan."""
    found = [] if pulses.has(placed.condition, placed.routine) else [("the rung", placed.action.span)]
    for param in placed.spec.pins:
        counted = placed.action.pin(param.name) if param.name != placed.effects.reset_by else None
        if counted is not None and not pulses.has(counted, placed.routine):
            found.append((param.name, counted.span))
    return found


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a counter counts without an edge",
    """
The vendor's help says that a counter counts once for each time its rung turns on; other sources, simulators among
them, count in every scan while it is on. With an edge on the counted bit both say the same, and a person who reads the
rung knows it too.

A bit that is on for one scan is as good as an edge, and the rule quiet: a coil that an edge or a one-shot drives, a bit
that an edge sets and every scan resets, a timer or a counter that resets itself, the bit of the first scan.
""",
    wrong=(
        Wrong(
            """
if x.Part:
    ctu(ct.Parts, setpoint=100, reset=lambda: c.NewBatch)  # <-
"""
        ),
        Wrong(
            """
if re(x.In):
    ctud(ct.Level, 50, count_down=lambda: x.Out, reset=lambda: c.Empty)  # <-
"""
        ),
    ),
    right=(
        """
if re(x.Part):
    ctu(ct.Parts, setpoint=100, reset=lambda: c.NewBatch)
""",
        """
if all(c.Running, fe(x.Part)):
    ctud(ct.Level, 50, count_down=lambda: re(x.Out), reset=lambda: c.Empty)
""",
        """
if re(x.Part):
    out(c.PartCame)
if all(c.Running, c.PartCame):
    ctu(ct.Box, setpoint=12, reset=lambda: ct.Box)
if ct.Box:
    ctu(ct.Pallet, setpoint=40, reset=lambda: ct.Pallet)
""",
        """
if nc(t.Minute):
    ton(t.Minute, setpoint=60, unit=Ts)
if t.Minute:
    ctu(ct.Minutes, setpoint=480, reset=lambda: c.NewShift)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
