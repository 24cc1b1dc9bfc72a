"""Reasoning about conditions: can one ever hold, does it always, do two exclude each other.

Whatever cannot be decided counts as possible: a rule may stay silent but never accuse wrongly. Names need no address:
two names may have the same one, and a name of bits may be the name of a block. A DF register may hold no number (NaN).
No source says how CLICK compares that; this module follows IEEE 754, where only ``!=`` holds then (click-facts
[compare.nan]). So neither of two opposite comparisons need hold. A safe fix, which must not rest on this, does not ask
about floating point here.
"""

from __future__ import annotations

import math
import operator
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, lru_cache

from clickgen.device.banks import BANKS, INTEGER_RANGES, Kind
from clickgen.ir.conditions import MIRRORED, OPPOSITE, All, Always, Any, Compare, Condition, Contact, Edge
from clickgen.ir.operands import Cell, CharCode, Hex, Immediate, Integer, Named, Range, Real, Single, Text, form_of
from clickgen.ir.walk import leaves

_REGISTERS = (Named, Cell)
_NUMBERS = (Integer, Hex, Real, CharCode)

_STEPS_MAX = 4000
_DEPTH_MAX = 200
"""Beyond this many steps, or nested alternatives, a condition counts as possible."""

MANY = 64
"""With more terms than this a rule does not compare them pair by pair: no rung that a person wrote has as many."""

Number = int | float


def can_hold(condition: Condition) -> bool:
    """False if no state of the machine makes the condition true."""
    return _Search().run([(condition, True)])


def always_holds(condition: Condition) -> bool:
    """True if every state of the machine makes the condition true."""
    return not _Search().run([(condition, False)])


def are_exclusive(*conditions: Condition) -> bool:
    """True if these conditions are never true together."""
    return not _Search().run([(condition, True) for condition in conditions])


def implies(one: Condition, other: Condition) -> bool:
    """True when ``other`` is true whenever ``one`` is."""
    return not _Search().run([(one, True), (other, False)])


def terms_of(*conditions: Condition) -> tuple[Condition, ...]:
    """The single terms that must hold for all of these to hold; a series inside a series is flattened."""
    flat: list[Condition] = []
    for condition in conditions:
        if isinstance(condition, All):
            flat += terms_of(*condition.terms)
        elif not isinstance(condition, Always):
            flat.append(condition)
    return tuple(flat)


def looked_at(condition: Condition) -> set[object]:
    """The bits and registers that decide a condition; two conditions that share none are independent."""
    return {key for leaf in leaves(condition) for key in _looked_at(leaf)}


def may_meet(conditions: Iterable[Condition]) -> bool:
    """False if no two contacts or comparisons look at the same thing: then they are all independent."""
    seen: set[object] = set()
    for condition in conditions:
        for leaf in leaves(condition):
            for key in _looked_at(leaf):
                if key in seen:
                    return True
                seen.add(key)
    return False


def _looked_at(leaf: Contact | Compare) -> Iterable[object]:
    if isinstance(leaf, Contact):
        return [key for (_, key), _ in _bits(leaf)]
    return [_key(side) for side in (leaf.left, leaf.right) if isinstance(side, _REGISTERS)]


def shape(condition: Condition) -> object:
    """The meaning of a condition, wherever it is written: two of one shape have the same value at the same moment."""
    if isinstance(condition, Contact):
        if isinstance(condition.operand, Immediate):
            return condition.span
        return tuple(_bits(condition))
    if isinstance(condition, Compare):
        left, op, right = _side(condition.left), condition.op, _side(condition.right)
        # With its sides exchanged, a comparison says the same of numbers; a DF register may hold none.
        as_written = isinstance(condition.left, _REGISTERS) or form_of(condition.right) == "DF"
        return (left, op, right) if as_written else (right, MIRRORED[op], left)
    if isinstance(condition, All | Any):
        terms = tuple(map(shape, condition.terms))
        return terms[0] if len(terms) == 1 else (type(condition), terms)
    return Always


def _side(operand: Single) -> object:
    return _key(operand) if isinstance(operand, _REGISTERS) else _constant(operand)


Goal = tuple[Condition, bool]
"""A condition and whether it should hold."""


class _Search:
    """Looks for a state in which every goal is met."""

    def __init__(self) -> None:
        self._steps = 0

    def run(self, goals: list[Goal], state: _State | None = None, depth: int = 0) -> bool:
        """True if there is such a state, or if the search takes too long."""
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
                if isinstance(condition.operand, Immediate):
                    continue  # It is not the bit in the image, and may change from one look to the next.
                bits = list(_bits(condition))
                if len(bits) > 1 and not wanted:
                    changes = (state.with_bits({key: not value}) for key, value in bits)
                    return any(self.run(goals, changed, depth + 1) for changed in changes if changed)
                changed = state.with_bits({key: value is wanted for key, value in bits})
                if changed is None:
                    return False
                state = changed
                if condition.edge and wanted:
                    # At a rising edge the bit is on, at a falling edge off.
                    level = Contact(condition.operand, condition.span, negated=condition.edge is Edge.FALL)
                    goals = [(level, True), *goals]
            else:
                changed = state.with_comparison(condition, wanted)
                if changed is None:
                    return False
                state = changed
        return True


def _bits(contact: Contact) -> Iterator[tuple[tuple[Edge | None, object], bool]]:
    """Yield the bits of a contact, each with its edge, and the value each must have; none for an immediate contact."""
    if not isinstance(contact.operand, Immediate):
        for key in _bit_keys(contact.operand):
            yield (contact.edge, key), not contact.negated


def _bit_keys(operand: Named | Cell | Range) -> list[object]:
    """The bits of an operand. Two represent those of a block: all are on, or all are off, or neither."""
    if isinstance(operand, Range):
        return [*operand.addresses()]
    if isinstance(operand, Named) and not isinstance(operand.part, int):
        return [(_key(operand), "first"), (_key(operand), "last")]
    return [_key(operand)]


def _key(operand: Named | Cell) -> object:
    return operand.address if isinstance(operand, Cell) else (operand.bank, operand.name.lower(), operand.part)


# -- numbers ----------------------------------------------------------------------------------------------------------

_RELATIONS = {"==": "=", "!=": "<>?", "<": "<", "<=": "<=", ">": ">", ">=": ">="}
"""The possible relations of two registers, as characters: ``?`` if one holds no number."""
HOLDS: Mapping[str, Callable[[Number, Number], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}
"""The meaning of each comparison for two numbers."""


_SINGLE_EXACT = 2**24
"""Below it a 32-bit floating-point number can be any whole number."""
_SINGLE_MAX = (2 - 2**-23) * 2.0**127
"""The largest 32-bit floating-point number."""


def _as_compared(value: Number, is_whole: bool) -> Number | None:
    """The number with which CLICK compares a register for a constant; None if that is unknown."""
    if is_whole:
        is_known = isinstance(value, int) or abs(value) < _SINGLE_EXACT or 2**31 < abs(value) < math.inf
        return value if is_known else None
    if not abs(value) <= _SINGLE_MAX:
        return None
    single: float = struct.unpack("<f", struct.pack("<f", value))[0]
    return single if single == value or abs(value) < _SINGLE_EXACT else None


@dataclass(frozen=True)
class _Interval:
    """The values that a register may have: from ``low`` to ``high``, both included, except ``holes``.

    With ``may_be_nan`` it may also hold no number; then there need be no values.
    """

    low: Number = -math.inf
    high: Number = math.inf
    holes: frozenset[Number] = frozenset()
    is_whole: bool = False
    may_be_nan: bool = False

    def with_bound(self, op: str, constant: Number, wanted: bool = True) -> _Interval | None:
        """Return what is left if the comparison with a constant must hold, or must not; None if nothing is."""
        value = _as_compared(constant, self.is_whole)
        if value is None:
            return self
        may_be_nan = self.may_be_nan and (op == "!=") is wanted
        op = op if wanted else OPPOSITE[op]
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
        changed = _Interval(low, high, holes, self.is_whole, may_be_nan)
        empty = low > high or (low == high and low in holes)
        return None if empty and not may_be_nan else changed


@dataclass(frozen=True)
class _State:
    """The known facts: bits, the range of each register, how registers compare with each other."""

    bits: Mapping[object, bool] = field(default_factory=dict)
    numbers: Mapping[object, _Interval] = field(default_factory=dict)
    relations: Mapping[tuple[str, str], str] = field(default_factory=dict)

    def with_bits(self, bits: Mapping[object, bool]) -> _State | None:
        if any(self.bits.get(key, value) is not value for key, value in bits.items()):
            return None
        return _State({**self.bits, **bits}, self.numbers, self.relations)

    def with_comparison(self, compare: Compare, wanted: bool) -> _State | None:
        op, left, right = compare.op, compare.left, compare.right
        left_value, right_value = _constant(left), _constant(right)
        if left_value is not None and right_value is not None:
            return self if HOLDS[op](left_value, right_value) is wanted else None
        if left_value is not None:
            left, op, right_value = right, MIRRORED[op], left_value
        if not isinstance(left, _REGISTERS):
            return self
        if right_value is not None:
            key = _key(left)
            interval = self.numbers.get(key, _domain(left.bank)).with_bound(op, right_value, wanted)
            return None if interval is None else _State(self.bits, {**self.numbers, key: interval}, self.relations)
        return self._related(left, op, right, wanted) if isinstance(right, _REGISTERS) else self

    def _related(self, left: Named | Cell, op: str, right: Named | Cell, wanted: bool) -> _State | None:
        one, other = str(_key(left)), str(_key(right))
        if one == other:
            # Nobody knows how CLICK compares a floating-point register that holds no number with itself.
            return self if ("=" in _RELATIONS[op]) is wanted or left.bank == "DF" else None
        if one > other:
            one, other, op = other, one, MIRRORED[op]
        known = self.relations.get((one, other), "<=>?" if "DF" in (left.bank, right.bank) else "<=>")
        kept = "".join(sign for sign in known if (sign in _RELATIONS[op]) is wanted)
        return _State(self.bits, self.numbers, {**self.relations, (one, other): kept}) if kept else None


def decided(compare: Compare) -> bool | None:
    """The result of a comparison whatever its register holds; None if that depends on the register."""
    left, op, right = compare.left, compare.op, compare.right
    if not isinstance(left, _REGISTERS):
        left, op, right = right, MIRRORED[op], left
    value = _constant(right)
    if value is not None and isinstance(left, _REGISTERS):
        return _decided(left.bank, op, value)
    if not can_hold(compare):
        return False
    return True if always_holds(compare) else None


@lru_cache(maxsize=None, typed=True)
def _decided(bank: str, op: str, value: Number) -> bool | None:
    if _domain(bank).with_bound(op, value) is None:
        return False
    return True if _domain(bank).with_bound(op, value, wanted=False) is None else None


@cache
def _domain(bank: str) -> _Interval:
    kind = BANKS[bank].kind
    if kind in INTEGER_RANGES:
        return _Interval(*INTEGER_RANGES[kind], is_whole=True)
    if kind in (Kind.HEX, Kind.TEXT):
        return _Interval(0, 0xFFFF, is_whole=True)
    return _Interval(may_be_nan=True)


def value_of(compare: Compare) -> str:
    """The reason why a comparison by itself is decided, for a message: the values that its register can hold."""
    if _constant(compare.left) is None and _constant(compare.right) is None:
        return "it is compared with itself"
    register = compare.left if isinstance(compare.left, Named | Cell) else compare.right
    kind = BANKS[form_of(register)].kind
    if kind in INTEGER_RANGES:
        low, high = INTEGER_RANGES[kind]
        return f"the register holds whole numbers from {low} to {high}"
    return "the register holds 0000h to FFFFh" if kind is Kind.HEX else "the register holds one character"


def _constant(operand: object) -> Number | None:
    if isinstance(operand, _NUMBERS):
        return operand.value
    return ord(operand.value) if isinstance(operand, Text) and len(operand.value) == 1 else None
