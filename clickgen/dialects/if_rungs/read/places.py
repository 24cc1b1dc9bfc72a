"""Where the nodes of one statement are in the text of their file.

libcst's nodes do not know. Its own provider of positions writes a whole file out again, which takes about as long as
reading it; here one pass over the tree of a statement adds up the lengths of what it holds. The nodes of which rungs
are made have a function each; libcst writes out all others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import libcst as cst

from clickgen.dialects.if_rungs.read.recorder import Recorder

Node = cst.CSTNode


class Places:
    """The places of the nodes that were read last: where each begins and ends, counted in characters from 0.

    The places are those of libcst's PositionProvider. Parentheses around an expression are none of it.
    """

    def __init__(self) -> None:
        self.table: dict[int, tuple[int, int]] = {}
        """Where each node begins and ends, by its identity: ``of`` asks for one."""
        self.roots: Sequence[Node] = ()
        """The statements of these nodes. Kept, so that no other node can have the identity of one of theirs."""
        self._indents: list[str] = []
        self.default_indent = ""
        """The indentation of blocks for which libcst notes none."""

    def read(self, nodes: Sequence[Node], at: int, indent: str = "", default_indent: str = "    ") -> int:
        """Note the places of these statements, which follow each other from here on; returns where they end.

        ``indent`` is the indentation of their block, ``default_indent`` that of blocks for which libcst notes none.
        """
        self.table = {}
        self.roots = nodes
        self._indents = [indent] if indent else []
        self.default_indent = default_indent
        for node in nodes:
            at = self.other(node, at)
        return at

    def of(self, node: Node | Sequence[cst.SubscriptElement]) -> tuple[int, int]:
        """Where a node begins and ends; for the elements of a subscript, where the first begins and the last ends."""
        return self.table[id(node)]

    def note(self, node: object, start: int, end: int) -> int:
        """Note a place; returns where it ends."""
        self.table[id(node)] = start, end
        return end

    def expression(self, node: cst.BaseExpression, at: int) -> int:
        """Note the places of an expression that begins here, with its parentheses; returns where they end."""
        inner = _INNER.get(node.__class__)
        if inner is None:
            return self.written_out(node, at)
        if not node.lpar:
            end = inner(self, node, at)
            self.table[id(node)] = at, end
            return end
        for opening in node.lpar:
            start, at = at, self.blank(opening.whitespace_after, at + 1)
            self.table[id(opening)] = start, at
        end = inner(self, node, at)
        self.table[id(node)] = at, end
        for closing in node.rpar:
            start, end = end, self.blank(closing.whitespace_before, end) + 1
            self.table[id(closing)] = start, end
        return end

    def other(self, node: Node, at: int) -> int:
        """Note the places of a statement or a part of one that begins here; returns where it ends."""
        inner = _OTHERS.get(node.__class__)
        return self.written_out(node, at) if inner is None else inner(self, node, at)

    def blank(self, node: Node, at: int) -> int:
        """Pass what is between two tokens, blanks, line breaks and comments; returns where it ends."""
        return at + len(node.value) if isinstance(node, cst.SimpleWhitespace) else self.written_out(node, at)

    def around(self, node: Any, at: int) -> int:
        """Pass a token of one character with blanks before and behind it: a dot, a comma, a colon."""
        before, after = node.whitespace_before, node.whitespace_after
        if before.__class__ is after.__class__ is cst.SimpleWhitespace:
            return at + len(before.value) + 1 + len(after.value)
        return self.blank(after, self.blank(before, at) + 1)

    @property
    def indent_width(self) -> int:
        """The length of the indentation here."""
        return sum(map(len, self._indents))

    def block(self, node: cst.IndentedBlock, at: int) -> int:
        """Note the places of the lines of a block, and of the blank lines and comments below them."""
        self._indents.append(self.default_indent if node.indent is None else node.indent)
        for statement in node.body:
            at = self.other(statement, at)
        at = _lines(self, node.footer, at)
        self._indents.pop()
        self.note(node, self.of(node.body[0])[0], self.of(node.body[-1])[1])
        return at

    def written_out(self, node: Node, at: int) -> int:
        """Note the places of a node of a rare kind, as libcst writes it out; returns where it ends."""
        state = Recorder(self.table, at, self._indents, self.default_indent)
        node._codegen(state)
        return state.at


# -- expressions ------------------------------------------------------------------------------------------------------


def _token(_: Places, node: cst.Name | cst.Integer | cst.Float | cst.SimpleString, at: int) -> int:
    return at + len(node.value)


def _attribute(places: Places, node: cst.Attribute, at: int) -> int:
    attr = node.attr
    at = places.around(node.dot, places.expression(node.value, at))
    end = at + len(attr.value)
    places.table[id(attr)] = at, end
    return end


def _subscript(places: Places, node: cst.Subscript, at: int) -> int:
    at = places.blank(node.whitespace_after_value, places.expression(node.value, at))
    at = places.blank(node.lbracket.whitespace_after, at + 1)
    start = end = at
    for element in node.slice:
        inner, comma = element.slice, element.comma
        if inner.__class__ is cst.Index and isinstance(inner, cst.Index) and inner.star is None:
            end = places.note(inner, at, places.expression(inner.value, at))
        else:
            end = places.other(inner, at)
        at = places.note(element, at, end)
        if isinstance(comma, cst.Comma):
            end = places.blank(comma.whitespace_before, at) + 1
            at = places.blank(comma.whitespace_after, end)
    places.note(node.slice, start, end)
    return places.blank(node.rbracket.whitespace_before, at) + 1


def _call(places: Places, node: cst.Call, at: int) -> int:
    at = places.blank(node.whitespace_after_func, places.expression(node.func, at))
    at = places.blank(node.whitespace_before_args, at + 1)
    for arg in node.args:
        start = at
        keyword, equal, comma = arg.keyword, arg.equal, arg.comma
        if arg.star:
            at = places.blank(arg.whitespace_after_star, at + len(arg.star))
        if keyword is not None:
            at = places.note(keyword, at, at + len(keyword.value))
        if isinstance(equal, cst.AssignEqual):
            at = places.around(equal, at)
        at = places.note(arg, start, places.expression(arg.value, at))
        if comma.__class__ is cst.Comma:
            at = places.around(comma, at)
        at = places.blank(arg.whitespace_after_arg, at)
    return at + 1


def _elements(places: Places, elements: Sequence[cst.BaseElement], at: int) -> int:
    for element in elements:
        if element.__class__ is not cst.Element:
            at = places.written_out(element, at)
            continue
        at = places.note(element, at, places.expression(element.value, at))
        if element.comma.__class__ is cst.Comma:
            at = places.around(element.comma, at)
    return at


def _tuple(places: Places, node: cst.Tuple, at: int) -> int:
    return _elements(places, node.elements, at)


def _list(places: Places, node: cst.List, at: int) -> int:
    at = _elements(places, node.elements, places.blank(node.lbracket.whitespace_after, at + 1))
    return places.blank(node.rbracket.whitespace_before, at) + 1


def _operator(places: Places, node: Any, at: int) -> int:
    """An operator with a token of its own and blanks on both sides."""
    token = _TOKENS.get(node.__class__)
    if token is None:
        return places.written_out(node, at)
    start = places.blank(node.whitespace_before, at)
    return places.blank(node.whitespace_after, places.note(node, start, start + token))


_TOKENS: dict[type[Node], int] = {
    **dict.fromkeys((cst.Equal, cst.NotEqual, cst.LessThanEqual, cst.GreaterThanEqual, cst.Or), 2),
    **dict.fromkeys((cst.LessThan, cst.GreaterThan, cst.Add, cst.Subtract, cst.Multiply, cst.Divide), 1),
    cst.And: 3,
}
"""The lengths of operators."""


def _comparison(places: Places, node: cst.Comparison, at: int) -> int:
    at = places.expression(node.left, at)
    for target in node.comparisons:
        start = at
        at = places.expression(target.comparator, _operator(places, target.operator, at))
        places.note(target, start, at)
    return at


def _binary(places: Places, node: cst.BinaryOperation, at: int) -> int:
    return places.expression(node.right, _operator(places, node.operator, places.expression(node.left, at)))


def _boolean(places: Places, node: cst.BooleanOperation, at: int) -> int:
    """``a and b and c``: libcst nests as many of them as there are terms, so it goes down without recursion."""
    above = [node]
    while isinstance(left := above[-1].left, cst.BooleanOperation) and not left.lpar:
        above.append(left)
    start, at = at, places.expression(left, at)
    while above:
        node = above.pop()
        at = places.note(node, start, places.expression(node.right, _operator(places, node.operator, at)))
    return at


def _unary(places: Places, node: cst.UnaryOperation, at: int) -> int:
    operator = node.operator
    width = 3 if operator.__class__ is cst.Not else 1
    return places.expression(node.expression, places.blank(operator.whitespace_after, at + width))


def _lambda(places: Places, node: cst.Lambda, at: int) -> int:
    at += 6
    if isinstance(node.whitespace_after_lambda, cst.BaseParenthesizableWhitespace):
        at = places.blank(node.whitespace_after_lambda, at)
    at = places.written_out(node.params, at) if has_parameters(node.params) else places.note(node.params, at, at)
    return places.expression(node.body, places.around(node.colon, at))


def has_parameters(node: cst.Parameters) -> bool:
    """True for a routine or a lambda with parameters."""
    return bool(
        node.params
        or node.kwonly_params
        or node.posonly_params
        or node.star_kwarg is not None
        or not isinstance(node.star_arg, cst.MaybeSentinel)
    )


def _strings(places: Places, node: cst.ConcatenatedString, at: int) -> int:
    """``"a" "b" "c"``: libcst nests as many of them as there are pieces, so it goes down without recursion."""
    above: list[tuple[cst.ConcatenatedString, int]] = []
    last: cst.BaseExpression = node
    while isinstance(last, cst.ConcatenatedString) and not (above and last.lpar):
        above.append((last, at))
        at = places.blank(last.whitespace_between, places.expression(last.left, at))
        last = last.right
    end = places.expression(last, at)
    for one, start in above:
        places.note(one, start, end)
    return end


_INNER: dict[type[Node], Callable[[Places, Any, int], int]] = {
    cst.Name: _token,
    cst.Integer: _token,
    cst.Float: _token,
    cst.SimpleString: _token,
    cst.Attribute: _attribute,
    cst.Subscript: _subscript,
    cst.Call: _call,
    cst.Tuple: _tuple,
    cst.List: _list,
    cst.Comparison: _comparison,
    cst.BinaryOperation: _binary,
    cst.BooleanOperation: _boolean,
    cst.UnaryOperation: _unary,
    cst.Lambda: _lambda,
    cst.ConcatenatedString: _strings,
}
"""How each kind of expression is passed, its parentheses left out."""


# -- statements -------------------------------------------------------------------------------------------------------


def _lines(places: Places, lines: Sequence[cst.EmptyLine], at: int) -> int:
    """Blank lines and comments."""
    for line in lines:
        at += len(line.whitespace.value) + (places.indent_width if line.indent else 0)
        if line.comment is not None:
            at = places.note(line.comment, at, at + len(line.comment.value))
        at += 1 if line.newline.value is None else len(line.newline.value)
    return at


def _end_of_line(places: Places, node: cst.TrailingWhitespace, at: int) -> int:
    at += len(node.whitespace.value)
    if node.comment is not None:
        at = places.note(node.comment, at, at + len(node.comment.value))
    return at + (1 if node.newline.value is None else len(node.newline.value))


def _smalls(places: Places, nodes: Sequence[cst.BaseSmallStatement], at: int) -> int:
    """Statements that share a line, and the semicolons between them."""
    for node in nodes:
        kind = node.__class__
        start = at
        if kind is cst.Expr and isinstance(node, cst.Expr):
            at = places.note(node, start, places.expression(node.value, at))
        elif kind is cst.Pass:
            at = places.note(node, start, start + 4)
        else:
            at = places.written_out(node, at)
            continue
        if isinstance(node.semicolon, cst.Semicolon):
            at = places.around(node.semicolon, at)
    return at


def _line(places: Places, node: cst.SimpleStatementLine, at: int) -> int:
    at = start = _lines(places, node.leading_lines, at) + places.indent_width
    at = _smalls(places, node.body, at)
    places.note(node, start, places.of(node.body[-1])[1])
    return _end_of_line(places, node.trailing_whitespace, at)


def _suite(places: Places, node: cst.SimpleStatementSuite, at: int) -> int:
    at = start = at + len(node.leading_whitespace.value)
    at = _smalls(places, node.body, at)
    places.note(node, start, places.of(node.body[-1])[1])
    return _end_of_line(places, node.trailing_whitespace, at)


def _block(places: Places, node: cst.IndentedBlock, at: int) -> int:
    return places.block(node, _end_of_line(places, node.header, at))


def _if(places: Places, node: cst.If, at: int, word: int = 2) -> int:
    """An ``if``, or an ``elif`` with a word of four letters."""
    at = start = _lines(places, node.leading_lines, at) + places.indent_width
    at = places.expression(node.test, places.blank(node.whitespace_before_test, at + word))
    at = places.other(node.body, places.blank(node.whitespace_after_test, at) + 1)
    last: Node = node.body
    if node.orelse is not None:
        last = node.orelse
        at = _if(places, node.orelse, at, 4) if isinstance(node.orelse, cst.If) else places.other(last, at)
    places.note(node, start, places.of(last)[1])
    return at


def _else(places: Places, node: cst.Else, at: int) -> int:
    at = start = _lines(places, node.leading_lines, at) + places.indent_width
    at = places.other(node.body, places.blank(node.whitespace_before_colon, at + 4) + 1)
    places.note(node, start, places.of(node.body)[1])
    return at


_OTHERS: dict[type[Node], Callable[[Places, Any, int], int]] = {
    cst.If: _if,
    cst.Else: _else,
    cst.IndentedBlock: _block,
    cst.SimpleStatementLine: _line,
    cst.SimpleStatementSuite: _suite,
}
"""How the statements of rungs are passed, with the blank lines and comments above them."""
