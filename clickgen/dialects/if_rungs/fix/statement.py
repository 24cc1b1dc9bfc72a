"""Writes a part of one statement otherwise: the statement is read again by libcst, and every other byte stays.

Comments that silence findings and endings that are added stay edits of the text, and so does every fix of a line that
cannot be read: libcst reads no broken statement, and a comment at the end of a line belongs to no rung.
"""

from __future__ import annotations

from bisect import bisect_left
from functools import cached_property
from typing import NamedTuple

import libcst as cst
from libcst._nodes.internal import CodegenState

from clickgen.dialects.if_rungs.fix.logic import absorbed
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import Node
from clickgen.dialects.if_rungs.read.statements import Layout, Part, layout_of
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.edits import Edit
from clickgen.text.source import SourceFile, Span


class Statements:
    """The statements of a file that is Python. One at a time is read, when something in it is asked for."""

    def __init__(self, source: SourceFile) -> None:
        self.source = source
        self._last: _Found | None = None

    @cached_property
    def context(self) -> Context:
        """The places of the statement that was read last."""
        return Context(self.source, Diagnostics(), places=self._layout.places)

    def node(self, span: Span) -> cst.BaseExpression | None:
        """The expression with this span, without the parentheses around it."""
        return self._read(span.line).expressions.get(span)

    def head(self, word: Span) -> cst.If | cst.Else | None:
        """The ``if``, ``elif`` or ``else`` that begins with this word."""
        return self._read(word.line).heads.get((word.line, word.col))

    def holders(self, line: int) -> list[cst.Call | cst.List | cst.Tuple]:
        """The calls and lists of the statement in this line."""
        kinds = cst.Call | cst.List | cst.Tuple
        return [node for node in self._read(line).expressions.values() if isinstance(node, kinds)]

    def edit(self, old: cst.BaseExpression, new: cst.BaseExpression) -> Edit | None:
        """The edit that puts an expression in the place of one of the statement that was read last.

        Parentheses around the old one become those of a call, if no comment is beside them. None
        for one that is nested too deeply.
        """
        start, end = self.context.extent(old)
        if isinstance(new, cst.Call) and old.lpar and self._may_absorb(old):
            start, end = self.context.places.of(old.lpar[-1])[0], self.context.places.of(old.rpar[0])[1]
            new = absorbed(new, old.lpar[-1], old.rpar[0])
        text = self.text(new, start)
        return None if text is None else Edit(self.context.stretch(start, end), text)

    def extent(self, node: cst.BaseExpression) -> tuple[int, int]:
        """Where an expression begins and ends in the text, with the parentheses around it."""
        if not node.lpar:
            return self.context.extent(node)
        return self.context.places.of(node.lpar[0])[0], self.context.places.of(node.rpar[-1])[1]

    def text(self, node: Node, at: int) -> str | None:
        """A node as libcst writes it in the block of the last statement that holds this place."""
        assert self._last is not None
        places = self.context.places
        around = sorted((*places.of(block), block.indent) for block in self._last.blocks)
        inner = [indent for first, last, indent in around if first <= at < last]
        indents = [self._last.part.indent, *(places.default_indent if one is None else one for one in inner)]
        state = CodegenState(default_indent="", default_newline="\n", indent_tokens=[*filter(None, indents)])
        try:
            node._codegen(state)
        except RecursionError:
            return None
        return "".join(state.tokens)

    def _may_absorb(self, node: cst.BaseExpression) -> bool:
        """True for parentheses around a node without comments inside, and not beside a word, as in ``if(c.A)``."""
        places, text = self.context.places, self.source.text
        (first, last), (start, end) = (
            self.context.extent(node),
            (places.of(node.lpar[-1])[0], places.of(node.rpar[0])[1]),
        )
        is_beside = text[start - 1 : start].isalnum() or text[start - 1 : start] == "_"
        return not is_beside and "#" not in text[start:first] + text[last:end]

    # -- reading ------------------------------------------------------------------------------------------------------

    @cached_property
    def _layout(self) -> Layout:
        layout = layout_of(self.source)
        assert layout is not None
        return layout

    @cached_property
    def _starts(self) -> list[int]:
        return [part.start for part in self._layout.parts]

    def _read(self, line: int) -> _Found:
        """What the statement in this line holds; the one that was read last is kept."""
        part = self._layout.parts[bisect_left(self._starts, line) - 1]
        if self._last is None or self._last.part is not part:
            found = self._last = _Found(part, {}, {}, [])
            for node in self._layout.nodes(part):
                if isinstance(node, cst.BaseExpression):
                    found.expressions.setdefault(self.context.span(node), node)
                elif isinstance(node, cst.If | cst.Else):
                    span = self.context.span(node)
                    found.heads[span.line, span.col] = node
                elif isinstance(node, cst.IndentedBlock):
                    found.blocks.append(node)
        return self._last


class _Found(NamedTuple):
    """What a part of a file holds."""

    part: Part
    expressions: dict[Span, cst.BaseExpression]
    heads: dict[tuple[int, int], cst.If | cst.Else]
    blocks: list[cst.IndentedBlock]
