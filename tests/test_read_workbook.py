"""An I/O list that a person made is read for what it certainly says, and no workbook brings the reader down."""

from __future__ import annotations

import contextlib
import datetime
import io
import os
import random
import re
import tracemalloc
import warnings
import zipfile
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import budget
import openpyxl
import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st
from judges.work import calls_in
from openpyxl.worksheet.worksheet import Worksheet

from clickgen.device.banks import BANKS, Address, parse_address
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.table.read import TableUnreadable
from clickgen.table.rows import Row, default_row
from clickgen.table.workbook import archive as limits
from clickgen.table.workbook.read import read_workbook
from clickgen.table.workbook.titles import TITLES, Field

Lines = Iterable[Iterable[Any]]
TITLE = ("Address", "Nickname", "Initial Value", "Retentive", "Comment")


def at(text: str) -> Address:
    address = parse_address(text)
    assert address is not None
    return address


def workbook(**sheets: Lines | Callable[[Worksheet], None]) -> bytes:
    """A workbook with these sheets: rows from the top, or a function that fills the sheet."""
    book = openpyxl.Workbook()
    assert book.active is not None
    book.remove(book.active)
    for title, content in sheets.items():
        sheet = book.create_sheet(title)
        if callable(content):
            content(sheet)
        else:
            for row in content:
                sheet.append(list(row))
    return saved(book)


def saved(book: openpyxl.Workbook) -> bytes:
    file = io.BytesIO()
    book.save(file)
    return file.getvalue()


def judged(data: bytes) -> tuple[tuple[Row, ...], tuple[Diagnostic, ...]]:
    problems = Diagnostics()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rows = read_workbook(Path("nowhere.xlsx"), "io.xlsx", problems, data)
    for problem in problems.found:
        assert problem.help
        assert problem.span is not None
        assert problem.span.path == "io.xlsx"
        assert problem.span.sheet
    return rows, tuple(problems.found)


def rows_of(data: bytes) -> tuple[Row, ...]:
    rows, problems = judged(data)
    assert problems == ()
    return rows


def said(data: bytes) -> list[str]:
    """``CG601 IO!B7 message (labels)`` of everything wrong."""
    _, problems = judged(data)
    return [
        f"{problem.code} {problem.span.cell if problem.span else ''} {problem.message}"
        + "".join(f" ({label.span.cell})" for label in problem.labels)
        for problem in problems
    ]


def in_words(row: Row) -> str:
    cell = row.cell.cell if row.cell else ""
    return f"{row.address} {row.nickname}|{row.initial}|{'Yes' if row.retentive else 'No'}|{row.comment} {cell}"


def listed(*rows: Iterable[Any]) -> bytes:
    """A workbook with one list of the usual titles; the first of the rows is row 2."""
    return workbook(IO=[TITLE, *rows])


T = TypeVar("T")


def little(work: Callable[[], T], calls: int = 4_000_000) -> T:
    """What the work gives, which may take so many calls of functions: what a file could make endless is cut off."""
    found: list[T] = []
    count = calls_in(lambda: found.append(work()))
    assert count < calls
    return found[0]


def unreadable(data: bytes) -> str:
    """Why these bytes cannot be read."""
    with pytest.raises(TableUnreadable) as caught:
        judged(data)
    message = str(caught.value)
    assert message.startswith("io.xlsx ")
    assert message.isprintable()
    assert len(message) < 500
    return message


# -- lists ------------------------------------------------------------------------------------------------------------


def test_a_plain_list() -> None:
    rows = rows_of(
        listed(
            ("X001", "Start", 0, "No", "the green button"),
            ("ds1", " Speed ", 5, "yes", None),
            (None, None, None, None, None),
            ("C1", "Running", None, None, None),
            ("C2", None, None, None, "no name, but a comment"),
            ("C3", None, None, None, None),
        )
    )
    assert [in_words(row) for row in rows] == [
        "X001 Start|0|No|the green button IO!A2",
        "DS1 Speed|5|Yes| IO!A3",
        "C1 Running|0|No| IO!A5",
        "C2 |0|No|no name, but a comment IO!A6",
    ]
    assert all(row.line == 0 and row.raw == "" for row in rows)
    assert str(rows[1].cell) == "io.xlsx:IO!A3"


def test_the_file_is_read_where_no_bytes_are_given(tmp_path: Path) -> None:
    path = tmp_path / "io.xlsm"
    path.write_bytes(listed(("X001", "Start")))
    assert len(read_workbook(path, "io.xlsm", Diagnostics())) == 1
    with pytest.raises(TableUnreadable, match=r"there is no workbook at gone\.xlsx"):
        read_workbook(tmp_path / "gone.xlsx", "gone.xlsx", Diagnostics())
    with pytest.raises(TableUnreadable, match="plant cannot be read: it is a folder"):
        read_workbook(tmp_path, "plant", Diagnostics())


@pytest.mark.parametrize(
    "titles",
    [
        ("ADDRESS", "nick name", "comment"),
        ("PLC\nAddress", "Tag-Name", "Description:"),
        ("I/O Address *", "TAG", "Desc."),
        ("Address (CLICK)", "Signal [24]", "Remarks"),
        ("Adresse", "Name", "Beschreibung"),
        ("Dirección", "NOMBRE", "Descripción"),
    ],
)
def test_titles_have_many_forms(titles: tuple[str, str, str]) -> None:
    (row,) = rows_of(workbook(IO=[titles, ("X001", "Start", "green")]))
    assert (row.nickname, row.comment) == ("Start", "green")


@pytest.mark.parametrize(
    ("what", "title"), [(what, title) for what, titles in TITLES.items() for title in titles.split(", ")]
)
def test_every_title_is_known(what: Field, title: str) -> None:
    titles = {Field.ADDRESS: "Address", Field.NICKNAME: "Nickname", what: title}
    content = {Field.ADDRESS: "C1", Field.NICKNAME: "A", Field.INITIAL: 1, Field.RETENTIVE: "x", Field.COMMENT: "c"}
    (row,) = rows_of(workbook(IO=[list(titles.values()), [content[each] for each in titles]]))
    changed = {Field.INITIAL: ("1", False, ""), Field.RETENTIVE: ("0", True, ""), Field.COMMENT: ("0", False, "c")}
    assert (row.initial, row.retentive, row.comment) == changed.get(what, ("0", False, ""))


def test_columns_come_in_any_order_among_others() -> None:
    data = workbook(
        IO=[
            ("No.", "Description", "Wire", "Tag", "Type", "Address", "Rev", "Retentive"),
            (1, "green", "W7", "Start", "24 V", "X001", 3.5, "y"),
        ]
    )
    assert [in_words(row) for row in rows_of(data)] == ["X001 Start|0|Yes|green IO!F2"]


def test_the_best_title_of_a_field_counts() -> None:
    data = workbook(IO=[("Name", "Register", "Notes", "Nickname", "Comment", "Address"), ("N", 1, "n", "A", "c", "C1")])
    assert [in_words(row) for row in rows_of(data)] == ["C1 A|0|No|c IO!F2"]


@pytest.mark.parametrize(
    ("address", "nickname", "comment"),
    [
        ("Address Internal", "Tag", "Description"),
        ("PLC\nAddress", "PLC Tag Name", "Signal Description"),
        ("Adresse / Address", "Symbol / Name", "Kommentar / Comment"),
        ("Adresse | Dirección", "Nom | Nombre", "Désignation | Descripción"),
        ("ADRESSE API", "MNEMONIQUE", "LIBELLE"),
        ("Address (CLICK)", "Tag #", "Service"),
        ("I/O ADDRESS", "Tag No.", "FUNCTION DESCRIPTION"),
        ("Address - PLC", "Point Name", "I/O Description"),
        ("Interne Adresse", "BMK", "Funktionstext"),
    ],
)
def test_titles_as_people_write_them(address: str, nickname: str, comment: str) -> None:
    (row,) = rows_of(workbook(IO=[(nickname, "No.", address, comment), ("Start", 1, "X001", "green")]))
    assert in_words(row) == "X001 Start|0|No|green IO!C2"


@pytest.mark.parametrize("title", ["Modbus Address", "IP Address", "Node Address", "Terminal", "Wire"])
def test_titles_of_other_things(title: str) -> None:
    assert "holds no list of addresses" in unreadable(workbook(IO=[(title, "Nickname"), ("X001", "Start")]))


def test_internal_and_external_addresses() -> None:
    """The internal one counts; where there is none, the external one."""
    titles = ("Tag", "Address External", "Address Internal", "Description")
    data = workbook(
        IO=[
            titles,
            ("Start", "X001", None, "button"),
            ("Speed", "400001", "DS1", None),
            ("Stop", "x2", "N/A", None),
            ("Ready", "Y001", "C1", None),
            ("Fault", "Y002", "C2", None),
            ("Nowhere", "-", None, None),
        ]
    )
    rows, _ = judged(data)
    assert [f"{row.address} {row.nickname}" for row in rows] == [
        "X001 Start", "DS1 Speed", "X002 Stop", "C1 Ready", "C2 Fault"
    ]  # fmt: skip
    assert said(data) == [
        "CG604 IO!A7 Nowhere has no address and is left out",
        "CG604 IO!B5 Y001 is left out: the internal address of the row, C1, counts, and so in 1 row below",
    ]


# -- spare points -----------------------------------------------------------------------------------------------------

SPARES = [
    "N/A", "n.a.", "SPARE", "Spare", "spare", "Reserve", "RESERVED", "-", "--", "not used", "Not Used", "unused", "TBD",
    "tba", "???", "None", "nicht belegt", "Réserve", "Reserva", "no usado", "SPARE INPUT", "[spare]",
]  # fmt: skip


@pytest.mark.parametrize("word", SPARES)
def test_a_spare_point_has_no_nickname(word: str) -> None:
    data = listed(("X001", "Start"), ("X002", word), ("X003", word, None, None, "on TB3"), (None, word))
    rows, problems = judged(data)
    assert [f"{row.address} {row.nickname}|{row.comment}" for row in rows if not row.is_default] == [
        "X001 Start|", "X003 |on TB3"
    ]  # fmt: skip
    assert [problem.code for problem in problems] == ([] if set(word) == {"-"} else ["CG618"])
    assert not any(problem.is_error for problem in problems)


def test_how_many_rows_are_passed_over_is_said_once() -> None:
    data = listed(
        ("X001", "SPARE"), ("X002", "Start"), ("X003", "N/A"), ("X004", "SPARE"), ("X005", "TBD"), ("X006", "unused"),
        ("X007", "???"),
    )  # fmt: skip
    assert said(data) == [
        "CG618 IO!B2 6 rows of this list have no nickname: SPARE in 2, N/A in 1, TBD in 1, unused in 1, others in 1"
    ]
    assert said(listed(("X001", "Start"), ("X002", "SPARE"))) == [
        "CG618 IO!B3 1 row of this list has no nickname: SPARE in 1"
    ]


def test_what_may_be_a_name_is_none_where_two_points_have_it() -> None:
    once = listed(("DF1", "x"), ("DF2", "y"), ("X001", "Open"), ("X002", "Free"))
    assert [row.nickname for row in rows_of(once)] == ["x", "y", "Open", "Free"]
    rows, problems = judged(listed(("X001", "x"), ("X002", "X"), ("X003", "Open")))
    assert [(str(row.address), row.nickname, row.spare) for row in rows] == [
        ("X001", "", "x"), ("X002", "", "X"), ("X003", "Open", "")
    ]  # fmt: skip
    assert [problem.code for problem in problems] == ["CG618"]


def test_in_a_table_of_clicks_own_form_a_word_is_a_nickname_as_long_as_it_is_alone() -> None:
    titles = ("Address", "Data Type", "Nickname", "Initial Value", "Retentive", "Address Comment")
    rows = rows_of(
        workbook(IO=[titles, ("X001", "BIT", "Spare", 0, "No", None), ("X002", "BIT", "Reserve", 0, "No", None)])
    )
    assert [row.nickname for row in rows] == ["Spare", "Reserve"]
    twice = workbook(IO=[titles, ("X001", "BIT", "Spare", 0, "No", None), ("X002", "BIT", "SPARE", 0, "No", None)])
    rows, problems = judged(twice)
    assert [row.spare for row in rows] == ["Spare", "SPARE"]
    assert [problem.code for problem in problems] == ["CG618"]
    assert said(workbook(IO=[titles, ("X001", "BIT", "N/A", 0, "No", None)])) == [
        "CG618 IO!C2 1 row of this list has no nickname: N/A in 1"
    ]


def test_a_spare_with_a_number_is_a_nickname() -> None:
    assert [row.nickname for row in rows_of(listed(("X001", "Spare 1"), ("X002", "SPARE2")))] == ["Spare 1", "SPARE2"]


def test_a_point_that_is_spare_in_one_list_and_named_in_another_is_named() -> None:
    data = workbook(IO=[("Address", "Tag"), ("X001", "SPARE")], More=[("Address", "Tag"), ("X001", "Start")])
    rows, problems = judged(data)
    assert [(row.nickname, row.spare) for row in rows] == [("Start", "")]
    assert [problem.code for problem in problems] == ["CG618"]


def test_other_columns_may_say_that_nothing_applies() -> None:
    (row,) = rows_of(listed(("X001", "Start", "N/A", "n.a.", "N/A")))
    assert in_words(row) == "X001 Start|0|No|N/A IO!A2"
    assert said(listed(("C1", "A"), ("n/a", "Name"), ("TBD", "Other"), ("none", "SPARE"))) == [
        "CG604 IO!B3 Name has no address and is left out",
        "CG604 IO!B4 Other has no address and is left out",
    ]


def test_titles_below_captions_and_merged_cells() -> None:
    def fill(sheet: Worksheet) -> None:
        sheet["A1"] = "Press 4, I/O list"
        sheet.merge_cells("A1:F3")
        sheet["A5"], sheet["B5"], sheet["C5"] = "Address", "Nickname", "Settings"
        sheet.merge_cells("A5:A6")
        sheet.merge_cells("B5:B6")
        sheet.merge_cells("C5:D5")
        sheet["C6"], sheet["D6"], sheet["E6"] = "Initial value", "Retentive", "Comment"
        sheet.append(("DS1", "Speed", 7, "no", "in rpm"))

    assert [in_words(row) for row in rows_of(workbook(IO=fill))] == ["DS1 Speed|7|No|in rpm IO!A7"]


def test_a_title_over_two_columns_with_titles_of_their_own() -> None:
    def fill(sheet: Worksheet) -> None:
        sheet["B2"], sheet["C2"], sheet["E2"] = "Signal", "Location", "Comment"
        sheet.merge_cells("B2:C2")
        sheet["B3"], sheet["C3"] = "Name", "Address"
        sheet.append((None, "Start", "X001", None, "green"))

    assert [in_words(row) for row in rows_of(workbook(IO=fill))] == ["X001 Start|0|No|green IO!C4"]


def test_lists_below_each_other_with_captions_between() -> None:
    data = workbook(
        IO=[
            ("Slot 1 inputs",),
            ("Address", "Tag", "Comment"),
            ("X001", "Start", "green"),
            (),
            (None, "Slot 2 outputs"),
            ("Tag", "Description", "Address"),
            ("Lamp", "red", "Y001"),
            ("Slot 3",),
            ("Tag", "Address"),
            ("Horn", "Y002"),
            ("sum",),
        ]
    )
    assert said(data) == ["CG604 IO!A11 sum has no address and is left out"]
    assert [in_words(row) for row in judged(data)[0]] == [
        "X001 Start|0|No|green IO!A3",
        "Y001 Lamp|0|No|red IO!C7",
        "Y002 Horn|0|No| IO!B10",
    ]


def test_lists_beside_each_other() -> None:
    data = workbook(
        IO=[
            ("Address", "Tag", "Comment", None, "Address", "Tag", "Comment"),
            ("X001", "Start", "green", None, "Y001", "Lamp", "red"),
            ("X002", "Stop", None, None, None, None, None),
        ]
    )
    assert [in_words(row) for row in rows_of(data)] == [
        "X001 Start|0|No|green IO!A2",
        "X002 Stop|0|No| IO!A3",
        "Y001 Lamp|0|No|red IO!E2",
    ]


def test_a_row_of_words_that_are_titles_too_is_data() -> None:
    titles = ("Address", "Nickname", "Comment")
    data = workbook(IO=[titles, ("DS1", "Signal", "Register"), ("DS2", "Name", "Address"), ("DS3", "Speed", "rpm")])
    assert [in_words(row) for row in rows_of(data)] == [
        "DS1 Signal|0|Yes|Register IO!A2",
        "DS2 Name|0|Yes|Address IO!A3",
        "DS3 Speed|0|Yes|rpm IO!A4",
    ]


def test_a_terminal_is_no_address() -> None:
    data = workbook(IO=[("Terminal", "PLC Addr", "Symbolic name"), ("C1", "X001", "Start")])
    assert [in_words(row) for row in rows_of(data)] == ["X001 Start|0|No| IO!B2"]
    unreadable(workbook(IO=[("Terminal", "Name"), ("C1", "Start")]))


def test_several_sheets_hidden_ones_too() -> None:
    book = openpyxl.load_workbook(
        io.BytesIO(
            workbook(
                Notes=[("Revision", "Name"), ("A", "Smith")],
                In=[("Address", "Tag"), ("X001", "Start")],
                Out=[("Address", "Tag"), ("Y001", "Lamp")],
                Old=[("Address", "Tag"), ("C1", "Run"), ("X001", "Other")],
            )
        )
    )
    book["Out"].sheet_state = "hidden"
    book["Old"].sheet_state = "veryHidden"
    book["In"].row_dimensions[2].hidden = True
    book.create_chartsheet("Chart")
    rows, (problem,) = judged(saved(book))
    assert [in_words(row) for row in rows] == [
        "X001 Start|0|No| In!A2",
        "Y001 Lamp|0|No| Out!A2",
        "C1 Run|0|No| Old!A2",
    ]
    assert problem.message == "the nickname of X001 is Other here and Start in In!A2".replace("A2", "B2")
    assert "hidden: Old" in problem.help


def test_the_first_titles_stand_in_the_first_fifty_rows() -> None:
    far = [("Address", "Tag"), ("X001", "Start")]
    assert len(rows_of(workbook(IO=[*[("remark",)] * 49, *far]))) == 1
    unreadable(workbook(IO=[*[("remark",)] * 50, *far]))
    assert len(rows_of(workbook(IO=[*far, *[("C1", None)] * 200, *far[:1], ("X002", "Stop")]))) == 2


def test_a_workbook_without_a_list_says_what_is_looked_for() -> None:
    message = unreadable(workbook(Contacts=[("Name", "Phone"), ("Smith", 5)], Empty=[]))
    assert message == (
        "io.xlsx holds no list of addresses: no row has the titles Address and Nickname (or Tag, Name, Symbol) "
        "among the first 50 of a sheet (the sheets are: Contacts, Empty)"
    )
    many = {f"Sheet {number}": [("nothing",)] for number in range(40)}
    assert unreadable(workbook(**many)).endswith("Sheet 8, Sheet 9, ...)")


def test_a_list_without_rows_is_one() -> None:
    assert rows_of(listed()) == ()


def test_a_list_of_other_addresses() -> None:
    data = workbook(
        Modbus=[("Address", "Name"), (None, "heading"), (40001, "Speed"), (40002, "Level")],
        IO=[("Address", "Name"), ("X001", "Start"), (5, "Odd")],
    )
    assert said(data) == [
        "CG601 Modbus!A3 no row of this list has an address of CLICK; the first reads 40001",
        "CG601 IO!A3 CLICK has no address 5",
    ]


# -- addresses and names ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("X001", "X001"),
        ("x1", "X001"),
        (" X 01 ", "X001"),
        ("DS\u00a0100", "DS100"),
        ("ds00100", "DS100"),
        ("xd0U", "XD0u"),
        ("CTD\n250", "CTD250"),
        ("txt1000", "TXT1000"),
    ],
)
def test_an_address_has_many_forms(text: str, address: str) -> None:
    (row,) = rows_of(listed((text, "Name")))
    assert row.address == at(address)


@pytest.mark.parametrize("text", ["X017", "X-001", "DS4501", "Q1", "1", "X", "X1.0", "X001 X002", "XD1u", "X\u0661"])
def test_what_is_no_address(text: str) -> None:
    data = listed(("C1", "A"), (text, "Name"))
    assert said(data) == [f"CG601 IO!A3 CLICK has no address {text}"]


def test_the_way_out_of_what_is_no_address() -> None:
    _, (remark, point) = judged(listed(("C1", "A"), ("Drawn by", "Smith"), ("X017", "B")))
    assert remark.help.startswith("the banks are X Y C")
    assert remark.help.endswith("; a remark belongs outside the columns of the list")
    assert point.help.startswith("X has 1..16, 21..36")


def test_rows_without_address_or_without_anything() -> None:
    data = listed(
        ("C1", "A"),
        (None, "Forgotten", 5, "yes", "said"),
        ("-", "Planned"),
        (" ", "\u2014", None, None, "a remark"),
        ("Spare points", None, None, None, "from here"),
        ("X017", None, None, None, None),
        ("X018", None, None, None, "spare"),
        ("C2", "-", None, None, None),
        (None, 32, None, None, None),
    )
    assert said(data) == [
        "CG604 IO!B3 Forgotten has no address and is left out",
        "CG604 IO!B4 Planned has no address and is left out",
        "CG601 IO!A8 CLICK has no address X018",
    ]
    rows, problems = judged(data)
    assert len(rows) == 1
    assert problems[0].help == "write its address into IO!A3"


def test_a_name_in_the_second_column_of_a_merged_title() -> None:
    def fill(sheet: Worksheet) -> None:
        sheet["A1"], sheet["B1"], sheet["D1"] = "Address", "Tag", "Comment"
        sheet.merge_cells("B1:C1")
        sheet.append(("X001", None, "Start"))
        sheet.append(("X002", "Stop", "and a remark"))

    rows, (problem,) = judged(workbook(IO=fill))
    assert [row.nickname for row in rows] == ["Stop"]
    assert problem.code == "CG604"
    assert problem.message == "X001 has no nickname; Start, in a column without a title, is left out"
    assert problem.help == "move it into IO!B2, or give its column a title"


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("Pump-1", "Pump-1 of C1: it holds -, which CLICK forbids in a nickname"),
        ("_Pump", "_Pump of C1: it begins with an underscore, which CLICK keeps for its own names"),
        ("P\u00fcmpe", "P\u00fcmpe of C1: it holds \u00fc, which is not ASCII"),
        ("A" * 25, f"{'A' * 25} of C1: it has 25 characters and CLICK takes 24"),
        ("two\nlines", "'two\\nlines' of C1: it holds a line break, which CLICK forbids in a nickname"),
        ("Mod", "Mod of C1: Mod is a word of CLICK's formulas"),
    ],
)
def test_a_nickname_that_click_does_not_take(name: str, why: str) -> None:
    data = listed(("C1", name))
    assert said(data) == [f"CG603 IO!B2 CLICK does not take the nickname {why}"]
    assert [row.nickname for row in judged(data)[0]] == [name]  # never shortened or mended


@pytest.mark.parametrize("value", [101, 1.5, True])
def test_a_number_is_no_nickname(value: object) -> None:
    shown = str(value).upper()
    assert said(listed(("C1", value))) == [f"CG603 IO!B2 the nickname of C1 is {shown}, which is no text"]


def test_names_of_click_on_its_own_points() -> None:
    rows = rows_of(listed(("SC1", "_Always_ON"), ("SD5", "_Twin"), ("SC9", "_twin"), ("X001", "_IO1_Fault")))
    assert [row.nickname for row in rows] == ["_Always_ON", "_Twin", "_twin", "_IO1_Fault"]


# -- values -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("address", "value", "initial"),
    [
        ("C1", 1, "1"), ("C1", 1.0, "1"), ("C1", True, "1"), ("C1", "ON", "1"), ("C1", " off ", "0"), ("C1", "0", "0"),
        ("C1", "  ", "0"), ("C1", "-", "0"),
        ("TXT1", "-", "-"), ("DS1", 5.0, "5"), ("DS1", " -5 ", "-5"), ("DS1", -32768, "-32768"), ("DS1", None, "0"),
        ("DD1", 2147483647, "2147483647"), ("DF1", 0.1, "0.1"), ("DF1", 12, "12"), ("DF1", "1.50", "1.50"),
        ("DF1", 1e20, "1E+20"), ("DF1", "-3.4028235E+38", "-3.4028235E+38"),
        ("DH1", "00FF", "00FF"), ("DH1", "00ffh", "00FF"), ("DH1", "FFh", "00FF"), ("DH1", "0x1f", "001F"),
        ("DH1", "10", "10"), ("DH1", 9, "0009"), ("DH1", 0.0, "0"),
        ("TXT1", "A", "A"), ("TXT1", " ", " "), ("TXT1", "B ", "B"), ("TXT1", 7, "7"), ("TXT1", None, ""),
        ("XD0u", "0", "0"), ("YD1", 0, "0"),
    ],
)  # fmt: skip
def test_initial_values(address: str, value: object, initial: str) -> None:
    (row,) = rows_of(listed((address, "Name", value)))
    assert (row.address, row.initial) == (at(address), initial)


@pytest.mark.parametrize(
    ("address", "value", "why"),
    [
        ("C1", 2, "C1 cannot start with the value 2"),
        ("C1", "maybe", "C1 cannot start with the value maybe"),
        ("DS1", 32768, "DS1 cannot start with the value 32768"),
        ("DS1", 1.5, "DS1 cannot start with the value 1.5"),
        ("DS1", True, "DS1 cannot start with the value TRUE"),
        ("DS1", "5 rpm", "DS1 cannot start with the value 5 rpm"),
        ("DF1", 1e39, "DF1 cannot start with the value 1e+39"),
        ("DF1", "1,5", "DF1 cannot start with the value 1,5"),
        ("DH1", "12345", "DH1 cannot start with the value 12345"),
        ("DH1", 10, "DH1 is hexadecimal, and 10 is a number that may be meant decimal"),
        ("DH1", 1.5, "DH1 is hexadecimal, and 1.5 is a number that may be meant decimal"),
        ("TXT1", "AB", "TXT1 cannot start with the value AB"),
        ("TXT1", 10, "TXT1 cannot start with the value 10"),
        ("XD1", "1", "CLICK lets nobody change the initial value setting of XD1"),
    ],
)
def test_initial_values_that_click_does_not_take(address: str, value: object, why: str) -> None:
    assert said(listed((address, "Name", value))) == [f"CG601 IO!C2 {why}"]


def test_the_way_out_of_a_number_that_may_be_hexadecimal() -> None:
    _, (problem,) = judged(listed(("DH1", "Name", 10)))
    assert problem.help == "write 10h or 000Ah"


@pytest.mark.parametrize("word", ["Yes", "y", "TRUE", True, 1, "1", "x", "X", " \u2713", "Ja"])
def test_retentive(word: object) -> None:
    assert [row.retentive for row in rows_of(listed(("C1", "A", None, word)))] == [True]


@pytest.mark.parametrize("word", ["No", "n", "False", False, 0, "0", "nein"])
def test_not_retentive(word: object) -> None:
    assert [row.retentive for row in rows_of(listed(("DS1", "A", None, word)))] == [False]


def test_retention_is_click_s_own_where_nothing_is_said() -> None:
    rows = rows_of(listed(("C1", "A", None, " "), ("DS1", "B"), ("XD1", "D", None, "No")))
    assert [row.retentive for row in rows] == [False, True, False]
    assert said(listed(("C1", "A", None, "perhaps"), ("YD0u", "B", None, "Yes"))) == [
        "CG601 IO!D2 the retentive setting of C1 reads perhaps",
        "CG601 IO!D3 CLICK lets nobody change the retentive setting of YD0u",
    ]


def test_comments_are_taken_exactly() -> None:
    comments = [" two\nlines ", "=no formula", "\u00e4 \u4e2d", 'a "quote", a comma', "x" * 128]

    def fill(sheet: Worksheet) -> None:
        sheet.append(TITLE)
        for number, comment in enumerate(comments, 1):
            sheet.append((f"C{number}",))
            cell = sheet.cell(number + 1, 5, comment)
            cell.data_type = "s"

    assert [row.comment for row in rows_of(workbook(IO=fill))] == comments
    assert [row.comment for row in rows_of(listed(("C1", "A", None, None, 24), ("C2", "B", None, None, True)))] == [
        "24",
        "TRUE",
    ]
    assert said(listed(("C1", "A", None, None, "x" * 129))) == [
        "CG601 IO!E2 CLICK does not take the comment of C1: it has 129 characters and CLICK takes 128"
    ]


def test_formulas_dates_and_errors_are_no_values() -> None:
    data = workbook(
        IO=[
            (*TITLE, "Total"),
            ('="X"&"001"', "Start", None, None, None, "=1+1"),
            ("C1", '="A"&1'),
            ("C2", '="A"&2'),
            ("C3", '="A"&3', "=1", None, datetime.date(2024, 5, 1)),
            ("C4", "Fine", None, None, None, "=SUM(A1:A2)"),
            ("C5", "#REF!"),
            ('="X"&"002"',),
        ]
    )
    assert said(data) == [
        "CG601 IO!A2 the address in IO!A2 is a formula",
        "CG601 IO!B3 the nickname in IO!B3 is a formula, and so are 2 more below",
        "CG601 IO!C5 the initial value in IO!C5 is a formula",
        "CG604 IO!E5 the comment in IO!E5 is a date and is left out",
        "CG601 IO!B7 the nickname in IO!B7 is an error, #REF!",
    ]
    _, problems = judged(data)
    assert problems[0].help.startswith("copy the cells and paste them as values")


def test_a_formula_as_a_comment_is_left_out_with_a_warning() -> None:
    data = listed(
        ("C1", "A", None, None, '="for "&"A"'), ("C2", "B", None, None, "kept"), ("C3", "C", None, None, "=A1")
    )
    assert said(data) == ["CG604 IO!E2 the comment in IO!E2 is a formula and is left out, and so is 1 more below"]
    assert [(row.nickname, row.comment) for row in judged(data)[0]] == [("A", ""), ("B", "kept"), ("C", "")]


# -- what is said twice -----------------------------------------------------------------------------------------------


def test_what_rows_say_of_one_address_is_put_together() -> None:
    data = workbook(
        Tags=[TITLE, ("X001", "Start", "0", "No", ""), ("DF1", "Speed", "1.50", "Yes", "rpm"), ("DH1", "Mask", "0F")],
        Slot1=[("Point", "Tag", "Description"), ("x1", "START", "green "), ("X002", None, None)],
        Cross=[("Address", "Nickname", "Routine"), ("X001", "Start", "main"), ("X001", "Start", "sub"), ("DF1", None)],
        More=[
            TITLE,
            ("DF1", None, 1.5, "x", " "),
            ("X002", "Stop"),
            ("X001", None, None, None, "green"),
            ("DH1", None, "000Fh"),
        ],
    )
    assert [in_words(row) for row in rows_of(data)] == [
        "X001 Start|0|No|green  Tags!A2",
        "DF1 Speed|1.50|Yes|rpm Tags!A3",
        "DH1 Mask|0F|Yes| Tags!A4",
        "X002 Stop|0|No| More!A3",
    ]


def test_contradictions_name_both_cells() -> None:
    data = workbook(
        A=[TITLE, ("X001", "Start", 0, "No", "green"), ("X002", "Stop")],
        B=[TITLE, ("X001", "Begin", 1, "Yes", "red"), ("Y001", "stop"), ("X002", "Stop")],
    )
    assert said(data) == [
        "CG602 B!B2 the nickname of X001 is Begin here and Start in A!B2 (A!B2)",
        "CG602 B!C2 the initial value of X001 is 1 here and 0 in A!C2 (A!C2)",
        "CG602 B!D2 the retentive setting of X001 is Yes here and No in A!D2 (A!D2)",
        "CG602 B!E2 the comment of X001 is red here and green in A!E2 (A!E2)",
        "CG602 B!B3 the nickname stop of Y001 already belongs to X002 in A!B3, there spelled Stop (A!B3)",
    ]


# -- size -------------------------------------------------------------------------------------------------------------


def large(count: int) -> bytes:
    rows = [
        (str(Address(bank.name, number)), f"{bank.name} name {number}", None, None, f"what {number} is for")
        for bank in BANKS.values()
        if not bank.settings_fixed
        for number in bank.numbers()
    ]
    return listed(*rows[:count])


def test_a_large_list_reads_in_linear_time() -> None:
    assert len(rows_of(large(5_000))) == 5_000
    small, great = (calls_in(partial(rows_of, large(count))) for count in (200, 800))
    assert great < 4.5 * small


# -- hostile and broken files -----------------------------------------------------------------------------------------

SHEET, STRINGS = "xl/worksheets/sheet1.xml", "xl/sharedStrings.xml"
MAIN = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'


def repacked(data: bytes, parts: dict[str, str | bytes | None], **how: Any) -> bytes:
    """A workbook with these parts instead of its own, or without those that are None."""
    file = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as new:
        for name in dict.fromkeys((*old.namelist(), *parts)):
            part = parts.get(name, old.read(name) if name in old.namelist() else None)
            if part is not None:
                new.writestr(name, part, **how)
    return file.getvalue()


def with_sheet(content: str) -> bytes:
    """A workbook whose sheet has the usual titles and then these rows, as XML."""
    titles = "".join(f'<c t="inlineStr"><is><t>{title}</t></is></c>' for title in TITLE)
    xml = f'<worksheet {MAIN}><sheetData><row r="1">{titles}</row>{content}</sheetData></worksheet>'
    return repacked(listed(), {SHEET: xml})


START = '<row r="2"><c r="A2" t="inlineStr"><is><t>X001</t></is></c><c r="B2" t="inlineStr"><is><t>S</t></is></c></row>'
"""A row that gives X001 the name S."""


def test_openpyxl_reads_xml_with_defusedxml() -> None:
    assert openpyxl.DEFUSEDXML


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "it is empty"),
        (b"Address,Data Type,Nickname\n", "is no workbook"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + b"\0" * 600, "protected by a password, or an old .xls"),
        (b"PK", "is no sound workbook"),
        (b"PK\x03\x04" + b"\0" * 200, "is no sound workbook"),
        (listed(("X001", "S"))[:3000], "is no sound workbook"),
        (b"\0" * (32 * 2**20 + 1), "has more than 32 MB"),
    ],
)
def test_other_files(data: bytes, why: str) -> None:
    assert why in unreadable(data)


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("mimetype", "OpenDocument spreadsheet (.ods)"),
        ("xl/workbook.bin", "binary workbook (.xlsb)"),
        ("readme.txt", "zip archive and no workbook"),
        ("[Content_Types].xml", "is no sound workbook"),
    ],
)
def test_other_archives(name: str, why: str) -> None:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr(name, "<Types xmlns='http://schemas.openxmlformats.org/package/2006/content-types'/>")
    assert why in unreadable(file.getvalue())


@pytest.mark.parametrize("name", ["[Content_Types].xml", "xl/workbook.xml", "xl/_rels/workbook.xml.rels", SHEET])
@pytest.mark.parametrize("part", [None, "", "<", "<a/>", b"\xff\xfe<\0", "<a>&b;</a>", "\x01"], ids=repr)
def test_a_part_that_is_missing_or_wrong(name: str, part: str | bytes | None) -> None:
    unreadable(repacked(listed(("X001", "S")), {name: part}))


@pytest.mark.parametrize("kind", ["<!DOCTYPE a [{}]>", "<!-- {} -->", "<?a {}?>"])
@pytest.mark.parametrize("name", [STRINGS, SHEET, "xl/workbook.xml", "xl/styles.xml", "[Content_Types].xml"])
def test_entities_never_expand(name: str, kind: str) -> None:
    entities = '<!ENTITY a0 "haha">' + "".join(
        f'<!ENTITY a{n + 1} "{f"&a{n};" * 10}">' for n in range(10)
    )  # fmt: skip
    xml = '<?xml version="1.0"?>' + kind.format(entities) + f"<sst {MAIN}><si><t>&a9;</t></si></sst>"
    assert f"{name}, what no spreadsheet program writes" in unreadable(repacked(listed(), {name: xml}))


def test_a_zip_bomb() -> None:
    bomb = repacked(listed(("X001", "S")), {SHEET: b" " * (150 * 2**20)})
    assert len(bomb) < 2**20
    tracemalloc.start()
    try:
        assert "unpacks to more than 64 MB" in unreadable(bomb)
        assert tracemalloc.get_traced_memory()[1] < 150 * 2**20
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    "name", ["xl/media/image1.xml", "xl/calcChain.xml", "xl/comments12.xml", "xl/worksheets/_rels/sheet1.xml.rels"]
)
def test_what_holds_no_cells_is_never_unpacked(name: str) -> None:
    assert len(rows_of(repacked(listed(("X001", "S")), {name: b"<" * (65 * 2**20)}))) == 1


def test_an_archive_that_lies_about_the_size_of_a_part() -> None:
    data = bytearray(repacked(listed(("X001", "S")), {"xl/worksheets/more.xml": b"<" * (65 * 2**20)}))
    at = data.rindex(b"PK\x01\x02", 0, data.rindex(b"xl/worksheets/more.xml"))
    data[at + 24 : at + 28] = (100).to_bytes(4, "little")
    unreadable(bytes(data))


@pytest.mark.parametrize(
    "content",
    [
        '<row r="2">' + '<c s="0"/>' * 200_000 + "</row>",
        '<row r="2">' + '<c s="0"/>' * 16_384 + "</row>" + '<row><c s="0"/></row>' * 60_000,
        "<a/>" * 200_000,
        "<a>" * 200_000 + "</a>" * 200_000,
        '</sheetData><mergeCells>' + '<mergeCell ref="A1:XFD1048576"/>' * 200_000 + "</mergeCells><sheetData>",
    ],
    ids=["a wide row", "many rows", "other elements", "nested", "merged"],
)  # fmt: skip
def test_far_too_many_cells(content: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "ELEMENTS_MAX", 120_000)
    assert "far too many cells" in unreadable(with_sheet(content))


@pytest.mark.parametrize("width", [1, 25])
@pytest.mark.parametrize("empty", ["/>", "></c>"])
def test_a_million_cells_that_are_only_formatted_cost_little(
    width: int, empty: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A tenth of a million, and a tenth of what is allowed."""
    monkeypatch.setattr(limits, "ELEMENTS_MAX", limits.ELEMENTS_MAX // 10)
    rows = "".join(
        f'<row r="{number}" ht="15" s="1">'
        + "".join(f'<c r="{chr(65 + column)}{number}" s="1"{empty}' for column in range(width))
        + "</row>"
        for number in range(3, 100_000 // width + 3)
    )
    titles = "".join(
        f'<c r="{chr(65 + n)}1" t="inlineStr"><is><t>{title}</t></is></c>' for n, title in enumerate(TITLE)
    )
    xml = f'<worksheet {MAIN}><sheetData><row r="1">{titles}</row>{START}{rows}</sheetData></worksheet>'
    assert [row.nickname for row in little(lambda: rows_of(repacked(listed(), {SHEET: xml})), 400_000)] == ["S"]


def test_blank_cells_that_do_not_say_where_they_stand_keep_their_place() -> None:
    assert [
        in_words(row)
        for row in rows_of(with_sheet(START.replace("</row>", "<c s='1'/><c/><c t='str'><v>c</v></c></row>")))
    ] == ["X001 S|0|No|c IO!A2"]


def test_a_pipe_and_a_device(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "io.xlsx")
    (tmp_path / "zero.xlsx").symlink_to("/dev/zero")
    for name in ("io.xlsx", "zero.xlsx"):
        with pytest.raises(TableUnreadable, match=f"{name} is a pipe or a device; name a file"):
            read_workbook(tmp_path / name, name, Diagnostics())


def test_one_endless_tag() -> None:
    assert "endless tags" in unreadable(with_sheet('<row a="' + "x>" * 10_000_000 + '"/>'))


def test_huge_dimensions_and_far_cells() -> None:
    far = '<row r="1048576"><c r="XFD1048576"><v>1</v></c></row>'
    xml = with_sheet(START + '<row r="3">' + '<c s="0"/>' * 16_384 + "</row>" + far)
    assert [row.nickname for row in little(lambda: rows_of(xml))] == ["S"]
    with zipfile.ZipFile(io.BytesIO(xml)) as archive:
        sheet = archive.read(SHEET).decode()
    sheet = sheet.replace("<sheetData>", '<dimension ref="A1:XFD1048576"/><sheetData>')
    assert [row.nickname for row in rows_of(repacked(xml, {SHEET: sheet}))] == ["S"]
    # A size that is too small hides nothing either.
    for size in ("A1", "C5:D9"):
        assert len(rows_of(repacked(xml, {SHEET: sheet.replace("A1:XFD1048576", size)}))) == 1
    endless = with_sheet(START + '<row r="99999999999"><c><v>1</v></c></row>')
    assert len(rows_of(endless)) == 1


def test_a_hundred_sheets_that_share_one_large_part(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "ELEMENTS_MAX", limits.ELEMENTS_MAX // 10)
    data = workbook(**{f"S{number}": [("nothing",)] for number in range(90)})
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        rels = archive.read("xl/_rels/workbook.xml.rels").decode()
    rels = re.sub(r"/xl/worksheets/sheet\d+\.xml", "/" + SHEET, rels)
    large = with_sheet(START + '<row><c s="0"/></row>' * 10_000)
    with zipfile.ZipFile(io.BytesIO(large)) as archive:
        data = repacked(data, {SHEET: archive.read(SHEET), "xl/_rels/workbook.xml.rels": rels})
    assert "far too many cells" in unreadable(data)


def test_a_huge_sheet_without_a_list_does_no_harm(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "ELEMENTS_MAX", limits.ELEMENTS_MAX // 10)
    log = "".join(f'<row r="{number}"><c><v>{number}</v></c></row>' for number in range(1, 40_000))
    data = workbook(Log=[("Time",)], IO=[TITLE, ("X001", "S")])
    data = repacked(data, {SHEET: f'<worksheet {MAIN}><dimension ref="A1"/><sheetData>{log}</sheetData></worksheet>'})
    assert len(little(lambda: rows_of(data), 400_000)) == 1


def test_too_many_sheets() -> None:
    assert "has 101 sheets" in unreadable(workbook(**{f"S{number}": [("a",)] for number in range(101)}))


def test_an_archive_in_another_packing_and_one_with_a_part_twice() -> None:
    assert "packed in a way of their own" in unreadable(repacked(listed(), {}, compress_type=zipfile.ZIP_LZMA))
    file = io.BytesIO(listed(("X001", "S")))
    with warnings.catch_warnings(), zipfile.ZipFile(file, "a") as archive:
        warnings.simplefilter("ignore")
        archive.writestr(SHEET, "<worksheet/>")
    assert "no spreadsheet program writes" in unreadable(file.getvalue())


def test_rows_out_of_order_are_not_left_out_silently() -> None:
    assert "rows are out of order" in unreadable(with_sheet('<row r="3"><c><v>1</v></c></row>' + START))


def test_a_strict_workbook() -> None:
    sheet = '<worksheet xmlns="http://purl.oclc.org/ooxml/spreadsheetml/main"/>'
    assert "is a Strict Open XML workbook" in unreadable(repacked(listed(), {SHEET: sheet}))


def test_shared_texts_formatted_in_parts() -> None:
    kind = "application/vnd.openxmlformats-officedocument.spreadsheetml.sharedStrings+xml"
    data = with_sheet('<row r="2"><c t="s"><v>1</v></c><c t="s"><v>0</v></c><c t="str"><v>1</v></c></row>')
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        types = archive.read("[Content_Types].xml").decode()
    types = types.replace("</Types>", f'<Override PartName="/{STRINGS}" ContentType="{kind}"/></Types>')
    rich = "<si><r><rPr><b/></rPr><t>St</t></r><r><t>art</t></r></si>"
    texts = f"<sst {MAIN}>{rich}<si><t>X001</t></si></sst>"
    assert [in_words(row) for row in rows_of(repacked(data, {STRINGS: texts, "[Content_Types].xml": types}))] == [
        "X001 Start|1|No| IO!A2"
    ]


@pytest.mark.parametrize(
    "cell",
    [
        '<c r="B2" t="s"><v>99</v></c>',
        '<c r="B2" t="s"><v>x</v></c>',
        '<c r="B2"><v>1e</v></c>',
        '<c r="B2" t="b"><v>maybe</v></c>',
        '<c r="B2" t="d"><v>never</v></c>',
        '<c r="??"><v>1</v></c>',
        '<c r="B2" s="x"><v>1</v></c>',
        f'<c r="B2"><v>{"1" * 5000}</v></c>',
    ],
)
def test_cells_of_wrong_types(cell: str) -> None:
    assert "is no sound workbook" in unreadable(with_sheet(f'<row r="2">{cell}</row>'))


def test_odd_cells_that_can_be_read() -> None:
    infinite = '<row r="3"><c t="inlineStr"><is><t>C1</t></is></c><c><v>1e999</v></c></row>'
    nameless = '<row r="4"><c/><c t="zz"><v>5</v></c></row>'
    assert said(with_sheet(START + infinite + nameless)) == [
        "CG604 IO!B4 5 has no address and is left out",
        "CG601 IO!B3 the nickname in IO!B3 is no number",
    ]


def survives(data: bytes) -> None:
    def read() -> None:
        with contextlib.suppress(TableUnreadable):
            read_workbook(Path("nowhere.xlsx"), "io.xlsx", Diagnostics(), data)

    little(read)


def broken_by(chance: random.Random, data: bytes) -> bytes:
    changed = bytearray(data)
    start = chance.randrange(len(data))
    how = chance.randrange(4)
    if how == 0:
        return data[:start]
    if how == 1:
        del changed[start : start + chance.randrange(1, 50)]
    else:
        for _ in range(how):
            changed[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    return bytes(changed)


@pytest.mark.property
@pytest.mark.parametrize("packed", [True, False])
def test_no_broken_file_brings_it_down(packed: bool) -> None:
    """Unpacked, the damage is in the XML itself, since its checksums are made anew."""
    chance = random.Random(4711)
    whole = listed(("X001", "Start", 0, "No", "c"), ("DS1", "Speed", 5, True, datetime.date(2024, 1, 1)), ("=A1", "B"))
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    for _ in budget.rounds(40):
        if packed:
            survives(broken_by(chance, whole))
        else:
            name = chance.choice(list(parts))
            survives(repacked(whole, {name: broken_by(chance, parts[name])}))


@given(st.binary(max_size=300))
def test_no_content_is_too_strange(content: bytes) -> None:
    for data in (content, b"PK\x03\x04" + content):
        with pytest.raises(TableUnreadable):
            judged(data)


WORDS = (
    "X001",
    "x 2",
    "DS1",
    "C1",
    "DH1",
    "TXT1",
    "XD1",
    "Start",
    "Stop",
    "yes",
    "0",
    "1",
    "00FFh",
    "-",
    " ",
    "=A1",
    "\u00e4",
)
CELLS = st.none() | st.booleans() | st.integers() | st.floats() | st.sampled_from([*WORDS, *TITLE])


@given(st.lists(st.lists(CELLS, max_size=6), max_size=8))
@examples(20)
def test_no_list_is_too_strange(lines: list[list[Any]]) -> None:
    rows, problems = judged(listed(*lines))
    assert len({row.address for row in rows}) == len(rows)
    names = [row.nickname.lower() for row in rows if row.nickname and row.address.bank not in ("SC", "SD")]
    assert len(set(names)) == len(names) or any(problem.code == "CG602" for problem in problems)
    assert all(row.cell and row.cell.sheet == "IO" for row in rows)


def test_what_is_read_again_is_the_same() -> None:
    """A sheet with all columns, and another that repeats part of it, give the same rows."""
    rows = [
        Row(at("X001"), "Start", "0", False, "a, b"),
        Row(at("DF1"), "Speed", "-3.4028235E+38", True, "two\nlines"),
        Row(at("DH1"), "Mask", "00FF", False, ""),
        Row(at("C2"), "", "1", True, ""),
        Row(at("TXT1"), "", " ", True, " "),
        default_row(at("DS9"), "Nine"),
    ]
    word = {True: "Yes", False: "No"}
    data = workbook(
        Tags=[
            ("Address", "Data type", "Nickname", "Initial value", "Retentive", "Comment"),
            *(
                (str(r.address), r.address.kind.value, r.nickname, r.initial, word[r.retentive], r.comment)
                for r in rows
            ),
        ],
        Slot=[("Address", "Nickname"), *((str(row.address), row.nickname) for row in rows)],
    )
    assert [row.content for row in rows_of(data)] == [row.content for row in rows]


# -- several addresses in a cell, and errors ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "X001-X003",
        "X001 - X003",
        "X1 \N{EN DASH} X3",
        "X1..X3",
        "X1...3",
        "X1-3",
        "X001, X002",
        "X1/X2",
        "X1 to X3",
        "X1:X3",
    ],
)
@pytest.mark.parametrize("name", ["Doors", "SPARE", None])
def test_a_cell_with_several_addresses_says_to_write_rows(text: str, name: str | None) -> None:
    (problem,) = judged(listed((text, name), ("Y001", "Motor")))[1]
    assert problem.code == "CG601"
    assert "are several addresses, and a row of a list is one" in problem.message
    assert problem.help.startswith("write a row for each of them")


@pytest.mark.parametrize("value", ["#N/A", "=NA()", "= na( )"])
def test_an_error_value_is_named(value: str) -> None:
    (problem,) = [each for each in judged(listed(("X001", value), ("Y001", "Motor")))[1] if each.code == "CG601"]
    assert "is an error, #N/A" in problem.message
    assert "SPARE" in problem.help
