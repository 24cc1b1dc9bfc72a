"""Arguments given in place of something else: values and conditions for coils, decimal commas, swapped ends."""

from __future__ import annotations

import re
from typing import NamedTuple

import libcst as cst

from clickgen.device.banks import CURRENT_VALUE_OF, Bank, Kind
from clickgen.dialects.if_rungs.read.conditions import as_condition
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    ADDRESSES,
    Node,
    arguments,
    called,
    elements,
    every,
    is_literal,
    literal,
)
from clickgen.dialects.if_rungs.trade import FORMULAS, advice
from clickgen.dialects.if_rungs.ways_out.hints import Fits, bank_of, own
from clickgen.dialects.if_rungs.ways_out.unwritable import instead, of_current_value, why_unwritable
from clickgen.instructions.effects import Shape
from clickgen.instructions.spec import Spec

_CONDITIONS = ("all", "any", "nc", "re", "fe")
_NEGATIONS = (cst.Not, cst.BitInvert)
_SUMS = (cst.Add, cst.Subtract, cst.Multiply, cst.Divide, cst.Power)
_BITS = {"true": True, "1": True, "on": True, "false": False, "0": False, "off": False}


class Misgiven(NamedTuple):
    """A problem with an argument, if there is more to say than that the instruction does not take it."""

    code: str
    node: Node
    message: str
    help: str


def misgiven(context: Context, spec: Spec, node: cst.Call, fits: Fits) -> Misgiven | None:
    """The fault in the arguments of a call, if they show what was meant; None for a call that may be right."""
    if context.is_trial or not arguments(node):
        return None
    if spec.effects.is_coil:
        return _of_coil(context, spec, node, fits)
    is_copy = spec.effects.shape in (Shape.VALUE, Shape.FILL) and all(spec.matrix)
    return _of_copy(context, spec, node, fits) if is_copy else None


# -- coils ------------------------------------------------------------------------------------------------------------


def _of_coil(context: Context, spec: Spec, node: cst.Call, fits: Fits) -> Misgiven | None:
    first, *rest = given = arguments(node)
    bank = bank_of(first)
    if bank is not None and bank.is_bit and not rest:
        return None
    shown = own(context, first)
    if not shown:
        return None
    if bank is None:
        return _of_condition(context, spec, first)
    if any(isinstance(one, cst.Slice) for one in every(first)) and not rest:
        return None
    value = own(context, rest[0]) if rest else ""
    if not bank.is_bit:
        # Rules report pointers and immediates: no coil takes one of a register.
        return _of_register(context, spec, first, bank, value, fits) if _is_plain(first) else None
    if not rest or (spec.effects.follows_power and not _is_number(rest[0])):
        return None
    if why_unwritable(first):
        action = _by_value(spec, value) or spec.name
        message = f"{shown} is {why_unwritable(first)}: no instruction writes it"
        return Misgiven("CG304", first, message, instead(context, first, action))
    other = bank_of(rest[0])
    if other is not None and other.is_bit:
        written = [f"{spec.name}({own(context, one)})" for one in given]
        if not all(map(fits, written)):
            return None
        help = f"each gets a line of its own: {' and '.join(written)}; {spec.signature}"
        return Misgiven("CG109", rest[0], f"{spec.name} takes no more than 1 address or range", help)
    if spec.effects.follows_power:
        help = f"it follows its rung: out({shown}); for one scan alone out({shown}, oneshot=True)"
        return Misgiven("CG115", rest[0], "out takes no value", help)
    action = _by_value(spec, value)
    if not action:
        return None
    what = "off" if action == "reset" else "on"
    return Misgiven("CG109", rest[0], f"{spec.name} takes no value", f"a bit is turned {what} with {action}({shown})")


def _by_value(spec: Spec, value: str) -> str:
    """``set`` or ``reset`` for a value given for a bit; "" for any other value."""
    state = _BITS.get(value.lower())
    if state is None:
        return ""
    return "set" if state and not spec.effects.turns_off else "reset"


def _is_plain(node: Node) -> bool:
    """True for an address or a range that names its cells itself: no pointer, nothing immediate."""
    if isinstance(node, cst.Attribute) and node.attr.value == "immediate":
        return False
    return not isinstance(node, cst.Subscript) or not any(
        type(inner) in ADDRESSES for element in node.slice for inner in every(element)
    )


def _is_bit(node: Node) -> bool:
    bank = bank_of(node)
    return bank is not None and bank.is_bit


def _is_number(node: Node) -> bool:
    return isinstance(node, cst.Integer | cst.Float)


def _of_register(context: Context, spec: Spec, first: Node, bank: Bank, value: str, fits: Fits) -> Misgiven | None:
    """``set(ds.A, 5)``, ``out(ds.A)``, ``reset(td.A)``: a register where a bit belongs."""
    shown = own(context, first)
    if why_unwritable(first):
        message = f"{shown} is {why_unwritable(first)}: no instruction writes it"
        default = "" if bank.name == "XD" else "0" if spec.effects.turns_off else "1"
        return Misgiven("CG304", first, message, instead(context, first, "copy", value or default))
    number = value or ("0" if spec.effects.turns_off else "1")
    message = f"{spec.name} does not take {shown} as 'address': it is for bits"
    if bank.name in CURRENT_VALUE_OF and (spec.effects.turns_off or value == "0"):
        return Misgiven("CG301", first, message, of_current_value(context, first, "0"))
    if bank.name in CURRENT_VALUE_OF:
        return Misgiven("CG301", first, message, of_current_value(context, first, number))
    if bank.kind is Kind.TEXT and not value:
        number = '" "' if spec.effects.turns_off else '"A"'
    written = f"copy({number}, {shown})"
    if not fits(written):
        written = f"copy({'0' if spec.effects.turns_off else '1'}, {shown})"
        if not fits(written):
            return None
    what = "a character" if bank.kind is Kind.TEXT else "a number"
    own_bit = "" if value else f"; to write a bit of the program, {spec.name}(c.Name)"
    return Misgiven("CG301", first, message, f"to store {what} write {written}{own_bit}")


def _of_condition(context: Context, spec: Spec, first: Node) -> Misgiven | None:
    """``out(not c.A)``, ``set(c.A == True)``, ``out(x[1] and x[2])``: a condition where an address belongs."""
    turned = _turned(first)
    if turned is not None:
        bit, is_on = turned
        shown, bank = own(context, bit), bank_of(bit)
        if bank is None or not bank.is_bit or not shown:
            return None
        message = f"{own(context, first)} is a condition, and {spec.name} takes an address"
        if why_unwritable(bit):
            condition = shown if is_on else f"nc({shown})"
            help = f"a condition belongs in the if: write if {condition}: {spec.name}(c.Name)"
            return Misgiven("CG113", first, message, help)
        if is_on:
            return Misgiven("CG113", first, message, f"write {spec.name}({shown})")
        if not spec.effects.follows_power:
            return Misgiven("CG113", first, message, f"write {'set' if spec.effects.turns_off else 'reset'}({shown})")
        help = f"CLICK has no coil that is turned round: write out({shown}) in a rung with the opposite condition"
        return Misgiven("CG113", first, message, help)
    name = called(first)
    if isinstance(first, cst.List | cst.Tuple) and first.elements and all(map(_is_bit, elements(first))):
        written = " and ".join(f"{spec.name}({own(context, one)})" for one in elements(first))
        return Misgiven("CG113", first, f"{spec.name} takes one address or range", f"write each by itself: {written}")
    if name not in _CONDITIONS and not isinstance(first, cst.BooleanOperation | cst.Comparison | cst.BinaryOperation):
        return None
    if isinstance(first, cst.BinaryOperation) and not isinstance(first.operator, cst.BitAnd | cst.BitOr):
        return None
    condition = as_condition(context, first)
    if not condition:
        return None
    help = f"a condition belongs in the if: write if {condition}: {spec.name}(c.Name)"
    if name == "re" and isinstance(first, cst.Call) and spec.effects.follows_power and len(arguments(first)) == 1:
        help = f"for one scan alone write out({own(context, arguments(first)[0])}, oneshot=True)"
    return Misgiven("CG113", first, f"{own(context, first)} is a condition, and {spec.name} takes an address", help)


def _turned(node: Node) -> tuple[Node, bool] | None:
    """A bit that is negated or compared with a constant, and whether the result equals the bit."""
    if isinstance(node, cst.UnaryOperation) and isinstance(node.operator, _NEGATIONS):
        return node.expression, False
    if isinstance(node, cst.Call) and called(node) == "nc" and len(arguments(node)) == 1:
        return arguments(node)[0], False
    if isinstance(node, cst.Comparison) and len(node.comparisons) == 1:
        operator, value = node.comparisons[0].operator, node.comparisons[0].comparator
        if not isinstance(operator, cst.Equal | cst.NotEqual | cst.Is):
            return None
        state = _BITS.get(str(literal(value)).lower()) if is_literal(value) else None
        bank = bank_of(node.left)
        if state is not None and bank is not None and bank.is_bit:
            return node.left, state is not isinstance(operator, cst.NotEqual)
    return None


# -- copies -----------------------------------------------------------------------------------------------------------


def _of_copy(context: Context, spec: Spec, node: cst.Call, fits: Fits) -> Misgiven | None:
    given = arguments(node)
    texts = [own(context, one) for one in given]
    if spec.effects.shape is Shape.VALUE and len(texts) >= 2:
        found = _of_source(context, given[0], given[1], fits)
        if found is not None:
            return found
    if len(texts) == 3 and re.fullmatch(r"[+-]?\d+", texts[0]) and re.fullmatch(r"\d+", texts[1]):
        bank = bank_of(given[2])
        is_whole = bank is not None and bank.kind is not Kind.FLOAT
        written = f"{spec.name}({texts[0]}.{texts[1]}, {'df.Name' if is_whole else texts[2]})"
        more = f"; {bank.name} takes no decimals, DF does" if bank is not None and is_whole else ""
        if fits(written):
            return Misgiven("CG109", given[1], "decimals are written with a point", f"write {written}{more}")
    if len(texts) < 2 or not _is_number(given[1]):
        return None
    swapped = f"{spec.name}({texts[1]}, {texts[0]})"
    if not fits(swapped):
        return None
    message = f"{spec.name} writes its second argument, and {texts[1]} is a constant"
    return Misgiven("CG301", given[1], message, f"the destination comes after the source: {swapped}")


def _of_source(context: Context, source: Node, target: Node, fits: Fits) -> Misgiven | None:
    """A condition, a calculation or a choice where a copy reads one value."""
    bank, shown, text = bank_of(target), own(context, target), own(context, source)
    if bank is None or not shown or not text:
        return None
    name = called(source)
    chosen = advice(name, FORMULAS)
    if isinstance(source, cst.Call) and chosen is not None and chosen.has_several:
        written = chosen.written([own(context, one) for one in arguments(source)], shown)
        return Misgiven("CG113", source, f"a copy does not work out {text}", chosen.of(written)) if written else None
    if isinstance(source, cst.BinaryOperation) and isinstance(source.operator, _SUMS):
        written = f"{'math_hex' if bank.kind is Kind.HEX else 'calc'}({text!r}, {shown})".replace("'", '"')
        is_right = '"' not in text and "**" not in text and fits(written)
        return Misgiven("CG113", source, "a copy does not calculate", f"write {written}") if is_right else None
    is_negated = isinstance(source, cst.UnaryOperation) and isinstance(source.operator, _NEGATIONS)
    if is_negated or name in _CONDITIONS or isinstance(source, cst.BooleanOperation | cst.Comparison):
        turned = _turned(source)
        condition = as_condition(context, source)
        if turned is not None and bank_of(turned[0]) is not None:
            condition = own(context, turned[0]) if turned[1] else f"nc({own(context, turned[0])})"
        action = f"out({shown})" if bank.is_bit else f"copy(1, {shown})"
        if condition and fits(action):
            help = f"a condition belongs in the if: write if {condition}: {action}"
            return Misgiven("CG113", source, f"{text} is a condition, and a copy reads a value", help)
    return None
