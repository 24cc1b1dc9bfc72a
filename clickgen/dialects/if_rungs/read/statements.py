"""The statements of a file, one after another, each as libcst's tree, which is dropped before the next is made.

Python's own parser says where statements begin and end, and whether a file is Python at all: `pieces.py` and
`parse.py`. libcst then reads each statement by itself, with the comment lines above it. A tree of the whole file takes
twice the time, and a hundred times the memory of the text.
"""

from __future__ import annotations

import ast
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from itertools import chain
from typing import NamedTuple

import libcst as cst

from clickgen.dialects.if_rungs.read import nodes, pieces
from clickgen.dialects.if_rungs.read.nodes import Node
from clickgen.dialects.if_rungs.read.parse import SPLIT, TOO_DEEP, deep_bracket, is_statement, sound_tree, soundness
from clickgen.dialects.if_rungs.read.pieces import RoutineNode
from clickgen.dialects.if_rungs.read.places import Places
from clickgen.text.source import SourceFile, Span

_SIMPLER = "write it in a simpler way"
_BLOCK = "if 1:\n"
"""Put above the statements of a block. They keep their indentation: in a text over several lines it counts."""


_REFUSALS = (cst.ParserSyntaxError, cst.CSTValidationError, TypeError)
"""What libcst raises for a text that it does not read; a TypeError for ``not(lambda: a)`` (libcst 1.9.0)."""


class Piece(NamedTuple):
    """Statements of a routine that are read at once: one, or several that share a line."""

    text: str
    """All that the reading depends on; "" where they are read with their routine."""
    base: int
    """The line before the first, from 1."""
    read: Callable[[], Sequence[nodes.Statement]]
    """Gives libcst's nodes, whose places are noted until the next piece is read. Raises Refused."""


class Statement(NamedTuple):
    """A statement of the top level. ``body`` has the statements of a routine, to be used up before the next one."""

    node: nodes.Statement
    body: Iterable[Piece] = ()


class Refused(Exception):
    """Python reads the file and libcst does not: what to say of it, and where."""

    def __init__(self, span: Span, message: str, help: str, code: str = "CG101") -> None:
        super().__init__(message)
        self.code = code
        self.span = span
        self.message = message
        self.help = help


def read_statements(source: SourceFile, tree: ast.Module, places: Places) -> Iterator[Statement]:
    """The statements of a file of which Python has made a tree; ``places`` has the places of the one that came last.

    Raises Refused.
    """
    return Reader(source, places).statements(pieces.statements_of(tree))


def read_in_pieces(source: SourceFile, places: Places) -> Iterator[Statement]:
    """The statements of a long file; raises Refused, and ``pieces.Broken`` where a piece cannot be read by itself."""
    return Reader(source, places).statements(pieces.statements_in_pieces(source, soundness(source)))


class Part(NamedTuple):
    """Lines that libcst reads at once: a statement, or several that share a line, from the end of what comes before.

    For a routine it is the head; its body has parts of its own.
    """

    start: int
    """The line before the first, from 1."""
    last: int
    ending: str = ""
    """Put below: ``pass``, for a head without its body."""
    indent: str = ""
    """The indentation of the block that it is in; "" at the top level."""
    before: str = ""
    """The indentation of the last block of the statement before it; "" for none."""
    has_block: bool = False
    """True for a statement of the top level with a block in it."""


class Reader:
    """The statements of a file. ``places`` has the places of the one that came last."""

    def __init__(self, source: SourceFile, places: Places) -> None:
        self._source = source
        self._lines = source.lines
        self._places = places
        self._end = 0
        """The last line of the parts that were found."""

    def statements(self, found: Iterable[pieces.Statement]) -> Iterator[Statement]:
        """The statements of the top level."""
        for part, body in self._parts(found):
            for node in self.read(part):
                inner: Iterable[Piece] = map(self._piece, body)
                if part.ending == "" and isinstance(node, cst.FunctionDef):
                    inner = (Piece("", part.start, partial(nodes.statements, node.body)),)
                yield Statement(node, inner)

    def parts(self, found: Iterable[pieces.Statement]) -> Iterator[Part]:
        """All parts of a file; the last has what is below its last statement."""
        for part, body in self._parts(found):
            yield part
            yield from body
        yield Part(self._end, len(self._lines), "pass\n")

    def _piece(self, part: Part) -> Piece:
        return Piece(self._above(part) + self._text(part), part.start, partial(self.read, part))

    def _text(self, part: Part) -> str:
        return "\n".join([*self._lines[part.start : part.last], part.ending])

    def _above(self, part: Part) -> str:
        """A comment may belong to the block of the statement before: then that one is needed, in a word."""
        if part.before and self._has_inner_comment(part):
            return f"{part.indent}if 1:\n{part.before}pass\n"
        return ""

    def read(self, part: Part) -> list[nodes.Statement]:
        """The statements of a part, whose places are noted. Raises Refused."""
        starts, text = self._source.starts, self._text(part)
        deep = deep_bracket(text)
        if deep is not None:
            line, col = part.start + deep[0], deep[1]
            raise Refused(self._source.span(line, col, line, col + 1), TOO_DEEP, SPLIT, "CG118")
        if not part.indent:
            tree = self._parsed(text, part)
            default_indent = part.ending.removesuffix("pass\n")
            if part.has_block:
                default_indent = cst.parse_module(text).default_indent
            self._note([tree], part, starts[part.start], "", default_indent)
            return nodes.in_lines([tree])
        above = self._above(part)
        block = self._parsed(f"{_BLOCK}{above}{text}", part)
        assert isinstance(block, cst.If)
        assert isinstance(block.body, cst.IndentedBlock)
        lines = block.body.body
        self._note(lines, part, starts[part.start] - len(above), part.indent, part.indent)
        return nodes.in_lines(lines[1:] if above else lines)

    # -- parts --------------------------------------------------------------------------------------------------------

    def _parts(self, found: Iterable[pieces.Statement]) -> Iterator[tuple[Part, Iterator[Part]]]:
        """The parts of the top level, each with those of a routine's body, to be used up before the next one."""
        waiting: list[ast.stmt] = []
        """Those that may share a line with the next one."""
        for node, body in found:
            if waiting and not self._shares_line(node):
                yield self._top(waiting), iter(())
                waiting = []
            if isinstance(node, RoutineNode):
                yield self._routine(node, iter(body))
            else:
                waiting.append(node)
        if waiting:
            yield self._top(waiting), iter(())

    def _top(self, found: Sequence[ast.stmt]) -> Part:
        start, self._end = self._end, self._last_line(found[-1])
        return Part(start, self._end, has_block=not isinstance(found[0], _SIMPLE))

    def _routine(self, node: RoutineNode, body: Iterator[ast.stmt]) -> tuple[Part, Iterator[Part]]:
        first, start = next(body), self._end
        if self._shares_line(first):
            self._end = self._last_line(node)
            return Part(start, self._end), iter(())
        head = _first_line(first) - 1
        indent = _indent_of(self._lines[head])
        while head > node.lineno and self._is_blank(head):
            head -= 1
        self._end = head
        return Part(start, head, f"{indent}pass\n"), self._body(indent, chain([first], body))

    def _body(self, indent: str, found: Iterable[ast.stmt]) -> Iterator[Part]:
        """The parts of a routine's body."""
        before = inner = ""
        last = 0
        for node in found:
            if last and not self._shares_line(node):
                start, self._end = self._end, last
                yield Part(start, last, "", indent, before)
                before = inner
            last, inner = self._last_line(node), self._inner_indent(node)
        start, self._end = self._end, last
        yield Part(start, last, "", indent, before)

    def _shares_line(self, node: ast.stmt) -> bool:
        """True for a statement that follows another one on its line."""
        line = self._lines[node.lineno - 1]
        before = line[: node.col_offset] if line.isascii() else line.encode()[: node.col_offset]
        if before and not before.isspace():
            return True
        return node.lineno > 1 and _is_joined(self._lines[node.lineno - 2])

    def _is_blank(self, number: int) -> bool:
        """True for a line without code."""
        text = self._lines[number - 1].strip()
        return not text or text.startswith("#")

    def _last_line(self, node: ast.stmt) -> int:
        """The line with which a statement ends; the one after it where a backslash joins a blank one to it."""
        last = node.end_lineno or node.lineno
        return last + _is_joined(self._lines[last - 1])

    def _inner_indent(self, node: ast.AST) -> str:
        """The indentation of a statement's last block; "" for one without a block, or with it on its own line."""
        block: Sequence[ast.AST] = []
        for name in _BLOCKS:
            block = getattr(node, name, None) or block
        first = block[0] if block else None
        if isinstance(first, _ARMS):
            return self._inner_indent(block[-1])
        if not isinstance(first, ast.stmt) or self._shares_line(first):
            return ""
        line = self._lines[_first_line(first) - 1]
        if isinstance(first, ast.If) and line.lstrip().startswith("elif"):
            return self._inner_indent(first)
        return _indent_of(line)

    def _has_inner_comment(self, part: Part) -> bool:
        """True where a comment above a part is indented like the block before it."""
        for line in self._lines[part.start : part.last]:
            text = line.lstrip()
            if text and not text.startswith("#"):
                return False
            if text and line.startswith(part.before):
                return True
        return False

    # -- libcst -------------------------------------------------------------------------------------------------------

    def _parsed(self, text: str, part: Part) -> cst.SimpleStatementLine | cst.BaseCompoundStatement:
        try:
            return cst.parse_statement(text)
        except _REFUSALS as error:
            span = self._span(part.start + 1)
            if "\t" in text:
                help = "indent with four spaces; an editor can turn tabs into spaces"
                raise Refused(span, "tabs and spaces are mixed", help) from None
            why = error.message if isinstance(error, cst.ParserSyntaxError) else str(error)
            if isinstance(error, TypeError) or why.startswith("Must have at least one space"):
                why = "a blank is missing beside a word such as if, not or and"
                help = "put a blank between the word and the parenthesis beside it"
                raise Refused(span, f"this cannot be read: {why}", help) from None
            raise Refused(span, f"this cannot be read: {why}", _SIMPLER) from None

    def _note(self, found: Sequence[Node], part: Part, at: int, indent: str, default_indent: str) -> None:
        """Note the places of statements that begin at this character."""
        try:
            end = self._places.read(found, at, indent, default_indent)
        except RecursionError:
            raise Refused(self._span(part.last), TOO_DEEP, SPLIT, "CG118") from None
        if end != self._source.starts[part.last] + len(part.ending):
            raise Refused(self._span(part.last), "this cannot be read: its layout is unusual", _SIMPLER)

    def _span(self, line: int) -> Span:
        return self._source.span(line, 1, line, 2)


_BLOCKS = ("body", "cases", "handlers", "orelse", "finalbody")
"""Where a statement has its blocks, in the order of the text."""
_ARMS = (ast.ExceptHandler, ast.match_case)
_SIMPLE = (
    ast.Expr,
    ast.Import,
    ast.ImportFrom,
    ast.Assign,
    ast.AugAssign,
    ast.AnnAssign,
    ast.Return,
    ast.Delete,
    ast.Raise,
    ast.Assert,
    ast.Global,
    ast.Nonlocal,
    ast.Pass,
    ast.Break,
    ast.Continue,
)


def _is_joined(line: str) -> bool:
    """True for a line that a backslash joins to the next one."""
    return line.endswith("\\") and "#" not in line


def _first_line(node: ast.stmt) -> int:
    """The line on which a statement begins, its decorators included."""
    decorators: list[ast.expr] = getattr(node, "decorator_list", [])
    return min([node.lineno, *(one.lineno for one in decorators)])


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
    except _REFUSALS:
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


# -- comments ---------------------------------------------------------------------------------------------------------


class CommentAt(NamedTuple):
    """A comment, and where its # is."""

    line: int
    col: int
    text: str
    stands_alone: bool
    """True for one without code before it on its line."""


class Layout:
    """The parts of a file that is Python, to be read one by one, in any order."""

    def __init__(self, source: SourceFile, tree: ast.Module) -> None:
        self.tree = tree
        """Where Python says that statements begin and end."""
        self.places = Places()
        self._source = source
        self._reader = Reader(source, self.places)
        self.parts = list(self._reader.parts(pieces.statements_of(tree)))

    def text(self, part: Part) -> str:
        """The lines of a part."""
        starts = self._source.starts
        return self._source.text[starts[part.start] : starts[part.last]]

    def nodes(self, part: Part) -> Iterator[Node]:
        """Every node of a part, blanks and comments included; none of what libcst does not read."""
        with suppress(Refused):
            self._reader.read(part)
            for root in self.places.roots:
                yield from nodes.every(root)

    def comments(self, part: Part) -> list[CommentAt]:
        """The comments of a part, in the order of the text."""
        starts = sorted(
            (self.places.of(node)[0], node.value) for node in self.nodes(part) if isinstance(node, cst.Comment)
        )
        return [self._comment(start, text) for start, text in starts]

    def _comment(self, start: int, text: str) -> CommentAt:
        line = bisect_right(self._source.starts, start)
        before = self._source.text[self._source.starts[line - 1] : start]
        return CommentAt(line, len(before) + 1, text, not before.strip())


def layout_of(source: SourceFile) -> Layout | None:
    """The parts of a file; None where it is not Python."""
    tree = sound_tree(source)
    return None if tree is None else Layout(source, tree)
