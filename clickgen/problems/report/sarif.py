"""SARIF 2.1.0, for GitHub's code scanning, editors and everything else that reads results of static analysis.

Specification: https://docs.oasis-open.org/sarif/sarif/v2.1.0/sarif-v2.1.0.html. What GitHub requires and what it reads:
"SARIF support for code scanning" in GitHub's documentation.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import PurePath
from urllib.parse import quote

from clickgen import __version__
from clickgen.commands.explain import explanation, plain
from clickgen.problems.codes import CODES, Severity
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.problems.report import Report, message_of, shown_path
from clickgen.problems.report.fingerprints import fingerprints
from clickgen.rules.registry import declared
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span

PAGES = ""
"""The absolute address of the pages of docs/problems/, without a slash at the end; "" if they are not published."""

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
_PROBLEM_SEVERITIES = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "recommendation"}
"""GitHub's own words for the severity of a rule that is not about security."""
_GROUPS = {
    "1": "syntax",
    "2": "addresses",
    "3": "operands",
    "4": "structure",
    "5": "logic",
    "6": "address-table",
    "7": "import",
}
_ROOT = "%SRCROOT%"
_DESCRIPTION_MAX = 1024
"""GitHub's limit for fullDescription."""

Tree = dict[str, object]


def render(report: Report) -> str:
    run: Tree = {
        "tool": {"driver": _driver()},
        "invocations": [{"executionSuccessful": True}],
        "originalUriBaseIds": {_ROOT: {"description": {"text": "The folder in which clickgen ran."}}},
        "artifacts": [{"location": _file(path), "roles": ["analysisTarget"]} for path in report.checked],
        "columnKind": "unicodeCodePoints",
        "results": [
            _result(report, finding, mark) for finding, mark in zip(report.findings, fingerprints(report), strict=True)
        ],
    }
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


# -- rules ------------------------------------------------------------------------------------------------------------


def _driver() -> Tree:
    """Every code, found or not: GitHub wants the rules to be the same in every run."""
    driver: Tree = {"name": "clickgen", "version": __version__, "semanticVersion": __version__}
    if PAGES:
        driver["informationUri"] = PAGES
    return {**driver, "rules": [_rule(code) for code in CODES]}


def _rule(code: str) -> Tree:
    entry = CODES[code]
    page = _without_links(explanation(declared(code)))
    rule: Tree = {
        "id": code,
        "shortDescription": {"text": entry.title},
        "fullDescription": {"text": _first_words(page)},
        "help": {"text": plain(page).strip(), "markdown": page.strip()},
        "defaultConfiguration": {"level": LEVELS[entry.severity], "enabled": entry.is_on},
        "properties": {"tags": [_GROUPS[code[2]]], "problem.severity": _PROBLEM_SEVERITIES[entry.severity]},
    }
    if PAGES:
        rule["helpUri"] = f"{PAGES}/{code}.md"
    return rule


def _without_links(page: str) -> str:
    """The page of a code on its own: without its links, which lead to pages beside it, and its comments for tests."""
    return re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", re.sub(r"<!--.*?-->\n", "", page))


def _first_words(page: str) -> str:
    """The first paragraph after the title, in one line, without the word for the severity."""
    paragraph = " ".join(plain(page).split("\n\n")[1].split())
    text = paragraph.partition(". ")[2] or paragraph
    return text if len(text) <= _DESCRIPTION_MAX else text[: _DESCRIPTION_MAX - 1] + "\N{HORIZONTAL ELLIPSIS}"


def _index(code: str) -> int:
    """The place of a code in the list of rules."""
    return list(CODES).index(code)


# -- results ----------------------------------------------------------------------------------------------------------


def _result(report: Report, finding: Diagnostic, mark: str) -> Tree:
    result: Tree = {
        "ruleId": finding.code,
        "ruleIndex": _index(finding.code),
        "level": LEVELS[report.severity(finding)],
        "message": {"text": "\n".join(_message(finding))},
        # No primaryLocationLineHash: GitHub's upload-sarif computes it from the source, and complains about any other
        # value (src/fingerprints.ts of https://github.com/github/codeql-action).
        "partialFingerprints": {"clickgenFinding/v1": mark},
    }
    place = finding.span or _beginning(report)
    if place:
        result["locations"] = [{"physicalLocation": _location(place)}]
    if finding.labels:
        result["relatedLocations"] = [_related(id, label) for id, label in enumerate(finding.labels, 1)]
    if finding.fix:
        result["fixes"] = [_fix(finding.fix)]
    return result


def _beginning(report: Report) -> Span | None:
    """The place for a finding that has none: GitHub shows no result without a location."""
    return Span(report.checked[0], 1, 1, 1, 1) if report.checked else None


def _message(finding: Diagnostic) -> Iterator[str]:
    yield _literal(message_of(finding))
    for id, label in enumerate(finding.labels, 1):
        # GitHub shows a related location only where the message links to it.
        text = re.sub(r"([\\\[\]])", r"\\\1", _braces(label.text))
        yield f"note: [{text}]({id})"
    if finding.help:
        yield f"help: {_literal(finding.help)}"


def _literal(text: str) -> str:
    """Text of a message that is neither placeholder (section 3.11.5) nor link (3.11.6)."""
    return _braces(text).replace("](", "\\](")


def _braces(text: str) -> str:
    return text.replace("{", "{{").replace("}", "}}")


def _related(id: int, label: Label) -> Tree:
    return {"id": id, "physicalLocation": _location(label.span), "message": {"text": _literal(label.text)}}


def _fix(fix: Fix) -> Tree:
    """Edits by file. The description says what ``--fix`` would say."""
    files: dict[str, list[Edit]] = {}
    for edit in fix.edits:
        files.setdefault(edit.span.path, []).append(edit)
    return {
        "description": {"text": "A safe fix." if fix.is_safe else "A fix that may change what the program does."},
        "artifactChanges": [
            {"artifactLocation": _file(path), "replacements": [_replacement(edit) for edit in edits]}
            for path, edits in files.items()
        ],
    }


def _replacement(edit: Edit) -> Tree:
    return {"deletedRegion": _region(edit.span), "insertedContent": {"text": edit.text}}


# -- places -----------------------------------------------------------------------------------------------------------


def _location(span: Span) -> Tree:
    return {"artifactLocation": _file(span.path), "region": _region(span)}


def _region(span: Span) -> dict[str, int]:
    """Counted from 1, the end exclusive, as in spans."""
    return {"startLine": span.line, "startColumn": span.col, "endLine": span.end_line, "endColumn": span.end_col}


def _file(path: str) -> Tree:
    """A relative address below the folder in which clickgen runs, which is GitHub's root of the repository."""
    shown = shown_path(path)
    if PurePath(shown).is_absolute():
        return {"uri": PurePath(shown).as_uri()}
    return {"uri": quote(shown, errors="surrogateescape"), "uriBaseId": _ROOT}
