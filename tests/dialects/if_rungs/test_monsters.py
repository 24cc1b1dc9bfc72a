"""Files that nobody writes by hand: each is one problem with a way out, and never the end of a whole check."""

from __future__ import annotations

import io
import json
import os
import sys
from pathlib import Path

import pytest

import clickgen
from clickgen import api
from clickgen.cli import main
from clickgen.config import ConfigError, Settings, read_config
from clickgen.device.banks import parse_address
from clickgen.workspace import Workspace

CLEAN = "def main():\n    if x[1]:\n        out(y[1])\n    if True:\n        end()\n"
HEX = "0x" + "F" * 6000
DECIMAL = "9" * 6000
ACTIONS = {
    "copied": "copy({}, ds[1])",
    "copied negative": "copy(-{}, ds[1])",
    "copied to a float": "copy({}, df[1])",
    "an address": "copy(ds[{}], ds[1])",
    "an immediate address": "copy(x[{}].immediate, c[1])",
    "a pointer": "copy(ds[ds[{}]], ds[1])",
    "the end of a range": "copy_fill(0, ds[1:{}])",
    "the start of a range": "copy_fill(0, ds[{}:1])",
    "the step of a range": "copy_fill(0, ds[1:9:{}])",
    "a member": "copy(0, ds.A[{}])",
    "members": "copy_fill(0, ds.A[{}:9])",
    "a setpoint": "ton(t[1], setpoint={})",
    "a shift": "shift(c[{}:0:-1])",
    "a search": 'search("==", {}, ds[1], ds[9], ds[10], c[1])',
    "padding": "copy(ds[1].as_text(pad={}), txt[1])",
    "a port": 'send(ModbusTcpTarget(ip="1.2.3.4", port={}, device_id=1), "DS1", ds[1:3], c[1], c[2], c[3], ds[9])',
    "a call": "call({})",
    "a formula": 'calc("{} + ds[1]", ds[2])',
    "an address in a formula": 'calc("ds[{}] + ds[1]", ds[2])',
    "a range in a formula": 'calc("SUM(ds[1:{}])", ds[2])',
    "a hexadecimal formula": 'math_hex("{} + dh[1]", dh[2])',
    "a remote address": 'send(ModbusTcpTarget(ip="1.2.3.4", port=502, device_id=1), "DS{}", ds[1:3], c[1], c[2], '
    "c[3], ds[9])",
}
PROGRAMS = {
    **{
        name: f"def main():\n    if x[1]:\n        {action}\n    if True:\n        end()\n"
        for name, action in ACTIONS.items()
    },
    "compared": "def main():\n    if ds[1] == {}:\n        out(y[1])\n    if True:\n        end()\n",
    "compared with a constant": "def main():\n    if 1 == {}:\n        out(y[1])\n    if True:\n        end()\n",
    "a chain": "def main():\n    if 0 < ds[1] < {}:\n        out(y[1])\n    if True:\n        end()\n",
    "a count": "def main():\n    if x[1]:\n        for _ in range({}):\n            pass\n\n"
    + CLEAN.partition("\n")[2],
    "a declared address": "nickname(ds.A, ds[{}])\n" + CLEAN,
    "an initial value": "nickname(ds.A, ds[5], initial={})\n" + CLEAN,
    "a subroutine's name": "@sub({})\ndef a():\n    if True:\n        return\n\n\n" + CLEAN,
    "a constant": "A = {}\n" + CLEAN,
}


@pytest.mark.parametrize(
    "number", [HEX, DECIMAL, "0o" + "7" * 6000, "0b" + "1" * 20000], ids=["hex", "dec", "oct", "bin"]
)
@pytest.mark.parametrize("name", PROGRAMS)
def test_an_endless_number_is_a_problem_in_its_place(name: str, number: str, tmp_path: Path) -> None:
    program = tmp_path / "p.py"
    program.write_text(PROGRAMS[name].format(number), "utf-8")
    result = clickgen.build(program)
    assert not result.ok
    lines = {problem.span.line for problem in result.diagnostics if problem.is_error and problem.span}
    assert lines, result.diagnostics


def test_every_endless_number_is_told(tmp_path: Path) -> None:
    program = tmp_path / "p.py"
    program.write_text(
        f"def main():\n    if ds[{HEX}] == 1:\n        copy({HEX}, ds[1])\n    if True:\n        end()\n"
    )
    found = clickgen.build(program).diagnostics
    assert [(one.code, one.span.line, one.span.col) for one in found if one.span] == [
        ("CG113", 2, 11),
        ("CG113", 3, 14),
    ]


def test_the_largest_numbers_are_judged_by_their_operand(tmp_path: Path) -> None:
    program = tmp_path / "p.py"
    program.write_text(CLEAN.replace("out(y[1])", "copy(0xFFFFFFFFFFFFFFFF, dd[1])"))
    assert [problem.code for problem in clickgen.build(program).diagnostics] == ["CG302"]


@pytest.mark.parametrize("text", ["DS" + DECIMAL, "DS0" + "0" * 6000 + "1", "X" + DECIMAL, "XD" + DECIMAL + "u"])
def test_an_address_has_few_digits(text: str) -> None:
    found = parse_address(text)
    assert found is None or str(found) == "DS1"


# -- settings and baselines -------------------------------------------------------------------------------------------

SETTINGS = {
    "nested lists": ("reserved = " + "[" * 3000 + "]" * 3000, "nested too deeply"),
    "lists that still parse": ("reserved = " + "[" * 100 + "]" * 100, "nested too deeply"),
    "nested tables": ("a = " + "{a=" * 3000 + "1" + "}" * 3000, "nested too deeply"),
    "a dotted key": (".".join(["a"] * 5000) + " = 1", "nested too deeply"),
    "a decimal number": (f"reserved = [{DECIMAL}]", "is not TOML"),
    "a hexadecimal number": (f"reserved = [{HEX}]", "24000 bits"),
    "a start": (f"[allocation]\nDS = {{start = {HEX}}}", "24000 bits"),
}


@pytest.mark.parametrize("name", SETTINGS)
def test_endless_settings_are_named(name: str, tmp_path: Path) -> None:
    text, words = SETTINGS[name]
    file = tmp_path / "clickgen.toml"
    file.write_text(text, "utf-8")
    with pytest.raises(ConfigError, match=words):
        read_config(file)


COUNT = '{"format": 1, "findings": [{"file": "p.py", "code": "CG501", "line": "x", "count": %s}]}'


@pytest.mark.parametrize(
    "text",
    [COUNT % "Infinity", COUNT % "NaN", COUNT % "1e999", COUNT % DECIMAL, "[" * 100_000, '{"a":' * 100_000, "1"],
    ids=["infinity", "nan", "exponent", "digits", "lists", "objects", "number"],
)
def test_a_baseline_that_is_none_is_told(
    text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("p.py").write_text(CLEAN, "utf-8")
    Path("b.json").write_text(text, "utf-8")
    assert main(["check", "p.py", "--baseline", "b.json"]) == 2
    assert "b.json is no baseline that clickgen made" in capsys.readouterr().err


# -- tables of an import ----------------------------------------------------------------------------------------------

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
GRID = ",".join(["marker", *"ABCDEFGHIJKLMNOPQRSTUVWXYZ", "AA", "AB", "AC", "AD", "AE", "AF"])


def bundle(folder: Path, table: str) -> Path:
    wires = ",-" * 30
    rungs = [f"R,DH1==0001h{wires},out(Y001)", f"R,C1{wires},out(Y002)", f"R,-{wires},end()"]
    folder.mkdir()
    (folder / "main.csv").write_text("\n".join((GRID, *rungs, "")), "utf-8")
    (folder / "nicknames.csv").write_text(HEADER + table, "utf-8")
    return folder


@pytest.mark.parametrize("out", ["-", "p.py", "plant/"])
@pytest.mark.parametrize("going", [[], ["--keep-going"]], ids=["", "keep-going"])
@pytest.mark.parametrize(
    ("row", "said"),
    [
        ('C1,"B""T","bad!name",0,No,""', "bad!name"),
        ('"C1",BIT,"bad!name",0,No,""', "bad!name"),
        ('C1,BIT,bad!name,0,No,""', "bad!name"),
        ('DH1,HEX,"Zed",zz,No,""', "cannot start with the value zz"),
        ('DH1,HEX,"Zed",-1,No,""', "cannot start with the value -1"),
        ('DF1,FLOAT,"Zed",inf,No,""', "cannot start with the value inf"),
    ],
)
def test_a_damaged_row_is_a_problem_of_the_import(
    row: str, said: str, out: str, going: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source = bundle(tmp_path / "bundle", row + "\n")
    where = out if out == "-" else str(tmp_path / out) + ("/" if out.endswith("/") else "")
    assert main(["import", str(source), "-o", where, *going]) in (0, 1)
    shown = capsys.readouterr()
    assert said in shown.out + shown.err
    assert "internal error" not in shown.err
    assert "zz" not in shown.out


# -- many files, odd names, closed streams ----------------------------------------------------------------------------


def test_a_chain_of_imports_has_no_end(tmp_path: Path) -> None:
    last = 2000
    for number in range(last + 1):
        onward = f"from f{number + 1} import s{number + 1}\n" if number < last else ""
        routine = f"@sub\ndef s{number}():\n    if True:\n        return\n"
        main_routine = "def main():\n    if x[1]:\n        call(s1)\n    if True:\n        end()\n"
        (tmp_path / f"f{number}.py").write_text(onward + (routine if number else main_routine), "utf-8")
    result = clickgen.build(tmp_path / "f0.py")
    assert result.ok, result.diagnostics
    assert len(result.sources) == last + 1


def test_a_long_circle_is_shown_in_short(tmp_path: Path) -> None:
    for number in range(40):
        (tmp_path / f"f{number}.py").write_text(
            f"import f{(number + 1) % 40}\n" + (CLEAN if not number else ""), "utf-8"
        )
    [problem] = clickgen.build(tmp_path / "f0.py").diagnostics
    assert problem.code == "CG122"
    shown = "f0.py -> f1.py -> f2.py -> f3.py -> f4.py -> f5.py -> ... -> f35.py -> "
    assert shown in problem.message
    assert problem.message.endswith("f39.py -> f0.py")


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="file names are text there")
def test_a_file_name_that_is_no_text_builds(tmp_path: Path) -> None:
    program = tmp_path / os.fsdecode(b"a\xff.py")
    program.write_text(CLEAN, "utf-8")
    result = clickgen.build(program)
    result.write(tmp_path / "out")
    places = json.loads((tmp_path / "out" / "sources.json").read_text("utf-8"))
    assert os.fsencode(places["routines"]["main"][0]["file"]) == b"a\xff.py"
    assert "CLICK program a\\udcff" in (tmp_path / "out" / "listing.txt").read_text("utf-8")


def test_a_closed_standard_input_is_told(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "stdin", None)
    assert main(["check", "-"]) == 2
    assert "the standard input is closed" in capsys.readouterr().err


# -- one bad file is one problem --------------------------------------------------------------------------------------


@pytest.mark.parametrize("count", [2, 6])
def test_a_program_that_cannot_be_judged_does_not_hide_the_others(
    count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for number in range(count):
        folder = tmp_path / f"plc{number}"
        folder.mkdir()
        (folder / "p.py").write_text(CLEAN.replace("out(y[1])", "ouch(y[1])"), "utf-8")
    Path("plc1/nicknames.csv").write_bytes("Address".encode("utf-16"))
    assert main(["check", "--output-format", "concise"]) == 1
    said = capsys.readouterr().out.replace("\\", "/")
    assert "plc1/p.py:1:1: CG140" in said
    assert "UTF-16" in said
    assert said.count("CG108") == count - 1


def test_a_fault_of_clickgen_is_a_problem_of_one_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("a", "b"):
        Path(f"{name}.py").write_text(CLEAN.replace("out(y[1])", "ouch(y[1])"), "utf-8")
    judged = api.check

    def check(path: str, settings: Settings, workspace: Workspace) -> api.CheckResult:
        if path == "a.py":
            raise ZeroDivisionError("no such luck")
        return judged(path, settings, workspace)

    monkeypatch.setattr(api, "check", check)
    for _ in range(2):  # it is not remembered either
        assert main(["check", "--output-format", "concise"]) == 1
        said = capsys.readouterr().out
        assert "a.py:1:1: CG140 internal error: ZeroDivisionError: no such luck" in said
        assert "b.py:3:9: CG108" in said


def test_stdin_is_read_once_it_is_there(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(CLEAN.encode())))
    assert main(["check", "-"]) == 0
    capsys.readouterr()
