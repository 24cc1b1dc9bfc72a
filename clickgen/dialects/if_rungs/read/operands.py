"""Addresses, ranges, pointers and constants out of expressions."""

from __future__ import annotations

import ast
import re

from clickgen.device.banks import BANKS, POINTED, UPPER_BYTE_BANKS, Address, Bank
from clickgen.dialects.if_rungs.read.context import Context
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
from clickgen.problems.diagnostics import Edit, Fix, did_you_mean
from clickgen.text.source import Span

_CHAR_CODE = re.compile(r"\$[0-9A-Fa-f]{2}")
_ADDRESS_FORMS = "an address is written ds[5] or ds.Name"


def looks_like_address(node: ast.expr) -> bool:
    """True for ``bank.name``, ``bank[...]`` and the same with ``.immediate``."""
    return isinstance(node, ast.Attribute | ast.Subscript)


def read_operand(context: Context, node: ast.expr, signature: str = "") -> Operand | None:
    """An address in any form or a constant; None with a problem, which shows the signature that it belongs to."""
    if isinstance(node, ast.Attribute | ast.Subscript):
        return read_address(context, node)
    return read_constant(context, node, signature)


def read_constant(context: Context, node: ast.expr, signature: str = "") -> Constant | None:
    """A number or a string; a leading minus belongs to the number."""
    if isinstance(node, ast.Constant):
        value, span = node.value, context.span(node)
        if isinstance(value, int) and not isinstance(value, bool):
            is_hex = context.text(node)[:2].lower() == "0x"
            return Hex(value, span) if is_hex else Integer(value, span)
        if isinstance(value, float):
            return Real(value, context.text(node), span)
        if isinstance(value, str):
            if _CHAR_CODE.fullmatch(value):
                return CharCode(int(value[1:], 16), span)
            return Text(value, span, context.embedded(node))
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
        inner = read_constant(context, node.operand) if isinstance(node.operand, ast.Constant) else None
        sign = -1 if isinstance(node.op, ast.USub) else 1
        if isinstance(inner, Integer):
            return Integer(sign * inner.value, context.span(node))
        if isinstance(inner, Real):
            return Real(sign * inner.value, ("-" if sign < 0 else "") + inner.text, context.span(node))
    hint = address_hint(node) or modifier_hint(node) or _calculated(context, node) or _ADDRESS_FORMS
    help = f"{hint}: {signature}" if signature else hint
    context.problem("CG113", node, f"{shorten(context.text(node))} is not an address or a constant", help)
    return None


def address_hint(node: ast.expr) -> str:
    """How the language writes what looks like an address of CLICK's: ``C1``, ``ds5``, ``"X001"``, ``X(1)``."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return text_hint(node.value)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id.lower() in BANK_NAMES:
        bank = BANK_NAMES[node.func.id.lower()]
        number = _whole_number(node.args[0]) if len(node.args) == 1 else None
        shown = number if number is not None and bank.has(number) else bank.first
        return f"an address has square brackets: {bank.dsl}[{shown}]"
    name = node.id if isinstance(node, ast.Name) else ""
    if name.lower() in BANK_NAMES:
        return f"{name} is a whole bank: {_ADDRESS_FORMS}"
    return name_hint(name)


def _calculated(context: Context, node: ast.expr) -> str:
    """The way out for a calculation, or another word, in the place of a value; "" for anything else."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return own_advice(context, advice(node.func.id, CONDITIONS), (), lambda _: False)
    if (
        isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Add | ast.Sub | ast.Mult | ast.Div)
        and not has_bits(node)
    ):
        text = own(context, node)
        if text and "'" not in text:
            quote = "'" if '"' in text else '"'
            return f"calculate it first, calc({quote}{text}{quote}, ds.Result), and use ds.Result"
    if isinstance(node, ast.Constant) and isinstance(node.value, bool):
        return "a bit is turned on with set(c.Name), off with reset(c.Name); a number is 1 or 0"
    if isinstance(node, ast.List | ast.Tuple) and node.elts:
        return (
            f"addresses are given one by one, each with a line of its own, or as a range: {own(context, node.elts[0])}"
        )
    if isinstance(node, ast.Name):
        return f"a nickname follows its bank: c.{node.id} for a bit, ds.{node.id} for a number"
    return ""


def read_address(context: Context, node: ast.Attribute | ast.Subscript) -> Operand | None:
    """``bank.name``, ``bank[number]``, ``bank["name"]``, ``bank[a:b]``, ``bank[ds.Pointer]``, with ``.immediate``."""
    holder = node.value
    if isinstance(node, ast.Attribute) and not isinstance(holder, ast.Name):
        return _read_modifier(context, node)
    if isinstance(node, ast.Subscript) and isinstance(holder, ast.Attribute | ast.Subscript):
        return _read_part(context, holder, node)
    if not isinstance(holder, ast.Name):
        context.problem("CG113", node, f"{shorten(context.text(node))} is not an address", _ADDRESS_FORMS)
        return None
    bank = BANK_NAMES.get(holder.id)
    if bank is None:
        _refuse_bank(context, node, holder)
        return None
    if isinstance(node, ast.Attribute):
        return Named(bank.name, node.attr, context.span(node))
    return _read_index(context, bank, node)


def _refuse_bank(context: Context, node: ast.Attribute | ast.Subscript, holder: ast.Name) -> None:
    message, lower = f"there is no bank {holder.id!r}", holder.id.lower()
    if lower in BANK_NAMES:
        fix = Fix((Edit(context.span(holder), lower),))
        shown = lower + own(context, node).removeprefix(holder.id)
        context.problem("CG113", holder, message, f"banks are written in small letters: {shown}", fix)
        return
    number = _whole_number(node.slice) if isinstance(node, ast.Subscript) else None
    match = re.fullmatch(r"([a-z]+)([0-9]{1,4})", lower)
    known = bank_hint(lower, str(number)) or did_you_mean(holder.id, BANK_NAMES)
    if match and match[1] in BANK_NAMES:
        known = f"a nickname stands alone behind its bank: {match[1]}[{int(match[2])}] or {match[1]}.Name"
    context.problem("CG113", holder, message, known or banks_hint())


def _read_modifier(context: Context, node: ast.Attribute) -> Operand | None:
    if node.attr != "immediate":
        hint = f"write .{node.attr}()" if node.attr in MODIFIERS else ""
        fix: Fix | None = None
        if not hint:
            hint, fix = _member(context, node)
        hint = hint or did_you_mean(node.attr, ["immediate", *MODIFIERS])
        context.problem("CG113", node, f"an address has no .{node.attr}", hint or _ADDRESS_FORMS, fix)
        return None
    if not isinstance(node.value, ast.Attribute | ast.Subscript):
        context.problem("CG113", node, ".immediate belongs behind an address", "x[1].immediate")
        return None
    target = read_address(context, node.value)
    if target is None:
        return None
    if not isinstance(target, Named | Cell | Range):
        context.problem("CG308", node, ".immediate belongs behind an X or Y address", "x[1].immediate")
        return None
    return Immediate(target, context.span(node))


def _member(context: Context, node: ast.Attribute) -> tuple[str, Fix | None]:
    """The way out for what is written behind an address with a dot."""
    base = node.value
    while isinstance(base, ast.Attribute | ast.Subscript):
        base = base.value
    bank = BANK_NAMES.get(base.id) if isinstance(base, ast.Name) else None
    text = own(context, node.value)
    return member_hint(context, node, bank, text.removeprefix(bank.dsl)) if bank and text else ("", None)


def _read_part(context: Context, holder: ast.Attribute | ast.Subscript, node: ast.Subscript) -> Named | None:
    """``ds.Recipe[3]`` and ``ds.Recipe[0:10]``: members of a block."""
    block = read_address(context, holder)
    if block is None:
        return None
    if not isinstance(block, Named) or block.part is not None:
        help = _ADDRESS_FORMS
        if isinstance(block, Cell) and not BANKS[block.bank].is_bit:
            help = bit_of_word(context.text(holder), BANKS[block.bank], _whole_number(node.slice))
        context.problem("CG113", node, f"{shorten(context.text(node))} is not an address", help)
        return None
    index, example = node.slice, f"{context.text(holder)}[3] and {context.text(holder)}[0:10]"
    if isinstance(index, ast.Slice):
        start, stop, step = (_whole_number(bound) for bound in (index.lower, index.upper, index.step))
        bounds = ((start, index.lower), (stop, index.upper), (step, index.step))
        if all(number is not None or bound is None for number, bound in bounds):
            return Named(block.bank, block.name, context.span(node), Section(start, stop, 1 if step is None else step))
    number = _whole_number(index)
    if number is not None and number >= 0:
        return Named(block.bank, block.name, context.span(node), number)
    if number is not None:
        context.problem("CG214", index, "the members of a block are counted from 0", example)
    elif isinstance(index, ast.Attribute | ast.Subscript):
        way = f"point into the bank: {block.bank.lower()}[ds.Index], with the block's first address added to the index"
        context.problem("CG214", index, f"a pointer cannot count inside {context.text(holder)}", way)
    else:
        context.problem("CG214", index, "a block takes a number or a range behind its name", example)
    return None


def _read_index(context: Context, bank: Bank, node: ast.Subscript) -> Operand | None:
    index, span = node.slice, context.span(node)
    if isinstance(index, ast.Slice):
        return _read_range(context, bank, index, node)
    if isinstance(index, ast.Constant) and isinstance(index.value, str):
        if index.value.lower() == "0u" and bank.name in UPPER_BYTE_BANKS:
            return Cell(Address(bank.name, 0, True), span)
        return Named(bank.name, index.value, span)
    number = _whole_number(index)
    if number is not None:
        return _cell(context, bank, number, span)
    if isinstance(index, ast.Attribute | ast.Subscript):
        return _read_pointer(context, bank, index, span)
    context.problem(
        "CG113",
        index,
        f"{bank.dsl}[...] takes a number, a name in quotes, a range or a DS register",
        _no_index(bank, index),
    )
    return None


def _no_index(bank: Bank, index: ast.expr) -> str:
    """The way out for what stands in brackets and says no number."""
    if isinstance(index, ast.BinOp):
        first, last = _whole_number(index.left), _whole_number(index.right)
        if isinstance(index.op, ast.Sub) and first is not None and last is not None and first < last:
            return f"a range has a colon, and its end is not included: {bank.dsl}[{first}:{last + 1}]"
        return 'arithmetic belongs into a calc before: calc("ds.Index + 1", ds.Next)'
    if isinstance(index, ast.Name):
        name = index.id
        return f"a nickname is written {bank.dsl}.{name}; a pointer goes through a register, {bank.dsl}[ds.{name}]"
    return f"{bank.dsl}[{bank.first}]"


def _cell(context: Context, bank: Bank, number: int, span: Span) -> Cell | None:
    if bank.has(number):
        return Cell(Address(bank.name, number), span)
    context.problems.add("CG201", span, f"there is no {bank.dsl}[{number}]", f"{bank.name} has {bank.describe_range()}")
    return None


def _read_pointer(context: Context, bank: Bank, index: ast.Attribute | ast.Subscript, span: Span) -> Operand | None:
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


def _read_range(context: Context, bank: Bank, index: ast.Slice, node: ast.Subscript) -> Range | None:
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


def _whole_number(node: ast.expr | None) -> int | None:
    if isinstance(node, ast.Constant) and type(node.value) is int:
        return node.value
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = _whole_number(node.operand)
        return None if inner is None else -inner
    return None


def shorten(text: str, limit: int = 40) -> str:
    """Source text on one line, for a message."""
    line = " ".join(text.split())
    return line if len(line) <= limit else line[: limit - 3] + "..."
