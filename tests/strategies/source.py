"""A program's text with the places of its grammar."""

from __future__ import annotations

import ast
import re
import warnings
from functools import cached_property
from itertools import accumulate

Span = tuple[int, int]
Edit = tuple[int, int, str]
"""The start and end of a stretch, and its new text."""


class Source:
    """A program's text with the places of its parts; a text that is not Python has lines and brackets only."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._lines = re.findall(r"[^\n]*\n|[^\n]+", text)
        self._starts = [0, *accumulate(len(line) for line in self._lines)]

    @cached_property
    def nodes(self) -> list[ast.AST]:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                tree = ast.parse(self.text)
            return [node for node in ast.walk(tree) if hasattr(node, "end_col_offset")]
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return []

    def every(self, *kinds: type[ast.AST]) -> list[ast.AST]:
        return [node for node in self.nodes if isinstance(node, kinds)]

    def calls(self) -> list[ast.Call]:
        return [node for node in self.nodes if isinstance(node, ast.Call)]

    def span(self, node: ast.AST) -> Span:
        """From the first character to after the last; ``ast`` counts bytes."""
        line, column = getattr(node, "lineno", 1), getattr(node, "col_offset", 0)
        end_line, end_column = getattr(node, "end_lineno", line), getattr(node, "end_col_offset", column)
        return self._offset(line, column), self._offset(end_line, end_column)

    def _offset(self, line: int, column: int) -> int:
        line = min(line, len(self._lines))
        text = self._lines[line - 1]
        return self._starts[line - 1] + len(text.encode("utf-8", "surrogatepass")[:column].decode("utf-8", "ignore"))

    def of(self, node: ast.AST) -> str:
        start, end = self.span(node)
        return self.text[start:end]

    def lines(self) -> list[Edit]:
        return [(start, start + len(line), line) for start, line in zip(self._starts, self._lines, strict=False)]

    def edited(self, *edits: Edit) -> str:
        text = self.text
        for start, end, new in sorted(edits, reverse=True):
            text = text[:start] + new + text[end:]
        return text
