"""``clickgen nicknames why``: the words it understands, and its answers about blocks and existing addresses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from clickgen.cli import main

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
PROGRAM = """\
nickname(ds.Blk, ds[100:110])
nickname(ds.B2, ds[200:210])


def main():
    if c.Run:
        ton(t.Pause, setpoint=ds.Blk[5])
        copy(td.Pause, ds.Speed)
    if ds[50] > 5:
        copy_fill(0, ds.B2[0:4])
    if True:
        end()
"""

Why = Callable[..., tuple[int, list[str], str]]


@pytest.fixture
def why(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Why:
    """Ask about a name in a folder with a.py in it: the exit code, the lines and the errors."""
    monkeypatch.chdir(tmp_path)
    Path("a.py").write_text(PROGRAM, "utf-8")

    def ask(name: str) -> tuple[int, list[str], str]:
        code = main(["nicknames", "why", name, "a.py"])
        said = capsys.readouterr()
        return code, said.out.splitlines(), said.err

    return ask


def sync() -> None:
    assert main(["nicknames", "sync", "a.py"]) == 0


def lines_of(why: Why, name: str) -> list[str]:
    code, lines, err = why(name)
    assert (code, err) == (0, "")
    return lines


# -- blocks -----------------------------------------------------------------------------------------------------------


def test_a_declared_block_is_declared_where_it_is(why: Why, capsys: pytest.CaptureFixture[str]) -> None:
    declared = [
        "B2 is the block DS200 to DS209, 10 addresses",
        "  declared by nickname(...) in a.py:2:1",
        "  ds.B2[0] is DS200",
        "  written in a.py:10 (copy_fill)",
    ]
    assert lines_of(why, "B2") == declared
    sync()
    capsys.readouterr()
    declared.insert(2, "  marked in line 7 of nicknames.csv")
    assert lines_of(why, "b2") == declared


def test_a_block_of_the_table_is_marked_where_it_is(why: Why) -> None:
    Path("nicknames.csv").write_text(HEADER + 'DS30,INT,"",0,Yes,"<M>"\nDS31,INT,"",0,Yes,"</M>"\n', "utf-8")
    assert lines_of(why, "M") == [
        "M is the block DS30 to DS31, 2 addresses",
        "  marked in line 2 of nicknames.csv",
        "  ds.M[0] is DS30",
    ]


def test_a_member_is_named_by_its_block(why: Why) -> None:
    assert lines_of(why, "DS103") == [
        "DS103 has no nickname (INT)",
        "  ds.Blk[3] of the block Blk, DS100 to DS109, declared by nickname(...) in a.py:1:1",
        "  a.py does not use it",
    ]
    assert lines_of(why, "DS200")[1:] == [
        "  ds.B2[0] of the block B2, DS200 to DS209, declared by nickname(...) in a.py:2:1",
        "  written in a.py:10 (copy_fill)",
    ]
    assert lines_of(why, "DS60") == ["DS60 has no name and a.py does not use it"]


def test_a_member_of_a_marked_block_has_the_place_of_the_mark(why: Why) -> None:
    Path("nicknames.csv").write_text(HEADER + 'DS50,INT,"",0,Yes,"<M>"\nDS51,INT,"",0,Yes,"</M>"\n', "utf-8")
    assert lines_of(why, "DS50")[1:] == [
        "  ds.M[0] of the block M, DS50 to DS51, marked in line 2 of nicknames.csv",
        "  from line 2 of nicknames.csv",
        "  read in a.py:9",
    ]


# -- what is understood -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "head"),
    [
        ("ds.Speed", "Speed is DS1 "),
        ("ds.speed", "Speed is DS1 "),
        ('ds["Speed"]', "Speed is DS1 "),
        ("ds['Speed']", "Speed is DS1 "),
        ("ds[50]", "DS50 has no nickname"),
        ("DS[50]", "DS50 has no nickname"),
        ("x[1]", "X001 has no name"),
        ('xd["0u"]', "XD0u has no name"),
        ("t.Pause", "Pause is T1 "),
        ("td.Pause", "td.Pause is TD1 "),
        ("TD1", "td.Pause is TD1 "),
        ("ds.Blk", "Blk is the block DS100"),
        ("ds.Blk[3]", "DS103 has no nickname"),
        ("Blk[3]", "DS103 has no nickname"),
        ('ds["Blk"][3]', "DS103 has no nickname"),
        (" Speed ", "Speed is DS1 "),
        ("sc._1st_SCAN", "_1st_SCAN is SC2 "),
    ],
)
def test_names_are_understood_as_a_program_writes_them(name: str, head: str, why: Why) -> None:
    assert lines_of(why, name)[0].startswith(head)


@pytest.mark.parametrize(
    "name", ["", " ", "dd.Speed", "dd.Blk", "ds.Blk[10]", "ds[5000]", "qq[5]", "ds[", "ds.Speed[0]"]
)
def test_what_no_program_knows(name: str, why: Why) -> None:
    sync()
    Path("nicknames.csv").write_text(Path("nicknames.csv").read_text() + 'TXT5,TEXT,"",,Yes,"noted"\n')
    code, _, err = why(name)
    assert code == 1
    assert f"no program knows {name}" in err


def test_a_near_miss_of_a_block_is_suggested(why: Why) -> None:
    Path("a.py").write_text(PROGRAM.replace("Blk", "Recipe"), "utf-8")
    assert "did you mean Recipe?" in why("Recip")[2]


def test_a_current_value_has_the_origin_of_its_bit(why: Why, capsys: pytest.CaptureFixture[str]) -> None:
    assert "  the current value of Pause, T1" in lines_of(why, "td.Pause")
    sync()
    capsys.readouterr()
    lines = lines_of(why, "td.Pause")
    assert "  from line 3 of nicknames.csv; clickgen placed it" in lines
    assert "  read in a.py:8 (copy)" in lines


# -- existing addresses -----------------------------------------------------------------------------------------------


def test_a_placed_name_says_what_the_settings_leave(why: Why, capsys: pytest.CaptureFixture[str]) -> None:
    settings = 'reserved = ["DS300..DS399"]\n[allocation]\nDS = { use = ["DS120..DS999"], avoid = ["DS500..DS599"] }\n'
    Path("clickgen.toml").write_text(settings, "utf-8")
    sync()
    capsys.readouterr()
    lines = lines_of(why, "Speed")
    assert lines[0].startswith("Speed is DS120 ")
    assert lines[2] == "  the settings let clickgen choose in DS120..DS299, DS400..DS499, DS600..DS999"
    Path("clickgen.toml").write_text(settings.replace("DS120", "DS130"), "utf-8")
    assert lines_of(why, "Speed")[2] == "  by the settings of today clickgen would not choose DS120"
    assert len([line for line in lines_of(why, "Run") if "settings" in line]) == 0
