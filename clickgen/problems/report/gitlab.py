"""For GitLab's Code Quality: a list of findings with fingerprints, which a merge request compares with its target."""

from __future__ import annotations

import json

from clickgen.problems.codes import Severity
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.report import Report, message_of, shown_path
from clickgen.problems.report.fingerprints import fingerprints

SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}
"""One of info, minor, major, critical and blocker.

Source of this and of the properties: "Code Quality report format", https://docs.gitlab.com/ci/testing/code_quality/.
"""


def render(report: Report) -> str:
    marks = zip(report.findings, fingerprints(report), strict=True)
    return json.dumps([_issue(report, finding, mark) for finding, mark in marks], indent=2) + "\n"


def _issue(report: Report, finding: Diagnostic, mark: str) -> dict[str, object]:
    # A place is required; a finding without one goes to the beginning of the first file.
    path = finding.span.path if finding.span else next(iter(report.checked), ".")
    return {
        "description": f"{finding.code}: {message_of(finding)}" + (f"; {finding.help}" if finding.help else ""),
        "check_name": finding.code,
        "fingerprint": mark,
        "severity": SEVERITIES[report.severity(finding)],
        "location": {"path": shown_path(path), "lines": {"begin": finding.span.line if finding.span else 1}},
    }
