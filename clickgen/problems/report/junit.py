"""For whatever reads test results: a suite for each file, a failed test for each finding, a passed one for none.

Notes do not make a check fail; they are skipped tests. The elements are those of junit-10.xsd of Jenkins' xUnit plugin.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from xml.etree import ElementTree as ET

from clickgen.problems.codes import Severity
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.report import Report, by_file, message_of, shown_path
from clickgen.problems.report.frames import Renderer
from clickgen.text.source import Span

_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML 1.0 cannot hold (production Char, https://www.w3.org/TR/xml/#charsets)."""


def render(report: Report) -> str:
    text_of = _texts(report)
    root = ET.Element("testsuites", name="clickgen")
    total: Counter[str] = Counter()
    for path, findings in _suites(report).items():
        suite = ET.SubElement(root, "testsuite", name=_xml(path))
        names: Counter[str] = Counter()
        for finding in findings:
            names[_name(finding)] += 1
            again = names[_name(finding)]
            # GitLab ignores a test with the name of an earlier one.
            case = _case(suite, path, f"{_name(finding)} ({again})" if again > 1 else _name(finding))
            severity = report.severity(finding)
            result = ET.SubElement(case, "skipped" if severity is Severity.INFO else "failure", type=severity.value)
            result.set("message", _xml(message_of(finding)))
            result.text = _xml(text_of(finding))
        if not findings:
            _case(suite, path, "no findings")
        counts = Counter(element.tag for element in suite.iter())
        suite.attrib |= {"tests": str(counts["testcase"]), "failures": str(counts["failure"]), "errors": "0"}
        suite.set("skipped", str(counts["skipped"]))
        total += counts
    root.attrib |= {"tests": str(total["testcase"]), "failures": str(total["failure"]), "errors": "0"}
    ET.indent(root)
    # In ASCII with character references, which no console's code page can spoil.
    text = ET.tostring(root, encoding="us-ascii", xml_declaration=False).decode("ascii")
    return f'<?xml version="1.0" encoding="utf-8"?>\n{text}\n'


def _texts(report: Report) -> Callable[[Diagnostic], str]:
    """Findings as a person reads them, with paths for machines."""
    named: dict[str, str] = {}

    def shown(span: Span) -> Span:
        path = shown_path(span.path)
        named[path] = span.path
        return span._replace(path=path)

    def text_of(finding: Diagnostic) -> str:
        labels = tuple(label._replace(span=shown(label.span)) for label in finding.labels)
        return renderer.render(finding._replace(span=finding.span and shown(finding.span), labels=labels))

    renderer = Renderer(False, lambda path, line: report.line_of(named[path], line), report.severity)
    return text_of


def _suites(report: Report) -> dict[str, list[Diagnostic]]:
    """The findings of every file by its shown path; those without a place are under ``clickgen``."""
    suites: dict[str, list[Diagnostic]] = {shown_path(path): [] for path in report.checked}
    for path, findings in by_file(report.findings).items():
        suites.setdefault(shown_path(path) if path else "clickgen", []).extend(findings)
    return suites


def _case(suite: ET.Element, path: str, name: str) -> ET.Element:
    return ET.SubElement(suite, "testcase", classname=_xml(path), name=name)


def _name(finding: Diagnostic) -> str:
    return f"{finding.code} at {finding.span.line}:{finding.span.col}" if finding.span else finding.code


def _xml(text: str) -> str:
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", text)
