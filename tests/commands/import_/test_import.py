"""``clickgen import``: a project of CLICK becomes a program, verified rung by rung, or nothing is written."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import golden
import pytest
from test_importing_cases import CASE_NAMES, golden_ladders, ladder_text, wired
from test_importing_properties import ruff_changes

import clickgen
from clickgen.cli import main
from clickgen.commands.import_.project import Target, import_project
from clickgen.config import Settings
from clickgen.dialects.if_rungs.write.routine import write_source
from clickgen.problems.codes import CODES

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment"
END, RETURN = wired("", "end()", "R"), wired("", "return()", "R")
SEAL = [wired("X001 T:~X002", "out(Y001)", "R"), wired("Y001", "")]
"""The rungs of a bundle, as rows."""


def write_bundle(
    folder: Path,
    nicknames: str = "",
    main: Sequence[list[str]] = (),
    others: Mapping[str, list[list[str]]] | None = None,
    **routines: list[list[str]],
) -> Path:
    """A bundle with these routines; the rows of main end with ``end()``."""
    (folder / "subroutines").mkdir(parents=True)
    (folder / "main.csv").write_text(ladder_text([*main, END]))
    for name, own in {**(others or {}), **routines}.items():
        (folder / "subroutines" / f"{name}.csv").write_text(ladder_text([*own, RETURN]))
    if nicknames:
        (folder / "nicknames.csv").write_text(f"{HEADER}\n{nicknames}")
    return folder


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def ran(capsys: pytest.CaptureFixture[str], *arguments: str, code: int = 0) -> tuple[str, str]:
    """The output and the complaints of an import that ends with this code."""
    capsys.readouterr()
    found = main(["import", *arguments])
    said = capsys.readouterr()
    assert found == code, said.out + said.err
    return said.out, said.err


def comment(*lines: str) -> list[list[str]]:
    return [["#", line] for line in lines]


# -- what comes out ---------------------------------------------------------------------------------------------------


def test_a_bundle_becomes_one_program(capsys: pytest.CaptureFixture[str]) -> None:
    rows = 'X001,BIT,"Start",0,No,""\nX002,BIT,"Stop",0,No,"wired normally closed"\nY001,BIT,"Motor",0,No,""\n'
    called = wired("SC2", 'call("Init")', "R")
    write_bundle(Path("plant"), rows, main=[*comment("Seal-in.", "", "  indented"), *SEAL, called], Init=[*SEAL])
    out, err = ran(capsys, "plant", "-o", "plant.py")
    assert err == ""
    assert Path("plant.py").read_text() == (
        "def main():\n"
        "    # Seal-in.\n"
        "    #\n"
        "    #   indented\n"
        "    if all(any(x.Start, y.Motor), nc(x.Stop)):\n"
        "        out(y.Motor)\n"
        "\n"
        "    if sc._1st_SCAN:\n"
        "        call(Init)\n"
        "\n"
        "    if True:\n"
        "        end()\n"
        "\n"
        "\n"
        "@sub\n"
        "def Init():\n"
        "    if all(any(x.Start, y.Motor), nc(x.Stop)):\n"
        "        out(y.Motor)\n"
        "\n"
        "    if True:\n"
        "        return\n"
    )
    assert Path("nicknames.csv").read_text() == f"{HEADER}\n{rows}"
    assert out.splitlines()[:3] == [
        "Imported plant into plant.py: 3 rungs in main, 2 rungs in 1 subroutine.",
        "5 of 5 rungs verified, 5 identical cell by cell.",
        "3 nicknames in nicknames.csv: commit it with the program.",
    ]
    result = clickgen.build("plant.py", frozen=True)
    assert result.ok
    for name in ("main.csv", "subroutines/Init.csv"):
        assert result.files[name] == (Path("plant") / name).read_text()


def test_a_folder_gets_one_file_for_each_subroutine(capsys: pytest.CaptureFixture[str]) -> None:
    calls = [wired("X001", 'call("Init")', "R"), wired("X002", 'call("Auto Mode")', "R")]
    write_bundle(Path("plant"), main=calls, others={"Auto Mode": [*SEAL], "Init": [*SEAL]})
    out, _ = ran(capsys, "plant", "-o", "program/")
    assert sorted(path.name for path in Path("program").iterdir()) == ["Auto_Mode.py", "Init.py", "main.py"]
    assert (
        Path("program/main.py")
        .read_text()
        .startswith("from Init import Init\nfrom Auto_Mode import Auto_Mode\n\n\ndef main():\n")
    )
    assert Path("program/Auto_Mode.py").read_text().startswith('@sub("Auto Mode")\ndef Auto_Mode():\n')
    assert "Imported plant into program: " in out
    result = clickgen.build("program/main.py", frozen=True)
    assert [routine.name for routine in result.routines] == ["main", "Init", "Auto Mode"]
    assert result.files["subroutines/Auto Mode.csv"] == Path("plant/subroutines/Auto Mode.csv").read_text()


def test_a_single_file_without_nicknames(capsys: pytest.CaptureFixture[str]) -> None:
    Path("ladder.csv").write_text(ladder_text([*SEAL, END]))
    out, err = ran(capsys, "ladder.csv", "-o", "prog.py")
    assert "x[1], y[1]" in Path("prog.py").read_text()
    assert not Path("nicknames.csv").exists()
    assert "2 of 2 rungs verified" in out
    assert not err


def test_the_program_to_the_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    Path("ladder.csv").write_text(ladder_text([*SEAL, END]))
    Path("nicknames.csv").write_text(f'{HEADER}\nX001,BIT,"Start",0,No,""\n')
    out, err = ran(capsys, "ladder.csv", "-o", "-", "--nicknames", "nicknames.csv")
    assert "any(x.Start, y[1])" in out
    assert "2 of 2 rungs verified" in err
    assert sorted(os.listdir()) == ["ladder.csv", "nicknames.csv"]


def test_the_table_beside_the_program_gives_names(capsys: pytest.CaptureFixture[str]) -> None:
    Path("ladder.csv").write_text(ladder_text([*SEAL, END]))
    Path("nicknames.csv").write_text(f'{HEADER}\nX001,BIT,"Start",0,No,""\n')
    ran(capsys, "ladder.csv", "-o", "prog.py")
    assert "x.Start" in Path("prog.py").read_text()
    assert clickgen.build("prog.py", frozen=True).ok


def test_the_configured_table_is_the_one_that_is_written(capsys: pytest.CaptureFixture[str]) -> None:
    Path("clickgen.toml").write_text('[[programs]]\npath = "plc/prog.py"\nnicknames = "tags/plc.csv"\n')
    write_bundle(Path("plant"), 'X001,BIT,"Start",0,No,""\n', main=SEAL)
    ran(capsys, "plant", "-o", "plc/prog.py")
    assert Path("tags/plc.csv").is_file()
    assert not Path("plc/nicknames.csv").exists()
    assert main(["build", "plc/prog.py", "--frozen"]) == 0


@pytest.mark.parametrize("name", CASE_NAMES)
def test_every_golden_case_comes_back(name: str, tmp_path: Path) -> None:
    """From the whole output folder, nicknames and scratch cells included; and a second import gives the same."""
    folder = tmp_path / "bundle"
    for file, data in golden.expected(golden.CASES / name).items():
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_bytes(data)
    result = import_project(folder, Target(tmp_path / "prog.py"))
    assert result.ok, result.diagnostics
    assert result.verdict is not None
    assert (result.verdict.verified, result.verdict.redrawn) == (result.rungs, [])
    text = result.files[tmp_path / "prog.py"].decode()
    assert ruff_changes(text) == ""
    result.write()
    built = clickgen.build(tmp_path / "prog.py")
    assert {file: built.files[file] for file in golden_ladders(name)} == golden_ladders(name)
    built.write(tmp_path / "again")
    second = import_project(tmp_path / "again", Target(tmp_path / "second" / "prog.py"))
    assert second.files[tmp_path / "second" / "prog.py"].decode() == text


# -- nicknames --------------------------------------------------------------------------------------------------------


def test_names_that_a_program_cannot_use_are_told_and_the_address_is_written(
    capsys: pytest.CaptureFixture[str],
) -> None:
    rows = [
        'X001,BIT,"First X",0,No,""',
        'X002,BIT,"a.b",0,No,"kept"',
        'Y001,BIT,"Twice",0,No,""',
        'C1,BIT,"twice",0,No,""',
        'C2,BIT,"class",0,No,""',
    ]
    drawn = [*SEAL, wired("C1 C2 C3", "out(C4)", "R")]
    write_bundle(Path("plant"), "\n".join(rows) + "\n", main=drawn)
    out, err = ran(capsys, "plant", "-o", "prog.py")
    text = Path("prog.py").read_text()
    assert 'any(x["First X"], y[1]), nc(x[2])' in text
    assert 'all(c[1], c["class"], c[3])' in text
    assert re.findall(r"(\w+)\[(CG\d+)\]", err) == [("warning", "CG706")] * 2
    assert "a.b" in err
    assert "Twice" in err or "twice" in err
    assert "2 nicknames in nicknames.csv" in out
    table = Path("nicknames.csv").read_text()
    assert 'X002,BIT,"",0,No,"kept"' in table
    assert "wice" not in table
    assert clickgen.build("prog.py", frozen=True).ok


def test_a_table_that_is_wrong_in_another_way_stops_the_import(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), 'X001,BIT,"A",7,No,""\nX1,BIT,"B",0,No,""\nX002,INT,"C",0,No,""\n', main=SEAL)
    _, err = ran(capsys, "plant", "-o", "prog.py", code=1)
    assert "error[CG601]" in err
    assert "nothing was written" in err
    assert sorted(os.listdir()) == ["plant"]


def test_click_s_own_names_are_written(capsys: pytest.CaptureFixture[str]) -> None:
    Path("ladder.csv").write_text(ladder_text([wired("SC2 ~SC5", "copy(SD19,DS1)", "R"), END]))
    ran(capsys, "ladder.csv", "-o", "prog.py")
    text = Path("prog.py").read_text()
    assert "sc._1st_SCAN" in text
    assert 'sd["_RTC_Year(4 digits)"]' in text


# -- nothing of the user's is lost ------------------------------------------------------------------------------------


def test_a_program_that_stands_there_is_not_overwritten(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), main=SEAL)
    Path("prog.py").write_text("# mine\n")
    _, err = ran(capsys, "plant", "-o", "prog.py", code=2)
    assert "prog.py would be overwritten" in err
    assert Path("prog.py").read_text() == "# mine\n"
    ran(capsys, "plant", "-o", "prog.py", "--force")
    assert Path("prog.py").read_text().startswith("def main")
    ran(capsys, "plant", "-o", "prog.py")


def test_another_table_is_never_overwritten(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), 'X001,BIT,"Start",0,No,""\n', main=SEAL)
    Path("nicknames.csv").write_text(f'{HEADER}\nX001,BIT,"Begin",0,No,""\n')
    _, err = ran(capsys, "plant", "-o", "prog.py", "--force", code=2)
    assert "nicknames.csv says otherwise than plant" in err
    assert "clickgen nicknames merge" in err
    assert not Path("prog.py").exists()


# -- what cannot be kept ----------------------------------------------------------------------------------------------

DEAD = [wired("X001", "out(Y001)", "R"), wired("X003", "")]
"""A contact that leads nowhere."""
INPUT = [wired("X001", "out(X002)", "R")]
"""A coil on an input, which CLICK does not take."""


def test_everything_that_cannot_be_kept_is_told_at_once(capsys: pytest.CaptureFixture[str]) -> None:
    unknown = wired("X001", "frobnicate(Y001)", "R")
    short = ["R", "X001", "-", "out(Y001)"]
    write_bundle(Path("plant"), main=[*SEAL, *DEAD, *INPUT, unknown], Sub=[short, wired("bogus", "out(Y001)", "R")])
    _, err = ran(capsys, "plant", "-o", "prog.py", code=1)
    places = re.findall(r"^(\S+?):(\d+):\d+: (\w+)\[(CG\d+)\]: (\w+ rung \d+)", err, re.MULTILINE)
    main_csv, sub_csv = (os.path.join("plant", *name.split("/")) for name in ("main.csv", "subroutines/Sub.csv"))
    assert places == [
        (main_csv, "5", "error", "CG702", "main rung 2"),
        (main_csv, "6", "error", "CG702", "main rung 3"),
        (main_csv, "7", "error", "CG702", "main rung 4"),
        (sub_csv, "2", "error", "CG701", "Sub rung 1"),
        (sub_csv, "3", "error", "CG701", "Sub rung 2"),
    ]
    assert "X003 in row 2, column A does not lead from the power rail to an output" in err
    assert "CG304" in err
    assert "5 errors; nothing was written" in err.replace("5 errors, 1 warning", "5 errors")
    assert sorted(os.listdir()) == ["plant"]


def test_problems_of_a_build_speak_of_the_rungs_of_the_project(capsys: pytest.CaptureFixture[str]) -> None:
    """A loop in a loop: nobody has seen a line of the program that is built for the proof."""
    loops = [wired("", token, "R") for token in ("for(3)", "for(2)", "out(C1)", "next()", "next()")]
    Path("ladder.csv").write_text(ladder_text([*loops, END]))
    _, err = ran(capsys, "ladder.csv", "-o", "prog.py", code=1)
    assert re.findall(r"main rung (\d): a build refuses it: (.*) \(", err) == [
        ("2", "this loop stands inside the loop of main rung 1"),
        ("5", "there is no open loop here"),
    ]
    assert "prog.py" not in err


def test_keep_going_leaves_marked_rungs_that_a_build_refuses(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), main=[*SEAL, *comment("Why it is there."), *DEAD, *INPUT])
    out, _ = ran(capsys, "plant", "-o", "prog.py", "--keep-going", code=1)
    assert "2 of 4 rungs verified" in out
    assert "2 rungs could not be kept" in out
    text = Path("prog.py").read_text()
    assert "    # Why it is there.\n    if True:\n        not_imported(" in text
    result = clickgen.build("prog.py")
    assert [problem.code for problem in result.diagnostics] == ["CG426", "CG426"]
    assert "main.csv:6" in result.diagnostics[0].message


def test_a_comment_without_a_rung_is_not_dropped(capsys: pytest.CaptureFixture[str]) -> None:
    Path("ladder.csv").write_text(ladder_text([*SEAL, END, *comment("the last word")]))
    _, err = ran(capsys, "ladder.csv", "-o", "prog.py", code=1)
    assert "error[CG701]" in err
    ran(capsys, "ladder.csv", "-o", "prog.py", "--keep-going", code=1)
    assert Path("prog.py").read_text().count("not_imported(") == 1


def test_a_part_of_a_program_is_verified_too(capsys: pytest.CaptureFixture[str]) -> None:
    Path("copied.csv").write_text(ladder_text([*SEAL, wired("X003", 'call("Elsewhere")', "R")]))
    out, err = ran(capsys, "copied.csv", "-o", "prog.py")
    assert "2 of 2 rungs verified" in out
    assert err.count("warning[CG707]") == 2
    assert "'Elsewhere'" in err
    assert "end()" not in Path("prog.py").read_text()
    assert "Next:" not in out


def test_a_subroutine_alone_is_a_file_to_import_from(capsys: pytest.CaptureFixture[str]) -> None:
    Path("Init.csv").write_text(ladder_text([*SEAL, RETURN]))
    out, _ = ran(capsys, "Init.csv", "-o", "Init.py")
    assert Path("Init.py").read_text().startswith("@sub\ndef Init():\n")
    assert "Imported Init.csv into Init.py: 2 rungs in 1 subroutine.\n2 of 2 rungs verified" in out


def test_notes_are_said_and_do_not_stop(capsys: pytest.CaptureFixture[str]) -> None:
    bypassed = [wired("X001 T:X002 T", "out(Y001)", "R"), wired(". -", "")]
    spaces = [*comment("spaces behind  "), *SEAL]
    Path("ladder.csv").write_text(ladder_text([*bypassed, *spaces, END]))
    _, err = ran(capsys, "ladder.csv", "-o", "prog.py")
    assert re.findall(r"(\w+)\[(CG\d+)\]", err) == [("warning", "CG704"), ("info", "CG705")]


def test_every_code_of_import_is_called_forth_here() -> None:
    # test_ladder_bytes.py provokes those of binary files, with the bytes that it takes.
    elsewhere = {"CG703", "CG708", "CG709", "CG710"}
    tested = set(re.findall(r"CG7\d\d", Path(__file__).read_text("utf-8"))) - elsewhere
    assert tested | elsewhere == {code for code in CODES if code.startswith("CG7")}


def test_a_rung_that_comes_back_otherwise_is_refused(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The comparison finds a mistake of the writer: here it writes another address."""
    monkeypatch.setattr(
        "clickgen.dialects.if_rungs.write.routine.write_source",
        lambda *args: write_source(*args).replace("y[1]", "y[2]"),
    )
    write_bundle(Path("plant"), main=[*SEAL, wired("X004", "out(C1)", "R")])
    _, err = ran(capsys, "plant", "-o", "prog.py", code=1)
    assert re.findall(r"(\w+)\[(CG\d+)\]: (\w+ rung \d+)", err) == [("error", "CG703", "main rung 1")]
    assert not Path("prog.py").exists()


# -- flags and faults -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["plant"], "-o"),
        (["missing", "-o", "prog.py"], "missing"),
        (["plant", "-o", ""], "the place after -o is empty"),
        (["plant", "-o", "prog.py", "--nicknames", "none.csv"], "there is no address table at none.csv"),
        (["plant", "-o", "prog.py", "--keepgoing"], "did you mean --keep-going?"),
        (["plant/nicknames.csv", "-o", "prog.py"], "nicknames.csv"),
    ],
)
def test_what_keeps_it_from_running_is_said(
    arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    write_bundle(Path("plant"), 'X001,BIT,"Start",0,No,""\n', main=SEAL)
    try:
        code = main(["import", *arguments])
    except SystemExit as stop:
        code = int(str(stop.code))
    assert code == 2
    assert said in capsys.readouterr().err
    assert sorted(os.listdir()) == ["plant"]


def test_no_verify_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), main=SEAL)
    out, _ = ran(capsys, "plant", "-o", "prog.py", "--no-verify")
    assert "0 of 2 rungs verified: --no-verify was given." in out


def _table_rows(text: str) -> dict[str, list[str]]:
    return {row[0]: row for row in csv.reader(text.splitlines()[1:])}


def test_scratch_cells_of_an_earlier_build_are_cells_like_any_other(tmp_path: Path) -> None:
    Path("prog.py").write_text(
        "def main():\n    if c.A:\n        ctu(ct.N, setpoint=5, reset=lambda: any(c.B, c.C))\n"
        "        copy(1, ds.X)\n        calc('ds[ds.P] + 1', ds.Y)\n    if True:\n        end()\n"
    )
    result = clickgen.build("prog.py")
    result.write(Path("bundle"))
    scratch = [str(row.address) for row in result.scratch_rows]
    assert scratch
    found = import_project(Path("bundle"), Target(tmp_path / "new" / "prog.py", settings=Settings()))
    assert found.ok, found.diagnostics
    rows = _table_rows(found.files[tmp_path / "new" / "nicknames.csv"].decode())
    for address in scratch:
        assert rows[address][2] == ""
        assert rows[address][5] != ""


# -- names without a table --------------------------------------------------------------------------------------------


def test_a_program_for_the_terminal_declares_its_names(capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    """Built elsewhere, without the table, it drives the same addresses."""
    rows = [
        'X001,BIT,"Start it",0,Yes,"left of the door"',
        'Y003,BIT,"Press",0,No,""',
        'C7,BIT,"Run",1,No,""',
        'T2,BIT,"Delay",0,No,""',
        'DS5,INT,"Speed",-7,No,""',
        'DH1,HEX,"Mask",00FF,Yes,""',
        'DF1,FLOAT,"Level",-1.5,Yes,""',
        'TXT1,TEXT,"Letter",A,Yes,"a ""quote"""',
        'C99,BIT,"Unused",0,No,""',
    ]
    drawn = [
        wired("X001 C7 SC2 TD2>5 DH1==00FFh DF1>1.5", "out(Y003)", "R"),
        wired("C7", "copy(DS5,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=none))", "R"),
    ]
    write_bundle(Path("dash"), "\n".join(rows) + "\n", main=drawn)
    assert main(["import", "dash", "-o", "-"]) == 0
    text = capfdbinary.readouterr().out.decode("utf-8")
    Path("elsewhere").mkdir()
    Path("elsewhere/prog.py").write_text(text)
    assert 'nickname(x["Start it"], x[1], retentive=True, comment="left of the door")\n' in text
    assert "Unused" not in text
    assert "_1st_SCAN" in text
    built = clickgen.build("elsewhere/prog.py", frozen=True)
    assert built.ok, built.diagnostics
    assert built.files["main.csv"] == Path("dash/main.csv").read_text()
    given = _table_rows(Path("dash/nicknames.csv").read_text())
    del given["C99"]
    assert _table_rows(built.files["nicknames.csv"]) == given
    assert ruff_changes(text) == ""


def test_a_header_alone_is_a_table_too(capsys: pytest.CaptureFixture[str]) -> None:
    """The addresses of a bundle without nicknames have no initial values, whatever is at the target."""
    write_bundle(Path("plant"), main=SEAL)
    Path("plant/nicknames.csv").write_text(f"{HEADER}\n")
    Path("t").mkdir()
    Path("t/nicknames.csv").write_text(f'{HEADER}\nC1,BIT,"Foo",1,Yes,""\n')
    _, err = ran(capsys, "plant", "-o", "t/p.py", code=2)
    assert f"says otherwise than {Path('plant/nicknames.csv')}" in err


def test_a_table_that_would_lose_names_stays(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), 'X001,BIT,"a.b",0,No,""\n', main=SEAL)
    _, err = ran(capsys, "plant", "-o", "plant/prog.py", code=2)
    assert "would lose the nicknames that are left out" in err


# -- stability --------------------------------------------------------------------------------------------------------

UNSTABLE = {
    "a wire into a counter and its reset": [
        wired("-", "count_up(CT1,CTD1,preset=5)", "R"),
        [""] * 33,
        wired("-", ".reset()"),
    ],
    "a box beside an output": [
        wired("X001 T", "out(Y001)", "R"),
        wired(". -", "count_up(CT1,CTD1,preset=5)"),
        [""] * 33,
        wired("X002", ".reset()"),
    ],
    "a number with an exponent": [wired("DF1>1E-3", "copy(1.0E+10,DF1)", "R")],
    "a comment of spaces": [*comment("  "), *SEAL],
    "a separate column for the outputs": [wired("X001 T T", "out(Y001)", "R"), wired("X002 .  -", "out(Y002)")],
}


@pytest.mark.parametrize("name", UNSTABLE)
def test_a_second_import_gives_the_same_source(name: str, tmp_path: Path) -> None:
    write_bundle(tmp_path / "plant", main=UNSTABLE[name])
    first = import_project(tmp_path / "plant", Target(tmp_path / "one" / "prog.py"))
    assert first.ok, first.diagnostics
    first.write()
    clickgen.build(tmp_path / "one" / "prog.py", frozen=True).write(tmp_path / "again")
    second = import_project(tmp_path / "again", Target(tmp_path / "two" / "prog.py"))
    assert second.verdict is not None
    assert second.verdict.verified == second.rungs
    [one, two] = (found.files[found.target.program] for found in (first, second))
    assert one == two


# -- reasons ----------------------------------------------------------------------------------------------------------


def test_a_call_in_other_letters_says_what_the_subroutine_is_called(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), main=[wired("X001", 'call("heat")', "R")], Heat=SEAL)
    _, err = ran(capsys, "plant", "-o", "prog.py", code=1)
    assert "main rung 1: it calls 'heat', and the subroutine is called 'Heat'" in err
    assert err.count("error[") == 1


def test_what_follows_from_a_lost_loop_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), main=[wired("X001", "for(0)", "R"), *SEAL, wired("", "next()", "R")])
    _, err = ran(capsys, "plant", "-o", "prog.py", code=1)
    assert re.findall(r"error\[CG702\]: (main rung \d)", err) == ["main rung 1", "main rung 3"]
    assert "this may follow from main rung 1, which is not kept" in err
    assert "line " not in err


def test_outputs_below_an_end_are_not_taken_for_skipped(capsys: pytest.CaptureFixture[str]) -> None:
    """No source says whether CLICK still runs the outputs below it in the rung."""
    write_bundle(Path("plant"), main=[wired("X001 T", "end()", "R"), wired(". -", "out(C3)")])
    _, err = ran(capsys, "plant", "-o", "prog.py", code=1)
    assert "error[CG702]: main rung 1: it cannot be proven the same: end() is above outputs" in err


@pytest.mark.parametrize("text", ["", ladder_text([])])
def test_a_source_without_rungs_is_no_project(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("ladder.csv").write_text(text)
    ran(capsys, "ladder.csv", "-o", "prog.py", code=2)
    assert os.listdir() == ["ladder.csv"]


def test_a_folder_is_not_made_by_mistake(capsys: pytest.CaptureFixture[str]) -> None:
    write_bundle(Path("plant"), main=SEAL)
    _, err = ran(capsys, "plant", "-o", "prog.txt", code=2)
    assert "prog.txt does not end in .py" in err
