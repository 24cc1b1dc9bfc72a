"""Where libcst puts the nodes that it writes out: the places of rare statements, by libcst's own code for them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import libcst as cst
from libcst._nodes.internal import CodegenState


class Recorder(CodegenState):
    """What libcst writes into: it counts characters, and notes where each node begins and ends."""

    def __init__(self, table: dict[int, tuple[int, int]], at: int, indents: list[str], default_indent: str) -> None:
        super().__init__(default_indent=default_indent, default_newline="\n", indent_tokens=list(indents))
        self.table = table
        self.at = at
        self._starts: list[int] = []

    def add_token(self, value: str) -> None:
        self.at += len(value)

    def add_indent_tokens(self) -> None:
        self.at += sum(map(len, self.indent_tokens))

    def before_codegen(self, node: cst.CSTNode) -> None:  # noqa: ARG002
        self._starts.append(self.at)

    def after_codegen(self, node: cst.CSTNode) -> None:
        # A place without the parentheses may have been noted already.
        self.table.setdefault(id(node), (self._starts.pop(), self.at))
        if isinstance(node, cst.Subscript):
            self._note_elements(node)

    def _note_elements(self, node: cst.Subscript) -> None:
        """Note where the elements of a subscript are together, a last comma included: they are no node of their own."""
        first, last = node.slice[0], node.slice[-1]
        closing = last.comma if isinstance(last.comma, cst.Comma) else last
        self.table[id(node.slice)] = self.table[id(first)][0], self.table[id(closing)][1]

    @contextmanager
    def record_syntactic_position(
        self, node: cst.CSTNode, *, start_node: cst.CSTNode | None = None, end_node: cst.CSTNode | None = None
    ) -> Iterator[None]:
        start = self.at
        yield
        first = start if start_node is None else self.table[id(start_node)][0]
        self.table[id(node)] = first, self.at if end_node is None else self.table[id(end_node)][1]
