"""Blocks: ``nickname(ds.Recipe, ds[100:150])``, their members in a program, and ClickNick's marks in the table."""

from __future__ import annotations

from pathlib import Path

import pyclickplc
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyclickplc.blocks import compute_all_block_ranges, parse_block_tag

import clickgen
from clickgen.cli import main
from clickgen.pipeline import BuildResult
from clickgen.resolve.blocks import mark_in

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"


def program(*rungs: str, above: str = "nickname(ds.Recipe, ds[100:110])") -> str:
    body = "".join(f"    if x[{n}]:\n        {rung}\n" for n, rung in enumerate(rungs, 1))
    return f"{above}\n\ndef main():\n{body}    if True:\n        end()\n"


def build(folder: Path, text: str, table: str = "") -> BuildResult:
    (folder / "prog.py").write_text(text, "utf-8")
    if table:
        (folder / "nicknames.csv").write_text(HEADER + table, "utf-8")
    return clickgen.build(folder / "prog.py")


def outputs(result: BuildResult) -> list[str]:
    """The instructions of main without its end, one for each rung."""
    assert result.ok, [str(problem) for problem in result.diagnostics]
    lines = [line for line in result.files["main.csv"].splitlines() if line.startswith("R,")]
    return [line.rpartition(",-,")[2].strip('"') for line in lines[:-1]]


# -- members in a program ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("rung", "becomes"),
    [
        ("copy(ds.Recipe[0], ds[1])", "copy(DS100,DS1)"),
        ("copy(ds.Recipe[9], ds[1])", "copy(DS109,DS1)"),
        ("copy(ds.recipe[3], ds[1])", "copy(DS103,DS1)"),
        ('copy(ds["Recipe"][3], ds[1])', "copy(DS103,DS1)"),
        ("copy_block(ds.Recipe[0:5], ds[1])", "blockcopy(DS100..DS104,DS1..DS5)"),
        ("copy_block(ds.Recipe[5:], ds[1])", "blockcopy(DS105..DS109,DS1..DS5)"),
        ("copy_block(ds.Recipe[:2], ds[1])", "blockcopy(DS100..DS101,DS1..DS2)"),
        ("copy_block(ds.Recipe, ds[1])", "blockcopy(DS100..DS109,DS1..DS10)"),
        ("copy_block(ds[1:4], ds.Recipe[7])", "blockcopy(DS1..DS3,DS107..DS109)"),
        ("copy_fill(7, ds.Recipe)", "fill(7,DS100..DS109)"),
        ('calc("ds.Recipe[1] * 2", ds[1])', "math(DS101 * 2,DS1,mode=decimal)"),
        ('calc("SUM(ds.Recipe[0:3])", ds[1])', "math(SUM ( DS100 : DS102 ),DS1,mode=decimal)"),
        ('calc("SUM(ds.Recipe[7:])", ds[1])', "math(SUM ( DS107 : DS109 ),DS1,mode=decimal)"),
        ('calc("SUM(ds.Recipe)", ds[1])', "math(SUM ( DS100 : DS109 ),DS1,mode=decimal)"),
        ("search(ds.Recipe >= 5, result=ds[1], found=c[1])", "search(DS100..DS109 >= 5,result=DS1,found=C1)"),
        ("search(5 <= ds.Recipe[2:6], result=ds[1], found=c[1])", "search(DS102..DS105 >= 5,result=DS1,found=C1)"),
        ("search(ds.Recipe[2:] == 5, result=ds[1], found=c[1])", "search(DS102..DS109 == 5,result=DS1,found=C1)"),
        ("copy(dd[ds.Recipe[3]], dd[1])", "copy(DD[DS103],DD1)"),
        ("ton(t[1], ds.Recipe[4])", "on_delay(T1,TD1,preset=DS104,unit=Tms)"),
    ],
)
def test_a_member_is_its_address(rung: str, becomes: str, tmp_path: Path) -> None:
    assert outputs(build(tmp_path, program(rung))) == [becomes]


@pytest.mark.parametrize(
    ("condition", "contacts"),
    [
        ("c.Valves[1]", "C11"),
        ("c.Valves", "C10,C11,C12"),
        ("nc(c.Valves[1:])", "~C11,~C12"),
        ("re(c.Valves[2])", "rise(C12)"),
        ("ds.Recipe[2] > 5", "DS102>5"),
        ("ds.Recipe[2]", "DS102!=0"),
        ("t.Stations[1]", "T6"),
        ("td.Stations[1] > 5", "TD6>5"),
    ],
)
def test_members_in_conditions(condition: str, contacts: str, tmp_path: Path) -> None:
    above = (
        "nickname(ds.Recipe, ds[100:110])\nnickname(c.Valves, c[10:13])\nnickname(t.Stations, t[5:7])\n"
        "nickname(y.Lamps, y[1:4])"
    )
    text = f"{above}\n\ndef main():\n    if {condition}:\n        out(y.Lamps[0])\n    if True:\n        end()\n"
    line = build(tmp_path, text).files["main.csv"].splitlines()[1]
    assert line.startswith(f"R,{contacts},-")
    assert line.endswith(",out(Y001)")


def test_a_list_of_outputs_takes_a_block(tmp_path: Path) -> None:
    rung = (
        "time_drum(outputs=c.Valves, presets=[1, 2], unit=Ts, pattern=[[1, 0, 1], [0, 1, 0]], current_step=ds[1], "
        "accumulator=td[1], completion_flag=c[1], reset=lambda: x[9])"
    )
    spelled = rung.replace("c.Valves", "[c[10], c[11], c[12]]")
    one, other = tmp_path / "one", tmp_path / "other"
    one.mkdir()
    other.mkdir()
    by_name = build(one, program(rung, above="nickname(c.Valves, c[10:13])"))
    assert by_name.files["main.csv"] == build(other, program(spelled)).files["main.csv"]


@pytest.mark.parametrize(
    ("rung", "code", "words"),
    [
        ("copy(ds.Recipe[10], ds[1])", "CG214", "ds.Recipe has 10 members, ds.Recipe[0] to ds.Recipe[9]"),
        ("copy_block(ds.Recipe[0:11], ds[1])", "CG214", "ds.Recipe has 10 members"),
        ("copy_block(ds.Recipe[4:4], ds[1])", "CG214", "empty"),
        ("copy_block(ds.Recipe[::2], ds[1])", "CG214", "every address"),
        ("copy(ds.Recipe[-1], ds[1])", "CG214", "counted from 0"),
        ("copy(ds.Recipe[ds.I], ds[1])", "CG214", "a pointer cannot count inside ds.Recipe"),
        ('calc("ds.Recipe[ds.I] + 1", ds[1])', "CG214", "a pointer cannot count inside a block"),
        ('calc("ds.Recipe[10] + 1", ds[1])', "CG214", "ds.Recipe has 10 members"),
        ('calc("ds.Recipe + 1", ds[1])', "CG214", "ds.Recipe is a block of 10 where one address stands"),
        ('calc("ds.Recipe[0:3] + 1", ds[1])', "CG116", "a range has a place only in SUM"),
        ('calc("SUM(ds.Other)", ds[1])', "CG214", "ds.Other is no block"),
        ("copy(ds.Recipes[1], ds[1])", "CG214", "ds.Recipes is no block"),
        ("copy(dd.Recipe[1], ds[1])", "CG214", "Recipe is the block ds.Recipe, DS100 to DS109"),
        ("ton(t[1], ds.Recipe)", "CG301", "a range of DS"),
        ("copy(ds.Recipe[0][1], ds[1])", "CG113", "is not an address"),
        ("search(ds.Recipe[4:2] == 1, result=ds[1], found=c[1])", "CG202", "at least one address"),
    ],
)
def test_what_is_no_member_is_told(rung: str, code: str, words: str, tmp_path: Path) -> None:
    problems = build(tmp_path, program(rung)).diagnostics
    assert [problem.code for problem in problems] == [code]
    assert words in problems[0].message
    assert problems[0].help


def test_a_misspelled_block_has_a_suggestion(tmp_path: Path) -> None:
    (problem,) = build(tmp_path, program("copy(ds.Recip[1], ds[1])")).diagnostics
    assert problem.help == "did you mean Recipe?"


# -- declarations -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("above", "words"),
    [
        ("nickname(dd.Recipe, ds[100:110])", "dd.Recipe cannot be DS100 to DS109"),
        ("nickname(ds.Recipe, ds[1:5])\nnickname(ds.Recipe, ds[11:15])", "Recipe and the block Recipe"),
        ("nickname(ds.Recipe, ds[1:5])\nnickname(ds.Other, ds[4:9])", "Other and the block Recipe, DS1 to DS4, meet"),
        ("nickname(ds.Recipe, ds[1:5])\nnickname(dd.Recipe, dd[1])", "Recipe is the nickname of one address"),
        ("nickname(sd.Recipe, sd[1:5])", "SD has no blocks"),
        ("nickname(ds.Marked, ds[1:5])", "Marked is DS1 to DS4 here and DS50 to DS52 in line 2 of"),
        ("nickname(ds.Level, ds[1:5])", "Level is the nickname of one address in line 4 of"),
    ],
)
def test_a_wrong_block_is_told(above: str, words: str, tmp_path: Path) -> None:
    table = 'DS50,INT,"",0,Yes,"<Marked>"\nDS52,INT,"",0,Yes,"</Marked>"\nDS60,INT,"Level",0,Yes,""\n'
    problems = build(tmp_path, program("copy(1, dd[5])", above=above), table).diagnostics
    assert [problem.code for problem in problems] == ["CG205"]
    assert words in problems[0].message


def test_the_table_gets_the_marks_and_keeps_the_rest(tmp_path: Path) -> None:
    above = (
        'nickname(ds.Recipe, ds[100:104], initial=7, comment="mix")\nnickname(ds.Speed, ds[103], comment="rpm")\n'
        "nickname(c.One, c[5:6])"
    )
    result = build(tmp_path, program("copy(1, ds.Recipe[0])", above=above), 'DS101,INT,"Kept",5,Yes,"old"\n')
    assert result.table.decode() == HEADER + (
        'C5,BIT,"",0,No,"<One />"\n'
        'DS100,INT,"",7,Yes,"<Recipe>mix"\n'
        'DS101,INT,"Kept",7,Yes,"old"\n'
        'DS102,INT,"",7,Yes,""\n'
        'DS103,INT,"Speed",7,Yes,"</Recipe>rpm"\n'
    )
    result.write(tmp_path / "out")
    again = clickgen.build(tmp_path / "prog.py", frozen=True)
    assert again.ok
    assert again.table == result.table


def test_nothing_is_allocated_inside_a_block(tmp_path: Path) -> None:
    result = build(tmp_path, program("copy(ds.A, ds.B)", above="nickname(ds.Recipe, ds[2:100])"))
    assert outputs(result) == ["copy(DS1,DS100)"]


def test_a_comment_that_is_full_takes_no_mark(tmp_path: Path) -> None:
    table = f'DS100,INT,"",0,Yes,"{"x" * 125}"\n'
    (problem,) = build(tmp_path, program("copy(1, ds.Recipe[0])"), table).diagnostics
    assert problem.code == "CG203"
    assert "128" in problem.message


def test_blocks_of_imported_files_are_known(tmp_path: Path) -> None:
    (tmp_path / "wiring.py").write_text("nickname(ds.Recipe, ds[100:110])\n")
    assert outputs(build(tmp_path, program("copy(ds.Recipe[1], ds[1])", above="import wiring"))) == ["copy(DS101,DS1)"]


# -- marks in the table -----------------------------------------------------------------------------------------------

MARKED = 'DS100,INT,"First",0,Yes,"the mix <Recipe bg=""#FFCDD2""> here"\nDS109,INT,"",0,Yes,"</Recipe>"\n'


def test_a_block_of_the_table_is_known(tmp_path: Path) -> None:
    text = program("copy(ds.Recipe[9], ds.First)", "copy_fill(0, ds.Recipe)", above="")
    assert outputs(build(tmp_path, text, MARKED)) == ["copy(DS109,DS100)", "fill(0,DS100..DS109)"]


def test_a_declaration_may_repeat_the_table(tmp_path: Path) -> None:
    result = build(tmp_path, program("copy(ds.Recipe[9], ds.First)"), MARKED)
    assert result.ok
    assert result.table.decode() == HEADER + MARKED


def test_a_nickname_goes_before_a_mark_of_the_same_name(tmp_path: Path) -> None:
    table = 'DS100,INT,"Recipe",0,Yes,"<Recipe>"\nDS109,INT,"",0,Yes,"</Recipe>"\n'
    text = program("copy(ds.Recipe, ds.Recipe[1])", above="")
    assert outputs(build(tmp_path, text, table)) == ["copy(DS100,DS101)"]


def test_a_block_without_an_end_is_told_by_its_line(tmp_path: Path) -> None:
    text = program("copy(ds.Recipe[9], ds[1])", above="")
    (problem,) = build(tmp_path, text, 'DS100,INT,"",0,Yes,"<Recipe>"\n').diagnostics
    assert problem.message.startswith("the block Recipe in line 2 of ")
    assert problem.help == "mark its last address </Recipe>"


def test_pyclickplc_finds_the_blocks_that_are_written(tmp_path: Path) -> None:
    above = "nickname(ds.Recipe, ds[100:150])\nnickname(c.One, c[7:8])\nnickname(t.Timers, t[1:3])"
    result = build(tmp_path, program("copy(1, ds.Recipe[0])", above=above))
    result.write(tmp_path / "out")
    rows = list(pyclickplc.read_csv(tmp_path / "out" / "nicknames.csv").values())
    found = {
        (block.name, rows[block.start_idx].display_address, rows[block.end_idx].display_address)
        for block in compute_all_block_ranges(rows)  # type: ignore[arg-type]
    }
    assert found == {("Recipe", "DS100", "DS149"), ("One", "C7", "C7"), ("Timers", "T1", "T2")}


COMMENTS = st.text(st.sampled_from("<>/ ab1\"'=bg#"), max_size=24)


@given(COMMENTS)
def test_a_mark_is_what_pyclickplc_takes_for_one(comment: str) -> None:
    theirs, ours = parse_block_tag(comment), mark_in(comment)
    assert (theirs.name is None) == (ours is None), comment
    if ours is not None:
        kinds = {(True, False): "open", (False, True): "close", (True, True): "self-closing"}
        assert (theirs.name, theirs.tag_type) == (ours.name, kinds[ours.opens, ours.closes]), comment


@pytest.mark.parametrize("where", ["wiring", "table"])
def test_a_fix_does_not_take_a_block_of_elsewhere_for_a_bit(
    where: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """``not c.Flags`` is not ``nc(c.Flags)`` where Flags are several bits."""
    monkeypatch.chdir(tmp_path)
    text = "def main():\n    if not c.Flags:\n        out(y[1])\n    if True:\n        end()\n"
    if where == "wiring":
        Path("wiring.py").write_text("nickname(c.Flags, c[1:5])\n")
        text = f"import wiring\n\n\n{text}"
    else:
        Path("nicknames.csv").write_text(HEADER + 'C1,BIT,"",0,No,"<Flags>"\nC4,BIT,"",0,No,"</Flags>"\n')
    Path("prog.py").write_text(text)
    assert main(["check", "prog.py", "--fix", "-q"]) == 1
    assert Path("prog.py").read_text() == text
