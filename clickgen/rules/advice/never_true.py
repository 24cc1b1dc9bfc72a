"""A condition that no state of the machine makes true: whatever depends on it never comes on."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from clickgen.facts.facts import Facts, Site
from clickgen.ir.conditions import All, Any, Compare, Condition
from clickgen.logic.conditions import MANY, are_exclusive, can_hold, decided, looked_at, may_meet, terms_of, value_of
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG507"

_NAMED_MAX = 4
"""A message names at most this many terms that exclude each other."""


def find(facts: Facts) -> Findings:
    for site in facts.sites:
        if may_meet((*site.above, site.condition)):
            # A branch of a dead rung is found with the rung.
            if site.above and are_exclusive(*site.above):
                continue
            found = _never(site.condition, site.above, False, _Patience())
        else:
            found = _never_alone(site.condition, False)
        for part, beside, is_leg in found:
            yield from _report(facts, site, part, beside, is_leg)


_PARTS_MAX = 1_000
"""No condition that a person wrote has this many parts; in a larger one the rule looks only at the first ones."""

_Found = tuple[Condition, tuple[Condition, ...], bool]
"""A part that is never true, the conditions in series with it, and whether it is one of several alternatives."""


class _Patience:
    """How many parts of one condition may still be looked at: nested alternatives double at every level."""

    def __init__(self) -> None:
        self._left = _PARTS_MAX

    @property
    def is_over(self) -> bool:
        self._left -= 1
        return self._left < 0


def _never(part: Condition, beside: tuple[Condition, ...], is_leg: bool, patience: _Patience) -> Iterator[_Found]:
    """Yield the innermost parts that are never true beside these others."""
    if patience.is_over:
        return
    if isinstance(part, All):
        inside = [found for term in part.terms for found in _never(term, beside, is_leg, patience)]
        if inside:
            yield from inside
        elif are_exclusive(*beside, part):
            yield part, beside, is_leg
        elif len(part.terms) <= MANY:
            for term in part.terms:
                if isinstance(term, All | Any):
                    others = (other for other in part.terms if other is not term)
                    near = _near(term, (*beside, *others))
                    if near:
                        yield from _never(term, near, is_leg, patience)
    elif isinstance(part, Any):
        if beside and are_exclusive(*beside, part) and can_hold(part):
            yield part, beside, is_leg
        else:
            for term in part.terms:
                yield from _never(term, beside, is_leg or len(part.terms) > 1, patience)
    elif isinstance(part, Compare) and decided(part) is False:
        yield part, (), is_leg
    else:
        near = _near(part, beside) if beside else ()
        if near and are_exclusive(*near, part):
            yield part, near, is_leg


def _near(part: Condition, beside: tuple[Condition, ...]) -> tuple[Condition, ...]:
    """Those that look at something that this part looks at too."""
    own = looked_at(part)
    return tuple(other for other in beside if not own.isdisjoint(looked_at(other)))


def _never_alone(part: Condition, is_leg: bool) -> Iterator[_Found]:
    """The same if all parts are independent: only a comparison can be never true by itself."""
    if isinstance(part, All | Any):
        for term in part.terms:
            yield from _never_alone(term, is_leg or (isinstance(part, Any) and len(part.terms) > 1))
    elif isinstance(part, Compare) and decided(part) is False:
        yield part, (), is_leg


def _report(facts: Facts, site: Site, part: Condition, beside: tuple[Condition, ...], is_leg: bool) -> Findings:
    help = f"correct one of them; for one or the other write {facts.spell.some('...')}"
    labels: tuple[Label, ...] = ()
    if isinstance(part, Compare) and decided(part) is False:
        fault = f"{facts.described(part)} is never true ({value_of(part)})"
        help = "correct the constant, or leave the comparison out"
    else:
        own = terms_of(part)
        terms = _at_odds(own, terms_of(*beside))
        fault = f"{_listed([facts.described(term) for term in terms])} never true{' together' * (len(terms) > 1)}"
        outer = [term for term in terms if not any(term is one for one in own)]
        labels = tuple(Label(term.span, "in series with it") for term in outer)
        above = terms_of(*site.above)
        if any(term is one for term in outer for one in above):
            help = "correct one of them, or give the branch a rung of its own"
    yield finding(CODE, part.span, f"{fault}, so {_consequence(site, is_leg)}", help, labels)


def _at_odds(own: tuple[Condition, ...], beside: tuple[Condition, ...]) -> list[Condition]:
    """The fewest of these terms that are still never true together: two if two are enough."""
    near, far = own[:MANY], beside[:MANY]
    pairs = [*combinations(near, 2), *((one, other) for other in far for one in near)]
    for pair in pairs:
        if are_exclusive(*pair):
            return list(pair)
    kept = [*own, *beside]
    for term in reversed(kept[:]):
        rest = [one for one in kept if one is not term]
        if rest and are_exclusive(*rest):
            kept = rest
    return kept


def _listed(shown: list[str]) -> str:
    """Some terms as the subject of a sentence: up to four of them by name."""
    if len(shown) > _NAMED_MAX:
        shown = [*shown[: _NAMED_MAX - 1], f"{len(shown) - _NAMED_MAX + 1} more"]
    return f"{shown[0]} is" if len(shown) == 1 else f"{', '.join(shown[:-1])} and {shown[-1]} are"


def _consequence(site: Site, is_leg: bool) -> str:
    if is_leg:
        return "this alternative never counts"
    if site.pin:
        return f"the input {site.pin} never comes"
    return f"the {'branch' if site.above else 'rung'} never comes on"


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a condition can never be true",
    """
What hangs on a condition that is never true does not run, whatever the machine does, and in CLICK the rung just never
turns blue. It is mostly `all(...)` where `any(...)` was meant, a comparison turned the wrong way, or a copied line in
which one term was not changed. A branch is looked at together with the conditions above it.

To switch a rung off on purpose, put the never-contact into it: `nc(sc[1])`. The rule says nothing of it.
""",
    wrong=(
        Wrong(
            """
if all(ds.Mode == 1, ds.Mode == 2):  # <-
    out(y.Motor)
"""
        ),
        Wrong(
            """
if any(c.Manual, all(ds.Level < 10, ds.Level > 90)):  # <-
    set(c.Alarm)
"""
        ),
        Wrong(
            """
if all(c.Run, x.Guard):
    out(y.Motor)
    if nc(x.Guard):  # <-
        set(c.Fault)
"""
        ),
        Wrong(
            """
if re(x.Part):
    ctu(ct.Parts, 10, reset=lambda: all(c.Clear, nc(c.Clear)))  # <-
if ds.Percent == 50.5:  # <-
    set(c.Half)
if all(ds.Mode == 1, any(ds.Mode == 2, c.Test)):  # <-
    set(c.Lamp)
"""
        ),
    ),
    right=(
        """
if any(ds.Mode == 1, ds.Mode == 2):
    out(y.Motor)
""",
        """
if all(c.Run, nc(sc[1])):
    out(y.Motor)
if re(x.Part):
    ctu(ct.Parts, 10, reset=lambda: nc(sc._Always_ON))
""",
        """
if all(ds.Level >= 10, ds.Level <= 90, nc(c.Alarm)):
    out(y.Lamp)
    if ds.Level == 10:
        set(c.Alarm)
""",
        """
if ds.Step == 1:
    for _ in range(5):
        if True:
            calc("ds.Step + 1", ds.Step)
        if ds.Step == 3:
            set(c.Three)
""",
        """
if all(x.Door.immediate, nc(x.Door)):
    out(y.Horn)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
