"""What every reader of this room needs: the file, the problems so far, and the places of libcst's nodes."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import libcst as cst

from clickgen.dialects.if_rungs.read import statements
from clickgen.dialects.if_rungs.read.nodes import Elements, Node, Statement, string_pieces, text_value
from clickgen.dialects.if_rungs.read.places import Places
from clickgen.dialects.if_rungs.read.remembered import RememberedFile
from clickgen.ir.proposals import Proposal
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.edits import Fix
from clickgen.text.source import EmbeddedText, SourceFile, Span, embedded_text

Located = Node | Elements


@dataclass(frozen=True)
class Context:
    source: SourceFile
    problems: Diagnostics
    proposals: list[Proposal] = field(default_factory=list)
    """The fixes of these problems, each still to be judged."""
    is_trial: bool = False
    """True where it is only asked whether a text can be read: nobody looks for ways out then, which are tried again."""
    places: Places = field(default_factory=Places)
    """Where the nodes of the statement are that is being read."""
    remembered: RememberedFile | None = None
    """What is known of the rungs of this file."""

    def aside(self) -> Context:
        """The same nodes, with problems and proposals that nobody hears of."""
        return Context(self.source, Diagnostics(), places=self.places)

    def of_text(self, text: str, is_trial: bool = True) -> Context:
        """A text by itself, with problems of its own."""
        return Context(SourceFile(self.source.path, text), Diagnostics(), is_trial=is_trial or self.is_trial)

    def expression(self) -> cst.BaseExpression | None:
        """The expression that the whole text is; None where it is none."""
        return statements.read_expression(self.source, self.places)

    def statement(self) -> Statement | None:
        """The statement that the whole text is; None where it is none."""
        return statements.read_statement(self.source, self.places)

    def extent(self, node: Located) -> tuple[int, int]:
        """Where a node begins and ends in the text, as Python counts it: see ``_EXTENTS``."""
        start, end = self.places.of(node)
        extent = _EXTENTS.get(node.__class__)
        return extent(self, node, start, end) if extent else (start, end)

    def span(self, node: Located) -> Span:
        """Where a node is."""
        start, end = self.places.table[id(node)]
        if node.__class__ in _EXTENTS:
            start, end = self.extent(node)
        source = self.source
        line = bisect_right(source.starts, start)
        first = source.starts[line - 1]
        if end < source.starts[line]:
            return Span(source.path, line, start - first + 1, line, end - first + 1)
        return self.stretch(start, end)

    def stretch(self, start: int, end: int) -> Span:
        """A stretch of the text, counted from 0, as a span."""
        starts = self.source.starts
        line, end_line = bisect_right(starts, start), bisect_right(starts, end)
        first, last = starts[line - 1], starts[end_line - 1]
        return Span(self.source.path, line, start - first + 1, end_line, end - last + 1)

    def text(self, node: Located) -> str:
        """A node as written."""
        start, end = self.extent(node)
        return self.source.text[start:end]

    def embedded(self, node: Node) -> EmbeddedText:
        """The value of a string literal with the place of each of its characters."""
        value = str(text_value(node))
        return embedded_text(self.source, list(self._pieces(node)), value)

    def _pieces(self, node: Node) -> Iterator[tuple[str, int, int]]:
        for piece in string_pieces(node):
            span = self.span(piece)
            yield self.text(piece), span.line, span.col

    def problem(self, code: str, node: Located, message: str, help: str = "", fix: Fix | None = None) -> None:
        """Report a problem at a node."""
        self.problems.add(code, self.span(node), message, help, fix=fix)


# -- where Python counts otherwise than libcst ------------------------------------------------------------------------


def _with_parentheses(context: Context, node: cst.Tuple, start: int, end: int) -> tuple[int, int]:
    """The parentheses of a tuple are a part of it."""
    return (context.places.of(node.lpar[-1])[0], context.places.of(node.rpar[0])[1]) if node.lpar else (start, end)


def _generator(context: Context, _: cst.GeneratorExp, start: int, end: int) -> tuple[int, int]:
    """The parentheses of a generator are a part of it, also where they are those of a call."""
    text = context.source.text
    return text.rindex("(", 0, start), text.index(")", end) + 1


_SEMICOLON = re.compile(r"[ \t]*;")


def _with_semicolon(context: Context, _: Node, start: int, end: int) -> tuple[int, int]:
    """A semicolon behind the last statement of a block is a part of what holds the block."""
    semicolon = _SEMICOLON.match(context.source.text, end)
    return start, semicolon.end() if semicolon else end


_EXTENTS: dict[type, Callable[[Context, Any, int, int], tuple[int, int]]] = {
    cst.Tuple: _with_parentheses,
    cst.GeneratorExp: _generator,
    **dict.fromkeys(
        (cst.If, cst.For, cst.While, cst.With, cst.Try, cst.TryStar, cst.Match, cst.FunctionDef, cst.ClassDef),
        _with_semicolon,
    ),
}
