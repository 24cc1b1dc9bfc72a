"""The command line as a user meets it: exit codes, messages, nothing lost."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import clickgen
from clickgen.cli import main

GOOD = """\
def main():
    # Start the pump
    if c.Start:
        out(c.Pump)

    if c.Pump:
        call(wash)

    if True:
        end()


@sub
def wash():
    if True:
        return
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "prog.py").write_text(GOOD)
    return tmp_path


def files(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_a_build_writes_exactly_these_files(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", "prog.py", "--no-cache"]) == 0
    assert set(files(folder)) == {
        "prog.py",
        "nicknames.csv",
        "nicknames.placed",
        "build/prog/main.csv",
        "build/prog/subroutines/wash.csv",
        "build/prog/nicknames.csv",
        "build/prog/listing.txt",
        "build/prog/sources.json",
    }
    said = capsys.readouterr()
    assert said.err == ""
    assert "3 rungs in main, 1 rung in 1 subroutine" in said.out
    assert "2 new addresses" in said.out
    assert "named wash" in said.out


def test_a_build_remembers_what_it_read_where_git_looks_past_it(folder: Path) -> None:
    assert main(["build", "prog.py"]) == 0
    cache = folder / ".clickgen_cache"
    assert (cache / ".gitignore").read_text() == "*\n"
    assert [path.name.partition("-")[0] for path in cache.glob("*.json")] == ["rungs"]


def test_a_second_build_changes_nothing(folder: Path) -> None:
    main(["build", "prog.py"])
    before = files(folder)
    times = {path: path.stat().st_mtime_ns for path in folder.rglob("*")}
    assert main(["build", "prog.py", "--frozen"]) == 0
    assert files(folder) == before
    assert {path: path.stat().st_mtime_ns for path in folder.rglob("*")} == times


def test_how_the_program_is_named_changes_no_output(folder: Path) -> None:
    main(["build", "prog.py", "-o", "one"])
    main(["build", str(folder / "prog.py"), "-o", "two"])
    main(["build", "./prog.py", "-o", "three"])
    for name in ("main.csv", "listing.txt", "sources.json", "nicknames.csv"):
        assert len({(folder / out / name).read_bytes() for out in ("one", "two", "three")}) == 1


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["build", "nothing.py"], "no file nothing.py"),
        (["build", "."], "folder"),
        (["build", "prog.py", "--frozn"], "--frozen"),
        (["buidl", "prog.py"], "did you mean build"),
        (["build"], "no program is named"),
        (["build", "prog.py", "--nicknames", "none.csv"], "none.csv"),
        (["build", "prog.py", "-o", "prog.py/x"], "prog.py"),
        (["build", "prog.py", "-o", "."], "choose another folder"),
    ],
)
def test_what_cannot_run_is_exit_2(
    folder: Path, arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    before = files(folder)
    try:
        code = main(arguments)
    except SystemExit as stop:
        code = int(str(stop.code))
    assert code == 2
    said = capsys.readouterr()
    assert words in said.err
    assert "Traceback" not in said.err
    assert said.out == ""
    assert files(folder) == before


def test_problems_are_exit_1_and_nothing_is_written(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "prog.py").write_text("def main():\n    if c.A:\n        out(x[1])\n        tonn(t.A, 5)\n")
    before = files(folder)
    assert main(["build", "prog.py"]) == 1
    assert files(folder) == before
    said = capsys.readouterr()
    assert said.out == ""
    assert "prog.py:3:13: error[CG304]" in said.err
    assert "  3 |         out(x[1])\n    |             ^^^^" in said.err
    assert "did you mean ton?" in said.err
    assert "2 errors; nothing was written" in said.err


def test_an_unparsable_file_is_exit_1(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "prog.py").write_text("def main(:\n")
    assert main(["build", "prog.py"]) == 1
    assert "prog.py:1:10: error[CG101]" in capsys.readouterr().err


@pytest.mark.parametrize("table", [b"\xff\xfe", b"Name;Address\n", b"", b"\x00" * 9])
def test_an_unreadable_table_is_exit_2_and_stays(
    folder: Path, table: bytes, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "nicknames.csv").write_bytes(table)
    before = files(folder)
    assert main(["build", "prog.py"]) == 2
    assert "nicknames.csv" in capsys.readouterr().err
    assert files(folder) == before


def test_frozen_names_what_is_missing(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = files(folder)
    assert main(["build", "prog.py", "--frozen"]) == 1
    said = capsys.readouterr().err
    assert "c.Start has no address" in said
    assert "c.Pump has no address" in said
    assert files(folder) == before


def test_a_subroutine_that_is_gone_leaves_no_file(folder: Path) -> None:
    main(["build", "prog.py"])
    (folder / "prog.py").write_text("def main():\n    if True:\n        end()\n")
    assert main(["build", "prog.py"]) == 0
    assert not (folder / "build/prog/subroutines/wash.csv").exists()


@pytest.mark.parametrize("name", ["main.csv", "other.csv", "subroutines/mine.csv", "listing.txt", "nicknames.csv"])
def test_a_user_s_files_in_the_output_folder_are_not_touched(
    folder: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    path = folder / "out" / name
    path.parent.mkdir(parents=True)
    path.write_text("mine")
    before = files(folder)
    assert main(["build", "prog.py", "-o", "out"]) == 2
    assert name in capsys.readouterr().err
    assert files(folder) == before


def test_other_files_in_the_output_folder_stay(folder: Path) -> None:
    (folder / "out").mkdir()
    (folder / "out" / "notes.md").write_text("mine")
    assert main(["build", "prog.py", "-o", "out"]) == 0
    assert (folder / "out" / "notes.md").read_text() == "mine"


def test_an_interrupted_write_leaves_everything_as_it_was(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    main(["build", "prog.py"])
    (folder / "prog.py").write_text(GOOD.replace("c.Start", "c.Begin"))
    before = files(folder)
    real, calls = os.replace, []

    def interrupted(*arguments: str) -> None:
        calls.append(arguments)
        if len(calls) == 3:
            raise KeyboardInterrupt
        real(*arguments)

    monkeypatch.setattr(os, "replace", interrupted)
    assert main(["build", "prog.py"]) == 130
    monkeypatch.undo()
    assert files(folder) == before


def test_a_table_that_changed_meanwhile_is_not_overwritten(folder: Path) -> None:
    result = clickgen.build("prog.py")
    (folder / "nicknames.csv").write_text("someone was here")
    from clickgen.text.write import ChangedMeanwhile

    with pytest.raises(ChangedMeanwhile):
        result.write(folder / "out")
    assert (folder / "nicknames.csv").read_text() == "someone was here"
    assert not (folder / "out").exists()


def test_the_api_gives_outputs_in_memory(folder: Path) -> None:
    result = clickgen.build(folder / "prog.py")
    assert result.ok
    assert result.diagnostics == ()
    assert set(result.files) == {"main.csv", "subroutines/wash.csv", "nicknames.csv", "listing.txt", "sources.json"}
    assert set(files(folder)) == {"prog.py"}
    scratch = json.loads(result.files["sources.json"])["scratch"]
    assert scratch == []
    with pytest.raises(clickgen.CouldNotRun):
        clickgen.build(folder / "none.py")


def test_colour_is_for_terminals_only(folder: Path) -> None:
    (folder / "prog.py").write_text("def main():\n    if c.A and c.B:\n        out(c.C)\n")
    done = subprocess.run([sys.executable, "-m", "clickgen", "build", "prog.py"], capture_output=True, text=True)
    assert done.returncode == 1
    assert "\x1b" not in done.stderr


def test_control_characters_of_a_program_do_not_reach_the_terminal(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "prog.py").write_text('def main():\n    if c["\x1b[31mA"]:\n        out(c.C)\n')
    assert main(["build", "prog.py"]) == 1
    assert "\x1b" not in capsys.readouterr().err


@pytest.mark.usefixtures("folder")
def test_an_internal_error_is_told_without_a_traceback(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError("no such luck")

    monkeypatch.setattr("clickgen.pipeline.dialect_of", broken)
    assert main(["build", "prog.py"]) == 2
    said = capsys.readouterr().err
    assert "internal error: ZeroDivisionError: no such luck" in said
    assert "Traceback" not in said
    monkeypatch.setenv("CLICKGEN_TRACEBACK", "1")
    with pytest.raises(ZeroDivisionError):
        main(["build", "prog.py"])


def test_version_and_help(capsys: pytest.CaptureFixture[str]) -> None:
    for arguments, words in (["--version"], clickgen.__version__), (["build", "--help"], "examples:"):
        with pytest.raises(SystemExit) as stop:
            main(arguments)
        assert stop.value.code == 0
        assert words in capsys.readouterr().out


def test_version_loads_nothing_heavy() -> None:
    code = (
        "import sys\nfrom clickgen.cli import main\n"
        "try:\n    main(['--version'])\nexcept SystemExit:\n    pass\n"
        "print(sorted(set(sys.modules) & {'libcst', 'lark', 'openpyxl', 'laddercodec', 'clickgen.pipeline'}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.endswith("[]\n")


def test_the_functions_of_the_package_stay_functions(tmp_path: Path) -> None:
    """Building loads the rules, whose folder has the name of the function ``check``."""
    (tmp_path / "prog.py").write_text("def main():\n    if x[1]:\n        out(y[1])\n    if True:\n        end()\n")
    code = "import clickgen\nassert clickgen.build('prog.py').ok\nassert not clickgen.check('prog.py').diagnostics"
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=True)


# -- new names --------------------------------------------------------------------------------------------------------


def _built(folder: Path, capsys: pytest.CaptureFixture[str], *names: str) -> list[str]:
    """The messages of a build of a program with these control relays, from the count of new addresses on."""
    rungs = "".join(f"    if x[1]:\n        out(c.{name})\n" for name in names)
    (folder / "prog.py").write_text(f"def main():\n{rungs}    if True:\n        end()\n")
    capsys.readouterr()
    assert main(["build", "prog.py"]) == 0
    return capsys.readouterr().out.split("commit it.\n")[-1].split("Files:")[0].splitlines()


def test_a_build_lists_the_names_that_are_new_to_it(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert _built(folder, capsys, "Guard_Fault", "Run") == ["New names: C1 Guard_Fault, C2 Run."]
    assert _built(folder, capsys, "Guard_Fault", "Run", "Gaurd_Fault", "Run2") == [
        "New names: C3 Gaurd_Fault, C4 Run2.",
        "  C3 Gaurd_Fault looks like C1 Guard_Fault: is one of them misspelled?",
    ]
    assert _built(folder, capsys, "Guard_Fault", "Run") == ["Built prog.py: 3 rungs in main."]


def test_many_new_names_are_counted_and_a_pair_is_told_once(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = [*(f"Zone{number}" for number in range(1, 20)), "MotorRunning", "MotorRuning"]
    lines = _built(folder, capsys, *names)
    assert lines[0] == f"New names: {', '.join(f'C{number} Zone{number}' for number in range(1, 9))} and 13 more."
    assert lines[1:] == ["  C21 MotorRuning looks like C20 MotorRunning: is one of them misspelled?"]


FILLER = """\
nickname(x.Go, x[1])


def main():
    if x.Go:
        copy(1, ds.Speed)

    if True:
        end()
"""


def test_a_neighbour_that_cannot_be_read_does_not_make_a_build_fail(folder: Path) -> None:
    """Once everything is written, it is too late to fail."""
    with open(folder / "other.py", "wb") as file:
        file.truncate(64 * 1024 * 1024 + 1)
    assert main(["build", "prog.py"]) == 0


def test_two_programs_of_one_table_are_told_how_to_part(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "prog.py").unlink()
    (folder / "filler.py").write_text(FILLER)
    (folder / "packer.py").write_text(FILLER.replace("x[1]", "x[3]"))
    (folder / "library.py").write_text("nickname(x.Stop, x[2])\n")
    assert main(["build", "filler.py"]) == 0
    assert (
        "packer.py has this table too. For two PLCs copy it to filler.csv, and name that in clickgen.toml:\n"
        '  programs = [{ path = "filler.py", nicknames = "filler.csv" }]\n'
    ) in capsys.readouterr().out
    assert main(["build", "filler.py"]) == 0
    assert "has this table too" not in capsys.readouterr().out

    assert main(["build", "packer.py"]) == 1
    said = capsys.readouterr().err
    setting = 'programs = [{ path = "packer.py", nicknames = "packer.csv" }]'
    assert f"if this program is for another PLC, give it a table of its own in clickgen.toml: {setting}\n" in said
    assert said.count("another PLC") == 1
    # Followed to the letter it builds, and the other program's addresses stay.
    before = (folder / "nicknames.csv").read_bytes()
    (folder / "clickgen.toml").write_text(f"{setting}\n")
    assert main(["build", "packer.py"]) == 0
    assert main(["build", "filler.py", "--frozen"]) == 0
    assert (folder / "nicknames.csv").read_bytes() == before
    assert "X003" in (folder / "packer.csv").read_text()
    assert "has this table too" not in capsys.readouterr().out


def test_two_configured_programs_of_one_table_are_not_told_to_part(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "prog.py").unlink()
    (folder / "filler.py").write_text(FILLER)
    (folder / "packer.py").write_text(FILLER.replace("Speed", "Rate"))
    (folder / "clickgen.toml").write_text('programs = ["filler.py", "packer.py"]\n')
    assert main(["build", "filler.py"]) == 0
    assert "has this table too" not in capsys.readouterr().out
    # A third one that the settings do not name may be for another PLC.
    (folder / "third.py").write_text(FILLER)
    assert main(["build", "packer.py"]) == 0
    assert "third.py has this table too" in capsys.readouterr().out


def test_a_table_that_is_named_and_not_there_says_how_to_begin_one(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["build", "prog.py", "--nicknames", "prog.csv"]) == 2
    setting = 'programs = [{ path = "prog.py", nicknames = "prog.csv" }]'
    assert f"clickgen begins one where the settings name it: {setting} in clickgen.toml" in capsys.readouterr().err
    (folder / "clickgen.toml").write_text(f"{setting}\n")
    assert main(["build", "prog.py"]) == 0
    assert (folder / "prog.csv").exists()


# -- files that are not programs --------------------------------------------------------------------------------------

PROJECT = "clickgen import the folder of the Scr*.tmp files"
NO_PROGRAMS = [
    ("plant.ckp", b"SC-PRJ" + bytes(range(256)), PROJECT),
    ("plant.ckp", b"\x01\x00scp.bin.zi" + bytes(99), PROJECT),
    ("saved.bin", b"CLICK   " + bytes(500), "clickgen import saved.bin -o prog.py"),
    ("Scr1.tmp", b"SC-SCR  " + bytes(500), "clickgen import Scr1.tmp -o prog.py"),
    ("scr2.tmp", b"\x00" * 500, "clickgen import scr2.tmp -o prog.py"),
    ("io.xlsx", b"PK\x03\x04" + bytes(range(256)), "after --nicknames"),
    ("io.xls", b"\xd0\xcf\x11\xe0" + bytes(range(256)), "after --nicknames"),
    ("plant.adpro", b"PK\x03\x04" + bytes(range(256)), "clickgen import --help"),
    ("main.csv", b"marker,A,B\nR,X001\n", "clickgen import main.csv -o prog.py"),
    ("names.csv", b"Address,Data Type,Nickname\nX001,BIT,A\n", "--nicknames names.csv"),
]


@pytest.mark.parametrize(("name", "data", "way"), NO_PROGRAMS)
@pytest.mark.parametrize("command", ["build", "check --no-cache", "workbook", "nicknames sync", "nicknames check"])
def test_what_is_given_for_a_program_and_is_none_is_named(
    command: str, name: str, data: bytes, way: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / name).write_bytes(data)
    assert main([*command.split(), name]) in (1, 2)
    captured = capsys.readouterr()
    said = captured.out + captured.err
    assert "UTF-8" not in said
    if command != "nicknames check":
        assert way in said
