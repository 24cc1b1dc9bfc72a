"""The statements of a file, one after another, each as libcst's tree, which is dropped before the next is made.

Python's own parser says where statements begin and end, and whether a file is Python at all: `pieces.py` and
`parse.py`. libcst then reads each statement by itself, with the comment lines above it. A tree of the whole file takes
twice the time, and a hundred times the memory of the text.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from typing import NamedTuple

import libcst as cst

from clickgen.dialects.if_rungs.read import nodes, pieces
from clickgen.dialects.if_rungs.read.nodes import Node
from clickgen.dialects.if_rungs.read.parse import is_statement, soundness
from clickgen.dialects.if_rungs.read.pieces import RoutineNode
from clickgen.dialects.if_rungs.read.places import Places
from clickgen.text.source import SourceFile, Span

_BLOCK = "if 1:\n"
"""Put above the statements of a block. They keep their indentation: in a text over several lines it counts."""


class Statement(NamedTuple):
    """A statement of the top level. ``body`` has the statements of a routine, to be used up before the next one."""

    node: nodes.Statement
    body: Iterable[nodes.Statement] = ()


class Refused(Exception):
    """Python reads the file and libcst does not: what to say of it, and where."""

    def __init__(self, span: Span, why: str, code: str = "CG101", help: str = "write it in a simpler way") -> None:
        super().__init__(why)
        self.code = code
        self.span = span
        self.message = f"this cannot be read: {why}"
        self.help = help


def read_statements(source: SourceFile, tree: ast.Module, places: Places) -> Iterator[Statement]:
    """The statements of a file of which Python has made a tree; ``places`` has the places of the one that came last.

    Raises Refused.
    """
    return _Reader(source, places).statements(pieces.statements_of(tree))


def read_in_pieces(source: SourceFile, places: Places) -> Iterator[Statement]:
    """The statements of a long file; raises Refused, and ``pieces.Broken`` where a piece cannot be read by itself."""
    return _Reader(source, places).statements(pieces.statements_in_pieces(source, soundness(source)))


class _Lines(NamedTuple):
    """The lines of a statement, or of several that share a line: from the end of what comes before it."""

    start: int
    first: int
    last: int
    """``start`` and ``first`` count from 0, and ``last`` from 1: it is the first of the next."""
    before: str = ""
    """The indentation of the last block of the statement before this one; "" for none."""


class _Reader:
    def __init__(self, source: SourceFile, places: Places) -> None:
        self._source = source
        self._lines = source.lines
        self._places = places
        self._end = 0
        """The last line that was read, from 1."""

    def statements(self, found: Iterable[pieces.Statement]) -> Iterator[Statement]:
        """The statements of the top level."""
        waiting: list[ast.stmt] = []
        """Those that may share a line with the next one."""
        for node, body in found:
            if waiting and not self._shares_line(node):
                yield from map(Statement, self._top(waiting))
                waiting = []
            if isinstance(node, RoutineNode):
                yield self._routine(node, body)
            else:
                waiting.append(node)
        if waiting:
            yield from map(Statement, self._top(waiting))

    def _shares_line(self, node: ast.stmt) -> bool:
        """True for a statement that follows another one on its line."""
        if isinstance(node, RoutineNode | ast.ClassDef):
            return False
        line = self._lines[node.lineno - 1]
        if line.encode()[: node.col_offset].strip():
            return True
        return node.lineno > 1 and _is_joined(self._lines[node.lineno - 2])

    def _top(self, found: Sequence[ast.stmt]) -> list[nodes.Statement]:
        """The trees of a statement of the top level, or of several that share a line."""
        start = self._end
        end = self._end = self._last_line(found[-1])
        text = self._text(start, end)
        tree = self._parsed(text, start)
        default_indent = cst.parse_module(text).default_indent if _has_block(found[0]) else ""
        self._placed([tree], self._source.starts[start], end, "", default_indent)
        return nodes.in_lines([tree])

    # -- routines -----------------------------------------------------------------------------------------------------

    def _routine(self, node: RoutineNode, body: Iterable[ast.stmt]) -> Statement:
        """A routine with its head alone in the tree; the statements of its body follow one by one."""
        own = iter(body)
        first, start = next(own), self._end
        if self._shares_line(first):
            end = self._end = self._last_line(node)
            tree = self._parsed(self._text(start, end), start)
            self._placed([tree], self._source.starts[start], end)
            assert isinstance(tree, cst.FunctionDef)
            return Statement(tree, nodes.statements(tree.body))
        at = _first_line(first) - 1
        indent = _indent_of(self._lines[at])
        head = at
        while head > node.lineno and self._is_blank(head - 1):
            head -= 1
        tree = self._parsed(f"{self._text(start, head)}{indent}pass\n", start)
        assert isinstance(tree, cst.FunctionDef)
        self._places.read([tree], self._source.starts[start], "", indent)
        return Statement(tree, self._body(head, indent, chain([first], own)))

    def _is_blank(self, number: int) -> bool:
        text = self._lines[number].strip()
        return not text or text.startswith("#")

    def _body(self, start: int, indent: str, found: Iterable[ast.stmt]) -> Iterator[nodes.Statement]:
        for lines in self._lines_of(start, found):
            self._end = lines.last
            yield from self._in_block(lines, indent)

    def _lines_of(self, start: int, found: Iterable[ast.stmt]) -> Iterator[_Lines]:
        """The lines of each statement of a block, with what is between it and the one before."""
        inner = next_inner = ""
        first = last = start
        is_open = False
        for node in found:
            if is_open and self._shares_line(node):
                last = self._last_line(node)
                continue
            if is_open:
                yield _Lines(start, first, last, inner)
                start, inner = last, next_inner
            first, last, is_open = _first_line(node) - 1, self._last_line(node), True
            next_inner = self._inner_indent(node)
        if is_open:
            yield _Lines(start, first, last, inner)

    def _in_block(self, lines: _Lines, indent: str) -> list[nodes.Statement]:
        """The statements on these lines of a block with this indentation."""
        above = ""
        if lines.before and any(
            line.lstrip().startswith("#") and line.startswith(lines.before)
            for line in self._lines[lines.start : lines.first]
        ):
            # A comment may belong to the block of the statement before: that one is needed, in a word.
            above = f"{indent}if 1:\n{lines.before}pass\n"
        tree = self._parsed(f"{_BLOCK}{above}{self._text(lines.start, lines.last)}", lines.start)
        assert isinstance(tree, cst.If)
        assert isinstance(tree.body, cst.IndentedBlock)
        start = self._source.starts[lines.start] - len(above)
        self._placed(tree.body.body, start, lines.last, indent, indent)
        return nodes.in_lines(tree.body.body[1:] if above else tree.body.body)

    def _last_line(self, node: ast.stmt) -> int:
        """The line with which a statement ends; the one after it where a backslash joins a blank one to it."""
        last = node.end_lineno or node.lineno
        return last + _is_joined(self._lines[last - 1])

    def _inner_indent(self, node: ast.stmt) -> str:
        """The indentation of a statement's last block; "" for one without a block, or with it on its own line."""
        block = getattr(node, "orelse", None) or getattr(node, "body", None)
        if not isinstance(block, list) or not isinstance(block[0], ast.stmt) or self._shares_line(block[0]):
            return ""
        return _indent_of(self._lines[_first_line(block[0]) - 1])

    # -- libcst -------------------------------------------------------------------------------------------------------

    def _text(self, start: int, end: int) -> str:
        """Whole lines, each with its end: from ``start``, counted from 0, to ``end``, counted from 1."""
        return "\n".join([*self._lines[start:end], ""])

    def _parsed(self, text: str, start: int) -> cst.SimpleStatementLine | cst.BaseCompoundStatement:
        try:
            return cst.parse_statement(text)
        except (cst.ParserSyntaxError, cst.CSTValidationError) as error:
            if "\t" in text:
                help = "indent with four spaces; an editor can turn tabs into spaces"
                raise Refused(self._line(start + 1), "tabs and spaces are mixed", help=help) from None
            message = error.message if isinstance(error, cst.ParserSyntaxError) else str(error)
            raise Refused(self._line(start + 1), message.removeprefix("tokenizer error: ")) from None

    def _placed(self, found: Sequence[Node], at: int, end: int, indent: str = "", default: str = "") -> None:
        """Note the places of statements that begin at this character and end with this line."""
        try:
            is_right = self._places.read(found, at, indent, default) == self._source.starts[end]
        except RecursionError:
            raise Refused(self._line(end), "it is nested too deeply", "CG118") from None
        if not is_right:
            raise Refused(self._line(end), "it is laid out in an unusual way")

    def _line(self, number: int) -> Span:
        return self._source.span(number, 1, number, 2)


def _is_joined(line: str) -> bool:
    """True for a line that a backslash joins to the next one."""
    return line.endswith("\\") and "#" not in line


def _first_line(node: ast.stmt) -> int:
    """The line on which a statement begins, its decorators included."""
    decorators: list[ast.expr] = getattr(node, "decorator_list", [])
    return min([node.lineno, *(one.lineno for one in decorators)])


def _has_block(node: ast.stmt) -> bool:
    return isinstance(getattr(node, "body", None) or getattr(node, "cases", None), list)


def _indent_of(line: str) -> str:
    return line[: len(line) - len(line.lstrip())]


# -- texts by themselves ----------------------------------------------------------------------------------------------


def read_statement(source: SourceFile, places: Places) -> nodes.Statement | None:
    """The single statement that a text is; None where it is none."""
    text = f"{source.text}\n"
    if not is_statement(text):
        return None
    try:
        tree = cst.parse_statement(text)
    except (cst.ParserSyntaxError, cst.CSTValidationError):
        return None
    found = nodes.in_lines([tree])
    if len(found) != 1:
        return None
    places.read([tree], 0, "", cst.parse_module(text).default_indent if len(source.lines) > 1 else "")
    return found[0]


def read_expression(source: SourceFile, places: Places) -> cst.BaseExpression | None:
    """The expression that a text is; None where it is none."""
    statement = read_statement(source, places)
    return statement.value if isinstance(statement, cst.Expr) else None
