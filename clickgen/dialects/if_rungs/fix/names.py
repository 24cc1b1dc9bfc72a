"""Where the names of a source file are, to the character, also inside the strings of formulas."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property
from keyword import iskeyword

import libcst as cst

from clickgen.dialects.base import NamePlaces, Place
from clickgen.dialects.if_rungs.fix.statement import Statements
from clickgen.dialects.if_rungs.read.nodes import Node, index_of, text_value
from clickgen.dialects.if_rungs.read.statements import layout_of
from clickgen.ir.operands import Named
from clickgen.ir.program import FormulaText
from clickgen.text.source import EmbeddedText, SourceFile, Span
from clickgen.text.wording import word_pattern

_IN_FORMULA = re.compile(r"""\w++\s*+(?:\.\s*(?P<plain>\w+)|\[\s*(?:"(?P<double>[^"\n]*)"|'(?P<single>[^'\n]*)'))""")
_ESCAPE = re.compile(r"\\(?:[0-7]{1,3}|x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|N\{[^}]*\}|.)")


class FilePlaces(NamePlaces):
    """The names of one file; ``formulas`` are all that it has."""

    def __init__(self, source: SourceFile, formulas: Sequence[FormulaText]) -> None:
        self.source = source
        self.formulas = formulas
        self._statements = Statements(source)

    def takes(self, named: Named, name: str) -> bool:
        _, is_plain, in_formula = self._found(named)
        return not is_plain or (name.isidentifier() and (in_formula or not iskeyword(name)))

    def place(self, named: Named) -> Place:
        return Place(self._found(named)[0])

    def _found(self, named: Named) -> tuple[tuple[Span, ...], bool, bool]:
        """Where a name is, whether only a plain word can be written there, and whether that is in a formula."""
        node = self._statements.node(named.span)
        if isinstance(node, cst.Subscript) and named.part is not None:
            # ds.Recipe[3] and ds["Door alarms"][0:4]: the name is before the index.
            node = node.value
        if node is None:
            text, start = self._characters(named.span)
            match = _IN_FORMULA.match(text.value, start)
            assert match is not None
            group = next(group for group, name in match.groupdict().items() if name is not None)
            return _stretches(text, *match.span(group)), group == "plain", True
        index = index_of(node) if isinstance(node, cst.Subscript) else None
        if isinstance(index, Node) and text_value(index) is not None:
            text = self._statements.context.embedded(index)
            return _stretches(text, 0, len(text.value)), False, False
        assert isinstance(node, cst.Attribute)
        return (self._statements.context.span(node.attr),), True, False

    @cached_property
    def _formulas_by_line(self) -> dict[int, list[FormulaText]]:
        found: dict[int, list[FormulaText]] = {}
        for formula in self.formulas:
            for line in range(formula.span.line, formula.span.end_line + 1):
                found.setdefault(line, []).append(formula)
        return found

    def _characters(self, span: Span) -> tuple[EmbeddedText, int]:
        """The text of the formula that has a name at this place, and the character with which the name begins."""
        for formula in self._formulas_by_line[span.line]:
            node = self._statements.node(formula.span)
            assert node is not None
            text = self._statements.context.embedded(node)
            if (span.line, span.col) in text.positions[:-1]:
                return text, text.positions.index((span.line, span.col))
        raise LookupError(span)


def _stretches(text: EmbeddedText, start: int, end: int) -> tuple[Span, ...]:
    """The place of ``value[start:end]`` in the file, without the quotes and line ends between its pieces."""
    source = text.source
    stretches: list[Span] = []
    for line, col in text.positions[start:end]:
        raw = source.line(line)
        escape = _ESCAPE.match(raw, col - 1)
        stop = col + (len(escape[0]) if escape else 1)
        if stretches and stretches[-1][3:5] == (line, col):
            stretches[-1] = stretches[-1]._replace(end_col=stop)
        else:
            stretches.append(source.span(line, col, line, stop))
    return tuple(stretches)


def comments_with(source: SourceFile, word: str) -> int:
    """How many comments of a file hold this word, in any case."""
    wanted = word_pattern(word)
    if not wanted.search(source.text):
        return 0
    layout = layout_of(source)
    if layout is None:
        return 0
    parts = (part for part in layout.parts if wanted.search(layout.text(part)))
    return sum(wanted.search(comment.text) is not None for part in parts for comment in layout.comments(part))
