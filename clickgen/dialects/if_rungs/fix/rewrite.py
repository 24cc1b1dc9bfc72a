"""Python's and, or, not, &, | and ~ rewritten with all(...), any(...) and nc(...), every other character kept."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import libcst as cst

from clickgen.device.banks import Kind
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    every,
    index_of,
    is_literal,
    keywords,
    literal,
    name_of,
    terms,
    word,
)
from clickgen.ir.addresses import BANK_NAMES
from clickgen.ir.conditions import OPPOSITE
from clickgen.text.edits import Edit

_SWAPPED = {"all": "any", "any": "all"}
_SIGN = re.compile("|".join(sorted(OPPOSITE, key=len, reverse=True)))
_OPERATOR = re.compile(r"and|or|&|\|")
_COMMENT = re.compile(r"#[^\n]*")


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


class Rewritten(NamedTuple):
    """An expression in the language."""

    text: str
    edit: Edit
    """The edit that puts it there."""
    turned: tuple[Node, ...]
    """The single conditions of which the text has the opposite, as they stand."""


def in_language(context: Context, node: Node, wanted: bool = True) -> Rewritten | None:
    """An expression, or its opposite, in the language; None where that is not plain."""
    return _Rewriter(context).rewritten(node, wanted)


def terms_in(node: Node, function: str = "all", wanted: bool = True) -> Iterator[tuple[Node, str, bool]]:
    """The terms under Python's operators, all and any: each with what joins it, and whether it is to hold or not."""
    logic = python_logic(node)
    if logic and logic[1] == "nc":
        yield from terms_in(logic[2][0], function, not wanted)
    elif logic:
        for term in logic[2]:
            yield from terms_in(term, logic[1], wanted)
    elif isinstance(node, cst.Call) and called(node) in _SWAPPED:
        for argument in arguments(node):
            yield from terms_in(argument, called(node), wanted)
    else:
        yield node, function, wanted


def has_opposite(context: Context, node: Node) -> bool:
    """True for a single condition whose opposite the language can say."""
    return _Rewriter(context).opposite(node) is not None


def opposite_text(context: Context, node: Node) -> str:
    """The opposite of a single condition; "" where the language has none."""
    piece = _Rewriter(context).opposite(node)
    return piece.whole if piece is not None else ""


@dataclass(frozen=True)
class _Piece:
    """Text that stands by itself, or the arguments of ``function``; ``is_loose`` are those of an operator."""

    text: str
    function: str = ""
    is_loose: bool = False

    @property
    def whole(self) -> str:
        return f"{self.function}({self.text})" if self.function else self.text


class _Rewriter:
    def __init__(self, context: Context) -> None:
        self._context = context
        self._text = context.source.text
        self._turned: list[Node] = []

    def rewritten(self, node: Node, wanted: bool) -> Rewritten | None:
        """An expression, or its opposite, and the edit that writes it; None where the language has no such thing."""
        start, end = self._extent(node)
        piece = self.piece(node, wanted)
        if piece is None:
            return None
        span = self._context.span(node)
        bracket = self._bracket_around(start, end) if piece.function else None
        if bracket is None:
            return Rewritten(piece.whole, Edit(span, piece.whole), tuple(self._turned))
        # Parentheses around the expression become those of the function.
        place = self._context.stretch(bracket, end)
        edit = Edit(place, piece.function + self._text[bracket:start] + piece.text)
        return Rewritten(piece.whole, edit, tuple(self._turned))

    def piece(self, node: Node, wanted: bool) -> _Piece | None:
        """The expression, or its opposite where it is not wanted; None where the language has no such thing."""
        start, end = self._extent(node)
        logic = python_logic(node)
        if logic and logic[1] == "nc":
            return self._negated(node, logic[2][0], wanted)
        if logic:
            function = logic[1] if wanted else _SWAPPED[logic[1]]
            text = self._joined(function, logic[2], (start, end), wanted)
            return None if text is None else _Piece(text, function, is_loose=True)
        if isinstance(node, cst.Call) and called(node) in _SWAPPED and arguments(node):
            return self._call(node, called(node), wanted)
        return _Piece(self._text[start:end]) if wanted else self.opposite(node)

    def _call(self, node: cst.Call, name: str, wanted: bool) -> _Piece | None:
        """all(...) or any(...): as it stands, where nothing in it changes."""
        start, end = self._extent(node)
        if wanted and not any(python_logic(inner) for inner in every(node)):
            return _Piece(self._text[start:end])
        opening = self._text.index("(", self._extent(node.func)[1])
        function = name if wanted else _SWAPPED[name]
        text = self._joined(function, arguments(node), (opening + 1, end - 1), wanted)
        return None if text is None else _Piece(text, function)

    def _negated(self, node: Node, operand: Node, wanted: bool) -> _Piece | None:
        piece = self.piece(operand, not wanted)
        if piece is None:
            return None
        (start, end), (first, last) = self._extent(node), self._extent(operand)
        before = re.sub(r"^(not|~)\s*", "", self._text[start:first])
        behind = self._text[last:end]
        if piece.function:
            # These parentheses become those of the function.
            text = _without("(", before) + piece.text + _without(")", behind)
            return _Piece(text, piece.function, piece.is_loose)
        return _Piece(before + piece.text + behind)

    def opposite(self, node: Node) -> _Piece | None:
        """The opposite of a single condition. A name counts as one bit: nobody knows here what it stands for."""
        self._turned.append(node)
        text = self._text[slice(*self._extent(node))]
        if isinstance(node, cst.Comparison):
            return self._opposite_comparison(node)
        if isinstance(node, cst.Call) and called(node) == "nc":
            given = arguments(node)
            bit = given[0] if len(given) == 1 and not keywords(node) else None
            return _Piece(self._text[slice(*self._extent(bit))]) if bit and _is_single(bit) else None
        if not _is_single(node):
            return None
        bank = BANK_NAMES[_bank_of(node)]
        if bank.is_bit:
            return _Piece(text, "nc")
        return None if bank.kind is Kind.TEXT else _Piece(f"{text} == 0")

    def _opposite_comparison(self, node: cst.Comparison) -> _Piece | None:
        start, end = self._extent(node)
        left, right = self._extent(node.left)[1], self._extent(node.comparisons[0].comparator)[0]
        sign = _SIGN.search(_code(self._text[left:right])) if len(node.comparisons) == 1 else None
        if sign is None:
            return None
        text = self._text[start : left + sign.start()], OPPOSITE[sign[0]], self._text[left + sign.end() : end]
        return _Piece("".join(text))

    def _joined(self, function: str, terms: Sequence[Node], extent: tuple[int, int], wanted: bool) -> str | None:
        """The terms with commas between them, and what stands around them in this stretch of the file."""
        edges = [extent[0], *(offset for term in terms for offset in self._extent(term)), extent[1]]
        gaps = [_with_comma(self._text[start:end]) for start, end in zip(edges[::2], edges[1::2], strict=True)]
        texts: list[str] = []
        for index, term in enumerate(terms):
            piece = self.piece(term, wanted)
            if piece is None:
                return None
            opening = _code(gaps[index]).rfind("(")
            if piece.is_loose and piece.function == function:
                gaps[index] = _without("(", gaps[index])
                gaps[index + 1] = _without(")", gaps[index + 1])
                texts.append(piece.text)
            elif piece.function and opening >= 0:
                # Parentheses around a term become those of its function.
                gaps[index] = gaps[index][:opening] + piece.function + gaps[index][opening:]
                texts.append(piece.text)
            else:
                texts.append(piece.whole)
        return "".join(part for pair in zip(gaps, [*texts, ""], strict=True) for part in pair)

    def _extent(self, node: Node) -> tuple[int, int]:
        """Where a node stands in the text, its own parentheses left out."""
        return self._context.extent(node)

    def _bracket_around(self, start: int, end: int) -> int | None:
        """Where the parenthesis stands that opens around this stretch, when it belongs to no call."""
        before = self._text[:start].rstrip()
        if not before.endswith("(") or not self._text[end:].lstrip().startswith(")"):
            return None
        bracket = len(before) - 1
        line = before[before.rfind("\n") + 1 : bracket]
        word = re.search(r"[\w\])]*$", line.rstrip())
        is_call = word is not None and word[0] and not (word[0] in ("if", "elif") and line[-1:].isspace())
        return None if is_call or "#" in line else bracket


def _with_comma(gap: str) -> str:
    """What stands between two terms, with a comma for the operator; the line is broken where it was."""
    code = _code(gap)
    match = _OPERATOR.search(code)
    if match is None:
        return gap
    comma = code.rfind(")", 0, match.start()) + 1
    before, behind = gap[comma : match.start()], gap[match.end() :]
    if "\n" in before:
        behind = behind.lstrip(" \t")
    else:
        before = "" if behind[:1].isspace() else " "
    return f"{gap[:comma]},{before}{behind}"


def _code(gap: str) -> str:
    """What stands between terms, with blanks in the place of comments."""
    return _COMMENT.sub(lambda comment: " " * len(comment[0]), gap)


def _without(bracket: str, gap: str) -> str:
    """What stands between terms without these parentheses; those of comments stay."""
    return "".join(one for one, code in zip(gap, _code(gap), strict=True) if code != bracket)


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
