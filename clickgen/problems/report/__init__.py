"""The findings of a check in the chosen format: one file per format, each a pure function to text."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from pathlib import PurePath
from typing import NamedTuple, TextIO

from clickgen.problems.codes import Severity
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.formats import FORMATS

__all__ = ["FORMATS", "LineOf", "Report", "by_file", "render", "shown_path", "use_color"]

LineOf = Callable[[str, int], str]
"""The text of a line of a file; "" if there is none."""


class Report(NamedTuple):
    """What is left to say after selection, suppressions and fixes.

    ``findings`` are in the order of files and places; ``checked`` names every file that was looked at.
    """

    findings: tuple[Diagnostic, ...]
    checked: tuple[str, ...] = ()
    line_of: LineOf = lambda *_: ""
    fixed: int = 0
    """How many findings a fix removed."""
    deny_warnings: bool = False
    color: bool = False
    skipped: Mapping[str, int] = {}
    """How many findings were not shown, by reason, such as the baseline."""

    def severity(self, finding: Diagnostic) -> Severity:
        """How serious a finding is; with ``deny_warnings`` everything is an error."""
        return Severity.ERROR if self.deny_warnings else finding.severity

    @property
    def fails(self) -> bool:
        """True when the findings make a check fail: errors and warnings, notes only with ``deny_warnings``."""
        return any(self.severity(finding) is not Severity.INFO for finding in self.findings)

    @property
    def fixable(self) -> int:
        """How many findings have a safe fix."""
        return sum(finding.fix is not None and finding.fix.is_safe for finding in self.findings)

    @property
    def unsafely_fixable(self) -> int:
        """How many findings have a fix that could change what the program does."""
        return sum(finding.fix is not None and not finding.fix.is_safe for finding in self.findings)


def render(format: str, report: Report) -> str:
    """The report as text in one of ``FORMATS``; it ends with a line end unless it is empty."""
    text: str = import_module(f"{__name__}.{format}").render(report)
    return text


def use_color(stream: TextIO) -> bool:
    """True on a terminal, unless NO_COLOR is set (https://no-color.org)."""
    return stream.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def shown_path(path: str, base: str | None = None) -> str:
    """A path for machines: relative to ``base`` (the working folder) if it is below, with slashes."""
    absolute, folder = PurePath(os.path.abspath(path)), PurePath(base or os.getcwd())
    return (absolute.relative_to(folder) if absolute.is_relative_to(folder) else absolute).as_posix()


def message_of(finding: Diagnostic) -> str:
    """The message for machines that know only lines: in a workbook it begins with the cell."""
    cell = finding.span.cell if finding.span else ""
    return f"{cell}: {finding.message}" if cell else finding.message


def by_file(findings: Iterable[Diagnostic]) -> dict[str, list[Diagnostic]]:
    """The findings of each file, in the order of the files; those without a place are under ""."""
    files: dict[str, list[Diagnostic]] = {}
    for finding in findings:
        files.setdefault(finding.span.path if finding.span else "", []).append(finding)
    return files
