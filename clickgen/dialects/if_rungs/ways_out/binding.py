"""The grouping of operators in an expression: in Python & and | bind before the comparisons around them."""

from __future__ import annotations

from collections.abc import Sequence

import libcst as cst

from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import Node, comparison, is_literal
from clickgen.dialects.if_rungs.ways_out.hints import bank_of

_Sign = cst.BaseCompOp | cst.BaseBinaryOp


def compare(
    context: Context, operators: Sequence[cst.BaseCompOp], operands: Sequence[cst.BaseExpression]
) -> cst.Comparison:
    """A comparison that is not written as one. Its place is from the first operand to the last."""
    targets = zip(operators, operands[1:], strict=True)
    node = cst.Comparison(operands[0], [cst.ComparisonTarget(sign, operand) for sign, operand in targets])
    context.places.note(node, context.extent(operands[0])[0], context.extent(operands[-1])[1])
    return node


def join(
    context: Context, operator: type[cst.And] | type[cst.Or], terms: Sequence[cst.BaseExpression]
) -> cst.BaseExpression:
    """Terms with ``and`` or ``or`` between them, in the place of the first."""
    joined = terms[0]
    for term in terms[1:]:
        joined = cst.BooleanOperation(joined, operator(), term)
        context.places.note(joined, *context.extent(terms[0]))
    return joined


def binds_otherwise(context: Context, node: cst.Comparison) -> bool:
    """True for ``ds[1] == 5 & x[1]``: Python takes ``5 & x[1]`` together."""
    return unbound(context, node) is not None


def unbound(context: Context, node: cst.Comparison) -> cst.BaseExpression | None:
    """``ds[1] == 5 & x[1]`` as it is meant: & and | bind more tightly in Python than the comparisons around them."""
    operators, operands = comparison(node)
    whole = context.text(node)
    if not any(is_tight(operand) for operand in operands):
        return None
    signs: list[_Sign] = []
    terms: list[cst.BaseExpression] = []
    for index, operand in enumerate(operands):
        if index:
            signs.append(operators[index - 1])
        for at, (sign, term) in enumerate(_loose(operand)):
            if at:
                signs.append(sign)
            terms.append(term)
    if len(context.text(terms[0]) or "") == 0 or _has_brackets(context, whole, terms):
        return None
    is_mask = all(_is_word(term) for term in terms) and not (
        any(is_tight(operand) for operand in operands[1:-1])
        or (is_tight(operands[-1]) and len(operands) == 2 and is_literal(_loose(operands[-1])[0][1]))
    )
    return None if is_mask else _grouped(context, terms, signs)


_JOINS: tuple[tuple[type[_Sign], type[cst.And] | type[cst.Or]], ...] = ((cst.BitOr, cst.Or), (cst.BitAnd, cst.And))


def _grouped(
    context: Context, terms: Sequence[cst.BaseExpression], signs: Sequence[_Sign]
) -> cst.BaseExpression | None:
    for kind, operator in _JOINS:
        places = [at for at, sign in enumerate(signs) if isinstance(sign, kind)]
        if places:
            starts, ends = [0, *(at + 1 for at in places)], [*(at + 1 for at in places), len(terms)]
            values = [_grouped(context, terms[a:b], signs[a : b - 1]) for a, b in zip(starts, ends, strict=True)]
            kept = [value for value in values if value is not None]
            return join(context, operator, kept) if len(kept) == len(values) else None
    if len(terms) == 1:
        return terms[0]
    return compare(context, [sign for sign in signs if isinstance(sign, cst.BaseCompOp)], terms)


def is_tight(node: Node) -> bool:
    return isinstance(node, cst.BinaryOperation) and isinstance(node.operator, cst.BitAnd | cst.BitOr)


def _loose(node: cst.BaseExpression) -> list[tuple[cst.BaseBinaryOp, cst.BaseExpression]]:
    """The terms of & and |, each with the operator before it."""
    if not isinstance(node, cst.BinaryOperation) or not is_tight(node):
        return [(cst.BitAnd(), node)]
    right = _loose(node.right)
    return [*_loose(node.left), (node.operator, right[0][1]), *right[1:]]


def _is_word(node: Node) -> bool:
    bank = bank_of(node)
    return is_literal(node) or (bank is not None and not bank.is_bit)


def _has_brackets(context: Context, whole: str, terms: Sequence[Node]) -> bool:
    """True if parentheses show what belongs together."""
    rest = whole
    for term in terms:
        rest = rest.replace(context.text(term), " ", 1)
    return "(" in rest or ")" in rest
