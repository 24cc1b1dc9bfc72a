"""For programs: one object with all findings, their places and fixes, and the counts. See docs/check-output.md."""

from __future__ import annotations

import json
from collections import Counter

from clickgen import __version__
from clickgen.problems.codes import CODES, Severity
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.problems.report import Report, shown_path
from clickgen.text.edits import Edit
from clickgen.text.source import Span

FORMAT = 1
"""Raised when something that existed changes its meaning or is removed; an addition does not change it."""


def render(report: Report) -> str:
    tree = {
        "format": FORMAT,
        "tool": {"name": "clickgen", "version": __version__},
        "findings": [_finding(report, finding) for finding in report.findings],
        "counts": _counts(report),
    }
    # All of it in ASCII: a character outside a console's code page would break the JSON.
    return json.dumps(tree, indent=2) + "\n"


def _finding(report: Report, finding: Diagnostic) -> dict[str, object]:
    return {
        "code": finding.code,
        "severity": report.severity(finding).value,
        "title": CODES[finding.code].title,
        "message": finding.message,
        "help": finding.help,
        **_place(finding.span),
        "labels": [_label(label) for label in finding.labels],
        "fix": {"safe": finding.fix.is_safe, "edits": [_edit(edit) for edit in finding.fix.edits]}
        if finding.fix
        else None,
    }


def _label(label: Label) -> dict[str, object]:
    return {"text": label.text, **_place(label.span)}


def _edit(edit: Edit) -> dict[str, object]:
    return {"text": edit.text, **_place(edit.span)}


def _place(span: Span | None) -> dict[str, object]:
    if span is None:
        return dict.fromkeys(("file", "line", "column", "end_line", "end_column", "cell"))
    return {
        "file": shown_path(span.path),
        "line": span.line,
        "column": span.col,
        "end_line": span.end_line,
        "end_column": span.end_col,
        "cell": span.cell or None,
    }


def _counts(report: Report) -> dict[str, object]:
    severities = Counter(map(report.severity, report.findings))
    return {
        "files": len(report.checked),
        **{severity.value: severities[severity] for severity in Severity},
        "fixable": report.fixable,
        "fixed": report.fixed,
        "not_shown": dict(report.skipped),
    }
