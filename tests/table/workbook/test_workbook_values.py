"""An I/O list that a person made: addresses, names and values are read only if they are clear."""

from __future__ import annotations

import datetime

import pytest
from io_lists import TITLE, at, in_words, judged, listed, rows_of, said, workbook
from openpyxl.worksheet.worksheet import Worksheet

# -- addresses and names -----------------------------------------------------------------------------------------------


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


# -- values ------------------------------------------------------------------------------------------------------------


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


# -- what is said twice ------------------------------------------------------------------------------------------------


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
