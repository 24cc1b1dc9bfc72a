"""Ways out for code in place of a condition that is not one: words of other machines, compared bits, chains."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import libcst as cst

from clickgen.device.banks import BANKS
from clickgen.device.nicknames import nickname_fault
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    ADDRESSES,
    Node,
    arguments,
    called,
    comparison,
    elements,
    index_of,
    is_literal,
    is_name,
    literal,
    name_of,
    text_value,
    whole_number,
    word,
)
from clickgen.dialects.if_rungs.read.operands import address_hint
from clickgen.dialects.if_rungs.trade import ACTIONS, CONDITIONS, advice
from clickgen.dialects.if_rungs.ways_out.condition_parts import SIGNS
from clickgen.dialects.if_rungs.ways_out.hints import (
    Fits,
    around_value,
    bank_of,
    flat_address,
    has_bits,
    is_condition,
    number_of,
    own,
    own_advice,
    replaced,
    trade_advice,
    truth_of,
)
from clickgen.dialects.if_rungs.ways_out.meant import Meant, meant
from clickgen.dialects.if_rungs.ways_out.no_call import routine_named
from clickgen.instructions import INSTRUCTIONS
from clickgen.ir.operands import Immediate, Operand, Range
from clickgen.problems.diagnostics import Diagnostics, did_you_mean
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import SourceFile

_FUNCTIONS = ("all", "any", "nc", "re", "fe")
_SIGNS = {"==": True, "!=": False, "is": True, "is not": False}
_COMPARED: dict[type[Node], str] = {
    cst.Equal: "==",
    cst.NotEqual: "!=",
    cst.Is: "is",
    cst.IsNot: "is not",
    cst.LessThan: "<",
    cst.LessThanEqual: "<=",
    cst.GreaterThan: ">",
    cst.GreaterThanEqual: ">=",
}
_NO_CALCULATION = (
    'a condition does not calculate: put a rung before it, if True: calc("ds.A * 2", dd.Result), '
    "and write dd.Result > 5"
)
_RANGE_MAX = 8
"""A message does not name each address of a longer range."""


def way_out(context: Context, node: Node, fits: Fits) -> tuple[str, Fix | None]:
    """The way out for an expression that is not a condition, and a fix if the meaning is certain."""
    if context.is_trial:
        return "", None
    name = name_of(node)
    if isinstance(node, cst.Call):
        return _called(context, node, fits)
    truth = truth_of(node)
    if truth is not None:
        return CONDITIONS["always" if truth else "never"].shown, None
    readings = readings_of(context, node, fits)
    if len(readings) == 2:
        return f"in series write {readings[0].text}, in parallel {readings[1].text}", None
    if readings and is_literal(node):
        return f"a condition has no quotes: {readings[0].way_out}", None
    if literal(node) is None:
        return "put a rung that always runs under if True:", None
    if isinstance(node, cst.Lambda):
        text = own(context, node.body)
        return (f"lambda: is for the inputs of a box; write {text} alone" if fits(text) else ""), None
    if isinstance(node, cst.BinaryOperation):
        if isinstance(node.operator, cst.BitXor):
            return own_advice(context, CONDITIONS["xor"], (node.left, node.right), fits), None
        return _calculation(context, node, fits)
    known = advice(name, CONDITIONS) if name else None
    if known is not None:
        return known.shown, None
    routine = routine_named(context, name) if name else ""
    if routine:
        return f"a subroutine is called under the if: call({routine})", None
    if name and not address_hint(node):
        return f"a nickname follows its bank: x.{name}, y.{name} or c.{name}", None
    return address_hint(node), None


def readings_of(context: Context, node: Node, fits: Fits) -> list[Meant]:
    """The possible meanings of an expression as a condition: one, two for a list, none if nothing is certain."""
    if isinstance(node, cst.Tuple | cst.List) and len(node.elements) > 1:
        terms = [meant(context, element, fits) for element in elements(node)]
        kept = [term for term in terms if term is not None and not term.before]
        texts = ", ".join(term.text for term in kept)
        turned = tuple(leaf for term in kept for leaf in term.turned)
        return [Meant(f"{name}({texts})", turned, ()) for name in ("all", "any")] if len(kept) == len(terms) else []
    quoted = text_value(node)
    if quoted is not None:
        text = _unquoted(quoted, fits)
        return [Meant(text, (), ())] if text else []
    said = meant(context, node, fits)
    return [said] if said is not None else []


def _unquoted(value: str, fits: Fits) -> str:
    """The condition that somebody put in quotes: ``"x[2]"``, ``"c.A and c.B"``, ``"Reset"``; "" for another text."""
    context = Context(SourceFile("", value), Diagnostics())
    flat, inner = flat_address(value), context.expression()
    if flat:
        return flat if fits(flat) else ""
    if is_name(inner) or nickname_fault(value) is None:
        cell = f"c.{value}" if value.isidentifier() else f'c["{value}"]'
        return cell if nickname_fault(value) is None and fits(cell) else ""
    if inner is None or is_literal(inner):
        return ""
    said = meant(context, inner, fits)
    return said.text if said is not None and not said.before and not said.turned else ""


def _called(context: Context, node: cst.Call, fits: Fits) -> tuple[str, Fix | None]:
    func, given = node.func, arguments(node)
    if isinstance(func, cst.Attribute | cst.Subscript):
        text = own(context, func)
        if not given and text and fits(text):
            return f"an address is not called: write {text}", None
        if isinstance(func, cst.Attribute):
            method = word(func.attr)
            return trade_advice(context, method, CONDITIONS, around_value(method, (func.value, *given)), fits), None
        return "", None
    name = called(node)
    lower = name.lower()
    if lower in _FUNCTIONS:
        return f"it is written in small letters: {lower}(...)", replaced(context, func, lower, is_safe=True)
    told = trade_advice(context, name, CONDITIONS, around_value(name, given), fits)
    if told:
        return told, None
    routine = routine_named(context, name)
    if routine:
        return f"a subroutine is called under the if: call({routine})", None
    if lower in INSTRUCTIONS or lower in ACTIONS:
        spec = INSTRUCTIONS.get(lower)
        found = advice(lower, ACTIONS)
        shown = spec.example if spec else found.code[0] if found and found.code else ""
        shown = own(context, node) if name in INSTRUCTIONS and node.args and own(context, node) else shown
        return f"an action belongs under the if, not in it: {shown}", None
    return address_hint(node) or did_you_mean(name, _FUNCTIONS), None


def _calculation(context: Context, node: cst.BinaryOperation, fits: Fits) -> tuple[str, Fix | None]:
    """A sum in place of a condition: most often a name with a sign in it."""
    left, right = node.left, name_of(node.right)
    if isinstance(node.operator, cst.Subtract) and isinstance(left, cst.Attribute) and right:
        return f"CLICK takes no - in a nickname: write {own(context, left)}_{right}", None
    if has_bits(node):
        series, parallel = (f"{name}({own(context, left)}, {own(context, node.right)})" for name in ("all", "any"))
        return f"bits do not calculate; in series write {series}, in parallel {parallel}" if fits(series) else "", None
    return _NO_CALCULATION, None


# -- comparisons ------------------------------------------------------------------------------------------------------


def unchained(context: Context, node: cst.Comparison, fits: Fits) -> tuple[str, Fix | None]:
    """``0 < ds[1] < 10`` as ``all(0 < ds[1], ds[1] < 10)``, and the edits that write it; every comment stays."""
    if context.is_trial:
        return "", None
    operators, operands = comparison(node)
    signs = [_COMPARED.get(operator.__class__, "") for operator in operators]
    texts = [own(context, operand) for operand in operands]
    general = "write each comparison by itself: all(1 < ds.A, ds.A < 5)"
    if not all(texts) or any(sign not in ("==", "!=", "<", "<=", ">", ">=") for sign in signs):
        return general, None
    pairs = zip(texts, signs, texts[1:], strict=False)
    text = f"all({', '.join(f'{left} {sign} {right}' for left, sign, right in pairs)})"
    if not fits(text):
        return general, None
    span, between = context.span(node), _between(context, operands)
    if "(" in between or ")" in between:
        return f"write {text}", None
    edits = [Edit(span._replace(end_line=span.line, end_col=span.col), "all(")]
    for operand, shown in zip(operands[1:-1], texts[1:-1], strict=True):
        end = context.span(operand)
        edits.append(Edit(end._replace(line=end.end_line, col=end.end_col), f", {shown}"))
    edits.append(Edit(span._replace(line=span.end_line, col=span.end_col), ")"))
    return f"write {text}", Fix(tuple(edits))


def _between(context: Context, operands: Sequence[Node]) -> str:
    """The text between the operands of a comparison without comments: its operators, and parentheses."""
    gaps: list[str] = []
    spans = [context.span(operand) for operand in operands]
    for one, other in pairwise(spans):
        lines = [context.source.line(number) for number in range(one.end_line, other.line + 1)]
        lines[-1] = lines[-1][: other.col - 1]
        lines[0] = lines[0][one.end_col - 1 :]
        gaps += [line.partition("#")[0] for line in lines]
    return "".join(gaps)


class ComparedBit(NamedTuple):
    """The way out for a compared bit. ``turned`` is the bit if its opposite is meant, for the judge of
    fixes: a name may be that of a block."""

    help: str
    fix: Fix | None = None
    turned: Node | None = None


def compared_bit(context: Context, node: cst.Comparison, fits: Fits) -> ComparedBit | None:
    """The way out for a bit compared with True, 0, "ON" or another bit; None if there is no bit."""
    target = node.comparisons[0]
    left, right, sign = node.left, target.comparator, _COMPARED.get(target.operator.__class__, "")
    if bank_of(right) is not None and _is_bit(right) and not _is_bit(left):
        left, right = right, left
    text, bank, state = own(context, left), bank_of(left), literal(right)
    is_terminal = isinstance(left, cst.Attribute) and word(left.attr) == "immediate" and _is_bit(left.value)
    if bank is not None and not bank.is_bit and isinstance(state, bool):
        return ComparedBit(f"write {text} {'!=' if state is _SIGNS.get(sign, True) else '=='} 0")
    if bank is not None and bank.is_bit and not _is_bit(left) and truth_of(right) is not None and fits(text):
        return ComparedBit(_compared_bits(left, text, truth_of(right) is _SIGNS.get(sign, True)))
    if bank is None or not (_is_bit(left) or (is_terminal and truth_of(right) is not None)) or not fits(text):
        return None
    if _is_bit(right):
        other = own(context, right)
        same, unlike = (
            f"any(all({text}, {other}), all(nc({text}), nc({other})))",
            CONDITIONS["xor"].written([text, other]),
        )
        written = same if _SIGNS.get(sign) else unlike
        return ComparedBit(
            f"write {written}" if sign in _SIGNS and text and other and fits(written) else bit_help(text)
        )
    value = truth_of(right)
    if value is None or sign not in _SIGNS or not text:
        current = {"T": "td", "CT": "ctd"}.get(bank.name)
        if current and sign and text:
            whole = own(context, node)
            written = re.sub(rf"\b{bank.dsl}(?=[.\[])", current, whole)
            if fits(written):
                return ComparedBit(f"{text} is the bit; its current value is compared with {written}")
        return ComparedBit(bit_help(text))
    wanted = text if value is _SIGNS[sign] else f"nc({text})"
    is_sure = isinstance(left, cst.Subscript) and whole_number(index_of(left)) is not None
    fix = replaced(context, node, wanted, is_safe=is_sure) if fits(wanted) else None
    return ComparedBit(f"write {wanted}", fix, None if wanted == text else left)


def _compared_bits(node: Node, text: str, is_on: bool) -> str:
    """The way out for ``c[1:3] == True``: all of them off, and not all of them on, are different."""
    index = index_of(node) if isinstance(node, cst.Subscript) else None
    if is_on or not isinstance(index, cst.Slice):
        return f"write {text}" if is_on else bit_help(text)
    bank, one = bank_of(node), ""
    start, stop = number_of(index.lower), number_of(index.upper)
    if bank is not None and start is not None and stop is not None:
        cells = [f"nc({bank.dsl}[{number}])" for number in range(start, stop)]
        one = f", any({', '.join(cells)}) where one of them is to be off" if 1 < len(cells) <= _RANGE_MAX else ""
    return f"write nc({text}) where all of them are to be off{one}"


def bit_help(text: str) -> str:
    return f"write {text or 'c.A'} where it is to be on, nc({text or 'c.A'}) where it is to be off"


def _is_bit(node: Node) -> bool:
    """True for a single bit by its name or number."""
    if isinstance(node, cst.Subscript) and not is_literal(index_of(node)):
        return False
    bank = bank_of(node) if node.__class__ in ADDRESSES else None
    return bank is not None and bank.is_bit and bool(name_of(getattr(node, "value", None)))


def searched(context: Context, node: cst.Comparison, fits: Fits) -> str:
    """A search for ``ds.A in ds[1:50]``; "" for any other comparison."""
    operator, span = node.comparisons[0].operator, node.comparisons[0].comparator
    if not isinstance(operator, cst.In | cst.NotIn) or not isinstance(span, cst.Subscript | cst.Attribute):
        return ""
    left, found = own(context, node.left), "c.Found" if isinstance(operator, cst.In) else "nc(c.Found)"
    bank = bank_of(span)
    if bank is None or bank.is_bit or not left or not fits(f"all({left} == 0)"):
        return ""
    search = f"search({own(context, span)} == {left}, result=ds.FoundAt, found=c.Found)"
    return f"put a rung before it, if True: {search}, and write {found}"


def compared_condition(context: Context, node: cst.Comparison, fits: Fits) -> str:
    """The way out for ``re(x[1]) == False``, and other conditions without an opposite in the language."""
    operator, right = node.comparisons[0].operator, node.comparisons[0].comparator
    sides = [side for side in (node.left, right) if is_condition(side)]
    other = right if sides[0] is node.left else node.left
    said, truth = meant(context, sides[0], fits), truth_of(other)
    if said is None or said.before or operator.__class__ not in SIGNS or truth is None:
        return "a condition is written alone; for its opposite put it on a bit: if c.A: out(c.Result), and nc(c.Result)"
    return f"put it on a bit in a rung before, if {said.text}: out(c.Result), and write nc(c.Result)"


def compared_range(context: Context, node: cst.Comparison, side: Operand, fits: Fits) -> str:
    """The way out for a compared range: a search for a text, each register by itself for numbers."""
    if isinstance(side, Immediate) or not isinstance(side, Range):
        return ""
    target = node.comparisons[0]
    left, right, sign = node.left, target.comparator, _COMPARED.get(target.operator.__class__, "")
    value = right if context.span(left) == side.span else left
    ranged = left if value is right else right
    text, shown = own(context, value), own(context, ranged)
    if side.bank == "TXT" and text_value(value) is not None and sign in ("==", "!="):
        found = "c.Found" if sign == "==" else "nc(c.Found)"
        return (
            f"a search compares a text: search({shown} == {text}, result=ds.FoundAt, found=c.Found) in a rung before, "
            f"and test {found}"
        )
    if len(side) <= _RANGE_MAX and value is right:
        cells = [f"{BANKS[side.bank].dsl}[{number}]" for number in _numbers(side)]
        each = f"all({', '.join(f'{cell} {sign} {text}' for cell in cells)})"
        return f"compare each by itself: {each}" if fits(each) else ""
    return (
        f"a search looks through a range: search({shown} {sign} {text}, result=ds.FoundAt, found=c.Found)"
        if sign
        else ""
    )


def _numbers(span: Range) -> Iterator[int]:
    return (address.number for address in span.addresses())
