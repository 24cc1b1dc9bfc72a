"""What a check found, in every format: held against the schema or the rules of whoever reads it."""

from __future__ import annotations

import json
import os
import re
from collections import Counter
from pathlib import Path
from typing import Any
from urllib.parse import unquote
from xml.etree import ElementTree as ET

import jsonschema
import pytest
import xmlschema
from hypothesis import given
from hypothesis import strategies as st
from test_lint import program_of

import clickgen
from clickgen.cli import main
from clickgen.problems.codes import CODES, Severity
from clickgen.problems.diagnostics import Diagnostic, Diagnostics, Label
from clickgen.problems.formats import FORMATS
from clickgen.problems.report import Report, render, sarif
from clickgen.problems.report.fingerprints import fingerprints
from clickgen.rules.advice import RULES
from clickgen.text.edits import Edit, Fix, apply_fixes
from clickgen.text.source import Span
from clickgen.text.wording import escaped

SCHEMAS = Path(__file__).with_name("schemas")
MACHINES = [name for name in FORMATS if name not in ("text", "concise")]

# -- reports to render ------------------------------------------------------------------------------------------------

SOURCE = """\
def main():
    if c.Ä and "\N{GRINNING FACE}":
        out(y.Motor)
    if c.B:
        out(y.Motor)
"""
ODD_PATH = "süd, ost/50%:pumpe.py"
FIX = Fix((Edit(Span(ODD_PATH, 5, 9, 5, 21), "set(y.Motor)"), Edit(Span(ODD_PATH, 4, 1, 4, 1), "    # now\n")))
ODD = Diagnostic(
    "CG501",
    "a\r\n100% <b>&\"'[1](2) {0} ]]>\x00\x1b[31m\x85\u2028\ufffe \N{GRINNING FACE} ä",
    Span(ODD_PATH, 2, 16, 2, 19),
    "one, two: three\nfour",
    (Label(Span(ODD_PATH, 3, 9, 3, 21), "here [x]"), Label(Span("other.py", 7, 1, 8, 2), "and there")),
    FIX,
)
PLACELESS = Diagnostic("CG401", "the program has no main", None)
LONG = Diagnostic("CG403", "over several lines", Span("other.py", 7, 5, 9, 2))


def line_of(path: str, number: int) -> str:
    lines = SOURCE.split("\n") if path == ODD_PATH else []
    return lines[number - 1] if 0 < number <= len(lines) else ""


def many(code: str, count: int, path: str = "many.py") -> tuple[Diagnostic, ...]:
    return tuple(Diagnostic(code, f"finding {n}", Span(path, n, 1, n, 5)) for n in range(1, count + 1))


EVERY_CODE = tuple(Diagnostic(code, "said", Span("every.py", n, 1, n, 2), "do that") for n, code in enumerate(CODES, 1))
REPORTS = {
    "nothing at all": Report(()),
    "clean": Report((), ("one.py", "two.py")),
    "odd": Report((ODD, LONG, PLACELESS), (ODD_PATH, "clean.py"), line_of, 2, skipped={"in the baseline": 3}),
    "placeless only": Report((PLACELESS,)),
    "denied": Report((ODD, *many("CG506", 2)), (ODD_PATH,), line_of, deny_warnings=True),
    "hundred": Report(many("CG501", 100), ("many.py",)),
    "every code": Report(EVERY_CODE, ("every.py",)),
}
every_report = pytest.mark.parametrize("report", REPORTS.values(), ids=list(REPORTS))


def one(code: str, path: str = "one.py", message: str = "said") -> Report:
    return Report((Diagnostic(code, message, Span(path, 3, 5, 3, 9)),), (path,))


# -- of all formats ---------------------------------------------------------------------------------------------------


@every_report
@pytest.mark.parametrize("format", FORMATS)
def test_a_report_is_the_same_each_time_and_ends_its_last_line(format: str, report: Report) -> None:
    text = render(format, report)
    assert text == render(format, report)
    assert text == "" or text.endswith("\n")
    assert report.findings or format in MACHINES or not text


@every_report
@pytest.mark.parametrize("format", ["json", "gitlab", "sarif", "junit"])
def test_a_document_is_written_in_ascii(format: str, report: Report) -> None:
    """So that no console's code page can break it."""
    assert render(format, report).isascii()


@pytest.mark.parametrize("format", FORMATS)
def test_the_command_writes_every_format(
    format: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "prog.py").write_text("def main():\n    if c.A:\n        outt(c.B)\n")
    assert main(["check", "prog.py", "--no-cache", "--output-format", format]) == 1
    assert "CG108" in capsys.readouterr().out
    assert main(["check", "prog.py", "--no-cache", "--output-format", format, "-o", "report"]) == 1
    assert "CG108" in (tmp_path / "report").read_text("utf-8")
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("format", MACHINES)
def test_paths_are_relative_to_the_working_folder_and_have_slashes(
    format: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "plant").mkdir()
    monkeypatch.chdir(tmp_path)
    below = os.path.join("plant", "prog.py")
    text = render(format, one("CG501", below))
    assert text == render(format, one("CG501", str(tmp_path / below)))
    assert "plant/prog.py" in text
    assert tmp_path.as_posix() not in text
    monkeypatch.chdir(tmp_path / "plant")
    assert "plant" not in render(format, one("CG501", str(tmp_path / below)))


def test_what_the_rules_really_find_goes_into_every_format(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for rule in RULES:
        for number, example in enumerate(rule.wrong):
            Path(f"{rule.code}_{number}.py").write_text(program_of(example.text), "utf-8")
    for format in FORMATS:
        main(["check", ".", "--select", "ALL", "--output-format", format, "-o", f"report.{format}"])
    found = json.loads(Path("report.json").read_text())["findings"]
    assert {finding["code"] for finding in found} >= {rule.code for rule in RULES}
    assert any(finding["fix"] for finding in found)
    assert len(json.loads(Path("report.gitlab").read_text())) == len(found)
    log = json.loads(Path("report.sarif").read_text())
    assert [error.message for error in _SARIF.iter_errors(log)] == []
    assert len(log["runs"][0]["results"]) == len(found)
    cases = list(ET.parse("report.junit").iter("testcase"))
    _JUNIT.validate("report.junit")
    assert sum(len(case) for case in cases) == len(found)
    for line in Path("report.github").read_text("utf-8").splitlines():
        parse_command(line)


# -- json -------------------------------------------------------------------------------------------------------------


def test_json_holds_everything() -> None:
    tree = json.loads(render("json", REPORTS["odd"]))
    nowhere = dict.fromkeys(("file", "line", "column", "end_line", "end_column", "cell"))
    odd, long, placeless = tree.pop("findings")
    assert tree == {
        "format": 1,
        "tool": {"name": "clickgen", "version": clickgen.__version__},
        "counts": {
            "files": 2,
            "error": 2,
            "warning": 1,
            "info": 0,
            "fixable": 1,
            "fixed": 2,
            "not_shown": {"in the baseline": 3},
        },
    }
    assert odd == {
        "code": "CG501",
        "severity": "warning",
        "title": CODES["CG501"].title,
        "message": ODD.message,
        "help": ODD.help,
        "file": ODD_PATH,
        "line": 2,
        "column": 16,
        "end_line": 2,
        "end_column": 19,
        "cell": None,
        "labels": [
            {
                "text": "here [x]",
                "file": ODD_PATH,
                "line": 3,
                "column": 9,
                "end_line": 3,
                "end_column": 21,
                "cell": None,
            },
            {
                "text": "and there",
                "file": "other.py",
                "line": 7,
                "column": 1,
                "end_line": 8,
                "end_column": 2,
                "cell": None,
            },
        ],
        "fix": {
            "safe": True,
            "edits": [
                {
                    "text": "set(y.Motor)",
                    "file": ODD_PATH,
                    "line": 5,
                    "column": 9,
                    "end_line": 5,
                    "end_column": 21,
                    "cell": None,
                },
                {
                    "text": "    # now\n",
                    "file": ODD_PATH,
                    "line": 4,
                    "column": 1,
                    "end_line": 4,
                    "end_column": 1,
                    "cell": None,
                },
            ],
        },
    }
    assert (long["end_line"], long["fix"], long["labels"]) == (9, None, [])
    assert placeless == {
        "code": "CG401",
        "severity": "error",
        "title": CODES["CG401"].title,
        "message": PLACELESS.message,
        "help": "",
        **nowhere,
        "labels": [],
        "fix": None,
    }


def test_json_says_how_serious_a_denied_finding_is() -> None:
    tree = json.loads(render("json", REPORTS["denied"]))
    assert {finding["severity"] for finding in tree["findings"]} == {"error"}
    assert tree["counts"]["error"] == 3


def test_a_fix_can_be_read_back_from_json() -> None:
    (finding,) = json.loads(render("json", Report((ODD,))))["findings"]
    edits = tuple(
        Edit(Span(e["file"], e["line"], e["column"], e["end_line"], e["end_column"]), e["text"])
        for e in finding["fix"]["edits"]
    )
    assert apply_fixes(SOURCE, [Fix(edits)]) == apply_fixes(SOURCE, [FIX])


# -- github -----------------------------------------------------------------------------------------------------------

Command = tuple[str, dict[str, str], str]


def parse_command(line: str) -> Command:
    """A line as the runner reads it: TryParseV2 in ActionCommand.cs of https://github.com/actions/runner."""
    assert line.startswith("::")
    end = line.index("::", 2)
    name, _, pairs = line[2:end].partition(" ")
    properties = {}
    for pair in filter(None, pairs.strip().split(",")):
        key, _, value = pair.partition("=")
        assert value, f"the runner leaves out {pair!r}"
        for token, char in (("%0D", "\r"), ("%0A", "\n"), ("%3A", ":"), ("%2C", ","), ("%25", "%")):
            value = value.replace(token, char)
        properties[key] = value
    data = line[end + 2 :]
    for token, char in (("%0D", "\r"), ("%0A", "\n"), ("%25", "%")):
        data = data.replace(token, char)
    return name, properties, data


def commands(report: Report) -> list[Command]:
    """What a runner that reads the output line by line makes of it."""
    return [parse_command(line) for line in re.split("\r\n|\r|\n", render("github", report))[:-1]]


def test_a_command_says_all_of_a_finding() -> None:
    report = Report((Diagnostic("CG501", "twice", Span("a.py", 5, 9, 5, 21), "join", ODD.labels),))
    assert render("github", report) == (
        "::warning file=a.py,line=5,endLine=5,col=9,endColumn=20,title=CG501::"
        "twice%0Anote: here [x] (süd, ost/50%25:pumpe.py:3)%0Anote: and there (other.py:7)%0Ahelp: join\n"
    )


def test_what_is_odd_comes_through_the_commands() -> None:
    error, placeless, warning = commands(REPORTS["odd"])
    assert error[1] == {"file": "other.py", "line": "7", "endLine": "9", "title": "CG403"}
    assert placeless == ("error", {"title": "CG401"}, PLACELESS.message)
    assert warning[0] == "warning"
    assert warning[1]["file"] == ODD_PATH
    assert "note: here [x] (line 3)\n" in warning[2]
    assert warning[2].endswith("help: one, two: three\nfour")
    assert "100% <b>&" in warning[2]
    assert not re.search("[\x00\x1b\x85\u2028]", warning[2])


@given(st.text(st.characters(codec="utf-8"), min_size=1), st.text(st.characters(codec="utf-8")))
def test_any_text_comes_through_a_command(path: str, message: str) -> None:
    name = f"p{path}".replace("/", "").replace("\\", "").replace("\0", "")
    message = "".join(char for char in message if char.isprintable() or char == "\n")
    ((level, properties, data),) = commands(one("CG506", name, message))
    assert (level, properties["file"], data) == ("notice", escaped(name), message)


def test_a_file_name_that_steers_a_terminal_is_written_out() -> None:
    name = "a\x1b[31m\u202eb\x85\n.py"
    finding = Diagnostic("CG506", "x", Span("b.py", 1, 1, 1, 2), labels=(Label(Span(name, 1, 1, 1, 2), "here"),))
    for report in (one("CG506", name, "x"), Report((finding,), ("b.py",))):
        text = render("github", report)
        assert not re.search("[\x1b\u202e\x85]", text)
        assert "\\x1b[31m\\u202eb\\x85\\n.py" in text


def test_github_gets_the_most_serious_and_is_told_of_the_rest() -> None:
    warnings, notes, errors = many("CG501", 12), many("CG506", 15), many("CG403", 11)
    found = commands(Report((*warnings, *notes, *errors)))
    assert [level for level, _, _ in found] == ["error"] * 10 + ["warning"] * 10 + ["notice"] * 10
    level, properties, text = found[-1]
    assert (level, properties) == ("notice", {"title": "clickgen"})
    assert text.startswith("1 error, 2 warnings, 6 notes more:")
    assert "clickgen check" in text
    assert [properties["line"] for level, properties, _ in found[:10]] == [str(n) for n in range(1, 11)]


def test_what_fits_the_limits_needs_no_summary() -> None:
    report = Report((*many("CG501", 10), *many("CG506", 10), *many("CG403", 10)))
    assert Counter(properties["title"] for _, properties, _ in commands(report)) == dict.fromkeys(
        ("CG403", "CG501", "CG506"), 10
    )


def test_a_denied_warning_is_an_error_for_github() -> None:
    assert {level for level, _, _ in commands(REPORTS["denied"])} == {"error"}


@every_report
def test_columns_stand_only_where_the_runner_takes_them(report: Report) -> None:
    for _, properties, _ in commands(report):
        if "col" in properties:
            assert properties["line"] == properties["endLine"]
            assert int(properties["endColumn"]) >= int(properties["col"]) >= 1


# -- fingerprints -----------------------------------------------------------------------------------------------------


def findings_of(text: str) -> Report:
    """A finding wherever a line of the text says ``out``, with the number of a line in its message."""
    lines = text.split("\n")
    found = [
        Diagnostic("CG501", f"as in line {n - 1}", Span("p.py", n, line.index("out") + 1, n, len(line) + 1))
        for n, line in enumerate(lines, 1)
        if "out" in line
    ]
    return Report(tuple(found), ("p.py",), lambda _, n: lines[n - 1])


def test_a_fingerprint_stays_while_lines_move() -> None:
    before = findings_of("if a:\n    out(y[1])\nif b:\n    out(y[2])\n")
    after = findings_of("# new\n\nif c:\n    if a:\n        out(y[1])\nif b:\n    out(y[2])\n")
    assert fingerprints(before) == fingerprints(after)


def test_findings_have_different_fingerprints() -> None:
    same = findings_of("out(y[1])\nout(y[1])\nout(y[2])\n")
    assert len(set(fingerprints(same))) == 3
    for report in REPORTS.values():
        assert len(set(fingerprints(report))) == len(report.findings)
    assert fingerprints(one("CG501")) != fingerprints(one("CG502"))
    assert fingerprints(one("CG501")) != fingerprints(one("CG501", "two.py"))


def test_a_fingerprint_does_not_depend_on_the_words() -> None:
    assert fingerprints(one("CG501")) == fingerprints(one("CG501", message="said better"))


# -- gitlab -----------------------------------------------------------------------------------------------------------


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


# -- sarif ------------------------------------------------------------------------------------------------------------

_SARIF_SCHEMA = json.loads((SCHEMAS / "sarif-schema-2.1.0.json").read_text("utf-8"))
_SARIF = jsonschema.Draft7Validator(_SARIF_SCHEMA)


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


# -- junit ------------------------------------------------------------------------------------------------------------

_JUNIT = xmlschema.XMLSchema(str(SCHEMAS / "junit-10.xsd"))


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
