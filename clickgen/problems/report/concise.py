"""One line for each finding: ``prog.py:4:9: CG501 message``."""

from __future__ import annotations

from clickgen.problems.report import Report
from clickgen.text.wording import escaped


def render(report: Report) -> str:
    lines = []
    for finding in report.findings:
        place = f"{finding.span}: " if finding.span else ""
        fixable = " [*]" if finding.fix and finding.fix.is_safe else ""
        lines.append(f"{escaped(place)}{finding.code}{fixable} {escaped(finding.message)}\n")
    return "".join(lines)
