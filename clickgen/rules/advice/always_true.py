"""A condition that every state of the machine makes true: it looks like a test but is none."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from clickgen.facts.facts import Facts
from clickgen.ir.conditions import All, Any, Compare, Condition
from clickgen.logic.conditions import MANY, always_holds, decided, may_meet, value_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG508"


def find(facts: Facts) -> Findings:
    for condition in facts.conditions:
        for part in _always(condition):
            yield finding(CODE, part.span, _fault(facts, part), _help(facts, condition, part))


def _always(part: Condition) -> Iterator[Compare | Any]:
    """Yield the innermost parts that are always true; all(...) is, only if each of its terms is."""
    if isinstance(part, All | Any):
        inside = [found for term in part.terms for found in _always(term)]
        if inside:
            yield from inside
        elif isinstance(part, Any) and may_meet(part.terms) and always_holds(part):
            yield part
    elif isinstance(part, Compare) and decided(part):
        yield part


def _fault(facts: Facts, part: Compare | Any) -> str:
    if isinstance(part, Compare):
        return f"{facts.described(part)} is always true ({value_of(part)})"
    for one, other in combinations(part.terms[:MANY], 2):
        if always_holds(Any((one, other), part.span)):
            return f"one of {facts.described(one)} and {facts.described(other)} is always true"
    return f"one of the alternatives of {facts.described(part)} is always true"


def _help(facts: Facts, condition: Condition, part: Compare | Any) -> str:
    both = f"correct one of them; where both must hold write {facts.spell.every('...')}"
    correct = "correct it" if isinstance(part, Compare) else both
    return f"{correct}; if it is meant, {f'write {facts.spell.always}' if part is condition else 'leave it out'}"


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a condition is always true",
    """
A test that is always true lets through what it seems to hold back. The classic is "neither 1 nor 2" written with
`any(...)`: of two different numbers the register always differs from one. Write `all(ds.Mode != 1, ds.Mode != 2)`.

Where the rung is meant to be unconditional, `if True:` says so, and so does the contact that is always on, `sc[1]`; the
rule says nothing of them. It also says nothing of `any(df.Level < 10, df.Level >= 10)`: a DF register can hold no
number (NaN), for example when words from another device are packed into it, and then neither comparison has to be true.
""",
    wrong=(
        Wrong(
            """
if any(ds.Mode != 1, ds.Mode != 2):  # <-
    reset(c.Running)
"""
        ),
        Wrong(
            """
if all(c.Run, ds.Count >= -32768):  # <-
    out(y.Motor)
if any(c.Auto, nc(c.Auto)):  # <-
    out(y.Lamp)
"""
        ),
        Wrong(
            """
if re(x.Part):
    ctu(ct.Parts, 10, reset=lambda: any(ds.Size < 5, ds.Size >= 5))  # <-
"""
        ),
    ),
    right=(
        """
if all(ds.Mode != 1, ds.Mode != 2):
    reset(c.Running)
""",
        """
if True:
    out(y.Power)
if any(sc[1], c.Test):
    out(y.Lamp)
if sc._Always_ON:
    out(y.Fan)
""",
        """
if any(df.Level < 10, df.Level >= 10):
    out(y.SensorAlive)
""",
        """
if any(ds.Level < 10, ds.Level > 90, c.Test):
    out(y.Horn)
""",
        """
if any(re(x.Switch), nc(x.Switch)):
    set(c.Moved)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
