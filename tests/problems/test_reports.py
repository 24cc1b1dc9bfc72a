"""The findings of a check in every format: compared with the schema or the rules of their reader."""

from __future__ import annotations

import json
import os
import re
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from findings_to_report import (
    _JUNIT,
    _SARIF,
    FIX,
    MACHINES,
    ODD,
    ODD_PATH,
    PLACELESS,
    REPORTS,
    SOURCE,
    every_report,
    many,
    one,
)
from hypothesis import given
from hypothesis import strategies as st
from test_examples import WRONG, program_of

import clickgen
from clickgen.cli import main
from clickgen.problems.codes import CODES
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.problems.formats import FORMATS
from clickgen.problems.report import Report, render
from clickgen.problems.report.fingerprints import fingerprints
from clickgen.text.edits import Edit, Fix, apply_fixes
from clickgen.text.source import Span
from clickgen.text.wording import escaped

# -- of all formats ----------------------------------------------------------------------------------------------------


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
    for number, example in enumerate(WRONG):
        Path(f"{example.code.name}_{number}.py").write_text(program_of(example.wrong.text), "utf-8")
    # Beside the others, a file without a main is a part of a program.
    codes = {example.code.name for example in WRONG} - {"CG401"}
    for format in FORMATS:
        main(["check", ".", "--select", "ALL", "--output-format", format, "-o", f"report.{format}"])
    found = json.loads(Path("report.json").read_text())["findings"]
    assert {finding["code"] for finding in found} >= codes
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


# -- json --------------------------------------------------------------------------------------------------------------


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


# -- github ------------------------------------------------------------------------------------------------------------


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
    """The problems that a runner finds in the output, line by line."""
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


# -- fingerprints ------------------------------------------------------------------------------------------------------


def findings_of(text: str) -> Report:
    """A finding at every line of the text that has ``out``, with the number of a line in its message."""
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
