"""What the signs of an expression take together: in Python & and | bind before the comparisons around them."""

from __future__ import annotations

import ast

from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.ways_out.hints import bank_of


def compare(left: ast.expr, op: ast.cmpop, right: ast.expr) -> ast.Compare:
    """A comparison that stands from its left side to its right."""
    return ast.Compare(
        left,
        [op],
        [right],
        lineno=left.lineno,
        col_offset=left.col_offset,
        end_lineno=right.end_lineno,
        end_col_offset=right.end_col_offset,
    )


def binds_otherwise(context: Context, node: ast.Compare) -> bool:
    """True for ``ds[1] == 5 & x[1]``: Python takes ``5 & x[1]`` together."""
    return unbound(context, node) is not None


def unbound(context: Context, node: ast.Compare) -> ast.expr | None:
    """``ds[1] == 5 & x[1]`` as it is meant: & and | bind more tightly in Python than the comparisons around them."""
    operands = [node.left, *node.comparators]
    whole = context.text(node)
    if not any(is_tight(operand) for operand in operands):
        return None
    signs: list[ast.cmpop | ast.operator] = []
    terms: list[ast.expr] = []
    for index, operand in enumerate(operands):
        if index:
            signs.append(node.ops[index - 1])
        for at, (sign, term) in enumerate(_loose(operand)):
            if at:
                signs.append(sign)
            terms.append(term)
    if len(context.text(terms[0]) or "") == 0 or _has_brackets(context, whole, terms):
        return None
    is_mask = all(_is_word(term) for term in terms) and not (
        any(is_tight(operand) for operand in operands[1:-1])
        or (is_tight(operands[-1]) and len(operands) == 2 and isinstance(_loose(operands[-1])[0][1], ast.Constant))
    )
    return None if is_mask else _grouped(terms, signs)


def _grouped(terms: list[ast.expr], signs: list[ast.cmpop | ast.operator]) -> ast.expr | None:
    for kind, op in ((ast.BitOr, ast.Or()), (ast.BitAnd, ast.And())):
        places = [at for at, sign in enumerate(signs) if isinstance(sign, kind)]
        if places:
            starts, ends = [0, *(at + 1 for at in places)], [*(at + 1 for at in places), len(terms)]
            values = [_grouped(terms[a:b], signs[a : b - 1]) for a, b in zip(starts, ends, strict=True)]
            kept = [value for value in values if value is not None]
            return ast.copy_location(ast.BoolOp(op, kept), terms[0]) if len(kept) == len(values) else None
    if len(terms) == 1:
        return terms[0]
    node = ast.Compare(terms[0], [sign for sign in signs if isinstance(sign, ast.cmpop)], terms[1:])
    node.lineno, node.col_offset = terms[0].lineno, terms[0].col_offset
    node.end_lineno, node.end_col_offset = terms[-1].end_lineno, terms[-1].end_col_offset
    return node


def is_tight(node: ast.expr) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitAnd | ast.BitOr)


def _loose(node: ast.expr) -> list[tuple[ast.operator, ast.expr]]:
    """The terms of & and |, each with the sign in front of it."""
    if not isinstance(node, ast.BinOp) or not is_tight(node):
        return [(ast.BitAnd(), node)]
    right = _loose(node.right)
    return [*_loose(node.left), (node.op, right[0][1]), *right[1:]]


def _is_word(node: ast.expr) -> bool:
    bank = bank_of(node)
    return isinstance(node, ast.Constant) or (bank is not None and not bank.is_bit)


def _has_brackets(context: Context, whole: str, terms: list[ast.expr]) -> bool:
    """True where parentheses say what belongs together."""
    rest = whole
    for term in terms:
        rest = rest.replace(context.text(term), " ", 1)
    return "(" in rest or ")" in rest
