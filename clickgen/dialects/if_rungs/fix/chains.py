"""if, elif and else as ifs that each stand alone: what must hold for an arm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeGuard

from clickgen.dialects.if_rungs.fix.opposites import opposite
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.program import Item
from clickgen.ir.proposals import Alternative, Proposal
from clickgen.ir.walk import leaves
from clickgen.logic.conditions import are_exclusive, can_hold, decided, implies, looked_at, terms_of
from clickgen.text.source import Span


class Arm(NamedTuple):
    """One arm of a chain. ``condition`` is None for a test that could not be read."""

    word: Span
    """The place of its ``if``, ``elif`` or ``else``."""
    condition: Condition | None
    items: tuple[Item, ...]


def propose(code: str, span: Span, arms: Sequence[Arm], is_branch: bool, is_read: bool) -> tuple[Proposal, Span | None]:
    """The fix that gives every elif and the else a condition of its own; not written where the language has none.

    With it comes the place of something that a later arm would have to turn round, and that has no opposite. CLICK
    looks at the conditions of branches before any action. A rung of its own looks after the actions of those before
    it. ``is_read`` is False where some of the arms could not be read, so that nobody knows what they do.
    """
    series = [arms[0].condition or Always(arms[0].word)]
    turned: dict[int, Contact | Compare] = {}
    tests = [arm.condition for arm in arms if _asks_something(arm.condition)]
    for index in range(1, len(arms)) if len(tests) == len(arms) else ():
        terms = _standing_alone(tests[index], tests[:index], turned)
        if not terms:
            break
        series.append(terms[0] if len(terms) == 1 else All(tuple(terms), terms[0].span))
    is_written = len(series) == len(arms)
    if not is_written:
        # Only what the problem says is judged: of all that comes before, a later arm means the opposite.
        turned = {id(leaf): leaf for arm in arms[:-1] if arm.condition for leaf in leaves(arm.condition)}
    alternatives = tuple(_alternative(arm, series[index] if is_written else None) for index, arm in enumerate(arms))
    proposal = Proposal(code, span, None, tuple(turned.values()), alternatives, is_written, is_branch, is_read)
    missing = None if is_written else next((leaf.span for leaf in turned.values() if opposite(leaf) is None), None)
    return proposal, missing


def _alternative(arm: Arm, alone: Condition | None) -> Alternative:
    test = arm.condition or Always(arm.word)
    return Alternative(test, alone or test, arm.items, arm.word)


# -- what must hold for an arm ----------------------------------------------------------------------------------------


def _asks_something(test: Condition | None) -> TypeGuard[Condition]:
    """False where a test never holds, or a part of it is decided by itself: nobody knows what was meant."""
    if test is None or not can_hold(test):
        return False
    return all(decided(leaf) is None for leaf in leaves(test) if isinstance(leaf, Compare))


def _standing_alone(
    own: Condition, earlier: Sequence[Condition], turned: dict[int, Contact | Compare]
) -> list[Condition] | None:
    """What must hold for an arm by itself, in series; None where the language cannot say it, or the arm never runs.

    Every contact and comparison that is turned round goes into ``turned``.
    """
    others: list[Condition] = []
    for test in earlier:
        if are_exclusive(test, own):
            continue
        other = opposite(test)
        if other is None:
            return None
        turned.update((id(leaf), leaf) for leaf in leaves(test))
        others.append(other)
    return _without_idle(terms_of(*others, own))


def _without_idle(terms: Sequence[Condition]) -> list[Condition] | None:
    """These terms in series without those that change nothing, the last kept first; None where they never all hold."""
    keys = {id(term): looked_at(term) for term in terms}
    kept: list[Condition] = []
    for term in reversed(terms):
        near = [one for one in kept if not keys[id(one)].isdisjoint(keys[id(term)])]
        if not any(implies(one, term) for one in near):
            idle = {id(one) for one in near if implies(term, one)}
            kept = [term, *(one for one in kept if id(one) not in idle)]
    if are_exclusive(*kept):
        return None
    for index, term in enumerate(kept):
        before, behind = kept[:index], kept[index + 1 :]
        near = [one for one in (*before, *behind) if not keys[id(one)].isdisjoint(keys[id(term)])]
        rest = _without_legs(term, near) if isinstance(term, Any) else term
        if rest is not term:
            return _without_idle(terms_of(*before, rest, *behind))
    return kept


def _without_legs(parallel: Any, beside: Sequence[Condition]) -> Condition:
    """A condition in parallel without the terms that never hold together with one beside it."""
    possible = tuple(term for term in parallel.terms if not any(are_exclusive(one, term) for one in beside))
    if len(possible) == len(parallel.terms):
        return parallel
    return possible[0] if len(possible) == 1 else Any(possible, parallel.span)
