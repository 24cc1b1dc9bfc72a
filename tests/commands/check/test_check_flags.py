"""Combined flags of ``clickgen check``, unusual streams, and comments that clickgen ignores."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from test_check import CLEAN, DOUBLE, Check, check, codes, write

from clickgen.cli import main

__all__ = ["check"]

MENDABLE = "def main():\n    if c.A and c.B:\n        out(c.C)\n    if True:\n        end()\n"
TWICE = DOUBLE.replace("    if True:", "    if c.Test:\n        out(y[1])\n    if True:")
"""Three coils: two findings."""


def run(folder: Path, *arguments: str, stdin: bytes = b"", **environment: str) -> subprocess.CompletedProcess[bytes]:
    command = [sys.executable, "-m", "clickgen", "check", *arguments]
    surroundings = {**os.environ, **environment}
    return subprocess.run(command, cwd=folder, input=stdin, capture_output=True, env=surroundings, check=False)


# -- flags that exclude each other ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--add-ignore", "-o", "report.txt", "plc.py"), "leave -o out"),
        (("--stdin-filename", "plc.py"), "--stdin-filename names what comes from the standard input"),
        (("--statistics", "--output-format", "sarif", "plc.py"), "--statistics is told as text or concise or json"),
    ],
)
def test_what_contradicts_itself_is_refused(check: Check, arguments: tuple[str, ...], said: str) -> None:
    write("plc.py", CLEAN)
    ended = check(*arguments)
    assert ended.code == 2
    assert said in ended.err


def test_statistics_as_json(check: Check) -> None:
    write("plc.py", DOUBLE)
    said = check("plc.py", "--statistics", "--output-format", "json")
    assert json.loads(said.out)[0] == {
        "code": "CG501",
        "count": 1,
        "fixable": 0,
        "title": "an output coil is driven in two places",
    }


# -- a baseline and what mends ----------------------------------------------------------------------------------------


def test_what_the_baseline_knows_is_not_silenced(check: Check) -> None:
    write("plc.py", DOUBLE)
    check("--baseline", "old.json")
    write("plc.py", TWICE)
    said = check("--baseline", "old.json", "--add-ignore", "--ignore", "CG525")
    assert "1 finding silenced in 1 file" in said.err
    assert Path("plc.py").read_text("utf-8").count("ignore[CG501]") == 1
    assert check("--baseline", "old.json").code == 0


def test_a_baseline_is_found_from_another_folder(check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    write("plc.py", DOUBLE)
    check("plc.py", "--baseline", "old.json")
    Path("below").mkdir()
    monkeypatch.chdir("below")
    assert check("../plc.py", "--baseline", "../old.json").code == 0
    assert check("../plc.py", "--baseline", "../new.json").code == 0
    assert Path("../new.json").read_bytes() == Path("../old.json").read_bytes()


# -- silencing --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "before", ["# clickgen: ignore[CG513] x", "# clickgen: ignore[CG5]", "# clickgen ignore[CG501]"]
)
def test_silencing_ends(check: Check, before: str) -> None:
    """A comment cannot silence its own faults."""
    write("plc.py", DOUBLE.replace("        out(y[1])\n    if True", f"        out(y[1])  {before}\n    if True"))
    check("plc.py", "--add-ignore")
    once = Path("plc.py").read_text("utf-8")
    assert "CG525" not in once
    assert check("plc.py", "--output-format", "concise").out.count("CG501") <= 1
    assert check("plc.py", "--add-ignore").err.startswith("0 findings silenced in 0 files")
    assert Path("plc.py").read_text("utf-8") == once


def test_what_no_comment_silences_is_told(check: Check) -> None:
    write("plc.py", MENDABLE)
    said = check("plc.py", "--add-ignore")
    assert (said.code, said.err) == (
        1,
        "0 findings silenced in 0 files; 1 finding that no comment silences: see clickgen check\n",
    )


@pytest.mark.parametrize(
    ("comment", "help"),
    [
        ("# clickgen ignore[CG501]", "write # clickgen: ignore[CG501]"),
        ("# Clickgen: ignore[CG501]", "write # clickgen: ignore[CG501]"),
        ("# clickgen: Ignore[CG501]", "write # clickgen: ignore[CG501]"),
        ("# clickgen: file-ignore[CG501]", "on a line of its own"),
    ],
)
def test_a_comment_that_is_not_heard_is_told(check: Check, comment: str, help: str) -> None:
    write("plc.py", DOUBLE.replace("        out(y[1])\n    if True", f"        out(y[1])  {comment}\n    if True"))
    said = check("plc.py")
    assert "CG525" in said.out
    assert help in said.out


def test_a_comment_may_speak_of_clickgen(check: Check) -> None:
    write("plc.py", CLEAN.replace("def main", "# clickgen builds this; clickgen ignores nothing here\ndef main"))
    assert check("plc.py").code == 0


def test_two_directives_in_one_comment(check: Check) -> None:
    both = "# clickgen: ignore[CG513] # clickgen: ignore[CG501]"
    write("plc.py", DOUBLE.replace("        out(y[1])\n    if True", f"        out(y[1])  {both}\n    if True"))
    said = check("plc.py", "--output-format", "concise")
    assert codes(said) == ["CG525"]
    assert "CG513" in said.out


@pytest.mark.parametrize("line", ["@sub  # clickgen: ignore[CG515]", "@sub\n# clickgen: ignore[CG515]"])
def test_a_comment_at_the_decorator_speaks_of_the_routine(check: Check, line: str) -> None:
    part = "def fill():\n    if c.A:\n        out(c.D)\n    if True:\n        return\n"
    write("plc.py", f"{CLEAN}\n\n{line}\n{part}")
    assert codes(check("plc.py", "--output-format", "concise")) == []


# -- mending ----------------------------------------------------------------------------------------------------------


def test_a_diff_goes_into_patch_whatever_a_comment_holds(check: Check) -> None:
    odd = "    # a\x0cb\u2028c\x85d\n"
    write("plc.py", MENDABLE.replace("    if c.A", odd + "    if c.A"))
    said = check("plc.py", "--diff")
    assert "No newline" not in said.out
    assert odd.rstrip("\n") in said.out


def test_a_diff_says_what_nothing_mends(check: Check) -> None:
    write("plc.py", DOUBLE)
    said = check("plc.py", "--diff")
    assert (said.code, said.out) == (1, "")
    assert said.err == "clickgen: besides what this mends: 1 warning in 1 file\n"


def test_a_diff_does_not_say_that_something_is_fixed(check: Check) -> None:
    """Nothing was written."""
    text = DOUBLE.replace("    if True:", "    if c.X and c.Y:\n        out(y[9])\n\n    if True:")
    write("plc.py", text)
    said = check("plc.py", "--diff")
    assert said.out
    assert "fixed" not in said.err
    assert Path("plc.py").read_text("utf-8") == text


def test_unsafe_fixes_are_named(check: Check) -> None:
    write("plc.py", "def main():\n    if c.A:\n        copy_pack(c[1:16], dh[1])\n    if True:\n        end()\n")
    said = check("plc.py")
    assert said.out.endswith("1 warning in 1 file; 1 can be fixed with --fix --unsafe-fixes\n")


def test_the_report_of_a_mended_standard_input_goes_where_it_is_asked(
    check: Check, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(MENDABLE.encode())))
    said = check("-", "--fix", "-o", "report.txt")
    assert said.out == MENDABLE.replace("c.A and c.B", "all(c.A, c.B)")
    assert (said.err, Path("report.txt").read_text("utf-8")) == ("", "1 file checked, all is well; 1 fixed\n")


# -- streams ----------------------------------------------------------------------------------------------------------


def test_the_standard_output_gets_the_bytes_of_the_program(tmp_path: Path) -> None:
    text = "\ufeff# caf\u00e9\r\n".encode() + MENDABLE.replace("\n", "\r\n").encode()
    done = run(tmp_path, "-", "--fix", stdin=text, PYTHONIOENCODING="ascii")
    assert done.stdout == text.replace(b"c.A and c.B", b"all(c.A, c.B)")


def test_a_standard_input_that_is_no_text_comes_back_as_it_was(tmp_path: Path) -> None:
    text = b"def main():\n    # \xe9\n"
    done = run(tmp_path, "-", "--fix", stdin=text)
    assert (done.returncode, done.stdout) == (1, text)
    assert b"CG101" in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="a shell closes the stream")
@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_closed_streams_change_nothing(tmp_path: Path, closed: str) -> None:
    (tmp_path / "plc.py").write_text(CLEAN)
    done = subprocess.run(
        f"{sys.executable} -m clickgen check plc.py {closed}",
        shell=True,
        cwd=tmp_path,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0
    assert b"Traceback" not in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="a shell's pipe")
def test_a_reader_that_goes_away_is_no_trouble(tmp_path: Path) -> None:
    for number in range(80):
        (tmp_path / f"p{number}.py").write_text(DOUBLE)
    command = f"{sys.executable} -m clickgen check . --output-format sarif | true"
    done = subprocess.run(command, shell=True, cwd=tmp_path, capture_output=True, check=False)
    assert done.stderr == b""


def test_an_interrupt_while_a_class_is_made_is_an_interrupt(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_: object) -> int:
        raise RuntimeError("Error calling __set_name__") from KeyboardInterrupt()

    monkeypatch.setattr("clickgen.cli.parser.parse", interrupted)
    assert main(["check"]) == 130
    assert capsys.readouterr().err == "clickgen: interrupted; nothing was written\n"


def test_a_group_is_explained_by_its_codes(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "CG60"]) == 2
    assert "it begins CG601, CG602, CG603" in capsys.readouterr().err
