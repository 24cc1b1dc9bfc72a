"""A term that repeats another one in series or in parallel with it: mostly a copied line."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import combinations

from clickgen.facts.facts import Facts
from clickgen.ir.conditions import All, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Immediate, Range
from clickgen.ir.walk import condition_operands, leaves
from clickgen.logic.conditions import (
    MANY,
    always_holds,
    are_exclusive,
    can_hold,
    implies,
    looked_at,
    may_meet,
    shape,
    terms_of,
)
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.edits import Fix

CODE = "CG509"


def find(facts: Facts) -> Findings:
    judge = _Judge(facts)
    for site in facts.sites:
        if may_meet((*site.above, site.condition)):
            judge.series(site.condition, terms_of(*site.above))
    yield from judge.found


_Pair = tuple[Condition, Condition]
"""A redundant term, and the one that makes it so."""


class _Judge:
    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        self.found: list[Diagnostic] = []

    def series(self, part: Condition, beside: tuple[Condition, ...]) -> None:
        """Judge terms that all must hold, beside others that hold too."""
        kept = self._without_repeats(part, terms_of(part), beside)
        if len(kept) + len(beside) <= MANY and not are_exclusive(*beside, part):
            pairs = [(term, cause) for term in kept for cause in beside] + _both_ways(kept)
            for term, cause in _too_much(pairs, lambda term, cause: implies(cause, term) and not always_holds(term)):
                kept.remove(term)
                self._report(term, cause, f"{self._facts.described(cause)} in series with it says it already")
        for term in kept:
            if isinstance(term, Any):
                self.parallel(term, (*beside, *(other for other in kept if other is not term)))

    def parallel(self, part: Any, beside: tuple[Condition, ...]) -> None:
        """Judge alternatives, and the conditions beside each of them."""
        kept = self._without_repeats(part, _alternatives(part), ())
        if len(kept) <= MANY and not always_holds(part):
            for term, cause in _too_much(_both_ways(kept), lambda term, cause: implies(term, cause) and can_hold(term)):
                kept.remove(term)
                self._report(term, cause, f"{self._facts.described(cause)} in parallel with it is on whenever it is")
        for term in kept:
            if isinstance(term, All):
                self.series(term, beside)

    def _without_repeats(
        self, part: Condition, terms: tuple[Condition, ...], beside: tuple[Condition, ...]
    ) -> list[Condition]:
        """Return the terms that are not word for word an earlier one; report the others in one finding with one fix."""
        above = {shape(term): term for term in reversed(beside)}
        seen: dict[object, Condition] = {}
        again: list[_Pair] = []
        for term in terms:
            said = above.get(shape(term))
            if said is not None:
                self._report(term, said, "the same is in series with it")
                continue
            first = seen.setdefault(shape(term), term)
            if first is not term:
                again.append((term, first))
        if again:
            wiring = "parallel" if isinstance(part, Any) else "series"
            named = dict.fromkeys(self._facts.described(term) for term, _ in again)
            verb = "are" if len(named) > 1 else "is"
            self.found.append(
                finding(
                    CODE,
                    again[0][0].span,
                    f"{' and '.join(named)} {verb} twice in {wiring}: the second time changes nothing",
                    "leave it out, or name the address that was meant",
                    tuple(Label(first.span, "the first time") for _, first in again),
                    _removal(self._facts, again),
                )
            )
        return list(seen.values())

    def _report(self, term: Condition, cause: Condition, reason: str) -> None:
        fault = f"{self._facts.described(term)} changes nothing: {reason}"
        help = "leave it out, or correct what is not meant so"
        self.found.append(finding(CODE, term.span, fault, help, (Label(cause.span, "this one"),)))


def _alternatives(part: Any) -> tuple[Condition, ...]:
    return tuple(flat for term in part.terms for flat in (_alternatives(term) if isinstance(term, Any) else (term,)))


def _both_ways(terms: list[Condition]) -> list[_Pair]:
    """Every pair, the later one first as the redundant one; not ds.Step == 1 and ds.Step == 2, which is common."""
    equations = [isinstance(term, Compare) and term.op == "==" for term in terms]
    pairs = combinations(zip(terms, equations, strict=True), 2)
    return [
        pair
        for (one, first), (other, second) in pairs
        if not (first and second)
        for pair in ((other, one), (one, other))
    ]


def _too_much(pairs: Iterable[_Pair], is_too_much: Callable[[Condition, Condition], bool]) -> list[_Pair]:
    found: list[_Pair] = []
    gone: set[int] = set()
    looks: dict[int, set[object]] = {}
    for term, cause in pairs:
        for one in (term, cause):
            if id(one) not in looks:
                # A level beside an edge of its bit is written for the reader: all(c.Run, re(c.Run)) is no mistake.
                looks[id(one)] = set() if _has_edge(one) else looked_at(one)
        if id(term) in gone or id(cause) in gone or looks[id(term)].isdisjoint(looks[id(cause)]):
            continue
        if is_too_much(term, cause):
            gone.add(id(term))
            found.append((term, cause))
    return found


def _has_edge(condition: Condition) -> bool:
    return any(isinstance(leaf, Contact) and leaf.edge for leaf in leaves(condition))


# -- the fix ----------------------------------------------------------------------------------------------------------


def _removal(facts: Facts, again: list[_Pair]) -> Fix | None:
    """Remove terms that repeat an earlier one from a series or a parallel; None if more would go."""
    mender = facts.mender(again[0][0].span.path)
    edits = mender.without_terms([term.span for term, _ in again]) if mender is not None else None
    if edits is None:
        return None
    # Two words for one address are equal only by the table of this program.
    rests_on_names = any(_words(facts, term) != _words(facts, first) for term, first in again)
    return Fix(edits, rests_on_names=rests_on_names)


def _words(facts: Facts, term: Condition) -> set[str]:
    """The words with which a term writes its addresses."""
    operands = (operand for operand in condition_operands(term) if isinstance(operand, Cell | Range | Immediate))
    return {"".join(facts.text(operand.span).split()) for operand in operands}


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a condition repeats a term",
    """
A second contact on the same bit in one series changes nothing, so it is mostly a copied term in which the address was
not changed: the guard of the other door that nobody checks. The same goes for two equal alternatives, for a branch that
asks again what its rung asks already, and for a comparison that another one includes: of `ds.Level > 50` and
`ds.Level > 30` in series one does nothing, and often one of them should be `<`.

Word-for-word repeats in one `all(...)` or `any(...)` are taken out by the fix. What only follows from another term is
left to you: either the term or its number is wrong. Edges count as equal within one rung, since all of it is looked at
in one moment; immediate contacts do not, since each reads the terminal again. A level beside an edge of the same bit is
left alone.
""",
    wrong=(
        Wrong(
            """
if all(x.Door1, x.Door2, x.Door1):  # <-
    out(y.Motor)
""",
            """
if all(x.Door1, x.Door2):  # <-
    out(y.Motor)
""",
        ),
        Wrong(
            """
if any(c.Start, c.Start):  # <-
    set(c.Run)
if all(c.Auto, any(re(x.Go), c.Test, re(x.Go)), all(c.Auto, nc(c.Fault))):  # <-  # <-
    set(c.Run)
""",
            """
if c.Start:  # <-
    set(c.Run)
if all(c.Auto, any(re(x.Go), c.Test), nc(c.Fault)):  # <-  # <-
    set(c.Run)
""",
        ),
        Wrong(
            """
if all(
    c.Auto,
    ds.Level > 5,
    c.Auto,  # <-
):
    rton(t.Hours, 5, Th).reset(c.Clear, c.Clear)  # <-
""",
            """
if all(
    c.Auto,
    ds.Level > 5,
    c.Auto,  # <-
):
    rton(t.Hours, 5, Th).reset(c.Clear)  # <-
""",
        ),
        Wrong(
            """
if all(c.Auto, ds.Level > 50, ds.Level > 30):  # <-
    out(y.Drain)
    if c.Auto:  # <-
        out(y.Lamp)
if any(c.Test, all(c.Auto, c.Test)):  # <-
    out(y.Horn)
"""
        ),
    ),
    right=(
        """
if all(x.Door1, x.Door2, any(c.Auto, c.Manual)):
    out(y.Motor)
if any(all(c.Auto, c.Start), all(c.Manual, c.Start)):
    set(c.Run)
""",
        """
if all(x.Door.immediate, c.Run, x.Door.immediate):
    out(y.Motor)
""",
        """
if all(ds.Level > 30, ds.Level < 50, ds.Level != 40):
    out(y.Lamp)
    if ds.Level == 35:
        out(y.Half)
""",
        """
if all(c.Run, re(c.Run)):
    set(c.Started)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
