"""Addresses, ranges, pointers and constants out of expressions."""

from __future__ import annotations

import re

import libcst as cst

from clickgen.device.banks import BANKS, POINTED, UPPER_BYTE_BANKS, Address, Bank
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
from clickgen.dialects.if_rungs.trade import CONDITIONS, advice, bank_hint
from clickgen.dialects.if_rungs.ways_out.hints import BANK_NAMES as BANK_NAMES
from clickgen.dialects.if_rungs.ways_out.hints import (
    banks_hint,
    bit_of_word,
    has_bits,
    member_hint,
    name_hint,
    own,
    own_advice,
    text_hint,
)
from clickgen.ir.operands import (
    Cell,
    CharCode,
    Constant,
    Hex,
    Immediate,
    Integer,
    Named,
    Operand,
    Pointer,
    Range,
    Real,
    Section,
    Text,
)
from clickgen.problems.diagnostics import did_you_mean
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span
from clickgen.text.wording import shorten

_CHAR_CODE = re.compile(r"\$[0-9A-Fa-f]{2}")
_ADDRESSES = (cst.Attribute, cst.Subscript)
_ADDRESS_FORMS = "an address is written ds[5] or ds.Name"


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


def read_address(context: Context, node: Node) -> Operand | None:
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
        _refuse_bank(context, node, holder, name)
        return None
    if isinstance(node, cst.Attribute):
        return Named(bank.name, word(node.attr), context.span(node))
    return _read_index(context, bank, node)


def _refuse_bank(context: Context, node: cst.Attribute | cst.Subscript, holder: Node, name: str) -> None:
    message, lower = f"there is no bank {name!r}", name.lower()
    if lower in BANK_NAMES:
        fix = Fix((Edit(context.span(holder), lower),))
        shown = lower + own(context, node).removeprefix(name)
        context.problem("CG113", holder, message, f"banks are written in small letters: {shown}", fix)
        return
    number = _whole_number(index_of(node)) if isinstance(node, cst.Subscript) else None
    match = re.fullmatch(r"([a-z]+)([0-9]{1,4})", lower)
    known = bank_hint(lower, str(number)) or did_you_mean(name, BANK_NAMES)
    if match and match[1] in BANK_NAMES:
        known = f"a nickname stands alone behind its bank: {match[1]}[{int(match[2])}] or {match[1]}.Name"
    context.problem("CG113", holder, message, known or banks_hint())


def _read_modifier(context: Context, node: cst.Attribute) -> Operand | None:
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
    index, example = index_of(node), f"{context.text(holder)}[3] and {context.text(holder)}[0:10]"
    if isinstance(index, cst.Slice):
        start, stop, step = (_whole_number(bound) for bound in (index.lower, index.upper, index.step))
        bounds = ((start, index.lower), (stop, index.upper), (step, index.step))
        if all(number is not None or bound is None for number, bound in bounds):
            return Named(block.bank, block.name, context.span(node), Section(start, stop, 1 if step is None else step))
    number = _whole_number(index)
    if number is not None and number >= 0:
        return Named(block.bank, block.name, context.span(node), number)
    if number is not None:
        context.problem("CG214", index, "the members of a block are counted from 0", example)
    elif index.__class__ in ADDRESSES:
        way = f"point into the bank: {block.bank.lower()}[ds.Index], with the block's first address added to the index"
        context.problem("CG214", index, f"a pointer cannot count inside {context.text(holder)}", way)
    else:
        context.problem("CG214", index, "a block takes a number or a range behind its name", example)
    return None


def _read_index(context: Context, bank: Bank, node: cst.Subscript) -> Operand | None:
    index, span = index_of(node), context.span(node)
    number = _whole_number(index)
    if number is not None:
        return _cell(context, bank, number, span)
    text = text_value(index)
    if text is not None:
        if text.lower() == "0u" and bank.name in UPPER_BYTE_BANKS:
            return Cell(Address(bank.name, 0, True), span)
        return Named(bank.name, text, span)
    if isinstance(index, cst.Slice):
        return _read_range(context, bank, index, node)
    if isinstance(index, _ADDRESSES):
        return _read_pointer(context, bank, index, span)
    context.problem(
        "CG113",
        index,
        f"{bank.dsl}[...] takes a number, a name in quotes, a range or a DS register",
        _no_index(bank, index),
    )
    return None


def _no_index(bank: Bank, index: Located) -> str:
    """The way out for what stands in brackets and says no number."""
    if isinstance(index, cst.BinaryOperation):
        first, last = _whole_number(index.left), _whole_number(index.right)
        if isinstance(index.operator, cst.Subtract) and first is not None and last is not None and first < last:
            return f"a range has a colon, and its end is not included: {bank.dsl}[{first}:{last + 1}]"
        return 'arithmetic belongs into a calc before: calc("ds.Index + 1", ds.Next)'
    name = name_of(index) if isinstance(index, cst.Name) else ""
    if name:
        return f"a nickname is written {bank.dsl}.{name}; a pointer goes through a register, {bank.dsl}[ds.{name}]"
    return f"{bank.dsl}[{bank.first}]"


def _cell(context: Context, bank: Bank, number: int, span: Span) -> Cell | None:
    if bank.has(number):
        return Cell(Address(bank.name, number), span)
    context.problems.add("CG201", span, f"there is no {bank.dsl}[{number}]", f"{bank.name} has {bank.describe_range()}")
    return None


def _read_pointer(context: Context, bank: Bank, index: Node, span: Span) -> Operand | None:
    register = read_address(context, index)
    if register is None:
        return None
    if not isinstance(register, Named | Cell) or register.bank != "DS" or _is_section(register):
        context.problem(
            "CG212", index, "a pointer goes through a single DS register", "copy the index to a DS register first"
        )
        return None
    if bank.name not in POINTED:
        context.problems.add(
            "CG213", span, f"{bank.name} cannot be pointed into", f"pointers reach {', '.join(POINTED)}"
        )
        return None
    return Pointer(bank.name, register, span)


def _is_section(operand: Named | Cell) -> bool:
    return isinstance(operand, Named) and isinstance(operand.part, Section)


def _read_range(context: Context, bank: Bank, index: cst.Slice, node: cst.Subscript) -> Range | None:
    """A half-open slice to a range with both ends included; step -1 is the reversed direction."""
    bounds = [_whole_number(bound) for bound in (index.lower, index.upper)]
    step = 1 if index.step is None else _whole_number(index.step)
    start, stop = bounds
    if start is None or stop is None or step not in (1, -1):
        context.problem(
            "CG202",
            node,
            "a range is written with two numbers: the first address and the one behind the last",
            f"{bank.dsl}[1:17] is {bank.name}1 to {bank.name}16; {bank.dsl}[16:0:-1] is the same backwards",
        )
        return None
    last = stop - step
    if (last - start) * step < 0:
        way = f"the end is not included: {bank.dsl}[{start}:{start + step}{'' if step > 0 else ':-1'}] is one address"
        context.problem("CG202", node, f"{bank.dsl}[{_slice_text(start, stop, step)}] is empty", way)
        return None
    low, high = min(start, last), max(start, last)
    if any(first <= low and high <= last_ for first, last_ in bank.ranges):
        return Range(bank.name, start, last, context.span(node))
    if bank.has(low) and bank.has(high):
        message = f"the range {Address(bank.name, low)} to {Address(bank.name, high)} crosses a gap"
    else:
        message = f"the range {Address(bank.name, low)} to {Address(bank.name, high)} leaves the bank"
    context.problem(
        "CG202", node, message, f"{bank.name} has {bank.describe_range()}; the end of a slice is not included"
    )
    return None


def _slice_text(start: int, stop: int, step: int) -> str:
    return f"{start}:{stop}" + ("" if step == 1 else f":{step}")


def _whole_number(node: Located | None) -> int | None:
    if node.__class__ is cst.Integer:
        return whole_number(node)
    if isinstance(node, cst.UnaryOperation) and isinstance(node.operator, cst.Minus):
        inner = _whole_number(node.expression)
        return None if inner is None else -inner
    return None
