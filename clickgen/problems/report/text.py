"""For people: each finding with its source line, then a line that sums up."""

from __future__ import annotations

from clickgen.problems.report import Report
from clickgen.text.wording import counted


def render(report: Report) -> str:
    if not report.findings:
        return ""
    from clickgen.problems.report.frames import Renderer

    renderer = Renderer(report.color, report.line_of, report.severity)
    return "".join(renderer.render(finding) + "\n\n" for finding in report.findings)


def summary_line(report: Report) -> str:
    """``3 errors, 1 warning in 2 files; 2 can be fixed with --fix``."""
    if not report.findings:
        what = f"{counted(len(report.checked), 'file')} checked, all is well"
    else:
        files = len({finding.span.path for finding in report.findings if finding.span})
        from clickgen.problems.report.frames import summary

        what = summary(map(report.severity, report.findings))
        what += f" in {counted(files, 'file')}" if files else ""
    notes = [what]
    if report.fixed:
        notes.append(f"{report.fixed} fixed")
    if report.fixable:
        notes.append(f"{report.fixable} can be fixed with --fix")
    if report.unsafely_fixable:
        more = f"{report.unsafely_fixable} more" if report.fixable else f"{report.unsafely_fixable} can be fixed"
        notes.append(f"{more} with --fix --unsafe-fixes")
    notes += [f"{count} not shown ({reason})" for reason, count in report.skipped.items() if count]
    return "; ".join(notes)
