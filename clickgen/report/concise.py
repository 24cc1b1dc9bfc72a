"""One line for each finding: ``prog.py:4:9: CG501 message``."""

from __future__ import annotations

from clickgen.report import Report
from clickgen.report.frames import printable


def render(report: Report) -> str:
    lines = []
    for finding in report.findings:
        place = f"{finding.span}: " if finding.span else ""
        fixable = " [*]" if finding.fix and finding.fix.is_safe else ""
        message = " ".join(printable(finding.message).split("\n"))
        lines.append(f"{printable(place)}{finding.code}{fixable} {message}\n")
    return "".join(lines)
