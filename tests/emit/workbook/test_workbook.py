"""The workbook as people and programs open it: sheets, print setup, text that stays text, the way back."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest
from openpyxl.worksheet.worksheet import Worksheet

import clickgen
from clickgen.cli import main
from clickgen.config import Settings
from clickgen.emit.built import BuiltProgram
from clickgen.emit.workbook.book import ROWS_MAX, TEXT_MAX, clean, to_bytes
from clickgen.emit.workbook.markup import pieces_of
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Column, Sheet
from clickgen.emit.workbook.sheets import sheets, workbook
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.rows import Row
from clickgen.table.workbook.read import read_workbook

DEMO = Path(__file__).parents[3] / "fixtures" / "cases" / "demo" / "prog.py"
HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
SHEETS = [
    "Project",
    "Inputs and outputs",
    "Tags",
    "Cross-reference",
    "Timers and counters",
    "Memory",
    "Memory stretches",
    "Memory map",
    "Scratch",
    "Rungs",
]
PROGRAM = """\
nickname(x.Door, x[3], comment="closed")


def main():
    # =1+1 is a comment
    if all(x.Door, nc(x[4]), c.Start):
        out(y[1])

    if re(c.Start):
        copy_fill(0, ds[1:11])
        copy_fill(0, ds[101:301])
        copy(ds[ds.Index], ds.Value)
        copy(xd[0], dh.Inputs)

    if c.Start:
        ton(t.Delay, setpoint=ds.Wait, unit=Ts)

    if re(c.Pulse):
        ctud(ct.Parts, setpoint=12).down(re(c.Back)).reset(c.Clear)

    if c.Awake:
        rtof(t.Idle, setpoint=3, unit=Tm, reset=lambda: c.Clear)

    if True:
        end()
"""
TABLE = """\
X005,BIT,"Spare",0,No,"=HYPERLINK(""http://x"")"
DS5,INT,"Fifth",-7,Yes,"+1"
DS150,INT,"Far",0,Yes,"@SUM(A1)"
DS200,INT,"",3,No,""
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "prog.py").write_text(PROGRAM, "utf-8")
    (tmp_path / "nicknames.csv").write_text(HEADER + TABLE, "utf-8")
    return tmp_path


def built(program: Path, settings: Settings | None = None) -> BuiltProgram:
    result = clickgen.build(program, settings=settings)
    assert result.ok, result.diagnostics
    # Every name is in the table: the first sheet says nothing about new ones.
    return replace(result.built, new=0)


def opened(data: bytes) -> dict[str, Worksheet]:
    book = openpyxl.load_workbook(io.BytesIO(data))
    return {sheet.title: sheet for sheet in book.worksheets}


def lines(sheet: Worksheet) -> list[tuple[object, ...]]:
    return [tuple("" if value is None else value for value in row) for row in sheet.iter_rows(values_only=True)]


def shown(data: bytes, name: str) -> list[tuple[object, ...]]:
    """The rows of a sheet below its titles."""
    return lines(opened(data)[name])[1:]


@pytest.fixture
def data(folder: Path) -> bytes:
    return workbook(built(folder / "prog.py"))


# -- how it looks -----------------------------------------------------------------------------------------------------


def test_the_sheets_stand_in_their_order_and_are_set_up_for_screen_and_paper(data: bytes) -> None:
    found = opened(data)
    assert list(found) == SHEETS
    for name, sheet in found.items():
        assert sheet.freeze_panes == "A2", name
        assert sheet.print_title_rows == "$1:$1"
        assert sheet.page_setup.orientation == "landscape"
        assert (sheet.page_setup.fitToWidth, sheet.page_setup.fitToHeight) == (1, 0)
        assert sheet.sheet_properties.pageSetUpPr is not None
        assert sheet.sheet_properties.pageSetUpPr.fitToPage
        assert sheet.auto_filter.ref == (None if name == "Project" else sheet.dimensions), name
        header = sheet.oddHeader
        assert header is not None
        assert header.left.text
        assert len(header.left.text) < 255
        for column in range(1, sheet.max_column + 1):
            letter = openpyxl.utils.get_column_letter(column)
            assert sheet.column_dimensions[letter].width > 0


def test_a_name_with_signs_of_a_footer_prints_as_it_is(folder: Path) -> None:
    (folder / "1&2.py").write_text("def main():\n    if True:\n        end()\n")
    with zipfile.ZipFile(io.BytesIO(workbook(built(folder / "1&2.py")))) as archive:
        assert b"<oddFooter>&amp;L 1&amp;&amp;2&amp;RPage" in archive.read("xl/worksheets/sheet3.xml")


# -- text stays text --------------------------------------------------------------------------------------------------

HOSTILE = ["=1+1", '=HYPERLINK("http://x","y")', "+1", "-1", "@SUM(A1)", "\t=1", "#N/A", "#REF!", "TRUE", "1e5", "'a"]


@pytest.mark.parametrize("text", [*HOSTILE, "_x0041_", "a_x0041__x0042_", " a ", "a\nb", "<&>", "\u20ac\U0001f600"])
def test_a_text_stays_the_text_that_it_is(text: str) -> None:
    sheet = Sheet("A", "", (Column("One", 10), Column("Two", 10, wraps=True)), ((text, text),))
    (cells,) = list(opened(to_bytes((sheet,), text))["A"].iter_rows(min_row=2))
    for cell in cells:
        assert (cell.value, cell.data_type) == (text, "s")
        assert cell.number_format == "@"
        assert cell.hyperlink is None


def test_a_long_text_is_no_formula_either_when_it_is_edited() -> None:
    text = "=" + "x" * 300
    sheet = Sheet("A", "", (Column("One", 10),), ((text,),))
    cell = opened(to_bytes((sheet,), ""))["A"]["A2"]
    assert (cell.value, cell.data_type, cell.quotePrefix) == (text, "s", True)


def test_what_a_workbook_cannot_hold_is_shown_or_cut() -> None:
    assert clean("a\x07b\x00\x7f\r\n\ud800\uffff") == "a\u2407b\u2400\u2421\u240d\n\ufffd\ufffd"
    cut = clean("x" * (TEXT_MAX + 1))
    assert len(cut) == TEXT_MAX
    assert cut.endswith(" [cut]")
    assert pieces_of("no _x12_ code") == ["no _x12_ code"]
    assert pieces_of("a_x0041_") == ["a_x", "0041_"]


def test_more_rows_than_a_sheet_holds_are_left_out_visibly(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ROWS_MAX == 2**20
    monkeypatch.setattr("clickgen.emit.workbook.book.ROWS_MAX", 5)
    sheet = Sheet("A", "", (Column("One", 10),), ((number,) for number in range(9)))
    rows = lines(opened(to_bytes((sheet,), ""))["A"])
    assert rows == [("One",), (0,), (1,), (2,), ("There are more rows than a sheet can hold.",)]


def test_no_cell_of_the_workbook_is_a_formula_or_a_link(data: bytes) -> None:
    cells = [cell for sheet in opened(data).values() for row in sheet.iter_rows() for cell in row]
    assert {cell.data_type for cell in cells} == {"s", "n"}
    assert not any(cell.hyperlink for cell in cells)
    assert '=HYPERLINK("http://x")' in {cell.value for cell in cells}


# -- the way back -----------------------------------------------------------------------------------------------------


def read_back(data: bytes) -> tuple[Row, ...]:
    problems = Diagnostics()
    rows = read_workbook(Path("project.xlsx"), "project.xlsx", problems, data)
    assert problems.found == []
    return rows


def contents(rows: Iterable[Row]) -> list[tuple[object, ...]]:
    return sorted((row.content for row in rows if not row.is_default), key=str)


def test_reading_it_as_a_table_gives_the_same_rows(folder: Path, data: bytes) -> None:
    assert contents(read_back(data)) == contents(built(folder / "prog.py").rows)


def test_every_kind_of_initial_value_comes_back_as_it_was(folder: Path) -> None:
    values = {
        "X001,BIT": ["0", "1"],
        "C1,BIT": ["0", "1"],
        "DS1,INT": ["0", "32767", "-32768", "007", "-0"],
        "DD1,INT2": ["0", "2147483647", "-2147483648"],
        "DH1,HEX": ["0", "00FF", "0100", "FFFF", "1E05", "9"],
        "DF1,FLOAT": ["0", "1.5", "-3.4028235E+38", "1.50", "100", "1E-10", ".5"],
        "TXT1,TEXT": ["", "A", "1", "=", " ", '"="'],
    }
    (folder / "prog.py").write_text("def main():\n    if True:\n        end()\n")
    for place, texts in values.items():
        address, kind = place.split(",")
        bank = address.rstrip("01")
        rows = "".join(
            f'{bank}{number:0{len(address) - len(bank)}},{kind},"N{number}",{text},{retentive},""\n'
            for number, (text, retentive) in enumerate(((t, r) for t in texts for r in ("Yes", "No")), 1)
        )
        (folder / "nicknames.csv").write_text(HEADER + rows, "utf-8")
        project = built(folder / "prog.py")
        assert len(project.rows) == 2 * len(texts)
        assert contents(read_back(workbook(project))) == contents(project.rows), place


def test_comments_of_every_sort_come_back_as_they_were(folder: Path) -> None:
    comments = [*HOSTILE, "_x0041_", " a ", "a\nb", "x" * 128, "Address"]
    rows = "".join(
        f'C{number},BIT,"Name {number}",0,No,"{text.replace(chr(34), chr(34) * 2)}"\n'
        for number, text in enumerate(comments, 1)
    )
    (folder / "nicknames.csv").write_text(HEADER + rows, "utf-8")
    project = built(folder / "prog.py")
    assert contents(read_back(workbook(project))) == contents(project.rows)


def test_a_build_with_the_workbook_as_its_table_makes_the_same(folder: Path) -> None:
    assert main(["build", "prog.py", "-o", "one"]) == 0
    assert main(["workbook", "prog.py", "-o", "a.xlsx"]) == 0
    (folder / "nicknames.csv").unlink()
    assert main(["build", "prog.py", "--nicknames", "a.xlsx", "--frozen", "-o", "two"]) == 0
    for name in ("main.csv", "nicknames.csv", "listing.txt"):
        assert (folder / "one" / name).read_bytes() == (folder / "two" / name).read_bytes()
    assert main(["workbook", "prog.py", "--nicknames", "a.xlsx", "-o", "b.xlsx"]) == 0
    assert (folder / "a.xlsx").read_bytes() == (folder / "b.xlsx").read_bytes()


# -- what it says -----------------------------------------------------------------------------------------------------


def test_a_slot_in_use_shows_its_free_points_and_an_unused_slot_is_one_line(data: bytes) -> None:
    rows = shown(data, "Inputs and outputs")
    assert [row[2] for row in rows[:17]] == [*(f"X{n:03}" for n in range(1, 17)), "X021-X036"]
    assert rows[2] == ("X001-X016", "XD0", "X003", "Door", "closed", "used", "", "main 1, 2")
    assert rows[4][3:6] == ("Spare", '=HYPERLINK("http://x")', "used")
    assert rows[16][5] == "free: 16 points"
    assert [row[2] for row in rows if row[5] == "used" and row[6]] == ["Y001"]


def test_reserved_cells_are_seen(folder: Path) -> None:
    from clickgen.device.banks import Address

    reserved = (*(Address("X", n) for n in range(101, 105)), *(Address("DF", n) for n in range(1, 21)))
    data = workbook(built(folder / "prog.py", Settings(reserved=reserved)))
    assert [row[5] for row in shown(data, "Inputs and outputs") if row[1] == "XD1"] == ["reserved"] * 4 + ["free"] * 12
    assert ("DF", "DF1", "DF20", 20, "reserved", "") in shown(data, "Memory stretches")
    assert ("DF", "DF1", "DF20", *"RRRRRRRRRR", 0) in shown(data, "Memory map")


def test_reserved_tens_are_one_row_and_a_reserved_slot_is_one_line(folder: Path) -> None:
    from clickgen.device.banks import Address

    reserved = (*(Address("X", n) for n in range(101, 117)), *(Address("DD", n) for n in range(6, 998)))
    data = workbook(built(folder / "prog.py", Settings(reserved=reserved)))
    slot = [row for row in shown(data, "Inputs and outputs") if row[1] == "XD1"]
    assert [row[2:6] for row in slot] == [("X101-X116", "", "", "reserved: 16 points")]
    assert [row for row in shown(data, "Memory map") if row[0] == "DD"] == [
        ("DD", "DD1", "DD10", "", "", "", "", "", *"RRRRR", 5),
        ("DD", "DD11", "DD990", *"RRRRRRRRRR", 0),
        ("DD", "DD991", "DD1000", *"RRRRRRR", "", "", "", 3),
    ]


BLOCKS = """\
nickname(ds.Recipe, ds[400:430])
nickname(t.Steps, t[101:105])


def main():
    if x[1]:
        copy(ds[ds.At], ds.Value)
        copy(ds.Value, yd[2])

    if td[200] > 5:
        out(y[1])

    if True:
        end()
"""


def test_the_inside_of_a_block_is_not_offered_as_free(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A pointer may read it; clickgen gives no name an address in it."""
    (folder / "prog.py").write_text(BLOCKS)
    marks = 'C50,BIT,"",0,No,"<Zone>"\nC55,BIT,"Valve",0,No,""\nC59,BIT,"",0,No,"</Zone>"\n'
    (folder / "nicknames.csv").write_text(HEADER + marks)
    assert main(["workbook", "prog.py", "-o", "a.xlsx"]) == 0
    capsys.readouterr()
    data = (folder / "a.xlsx").read_bytes()
    stretches = [row for row in shown(data, "Memory stretches") if row[0] in ("DS", "C", "T")]
    remark = "pointers read any of its cells: DS[DS1]"
    assert stretches == [
        ("C", "C1", "C49", 49, "free", ""),
        ("C", "C50", "C54", 5, "in a block", ""),
        ("C", "C55", "C55", 1, "named, not used", ""),
        ("C", "C56", "C59", 4, "in a block", ""),
        ("C", "C60", "C2000", 1941, "free", ""),
        ("T", "T1", "T100", 100, "free", ""),
        ("T", "T101", "T104", 4, "in a block", ""),
        ("T", "T105", "T199", 95, "free", ""),
        ("T", "T200", "T200", 1, "used", ""),
        ("T", "T201", "T500", 300, "free", ""),
        ("DS", "DS1", "DS2", 2, "used", ""),
        ("DS", "DS3", "DS399", 397, "free", remark),
        ("DS", "DS400", "DS429", 30, "in a block", remark),
        ("DS", "DS430", "DS4500", 4071, "free", remark),
    ]
    assert ("DS", "DS401", "DS420", *"BBBBBBBBBB", 0) in shown(data, "Memory map")
    assert {row[5] for row in shown(data, "Inputs and outputs") if row[1] == "YD2"} == {"used"}


NUMBERS = """\
nickname(df.Scale, df[1], initial=1.5, retentive=False)
nickname(df.Long, df[2], initial=-3.4028235e38, retentive=False)
nickname(ds.Preset, ds[1], initial=250, retentive=False)
nickname(dh.Mask, dh[1], initial=0x0100, retentive=False)
nickname(c["007"], c[7])
nickname(txt.Digit, txt[1], initial="5", retentive=False, comment="12")


def main():
    if c["007"]:
        ton(t.Delay, setpoint=500)
        ton(t.Other, setpoint=ds.Preset)

    if True:
        end()
"""


def test_numbers_are_numbers_and_texts_that_look_like_them_are_texts(folder: Path) -> None:
    (folder / "prog.py").write_text(NUMBERS)
    data = workbook(built(folder / "prog.py"))
    tags = {row[0]: row for row in shown(data, "Tags")}
    assert (tags["DF1"][3], tags["DS1"][3], tags["C7"][3]) == (1.5, 250, 0)
    assert (tags["DF2"][3], tags["DH1"][3], tags["TXT1"][3], tags["TXT1"][5]) == ("-3.4028235E+38", "0100", "5", "12")
    assert tags["C7"][2] == "007"
    timers = {row[1]: row for row in shown(data, "Timers and counters")}
    assert (timers["Delay"][3], timers["Other"][4], timers["Delay"][10]) == (500, 250, 1)


def test_the_cross_reference_says_where_and_through_what(data: bytes) -> None:
    rows = shown(data, "Cross-reference")
    assert ("X003", "Door", "read", "main", 1, "prog.py:6", "NO contact", "") in rows
    assert ("X003", "Door", "read", "main", 2, "prog.py:13", "copy", "XD0") in rows
    assert ("X004", "", "read", "main", 1, "prog.py:6", "NC contact", "") in rows
    assert ("DS5", "Fifth", "written", "main", 2, "prog.py:10", "copy_fill", "DS1..DS10") in rows
    assert ("DS1..DS10", "", "written", "main", 2, "prog.py:10", "copy_fill", "") in rows
    assert ("DS150", "Far", "written", "", "", "", "in a long range: see there", "DS101..DS300") in rows
    assert [row[2:7] for row in rows if str(row[0]).startswith("DS[")] == [("read", "main", 2, "prog.py:12", "copy")]
    back = [row for row in rows if row[1] == "Back"]
    assert [row[6] for row in back] == ["ctud input: rising edge"]


def test_a_condition_that_is_looked_at_in_several_rungs_is_one_line(folder: Path) -> None:
    (folder / "prog.py").write_text(
        "def main():\n    if c.Wide:\n        ctu(ct.A, setpoint=1, reset=lambda: c.R)\n"
        "        ctu(ct.B, setpoint=1, reset=lambda: c.R)\n\n    if True:\n        end()\n"
    )
    rows = shown(workbook(built(folder / "prog.py")), "Cross-reference")
    assert [row[4] for row in rows if row[1] == "Wide"] == ["1, 2"]


def test_timers_and_counters_have_setpoints_resets_and_current_values(data: bytes) -> None:
    rows = {row[1]: row for row in shown(data, "Timers and counters")}
    wait = str(rows["Delay"][3])
    assert rows["Delay"][2:8] == ("ton", wait, 0, "s", "TD1", "")
    assert wait.endswith(":Wait")
    assert rows["Parts"][2:7] == ("ctud", 12, "", "", "CTD1")
    assert str(rows["Parts"][7]).endswith(":Clear")
    assert str(rows["Parts"][8]).startswith("rise C")
    assert rows["Idle"][2:6] == ("rtof", 3, "", "min")


def test_memory_adds_up(data: bytes) -> None:
    summary = {row[0]: row for row in shown(data, "Memory")}
    for row in summary.values():
        counts = [value for value in row[4:10] if isinstance(value, int)]
        assert not counts or sum(counts) == row[3]
    assert summary["DS"][10] == "DS301-DS4500"
    assert "pointers read any of its cells: DS[DS" in str(summary["DS"][11])
    assert summary["C"][7] == 2  # rtof's two bits
    stretches = shown(data, "Memory stretches")
    for bank, row in summary.items():
        assert sum(int(str(each[3])) for each in stretches if each[0] == bank) in (row[3], 0)
    free = {row[0]: row[9] for row in summary.values()}
    for bank in ("X", "C", "DS", "TXT"):
        assert sum(int(str(row[13])) for row in shown(data, "Memory map") if row[0] == bank) == free[bank]


def test_the_map_shows_a_letter_for_each_cell_and_free_tens_together(data: bytes) -> None:
    rows = shown(data, "Memory map")
    assert ("X", "X001", "X010", *"UUUUUUUUUU", 0) in rows
    assert ("X", "X011", "X016", *"UUUUUU----", 0) in rows
    assert ("DS", "DS21", "DS100", *([""] * 10), 80) in rows


def test_scratch_cells_have_their_reasons_and_a_leftover_is_said_to_be_one(folder: Path) -> None:
    table = folder / "nicknames.csv"
    old = 'C2000,BIT,"Scratch_C2000",0,No,"condition of main rung 99"\n'
    table.write_text(table.read_text() + old)
    (folder / "prog.py").write_text("def main():\n    if True:\n        end()\n")
    assert shown(workbook(built(folder / "prog.py")), "Scratch")[0][2:] == (
        "condition of main rung 99",
        "not needed now",
        "",
    )
    table.write_text(HEADER)
    assert shown(workbook(built(folder / "prog.py")), "Scratch") == [
        ("The program needs no scratch cells.", "", "", "", "")
    ]


def test_a_rung_that_is_too_tall_for_a_row_goes_on_in_the_next(folder: Path) -> None:
    coils = "".join(f"        out(c[{number}])\n" for number in range(1, 31))
    (folder / "prog.py").write_text(f"def main():\n    # Many\n    if x[1]:\n{coils}    if True:\n        end()\n")
    rows = shown(workbook(built(folder / "prog.py")), "Rungs")
    assert [row[:4] for row in rows] == [
        ("main", 1, "prog.py:3-33", "Many"),
        ("main", 1, "prog.py:3-33", "(goes on)"),
        ("main", 2, "prog.py:34-35", ""),
    ]
    assert str(rows[0][4]).startswith("if X001\n  out(C1)\n")
    assert str(rows[1][4]).endswith("out(C30)")


def test_a_comment_that_is_too_tall_for_a_row_goes_on_in_the_next(folder: Path) -> None:
    comment = " ".join(["word"] * 270)
    (folder / "prog.py").write_text(f"def main():\n    # {comment}\n    if True:\n        end()\n")
    rows = shown(workbook(built(folder / "prog.py")), "Rungs")
    assert "".join(str(row[3]) for row in rows) == comment
    assert all(len(str(row[3])) < 1000 for row in rows)
    assert [row[4] for row in rows] == ["always\n  end()", "", ""]


def test_ranges_over_ranges_stay_moderate(folder: Path) -> None:
    """Each of many names in each of many long ranges would be far too many lines."""
    fills = "".join(f"        copy_fill(0, ds[{n}:{n + 1000}])\n" for n in range(1, 101))
    (folder / "prog.py").write_text(f"def main():\n    if x[1]:\n{fills}    if True:\n        end()\n")
    rows = "".join(f'DS{n},INT,"Name{n}",0,Yes,""\n' for n in range(1, 1001))
    (folder / "nicknames.csv").write_text(HEADER + rows)
    found = shown(workbook(built(folder / "prog.py")), "Cross-reference")
    assert len(found) < 1200
    assert [row[7] for row in found if row[0] == "DS500"] == ["DS1..DS1000, DS2..DS1001, DS3..DS1002 and 97 more"]


# -- the same input gives the same bytes ------------------------------------------------------------------------------


def test_the_bytes_depend_on_nothing_but_the_project(folder: Path, data: bytes) -> None:
    named_otherwise = workbook(built(Path("prog.py")))
    assert workbook(built(folder / "prog.py")) == data == named_otherwise
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        assert b"dcterms" not in archive.read("docProps/core.xml")


def test_the_demo_makes_a_workbook_that_comes_back(tmp_path: Path) -> None:
    program = tmp_path / "demo.py"
    program.write_bytes(DEMO.read_bytes())
    project = built(program)
    assert [sheet.name for sheet in sheets(Project(project))] == SHEETS
    assert contents(read_back(workbook(project))) == contents(project.rows)


# -- the command ------------------------------------------------------------------------------------------------------


def files(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_it_writes_the_workbook_and_nothing_else(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = files(folder)
    assert main(["workbook", "prog.py", "-o", "plant/project.xlsx"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("Wrote ")
    assert "not in nicknames.csv yet: clickgen build writes them." in said
    after = files(folder)
    assert set(after) - set(before) == {"plant/project.xlsx"}
    assert {name: after[name] for name in before} == before
    assert main(["workbook", "prog.py"]) == 0
    assert files(folder)["build/prog/prog.xlsx"] == after["plant/project.xlsx"]


def test_it_writes_over_its_own_and_not_over_what_somebody_saved(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["workbook", "prog.py", "-o", "a.xlsx"]) == 0
    (folder / "prog.py").write_text("def main():\n    if True:\n        end()\n")
    assert main(["workbook", "prog.py", "-o", "a.xlsx"]) == 0
    assert "1 rung" in capsys.readouterr().out
    path = folder / "a.xlsx"
    book = openpyxl.load_workbook(path)
    book.save(path)
    for content in (path.read_bytes(), b"no workbook", b"PK\x03\x04", b""):
        path.write_bytes(content)
        assert main(["workbook", "prog.py", "-o", "a.xlsx"]) == 2
        assert "a.xlsx was not written by clickgen" in capsys.readouterr().err
        assert path.read_bytes() == content


def test_errors_are_shown_and_nothing_is_written(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "prog.py").write_text("def main():\n    if c.A:\n        ton(t.B, 3, units=Ts)\n")
    before = files(folder)
    assert main(["workbook", "prog.py", "-o", "a.xlsx"]) == 1
    said = capsys.readouterr().err
    assert "error[CG109]" in said
    assert said.endswith("nothing was written\n")
    assert files(folder) == before


@pytest.mark.parametrize(
    "arguments",
    [
        ["missing.py"],
        ["prog.py", "-o", "a.csv"],
        ["prog.py", "-o", ""],
        ["prog.py", "-o", "."],
        ["prog.py", "--nicknames", "missing.csv"],
        ["prog.py", "--config", "missing.toml"],
        ["prog.py", "-o", "prog.py/a.xlsx"],
    ],
)
@pytest.mark.usefixtures("folder")
def test_what_cannot_run_says_so(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["workbook", *arguments]) == 2
    assert capsys.readouterr().err.splitlines()[-1].startswith("clickgen: ")


def test_the_table_is_not_written_over(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["workbook", "prog.py", "-o", "a.xlsx"]) == 0
    before = files(folder)
    assert main(["workbook", "prog.py", "--nicknames", "a.xlsx", "-o", "./a.xlsx"]) == 2
    assert "is the address table" in capsys.readouterr().err
    assert files(folder) == before
