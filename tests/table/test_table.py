"""The address table: it is read exactly, and faults in its rows are reported."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from judges.work import calls_in
from made_tables import EXPORT, at, file, judged, table_of
from pyclickplc import read_csv

from clickgen.device.banks import BANKS, Address
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.read import TableUnreadable, read_table
from clickgen.table.rows import HEADER, default_row, format_row

__all__ = ["file"]


SHARED_EXPORT = Path(__file__).parents[3] / "shared" / "data" / "nickname-export.csv"


def faults(path: Path, *rows: str) -> list[tuple[str, str]]:
    """Code and ``line:col-col message`` of everything wrong with these rows; the first of them is on line 2."""
    _, problems = judged(path, HEADER + "\n" + "".join(row + "\n" for row in rows))
    found = []
    for problem in problems:
        assert problem.span is not None
        assert problem.span.path == "nicknames.csv"
        assert problem.help
        found.append((problem.code, f"{problem.span.line}:{problem.span.col}-{problem.span.end_col} {problem.message}"))
    return found


# -- reading -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("source", [EXPORT, SHARED_EXPORT], ids=["fixture", "shared"])
def test_an_export_of_click_reads_without_a_word(source: Path, file: Path) -> None:
    if not source.exists():
        pytest.skip("the shared export is not on this machine")
    table, problems = judged(file, source.read_bytes())
    assert problems == ()
    records = read_csv(source)
    assert len(table.rows) == len(records)
    for row in table.rows:
        record = records.addr[str(row.address)]
        assert (row.nickname, row.initial, row.retentive, row.comment) == (
            record.nickname,
            record.initial_value,
            record.retentive,
            record.comment,
        )
        # Each row is what this module would have written.
        assert format_row(row) == row.raw
    assert list(table.rows) == sorted(table.rows, key=lambda row: row.address.sort_key)


def test_lookups(file: Path) -> None:
    table, _ = judged(file, EXPORT.read_bytes())
    row = table.by_nickname["pumpmotor"]
    assert row == table.by_address[at("Y001")]
    assert (row.nickname, row.comment, row.line) == ("PumpMotor", 'say "pump" on the panel', 7)
    assert table.by_address[at("C2")].nickname == ""
    assert "" not in table.by_nickname
    assert [row.nickname for row in table.rows if row.address.bank in ("SC", "SD")] == [
        "_Always_ON", "_I/O_BUS_Error", "_PLC_Error_Code", "_RTC_Year (4 digits)"
    ]  # fmt: skip
    span = table.span(row)
    assert span is not None
    assert (span.line, span.col, span.end_line, span.end_col) == (7, 1, 7, len(row.raw) + 1)


@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"], ids=["no mark", "byte order mark"])
@pytest.mark.parametrize("newline", ["\n", "\r\n"], ids=["LF", "CRLF"])
@pytest.mark.parametrize("end", [True, False], ids=["ended", "no last newline"])
def test_every_way_to_save_the_file_is_kept(file: Path, mark: bytes, newline: str, end: bool) -> None:
    text = EXPORT.read_text("utf-8")
    if not end:
        text = text.rstrip("\n")
    data = mark + text.replace("\n", newline).encode()
    table, problems = judged(file, data)
    assert problems == ()
    assert (table.bom, table.newline, table.final_newline) == (bool(mark), newline, end)
    more = table.extended([default_row(at("DS3"), "New"), default_row(at("TXT1000")._replace(number=999), "Late")])
    lines = more.to_bytes().removeprefix(mark).decode().split(newline)
    assert 'DS3,INT,"New",0,Yes,""' in lines
    assert all("\r" not in line and "\n" not in line for line in lines)
    assert (lines[-1] == "") == end
    assert more.to_bytes().startswith(mark + b"Address")


def test_a_row_appended_to_a_file_without_a_last_newline(file: Path) -> None:
    table, _ = judged(file, f'{HEADER}\nC1,BIT,"A",0,No,""')
    assert table.extended([default_row(at("C2"), "B")]).text() == f'{HEADER}\nC1,BIT,"A",0,No,""\nC2,BIT,"B",0,No,""'
    bare, _ = judged(file, HEADER)
    assert bare.extended([default_row(at("C2"), "B")]).text() == f'{HEADER}\nC2,BIT,"B",0,No,""'


def test_what_a_spreadsheet_makes_of_it_is_taken_and_kept(file: Path) -> None:
    rows = (
        "x1,BIT,Start,0,No,",  # no quotes, a short address
        '"X002","BIT","Stop","0","No","quoted throughout"',
        'C1,BIT,"A",0,No,"two\nlines"',
        "",
        ",,,,,",
        "TXT1,TEXT,Blank, ,Yes,",
        'TXT2,TEXT,Comma,",",Yes,',
    )
    table = table_of(file, *rows)
    assert [(str(row.address), row.nickname, row.line) for row in table.rows] == [
        ("X001", "Start", 2), ("X002", "Stop", 3), ("C1", "A", 4), ("TXT1", "Blank", 8), ("TXT2", "Comma", 9)
    ]  # fmt: skip
    assert table.by_nickname["a"].comment == "two\nlines"
    assert table.by_nickname["comma"].initial == ","


def test_mixed_line_ends_are_kept(file: Path) -> None:
    table, problems = judged(file, f"{HEADER}\r\nC1,BIT,A,0,No,\nC2,BIT,B,0,No,\r\n\nC3,BIT,C,0,No,\r")
    assert problems == ()
    assert [row.line for row in table.rows] == [2, 3, 5]


def test_an_empty_table() -> None:
    table = AddressTable.empty("nicknames.csv")
    assert table.rows == ()
    assert table.to_bytes() == HEADER.encode() + b"\n"
    assert table.extended([]) is table


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "it is empty"),
        (b"\xef\xbb\xbf", "it is empty"),
        (b"\n" + HEADER.encode(), "its first line is empty"),
        (b'X001,BIT,"Start",0,No,""\n', 'begins with X001,BIT,"Start",0,No,""'),
        (HEADER.replace(",", ";").encode(), "separated by semicolons"),
        (HEADER.replace(",", "\t").encode(), "separated by tabs"),
        (HEADER.encode().replace(b"Nickname", b"Name"), "begins with Address,Data Type,Name"),
        (HEADER.encode() + b",More\n", "is not a CLICK nickname CSV"),
        (f'"{HEADER}"\n'.encode(), "is not a CLICK nickname CSV"),
        (HEADER.encode() + b"\rC1,BIT,A,0,No,\r", "lone carriage return"),
        (b"PK\x03\x04" + b"xl/workbook.xml", "Excel workbook: give it a name that ends in .xlsx"),
        (b"PK\x03\x04\0\0\0", "a zip archive and no nickname CSV"),
        (
            b"PK\x03\x04".ljust(30, b"\0") + b"mimetypeapplication",
            "(.ods): open it in a spreadsheet program and save it",
        ),
        (b"PK\x03\x04" + b"xl/workbook.bin", "(.xlsb): open it in a spreadsheet program and save it as .xlsx"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1", "(.xls), or protected by a password: open it in a spreadsheet program"),
        (HEADER.encode().ljust(32 * 2**20 + 1), "has more than 32 MB"),
        (HEADER.encode() + b"\n" * 200_001, "has more than 200,000 lines"),
        ("\ufeff".encode("utf-16-le") + HEADER.encode("utf-16-le"), "UTF-16"),
        (HEADER.encode() + b'\nC1,BIT,"A",0,No,"\xe4"\n', "line 2 holds the byte E4; save it as CSV UTF-8"),
        (b"x" * 100_000, "..."),
    ],
)
def test_what_is_no_table(file: Path, content: bytes, said: str) -> None:
    file.write_bytes(content)
    with pytest.raises(TableUnreadable) as caught:
        read_table(file, "plant/nicknames.csv", Diagnostics())
    assert said in str(caught.value)
    assert str(caught.value).startswith("plant/nicknames.csv")
    assert len(str(caught.value)) < 300


def test_no_file_and_a_folder(tmp_path: Path) -> None:
    with pytest.raises(TableUnreadable, match=r"there is no address table at gone\.csv"):
        read_table(tmp_path / "gone.csv", "gone.csv", Diagnostics())
    with pytest.raises(TableUnreadable, match="plant is a folder"):
        read_table(tmp_path, "plant", Diagnostics())


def test_an_export_that_is_a_workbook(tmp_path: Path) -> None:
    (tmp_path / "e.xlsx").write_bytes(b"PK\x03\x04xl/workbook.xml")
    with pytest.raises(TableUnreadable, match=r"e\.xlsx is an Excel workbook, and a nickname CSV"):
        read_table(tmp_path / "e.xlsx", "e.xlsx", Diagnostics())


def test_a_pipe_and_a_device(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    (tmp_path / "zero.csv").symlink_to("/dev/zero")
    for name in ("pipe.csv", "zero.csv"):
        with pytest.raises(TableUnreadable, match=f"{name} is a pipe or a device; name a file"):
            read_table(tmp_path / name, name, Diagnostics())


# -- what is wrong with rows -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("C1,BIT,A,0,No", "2:1-14 this row has 5 fields where 6 are expected"),
        ('C1,BIT,"A",0,No,one, two', "2:1-25 this row has 7 fields where 6 are expected"),
        ("hello", "2:1-6 this row has 1 field where 6 are expected"),
        ('X017,BIT,"A",0,No,""', "2:1-5 CLICK has no address X017"),
        ('Q1,BIT,"A",0,No,""', "2:1-3 CLICK has no address Q1"),
        (',BIT,"A",0,No,""', '2:1-2 CLICK has no address ""'),
        (f'DS{"1" * 5000},INT,"A",0,No,""', f"2:1-5003 CLICK has no address DS{'1' * 38}..."),
        ('DS1,BIT,"A",0,No,""', "2:5-8 DS1 is given the data type BIT"),
        ('DS1,int,"A",0,No,""', "2:5-8 DS1 is given the data type int"),
        ('TXT1,TXT,"A",,No,""', "2:6-9 TXT1 is given the data type TXT"),
        ('C1,BIT,"A",2,No,""', "2:12-13 C1 cannot start with the value 2"),
        ('C1,BIT,"A",,No,""', '2:12-13 C1 cannot start with the value ""'),
        ('DS1,INT,"A B",32768,No,""', "2:15-20 DS1 cannot start with the value 32768"),
        ('DS1,INT,"A",1.5,No,""', "2:13-16 DS1 cannot start with the value 1.5"),
        ('DS1,INT,"A",\u0661,No,""', "2:13-14 DS1 cannot start with the value \u0661"),
        ('DD1,INT2,"A",-2147483649,No,""', "2:14-25 DD1 cannot start with the value -2147483649"),
        ('DH1,HEX,"A",00FFh,No,""', "2:13-18 DH1 cannot start with the value 00FFh"),
        ('DF1,FLOAT,"A",nan,No,""', "2:15-18 DF1 cannot start with the value nan"),
        ('DF1,FLOAT,"A",1e39,No,""', "2:15-19 DF1 cannot start with the value 1e39"),
        ('DF1,FLOAT,"A","1,5",No,""', "2:15-20 DF1 cannot start with the value 1,5"),
        ('TXT1,TEXT,"A",AB,No,""', "2:15-17 TXT1 cannot start with the value AB"),
        ('TXT1,TEXT,"A",ä,No,""', "2:15-16 TXT1 cannot start with the value ä"),
        ('C1,BIT,"A",0,no,""', "2:14-16 the Retentive field of C1 reads no"),
        ('C1,BIT,"A",0,,""', '2:14-15 the Retentive field of C1 reads ""'),
        ('XD1,HEX,"A",1,No,""', "2:13-14 CLICK lets nobody change the initial value setting of XD1"),
        ('YD0u,HEX,"A",0,Yes,""', "2:16-19 CLICK lets nobody change the retentive setting of YD0u"),
        (
            f'C1,BIT,"A",0,No,"{"x" * 129}"',
            "2:17-148 CLICK does not take the comment of C1: it has 129 characters and CLICK takes 128",
        ),
        ('C1,BIT,"A",0,No,"a\0b"', "2:17-22 CLICK does not take the comment of C1: it holds the character U+0000"),
        ('C1,BIT,"A"x,0,No,""', "2:1-20 the double quotes of this row do not pair up"),
        ('C1,BIT,"A,0,No,', "2:1-16 the double quotes of this row do not pair up"),
        ("C1,BIT,A\rB,0,No,", "2:1-17 a lone carriage return stands in this row"),
        (f"C1,BIT,{'A' * 140_000},0,No,", "2:1-140014 this row is far too long for a row of nicknames"),
    ],
)
def test_a_malformed_row(file: Path, row: str, said: str) -> None:
    assert faults(file, row) == [("CG601", said)]


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ('C1,BIT,"Pump-1",0,No,""', "2:8-16 CLICK does not take the nickname Pump-1 of C1: it holds -, which CLICK"),
        ('C1,BIT,"_A",0,No,""', "2:8-12 CLICK does not take the nickname _A of C1: it begins with an underscore"),
        ('C1,BIT,"a\0",0,No,""', "2:8-12 CLICK does not take the nickname 'a\\x00' of C1: it holds the character"),
        ('X001,BIT,"_A",0,No,""', "2:10-14 CLICK does not take the nickname _A of X001: it begins with an underscore"),
        ('SC1,BIT,"Ä",0,No,""', "2:9-12 CLICK does not take the nickname Ä of SC1: it holds Ä, which is not ASCII"),
    ],
)
def test_an_illegal_nickname(file: Path, row: str, said: str) -> None:
    ((code, message),) = faults(file, row)
    assert code == "CG603"
    assert message.startswith(said)


def test_duplicates_name_the_earlier_row(file: Path) -> None:
    rows = (
        'C1,BIT,"Pump",0,No,"first\nline"',
        'C2,BIT,"PUMP",0,No,""',
        'C1,BIT,"Other",0,No,""',
        'C3,BIT,"",0,Yes,""',
        'C4,BIT,"",0,Yes,""',
    )
    assert faults(file, *rows) == [
        ("CG602", "4:8-14 the nickname PUMP of C2 already belongs to C1 on line 2, there spelled Pump"),
        ("CG602", "5:1-3 C1 stands twice: on line 2 and here"),
    ]
    table, problems = judged(file, HEADER + "\n" + "\n".join(rows))
    assert [str(problem.labels[0].span) for problem in problems] == ["nicknames.csv:2:8", "nicknames.csv:2:1"]
    assert [str(row.address) for row in table.rows] == ["C1", "C2", "C3", "C4"]
    assert table.by_nickname["pump"].address == at("C1")


def test_click_s_own_points_may_share_a_name(file: Path) -> None:
    table = table_of(file, 'SC5,BIT,"_Twin",0,No,""', 'SD7,INT,"_Twin",0,No,""')
    assert table.by_nickname["_twin"].address == at("SC5")
    assert [code for code, _ in faults(file, "SC5,BIT,Twin,0,No,", "C7,BIT,Twin,0,No,")] == ["CG602"]


def test_everything_is_said_at_once_and_reading_goes_on(file: Path) -> None:
    rows = (
        'C1,BIT,"A",0,No,""',
        'DS1,BIT,"B-2",99999,Maybe,""',
        'C2,BIT,"open,0,No,""',
        'C3,BIT,"C",0,No,""',
        "nonsense",
        'C4,BIT,"c",0,No,""',
        'C5,BIT,"D",0,No,"never closed',
        "C6,BIT,E,0,No,",
    )
    assert [(code, message.split()[0]) for code, message in faults(file, *rows)] == [
        ("CG601", "3:5-8"),
        ("CG603", "3:9-14"),
        ("CG601", "3:15-20"),
        ("CG601", "3:21-26"),
        ("CG601", "4:1-21"),
        ("CG601", "6:1-9"),
        ("CG602", "7:8-11"),
        ("CG601", "8:1-30"),
    ]
    table, _ = judged(file, HEADER + "\n" + "\n".join(rows))
    assert [row.nickname for row in table.rows] == ["A", "B-2", "C", "c", "E"]


@pytest.mark.parametrize("row", ['C1,BIT,"A",0,No,""', "nonsense", 'C2,BIT,"open,0,No,""', 'C1,INT,"A",0,Maybe,""'])
def test_a_table_with_endless_problems_is_not_read_to_its_end(file: Path, row: str) -> None:
    rows = ['C1,BIT,"A",0,No,""', *[row] * 150_000]
    found: list[tuple[Diagnostic, ...]] = []
    work = calls_in(lambda: found.append(judged(file, "\n".join([HEADER, *rows]))[1]))
    assert work < 600_000
    [problems] = found
    assert len(problems) == 1_000
    assert [problem for problem in problems if "and more" in problem.message] == [problems[-1]]
    assert problems[-1].message.endswith("; and more: nothing below is read")


@given(st.binary(max_size=200) | st.text(st.sampled_from('C1,"\r\n\0 AbitNo0ä;'), max_size=80).map(str.encode))
def test_no_content_is_too_strange(tmp_path: Path, content: bytes) -> None:
    judged(tmp_path / "strange.csv", HEADER.encode() + b"\n" + content.decode(errors="replace").encode())
    (tmp_path / "raw.csv").write_bytes(content)
    with pytest.raises(TableUnreadable):
        read_table(tmp_path / "raw.csv", "raw.csv", Diagnostics())


def test_a_large_table_is_read_row_by_row(file: Path) -> None:
    rows = [
        format_row(default_row(Address(bank.name, number), f"{bank.name} nickname {number}", "what it is for"))
        for bank in BANKS.values()
        if bank.name not in ("SC", "SD")
        for number in bank.numbers()
    ][:10_000]
    file.write_text("\n".join([HEADER, *rows]))
    tables: list[AddressTable] = []
    work = calls_in(lambda: tables.append(read_table(file, "nicknames.csv", Diagnostics())))
    assert len(tables[0].rows) == 10_000
    assert work < 80 * 10_000
