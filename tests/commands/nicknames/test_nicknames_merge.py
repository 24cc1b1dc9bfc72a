"""Merging an export: differences are reported, and those that were asked for are taken."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import pytest
from judges.work import calls_in
from merging import ALL, read, read_table_with_faults, row, rows, table

from clickgen.commands.nicknames.changed_rows import conflict_lines, diff_lines, summary
from clickgen.commands.nicknames.merge import Merge, merge
from clickgen.commands.nicknames.uses import ProgramsSay, places_in, read_names
from clickgen.device.banks import Address
from clickgen.dialects.if_rungs.read.parse import decode
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import HEADER, Row
from clickgen.text.source import Span


def merged(before: list[str], after: list[str], used: Callable[[str], list[str]] | None = None) -> Merge:
    return merge(table(*before), table(*after), used)


# -- what differs ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("before", "after", "lines"),
    [
        ([], ["C17 PumpRun"], ["+ C17 PumpRun"]),
        (["DS9 Old"], [], ["- DS9 Old"]),
        (["C5 Motor"], ["C5 Motor1"], ["~ C5 Motor -> Motor1 (renamed)"]),
        (["C5 motor"], ["C5 Motor"], ["~ C5 motor -> Motor (renamed, in capital letters only)"]),
        (["DS5 Level"], ["DS9 Level"], ["> Level DS5 -> DS9 (moved)"]),
        (["DS5 Level"], ["DS9 level"], ["> Level DS5 -> DS9 (moved, now level)"]),
        (["DS5 Level"], ["DS5 Level 10"], ["~ DS5 Level: initial 0 -> 10"]),
        (["DS5 Level"], ["DS5 Level 0 No new"], ['~ DS5 Level: retentive Yes -> No, comment "" -> "new"']),
        (["TXT5 Unit A"], ["TXT5 Unit"], ["~ TXT5 Unit: initial A -> nothing"]),
        (["DS5 Level"], ["DS5 Fill 10"], ["~ DS5 Level -> Fill (renamed)", "~ DS5 Level: initial 0 -> 10"]),
        ([], ["DS5 - 10"], ["+ DS5 without a name"]),
        (["DS5 - 10"], [], ["- DS5 without a name"]),
        (["DS5 - 10"], ["DS5 - 11"], ["~ DS5 without a name: initial 10 -> 11"]),
        (["DS5 - 10"], ["DS5 Level 10"], ["+ DS5 Level"]),
        (["DS5 - 10"], ["DS5 Level 11"], ["+ DS5 Level", "~ DS5 without a name: initial 10 -> 11"]),
        (["DS5 Level 10"], ["DS5 - 10"], ["- DS5 Level"]),
        # Two that change places, and one that takes the place of another that takes a third.
        (
            ["C1 A", "C2 B"],
            ["C1 B", "C2 A"],
            ["~ C1 A -> B (renamed; B was C2)", "~ C2 B -> A (renamed; A was C1)"],
        ),
        (["C1 A", "C2 B"], ["C1 B", "C2 C"], ["~ C1 A -> B (renamed; B was C2)", "~ C2 B -> C (renamed)"]),
        # A name that comes where another was, or leaves where another comes.
        (["C1 A", "C2 B"], ["C2 A"], ["> A C1 -> C2 (moved)", "- C2 B"]),
        (["C1 A"], ["C1 New", "C2 A"], ["+ C1 New", "> A C1 -> C2 (moved)"]),
        (["C1 A", "C2 B"], ["C2 A", "C3 B"], ["> A C1 -> C2 (moved)", "> B C2 -> C3 (moved)"]),
    ],
)
def test_what_differs(before: list[str], after: list[str], lines: list[str]) -> None:
    found = merged(before, after)
    assert diff_lines(found) == lines
    everything = found.taken(ALL)
    assert sorted(rows(everything)) == sorted(rows(found.export))
    assert merge(everything, found.export).changes == ()
    assert found.conflicts(ALL) == ()


def test_nothing_differs() -> None:
    found = merged(["C1 A", "DS1 B 1"], ["DS1 B 1", "C1 A", "C9 -"])
    assert (found.changes, diff_lines(found), summary(found)) == ((), [], "nothing differs")
    assert found.taken(ALL) is found.table
    # However a value is written, and whatever ends the lines of a comment.
    ours = read(
        f'{HEADER}\r\nDF1,FLOAT,A,1.50,Yes,"one\r\ntwo"\r\nDH1,HEX,B,ff,Yes,\r\nDS1,INT,C,007,Yes,\r\n'.encode()
    )
    theirs = read(
        f'{HEADER}\nDF1,FLOAT,"A",1.5,Yes,"one\ntwo"\nDH1,HEX,"B",00FF,Yes,""\nDS1,INT,"C",7,Yes,""\n'.encode()
    )
    assert merge(ours, theirs).changes == ()


def test_the_rows_of_the_system_are_kept_apart() -> None:
    found = merged(["SC1 Mine", "C1 A"], ["SC1 Other", "SC2 More", "SD1 Less", "C1 A", "C2 New"])
    assert diff_lines(found) == ["+ C2 New"]
    assert summary(found) == "1 added; 3 rows of SC and SD kept apart"
    assert rows(found.taken(ALL)) == ["SC1 Mine", "C1 A", "C2 New"]


def test_a_name_of_a_system_row_is_taken() -> None:
    found = merged(["SC5 Blink"], ["C1 blink"])
    assert conflict_lines(found, ALL) == ["! + C1 blink: Blink is SC5 in the table (line 2 of nicknames.csv)"]
    assert found.taken(ALL) is found.table


def test_words_for_input_and_output_are_rows_like_any() -> None:
    assert rows(merged(["XD1 A"], ["XD0 Words", "YD0 Out"]).taken(ALL)) == ["XD0 Words", "YD0 Out"]


def test_what_programs_use_is_marked() -> None:
    places = {"old": ["prog.py:12"], "level": [f"prog.py:{n}" for n in range(1, 6)], "motor": ["a.py:1", "b.py:2"]}
    found = merged(
        ["C1 Old", "C2 Gone", "C5 Motor", "C6 case", "DS5 Level", "DS7 - 10"],
        ["C5 Motor1", "C6 Case", "C9 New", "DS9 Level"],
        lambda name: places.get(name.lower(), []),
    )
    assert diff_lines(found) == [
        "- C1 Old (used at prog.py:12)",
        "- C2 Gone (nothing refers to it)",
        "~ C5 Motor -> Motor1 (renamed; used at a.py:1, b.py:2)",
        "~ C6 case -> Case (renamed, in capital letters only)",
        "+ C9 New",
        "- DS7 without a name",
        "> Level DS5 -> DS9 (moved; used at prog.py:1, prog.py:2, prog.py:3 and 2 more)",
    ]
    assert diff_lines(found, {"added", "moved"})[0] == "+ C9 New"
    assert summary(found) == "1 added, 2 renamed, 1 moved, 3 removed"


# -- what is taken -----------------------------------------------------------------------------------------------------


def test_what_was_not_asked_for_stays() -> None:
    before = ["C1 Old", "C5 Motor", "DS5 Level 1", "DS6 Same"]
    found = merged(before, ["C5 Motor1", "C7 New", "DS9 Level 1", "DS6 Same 0 Yes words"])
    assert rows(found.taken({"added"})) == ["C1 Old", "C5 Motor", "C7 New", "DS5 Level", "DS6 Same"]
    assert rows(found.taken({"renamed"})) == ["C1 Old", "C5 Motor1", "DS5 Level", "DS6 Same"]
    assert rows(found.taken({"moved"})) == ["C1 Old", "C5 Motor", "DS6 Same", "DS9 Level"]
    assert rows(found.taken({"removed"})) == ["C5 Motor", "DS5 Level", "DS6 Same"]
    assert found.taken({"changed"}).by_address[Address("DS", 6)].comment == "words"
    assert found.taken(set()) is found.table


def test_every_other_byte_stays() -> None:
    text = (
        f"\ufeff{HEADER}\r\nDS9,INT,Late,0,Yes,\r\n\r\nC5,BIT,Motor,0,No,kept\r\nDS1,INT,Gone,0,Yes,\r\nC1,BIT,A,0,No,"
    )
    ours = read(text.encode())
    theirs = table("C1 A", "C2 New", "C5 Pump 0 No kept", "DS9 Late")
    assert merge(ours, theirs).taken(ALL).to_bytes().decode() == (
        f'\ufeff{HEADER}\r\nDS9,INT,Late,0,Yes,\r\n\r\nC5,BIT,"Pump",0,No,"kept"\r\nC1,BIT,A,0,No,\r\nC2,BIT,"New",0,No,""'
    )
    last = read(f"{HEADER}\nC1,BIT,A,0,No,\nC2,BIT,B,0,No,".encode())
    assert merge(last, table("C1 A")).taken(ALL).text() == f"{HEADER}\nC1,BIT,A,0,No,"


def test_content_goes_with_its_address() -> None:
    found = merged(["DS5 Level 1"], ["DS5 Fill 2"])
    assert found.taken({"renamed"}).text().splitlines()[1:] == ['DS5,INT,"Fill",1,Yes,""']
    assert found.taken({"changed"}).text().splitlines()[1:] == ['DS5,INT,"Level",2,Yes,""']
    found = merged(["DS5 - 1"], ["DS5 Fill 2"])
    assert found.taken({"added"}).text().splitlines()[1:] == ['DS5,INT,"Fill",1,Yes,""']
    # Where another name comes, nothing of the old row stays.
    found = merged(["C1 A 1", "C2 B 0 Yes old"], ["C2 A 1"])
    assert found.taken({"moved", "removed"}).text().splitlines()[1:] == ['C2,BIT,"A",1,No,""']
    # A row that says nothing does not count.
    found = merged(["DS5 -"], ["DS5 Fill 2"])
    assert found.taken({"added"}).text().splitlines()[1:] == ['DS5,INT,"Fill",2,Yes,""']
    # A name goes and a comment stays.
    found = merged(["C1 A 0 No note"], ["C1 - 0 No note"])
    assert found.taken({"removed"}).text().splitlines()[1:] == ['C1,BIT,"",0,No,"note"']


# -- conflicts ---------------------------------------------------------------------------------------------------------


def test_kinds_that_only_go_together() -> None:
    found = merged(["C1 A", "C2 B"], ["C2 A"])
    assert conflict_lines(found, {"moved"}) == [
        "! > A C1 -> C2 (moved): B is C2 in the table (line 3 of nicknames.csv); --accept moved,removed takes both"
    ]
    assert rows(found.taken({"moved"})) == ["C1 A", "C2 B"]
    assert rows(found.taken({"removed"})) == ["C1 A"]
    assert rows(found.taken({"moved", "removed"})) == ["C2 A"]

    found = merged(["C1 A"], ["C1 New", "C2 A"])
    assert conflict_lines(found, {"added"}) == [
        "! + C1 New: A is C1 in the table (line 2 of nicknames.csv); --accept added,moved takes both"
    ]
    assert rows(found.taken({"moved"})) == ["C2 A"]

    # Through others: the first needs the second's place, which needs the third's.
    found = merged(["C1 A", "C2 B", "C3 C"], ["C2 A", "C3 B"])
    (conflict, other) = found.conflicts({"moved"})
    assert conflict.accept == other.accept == ("moved", "removed")
    assert conflict.change.after is not None
    assert rows(found.taken({"moved"})) == ["C1 A", "C2 B", "C3 C"]


def test_what_clickgen_uses_is_left_alone() -> None:
    scratch = 'C2000,BIT,"Scratch_C2000",0,No,"condition of main rung 12"'
    ours = read(f"{HEADER}\n{scratch}\n".encode())
    for theirs in ([], ["C2000 Scratch_C2000 0 No other"]):
        text = "\n".join([HEADER, *map(row, theirs), ""]).replace("Scratch C2000", "Scratch_C2000")
        assert merge(ours, read(text.encode())).changes == ()
    found = merge(ours, table("C2000 Mine"))
    assert conflict_lines(found, ALL) == [
        "! + C2000 Mine: C2000 is Scratch_C2000, which clickgen uses for itself (line 2 of nicknames.csv): "
        "give Mine another address in CLICK, or delete that row"
    ]
    assert found.taken(ALL) is ours
    # A table that was lost gets them back, so that they keep their addresses.
    assert merge(AddressTable.empty("t"), ours).taken({"added"}).text() == f"{HEADER}\n{scratch}\n"
    assert merge(table("C2000 Mine"), ours).of({"added"}) == ()


def test_a_workbook_is_changed_by_hand() -> None:
    cell = Span.of_cell("plant.xlsx", "IO", 7, 2)
    base = (Row(Address("C", 1), "A", "0", False, "", cell=cell), Row(Address("C", 2), "B", "0", False, "", cell=cell))
    ours = AddressTable("nicknames.csv", table("C3 C")._entries, base=base)
    found = merge(ours, table("C1 A1", "C3 D", "C4 B"))
    reason = "stands in IO!B7 of plant.xlsx, and a workbook is changed by hand"
    assert [(c.change.kind, c.reason, c.accept) for c in found.conflicts(ALL)] == [
        ("renamed", f"C1 {reason}", ()),
        ("moved", f"C2 {reason}", ()),
    ]
    assert rows(found.taken(ALL)) == ["C1 A", "C2 B", "C3 D"]


def test_an_export_that_gives_a_name_twice() -> None:
    theirs = read_table_with_faults(f'{HEADER}\nC1,BIT,"A",0,No,""\nC2,BIT,"a",0,No,""\nC3,BIT,"B",0,No,""\n')
    found = merge(table("C9 Z"), theirs)
    assert conflict_lines(found, {"added"}) == ["! + C2 a: the export gives a to C1 and to C2"]
    assert rows(found.taken(ALL)) == ["C1 A", "C3 B"]


def test_a_shift_of_many_names_is_quick() -> None:
    def shifted(count: int) -> None:
        ours = table(*(f"DS{n} Name{n}" for n in range(1, count + 1)))
        theirs = table(*(f"DS{n + 1} Name{n}" for n in range(1, count + 1)))
        assert merge(ours, theirs).taken({"moved"}).rows[0].address == Address("DS", 2)

    assert calls_in(partial(shifted, 2000)) < 5 * calls_in(partial(shifted, 500))


# -- names in programs ------------------------------------------------------------------------------------------------


def of_programs(before: list[str], after: list[str], text: str) -> Merge:
    source = decode("prog.py", text.encode(), Diagnostics())
    assert source is not None
    names = read_names(source, Diagnostics())
    assert names is not None
    return merge(table(*before), table(*after), places_in([names]), ProgramsSay([names, names]))


DECLARING = """\
nickname(c.Decl, c[7])
nickname(ds.Limit, ds[5], initial=3, retentive=True, comment="rows")
nickname(ds.Recipe, ds[100:110])


def main():
    if c.A:
        copy_fill(0, ds[1:20])
    if x[3]:
        copy(xd[0], dh[1])
    if True:
        end()
"""


@pytest.mark.parametrize(
    ("before", "after", "reason"),
    [
        (["C7 Decl"], ["C8 Decl"], "Decl is C7 by nickname(...) at prog.py:1"),
        ([], ["C8 decl"], "decl is C7 by nickname(...) at prog.py:1"),
        (["C9 Other"], ["C9 Decl"], "Decl is C7 by nickname(...) at prog.py:1"),
        ([], ["C7 Foreign"], "C7 is Decl by nickname(...) at prog.py:1"),
        (["C9 Other"], ["C7 Other"], "C7 is Decl by nickname(...) at prog.py:1"),
        ([], ["DS9 Recipe"], "Recipe is a block by nickname(...) at prog.py:3"),
        (["DS5 Limit 3 Yes rows"], ["DS5 Limit 4 Yes rows"], "gives DS5 its initial: change it there"),
        (["DS5 Limit 3 Yes rows"], ["DS5 Limit 3 No more"], "gives DS5 its retentive and comment: change it there"),
    ],
)
def test_what_a_program_declares_is_changed_there(before: list[str], after: list[str], reason: str) -> None:
    found = of_programs(before, after, DECLARING)
    (conflict,) = found.conflicts(ALL)
    assert reason in conflict.reason
    assert conflict.accept == ()
    assert found.never == (conflict,)
    assert found.taken(ALL).to_bytes() == table(*before).to_bytes()


def test_what_agrees_with_a_declaration_is_taken() -> None:
    for before, after in (
        ([], ["C7 Decl"]),
        (["C7 Decl"], ["C7 DECL"]),
        (["C7 Decl"], ["C7 Motor"]),  # a rename in the programs follows
        (["DS5 Limit 0 No old"], ["DS5 Limit 3 Yes rows"]),
        (["C7 Decl"], ["C7 Decl 1 Yes words"]),
    ):
        assert of_programs(before, after, DECLARING).conflicts(ALL) == ()


def test_a_name_on_a_cell_that_a_program_uses_by_number_is_noted() -> None:
    found = of_programs(["DS30 Gone"], ["DS5 Panel", "DS6 Gone", "DS21 Far", "X002 In"], DECLARING)
    assert diff_lines(found) == [
        "+ X002 In (X002 is used by its number at prog.py:10)",
        "+ DS5 Panel (DS5 is used by its number at prog.py:8)",
        "> Gone DS30 -> DS6 (moved; DS6 is used by its number at prog.py:8)",
        "+ DS21 Far",
    ]


@pytest.mark.parametrize(
    ("before", "after", "used", "lines"),
    [
        (
            ["C1 A", "C2 B"],
            ["C1 B", "C2 A"],
            "A",
            [
                "~ C1 A -> B (swapped; B was C2; programs that say A use C2 then; used at p.py:2)",
                "~ C2 B -> A (swapped; A was C1)",
            ],
        ),
        (
            ["C1 A", "C2 B"],
            ["C1 B", "C2 C"],
            "B",
            [
                "~ C1 A -> B (swapped; B was C2)",
                "~ C2 B -> C (swapped; programs that say B use C1 then; used at p.py:2)",
            ],
        ),
        # A rename in the programs follows if they do not use the name that moves.
        (
            ["C1 A", "C2 B"],
            ["C1 B", "C2 C"],
            "A",
            ["~ C1 A -> B (renamed; B was C2; used at p.py:2)", "~ C2 B -> C (renamed)"],
        ),
        (
            ["C1 A", "C2 B"],
            ["C1 B", "C2 A"],
            "Z",
            ["~ C1 A -> B (renamed; B was C2)", "~ C2 B -> A (renamed; A was C1)"],
        ),
    ],
)
def test_names_that_go_round_and_that_programs_use(
    before: list[str], after: list[str], used: str, lines: list[str]
) -> None:
    found = merged(before, after, lambda name: ["p.py:2"] if name == used else [])
    assert diff_lines(found) == lines
    is_swapped = "swapped" in lines[0]
    assert rows(found.taken(ALL - {"swapped"})) == (before if is_swapped else after)
    assert rows(found.taken(ALL)) == after
