"""Reasoning about conditions: can it ever hold, does it always, do two exclude each other.

What cannot be decided counts as possible: a rule may stay silent, never accuse wrongly.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from clickgen.device.banks import BANKS, INTEGER_RANGES, Kind
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell, CharCode, Hex, Immediate, Integer, Named, Range, Real, Text

_STEPS_MAX = 4000
_DEPTH_MAX = 200
"""Beyond so many steps, or alternatives inside each other, a condition counts as possible."""

Number = int | float


def can_hold(condition: Condition) -> bool:
    """False when no state of the machine makes the condition true."""
    return _Search().run([(condition, True)])


def always_holds(condition: Condition) -> bool:
    """True when every state of the machine makes the condition true."""
    return not _Search().run([(condition, False)])


def are_exclusive(*conditions: Condition) -> bool:
    """True when these conditions are never true together."""
    return not _Search().run([(condition, True) for condition in conditions])


def implies(one: Condition, other: Condition) -> bool:
    """True when ``other`` is true whenever ``one`` is."""
    return not _Search().run([(one, True), (other, False)])


Goal = tuple[Condition, bool]
"""A condition and whether it is to hold."""


class _Search:
    """Looks for a state in which every goal is met."""

    def __init__(self) -> None:
        self._steps = 0

    def run(self, goals: list[Goal], state: _State | None = None, depth: int = 0) -> bool:
        """True when there is such a state, or when looking for it takes too long."""
        state = state or _State()
        while goals:
            self._steps += 1
            if self._steps > _STEPS_MAX or depth > _DEPTH_MAX:
                return True
            (condition, wanted), goals = goals[0], goals[1:]
            if isinstance(condition, Always):
                if not wanted:
                    return False
            elif isinstance(condition, All | Any):
                if isinstance(condition, All) is wanted:
                    goals = [*((term, wanted) for term in condition.terms), *goals]
                else:
                    return any(self.run([(term, wanted), *goals], state, depth + 1) for term in condition.terms)
            elif isinstance(condition, Contact):
                bits = list(_bits(condition))
                if len(bits) > 1 and not wanted:
                    changes = (state.with_bit(key, not value) for key, value in bits)
                    return any(self.run(goals, changed, depth + 1) for changed in changes if changed)
                for key, value in bits:
                    changed = state.with_bit(key, value is wanted)
                    if changed is None:
                        return False
                    state = changed
                if condition.edge and wanted:
                    # At a rising edge the bit is on, at a falling edge off.
                    level = Contact(condition.operand, condition.span, negated=condition.edge == "fall")
                    goals = [(level, True), *goals]
            else:
                changed = state.with_comparison(condition, wanted)
                if changed is None:
                    return False
                state = changed
        return True


def _bits(contact: Contact) -> Iterator[tuple[object, bool]]:
    """The bits of a contact and the value each must have. An immediate input is not the one in the image."""
    operand = contact.operand
    target = operand.target if isinstance(operand, Immediate) else operand
    prefix = ("immediate",) if isinstance(operand, Immediate) else (contact.edge,)
    for key in target.addresses() if isinstance(target, Range) else [_key(target)]:
        yield (*prefix, key), not contact.negated


def _key(operand: Named | Cell) -> object:
    return operand.address if isinstance(operand, Cell) else (operand.bank, operand.name.lower())


# -- numbers ----------------------------------------------------------------------------------------------------------

_OPPOSITE = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
_MIRRORED = {"==": "==", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_RELATIONS = {"==": "=", "!=": "<>", "<": "<", "<=": "<=", ">": ">", ">=": ">="}
"""The ways in which two registers can stand to each other, as characters."""
_COMPARE: Mapping[str, Callable[[Number, Number], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


@dataclass(frozen=True)
class _Interval:
    """The values that a register may have: from ``low`` to ``high``, both included, but for ``holes``."""

    low: Number = -math.inf
    high: Number = math.inf
    holes: frozenset[Number] = frozenset()
    is_whole: bool = False

    def with_bound(self, op: str, value: Number) -> _Interval | None:
        """What is left when the register must compare so with a constant; None when nothing is."""
        low, high, holes = self.low, self.high, self.holes
        if op in ("==", ">="):
            low = max(low, value)
        if op in ("==", "<="):
            high = min(high, value)
        if op == ">":
            low, holes = max(low, value), holes | {value}
        if op == "<":
            high, holes = min(high, value), holes | {value}
        if op == "!=":
            holes = holes | {value}
        if self.is_whole:
            low = math.ceil(low)
            high = math.floor(high)
            while low in holes and low <= high:
                low += 1
            while high in holes and low <= high:
                high -= 1
        changed = _Interval(low, high, holes, self.is_whole)
        empty = low > high or (low == high and low in holes)
        return None if empty else changed


@dataclass(frozen=True)
class _State:
    """What is known so far: bits, the range of each register, how registers stand to each other."""

    bits: Mapping[object, bool] = field(default_factory=dict)
    numbers: Mapping[object, _Interval] = field(default_factory=dict)
    relations: Mapping[tuple[str, str], str] = field(default_factory=dict)

    def with_bit(self, key: object, value: bool) -> _State | None:
        if self.bits.get(key, value) is not value:
            return None
        return replace(self, bits={**self.bits, key: value})

    def with_comparison(self, compare: Compare, wanted: bool) -> _State | None:
        op = compare.op if wanted else _OPPOSITE[compare.op]
        left, right = compare.left, compare.right
        left_value, right_value = _constant(left), _constant(right)
        if left_value is not None and right_value is not None:
            return self if _COMPARE[op](left_value, right_value) else None
        if left_value is not None:
            left, op, right_value = right, _MIRRORED[op], left_value
        if not isinstance(left, Named | Cell):
            return self
        if right_value is not None:
            key = _key(left)
            interval = self.numbers.get(key, _domain(left.bank)).with_bound(op, right_value)
            return None if interval is None else replace(self, numbers={**self.numbers, key: interval})
        return self._related(left, op, right) if isinstance(right, Named | Cell) else self

    def _related(self, left: Named | Cell, op: str, right: Named | Cell) -> _State | None:
        one, other = str(_key(left)), str(_key(right))
        if one == other:
            return self if "=" in _RELATIONS[op] else None
        if one > other:
            one, other, op = other, one, _MIRRORED[op]
        kept = "".join(sign for sign in self.relations.get((one, other), "<=>") if sign in _RELATIONS[op])
        return replace(self, relations={**self.relations, (one, other): kept}) if kept else None


def _domain(bank: str) -> _Interval:
    kind = BANKS[bank].kind
    if kind in INTEGER_RANGES:
        return _Interval(*INTEGER_RANGES[kind], is_whole=True)
    if kind in (Kind.HEX, Kind.TEXT):
        return _Interval(0, 0xFFFF, is_whole=True)
    return _Interval()


def _constant(operand: object) -> Number | None:
    if isinstance(operand, Integer | Hex | Real | CharCode):
        return operand.value
    return ord(operand.value) if isinstance(operand, Text) and len(operand.value) == 1 else None
