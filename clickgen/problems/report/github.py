"""For a GitHub workflow: a command for each finding, which GitHub shows beside the line in the pull request."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.problems.codes import Severity
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.report import Report, message_of, shown_path
from clickgen.problems.report.frames import summary
from clickgen.text.source import Span
from clickgen.text.wording import escaped, printable

LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}
LIMIT = 10
"""GitHub shows 10 errors, 10 warnings and 10 notices of a step and silently drops the rest.

Source: "Limitations" in docs/problem-matchers.md of https://github.com/actions/toolkit.
"""


def render(report: Report) -> str:
    """The most serious first, up to the limits; if some are left, a last notice says so."""
    levels: dict[Severity, list[Diagnostic]] = {severity: [] for severity in LEVELS}
    for finding in report.findings:
        levels[report.severity(finding)].append(finding)
    shown = dict.fromkeys(LEVELS, LIMIT)
    if any(len(findings) > LIMIT for findings in levels.values()):
        shown[Severity.INFO] -= 1
    lines = [
        _command(LEVELS[severity], _properties(finding), _text(finding))
        for severity, findings in levels.items()
        for finding in findings[: shown[severity]]
    ]
    left = [severity for severity, findings in levels.items() for _ in findings[shown[severity] :]]
    if left:
        lines.append(
            _command(
                "notice",
                {"title": "clickgen"},
                f"{summary(left)} more: GitHub shows {LIMIT} of a kind for each step. All of them: run clickgen check, "
                "or upload what clickgen check --output-format sarif writes",
            )
        )
    return "".join(f"{line}\n" for line in lines)


def _properties(finding: Diagnostic) -> dict[str, str]:
    return {**(dict(_place(finding.span)) if finding.span else {}), "title": finding.code}


def _place(span: Span) -> Iterator[tuple[str, str]]:
    yield "file", escaped(shown_path(span.path))
    yield "line", str(span.line)
    yield "endLine", str(max(span.line, span.end_line))
    # The runner takes no columns for several lines (ValidateLinesAndColumns in ActionCommandManager.cs of
    # https://github.com/actions/runner). The end is the last character; without an end it is the start
    # (AnnotationProperties of @actions/core).
    if span.end_line <= span.line:
        yield "col", str(span.col)
        yield "endColumn", str(max(span.col, span.end_col - 1))


def _text(finding: Diagnostic) -> str:
    lines = [message_of(finding)]
    for label in finding.labels:
        here = finding.span and label.span.path == finding.span.path
        place = f"line {label.span.line}" if here else f"{escaped(shown_path(label.span.path))}:{label.span.line}"
        lines.append(f"note: {label.text} ({place})")
    if finding.help:
        lines.append(f"help: {finding.help}")
    return printable("\n".join(lines))


def _command(level: str, properties: dict[str, str], text: str) -> str:
    shown = ",".join(f"{name}={_property(value)}" for name, value in properties.items())
    return f"::{level} {shown}::{_data(text)}"


# Which characters are escaped, and how: _escapeDataMappings and _escapePropertyMappings in ActionCommand.cs of
# https://github.com/actions/runner.


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
