"""The key of a finding while lines move: for baselines, and for services that follow findings."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from clickgen.problems.diagnostics import Diagnostic

Key = tuple[str, str, str]
"""File, code and source line of a finding: it may move, but not change."""


def keys_of(
    findings: Iterable[Diagnostic], name: Callable[[str], str], line_of: Callable[[str, int], str]
) -> list[Key]:
    """The key of each finding; ``name`` gives a path as the baseline writes it."""
    return [
        (name(finding.span.path), finding.code, line_of(finding.span.path, finding.span.line).strip())
        if finding.span
        else ("", finding.code, "")
        for finding in findings
    ]
