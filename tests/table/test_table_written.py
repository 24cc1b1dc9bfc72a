"""The address table: writing changes no row that nobody changed."""

from __future__ import annotations

import csv
import io
import math
import struct
from itertools import accumulate
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_tables import EXPORT, at, file, judged, made_rows, table_of
from pyclickplc import read_csv
from pyclickplc.validation import validate_initial_value

from clickgen.device.banks import BANKS, Address, Kind
from clickgen.emit.built import BuiltProgram
from clickgen.emit.nickname_csv import nickname_csv
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import COLUMNS, HEADER, Row, default_row, format_initial, format_row

__all__ = ["file"]


# -- tables made up by hypothesis --------------------------------------------------------------------------------------


def in_some_style(draw: st.DrawFn, row: Row) -> str:
    """The row as CLICK, a spreadsheet or a person might write it."""
    style = draw(st.sampled_from(["click", "spreadsheet", "quoted"]))
    if style == "click":
        return format_row(row)
    fields = next(csv.reader(io.StringIO(format_row(row), newline="")))
    line = io.StringIO(newline="")
    csv.writer(line, quoting=csv.QUOTE_ALL if style == "quoted" else csv.QUOTE_MINIMAL).writerow(fields)
    return line.getvalue().removesuffix("\r\n")


@given(st.data())
def test_made_up_tables_read_back_and_are_written_byte_for_byte(tmp_path: Path, data: st.DataObject) -> None:
    rows = data.draw(made_rows())
    newline = data.draw(st.sampled_from(["\n", "\r\n"]))
    lines = [HEADER, *data.draw(st.composite(lambda draw: [in_some_style(draw, row) for row in rows])())]
    text = newline.join(lines) + data.draw(st.sampled_from(["", newline]))
    content = data.draw(st.sampled_from([b"", b"\xef\xbb\xbf"])) + text.encode()

    table, problems = judged(tmp_path / "made.csv", content)
    assert problems == ()
    assert [row.content for row in table.rows] == [row.content for row in rows]
    assert [row.raw for row in table.rows] == lines[1:]
    starts = accumulate((line.count("\n") + 1 for line in lines), initial=1)
    assert [1, *(row.line for row in table.rows)] == list(starts)[:-1]

    records = read_csv(tmp_path / "made.csv") if not content.startswith(b"\xef") else None
    if records is not None:
        assert {str(row.address) for row in rows} == {record.display_address for record in records.values()}


@given(made_rows(), made_rows())
def test_extending_moves_nothing_and_keeps_order(tmp_path: Path, old: list[Row], new: list[Row]) -> None:
    """Over tables in any order, CLICK's included."""
    taken = {row.address for row in old} | {at("X001")}
    names = {row.nickname.lower() for row in old if row.nickname}
    new = [row for row in new if row.address not in taken and row.nickname.lower() not in names]
    for rows in (old, sorted(old, key=lambda row: row.address.sort_key)):
        text = HEADER + "\n" + "".join(format_row(row) + "\n" for row in rows)
        table, problems = judged(tmp_path / "old.csv", text)
        assert problems == ()
        more = table.extended(new)
        assert [row for row in more.rows if row.line] == list(table.rows)
        assert {row.content for row in more.rows} == {row.content for row in (*old, *new)}
        assert more == table.extended(list(reversed(new)))
        assert more.extended(new) == more
        read, problems = judged(tmp_path / "new.csv", more.to_bytes())
        assert problems == ()
        assert [row.content for row in read.rows] == [row.content for row in more.rows]
    in_order = [row.address.sort_key for row in more.rows]
    assert in_order == sorted(in_order)


@given(made_rows())
def test_the_import_file_holds_the_same_records_for_pyclickplc(tmp_path: Path, rows: list[Row]) -> None:
    # pyclickplc's own writer leaves the characters of a CSV unquoted in a TXT's initial value, and so does not read
    # such a row back; ours are quoted.
    path = tmp_path / "nicknames.csv"
    path.write_bytes(nickname_csv(BuiltProgram("", (), tuple(rows))).encode())
    records = read_csv(path)
    expected = [row for row in rows if row.address.bank not in ("SC", "SD") and not row.is_default]
    assert len(records) == len(expected)
    for row in expected:
        record = records.addr[str(row.address)]
        assert record.has_content
        assert (record.nickname, record.initial_value, record.retentive, record.comment) == (
            row.nickname,
            row.initial,
            row.retentive,
            row.comment,
        )
        assert record.data_type == BANK_TYPES[row.address.kind]
    keys = [record.addr_key for record in records.values()]
    assert keys == sorted(keys)


BANK_TYPES = {Kind.BIT: 0, Kind.INT16: 1, Kind.INT32: 2, Kind.FLOAT: 3, Kind.HEX: 4, Kind.TEXT: 6}


# -- extending ---------------------------------------------------------------------------------------------------------


def names(table: AddressTable) -> str:
    return " ".join(f"{row.address}" for row in table.rows)


def test_new_rows_stand_where_click_would_put_them(file: Path) -> None:
    table = table_of(file, "X001,BIT,A,0,No,", "C5,BIT,B,0,No,", "DS1,INT,C,0,Yes,")
    new = ["TXT1", "DS2", "C1", "C9", "T1", "X002", "Y001", "XD0u", "XD0", "SC3"]
    more = table.extended(default_row(at(text), f"N {text}") for text in new)
    assert names(more) == "X001 X002 Y001 C1 C5 C9 T1 SC3 DS1 DS2 XD0 XD0u TXT1"
    # The old text was written unchanged, unquoted.
    assert more.text().splitlines()[1] == "X001,BIT,A,0,No,"


def test_new_rows_in_a_table_in_a_person_s_order(file: Path) -> None:
    table = table_of(file, "DS9,INT,A,0,Yes,", "DS2,INT,B,0,Yes,", "", "C5,BIT,C,0,No,", "X001,BIT,D,0,No,")
    assert names(table.extended([default_row(at("DS3"), "N")])) == "DS9 DS2 DS3 C5 X001"
    assert names(table.extended([default_row(at("DS10"), "N")])) == "DS9 DS2 DS10 C5 X001"
    assert names(table.extended([default_row(at("DS1"), "N")])) == "DS1 DS9 DS2 C5 X001"
    assert names(table.extended([default_row(at("Y001"), "N")])) == "DS9 DS2 C5 X001 Y001"
    assert names(table.extended([default_row(at("T1"), "N"), default_row(at("T2"), "M")])) == "DS9 DS2 C5 T1 T2 X001"
    assert names(table.extended([default_row(at("TXT1"), "N")])) == "DS9 DS2 TXT1 C5 X001"


def test_an_unnamed_row_gets_its_name_in_place(file: Path) -> None:
    table = table_of(file, "C1,BIT,A,0,No,", 'C2,BIT,"",1,Yes,"kept"', "C3,BIT,B,0,No,")
    more = table.extended([table.named(at("C2"), "New")])
    assert more.text().splitlines()[1:] == ["C1,BIT,A,0,No,", 'C2,BIT,"New",1,Yes,"kept"', "C3,BIT,B,0,No,"]
    assert table.named(at("C9"), "New") == default_row(at("C9"), "New")
    assert table.named(at("C2"), "New", "other").comment == "other"


def test_a_changed_comment_replaces_the_row_and_nothing_else(file: Path) -> None:
    table = table_of(file, "C1,BIT,A,0,No,old", "C2,BIT,B,0,No,old")
    more = table.extended([Row(at("C1"), "A", "0", False, "new"), Row(at("C2"), "B", "0", False, "old")])
    assert more.text().splitlines()[1:] == ['C1,BIT,"A",0,No,"new"', "C2,BIT,B,0,No,old"]
    assert table.extended([Row(at("C2"), "B", "0", False, "old")]) is table


def test_no_name_and_no_address_moves(file: Path) -> None:
    table = table_of(file, "C1,BIT,A,0,No,")
    with pytest.raises(ValueError, match="C1 is A and cannot become B"):
        table.extended([default_row(at("C1"), "B")])
    with pytest.raises(ValueError, match="a is C1 and cannot move to C2"):
        table.extended([default_row(at("C2"), "a")])
    with pytest.raises(ValueError, match="B is C3 and cannot move to C4"):
        table.extended([default_row(at("C3"), "B"), default_row(at("C4"), "B")])
    with pytest.raises(ValueError, match="C3"):
        table.extended([default_row(at("C3"), "B"), default_row(at("C3"), "D")])


# -- rows and values ---------------------------------------------------------------------------------------------------


def test_default_rows_are_as_click_writes_them() -> None:
    written = {line.split(",", 1)[0]: line for line in EXPORT.read_text("utf-8").splitlines()}
    for text in ("C1", "T1", "CT1", "DS1", "DD1", "DH1", "DF1", "TXT1", "XD0u", "TD1"):
        nickname = next(csv.reader([written[text]]))[2]
        assert format_row(default_row(at(text), nickname)) == written[text]
    assert format_row(default_row(at("y1"), "Q", 'a "b"')) == 'Y001,BIT,"Q",0,No,"a ""b"""'
    assert len(COLUMNS) == 6


@pytest.mark.parametrize(
    ("kind", "value", "text"),
    [
        (Kind.BIT, True, "1"), (Kind.BIT, 0, "0"), (Kind.BIT, 2, None), (Kind.BIT, 1.0, None), (Kind.BIT, "1", None),
        (Kind.INT16, -32768, "-32768"), (Kind.INT16, 32768, None), (Kind.INT16, True, None), (Kind.INT16, 1.5, None),
        (Kind.INT32, 2**31 - 1, "2147483647"), (Kind.INT32, 2**31, None),
        (Kind.HEX, 0, "0"), (Kind.HEX, 0xFF, "00FF"), (Kind.HEX, "00ffh", "00FF"), (Kind.HEX, "FFFF", "FFFF"),
        (Kind.HEX, -1, None), (Kind.HEX, 0x10000, None), (Kind.HEX, "10000", None), (Kind.HEX, "xyz", None),
        (Kind.FLOAT, 0, "0"), (Kind.FLOAT, -0.0, "0"), (Kind.FLOAT, 1, "1"), (Kind.FLOAT, 0.1, "0.1"),
        (Kind.FLOAT, 100, "100"), (Kind.FLOAT, 12.5, "12.5"), (Kind.FLOAT, 1e7, "1E+07"),
        (Kind.FLOAT, 1234567, "1234567"), (Kind.FLOAT, 1.5e-7, "1.5E-07"), (Kind.FLOAT, 0.00002, "0.00002"),
        (Kind.FLOAT, 3.4028235e38, "3.4028235E+38"), (Kind.FLOAT, -3.4028235e38, "-3.4028235E+38"),
        (Kind.FLOAT, 3.5e38, None), (Kind.FLOAT, math.nan, None), (Kind.FLOAT, math.inf, None),
        (Kind.FLOAT, 10**400, None), (Kind.FLOAT, True, None), (Kind.FLOAT, "1", None),
        (Kind.TEXT, "", ""), (Kind.TEXT, "A", "A"), (Kind.TEXT, "AB", None), (Kind.TEXT, "ä", None),
        (Kind.TEXT, 5, None), (Kind.TEXT, "\0", None),
    ],
)  # fmt: skip
def test_initial_values(kind: Kind, value: object, text: str | None) -> None:
    assert format_initial(kind, value) == text


@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
def test_a_float_comes_back_as_the_same_float(value: float) -> None:
    text = format_initial(Kind.FLOAT, value)
    assert text is not None
    assert struct.pack("<f", float(text)) == struct.pack("<f", value + 0.0)
    assert validate_initial_value(text, 3) == (True, "")


@given(kind=st.sampled_from(list(Kind)), value=st.integers() | st.text(max_size=5) | st.booleans() | st.floats())
def test_every_formatted_value_is_one_that_a_row_may_hold(kind: Kind, value: Any) -> None:
    text = format_initial(kind, value)
    if text is None:
        return
    assert validate_initial_value(text, BANK_TYPES[kind]) == (True, "")
    bank = next(bank for bank in BANKS.values() if bank.kind is kind and not bank.settings_fixed)
    problems = Diagnostics()
    check_row(Row(Address(bank.name, bank.first), "N", text, False, ""), problems)
    assert problems.found == []


def check_row(row: Row, problems: Diagnostics) -> None:
    from clickgen.table import read as room

    reader = room._Reader("t", problems)
    reader.read([HEADER + "\n", *io.StringIO(format_row(row), newline="\n").readlines()])
    assert [entry.row.content for entry in reader.entries[1:] if entry.row] == [row.content]


# -- the import file ---------------------------------------------------------------------------------------------------


def test_the_import_file() -> None:
    rows = [
        Row(at("DS1"), "B", "5", True, "", 3, "DS1,INT,B,5,Yes,"),
        Row(at("SC1"), "_Always_ON", "0", False, ""),
        Row(at("SD1"), "_PLC_Error_Code", "0", False, ""),
        Row(at("C2"), "", "0", False, ""),
        Row(at("C3"), "", "0", True, ""),
        Row(at("C4"), "", "0", False, "spare"),
        Row(at("TXT1"), "", "", True, ""),
        Row(at("C1"), "A", "0", False, ""),
        Row(at("TXT2"), "T", '"', True, ""),
    ]
    assert nickname_csv(BuiltProgram("", (), tuple(rows))) == (
        f"{HEADER}\n"
        'C1,BIT,"A",0,No,""\n'
        'C3,BIT,"",0,Yes,""\n'
        'C4,BIT,"",0,No,"spare"\n'
        'DS1,INT,"B",5,Yes,""\n'
        'TXT2,TEXT,"T","""",Yes,""\n'
    )
    assert nickname_csv(BuiltProgram("", (), ())) == HEADER + "\n"


def test_an_export_of_click_comes_out_as_it_was_without_its_own_points(file: Path) -> None:
    table, _ = judged(file, EXPORT.read_bytes())
    kept = [line for line in EXPORT.read_text("utf-8").splitlines() if not line.startswith(("SC", "SD"))]
    assert nickname_csv(BuiltProgram("", (), tuple(reversed(table.rows)))).splitlines() == kept
