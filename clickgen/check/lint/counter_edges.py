"""A counter whose inputs are levels: vendor and simulator disagree whether it counts scans or edges."""

from __future__ import annotations

from clickgen.check.facts import Facts, Placed
from clickgen.check.rule import Rule, Wrong
from clickgen.diagnostics import Diagnostics
from clickgen.instructions import counters
from clickgen.ir.conditions import Always, Condition
from clickgen.ir.walk import leaves
from clickgen.source import Span

CODE = "CG513"


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        if placed.spec in counters.SPECS:
            for place, span in _levels(placed):
                problems.add(
                    CODE,
                    span,
                    f"{place} of this {placed.spec.name} is a level, not an edge: sources disagree whether CLICK then "
                    "counts once or in every scan",
                    "count edges: re(...) on the bit that is counted",
                )


def _levels(placed: Placed) -> list[tuple[str, Span]]:
    """The counted inputs that hold no edge."""
    found = [] if _has_edge(placed.condition) else [("the rung", placed.action.span)]
    down = placed.action.pin("count_down")
    if down is not None and not _has_edge(down):
        found.append(("count_down", down.span))
    return found


def _has_edge(condition: Condition) -> bool:
    return not isinstance(condition, Always) and any(getattr(leaf, "edge", "") for leaf in leaves(condition))


RULE = Rule(
    CODE,
    check,
    """
The vendor's help says that a counter counts once for each time its rung turns on; other sources, simulators among
them, count in every scan while it is on. With an edge on the counted bit both say the same, and a person who reads the
rung knows it too.
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
    ),
)
