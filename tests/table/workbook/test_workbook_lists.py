"""An I/O list that a person made: which rows are its, and which are spare points."""

from __future__ import annotations

import io
from pathlib import Path

import openpyxl
import pytest
from io_lists import in_words, judged, listed, rows_of, said, saved, unreadable, workbook
from openpyxl.worksheet.worksheet import Worksheet

from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.read import TableUnreadable
from clickgen.table.workbook.read import read_workbook
from clickgen.table.workbook.titles import TITLES, Field

# -- lists -------------------------------------------------------------------------------------------------------------


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
    """The internal one counts; if there is none, the external one."""
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


# -- spare points ------------------------------------------------------------------------------------------------------


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
