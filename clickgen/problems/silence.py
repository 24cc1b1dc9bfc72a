"""Comments that silence findings: which findings each one meets, and those that silence nothing.

How such a comment is written, and what it speaks of, is the dialect's.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import SourceFile, Span

DIRECTIVE = "clickgen:"
"""How a comment begins that speaks to clickgen. It is no comment of a rung."""
UNUSED = "CG525"
"""The code of a comment that silences nothing."""


@dataclass
class Directive:
    """One comment: the codes it names, the lines that it speaks of, and what became of it."""

    span: Span
    """From its ``#`` to the closing bracket."""
    codes: tuple[str, ...]
    first: int
    last: int
    used: set[str] = field(default_factory=set)

    def silences(self, finding: Diagnostic) -> bool:
        span = finding.span
        if span is None or span.path != self.span.path or finding.is_error:
            return False
        # A finding over several lines is met by a comment on any of them, a rung's by a comment above it.
        meets = span.line <= self.last and span.end_line >= self.first
        return meets and finding.code in self.codes


def silenced(
    findings: Iterable[Diagnostic], directives: Iterable[Directive]
) -> tuple[list[Diagnostic], list[Diagnostic]]:
    """The findings that are left, and those that a comment silences."""
    left: list[Diagnostic] = []
    gone: list[Diagnostic] = []
    near = _Index(directives)
    for finding in findings:
        by = [directive for directive in near(finding) if directive.silences(finding)]
        for directive in by:
            directive.used.add(finding.code)
        (gone if by else left).append(finding)
    return left, gone


class _Index:
    """Directives by file, code and line, so that each finding looks at those near it."""

    def __init__(self, directives: Iterable[Directive]) -> None:
        self._wide: dict[tuple[str, str], list[Directive]] = {}
        """Those that speak of many lines."""
        self._narrow: dict[tuple[str, str], dict[int, list[Directive]]] = {}
        for directive in directives:
            for code in directive.codes:
                key = directive.span.path, code
                if directive.last - directive.first >= _MANY_LINES:
                    self._wide.setdefault(key, []).append(directive)
                    continue
                lines = self._narrow.setdefault(key, {})
                for line in range(directive.first, directive.last + 1):
                    lines.setdefault(line, []).append(directive)

    def __call__(self, finding: Diagnostic) -> list[Directive]:
        """Every directive that may silence this finding, each once."""
        if finding.span is None:
            return []
        key = finding.span.path, finding.code
        lines = self._narrow.get(key, {})
        own = range(finding.span.line, finding.span.end_line + 1)
        near = own if len(own) < len(lines) else lines
        found = [*self._wide.get(key, ()), *(one for line in near for one in lines.get(line, ()))]
        return list({id(one): one for one in found}.values())


_MANY_LINES = 50


def silenceable(source: SourceFile, findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    """The findings of a file that a comment can silence: no errors, and not what is wrong with such comments."""
    return [
        finding
        for finding in findings
        if finding.span and finding.span.path == source.path and not finding.is_error and finding.code != UNUSED
    ]


def report_unused(
    source: SourceFile,
    directives: Iterable[Directive],
    judged: Iterable[str],
    without: Callable[[SourceFile, Directive, Sequence[str]], Edit],
    problems: Diagnostics,
) -> None:
    """A finding for each code that a directive names and that silences nothing, of those codes that were judged.

    ``without`` takes codes out of a directive.
    """
    judged = set(judged)
    for directive in directives:
        unused = [code for code in directive.codes if code not in directive.used and code in judged]
        if not unused or directive.span.path != source.path:
            continue
        problems.add(
            UNUSED,
            directive.span,
            f"this silences no {' and no '.join(unused)}",
            "remove it",
            fix=Fix((without(source, directive, unused),)),
        )
