"""if, elif and else as ifs that each stand alone: what must hold for an arm, and the edits that write it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple, TypeGuard

import libcst as cst

from clickgen.dialects.if_rungs.fix.opposites import opposite
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.write.expressions import EDGE_FUNCTIONS
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.program import Item
from clickgen.ir.proposals import Alternative, Proposal
from clickgen.ir.walk import condition_operands, leaves
from clickgen.logic.conditions import are_exclusive, can_hold, decided, implies, looked_at, terms_of
from clickgen.text.edits import Edit
from clickgen.text.source import Span


class Arm(NamedTuple):
    """One arm of a chain. ``test`` is None for an else, ``condition`` for a test that could not be read."""

    word: Span
    """Where its ``if``, ``elif`` or ``else`` stands."""
    test: cst.BaseExpression | None
    condition: Condition | None
    items: tuple[Item, ...]


def propose(
    context: Context, code: str, span: Span, arms: Sequence[Arm], is_branch: bool, is_read: bool
) -> tuple[Proposal, Span | None]:
    """The fix that gives every elif and the else a condition of its own; without edits where that cannot be written.

    With it comes the place of something that a later arm would have to turn round, and that has no opposite. CLICK
    looks at the conditions of branches before any action. A rung of its own looks after the actions of those before
    it. ``is_read`` is False where some of the arms could not be read, so that nobody knows what they do.
    """
    series = [arms[0].condition or Always(arms[0].word)]
    edits: list[Edit] = []
    turned: dict[int, Contact | Compare] = {}
    tests = [arm.condition for arm in arms if _asks_something(arm.condition)]
    for index, arm in enumerate(arms[1:], 1) if len(tests) == len(arms) else ():
        terms = _standing_alone(tests[index], tests[:index], turned)
        own = _edits(context, arm, tests[index], terms) if terms else None
        if not terms or own is None:
            break
        edits += own
        series.append(terms[0] if len(terms) == 1 else All(tuple(terms), terms[0].span))
    is_written = len(series) == len(arms)
    if not is_written:
        # Only what the problem says is judged: of all that comes before, a later arm means the opposite.
        edits = []
        turned = {id(leaf): leaf for arm in arms[:-1] if arm.condition for leaf in leaves(arm.condition)}
    proposal = Proposal(
        code,
        span,
        tuple(edits),
        "",
        tuple(turned.values()),
        tuple(_alternative(arm, series[index] if is_written else None) for index, arm in enumerate(arms)),
        is_branch,
        is_read,
    )
    missing = None if is_written else next((leaf.span for leaf in turned.values() if opposite(leaf) is None), None)
    return proposal, missing


def _alternative(arm: Arm, alone: Condition | None) -> Alternative:
    test = arm.condition or Always(arm.word)
    return Alternative(test, alone or test, arm.items)


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


# -- how it is written ------------------------------------------------------------------------------------------------


def _edits(context: Context, arm: Arm, test: Condition, terms: list[Condition]) -> list[Edit] | None:
    """The edits that make an elif or an else an if of these terms; what it asks itself is left as it is written."""
    if arm.test is None:
        text = _written(context, terms)
        return None if text is None else [Edit(arm.word, f"if {text}")]
    own = [*terms_of(test)]
    if not own or terms[-len(own) :] != own:
        text = None if "#" in context.text(arm.test) else _written(context, terms)
        return None if text is None else [Edit(arm.word, "if"), Edit(context.span(arm.test), text)]
    return _before_own(context, arm.word, arm.test, terms[: -len(own)])


def _before_own(context: Context, word: Span, test: cst.BaseExpression, terms: list[Condition]) -> list[Edit] | None:
    """Terms put in series in front of what an elif asks."""
    texts = [_text(context, term) for term in terms]
    if None in texts:
        return None
    shown = ", ".join(text for text in texts if text)
    if not shown:
        return [Edit(word, "if")]
    span, text = context.span(test), context.text(test)
    series = re.match(r"all[^\S\n]*\(([^\S\n]*)", text)
    if series:
        place = span._replace(col=span.col + series.end(), end_line=span.line, end_col=span.col + series.end())
        broken = re.match(r"\n\s*", text[series.end() :])
        return [Edit(word, "if"), Edit(place, f"{shown}," + ("" if broken else series[1] or " "))]
    end = _end_of_head(context, span)
    return None if end is None else [Edit(word, f"if all({shown},"), Edit(end, ")")]


def _end_of_head(context: Context, test: Span) -> Span | None:
    """The place behind a test and the parentheses around it."""
    line, col = test.end_line, test.end_col
    place = Span(test.path, line, col, line, col)
    while line <= len(context.source.lines):
        code = context.source.line(line)[col - 1 :]
        for offset, character in enumerate(code):
            if character == ":":
                return place
            if character == "#":
                break
            if character == ")":
                place = Span(test.path, line, col + offset + 1, line, col + offset + 1)
        line, col = line + 1, 1
    return None


def _written(context: Context, terms: list[Condition]) -> str | None:
    return _text(context, terms[0] if len(terms) == 1 else All(tuple(terms), terms[0].span))


def _text(context: Context, condition: Condition) -> str | None:
    """A condition on one line, every address and constant as the person wrote it; None where one is on several."""
    operands = list(condition_operands(condition))
    if any(operand.span.line != operand.span.end_line for operand in operands):
        return None
    if isinstance(condition, All | Any):
        texts = [_text(context, term) for term in condition.terms]
        if None in texts:
            return None
        name = "all" if isinstance(condition, All) else "any"
        return f"{name}({', '.join(text for text in texts if text)})"
    line = context.source.line
    shown = [line(span.line)[span.col - 1 : span.end_col - 1] for span in (operand.span for operand in operands)]
    if isinstance(condition, Compare):
        if condition.left.span != condition.right.span:
            return f"{shown[0]} {condition.op} {shown[1]}"
        # A register alone is compared with a 0 that stands nowhere.
        return shown[0] if condition.op == "!=" else f"{shown[0]} {condition.op} 0"
    assert isinstance(condition, Contact)
    edge = EDGE_FUNCTIONS[condition.edge] if condition.edge else None
    word = "nc" if condition.negated else edge
    return f"{word}({shown[0]})" if word else shown[0]
