"""if, elif and else as ifs that each stand alone: what must hold for an arm, and whether that is the same program."""

from __future__ import annotations

import ast
import math
import operator
import re
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from clickgen.device.banks import BANKS, TWIN_BANKS, VALUE_BANK, Kind
from clickgen.diagnostics import Edit, Fix
from clickgen.instructions import communication, copies, maths
from clickgen.instructions.coils import RESET, SET
from clickgen.instructions.control import CALL, END, FOR, NEXT, NOP, RETURN
from clickgen.instructions.spec import Access
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.operands import (
    Cell,
    CharCode,
    Hex,
    Immediate,
    Integer,
    Named,
    Operand,
    Range,
    Real,
    Text,
    form_of,
)
from clickgen.ir.program import Action, Branch, Item, Loop, actions_in
from clickgen.ir.reach import length_of, touches
from clickgen.ir.walk import condition_operands, leaves
from clickgen.source import Span
from clickgen.syntax.context import Context
from clickgen.syntax.rewrite import names_block


class Arm(NamedTuple):
    """One arm of a chain. ``test`` is None for an else, ``condition`` for a test that could not be read."""

    word: Span
    """Where its ``if``, ``elif`` or ``else`` stands."""
    test: ast.expr | None
    condition: Condition | None
    items: tuple[Item, ...]


def as_ifs(context: Context, arms: Sequence[Arm], is_branch: bool, is_known: bool) -> Fix | None:
    """The fix that gives every elif and the else a condition of its own; None where that cannot be written.

    CLICK looks at the conditions of branches before any action. A rung of its own looks after the actions of those
    before it. ``is_known`` is False where some of the arms could not be read, so that nobody knows what they do.
    """
    edits: list[Edit] = []
    series: list[list[Condition]] = []
    for index, arm in enumerate(arms[1:], 1):
        terms = _standing_alone(context, arm, [before.condition for before in arms[:index]])
        own = None if terms is None else _edits(context, arm, terms)
        if terms is None or own is None:
            return None
        edits += own
        series.append(terms)
    is_safe = is_known and not _is_undone(context, arms) and (is_branch or _may_look_again(context, arms, series))
    return Fix(tuple(edits), is_safe)


def without_opposite(context: Context, arms: Sequence[Arm]) -> Span | None:
    """Where something stands that a later arm would have to turn round, and that has no opposite."""
    for arm in arms[:-1]:
        for leaf in leaves(arm.condition) if arm.condition else ():
            if _opposite(context, leaf) is None:
                return leaf.span
    return None


# -- what must hold for an arm ----------------------------------------------------------------------------------------

_OPPOSITE = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}


def _standing_alone(context: Context, arm: Arm, earlier: Sequence[Condition | None]) -> list[Condition] | None:
    """What must hold for an arm by itself, in series; None where nobody knows, or it never runs."""
    if arm.condition is None:
        return None
    others: list[Condition] = []
    for condition in earlier:
        if condition is None:
            return None
        if _exclude(condition, arm.condition):
            continue
        other = _opposite(context, condition)
        if other is None:
            return None
        others += _series(other)
    return _without_idle(others, _series(arm.condition)) or None


def _edits(context: Context, arm: Arm, terms: list[Condition]) -> list[Edit] | None:
    """The edits that make an elif or an else an if of these terms; what it asks itself is left as it is written."""
    if arm.test is None or arm.condition is None:
        text = _written(context, terms)
        return None if text is None else [Edit(arm.word, f"if {text}")]
    own = _series(arm.condition)
    if not own or terms[-len(own) :] != own:
        text = None if "#" in context.text(arm.test) else _written(context, terms)
        return None if text is None else [Edit(arm.word, "if"), Edit(context.span(arm.test), text)]
    return _before_own(context, arm.word, arm.test, terms[: -len(own)])


def _before_own(context: Context, word: Span, test: ast.expr, terms: list[Condition]) -> list[Edit] | None:
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


def _series(condition: Condition) -> list[Condition]:
    """What must hold for it to hold, one by one."""
    if isinstance(condition, All):
        return [flat for term in condition.terms for flat in _series(term)]
    return [] if isinstance(condition, Always) else [condition]


def _opposite(context: Context, condition: Condition) -> Condition | None:
    """The opposite, where the language has a word for it; an immediate contact may differ when it is read again."""
    if isinstance(condition, All | Any):
        terms = [_opposite(context, term) for term in condition.terms]
        kept = tuple(term for term in terms if term is not None)
        if len(kept) < len(terms):
            return None
        return Any(kept, condition.span) if isinstance(condition, All) else All(kept, condition.span)
    if isinstance(condition, Compare):
        return Compare(_OPPOSITE[condition.op], condition.left, condition.right, condition.span)
    bit = condition.operand if isinstance(condition, Contact) and not condition.edge else None
    if isinstance(bit, Cell) or (isinstance(bit, Named) and (type(bit.part) is int or not _is_block(context, bit))):
        return Contact(bit, condition.span, isinstance(condition, Contact) and not condition.negated)
    return None


def _is_block(context: Context, named: Named) -> bool:
    """True for a block and what is in it, as far as this file says so."""
    return named.part is not None or names_block(context, named.bank, named.name)


def _without_idle(others: list[Condition], own: list[Condition]) -> list[Condition] | None:
    """These terms in series without those that change nothing; None where they never hold together."""
    kept: list[Condition] = []
    for term in (*reversed(own), *reversed(others)):
        if not any(term is not one and _implies(one, term) for one in kept):
            kept = [one for one in kept if not _implies(term, one)]
            kept.insert(0, term)
    for index, term in enumerate(kept):
        beside = [one for one in kept if one is not term]
        if any(_exclude(one, term) for one in beside):
            return None
        if isinstance(term, Any):
            legs = tuple(leg for leg in term.terms if not any(_exclude(one, leg) for one in beside))
            if not legs:
                return None
            if len(legs) < len(term.terms):
                rest = _series(legs[0] if len(legs) == 1 else Any(legs, term.span))
                return _without_idle([], [*kept[:index], *rest, *kept[index + 1 :]])
    return kept


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
    word = "nc" if condition.negated else {"rise": "re", "fall": "fe"}.get(condition.edge)
    return f"{word}({shown[0]})" if word else shown[0]


# -- what follows from what -------------------------------------------------------------------------------------------

_MIRRORED = {"==": "==", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_HOLDS: Mapping[str, Callable[[float, float], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}
_EXACT_MAX = 2**24
"""Below it a 32-bit floating-point number holds every whole number."""


def _implies(one: Condition, other: Condition) -> bool:
    """True when ``other`` surely holds whenever ``one`` does."""
    if isinstance(one, Any):
        return all(_implies(term, other) for term in one.terms)
    if isinstance(other, All):
        return all(_implies(one, term) for term in other.terms)
    if isinstance(one, All):
        return any(_implies(term, other) for term in one.terms)
    if isinstance(other, Any):
        return any(_implies(one, term) for term in other.terms)
    if isinstance(one, Contact) and isinstance(other, Contact):
        is_same = (one.edge, one.negated) == (other.edge, other.negated)
        return is_same and bool(_bits(other)) and _bits(other) <= _bits(one)
    if isinstance(one, Compare) and isinstance(other, Compare):
        both = _answers(one, other)
        return bool(both) and all(second for first, second in both if first)
    return False


def _exclude(one: Condition, other: Condition) -> bool:
    """True when the two surely never hold together."""
    for group, beside in ((one, other), (other, one)):
        if isinstance(group, Any):
            return all(_exclude(term, beside) for term in group.terms)
    for group, beside in ((one, other), (other, one)):
        if isinstance(group, All):
            return any(_exclude(term, beside) for term in group.terms)
    if isinstance(one, Contact) and isinstance(other, Contact):
        is_level = not one.edge and not other.edge
        return is_level and one.negated is not other.negated and not _bits(one).isdisjoint(_bits(other))
    if isinstance(one, Compare) and isinstance(other, Compare):
        both = _answers(one, other)
        return bool(both) and not any(first and second for first, second in both)
    return False


def _bits(contact: Contact) -> set[object]:
    """The bits of a contact; none of an immediate one, which says nothing of another look."""
    operand = contact.operand
    if isinstance(operand, Immediate):
        return set()
    return set(operand.addresses()) if isinstance(operand, Range) else {_key(operand)}


def _key(operand: Named | Cell) -> object:
    return operand.address if isinstance(operand, Cell) else (operand.bank, operand.name.lower(), operand.part)


class _Question(NamedTuple):
    """A comparison of something with a number. Of two registers the number 0 says that they are equal."""

    subject: object
    op: str
    value: float
    is_whole: bool


def _answers(one: Compare, other: Compare) -> list[tuple[bool, bool]]:
    """What both are for every value that makes a difference; nothing where they ask about different things."""
    first, second = _question(one), _question(other)
    if first is None or second is None or first.subject != second.subject:
        return []
    if first.is_whole:
        near = [math.floor(value) + step for value in (first.value, second.value) for step in (-1.0, 0.0, 1.0, 2.0)]
    else:
        low, high = sorted((first.value, second.value))
        near = [low - 1, low, (low + high) / 2, high, high + 1]
    return [(_HOLDS[first.op](value, first.value), _HOLDS[second.op](value, second.value)) for value in near]


def _question(compare: Compare) -> _Question | None:
    left, op, right = compare.left, compare.op, compare.right
    if not isinstance(left, Named | Cell):
        left, op, right = right, _MIRRORED[op], left
    if not isinstance(left, Named | Cell):
        return None
    if isinstance(right, Named | Cell):
        one, another = _key(left), _key(right)
        is_swapped = str(one) > str(another)
        pair = (another, one) if is_swapped else (one, another)
        return _Question(pair, _MIRRORED[op] if is_swapped else op, 0, True)
    value = _number(right)
    is_whole = BANKS[left.bank].kind is not Kind.FLOAT
    is_exact = value is not None and (abs(value) < _EXACT_MAX or (is_whole and isinstance(right, Integer | Hex)))
    if value is None or not is_exact:
        return None
    if not is_whole:
        value = struct.unpack("<f", struct.pack("<f", value))[0]
    return _Question(_key(left), op, value, is_whole)


def _number(operand: Operand) -> float | None:
    if isinstance(operand, Integer | Hex | Real | CharCode):
        return operand.value
    return ord(operand.value) if isinstance(operand, Text) and len(operand.value) == 1 else None


# -- whether that is the same program ---------------------------------------------------------------------------------

_VOLATILE = ("T", "TD", "SC", "SD")
"""Banks that may change between two rungs although no instruction there writes them."""
_UNKNOWN = (CALL, FOR, NEXT, END, RETURN)
"""What runs behind these, or not, is not what stands behind them."""
_QUIET = (SET, RESET, NOP, CALL, NEXT, END, RETURN, *copies.SPECS, *maths.SPECS)
"""Instructions that change nothing while their condition does not hold."""
_MESSAGES = re.compile(rf"\b({'|'.join(spec.name for spec in communication.SPECS)})\s*\(")

_Place = tuple[str, object]
"""A bank, and a number or a name in it; None for all of the bank."""


def _is_undone(context: Context, arms: Sequence[Arm]) -> bool:
    """True when an arm that does not run may undo what an earlier one did: out turns its bit off then."""
    for earlier, later in _pairs(arms):
        after = _places_written(context, (action for action in actions_in(later.items) if action.spec not in _QUIET))
        is_open = any(action.spec in (CALL, FOR) for action in actions_in(earlier.items))
        if after and (is_open or _meet(_places_written(context, actions_in(earlier.items)), after)):
            return True
    return False


def _pairs(arms: Sequence[Arm]) -> Iterator[tuple[Arm, Arm]]:
    return ((earlier, later) for index, later in enumerate(arms) for earlier in arms[:index])


def _may_look_again(context: Context, arms: Sequence[Arm], series: Sequence[list[Condition]]) -> bool:
    """True when what each later arm asks is the same before and behind the actions of the arms in front of it."""
    # What other devices send arrives in its own time.
    if _MESSAGES.search(context.source.text):
        return False
    written: set[_Place] = set()
    for earlier, later, terms in zip(arms, arms[1:], series, strict=False):
        if any(action.spec in _UNKNOWN for action in actions_in(earlier.items)) or not all(map(_is_steady, terms)):
            return False
        written |= _places_written(context, actions_in(earlier.items))
        operands = [operand for term in terms for operand in condition_operands(term)]
        looked_at = {place for operand in (*operands, *_looked_at(later.items)) for place in _places(context, operand)}
        if _meet(written, looked_at):
            return False
    return True


def _is_steady(condition: Condition) -> bool:
    """True when nothing but an instruction changes it in the middle of a scan."""
    operands = list(condition_operands(condition))
    has_edge = any(getattr(leaf, "edge", "") for leaf in leaves(condition))
    is_immediate = any(isinstance(operand, Immediate) for operand in operands)
    return not has_edge and not is_immediate and not any(form_of(operand) in _VOLATILE for operand in operands)


def _looked_at(items: Iterable[Item]) -> Iterator[Operand]:
    """What the conditions of branches and pins look at."""
    for item in items:
        if isinstance(item, Branch):
            yield from condition_operands(item.condition)
            yield from _looked_at(item.items)
        elif not isinstance(item, Loop):
            for param in item.spec.pins:
                condition = item.pin(param.name)
                if condition is not None:
                    yield from condition_operands(condition)


def _places_written(context: Context, actions: Iterable[Action]) -> set[_Place]:
    places: set[_Place] = set()
    for action in actions:
        for touch in touches(action):
            if touch.is_written:
                places |= _places(context, touch.operand, length_of(action, touch.param) > 1)
            if touch.param.slot.access is Access.OWN and isinstance(touch.operand, Named | Cell):
                bank = touch.operand.bank
                places |= {(bank, None), (VALUE_BANK.get(bank, bank), None)}
    return places


def _places(context: Context, operand: Operand, is_long: bool = False) -> set[_Place]:
    """What an operand may be; names have no number yet."""
    if isinstance(operand, Immediate):
        return _places(context, operand.target)
    if isinstance(operand, Range):
        return {(address.bank, address.number) for address in operand.addresses()}
    if isinstance(operand, Cell):
        return {(operand.bank, operand.address.number)}
    if isinstance(operand, Named) and not is_long and not _is_block(context, operand):
        return {(operand.bank, operand.name.lower())}
    return {(form_of(operand), None)} if form_of(operand) in BANKS else set()


def _meet(one: set[_Place], other: set[_Place]) -> bool:
    """True when two sets of places may have one in common: any name of a bank may be any number of it."""
    banks = {bank for bank, _ in one} | {TWIN_BANKS.get(bank, bank) for bank, _ in one}
    for bank in banks & {bank for bank, _ in other}:
        here = {key for name, key in one if name == bank}
        there = {key for name, key in other if name == bank}
        if not here or None in here | there or not here.isdisjoint(there):
            return True
        if len({type(key) for key in here | there}) > 1:
            return True
    return False
