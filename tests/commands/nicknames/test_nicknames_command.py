"""``clickgen nicknames`` as a user sees it: sync, check, merge, rename and why, their messages and exit codes."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import openpyxl
import pytest

from clickgen.cli import main
from clickgen.text.write import ChangedMeanwhile
from clickgen.workspace import CouldNotRun

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
PROGRAM = """\
def main():
    if c.Run:
        copy(ds.Speed, ds.Shown)
    if True:
        end()
"""
OTHER = "def main():\n    if c.Other:\n        out(c.Run)\n    if True:\n        end()\n"


class Said(NamedTuple):
    code: int
    out: str
    err: str


Run = Callable[..., Said]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run ``clickgen nicknames`` with these arguments in a folder of its own."""
    monkeypatch.chdir(tmp_path)

    def nicknames(*arguments: str) -> Said:
        try:
            code = main(["nicknames", *arguments])
        except SystemExit as stop:
            code = int(str(stop.code))
        said = capsys.readouterr()
        return Said(code, said.out, said.err)

    return nicknames


def write(name: str, text: str) -> None:
    path = Path(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


def table(name: str = "nicknames.csv") -> list[str]:
    return Path(name).read_text("utf-8").splitlines()[1:]


# -- sync -------------------------------------------------------------------------------------------------------------


def test_sync_gives_what_is_missing_an_address(run: Run) -> None:
    write("prog.py", PROGRAM)
    assert run("sync", "prog.py", "--dry-run") == (
        0,
        "nicknames.csv: 3 addresses would be added\n  + C1 Run\n  + DS1 Speed\n  + DS2 Shown\n",
        "",
    )
    assert [path.name for path in Path().iterdir()] == ["prog.py"]
    assert run("sync", "prog.py").out == "nicknames.csv: 3 addresses added\n  + C1 Run\n  + DS1 Speed\n  + DS2 Shown\n"
    assert table() == ['C1,BIT,"Run",0,No,""', 'DS1,INT,"Speed",0,Yes,""', 'DS2,INT,"Shown",0,Yes,""']
    assert sorted(path.name for path in Path().iterdir()) == ["nicknames.csv", "nicknames.placed", "prog.py"]
    assert run("sync", "prog.py") == (0, "nicknames.csv: up to date\n", "")


def test_sync_gives_the_addresses_of_a_build(run: Run) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    before = Path("nicknames.csv").read_bytes()
    assert main(["build", "prog.py", "--frozen"]) == 0
    assert Path("nicknames.csv").read_bytes() == before


def test_prune_takes_what_clickgen_placed_and_nothing_else(run: Run) -> None:
    write("prog.py", PROGRAM)
    write("nicknames.csv", HEADER + 'C7,BIT,"Panel",0,No,""\nC8,BIT,"Noted",0,No,"for the HMI"\n')
    run("sync", "prog.py")
    write("prog.py", PROGRAM.replace("ds.Speed", "ds.Rate"))
    said = run("sync", "prog.py")
    assert said.out == (
        "nicknames.csv: 1 address added, 3 names that no program uses\n"
        "  + DS3 Rate\n  ? C7 Panel\n  ? C8 Noted\n  ? DS1 Speed\n"
    )
    said = run("sync", "prog.py", "--prune")
    assert said.out == (
        "nicknames.csv: 1 address removed, 2 names that no program uses\n  - DS1 Speed\n  ? C7 Panel\n  ? C8 Noted\n"
    )
    assert 'DS1,INT,"Speed",0,Yes,""' not in table()
    assert "Speed" not in Path("nicknames.placed").read_text("utf-8")
    assert main(["build", "prog.py", "--frozen"]) == 0


@pytest.mark.parametrize(
    "row",
    ['DS1,INT,"Speed",0,Yes,"rpm"', 'DS1,INT,"Speed",5,Yes,""', 'DS1,INT,"Speed",0,No,""', 'DS1,INT,"Pace",0,Yes,""'],
)
def test_prune_leaves_what_a_person_has_touched(run: Run, row: str) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    write("prog.py", PROGRAM.replace("ds.Speed", "ds.Shown"))
    text = Path("nicknames.csv").read_text("utf-8")
    write("nicknames.csv", text.replace('DS1,INT,"Speed",0,Yes,""', row))
    run("sync", "prog.py", "--prune")
    assert row in table()


@pytest.mark.parametrize(
    "other",
    [
        OTHER.replace("c.Other", "ds.Speed > 5"),
        OTHER.replace("c.Other", "ds[1] > 5"),
        OTHER.replace("out(c.Run)", "copy_block(ds[1:5], ds[100])"),
        OTHER.replace("out(c.Run)", "copy(ds[ds.At], ds[100])"),
        "nickname(ds.Speed, ds[1])\n\n\n" + OTHER,
        "@sub\ndef part():\n    if ds.Speed > 5:\n        out(c.Run)\n    if True:\n        return\n",
        OTHER.replace("out(c.Run)", "outt(c.Run)"),
    ],
    ids=["name", "number", "range", "pointer", "declaration", "part", "broken"],
)
def test_prune_leaves_what_another_program_of_the_table_needs(run: Run, other: str) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    write("below/other.py", other)
    write("clickgen.toml", 'programs = ["prog.py", { path = "below/other.py", nicknames = "nicknames.csv" }]\n')
    write("prog.py", PROGRAM.replace("ds.Speed", "ds.Shown"))
    run("sync", "prog.py", "--prune")
    assert 'DS1,INT,"Speed",0,Yes,""' in table()


USER = OTHER.replace("c.Other", "ds.Speed > 5")


@pytest.mark.parametrize("place", ["below", "settings", "part"])
def test_prune_leaves_what_a_program_without_a_table_names(run: Run, place: str) -> None:
    """It may be built with this table another time."""
    write("plant/prog.py", PROGRAM)
    write("plant/io.csv", HEADER)
    run("sync", "plant/prog.py", "--nicknames", "plant/io.csv")
    if place == "below":
        write("plant/sub/other.py", USER)
    elif place == "settings":
        write("elsewhere/other.py", USER)
        write(
            "plant/clickgen.toml", 'programs = ["prog.py", { path = "../elsewhere/other.py", nicknames = "io.csv" }]\n'
        )
    else:
        write(
            "plant/part.py",
            "@sub\ndef part():\n    if ds.Speed > 5:\n        out(c.Run)\n    if True:\n        return\n",
        )
    write("plant/prog.py", PROGRAM.replace("ds.Speed", "ds.Shown"))
    run("sync", "plant/prog.py", "--nicknames", "plant/io.csv", "--prune")
    assert 'DS1,INT,"Speed",0,Yes,""' in table("plant/io.csv")


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_prune_looks_around_the_table_that_a_link_leads_to(run: Run) -> None:
    write("prog.py", USER)
    write("nicknames.csv", HEADER)
    write("sub/other.py", PROGRAM)
    Path("sub/nicknames.csv").symlink_to("../nicknames.csv")
    run("sync", "sub/other.py")
    assert Path("nicknames.placed").exists()
    write("sub/other.py", PROGRAM.replace("ds.Speed", "ds.Shown"))
    run("sync", "sub/other.py", "--prune")
    assert 'DS1,INT,"Speed",0,Yes,""' in table()
    write("prog.py", OTHER)
    run("sync", "prog.py", "sub/other.py", "--prune")
    assert 'DS1,INT,"Speed",0,Yes,""' not in table()


def test_prune_says_what_keeps_a_name(run: Run) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    write("prog.py", PROGRAM.replace("ds.Speed", "ds[ds.Shown]"))
    assert "  ? DS1 Speed (prog.py points into DS)\n" in run("sync", "prog.py", "--prune").out


def test_prune_takes_scratch_cells_that_nothing_needs(run: Run) -> None:
    rung = (
        "    if ds.Speed > 5:\n        copy(1, ds.Speed)\n        ctu(ct.Parts, 5, reset=lambda: c.Run)\n"
        "        copy(2, ds.Shown)\n"
    )
    write("prog.py", PROGRAM.replace("    if True", rung + "    if True"))
    run("sync", "prog.py")
    scratch = [row for row in table() if "Scratch_" in row]
    assert scratch
    write("prog.py", PROGRAM)
    said = run("sync", "prog.py", "--prune")
    assert not [row for row in table() if "Scratch_" in row], said


def test_several_programs_share_a_table(run: Run) -> None:
    write("prog.py", PROGRAM)
    write("other.py", OTHER)
    write("clickgen.toml", 'programs = ["prog.py", "other.py"]\n')
    assert run("sync").out == (
        "nicknames.csv: 4 addresses added\n  + C1 Run\n  + C2 Other\n  + DS1 Speed\n  + DS2 Shown\n"
    )


def test_beside_a_workbook_only_what_it_lacks_is_added(run: Run) -> None:
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    for row in (("Address", "Tag"), ("DS100", "Speed")):
        sheet.append(row)
    book.save("io.xlsx")
    before = Path("io.xlsx").read_bytes()
    write("prog.py", PROGRAM)
    run("sync", "prog.py", "--nicknames", "io.xlsx")
    assert table() == ['C1,BIT,"Run",0,No,""', 'DS1,INT,"Shown",0,Yes,""']
    assert run("check", "prog.py", "--nicknames", "io.xlsx").code == 0
    own = ['C7,BIT,"Panel",0,No,""', 'DS50,INT,"Noted",7,Yes,"set by the panel"']
    write("nicknames.csv", "\n".join((HEADER.strip(), 'C1,BIT,"Run",0,No,""', own[0], *table()[1:], own[1], "")))
    write("prog.py", PROGRAM.replace("c.Run", "c.Ran"))
    run("sync", "prog.py", "--nicknames", "io.xlsx", "--prune")
    assert table() == ['C2,BIT,"Ran",0,No,""', own[0], 'DS1,INT,"Shown",0,Yes,""', own[1]]
    assert Path("io.xlsx").read_bytes() == before


def test_errors_write_nothing(run: Run) -> None:
    write("prog.py", PROGRAM.replace("end()", "ende()"))
    said = run("sync", "prog.py")
    assert said.code == 1
    assert "nothing was written" in said.err
    assert not Path("nicknames.csv").exists()


def test_a_table_that_changes_meanwhile_is_left_alone(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    write("prog.py", PROGRAM)

    def refuse(*_: object, **__: object) -> list[Path]:
        raise ChangedMeanwhile(Path("nicknames.csv"))

    monkeypatch.setattr("clickgen.cli.nicknames.sync.put_in_place", refuse)
    assert run("sync", "prog.py") == (
        2,
        "",
        "clickgen: nicknames.csv was changed by someone else in the meantime; run again\n",
    )


def test_sync_makes_no_table_for_nothing(run: Run) -> None:
    write("prog.py", "def main():\n    if x[1]:\n        out(y[1])\n    if True:\n        end()\n")
    assert run("sync", "prog.py").out == "nicknames.csv: up to date\n"
    assert not Path("nicknames.csv").exists()


# -- check ------------------------------------------------------------------------------------------------------------


def test_check_says_what_is_missing_and_writes_nothing(run: Run) -> None:
    write("prog.py", PROGRAM)
    said = run("check", "prog.py")
    assert said.code == 1
    assert said.out.count("CG209") == 3
    assert [path.name for path in Path().iterdir()] == ["prog.py"]
    run("sync", "prog.py")
    assert run("check", "prog.py") == (0, "nicknames.csv: 3 addresses, in agreement with prog.py\n", "")


@pytest.mark.parametrize(
    "above",
    [
        'nickname(ds.Speed, ds[1], comment="rpm")\n',
        "nickname(ds.Recipe, ds[100:110])\n",
        "nickname(c.New, c[9])\n",
    ],
)
def test_check_says_what_the_source_gives_otherwise_than_the_table(run: Run, above: str) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    before = Path("nicknames.csv").read_bytes()
    write("prog.py", f"{above}\n\n{PROGRAM}")
    said = run("check", "prog.py")
    assert said.code == 1
    assert "would be" in said.out
    assert said.err == "clickgen: run clickgen nicknames sync and commit the table\n"
    assert Path("nicknames.csv").read_bytes() == before
    run("sync", "prog.py")
    assert run("check", "prog.py").code == 0


def test_check_leaves_other_errors_to_the_check_of_programs(run: Run) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    write("prog.py", PROGRAM.replace("copy(", "copie("))
    said = run("check", "prog.py")
    assert (said.code, said.out) == (1, "")
    assert said.err == "clickgen: prog.py has 1 other error: see clickgen check prog.py\n"


def test_check_judges_the_table_itself(run: Run) -> None:
    write("prog.py", PROGRAM)
    write("nicknames.csv", HEADER + 'DS1,INT,"a+b",0,Yes,""\nDS1,INT,"Speed",70000,Yes,""\n')
    said = run("check", "prog.py")
    assert said.code == 1
    assert {"CG601", "CG602", "CG603"} <= set(said.out.replace("[", " ").replace("]", " ").split())


# -- merge ------------------------------------------------------------------------------------------------------------

EXPORT = HEADER + (
    'C1,BIT,"Started",0,No,""\nDS1,INT,"Speed",0,Yes,"rpm"\nDS9,INT,"New",0,Yes,""\nSC1,BIT,"_Always_ON",0,No,""\n'
)


def test_merge_takes_in_what_is_new_and_shows_the_rest(run: Run) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    write("export.csv", EXPORT)
    said = run("merge", "export.csv", "--dry-run")
    assert said.code == 1
    assert "DS9" not in "".join(table())
    said = run("merge", "export.csv")
    assert said == (
        1,
        "export.csv: 1 added, 1 renamed, 1 removed, 1 changed; 1 row of SC and SD kept apart\n"
        "  ~ C1 Run -> Started (renamed; used at prog.py:2)\n"
        '  ~ DS1 Speed: comment "" -> "rpm"\n'
        "  - DS2 Shown (used at prog.py:3)\n"
        "  + DS9 New\n"
        "1 change taken, 3 not: take them with --accept renamed,removed,changed\n",
        "",
    )
    assert table() == [
        'C1,BIT,"Run",0,No,""',
        'DS1,INT,"Speed",0,Yes,""',
        'DS2,INT,"Shown",0,Yes,""',
        'DS9,INT,"New",0,Yes,""',
    ]


def test_merge_takes_what_is_asked_for(run: Run) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    write("export.csv", EXPORT)
    said = run("merge", "export.csv", "--accept", "renamed,changed")
    assert said.code == 1
    assert "Run stands in programs: clickgen nicknames rename Run Started prog.py renames it there too\n" in said.out
    assert table()[:2] == ['C1,BIT,"Started",0,No,""', 'DS1,INT,"Speed",0,Yes,"rpm"']
    assert run("rename", "Run", "Started", "prog.py").code == 0
    assert "c.Started" in Path("prog.py").read_text("utf-8")
    assert run("merge", "export.csv", "--accept", "all").code == 0
    assert run("merge", "export.csv").out == "export.csv: nothing differs; 1 row of SC and SD kept apart\n"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("gone.csv",), "there is no address table at gone.csv"),
        (("export.csv", "--accept", "renmed"), "there is no kind of change 'renmed'; did you mean renamed?"),
        (("bad.csv",), "bad.csv has 1 error; nothing was written"),
    ],
)
def test_merge_that_cannot_run(run: Run, arguments: tuple[str, ...], words: str) -> None:
    write("export.csv", EXPORT)
    write("bad.csv", HEADER + "DS0,INT,,0,Yes,\n")
    said = run("merge", *arguments)
    assert said.code == 2
    assert words in said.err
    assert not Path("nicknames.csv").exists()


# -- rename and why ---------------------------------------------------------------------------------------------------


def test_rename_says_what_it_did(run: Run) -> None:
    write("prog.py", PROGRAM.replace("    if c.Run", "    # Run is the start\n    if c.Run"))
    run("sync", "prog.py")
    assert run("rename", "run", "Started", "prog.py", "--dry-run").out.startswith(
        "run would become Started; the ladder of prog.py would be the same:\n  nicknames.csv: 1 time\n"
    )
    said = run("rename", "Run", "Started", "prog.py")
    assert said == (
        0,
        "Run becomes Started; the ladder of prog.py stays the same:\n"
        "  nicknames.csv: 1 time\n  prog.py: 1 time\n  prog.py: 1 comment still says Run\nRun is Started now\n",
        "",
    )


def test_rename_says_which_programs_it_changes_before_it_does(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """Even if it cannot write afterwards."""
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    write("other.py", PROGRAM)

    def refuse(*_: object) -> None:
        raise CouldNotRun("the disk is full")

    monkeypatch.setattr("clickgen.cli.nicknames.rename.put_in_place", refuse)
    said = run("rename", "Run", "Started", "prog.py")
    assert said.code == 2
    assert said.out == (
        "Run becomes Started; the ladder of prog.py, other.py stays the same:\n"
        "  nicknames.csv: 1 time\n  other.py: 1 time\n  prog.py: 1 time\n"
    )


def test_rename_hints_at_near_names(run: Run) -> None:
    write("prog.py", PROGRAM)
    run("sync", "prog.py")
    assert run("rename", "Sped", "Rate", "prog.py").code == 2


def test_why_says_where_an_address_comes_from(run: Run) -> None:
    above = 'nickname(ds.Limit, ds[5], initial=3, comment="rows")\nnickname(ds.Recipe, ds[10:20])\n\n\n'
    write("clickgen.toml", 'reserved = ["DS1..DS3"]\n')
    write("prog.py", above + PROGRAM.replace("ds.Shown", "ds.Limit"))
    said = run("why", "speed", "prog.py")
    assert said.out == (
        "Speed is DS4 (INT, retentive, initial value 0)\n"
        "  clickgen chooses it, the lowest free address of DS; clickgen build writes it into the table\n"
        "  below it 3 addresses are not free: 3 by the settings\n"
        "  read in prog.py:7 (copy)\n"
    )
    run("sync", "prog.py")
    assert "  from line 3 of nicknames.csv; clickgen placed it\n" in run("why", "Speed", "prog.py").out
    assert run("why", "DS5", "prog.py").out == (
        "Limit is DS5 (INT, retentive, initial value 3): rows\n"
        "  declared by nickname(...) in prog.py:1:1\n"
        "  from line 4 of nicknames.csv\n"
        "  written in prog.py:7 (copy)\n"
    )
    assert run("why", "Recipe", "prog.py").out.startswith("Recipe is the block DS10 to DS19, 10 addresses\n")
    assert run("why", "_1st_SCAN", "prog.py").out == "_1st_SCAN is SC2 (BIT)\n  CLICK's own name\n"
    said = run("why", "Sped", "prog.py")
    assert (said.code, said.err) == (1, "clickgen: no program knows Sped; did you mean Speed?\n")


@pytest.mark.parametrize("arguments", [(), ("snc",), ("sync", "--prunee"), ("why",), ("sync", "gone.py")])
def test_wrong_arguments_are_exit_2(run: Run, arguments: tuple[str, ...]) -> None:
    said = run(*arguments)
    assert said.code == 2
    assert said.err
