"""Blocks: ``nickname(ds.Recipe, ds[100:150])``, their members in a program, and ClickNick's marks in the table."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pyclickplc
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyclickplc.blocks import compute_all_block_ranges, parse_block_tag

import clickgen
from clickgen.cli import main
from clickgen.results import BuildResult
from clickgen.table.blocks import mark_in

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
        ('calc("ds.Recipe[ds.I] + 1", ds[1])', "CG214", "a pointer cannot count inside ds.Recipe"),
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


@pytest.mark.parametrize("edge", ["re(c.Valves)", "fe(c.Valves)", "all(c[1], re(c.Valves[0:2]))"])
def test_an_edge_belongs_to_one_bit(edge: str, tmp_path: Path) -> None:
    text = (
        f"nickname(c.Valves, c[10:13])\n\ndef main():\n    if {edge}:\n        out(y[1])\n    if True:\n        end()\n"
    )
    (problem,) = build(tmp_path, text).diagnostics
    assert problem.code == "CG214"
    assert "is a block of" in problem.message


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
    warning, problem = build(tmp_path, text, 'DS100,INT,"",0,Yes,"<Recipe>"\n').diagnostics
    assert warning.code == "CG606"
    assert problem.message.startswith("the block Recipe in line 2 of ")
    assert problem.help == "mark its last address </Recipe>"


def test_pyclickplc_finds_the_blocks_that_are_written(tmp_path: Path) -> None:
    above = "nickname(ds.Recipe, ds[100:150])\nnickname(c.One, c[7:8])\nnickname(t.Timers, t[1:3])"
    result = build(tmp_path, program("copy(1, ds.Recipe[0])", above=above))
    result.write(tmp_path / "out")
    rows = list(pyclickplc.read_csv(tmp_path / "out" / "nicknames.csv").values())
    found = {
        (block.name, rows[block.start_idx].display_address, rows[block.end_idx].display_address)
        # Its rows are what its own reader gives, though its protocol asks for another type.
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
    """``not c.Flags`` is not ``nc(c.Flags)`` if Flags are several bits."""
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


# -- names and marks that do not fit ----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["R/", "/R", "S<x>", 'R"', "sum", "_r", "x" * 35, "12", " R", "Ö", "Scratch_C5", ""])
def test_the_name_of_a_block_is_one_that_its_mark_gives_back(name: str, tmp_path: Path) -> None:
    above = f"nickname(ds[{name!r}], ds[100:110])"
    (problem,) = build(tmp_path, program("copy(1, dd[5])", above=above)).diagnostics
    assert problem.code == "CG203"
    assert problem.help


def test_a_wrong_name_of_a_block_is_told_once(tmp_path: Path) -> None:
    rung = 'copy(ds["R/"][1], ds[1])'
    (problem,) = build(tmp_path, program(rung, above='nickname(ds["R/"], ds[100:110])')).diagnostics
    assert problem.code == "CG203"


def test_a_block_of_the_table_keeps_its_name(tmp_path: Path) -> None:
    """ClickNick gives blocks names such as Base.field, which are no nicknames."""
    table = 'DS100,INT,"",0,Yes,"<Alarm.id:udt>"\nDS109,INT,"",0,Yes,"</Alarm.id:udt>"\n'
    above = 'nickname(ds["alarm.id:udt"], ds[100:110])'
    result = build(tmp_path, program('copy(ds["Alarm.id:udt"][1], ds[1])', above=above), table)
    assert outputs(result) == ["copy(DS101,DS1)"]
    assert result.table.decode() == HEADER + table


@pytest.mark.parametrize("name", ["Recipe", "Mix 2", "2nd", "a_b"])
def test_a_table_with_blocks_does_not_grow(name: str, tmp_path: Path) -> None:
    above = f'nickname(ds["{name}"], ds[100:110])\nnickname(c["{name} c"], c[1:2])'
    first = build(tmp_path, program("copy(1, dd[5])", above=above))
    first.write(tmp_path / "out")
    again = build(tmp_path, program("copy(1, dd[5])", above=above))
    assert again.ok
    assert again.table == first.table


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ('DS100,INT,"",0,Yes,"<R>"\nDS109,INT,"",0,Yes,"</R>"\n', "DS100 is marked <R> in line 2 of"),
        ('DS100,INT,"",0,Yes,"<R>"\nDS105,INT,"",0,Yes,"</R>"\n', "DS100 is marked <R> in line 2 of"),
        ('DS105,INT,"",0,Yes,"<R>"\nDS109,INT,"",0,Yes,"</R>"\n', "DS109 is marked </R> in line 3 of"),
        ('DS100,INT,"",0,Yes,"kept <R /> too"\n', "DS100 is marked <R /> in line 2 of"),
        ('DS100,INT,"",0,Yes,"</Q>"\nDS109,INT,"",0,Yes,"<Q>"\n', "DS100 is marked </Q> in line 2 of"),
        ('DS50,INT,"",0,Yes,"<Q>"\n', "DS50 is marked <Q> in line 2 of"),
        ('DS100,INT,"",0,Yes,"<Q>"\nDS105,INT,"",0,Yes,"<Q>"\n', "DS105 is marked <Q> in line 3 of"),
    ],
)
def test_a_mark_in_the_way_of_a_block_is_told(table: str, words: str, tmp_path: Path) -> None:
    above = "nickname(ds.Q, ds[100:110])"
    result = build(tmp_path, program("copy(1, ds.Q[0])", above=above), table)
    (problem,) = (problem for problem in result.diagnostics if problem.is_error)
    assert problem.code == "CG205"
    assert problem.message.startswith("Q is DS100 to DS109 here, and the comment of ")
    assert words in problem.message
    assert problem.help
    assert problem.labels


def test_half_a_block_is_completed_without_a_warning(tmp_path: Path) -> None:
    result = build(tmp_path, program("copy(1, ds.Recipe[0])"), 'DS100,INT,"",0,Yes,"<Recipe>"\n')
    assert result.diagnostics == ()
    assert 'DS109,INT,"",0,Yes,"</Recipe>"' in result.table.decode()


@pytest.mark.parametrize(
    ("table", "line", "words"),
    [
        ('DS1,INT,"",0,Yes,"<R>"\n', 2, '"<R>" in the comment of DS1 is taken for the beginning of a block'),
        (
            'DS1,INT,"",0,Yes,"on"\nDS2,INT,"",0,Yes,"end </R>"\n',
            3,
            '"</R>" in the comment of DS2 is taken for the end',
        ),
        (
            'DS1,INT,"",0,Yes,"<R>"\nDS3,INT,"",0,Yes,"<Q>"\nDS5,INT,"",0,Yes,"</R>"\nDS7,INT,"",0,Yes,"</Q>"\n',
            3,
            "the blocks R, DS1 to DS5, and Q, DS3 to DS7, overlap",
        ),
        ('DS1,INT,"",0,Yes,"<R />"\nDS3,INT,"",0,Yes,"<r />"\n', 3, "a second block r, DS3, is marked"),
        ('DS1,INT,"",0,Yes,"<R />"\nDD3,INT2,"",0,Yes,"<R />"\n', 3, "a second block R, DD3, is marked"),
        ('X015,BIT,"",0,No,"<R>"\nX022,BIT,"",0,No,"</R>"\n', 2, "the block R, X015 to X022, spans addresses that"),
    ],
)
def test_marks_that_do_not_fit_are_a_warning(table: str, line: int, words: str, tmp_path: Path) -> None:
    result = build(tmp_path, program("copy(1, dd[5])", above=""), table)
    (problem,) = result.diagnostics
    assert (problem.code, problem.is_error) == ("CG606", False)
    assert problem.span is not None
    assert problem.span.line == line
    assert problem.message.startswith(words)
    assert problem.help
    assert result.table.decode() == HEADER + table


@pytest.mark.parametrize(
    "table",
    [
        'DS1,INT,"",0,Yes,"< 5 >"\n',
        'DS1,INT,"",0,Yes,"a < b"\n',
        'DS1,INT,"",0,Yes,"<>"\n',
        'DS1,INT,"",0,Yes,"<R />"\n',
        'DS1,INT,"",0,Yes,"<R>"\nDS3,INT,"",0,Yes,"<Q />"\nDS5,INT,"",0,Yes,"</R>"\n',
        'T1,BIT,"",0,No,"<R>"\nT3,BIT,"",0,No,"</R>"\nTD1,INT,"",0,No,"<R>"\nTD3,INT,"",0,No,"</R>"\n',
    ],
    ids=["number", "less", "empty", "one", "nested", "timers"],
)
def test_what_is_no_mark_or_a_good_one_is_no_warning(table: str, tmp_path: Path) -> None:
    assert build(tmp_path, program("copy(1, dd[5])", above=""), table).diagnostics == ()


def test_of_two_openings_the_later_one_is_closed_as_clicknick_has_it(tmp_path: Path) -> None:
    table = 'DS1,INT,"",0,Yes,"<R>"\nDS3,INT,"",0,Yes,"<R>"\nDS9,INT,"",0,Yes,"</R>"\n'
    result = build(tmp_path, program("copy_fill(0, ds.R)", above=""), table)
    assert outputs(result) == ["fill(0,DS3..DS9)"]
    (problem,) = result.diagnostics
    assert problem.span is not None
    assert (problem.code, problem.span.line) == ("CG606", 2)


def test_a_declared_block_that_crosses_a_marked_one_is_a_warning(tmp_path: Path) -> None:
    table = 'DS105,INT,"",0,Yes,"<Q>"\nDS115,INT,"",0,Yes,"</Q>"\n'
    result = build(tmp_path, program("copy(1, ds.Recipe[0])"), table)
    (problem,) = result.diagnostics
    assert problem.code == "CG606"
    result.write(tmp_path / "out")
    (problem,) = clickgen.build(tmp_path / "prog.py").diagnostics
    assert problem.code == "CG606"


@pytest.mark.parametrize("part", ["[2]", "[0:4]", ""])
def test_a_member_in_a_gap_of_the_inputs_is_told(part: str, tmp_path: Path) -> None:
    table = 'X015,BIT,"",0,No,"<R>"\nX022,BIT,"",0,No,"</R>"\n'
    text = f"def main():\n    if x.R{part}:\n        out(y[1])\n    if True:\n        end()\n"
    (problem,) = (problem for problem in build(tmp_path, text, table).diagnostics if problem.is_error)
    assert problem.code == "CG214"
    assert "X017" in problem.message


def workbook(folder: Path, *rows: tuple[str, ...]) -> Path:
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    for row in (("Address", "Tag", "Comment"), *rows):
        sheet.append(row)
    book.save(folder / "io.xlsx")
    return folder / "io.xlsx"


@pytest.mark.parametrize(("row", "comment"), [("DS100", ""), ("DS109", "noted")])
def test_a_block_at_a_row_of_a_workbook_has_no_marks(row: str, comment: str, tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text(program("copy(ds.Recipe[1], ds[1])"))
    book = workbook(tmp_path, (row, "Given", comment))
    result = clickgen.build(tmp_path / "prog.py", nicknames=book)
    assert outputs(result) == ["copy(DS101,DS1)"]
    assert result.diagnostics == ()
    assert result.table.decode() == HEADER
    assert "Recipe" not in result.files["nicknames.csv"]


def test_half_a_block_of_a_workbook_is_completed_in_the_table(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text(program("copy(ds.Recipe[1], ds[1])"))
    book = workbook(tmp_path, ("DS100", "Given", "<Recipe>"))
    result = clickgen.build(tmp_path / "prog.py", nicknames=book)
    assert result.diagnostics == ()
    assert result.table.decode() == HEADER + 'DS109,INT,"",0,Yes,"</Recipe>"\n'


def test_a_declared_comment_leaves_the_mark_of_a_block(tmp_path: Path) -> None:
    text = program("copy(ds.R[0], ds.First)", above='nickname(ds.First, ds[100], comment="mine")')
    table = 'DS100,INT,"First",0,Yes,"old <R> text"\nDS109,INT,"",0,Yes,"</R>"\n'
    result = build(tmp_path, text, table)
    assert result.ok
    assert 'DS100,INT,"First",0,Yes,"<R>mine"' in result.table.decode()
    result.write(tmp_path / "out")
    assert build(tmp_path, text).table == result.table
