"""Comments that silence findings: ``# clickgen: ignore[CG501] reason`` and ``# clickgen: file-ignore[CG504]``.

Behind code a comment speaks of its line; on a line of its own of the rung or statement below it.
"""

from __future__ import annotations

import ast
import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from clickgen.problems.codes import CODES, Severity
from clickgen.problems.diagnostics import Diagnostic, Diagnostics, did_you_mean
from clickgen.problems.silence import UNUSED, Directive, silenceable
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import SourceFile, Span

if TYPE_CHECKING:
    from clickgen.dialects.if_rungs.read.statements import CommentAt, Layout

_DIRECTIVE = re.compile(
    r"#\s*(?P<name>clickgen)(?P<colon>\s*:)?\s*(?P<word>[\w-]*)\s*(?:\[(?P<codes>[^\]#]*)\])?", re.IGNORECASE
)
_WORDS = ("ignore", "file-ignore")


def read_directives(source: SourceFile, problems: Diagnostics) -> list[Directive]:
    """Every directive of a file; what looks like one and is none is a problem."""
    if "clickgen" not in source.text.lower():
        return []
    # Heavy, and needed for a file with such a comment alone.
    from clickgen.dialects.if_rungs.read.statements import layout_of

    layout = layout_of(source)
    if layout is None:
        return []
    statements = _Statements(layout.tree)
    found: list[Directive] = []
    for part in layout.parts:
        if "clickgen" not in layout.text(part).lower():
            continue
        for comment in layout.comments(part):
            for match in _directives_in(comment.text):
                line, col = comment.line, comment.col
                span = source.span(line, col + match.start(), line, col + match.end())
                found += _read(source, span, match, comment.stands_alone, statements, problems)
    return found


def _directives_in(comment: str) -> Iterator[re.Match[str]]:
    """What speaks to clickgen in a comment; one that only names it does not."""
    for match in _DIRECTIVE.finditer(comment):
        if match["colon"] or (match["word"].lower() in _WORDS and match["codes"] is not None):
            yield match


def _is_well_written(match: re.Match[str]) -> bool:
    return match["name"] == "clickgen" and match["colon"] == ":" and match["word"] in _WORDS


class _Statements:
    """The statements of a file, by line."""

    def __init__(self, tree: ast.Module) -> None:
        self.heads: dict[int, tuple[int, int]] = {}
        """What a comment after code on a line speaks of, where that is more than the line: decorators and their def."""
        self.starts: dict[int, tuple[int, int]] = {}
        """What a comment above a line speaks of; between a decorator and its routine that is the routine."""
        extents = {node.lineno: _extent(node) for node in ast.walk(tree) if isinstance(node, ast.stmt)}
        for line, extent in extents.items():
            if line == extent[1]:
                for each in range(extent[0], line + 1):
                    self.heads[each] = max(extent, self.heads.get(each, extent))
            for each in (line, extent[0]):
                self.starts[each] = max(extent, self.starts.get(each, extent), key=lambda one: one[1])


def _extent(node: ast.stmt) -> tuple[int, int]:
    """The lines that a comment above a statement speaks of: a whole rung, but of a routine only its head."""
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        return min([node.lineno, *(decorator.lineno for decorator in node.decorator_list)]), node.lineno
    return node.lineno, node.end_lineno or node.lineno


def _read(
    source: SourceFile,
    span: Span,
    match: re.Match[str],
    stands_alone: bool,
    statements: _Statements,
    problems: Diagnostics,
) -> Iterator[Directive]:
    word, listed = match["word"], match["codes"]
    if word.lower() in _WORDS and not _is_well_written(match):
        way = f"write # clickgen: {word.lower()}[{listed or 'CG501'}]"
        problems.add(UNUSED, span, "clickgen does not hear this", way)
        return
    if word == "file-ignore" and not stands_alone:
        way = "put it on a line of its own, or write # clickgen: ignore[...] for this line"
        problems.add(UNUSED, span, "file-ignore speaks of the whole file and stands behind code", way)
        return
    if word not in _WORDS or listed is None or not listed.strip():
        help = did_you_mean(word, _WORDS) or "write # clickgen: ignore[CG501] and the reason"
        fault = "this names no codes" if word in _WORDS else f"there is no {word!r} to tell clickgen"
        problems.add(UNUSED, span, fault, help)
        return
    codes = tuple(code.strip() for code in listed.split(","))
    for code in codes:
        if code not in CODES:
            problems.add(UNUSED, span, f"there is no code {code!r}", did_you_mean(code, CODES) or "see clickgen rules")
        elif CODES[code].severity is Severity.ERROR:
            problems.add(UNUSED, span, f"{code} is an error: CLICK would not take the program", "correct it")
    codes = tuple(code for code in codes if code in CODES and CODES[code].severity is not Severity.ERROR)
    if word == "file-ignore":
        yield Directive(span, codes, 1, len(source.lines))
    elif not stands_alone:
        yield Directive(span, codes, *statements.heads.get(span.line, (span.line, span.line)))
    else:
        below = span.line + 1
        while source.line(below).lstrip().startswith("#"):
            below += 1
        yield Directive(span, codes, *statements.starts.get(below, (span.line, span.line)))


# -- writing them ----------------------------------------------------------------------------------------------------


def ignoring(source: SourceFile, findings: Iterable[Diagnostic]) -> Fix | None:
    """The edits that silence these findings of a file, each where it stands; None when there is nothing to silence."""
    wanted: dict[int, list[str]] = {}
    for finding in silenceable(source, findings):
        assert finding.span is not None
        codes = wanted.setdefault(finding.span.line, [])
        codes += [finding.code] if finding.code not in codes else []
    if not wanted:
        return None
    from clickgen.dialects.if_rungs.read.statements import layout_of

    layout = layout_of(source)
    if layout is None:
        return None
    ends = _Ends(source, layout, wanted)
    statements = sorted(node.lineno for node in ast.walk(layout.tree) if isinstance(node, ast.stmt))
    edits = [_ignoring_line(source, line, codes, ends, statements) for line, codes in sorted(wanted.items())]
    return Fix(tuple(edits))


class _Ends:
    """What is at the ends of these lines: comments, or no place for one."""

    def __init__(self, source: SourceFile, layout: Layout, lines: Iterable[int]) -> None:
        self.comments: dict[int, CommentAt] = {}
        self._open: set[int] = set()
        """Lines that end inside a text."""
        self._source = source
        wanted = sorted(lines)
        for part in layout.parts:
            if bisect_right(wanted, part.last) > bisect_right(wanted, part.start):
                self.comments.update((comment.line, comment) for comment in layout.comments(part))
                for node in layout.nodes(part):
                    if type(node).__name__ in ("SimpleString", "FormattedString"):
                        first, last = (bisect_right(source.starts, place) for place in layout.places.of(node))
                        self._open.update(range(first, last))

    def has_room(self, line: int) -> bool:
        """True for a line after which a comment can be put: it does not end inside a text, and no backslash ends it."""
        text = self._source.line(line)
        is_line = bool(text) or line < len(self._source.lines)
        is_joined = text.endswith("\\") and line not in self.comments
        return is_line and not is_joined and line not in self._open


def _ignoring_line(source: SourceFile, line: int, codes: list[str], ends: _Ends, statements: list[int]) -> Edit:
    text, comment = source.line(line), ends.comments.get(line)
    match = _DIRECTIVE.search(comment.text) if comment else None
    if comment and match and match["word"] == "ignore" and match["codes"] and _is_well_written(match):
        start = comment.col + match.start("codes")
        span = source.span(line, start, line, start + len(match["codes"]))
        known = [code.strip() for code in match["codes"].split(",")]
        return Edit(span, ", ".join([*known, *(code for code in codes if code not in known)]))
    directive = f"# clickgen: ignore[{', '.join(codes)}]"
    if ends.has_room(line):
        end = len(text) + 1
        return Edit(source.span(line, end, line, end), f"  {directive}")
    # No comment fits behind a line that goes on: it is put above the statement.
    above = max((start for start in statements if start <= line), default=line)
    indent = source.line(above)[: len(source.line(above)) - len(source.line(above).lstrip())]
    return Edit(source.span(above, 1, above, 1), f"{indent}{directive}\n")


def without(source: SourceFile, directive: Directive, unused: Sequence[str]) -> Edit:
    """The edit that takes codes out of a directive, and with the last one the whole comment."""
    span = directive.span
    kept = [code for code in directive.codes if code not in unused]
    text = source.line(span.line)
    if kept:
        head, _, _ = text[span.col - 1 : span.end_col - 1].partition("[")
        return Edit(span, f"{head}[{', '.join(kept)}]")
    before = text[: span.col - 1].rstrip()
    if before:
        return Edit(source.span(span.line, len(before) + 1, span.line, len(text) + 1), "")
    return Edit(source.span(span.line, 1, span.line + 1, 1), "")
