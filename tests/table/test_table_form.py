"""Nickname CSVs as CLICK writes them with "Display MODBUS address" checked, read and extended wherever a table is."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest

import clickgen
from clickgen.cli import main
from clickgen.device.banks import BANKS, Address
from clickgen.device.modbus import modbus_number
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.read import read_table
from clickgen.table.rows import default_row

HEADER = "Address,Data Type,Modbus Address,Function Code,Nickname,Initial Value,Retentive,Address Comment"
PLAIN = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment"
PROGRAM = """\
def main():
    if all(c.Run, x._IO1_Module_Error):
        out(y[1])
        copy(ds.Kept, ds.New)
        copy(td[3], dd.Total)
        copy_fill("A", txt[7:9])

    if c.Later:
        copy(txt.Letter, txt[5])

    if True:
        end()
"""

DECIMAL = f"""\
{HEADER}
X101,BIT,100033,FC=02,"_IO1_Module_Error",0,No,""
C1,BIT,16385,"FC=01,05,15","",0,No,""
C3,BIT,16387,"FC=01,05,15","Run",0,No,"a comment, with a comma"
DS2,INT,400002,"FC=03,06,16","Kept",0,Yes,""
XD8,HEX,357361,FC=04,"",0,No,""
,HEX,357362,FC=04,"",0,No,""
YD8,HEX,457873,"FC=03,06,16","",0,No,""
,HEX,457874,"FC=03,06,16","",0,No,""
SD24,INT,361464,FC=04,"_RTC_Hour",0,No,""
"""


def hexadecimal(text: str) -> str:
    rows = [line.split(",", 3) for line in text.splitlines()[1:]]
    lines = []
    for address, word, number, rest in rows:
        offset = (int(number) - 1) % 100000 if int(number) > 99999 else int(number) - 1
        lines.append(f"{address},{word},{offset:04X}h,{rest}")
    return "\n".join([HEADER, *lines]) + "\n"


def read(text: str | bytes) -> tuple[AddressTable, Diagnostics]:
    problems = Diagnostics()
    data = text if isinstance(text, bytes) else text.encode()
    return read_table(Path("t.csv"), "t.csv", problems, data), problems


FORMS = {
    "decimal": DECIMAL,
    "hexadecimal": hexadecimal(DECIMAL),
    "marked": "## " + DECIMAL,
    "crlf": DECIMAL.replace("\n", "\r\n"),
    "bom": "\N{ZERO WIDTH NO-BREAK SPACE}" + DECIMAL,
    "marked plain": f'## {PLAIN}\nX101,BIT,"_IO1_Module_Error",0,No,""\nC3,BIT,"Run",0,No,""\n'
    'DS2,INT,"Kept",0,Yes,""\n',
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.usefixtures("folder")
def test_a_build_extends_the_table_in_its_form_and_keeps_every_other_byte(form: str) -> None:
    before = FORMS[form].encode()
    Path("nicknames.csv").write_bytes(before)
    Path("prog.py").write_text(PROGRAM)
    result = clickgen.build("prog.py")
    assert result.ok, result.diagnostics
    assert {str(row.address) for row in result.new_rows} == {"C1", "DS1", "DD1", "TXT1"}
    assert result.table is not None
    kept, new = before.splitlines(keepends=True), result.table.splitlines(keepends=True)
    # Every line of the file is there in its order, but for that of C1, which had no name and has one now.
    rest = iter(new)
    assert all(line in rest for line in kept if not line.startswith(b"C1,"))
    table, problems = read(result.table)
    assert problems.found == []
    assert len(new) == len(kept) + 4 - any(line.startswith(b"C1,") for line in kept)
    for row in table.own_rows:
        [fields] = csv.reader(io.StringIO(row.raw))
        if table.form.has_modbus:
            number = modbus_number(row.address)
            assert fields[2] == (number.hexadecimal if "hexadecimal" in form else number.decimal)
            assert fields[3] == number.function_code
        assert len(fields) == table.form.width
    assert clickgen.build("prog.py", nicknames="nicknames.csv").files["nicknames.csv"].startswith(PLAIN)


def test_rows_of_upper_words_are_passed_over_and_stay_with_their_words() -> None:
    table, problems = read(DECIMAL)
    assert problems.found == []
    assert len(table.own_rows) == 7
    extended = table.extended([default_row(Address("TD", 1), "Wait"), default_row(Address("DF", 1), "Level")])
    text = extended.text()
    assert '357362,FC=04,"",0,No,""\nYD8' in text
    assert '457874,"FC=03,06,16","",0,No,""\nTD1,INT,445057,"FC=03,06,16","Wait",0,No,""\nSD24' in text
    assert 'DF1,FLOAT,428673,"FC=03,06,16","Level",0,Yes,""\nXD8' in text


@pytest.mark.parametrize(
    "row",
    [
        ',HEX,357362,FC=04,"Named",0,No,""',
        ',HEX,357363,FC=04,"",0,No,""',
        ',INT,357362,FC=04,"",0,No,""',
        ',BIT,16385,"FC=01,05,15","",0,No,""',
    ],
)
def test_no_other_row_may_lack_its_address(row: str) -> None:
    _, problems = read(f"{HEADER}\n{row}\n")
    assert [problem.code for problem in problems.found] == ["CG601"]


@pytest.mark.usefixtures("folder")
def test_a_whole_address_list_of_click_leaves_addresses_free() -> None:
    """CLICK can list every address: an empty row takes none."""
    rows = [default_row(Address("C", number), "") for number in BANKS["C"].numbers()]
    table, _ = read(HEADER + "\n")
    Path("nicknames.csv").write_bytes(table.extended(rows).to_bytes())
    Path("prog.py").write_text(
        "def main():\n    if c.A:\n        rton(t[1], 5, reset=lambda: c.B)\n        set(c.A)\n"
        "    if True:\n        end()\n"
    )
    result = clickgen.build("prog.py")
    assert result.ok, result.diagnostics
    assert [str(row.address) for row in result.new_rows] == ["C1", "C2"]
    assert result.table is not None
    assert len(result.table.splitlines()) == 2001


def test_a_number_of_another_address_is_said() -> None:
    _, problems = read(f'{HEADER}\nC1,BIT,16386,"FC=01,05,15","Run",0,No,""\nC2,BIT,4001h,"FC=01,05,15","",0,No,""\n')
    [problem] = problems.found
    assert problem.code == "CG607"
    assert "CLICK has it at" in problem.message
    assert problem.span is not None
    assert (problem.span.line, problem.span.col) == (2, 8)


def test_faults_are_marked_in_their_own_columns() -> None:
    _, problems = read(f'{HEADER}\nC1,BIT,16385,"FC=01,05,15","a,b",0,Perhaps,""\nC1,BIT,16385,"FC=01,05,15"\n')
    places = {problem.code: (problem.span.line, problem.span.col) for problem in problems.found if problem.span}
    assert places["CG603"] == (2, 28)
    assert any("4 fields where 8 are expected" in problem.message for problem in problems.found)
    assert any(problem.span and problem.span.col == 36 for problem in problems.found if problem.code == "CG601")


# -- everywhere --------------------------------------------------------------------------------------------------------


def bundle(place: Path, table: str) -> Path:
    """The build of PROGRAM, with this table as its own."""
    (place / "source").mkdir()
    (place / "source" / "prog.py").write_text(PROGRAM)
    (place / "source" / "nicknames.csv").write_text(table)
    result = clickgen.build(place / "source" / "prog.py")
    folder = place / "bundle"
    result.write(folder)
    assert result.table is not None
    (folder / "nicknames.csv").write_bytes(result.table)
    return folder


@pytest.mark.parametrize("form", ["decimal", "hexadecimal", "marked"])
@pytest.mark.parametrize("place", ["prog.py", "program/", "-"])
def test_an_import_takes_the_names_of_such_a_table(
    folder: Path, form: str, place: str, capsys: pytest.CaptureFixture[str]
) -> None:
    made = bundle(folder, FORMS[form])
    assert main(["import", str(made), "-o", place]) == 0
    text = capsys.readouterr().out if place == "-" else Path("program/main.py" if "/" in place else place).read_text()
    assert "if all(c.Run, x._IO1_Module_Error):" in text
    assert "copy(ds.Kept, ds.New)" in text
    if place == "-":
        assert "nickname(x._IO1_Module_Error, x[101])" in text
        Path("again.py").write_text(text)
        assert clickgen.build("again.py").ok


def test_merge_and_diff_read_such_a_table(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = bundle(folder, DECIMAL)
    Path("export.csv").write_text("## " + hexadecimal(DECIMAL.replace('"Kept"', '"Stored"')))
    assert main(["nicknames", "merge", "export.csv", "--nicknames", "source/nicknames.csv"]) in (0, 1)
    assert "DS2 Kept -> Stored" in capsys.readouterr().out
    assert main(["diff", "source/prog.py", str(made)]) == 0
    capsys.readouterr()
    assert main(["nicknames", "rename", "Kept", "Stored", "source/prog.py"]) == 0
    text = Path("source/nicknames.csv").read_text()
    assert 'DS2,INT,400002,"FC=03,06,16","Stored",0,Yes,""' in text
    assert 'C3,BIT,16387,"FC=01,05,15","Run",0,No,"a comment, with a comma"' in text


@pytest.mark.usefixtures("folder")
def test_names_of_click_s_own_on_x_are_declared() -> None:
    Path("prog.py").write_text(
        "nickname(x._IO1_Module_Error, x[101])\n\n\ndef main():\n    if x._IO1_Module_Error:\n        out(y[1])\n\n"
        "    if True:\n        end()\n"
    )
    result = clickgen.build("prog.py")
    assert result.ok
    assert not result.diagnostics
    assert "\nR,X101,-" in result.files["main.csv"]
    # On any other bank an underscore at the beginning is CLICK's.
    Path("prog.py").write_text("nickname(c._IO1_Module_Error, c[101])\n\n\ndef main():\n    if True:\n        end()\n")
    assert [problem.code for problem in clickgen.build("prog.py").diagnostics] == ["CG203"]


def test_names_of_another_click_on_sd_reach_the_terminal_declared(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """An export of a newer CLICK shows where its names are; a program by itself has to say it."""
    Path("prog.py").write_text(
        "def main():\n    if x[1]:\n        copy(sd[134], ds[1])\n\n    if True:\n        end()\n"
    )
    clickgen.build("prog.py").write(folder / "made")
    rows = 'SD134,INT,"_Port1_AL_Denied_Count",0,No,""\nSC400,BIT,"_Something_new",0,No,""\n'
    Path("export.csv").write_text(f"{PLAIN}\n{rows}")
    assert main(["import", "made/main.csv", "--nicknames", "export.csv", "-o", "-"]) == 0
    assert "nickname(sd._Port1_AL_Denied_Count, sd[134])" in capsys.readouterr().out
