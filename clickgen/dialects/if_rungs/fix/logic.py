"""Python's and, or, not, &, | and ~ as all(...), any(...) and nc(...): libcst's nodes, with every blank and comment."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import libcst as cst

from clickgen.device.banks import Kind
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    every,
    index_of,
    is_literal,
    is_starred,
    keywords,
    literal,
    name_of,
    terms,
    word,
)
from clickgen.ir.addresses import BANK_NAMES

SWAPPED = {"all": "any", "any": "all"}
_OPPOSITE: dict[type[cst.BaseCompOp], type[cst.BaseCompOp]] = {
    cst.Equal: cst.NotEqual,
    cst.NotEqual: cst.Equal,
    cst.LessThan: cst.GreaterThanEqual,
    cst.GreaterThanEqual: cst.LessThan,
    cst.GreaterThan: cst.LessThanEqual,
    cst.LessThanEqual: cst.GreaterThan,
}
_Blank = cst.BaseParenthesizableWhitespace
_NOTHING = cst.SimpleWhitespace("")


# -- what is asked ----------------------------------------------------------------------------------------------------


def python_logic(node: Node) -> tuple[str, str, Sequence[cst.BaseExpression]] | None:
    """The Python operator of an expression, the function that the language has for it, and its terms."""
    if isinstance(node, cst.BooleanOperation):
        found = terms(node)
        return ("and", "all", found) if isinstance(node.operator, cst.And) else ("or", "any", found)
    if isinstance(node, cst.UnaryOperation) and isinstance(node.operator, cst.Not | cst.BitInvert):
        is_word = isinstance(node.operator, cst.BitInvert) and _is_number(node.expression)
        return None if is_word else ("not" if isinstance(node.operator, cst.Not) else "~", "nc", [node.expression])
    if isinstance(node, cst.BinaryOperation) and isinstance(node.operator, cst.BitAnd | cst.BitOr):
        both = [node.left, node.right]
        is_and = isinstance(node.operator, cst.BitAnd)
        # Of two registers one is not zero when any of their bits is on; 1 & 2 is 0, though both are not.
        if any((is_and or is_literal(term)) and _is_number(term) for term in both):
            return None
        return ("&", "all", both) if is_and else ("|", "any", both)
    return None


def _is_number(node: Node) -> bool:
    """True for a word or a number, of which ``&``, ``|`` and ``~`` take the single bits."""
    if isinstance(node, cst.Attribute | cst.Subscript):
        bank = BANK_NAMES.get(_bank_of(node))
        return bank is not None and not bank.is_bit
    if isinstance(node, cst.BinaryOperation):
        return _is_number(node.right)
    if isinstance(node, cst.UnaryOperation):
        return not isinstance(node.operator, cst.Not) and _is_number(node.expression)
    return is_literal(node) and not isinstance(literal(node), bool)


def terms_in(node: Node, function: str = "all", wanted: bool = True) -> Iterator[tuple[Node, str, bool]]:
    """The terms under Python's operators, all and any: each with what joins it, and whether it is to hold or not."""
    logic = python_logic(node)
    if logic and logic[1] == "nc":
        yield from terms_in(logic[2][0], function, not wanted)
    elif logic:
        for term in logic[2]:
            yield from terms_in(term, logic[1], wanted)
    elif isinstance(node, cst.Call) and called(node) in SWAPPED:
        for argument in arguments(node):
            yield from terms_in(argument, called(node), wanted)
    else:
        yield node, function, wanted


# -- how it is written ------------------------------------------------------------------------------------------------


class _Made(NamedTuple):
    node: cst.BaseExpression
    is_loose: bool = False
    """True for a call in the place of an operator: its arguments may join those of the same function around it."""


def in_language(node: Node, wanted: bool = True) -> cst.BaseExpression | None:
    """An expression without the parentheses around it, or its opposite, in the language; None where it has none."""
    assert isinstance(node, cst.BaseExpression)
    if isinstance(node, cst.Tuple | cst.GeneratorExp):
        return None  # Some of these cannot be without their parentheses, and none of them is a condition.
    made = _made(node.with_changes(lpar=[], rpar=[]) if node.lpar else node, wanted)
    return made and made.node


def opposite(node: Node) -> cst.BaseExpression | None:
    """The opposite of a single condition, in its parentheses; None where the language has none.

    A name counts as one bit: nobody knows here what it is.
    """
    if isinstance(node, cst.Comparison):
        target = node.comparisons[0]
        sign = _OPPOSITE.get(type(target.operator)) if len(node.comparisons) == 1 else None
        if sign is None:
            return None
        operator: cst.BaseCompOp = sign(**{side: getattr(target.operator, side) for side in _SIDES})
        return node.with_changes(comparisons=[target.with_changes(operator=operator)])
    if isinstance(node, cst.Call) and called(node) == "nc":
        given = arguments(node)
        bit = given[0] if len(given) == 1 and not keywords(node) else None
        if not isinstance(bit, cst.BaseExpression) or not _is_single(bit):
            return None
        return bit.with_changes(lpar=node.lpar, rpar=node.rpar)
    if not isinstance(node, cst.BaseExpression) or not _is_single(node):
        return None
    bank = BANK_NAMES[_bank_of(node)]
    bare = node.with_changes(lpar=[], rpar=[])
    if bank.is_bit:
        return _bracketed(cst.Call(cst.Name("nc"), [cst.Arg(bare)]), node)
    if bank.kind is Kind.TEXT:
        return None
    return cst.Comparison(bare, [cst.ComparisonTarget(cst.Equal(), cst.Integer("0"))], node.lpar, node.rpar)


_SIDES = ("whitespace_before", "whitespace_after")


def absorbed(call: cst.Call, opening: cst.LeftParen, closing: cst.RightParen) -> cst.Call:
    """A call whose parentheses are those around it, with what is between the two."""
    last = call.args[-1]
    last = last.with_changes(whitespace_after_arg=joined(last.whitespace_after_arg, closing.whitespace_before))
    before = joined(opening.whitespace_after, call.whitespace_before_args)
    return call.with_changes(args=[*call.args[:-1], last], whitespace_before_args=before)


def _made(node: cst.BaseExpression, wanted: bool) -> _Made | None:
    """The expression, or its opposite where it is not wanted; None where the language has no such thing."""
    logic = python_logic(node)
    if logic and logic[1] == "nc":
        return _negated(node, logic[2][0], wanted)
    if logic:
        function = logic[1] if wanted else SWAPPED[logic[1]]
        gaps = [_gap(operator) for operator in _operators(node, len(logic[2]))]
        commas: list[cst.Comma | cst.MaybeSentinel] = [
            *(cst.Comma(_NOTHING, gap) for gap in gaps),
            cst.MaybeSentinel.DEFAULT,
        ]
        args = [cst.Arg(term, comma=comma) for term, comma in zip(logic[2], commas, strict=True)]
        call = _joined(cst.Call(cst.Name(function), args), wanted)
        return None if call is None else _Made(_bracketed(call, node), is_loose=True)
    if isinstance(node, cst.Call) and called(node) in SWAPPED and arguments(node):
        if wanted and not any(python_logic(inner) for inner in every(node)):
            return _Made(node)
        if keywords(node) or any(map(is_starred, arguments(node))):
            return None
        call = _joined(node if wanted else node.with_changes(func=cst.Name(SWAPPED[called(node)])), wanted)
        return None if call is None else _Made(_bracketed(call, node))
    other = node if wanted else opposite(node)
    return None if other is None else _Made(other)


def _negated(node: cst.BaseExpression, operand: cst.BaseExpression, wanted: bool) -> _Made | None:
    made = _made(operand, not wanted)
    if made is None:
        return None
    if isinstance(made.node, cst.Call) and made.node is not operand:
        return made._replace(node=_bracketed(_bare(made.node), node))
    both = [*node.lpar, *made.node.lpar], [*made.node.rpar, *node.rpar]
    return _Made(made.node.with_changes(lpar=both[0], rpar=both[1]))


def _joined(call: cst.Call, wanted: bool) -> cst.Call | None:
    """A call of all or any with its terms in the language; those of the same function inside it become its own."""
    opening, args = call.whitespace_before_args, list[cst.Arg]()
    for arg in call.args:
        made = _made(arg.value, wanted)
        if made is None:
            return None
        inner = made.node
        if not made.is_loose or not isinstance(inner, cst.Call) or called(inner) != called(call):
            args.append(arg.with_changes(value=inner))
            continue
        inner = _bare(inner)
        if args:
            comma = args[-1].comma
            assert isinstance(comma, cst.Comma)
            after = joined(comma.whitespace_after, inner.whitespace_before_args)
            args[-1] = args[-1].with_changes(comma=comma.with_changes(whitespace_after=after))
        else:
            opening = joined(opening, inner.whitespace_before_args)
        args += [*inner.args[:-1], _followed(inner.args[-1], arg)]
    return call.with_changes(args=args, whitespace_before_args=opening)


def _followed(last: cst.Arg, by: cst.Arg) -> cst.Arg:
    """A last argument in the place of another one, with the comma after that."""
    behind, comma = last.whitespace_after_arg, by.comma
    if not isinstance(comma, cst.Comma):
        return last.with_changes(comma=comma, whitespace_after_arg=joined(behind, by.whitespace_after_arg))
    comma = comma.with_changes(whitespace_before=joined(behind, comma.whitespace_before))
    return last.with_changes(comma=comma, whitespace_after_arg=by.whitespace_after_arg)


def _bracketed(call: cst.Call, node: cst.BaseExpression) -> cst.Call:
    """A call in the parentheses of a node, the innermost of which become those of the call."""
    call = call.with_changes(lpar=[], rpar=[])
    if not node.lpar:
        return call
    return absorbed(call, node.lpar[-1], node.rpar[0]).with_changes(lpar=node.lpar[:-1], rpar=node.rpar[1:])


def _bare(call: cst.Call) -> cst.Call:
    """A call without parentheses around it; the comments between them stay."""
    while call.lpar:
        call = _bracketed(call, call)
    return call


# -- blanks and comments ----------------------------------------------------------------------------------------------


def _operators(node: cst.BaseExpression, count: int) -> list[cst.BaseBooleanOp | cst.BaseBinaryOp]:
    """The operators between so many terms of ``a and b and c``, which libcst nests."""
    found: list[cst.BaseBooleanOp | cst.BaseBinaryOp] = []
    while len(found) < count - 1:
        assert isinstance(node, cst.BooleanOperation | cst.BinaryOperation)
        found.append(node.operator)
        node = node.left
    return found[::-1]


def _gap(operator: cst.BaseBooleanOp | cst.BaseBinaryOp) -> _Blank:
    """What follows the comma in the place of an operator: the line is broken where it was."""
    before, after = (getattr(operator, side) for side in _SIDES)
    if isinstance(before, cst.ParenthesizedWhitespace) or "\n" in before.value:
        return joined(before, _without_indent(after))
    return after if isinstance(after, cst.ParenthesizedWhitespace) or after.value else cst.SimpleWhitespace(" ")


def _without_indent(blank: _Blank) -> _Blank:
    if isinstance(blank, cst.SimpleWhitespace):
        return blank.with_changes(value=blank.value.lstrip(" \t"))
    assert isinstance(blank, cst.ParenthesizedWhitespace)
    return blank.with_changes(first_line=blank.first_line.with_changes(whitespace=_NOTHING))


def joined(first: _Blank, second: _Blank) -> _Blank:
    """Two stretches between tokens, one after the other."""
    if isinstance(first, cst.SimpleWhitespace):
        if isinstance(second, cst.SimpleWhitespace):
            return cst.SimpleWhitespace(first.value + second.value)
        assert isinstance(second, cst.ParenthesizedWhitespace)
        blank = cst.SimpleWhitespace(first.value + second.first_line.whitespace.value)
        return second.with_changes(first_line=second.first_line.with_changes(whitespace=blank))
    assert isinstance(first, cst.ParenthesizedWhitespace)
    if isinstance(second, cst.SimpleWhitespace):
        return first.with_changes(last_line=cst.SimpleWhitespace(first.last_line.value + second.value))
    assert isinstance(second, cst.ParenthesizedWhitespace)
    line = second.first_line
    between = cst.SimpleWhitespace(first.last_line.value + line.whitespace.value)
    middle = cst.EmptyLine(first.indent, between, line.comment, line.newline)
    return second.with_changes(
        first_line=first.first_line, empty_lines=[*first.empty_lines, middle, *second.empty_lines]
    )


# -- addresses --------------------------------------------------------------------------------------------------------


def _is_single(node: Node) -> bool:
    """True for one address: no range, no pointer."""
    if isinstance(node, cst.Attribute) and word(node.attr) == "immediate":
        node = node.value
    if isinstance(node, cst.Subscript) and not is_literal(index_of(node)):
        return False
    return isinstance(node, cst.Attribute | cst.Subscript) and _bank_of(node) in BANK_NAMES


def _bank_of(node: Node) -> str:
    while isinstance(node, cst.Attribute | cst.Subscript):
        node = node.value
    return name_of(node)
