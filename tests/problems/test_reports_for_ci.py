"""The findings of a check for GitLab, SARIF and JUnit readers."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any
from urllib.parse import unquote
from xml.etree import ElementTree as ET

import pytest
from findings_to_report import (
    _JUNIT,
    _SARIF,
    _SARIF_SCHEMA,
    FIX,
    MACHINES,
    ODD_PATH,
    REPORTS,
    SOURCE,
    every_report,
    many,
    one,
)
from hypothesis import given
from hypothesis import strategies as st

from clickgen.problems.codes import CODES, Severity
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.problems.formats import FORMATS
from clickgen.problems.report import Report, render, sarif
from clickgen.text.edits import Edit, Fix, apply_fixes
from clickgen.text.source import Span

# -- gitlab ------------------------------------------------------------------------------------------------------------


@every_report
def test_gitlab_gets_what_it_requires(report: Report) -> None:
    """The properties of "Code Quality report format", https://docs.gitlab.com/ci/testing/code_quality/."""
    text = render("gitlab", report)
    assert not text.startswith("\ufeff")
    issues = json.loads(text)
    assert len(issues) == len(report.findings)
    for issue, finding in zip(issues, report.findings, strict=True):
        assert issue.keys() == {"description", "check_name", "fingerprint", "severity", "location"}
        assert finding.message in issue["description"]
        assert issue["check_name"] == finding.code
        assert issue["severity"] in ("info", "minor", "major", "critical", "blocker")
        path, line = issue["location"]["path"], issue["location"]["lines"]["begin"]
        assert path
        assert not path.startswith(("/", "./"))
        assert line == (finding.span.line if finding.span else 1)
    assert len({issue["fingerprint"] for issue in issues}) == len(issues)


@pytest.mark.parametrize(("code", "severity"), [("CG403", "major"), ("CG501", "minor"), ("CG506", "info")])
def test_gitlab_s_severities(code: str, severity: str) -> None:
    assert json.loads(render("gitlab", one(code)))[0]["severity"] == severity


# -- sarif -------------------------------------------------------------------------------------------------------------


def run_of(report: Report) -> dict[str, Any]:
    log = json.loads(render("sarif", report))
    (run,) = log["runs"]
    assert isinstance(run, dict)
    return run


@every_report
def test_sarif_keeps_to_the_schema(report: Report) -> None:
    log = json.loads(render("sarif", report))
    assert [error.message for error in _SARIF.iter_errors(log)] == []
    assert log["version"] == "2.1.0"


def test_the_schema_is_the_one_and_refuses_what_is_wrong() -> None:
    assert _SARIF_SCHEMA["title"].startswith("Static Analysis Results Format (SARIF) Version 2.1.0")
    log = json.loads(render("sarif", REPORTS["odd"]))
    log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0
    assert not _SARIF.is_valid(log)


@every_report
def test_sarif_has_what_github_requires(report: Report) -> None:
    """The properties and limits of "SARIF support for code scanning" in GitHub's documentation."""
    log = json.loads(render("sarif", report))
    assert log["$schema"]
    (run,) = log["runs"]
    driver = run["tool"]["driver"]
    assert driver["name"] == "clickgen"
    assert len(driver["rules"]) <= 25_000
    for rule in driver["rules"]:
        assert 0 < len(rule["shortDescription"]["text"]) <= 1024
        assert 0 < len(rule["fullDescription"]["text"]) <= 1024
        assert rule["help"]["text"]
        assert rule["help"]["markdown"]
        assert rule["defaultConfiguration"]["level"] in ("note", "warning", "error")
        assert rule["properties"]["problem.severity"] in ("error", "warning", "recommendation")
        assert len(rule["properties"]["tags"]) <= 10
    assert len(run["results"]) == len(report.findings)
    for result in run["results"]:
        assert driver["rules"][result["ruleIndex"]]["id"] == result["ruleId"]
        assert result["message"]["text"]
        assert all(result["partialFingerprints"].values())
        for location in result["locations"] if report.checked else []:
            place = location["physicalLocation"]
            assert place["artifactLocation"]["uri"]
            assert place["region"].keys() == {"startLine", "startColumn", "endLine", "endColumn"}
            start = (place["region"]["startLine"], place["region"]["startColumn"])
            assert start <= (place["region"]["endLine"], place["region"]["endColumn"])


def test_the_rules_are_every_code_whatever_was_found() -> None:
    rules = run_of(REPORTS["clean"])["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == list(CODES)
    assert rules == run_of(REPORTS["odd"])["tool"]["driver"]["rules"]


def test_a_rule_says_why_it_matters() -> None:
    rule = next(rule for rule in run_of(REPORTS["clean"])["tool"]["driver"]["rules"] if rule["id"] == "CG501")
    assert rule["shortDescription"]["text"] == CODES["CG501"].title
    assert rule["fullDescription"]["text"].startswith("`out` writes its bit in every scan")
    assert "```python" in rule["help"]["markdown"]
    assert "```" not in rule["help"]["text"]
    assert rule["defaultConfiguration"] == {"level": "warning", "enabled": True}
    for rule in run_of(REPORTS["clean"])["tool"]["driver"]["rules"]:
        assert "<!--" not in rule["help"]["markdown"]
        assert "](" not in rule["help"]["markdown"], "a relative link leads nowhere there"


def test_a_rule_leads_to_its_page_where_there_is_one(monkeypatch: pytest.MonkeyPatch) -> None:
    rule = run_of(REPORTS["clean"])["tool"]["driver"]["rules"][0]
    assert rule.get("helpUri", sarif.PAGES) == (f"{sarif.PAGES}/CG101.md" if sarif.PAGES else "")
    monkeypatch.setattr(sarif, "PAGES", "https://example.org/problems")
    driver = run_of(REPORTS["clean"])["tool"]["driver"]
    assert driver["informationUri"] == "https://example.org/problems"
    assert driver["rules"][0]["helpUri"] == "https://example.org/problems/CG101.md"
    assert _SARIF.is_valid(json.loads(render("sarif", REPORTS["odd"])))


def test_sarif_places_are_code_points_and_addresses_are_quoted() -> None:
    run = run_of(REPORTS["odd"])
    assert run["columnKind"] == "unicodeCodePoints"
    place = run["results"][0]["locations"][0]["physicalLocation"]
    region = place["region"]
    assert region == {"startLine": 2, "startColumn": 16, "endLine": 2, "endColumn": 19}
    marked = SOURCE.split("\n")[1][region["startColumn"] - 1 : region["endColumn"] - 1]
    assert marked == '"\N{GRINNING FACE}"'
    address = place["artifactLocation"]
    assert address["uriBaseId"] in run["originalUriBaseIds"]
    assert re.fullmatch(r"[\w%/.-]+", address["uri"], re.ASCII)
    assert unquote(address["uri"]) == ODD_PATH
    assert [artifact["location"]["uri"] for artifact in run["artifacts"]] == [address["uri"], "clean.py"]


def test_a_file_elsewhere_has_an_absolute_address(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "work").mkdir()
    monkeypatch.chdir(tmp_path / "work")
    (result,) = run_of(one("CG501", "../süd.py"))["results"]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"] == {"uri": (tmp_path / "süd.py").as_uri()}


def test_a_sarif_message_links_to_related_locations_and_to_nothing_else() -> None:
    (result, *_) = run_of(REPORTS["odd"])["results"]
    text = result["message"]["text"]
    # Section 3.11.6 of the specification: a link, its text escaped.
    links = re.findall(r"(?<!\\)\[((?:\\.|[^\\\[\]])*)\]\((\d+)\)", text)
    assert links == [(r"here \[x\]", "1"), ("and there", "2")]
    assert {str(related["id"]) for related in result["relatedLocations"]} == {id for _, id in links}
    # Section 3.11.5: what is no placeholder has its braces twice.
    assert "{{0}}" in text
    assert text.endswith("help: one, two: three\nfour")
    other = result["relatedLocations"][1]
    assert other["physicalLocation"]["artifactLocation"]["uri"] == "other.py"
    assert other["message"]["text"] == "and there"


def test_a_sarif_fix_does_what_fix_does() -> None:
    (result, *_) = run_of(REPORTS["odd"])["results"]
    ((change,),) = [fix["artifactChanges"] for fix in result["fixes"]]
    assert unquote(change["artifactLocation"]["uri"]) == ODD_PATH
    edits = []
    for replacement in change["replacements"]:
        region = replacement["deletedRegion"]
        span = Span("", region["startLine"], region["startColumn"], region["endLine"], region["endColumn"])
        edits.append(Edit(span, replacement["insertedContent"]["text"]))
    assert apply_fixes(SOURCE, [Fix(tuple(edits))]) == apply_fixes(SOURCE, [FIX])


def test_a_finding_without_a_place_stands_at_the_beginning_of_the_first_file() -> None:
    placeless = run_of(REPORTS["odd"])["results"][2]
    assert placeless["locations"][0]["physicalLocation"]["region"]["startLine"] == 1
    assert "locations" not in run_of(REPORTS["placeless only"])["results"][0]


def test_sarif_levels() -> None:
    def levels(report: Report) -> list[str]:
        return [result["level"] for result in run_of(report)["results"]]

    assert [levels(one(code)) for code in ("CG403", "CG501", "CG506")] == [["error"], ["warning"], ["note"]]
    assert set(levels(REPORTS["denied"])) == {"error"}


# -- junit -------------------------------------------------------------------------------------------------------------


def suites_of(report: Report) -> list[ET.Element]:
    return list(ET.fromstring(render("junit", report)))


@every_report
def test_junit_keeps_to_the_schema(report: Report) -> None:
    _JUNIT.validate(ET.fromstring(render("junit", report)))


def test_the_junit_schema_refuses_what_is_wrong() -> None:
    assert not _JUNIT.is_valid(ET.fromstring("<testsuites><testsuite name='a'><testcase/></testsuite></testsuites>"))


@every_report
def test_junit_counts_what_it_holds(report: Report) -> None:
    root = ET.fromstring(render("junit", report))
    for element in (root, *root):
        assert element.get("tests") == str(len(list(element.iter("testcase"))))
        assert element.get("failures") == str(len(list(element.iter("failure"))))
    for suite in root:
        assert suite.get("skipped") == str(len(list(suite.iter("skipped"))))
    fails = [finding for finding in report.findings if report.severity(finding) is not Severity.INFO]
    assert root.get("failures") == str(len(fails))


def test_a_file_without_findings_is_a_passed_test() -> None:
    odd, clean, *others = suites_of(REPORTS["odd"])
    assert odd.get("name") == ODD_PATH
    assert clean.get("name") == "clean.py"
    (case,) = clean
    assert (case.get("name"), list(case)) == ("no findings", [])
    assert [suite.get("name") for suite in others] == ["other.py", "clickgen"]


def test_a_failed_test_says_what_a_person_would_read() -> None:
    report = Report((Diagnostic("CG501", "twice <&>", Span("a.py", 1, 5, 1, 8), "join"),), (), lambda *_: "def main")
    ((case,),) = suites_of(report)
    assert case.attrib == {"classname": "a.py", "name": "CG501 at 1:5"}
    (failure,) = case
    assert failure.attrib == {"type": "warning", "message": "twice <&>"}
    assert failure.text == "\n".join(
        (
            "a.py:1:5: warning[CG501]: twice <&>",
            "  1 | def main",
            "    |     ^^^",
            "  help: join",
        )
    )


@pytest.mark.parametrize(
    ("word", "columns"),
    [
        ("Motor", 5),
        ("F\u00f6rderband", 10),
        ("\u65e5\u672c", 4),
        ("e\u0301t\u00e9", 3),
        ("\u0e01\u0e47", 1),  # a Thai consonant with a vowel sign above it, which Unicode does not call combining
        ("\u07a6x", 1),
    ],
    ids=ascii,
)
def test_a_mark_stands_below_what_a_terminal_shows_there(word: str, columns: int) -> None:
    span = Span("a.py", 1, len(word) + 2, 1, len(word) + 3)
    report = Report((Diagnostic("CG501", "twice", span, "join"),), (), lambda *_: f"{word} x")
    (shown,) = [line for line in render("text", report).splitlines() if line.strip(" |") == "^"]
    assert shown == f"    | {' ' * (columns + 1)}^"


def test_notes_are_skipped_tests_unless_they_are_denied() -> None:
    notes = many("CG506", 2)
    for deny, tag in ((False, "skipped"), (True, "failure")):
        (suite,) = suites_of(Report(notes, deny_warnings=deny))
        assert [element.tag for case in suite for element in case] == [tag, tag]


def test_no_two_tests_of_a_file_have_the_same_name() -> None:
    """GitLab takes only the first: "Unit test reports", https://docs.gitlab.com/ci/testing/unit_test_reports/."""
    span = Span("a.py", 1, 1, 1, 2)
    (suite,) = suites_of(Report((Diagnostic("CG501", "one", span), Diagnostic("CG501", "two", span))))
    assert [case.get("name") for case in suite] == ["CG501 at 1:1", "CG501 at 1:1 (2)"]


def test_what_xml_forbids_is_replaced() -> None:
    text = render("junit", REPORTS["odd"])
    failure = next(ET.fromstring(text).iter("failure"))
    message = failure.get("message") or ""
    assert message.count("\ufffd") == 3
    assert "]]>" in message
    assert message.endswith("\N{GRINNING FACE} ä")


@given(st.text())
def test_any_message_makes_good_xml(message: str) -> None:
    _JUNIT.validate(ET.fromstring(render("junit", one("CG501", "a.py", message))))


@pytest.mark.parametrize("format", MACHINES)
@given(message=st.text(), path=st.text(min_size=1).filter(lambda path: "\0" not in path))
def test_no_text_breaks_a_report(format: str, message: str, path: str) -> None:
    text = render(format, one("CG501", path, message))
    if format == "junit":
        ET.fromstring(text)
    elif format != "github":
        json.loads(text)


CELL = Span.of_cell("plant/io.xlsx", "Inputs 2", 7, 28)


@pytest.mark.parametrize("format", FORMATS)
def test_a_cell_of_a_workbook_is_named_in_every_format(format: str) -> None:
    finding = Diagnostic("CG603", "a bad name", CELL, "rename it")
    text = render(format, Report((finding,), ("plant/io.xlsx",)))
    assert "Inputs 2!AB7" in text.replace("%20", " ")


def test_places_in_a_workbook() -> None:
    assert str(CELL) == "plant/io.xlsx:Inputs 2!AB7"
    assert [Span.of_cell("a", "S", 1, column).cell for column in (1, 26, 27, 52, 53, 702, 703)] == [
        "S!A1", "S!Z1", "S!AA1", "S!AZ1", "S!BA1", "S!ZZ1", "S!AAA1"
    ]  # fmt: skip
    assert CELL.seen_from(Span("plant/io.xlsx", 1, 1, 1, 2, "Other")) == "Inputs 2!AB7"
    assert CELL.seen_from(Span("prog.py", 1, 1, 1, 2)) == "plant/io.xlsx:Inputs 2!AB7"


def test_problems_of_a_workbook_come_sheet_by_sheet() -> None:
    problems = Diagnostics()
    for sheet, row in (("B", 1), ("A", 9), ("B", 3), ("A", 2)):
        problems.add("CG603", Span.of_cell("io.xlsx", sheet, row, 1), "a bad name")
    assert [problem.span.cell for problem in problems.in_order() if problem.span] == ["A!A2", "A!A9", "B!A1", "B!A3"]
