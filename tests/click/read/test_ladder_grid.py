"""Ladder files as laddercodec reads them; damage with file, row and reason; power through any drawing at all."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Mapping
from pathlib import Path

import laddercodec
import pytest
from budget import examples
from hypothesis import example, given, note
from hypothesis import strategies as st
from judges.power import HEADER, flow, leaf_of, situations
from test_importing_cases import CASE_NAMES, golden_ladders, ladder_text, wired

from clickgen.click.draw.tokens import contact_token
from clickgen.click.read.grid import DrawnRung, decode_ladder, read_ladder
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.rungs import ImportedRung, import_rung
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.program import Action, Branch, Item

OUT = wired("X001", "out(C1)", "R")


def problems(text: str) -> list[tuple[int, str]]:
    return [(problem.row, problem.message) for problem in read_ladder(text, "main.csv").all_problems]


def rung(*rows: list[str]) -> DrawnRung:
    ladder = read_ladder(ladder_text(rows), "main.csv")
    assert not ladder.all_problems
    [only] = ladder.rungs
    return only


# -- what is read -----------------------------------------------------------------------------------------------------


def test_comments_markers_and_empty_lines_are_read() -> None:
    text = ladder_text([["#", "Two lines,"], ["#", '  "indented"'], wired("X001", "out(C1)", "R17")])
    text = (
        "\ufeff" + text.replace("\n", "\r\n\r\n", 1) + ladder_text([wired("~X002", "out(C2)", "R")]).split("\n", 1)[1]
    )
    ladder = read_ladder(text, "main.csv")
    assert not ladder.all_problems
    assert [one.comment for one in ladder.rungs] == ['Two lines,\n  "indented"', ""]
    assert [one.number for one in ladder.rungs] == [1, 2]
    assert [one.line for one in ladder.rungs] == [5, 6]


def test_a_comment_may_be_a_cell_of_several_lines() -> None:
    assert rung(["#", "one\r\n\ttwo"], OUT).comment == "one\n\ttwo"


def test_pins_belong_to_the_box_above() -> None:
    box = rung(
        wired("X001", "count_up(CT1,CTD1,preset=5)", "R"), wired("X002", ".down()"), wired("X003", ".reset()")
    ).boxes[0]
    assert box.pins == ((".down()", 1), (".reset()", 2))


def test_a_rung_of_all_rows_is_read() -> None:
    rows = [wired(f"C{number + 1}", f"out(C{number + 101})", "" if number else "R") for number in range(32)]
    assert len(rung(*rows).boxes) == 32
    assert problems(ladder_text([*rows, wired("C99", "out(C99)")])) == [
        (2, "the rung has 33 rows with its boxes at their full height, and CLICK 32")
    ]


def test_tall_boxes_count_at_their_full_height() -> None:
    rows = [wired(f"C{number + 1}", f"copy({number},DS1)", "" if number else "R") for number in range(17)]
    rung(*rows[:16])
    assert problems(ladder_text(rows))[0][1].startswith("the rung has 34 rows")


@pytest.mark.parametrize("name", CASE_NAMES)
def test_laddercodec_sees_the_same_rungs(name: str) -> None:
    for file, text in golden_ladders(name).items():
        ours = read_ladder(text, file).rungs
        theirs = codec_rungs(text)
        assert [one.comment for one in ours] == [one.comment or "" for one in theirs]
        assert [len(one.boxes) for one in ours] == [_outputs(one) for one in theirs]


def codec_rungs(text: str) -> list[laddercodec.Rung]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "main.csv"
        path.write_text(text, encoding="utf-8", newline="")
        found: list[laddercodec.Rung] = laddercodec.read_csv(path)
        return found


def _outputs(theirs: laddercodec.Rung) -> int:
    """The instructions of a rung; the NOP beside a down counter is part of it."""
    shown = [one for one in theirs.instructions if one != ""]
    covered = [one for one in shown if getattr(one, "counter_type", "") == "count_down"]
    return len(shown) - len(covered)


# -- damage -----------------------------------------------------------------------------------------------------------

HEAD = ",".join(HEADER)
ROW = ",".join(OUT)
DAMAGED: dict[str, tuple[str, int, str]] = {
    "nothing": ("", 1, "the file is empty"),
    "another header": (f"Address,Nickname\n{ROW}\n", 1, "the header of a ladder file is marker,A,...,AF"),
    "too few columns": (f"{HEAD}\n{ROW}\nR,X001,-\n", 3, "the line has 3 columns, not 33: is it cut off?"),
    "too many columns": (f"{HEAD}\n{ROW},,\n", 2, "the line has 35 columns, not 33"),
    "an unknown square": (
        f"{HEAD}\n{ROW.replace('X001', 'X017')}\n",
        2,
        "column A holds 'X017', and CLICK has no X017",
    ),
    "a quote that is not closed": (
        f'{HEAD}\n{ROW}\nR,"X001,-\n',
        3,
        "the quotes of this line do not fit, or the file is cut off here (unexpected end of data)",
    ),
    "a quote inside": (
        f'{HEAD}\n{ROW}\nR,"X0"01,-\n',
        3,
        "the quotes of this line do not fit, or the file is cut off here (',' expected after '\"')",
    ),
    "a line break in a cell": (f'{HEAD}\n"R\n",X001\n', 2, "the line has 2 columns, not 33: is it cut off?"),
    "a line break in an output": (
        HEAD + "\n" + ROW.replace("out(C1)", '"out(\nC1)"') + "\n",
        2,
        "a cell holds a line break: is a quote missing?",
    ),
    "an unknown marker": (f"{HEAD}\n{ROW}\nQ{ROW[1:]}\n", 3, "the line begins with 'Q', not with R, # or nothing"),
    "a row before the first rung": (f"{HEAD}\n{ROW[1:]}\n{ROW}\n", 2, "this line belongs to no rung: no R above it"),
    "a row behind a comment": (
        f"{HEAD}\n{ROW}\n#,a\n{ROW[1:]}\n{ROW}\n",
        4,
        "this line belongs to no rung: no R above it",
    ),
    "a comment at the end": (f"{HEAD}\n{ROW}\n#,a\n#,b\n", 3, "a comment at the end belongs to no rung"),
    "text beside a comment": (f"{HEAD}\n#,a,b\n{ROW}\n", 2, "a comment has text outside column A"),
    "a wire down at the rail": (
        f"{HEAD}\n{ROW.replace('X001', 'T')}\n{ROW[1:]}\n",
        2,
        "T in column A: there the power rail joins the rows",
    ),
    "a wire down from the last row": (
        f"{HEAD}\n{ROW.replace('X001,-', 'X001,T')}\n",
        2,
        "a wire leads down from the last row of the rung",
    ),
    "a pin without a box": (
        f"{HEAD}\n{ROW.replace('out(C1)', '.reset()')}\n",
        2,
        ".reset() is not directly below its instruction",
    ),
    "a pin of another box": (
        f"{HEAD}\n{ROW}\n{ROW[1:].replace('out(C1)', '.clock()')}\n",
        3,
        "out has no .clock() here",
    ),
    "something like a pin": (f"{HEAD}\n{ROW}\n{ROW[1:].replace('out(C1)', '.reset')}\n", 3, "'.reset' is no pin"),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_damage_is_told_with_row_and_reason(name: str) -> None:
    text, row, message = DAMAGED[name]
    assert (row, message) in problems(text)
    assert str(LadderProblem(message, "main.csv", row)) == f"main.csv:{row}: {message}"


def test_bytes_that_are_no_text_are_told() -> None:
    assert decode_ladder(b"\xef\xbb\xbfmarker", "main.csv") == "marker"
    with pytest.raises(LadderProblem) as caught:
        decode_ladder(b"marker\nR,\xff", "main.csv")
    assert (caught.value.row, caught.value.message) == (2, "the file is not UTF-8 text: byte 0xFF")


CHARACTERS = st.sampled_from(',"\n\r#RT-|:X~C().=15 \0é')


@given(
    st.sampled_from(("demo", "pin_conditions", "event_drum", "comments", "send")),
    st.integers(0, 10**6),
    st.integers(0, 40),
    st.text(CHARACTERS, max_size=3),
    st.booleans(),
)
@examples(80)
def test_a_damaged_file_is_read_or_refused(name: str, at: int, length: int, put: str, cut: bool) -> None:
    """The only exception is a LadderProblem in an existing row; laddercodec reads whatever is read here."""
    text = next(iter(golden_ladders(name).values()))
    at %= len(text)
    damaged = text[:at] + put + ("" if cut else text[at + length :])
    ladder = read_ladder(damaged, "main.csv")
    rows = damaged.count("\n") + damaged.count("\r") + 1
    found = list(ladder.all_problems)
    for one in ladder.rungs:
        try:
            import_rung(one)
        except LadderProblem as problem:
            found.append(problem)
    assert all(1 <= problem.row <= rows and problem.file == "main.csv" and problem.message for problem in found)
    if not found:
        assert len(codec_rungs(damaged)) == len(ladder.rungs)


# -- any drawing ------------------------------------------------------------------------------------------------------

SQUARES = ("C1", "~C1", "C2", "T:C2", "C3", "T:~C3", "C4", "T:C5", "-", "-", "T", "T", "|", "")
WIDTH = 5


@st.composite
def drawings(draw: st.DrawFn) -> list[list[str]]:
    """Rows of any squares, each with or without an output; no wire down at the rail or from the last row."""
    count = draw(st.integers(1, 5))
    rows: list[list[str]] = []
    for number in range(count):
        cells = [draw(st.sampled_from(SQUARES)) for _ in range(WIDTH)]
        cells[0] = {"T": "-", "|": ""}.get(cells[0], cells[0]).removeprefix("T:")
        if number + 1 == count:
            cells = [{"T": "-", "|": ""}.get(cell, cell).removeprefix("T:") for cell in cells]
        output = f"out(C{100 + number})" if draw(st.booleans()) else ""
        rest = ["-" if output else ""] * (31 - WIDTH)
        rows.append(["" if number else "R", *cells, *rest, output])
    return rows


@given(drawings())
@examples(100)
def test_wires_are_led_on_as_laddercodec_does(rows: list[list[str]]) -> None:
    [theirs] = codec_rungs(ladder_text(rows))
    ours = read_ladder(ladder_text(rows), "main.csv").rungs[0]
    seen = [[(square.right, square.down) for square in row.squares] for row in ours.rows]
    assert seen == [[_carries(token) for token in row] for row in theirs.conditions]


def _carries(token: object) -> tuple[bool, bool]:
    is_down = token in ("T", "|") or getattr(token, "wire_down", False) is True
    return token not in ("", "|"), is_down


@given(drawings())
@example(
    [
        ["R", "-", "-", "|", "", "", *[""] * 26, ""],
        ["", "C1", "T", "C1", "C1", "C1", *["-"] * 26, "out(C101)"],
        ["", "C1", "~C1", "~C1", "|", "", *[""] * 26, ""],
        ["", "C1", "C1", "C1", "~C1", "~C1", *["-"] * 26, "out(C103)"],
    ]
)
@examples(150)
def test_power_is_that_of_the_drawing(rows: list[list[str]]) -> None:
    """Power goes to the right through contacts and wires, and both ways along a downward wire."""
    drawn, found = _imported_without_loose_ends(rows)
    cells = [_cells(row) for row in drawn.rows]
    note("\n".join(",".join(row[: WIDTH + 1]) for row in cells))
    sets, full = situations([f"C{number}" for number in range(1, 6)])

    def mask(token: str) -> int:
        leaf, negated = leaf_of(token)
        return full & ~sets[leaf] if negated else sets[leaf]

    level = flow(cells, mask, full)
    wanted = [level[box.row][-1] for box in drawn.boxes]
    solved = _solved(found.rung.condition, sets, full)
    if drawn.boxes:
        assert list(_powers(found.rung.items, solved, sets, full)) == wanted


def _imported_without_loose_ends(rows: list[list[str]]) -> tuple[DrawnRung, ImportedRung]:
    """The rung without the contacts and outputs that would make the import refuse it."""
    rows = [list(row) for row in rows]
    while True:
        [drawn] = read_ladder(ladder_text(rows), "main.csv").rungs
        try:
            return drawn, import_rung(drawn)
        except LadderProblem as problem:
            place = re.search(r"in row (\d+), column (\w)", problem.message)
            if place:
                row, column = int(place[1]) - 1, ord(place[2]) - ord("A") + 1
                rows[row][column] = "|" if rows[row][column].startswith("T:") else ""
            else:
                rows[problem.row - 2][-1] = ""


def _cells(row: object) -> list[str]:
    squares = getattr(row, "squares", ())
    shown: list[str] = []
    for square in squares:
        contact = contact_token(square.contact) if square.contact else "-" if square.right else ""
        down = {"": "|", "-": "T"}.get(contact, f"T:{contact}")
        shown.append(down if square.down else contact)
    return shown


def _solved(condition: Condition, sets: Mapping[str, int], full: int) -> int:
    if isinstance(condition, Always):
        return full
    if isinstance(condition, All | Any):
        value = full if isinstance(condition, All) else 0
        for term in condition.terms:
            one = _solved(term, sets, full)
            value = value & one if isinstance(condition, All) else value | one
        return value
    assert isinstance(condition, Contact)
    assert not isinstance(condition, Compare)
    leaf, negated = leaf_of(contact_token(condition))
    return full & ~sets[leaf] if negated else sets[leaf]


def _powers(items: tuple[Item, ...], enable: int, sets: Mapping[str, int], full: int) -> list[int]:
    found: list[int] = []
    for item in items:
        if isinstance(item, Branch):
            found += _powers(item.items, enable & _solved(item.condition, sets, full), sets, full)
        else:
            assert isinstance(item, Action)
            found.append(enable)
    return found
