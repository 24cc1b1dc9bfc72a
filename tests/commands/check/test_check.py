"""``clickgen check`` as a user sees it: its files, its messages, its fixes, and its exit codes."""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from clickgen.cli import main
from clickgen.problems.codes import CODES, waits_for_errors
from clickgen.rules.select import Selection

DOUBLE = """\
def main():
    if c.Auto:
        out(y[1])
    if c.Manual:
        out(y[1])
    if True:
        end()
"""
CLEAN = "def main():\n    if c.A:\n        out(c.B)\n    if True:\n        end()\n"
BROKEN = "def main():\n    if c.A and c.B:\n        out(c.C)\n"
ALWAYS_CALLS = "from parts import fill\n\n\n" + CLEAN.replace(
    "if c.A:\n        out(c.B)", "if True:\n        call(fill)"
)
PART = "@sub\ndef fill():\n    if c.A:\n        out(c.B)\n    if True:\n        return\n"


class Said(NamedTuple):
    code: int
    out: str
    err: str


Check = Callable[..., Said]


@pytest.fixture
def check(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Check:
    """Run ``clickgen check`` with these arguments in a folder of its own."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> Said:
        try:
            code = main(["check", *arguments])
        except SystemExit as stop:
            code = int(str(stop.code))
        said = capsys.readouterr()
        assert "Traceback" not in said.err
        return Said(code, said.out, said.err)

    return run


def write(path: str, text: str) -> Path:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, "utf-8")
    return file


def codes(said: Said) -> list[str]:
    """The codes of a concise report."""
    return [line.split(" ")[1] for line in said.out.splitlines() if ": CG" in line]


# -- how it ends ------------------------------------------------------------------------------------------------------


def test_a_clean_program_is_exit_0_and_says_so(check: Check) -> None:
    write("plc.py", CLEAN)
    assert check("plc.py") == (0, "1 file checked, all is well\n", "")
    assert check("plc.py", "-q") == (0, "", "")


def test_findings_are_exit_1_on_the_standard_output(check: Check) -> None:
    write("plc.py", DOUBLE)
    said = check("plc.py")
    assert said.code == 1
    assert said.err == ""
    assert said.out.startswith("plc.py:5:9: warning[CG501]: Y001 is driven by out in line 3 already")
    assert said.out.endswith("\n\n1 warning in 1 file\n")


def test_errors_are_findings_too(check: Check) -> None:
    write("plc.py", BROKEN)
    said = check("plc.py", "--output-format", "concise")
    assert said.code == 1
    assert codes(said) == ["CG105"]


def test_notes_alone_do_not_fail(check: Check) -> None:
    rtof = "def main():\n    if c.A:\n        rtof(t.B, 5, reset=lambda: c.R)\n    if True:\n        end()\n"
    write("plc.py", rtof)
    assert check("plc.py").code == 0
    said = check("plc.py", "--deny-warnings")
    assert said.code == 1
    assert "error[CG420]" in said.out


def test_exit_zero_shows_and_does_not_fail(check: Check) -> None:
    write("plc.py", DOUBLE)
    said = check("plc.py", "--exit-zero")
    assert said.code == 0
    assert "CG501" in said.out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("nowhere.py",), "there is no file or folder nowhere.py"),
        (("--output-format", "xml"), "there is no format 'xml'"),
        (("--output-format", "jsn"), "did you mean json?"),
        (("--select", "CG999"), "clickgen has no code 'CG999'"),
        (("--ignore", "E501"), "clickgen has no code 'E501'"),
        (("--selct", "CG5"), "did you mean --select?"),
        (("--unsafe-fixes",), "--unsafe-fixes goes with --fix or --diff"),
        (("--fix", "--diff"), "give one of them"),
        (("--add-ignore", "--fix"), "give one of them"),
        (("-", "plc.py"), "- stands alone"),
        (("--config", "nowhere.toml"), "nowhere.toml cannot be read"),
        (("--baseline", "plc.py", "plc.py"), "plc.py is no baseline"),
    ],
)
def test_what_cannot_run_is_exit_2(check: Check, arguments: tuple[str, ...], words: str) -> None:
    write("plc.py", DOUBLE)
    said = check(*arguments)
    assert said.code == 2
    assert said.out == ""
    assert words in said.err


# -- what is looked at ------------------------------------------------------------------------------------------------


def test_folders_are_searched_for_programs(check: Check) -> None:
    write("a/plc.py", DOUBLE)
    write("b/plc.py", DOUBLE)
    write("tool.py", "import sys\n\n\ndef main():\n    args = sys.argv\n    print(args)\n\n\nmain()\n")
    write("helper.py", "def main():\n    x = 1\n    y = 2\n    return x + y\n")
    write("build/old.py", DOUBLE)
    write(".hidden/old.py", DOUBLE)
    said = check("--output-format", "concise")
    assert [line.partition(":")[0] for line in said.out.splitlines()[:-1]] == ["a/plc.py", "b/plc.py"]


def test_a_broken_program_is_found_too(check: Check) -> None:
    write("plc.py", "def main():\n    if c.A\n        out(c.B)\n    if True:\n        end()\n")
    assert codes(check(".", "--output-format", "concise")) == ["CG101"]


def test_a_file_without_a_main_is_checked_as_part_of_its_program(check: Check) -> None:
    write("plc.py", ALWAYS_CALLS)
    write("parts.py", PART.replace("out(c.B)", "out(c.B)\n    if c.C:\n        out(c.B)"))
    said = check("parts.py", "--output-format", "concise")
    assert said.out.startswith("parts.py:6:9: CG501 ")
    assert codes(said) == ["CG501"]


def test_a_part_that_nothing_imports_is_not_asked_for_a_main(check: Check) -> None:
    write("parts.py", PART)
    assert check("parts.py").code == 0
    write("parts.py", PART.replace("c.A", "c.A and c.B"))
    assert codes(check("parts.py", "--output-format", "concise")) == ["CG105"]


def test_a_file_of_two_programs_has_its_findings_once(check: Check) -> None:
    for name in ("one", "two"):
        write(f"{name}.py", "from parts import fill\n\n\n" + CLEAN.replace("out(c.B)", "call(fill)"))
    write("parts.py", PART.replace("if c.A", "if c.A == 1"))
    assert codes(check(".", "--output-format", "concise")) == ["CG303"]


def test_excluded_paths_are_left_out(check: Check) -> None:
    write("a/plc.py", DOUBLE)
    write("b/plc.py", DOUBLE)
    assert "a/plc.py" not in check(".", "--exclude", "a").out
    assert "a/plc.py" in check("a/plc.py", "--exclude", "a").out
    assert check("a/plc.py", "--exclude", "a", "--force-exclude").out == "0 files checked, all is well\n"
    write("tool.py", "import sys\n\nprint(sys.argv)\n")
    assert check("tool.py", "--force-exclude").out == "0 files checked, all is well\n"
    assert check("tool.py").code == 1


def test_the_standard_input_is_a_program(check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(DOUBLE.encode())))
    said = check("-", "--stdin-filename", "lib/plc.py", "--output-format", "concise")
    assert said.out.startswith("lib/plc.py:5:9: CG501 ")
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(BROKEN.encode())))
    said = check("-", "--fix", "-q")
    assert said.out == "def main():\n    if all(c.A, c.B):\n        out(c.C)\n    if True:\n        end()\n"
    assert said.code == 0


# -- choosing ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("selection", "code", "wanted"),
    [
        (Selection(), "CG501", True),
        (Selection(), "CG504", False),
        (Selection(("CG504",)), "CG504", True),
        (Selection(("CG504",)), "CG501", False),
        (Selection(("CG",)), "CG504", True),
        (Selection(None, ("CG504",)), "CG504", True),
        (Selection(None, ("CG504",)), "CG501", True),
        (Selection(None, (), ("CG5",)), "CG501", False),
        (Selection(None, ("CG501",), ("CG5",)), "CG501", True),
        (Selection(("CG5",), (), ("CG50",)), "CG501", False),
        (Selection(("CG501",), (), ("CG501",)), "CG501", False),
        (Selection(("CG5",), (), ("CG1",)), "CG105", True),
        (Selection(("CG5",)), "CG312", False),
    ],
)
def test_the_most_specific_wins_and_errors_always_show(selection: Selection, code: str, wanted: bool) -> None:
    assert selection.wants(code) is wanted


def test_the_command_line_replaces_the_selection_of_the_settings(check: Check) -> None:
    write("plc.py", DOUBLE)
    write("clickgen.toml", '[check]\nignore = ["CG501"]\n')
    assert check("plc.py").code == 0
    assert check("plc.py", "--select", "CG5").code == 1
    assert check("plc.py", "--extend-select", "CG501").code == 0


def test_files_can_have_ignores_of_their_own(check: Check) -> None:
    write("old/plc.py", DOUBLE)
    write("new/plc.py", DOUBLE)
    write("pyproject.toml", '[tool.clickgen.check.per-file-ignores]\n"old/*" = ["CG5"]\n')
    assert [line.partition(":")[0] for line in check(".", "--output-format", "concise", "-q").out.splitlines()] == [
        "new/plc.py"
    ]


# -- silencing --------------------------------------------------------------------------------------------------------


def silenced(comment_at: int, comment: str) -> str:
    """DOUBLE with a comment: after a line, or above it if the comment has the line's indentation."""
    lines = DOUBLE.split("\n")
    if comment.startswith(" "):
        lines.insert(comment_at - 1, comment)
    else:
        lines[comment_at - 1] += f"  {comment}"
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("line", "comment"),
    [
        (5, "# clickgen: ignore[CG501] the bench drives it too"),
        (5, "# a word # clickgen: ignore[ CG501 , CG513 ]"),
        (4, "    # clickgen: ignore[CG501]"),
        (5, "        # clickgen: ignore[CG501]"),
        (4, "    # clickgen: file-ignore[CG501]"),
    ],
)
def test_a_comment_silences(check: Check, line: int, comment: str) -> None:
    write("plc.py", silenced(line, comment))
    assert codes(check("plc.py", "--output-format", "concise", "--ignore", "CG525")) == []


@pytest.mark.parametrize(
    ("line", "comment", "expected"),
    [
        (3, "# clickgen: ignore[CG501]", ["CG525", "CG501"]),
        (5, "# clickgen: ignore[CG513]", ["CG501", "CG525"]),
        (5, "# clickgen: ignore[CG501, CG513]", ["CG525"]),
        (5, "# clickgen: ignore", ["CG501", "CG525"]),
        (5, "# clickgen: ignroe[CG501]", ["CG501", "CG525"]),
        (5, "# clickgen: ignore[CG105]", ["CG501", "CG525"]),
        (5, "# clickgen: ignore[CG5]", ["CG501", "CG525"]),
    ],
)
def test_a_comment_that_silences_nothing_is_told(check: Check, line: int, comment: str, expected: list[str]) -> None:
    write("plc.py", silenced(line, comment))
    assert codes(check("plc.py", "--output-format", "concise")) == expected


def test_an_error_cannot_be_silenced(check: Check) -> None:
    write("plc.py", BROKEN.replace("c.B:", "c.B:  # clickgen: ignore[CG105]"))
    assert codes(check("plc.py", "--output-format", "concise")) == ["CG105", "CG525"]


def test_what_was_not_judged_is_not_called_unused(check: Check) -> None:
    write("plc.py", silenced(5, "# clickgen: ignore[CG501]"))
    assert check("plc.py", "--select", "CG4,CG525").code == 0
    # With an error in it, a program is not judged by the rules about logic.
    write("plc.py", silenced(5, "# clickgen: ignore[CG501]").replace("        end()", "        out(c.A and c.B)"))
    assert "CG525" not in check("plc.py").out


@pytest.mark.parametrize("code", [code for code in CODES if waits_for_errors(code)])
def test_what_waits_for_errors_is_not_called_unused_before(code: str, check: Check) -> None:
    """An error stops the stage that would report it, so nobody knows whether the comment is needed."""
    write("plc.py", silenced(5, f"# clickgen: ignore[{code}]").replace("        end()", "        out(c.A and c.B)"))
    assert codes(check("plc.py", "--output-format", "concise")) == ["CG113"]


def test_unused_comments_are_removed(check: Check) -> None:
    text = silenced(5, "# clickgen: ignore[CG501, CG513] why").replace(
        "    if True", "    # clickgen: ignore[CG502]\n    if True"
    )
    file = write("plc.py", text)
    assert check("plc.py", "--fix").code == 0
    assert file.read_text("utf-8") == silenced(5, "# clickgen: ignore[CG501] why")


def test_ignores_can_be_added(check: Check) -> None:
    file = write("plc.py", DOUBLE)
    said = check("plc.py", "--add-ignore")
    assert said == (0, "", "1 finding silenced in 1 file\n")
    assert file.read_text("utf-8") == silenced(5, "# clickgen: ignore[CG501]")
    assert check("plc.py").code == 0


def test_ignores_join_those_that_are_there_and_stand_above_lines_that_go_on(check: Check) -> None:
    text = (
        "def main():\n    if c.A:\n        out(y[1])\n    if x[1]:\n"
        "        ctu(ct[1], 5)  # clickgen: ignore[CG418] bench\n"
        "    if c.B:\n        out(\\\n            y[1])\n    if True:\n        end()\n"
    )
    file = write("plc.py", text)
    check("plc.py", "--add-ignore")
    assert file.read_text("utf-8") == text.replace("[CG418] bench", "[CG418, CG513] bench").replace(
        "        out(\\\n", "        # clickgen: ignore[CG501]\n        out(\\\n"
    )
    assert check("plc.py").code == 0


def test_a_baseline_hides_what_was_there(check: Check) -> None:
    file = write("plc.py", DOUBLE)
    said = check("--baseline", "old.json")
    assert said == (
        0,
        "1 file checked, all is well; 1 not shown (in the baseline)\n",
        "clickgen: 1 finding written to old.json\n",
    )
    file.write_text("\n\n" + DOUBLE.replace("    if True", "    if c.More:\n        out(y[1])\n    if True"), "utf-8")
    said = check("--baseline", "old.json", "--output-format", "concise")
    assert said.code == 1
    assert codes(said) == ["CG501"]
    Path("old.json").write_text('{"format": 7}', "utf-8")
    assert check("--baseline", "old.json").code == 2


# -- mending ----------------------------------------------------------------------------------------------------------


def test_fixes_keep_every_other_byte(check: Check) -> None:
    file = Path("plc.py")
    file.write_bytes(b"\xef\xbb\xbf" + BROKEN.replace("c.C)", "c.C)  # caf\u00e9").replace("\n", "\r\n").encode())
    said = check("plc.py", "--fix")
    assert said.code == 0
    assert said.out.endswith("2 fixed\n")
    fixed = "def main():\n    if all(c.A, c.B):\n        out(c.C)  # caf\u00e9\n    if True:\n        end()\n"
    assert file.read_bytes() == b"\xef\xbb\xbf" + fixed.replace("\n", "\r\n").encode()
    assert check("plc.py", "--fix").out == "1 file checked, all is well\n"


def test_a_diff_shows_and_changes_nothing(check: Check) -> None:
    file = write("plc.py", BROKEN)
    said = check("plc.py", "--diff")
    assert said.code == 1
    assert "-    if c.A and c.B:\n+    if all(c.A, c.B):\n" in said.out
    assert file.read_text("utf-8") == BROKEN
    write("plc.py", CLEAN)
    assert check("plc.py", "--diff") == (0, "", "")


# -- telling ----------------------------------------------------------------------------------------------------------


def test_a_report_goes_into_a_file(check: Check) -> None:
    write("plc.py", DOUBLE)
    said = check("plc.py", "--output-format", "json", "-o", "out/report.json")
    assert (said.code, said.out) == (1, "")
    assert json.loads(Path("out/report.json").read_text("utf-8"))["findings"][0]["code"] == "CG501"


def test_statistics_count(check: Check) -> None:
    write("plc.py", silenced(5, "# clickgen: ignore[CG513]"))
    assert check("plc.py", "--statistics", "-q").out == (
        "1  CG501       an output coil is driven in two places\n1  CG525  [*]  a suppression suppresses nothing\n"
    )


def test_a_repeated_run_says_the_same_out_of_the_cache(check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    write("plc.py", DOUBLE)
    first = check(".")
    assert (Path(".clickgen_cache") / ".gitignore").read_text("utf-8") == "*\n"
    monkeypatch.setattr("clickgen.commands.check.judging.judge", None)
    assert check(".") == first


@pytest.mark.parametrize("damage", [b"", b"{", b'{"key": 1}', b"[]", b"\xff"])
def test_a_damaged_cache_is_no_cache(check: Check, damage: bytes) -> None:
    write("plc.py", DOUBLE)
    first = check(".")
    for path in Path(".clickgen_cache").glob("*.json"):
        path.write_bytes(damage)
    assert check(".") == first


def test_a_cached_result_knows_what_it_was_made_of(check: Check) -> None:
    write("plc.py", ALWAYS_CALLS)
    assert codes(check(".", "--output-format", "concise")) == ["CG121"]
    write("parts.py", PART)
    assert check(".").code == 0
    write("parts.py", PART.replace("c.A", "ds.A"))
    write("nicknames.csv", 'Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\nC1,BIT,"A",0,No,""\n')
    assert "CG204" in codes(check(".", "--output-format", "concise"))


def test_nothing_is_cached_when_it_is_not_wanted(check: Check) -> None:
    write("plc.py", DOUBLE)
    check(".", "--no-cache")
    assert not Path(".clickgen_cache").exists()


def test_many_programs_use_all_cores_and_come_in_order(check: Check) -> None:
    for number in range(6):
        write(f"p{number}/plc.py", DOUBLE)
    said = check(".", "--output-format", "concise", "-q")
    assert [line[:2] for line in said.out.splitlines()] == [f"p{number}" for number in range(6)]
