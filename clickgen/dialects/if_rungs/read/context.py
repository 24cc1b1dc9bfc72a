"""What every reader of this room needs: the file, the problems so far, and spans of ast nodes."""

from __future__ import annotations

import ast
import io
import tokenize
from dataclasses import dataclass, field

from clickgen.ir.proposals import Proposal
from clickgen.problems.diagnostics import Diagnostics, Fix
from clickgen.text.source import EmbeddedText, SourceFile, Span, embedded_text

Located = ast.expr | ast.stmt | ast.keyword | ast.arg


@dataclass(frozen=True)
class Context:
    source: SourceFile
    problems: Diagnostics
    proposals: list[Proposal] = field(default_factory=list)
    """The fixes of these problems, each still to be judged."""
    is_trial: bool = False
    """True where it is only asked whether a text can be read: nobody looks for ways out then, which are tried again."""

    def span(self, node: Located) -> Span:
        """Where a node stands."""
        end_line = node.end_lineno or node.lineno
        end = node.end_col_offset or node.col_offset
        source = self.source
        if source.is_ascii:
            return Span(source.path, node.lineno, node.col_offset + 1, end_line, end + 1)
        return Span(
            source.path,
            node.lineno,
            source.column(node.lineno, node.col_offset),
            end_line,
            source.column(end_line, end),
        )

    def text(self, node: ast.expr) -> str:
        """A node as written."""
        if node.lineno != node.end_lineno:
            return ast.get_source_segment(self.source.text, node) or ""
        span = self.span(node)
        return self.source.line(span.line)[span.col - 1 : span.end_col - 1]

    def embedded(self, node: ast.Constant) -> EmbeddedText:
        """The value of a string literal with the place of each of its characters."""
        span = self.span(node)
        raw = self.text(node)
        value = str(node.value)
        if raw == f'"{value}"' or raw == f"'{value}'":
            return embedded_text(self.source, [(raw, span.line, span.col)], value)
        parts = []
        for token in tokenize.generate_tokens(io.StringIO(f"({raw})").readline):
            if token.type == tokenize.STRING:
                row, col = token.start
                first = span.col - 1 if row == 1 else 1
                parts.append((token.string, span.line + row - 1, col + first))
        return embedded_text(self.source, parts, value)

    def problem(self, code: str, node: Located, message: str, help: str = "", fix: Fix | None = None) -> None:
        self.problems.add(code, self.span(node), message, help, fix=fix)
