"""Addresses, ranges, pointers and constants out of expressions."""

from __future__ import annotations

import re

import libcst as cst

from clickgen.device.banks import BANKS
from clickgen.dialects.if_rungs.read.context import Context, Located
from clickgen.dialects.if_rungs.read.nodes import (
    ADDRESSES,
    NO_LITERAL,
    Node,
    called,
    elements,
    index_of,
    is_literal,
    literal,
    name_of,
    text_value,
    values,
    whole_number,
    word,
)
from clickgen.dialects.if_rungs.read.options import MODIFIERS, modifier_hint
from clickgen.dialects.if_rungs.trade import CONDITIONS, advice
from clickgen.dialects.if_rungs.ways_out.hints import (
    bit_of_word,
    has_bits,
    member_hint,
    name_hint,
    own,
    own_advice,
    text_hint,
)
from clickgen.formula.spelling import SPELL
from clickgen.ir.addresses import BANK_NAMES, NO_NUMBER, Addressed, AddressReader, Bounds, Fault, Index, Odd, Part
from clickgen.ir.operands import (
    Cell,
    CharCode,
    Constant,
    Hex,
    Immediate,
    Integer,
    Named,
    Operand,
    Range,
    Real,
    Text,
)
from clickgen.problems.diagnostics import did_you_mean
from clickgen.text.edits import Edit, Fix
from clickgen.text.wording import shorten

_CHAR_CODE = re.compile(r"\$[0-9A-Fa-f]{2}")
_ADDRESSES = (cst.Attribute, cst.Subscript)
ADDRESSES_READ = AddressReader(SPELL)
_ADDRESS_FORMS = ADDRESSES_READ.forms


def looks_like_address(node: Node) -> bool:
    """True for ``bank.name``, ``bank[...]`` and the same with ``.immediate``."""
    return node.__class__ in ADDRESSES


def read_operand(context: Context, node: Node, signature: str = "") -> Operand | None:
    """An address in any form or a constant; None with a problem, which shows the signature that it belongs to."""
    if node.__class__ in ADDRESSES:
        return read_address(context, node)
    return read_constant(context, node, signature)


def read_constant(context: Context, node: Node, signature: str = "") -> Constant | None:
    """A number or a string; a leading minus belongs to the number."""
    value = literal(node)
    if value is not NO_LITERAL:
        span = context.span(node)
        if isinstance(value, int) and not isinstance(value, bool):
            is_hex = context.text(node)[:2].lower() == "0x"
            return Hex(value, span) if is_hex else Integer(value, span)
        if isinstance(value, float):
            return Real(value, context.text(node), span)
        if isinstance(value, str):
            if _CHAR_CODE.fullmatch(value):
                return CharCode(int(value[1:], 16), span)
            return Text(value, span, context.embedded(node))
    if isinstance(node, cst.UnaryOperation) and isinstance(node.operator, cst.Minus | cst.Plus):
        inner = read_constant(context, node.expression) if is_literal(node.expression) else None
        sign = -1 if isinstance(node.operator, cst.Minus) else 1
        if isinstance(inner, Integer):
            return Integer(sign * inner.value, context.span(node))
        if isinstance(inner, Real):
            return Real(sign * inner.value, ("-" if sign < 0 else "") + inner.text, context.span(node))
    hint = address_hint(node) or modifier_hint(node) or _calculated(context, node) or _ADDRESS_FORMS
    help = f"{hint}: {signature}" if signature else hint
    context.problem("CG113", node, f"{shorten(context.text(node))} is not an address or a constant", help)
    return None


def address_hint(node: Node) -> str:
    """How the language writes what looks like an address of CLICK's: ``C1``, ``ds5``, ``"X001"``, ``X(1)``."""
    text = text_value(node)
    if text is not None:
        return text_hint(text)
    if isinstance(node, cst.Call) and called(node).lower() in BANK_NAMES:
        bank, given = BANK_NAMES[called(node).lower()], values(node)
        number = _whole_number(given[0]) if len(given) == 1 else None
        shown = number if number is not None and bank.has(number) else bank.first
        return f"an address has square brackets: {bank.dsl}[{shown}]"
    name = name_of(node)
    if name.lower() in BANK_NAMES:
        return f"{name} is a whole bank: {_ADDRESS_FORMS}"
    return name_hint(name)


def _calculated(context: Context, node: Node) -> str:
    """The way out for a calculation, or another word, in the place of a value; "" for anything else."""
    if called(node):
        return own_advice(context, advice(called(node), CONDITIONS), (), lambda _: False)
    if (
        isinstance(node, cst.BinaryOperation)
        and isinstance(node.operator, cst.Add | cst.Subtract | cst.Multiply | cst.Divide)
        and not has_bits(node)
    ):
        text = own(context, node)
        if text and "'" not in text:
            quote = "'" if '"' in text else '"'
            return f"calculate it first, calc({quote}{text}{quote}, ds.Result), and use ds.Result"
    if isinstance(literal(node), bool):
        return "a bit is turned on with set(c.Name), off with reset(c.Name); a number is 1 or 0"
    if isinstance(node, cst.List | cst.Tuple) and node.elements:
        first = own(context, elements(node)[0])
        return f"addresses are given one by one, each with a line of its own, or as a range: {first}"
    if name_of(node):
        return f"a nickname follows its bank: c.{name_of(node)} for a bit, ds.{name_of(node)} for a number"
    return ""


def read_address(context: Context, node: Node) -> Addressed | None:
    """``bank.name``, ``bank[number]``, ``bank["name"]``, ``bank[a:b]``, ``bank[ds.Pointer]``, with ``.immediate``."""
    assert isinstance(node, _ADDRESSES)
    holder = node.value
    name = name_of(holder)
    if not name:
        if isinstance(node, cst.Attribute):
            return _read_modifier(context, node)
        if isinstance(holder, _ADDRESSES):
            return _read_part(context, holder, node)
        context.problem("CG113", node, f"{shorten(context.text(node))} is not an address", _ADDRESS_FORMS)
        return None
    bank = BANK_NAMES.get(name)
    if bank is None:
        inside = index_of(node) if isinstance(node, cst.Subscript) else None
        number = _whole_number(inside) if inside is not None else None
        fault = ADDRESSES_READ.bank(name, number, lambda: own(context, node))
        assert isinstance(fault, Fault)
        _refuse(context, fault, node, holder)
        return None
    if isinstance(node, cst.Attribute):
        return Named(bank.name, word(node.attr), context.span(node))
    index = _index(context, index_of(node))
    if index is None:
        return None
    found = ADDRESSES_READ.indexed(bank, index, context.span(node), lambda: own(context, node))
    if isinstance(found, Fault):
        _refuse(context, found, node, holder)
        return None
    return found


def _refuse(context: Context, fault: Fault, node: cst.Attribute | cst.Subscript, holder: Node) -> None:
    """Report what is wrong with an address, at the part that it is about."""
    part: Located = node
    if fault.part is Part.BANK:
        part = holder
    elif fault.part is Part.INDEX and isinstance(node, cst.Subscript):
        part = index_of(node)
    fix = Fix((Edit(context.span(holder), fault.bank),)) if fault.bank else None
    context.problem(fault.code, part, fault.message, fault.help, fix)


def _index(context: Context, inside: Located) -> Index | None:
    """What is between the brackets; None for an address whose problem was reported."""
    number = _whole_number(inside)
    if number is not None:
        return number
    if inside.__class__ in ADDRESSES:
        assert isinstance(inside, cst.CSTNode)
        return read_address(context, inside)
    if isinstance(inside, cst.Slice):
        bounds = (inside.lower, inside.upper, inside.step)
        return Bounds(*(None if bound is None else _bound(bound) for bound in bounds))
    text = text_value(inside)
    return text if text is not None else _odd(inside)


def _bound(node: Node) -> int | Odd:
    number = _whole_number(node)
    return NO_NUMBER if number is None else number


def _odd(inside: Located) -> Odd:
    """Something in brackets that says no number."""
    if isinstance(inside, cst.BinaryOperation):
        first, last = _whole_number(inside.left), _whole_number(inside.right)
        if isinstance(inside.operator, cst.Subtract) and first is not None and last is not None:
            return Odd(difference=(first, last), is_calculated=True)
    is_list = not isinstance(inside, cst.CSTNode)
    return Odd(name_of(inside), None, isinstance(inside, cst.BinaryOperation | cst.Call), is_list)


def _read_modifier(context: Context, node: cst.Attribute) -> Immediate | None:
    attr = word(node.attr)
    if attr != "immediate":
        hint = f"write .{attr}()" if attr in MODIFIERS else ""
        fix: Fix | None = None
        if not hint:
            hint, fix = _member(context, node)
        hint = hint or did_you_mean(attr, ["immediate", *MODIFIERS])
        context.problem("CG113", node, f"an address has no .{attr}", hint or _ADDRESS_FORMS, fix)
        return None
    if node.value.__class__ not in ADDRESSES:
        context.problem("CG113", node, ".immediate belongs behind an address", "x[1].immediate")
        return None
    target = read_address(context, node.value)
    if target is None:
        return None
    if not isinstance(target, Named | Cell | Range):
        context.problem("CG308", node, ".immediate belongs behind an X or Y address", "x[1].immediate")
        return None
    return Immediate(target, context.span(node))


def _member(context: Context, node: cst.Attribute) -> tuple[str, Fix | None]:
    """The way out for what is written behind an address with a dot."""
    base = node.value
    while isinstance(base, cst.Attribute | cst.Subscript):
        base = base.value
    bank = BANK_NAMES.get(name_of(base))
    text = own(context, node.value)
    return member_hint(context, node, bank, text.removeprefix(bank.dsl)) if bank and text else ("", None)


def _read_part(context: Context, holder: Node, node: cst.Subscript) -> Named | None:
    """``ds.Recipe[3]`` and ``ds.Recipe[0:10]``: members of a block."""
    block = read_address(context, holder)
    if block is None:
        return None
    if not isinstance(block, Named) or block.part is not None:
        help = _ADDRESS_FORMS
        if isinstance(block, Cell) and not BANKS[block.bank].is_bit:
            help = bit_of_word(context.text(holder), BANKS[block.bank], _whole_number(index_of(node)))
        context.problem("CG113", node, f"{shorten(context.text(node))} is not an address", help)
        return None
    index = _index(context, index_of(node))
    if index is None:
        return None
    found = ADDRESSES_READ.part(block, index, context.span(node), context.text(holder))
    if isinstance(found, Fault):
        _refuse(context, found, node, holder)
        return None
    return found


def _whole_number(node: Located | None) -> int | None:
    if node.__class__ is cst.Integer:
        return whole_number(node)
    if isinstance(node, cst.UnaryOperation) and isinstance(node.operator, cst.Minus):
        inner = _whole_number(node.expression)
        return None if inner is None else -inner
    return None
