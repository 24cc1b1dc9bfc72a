"""Taking in an export: what differs is said, what is asked for is taken, and the table stays legal and in its order."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import NamedTuple

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from judges.work import calls_in
from test_table import made_rows

from clickgen.cli import main
from clickgen.commands.nicknames.changed_rows import conflict_lines, diff_lines, summary
from clickgen.commands.nicknames.changes import differing
from clickgen.commands.nicknames.merge import KINDS, Merge, merge
from clickgen.commands.nicknames.uses import ProgramsSay, places_in, read_names
from clickgen.device.banks import Address, parse_address
from clickgen.dialects.if_rungs.read.parse import decode
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.read import read_table
from clickgen.table.rows import HEADER, Row, default_row, format_row, is_scratch, scratch_name
from clickgen.text.source import Span

ALL = set(KINDS)


def read(data: bytes, shown: str = "nicknames.csv") -> AddressTable:
    problems = Diagnostics()
    table = read_table(Path(shown), shown, problems, data)
    assert problems.found == []
    return table


def table(*rows: str, newline: str = "\n") -> AddressTable:
    return read(newline.join((HEADER, *map(row, rows), "")).encode())


def row(text: str) -> str:
    """``C1 Motor``, ``DS5 Level 10``, ``DS5 - 10 Yes a comment`` as a row; what is left out is CLICK's default."""
    place, name, *rest = text.split(" ", 4)
    address = parse_address(place)
    assert address is not None
    made = default_row(address, "" if name == "-" else name.replace("_", " "), rest[2] if len(rest) > 2 else "")
    initial = rest[0] if rest else made.initial
    retentive = rest[1] == "Yes" if len(rest) > 1 else made.retentive
    return format_row(Row(address, made.nickname, initial, retentive, made.comment))


def rows(table: AddressTable) -> list[str]:
    return [f"{row.address} {row.nickname or '-'}" for row in table.rows]


def merged(before: list[str], after: list[str], used: Callable[[str], list[str]] | None = None) -> Merge:
    return merge(table(*before), table(*after), used)


# -- what differs -----------------------------------------------------------------------------------------------------


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
        # A name that comes where another stood, or leaves where another comes.
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


# -- what is taken ----------------------------------------------------------------------------------------------------


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
    # A row that says nothing is none.
    found = merged(["DS5 -"], ["DS5 Fill 2"])
    assert found.taken({"added"}).text().splitlines()[1:] == ['DS5,INT,"Fill",2,Yes,""']
    # A name goes and a comment stays.
    found = merged(["C1 A 0 No note"], ["C1 - 0 No note"])
    assert found.taken({"removed"}).text().splitlines()[1:] == ['C1,BIT,"",0,No,"note"']


# -- conflicts --------------------------------------------------------------------------------------------------------


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


def read_table_with_faults(text: str) -> AddressTable:
    return read_table(Path("export.csv"), "export.csv", Diagnostics(), text.encode())


def test_a_shift_of_many_names_is_quick() -> None:
    def shifted(count: int) -> None:
        ours = table(*(f"DS{n} Name{n}" for n in range(1, count + 1)))
        theirs = table(*(f"DS{n + 1} Name{n}" for n in range(1, count + 1)))
        assert merge(ours, theirs).taken({"moved"}).rows[0].address == Address("DS", 2)

    assert calls_in(partial(shifted, 2000)) < 5 * calls_in(partial(shifted, 500))


# -- what programs say ------------------------------------------------------------------------------------------------


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
        # A rename in the programs follows where the name that moves stands in none.
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


# -- the command ------------------------------------------------------------------------------------------------------


class Command(NamedTuple):
    code: int
    out: str
    err: str


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., Command]:
    monkeypatch.chdir(tmp_path)

    def command(*arguments: str) -> Command:
        code = main(["nicknames", *arguments])
        return Command(code, *capsys.readouterr())

    return command


def put(name: str, *lines: str) -> None:
    Path(name).parent.mkdir(parents=True, exist_ok=True)
    Path(name).write_text("\n".join([HEADER, *map(row, lines), ""]) if name.endswith(".csv") else lines[0], "utf-8")


def put_workbook(name: str, *cells: tuple[str, str]) -> None:
    book = openpyxl.Workbook()
    assert book.active is not None
    book.active.title = "IO"
    for line in (("Address", "Tag"), *cells):
        book.active.append(line)
    book.save(name)


def program(*conditions: str) -> str:
    rungs = "".join(f"    if {condition}:\n        out(y[{n}])\n" for n, condition in enumerate(conditions, 1))
    return f"def main():\n{rungs}    if True:\n        end()\n"


SETTINGS = 'programs = [{ path = "a.py", nicknames = "io.xlsx" }]\n'


def test_what_the_workbook_says_is_not_new(run: Callable[..., Command]) -> None:
    put_workbook("io.xlsx", ("C1", "A"), ("C5", "W"))
    put("a.py", program("c.A", "c.Own"))
    put("clickgen.toml", SETTINGS)
    assert run("sync").code == 0
    book, own = Path("io.xlsx").read_bytes(), Path("nicknames.csv").read_bytes()
    put("e.csv", "C1 A", "C2 Own", "C5 W")
    assert run("merge", "e.csv") == (0, "e.csv: nothing differs\n", "")
    put("e.csv", "C1 A2", "C2 Own", "C5 W", "C9 New")
    said = run("merge", "e.csv")
    assert said == (
        1,
        "e.csv: 1 added, 1 renamed\n  ~ C1 A -> A2 (renamed; used at a.py:2)\n  + C9 New\ncannot be taken at all:\n"
        "  ! ~ C1 A -> A2 (renamed; used at a.py:2): C1 stands in IO!A2 of io.xlsx, and a workbook is changed by hand\n"
        "1 change taken, 1 not\n",
        "",
    )
    assert Path("nicknames.csv").read_bytes() == own + b'C9,BIT,"New",0,No,""\n'
    assert Path("io.xlsx").read_bytes() == book
    said = run("merge", "e.csv", "--accept", "all")
    assert said.code == 1
    assert "C1 stands in IO!A2 of io.xlsx" in said.err
    assert run("check").code == 0


def test_a_workbook_that_is_named_is_the_base_of_the_table(run: Callable[..., Command]) -> None:
    put_workbook("io.xlsx", ("C1", "A"), ("C5", "W"))
    put("e.csv", "C1 A", "C5 W", "C6 New")
    put("a.py", program("c.A"))
    assert run("merge", "e.csv", "--nicknames", "io.xlsx").out == ("e.csv: 1 added\n  + C6 New\n1 change taken\n")
    assert Path("nicknames.csv").read_text().splitlines()[1:] == ['C6,BIT,"New",0,No,""']
    # Beside a program of the settings.
    put("plant/b.py", program("c.B"))
    put("clickgen.toml", 'programs = [{ path = "plant/b.py", nicknames = "io.xlsx" }, "a.py"]\n')
    assert run("merge", "e.csv", "--nicknames", "io.xlsx").code == 0
    assert Path("plant/nicknames.csv").is_file()
    # The table beside it brings the workbook along.
    assert run("merge", "e.csv", "--nicknames", "plant/nicknames.csv").out == "e.csv: nothing differs\n"
    put("plant/nicknames.csv", "C5 Other")
    said = run("merge", "e.csv", "--nicknames", "plant/nicknames.csv")
    assert said.code == 2
    assert "CG605" in said.err


def test_a_table_that_is_named_must_exist(run: Callable[..., Command]) -> None:
    put("e.csv", "C1 A")
    for name in ("nope.csv", "nope.xlsx"):
        said = run("merge", "e.csv", "--nicknames", name)
        assert said.code == 2
        assert f"at {name}" in said.err
        assert [path.name for path in Path().iterdir()] == ["e.csv"]


def test_swapped_names_are_asked_for_by_their_own_word(run: Callable[..., Command]) -> None:
    put("a.py", program("c.A", "c.B"))
    run("sync", "a.py")
    put("e.csv", "C1 B", "C2 A")
    before = Path("nicknames.csv").read_bytes()
    said = run("merge", "e.csv", "--accept", "all")
    assert said.code == 1
    assert said.out.splitlines()[1:] == [
        "  ~ C1 A -> B (swapped; B was C2; programs that say A use C2 then; used at a.py:2)",
        "  ~ C2 B -> A (swapped; A was C1; programs that say B use C1 then; used at a.py:4)",
        "0 changes taken, 2 not: take them with --accept swapped",
        "2 addresses swapped names that programs use: no rename follows that, and the programs would drive other "
        "addresses at a.py:2, a.py:4",
    ]
    assert Path("nicknames.csv").read_bytes() == before
    said = run("merge", "e.csv", "--accept", "swapped")
    assert said.code == 0
    assert "the programs drive other addresses now at a.py:2, a.py:4" in said.out
    assert Path("nicknames.csv").read_text().splitlines()[1:] == ['C1,BIT,"B",0,No,""', 'C2,BIT,"A",0,No,""']


def test_the_advice_can_be_followed(run: Callable[..., Command]) -> None:
    put("a.py", program('c["Old one"]'))
    run("sync", "a.py")
    put("e.csv", "C1 New_one")
    (advice,) = (
        line for line in run("merge", "e.csv", "--accept", "renamed").out.splitlines() if "stands in programs" in line
    )
    assert advice == (
        "Old one stands in programs: clickgen nicknames rename 'Old one' 'New one' a.py renames it there too"
    )
    assert run("rename", "Old one", "New one", "a.py").code == 0
    assert run("check", "a.py").code == 0


def test_a_declared_name_is_not_moved_by_the_command(run: Callable[..., Command]) -> None:
    put("a.py", "nickname(c.Decl, c[7])\n\n\n" + program("c.Decl"))
    run("sync", "a.py")
    put("e.csv", "C8 Decl")
    said = run("merge", "e.csv", "--accept", "moved")
    assert said.code == 1
    assert "Decl is C7 by nickname(...) at a.py:1" in said.err
    assert run("check", "a.py").code == 0
    # Seen from the working folder where the settings name the program too.
    put("nicknames.csv", "C7 Decl")
    put("b.py", "nickname(c.More, c[9])\n\n\n" + program("c.Decl"))
    put("clickgen.toml", 'programs = ["a.py", "b.py"]\n')
    put("e.csv", "C7 Decl", "C10 More")
    assert run("merge", "e.csv").err.endswith(": More is C9 by nickname(...) at b.py:1\n")


# -- the table itself -------------------------------------------------------------------------------------------------


def test_rows_change_in_place() -> None:
    ours = table("C1 A", "C2 B", "C9 Z")
    one, two = (default_row(Address("C", number), name) for number, name in ((1, "B"), (2, "A")))
    assert rows(ours.changed({one.address: one, two.address: two})) == ["C1 B", "C2 A", "C9 Z"]
    assert rows(ours.changed({Address("C", 2): None, Address("C", 7): default_row(Address("C", 7), "B")})) == [
        "C1 A", "C7 B", "C9 Z"
    ]  # fmt: skip
    assert ours.changed({Address("C", 5): None}).to_bytes() == ours.to_bytes()
    with pytest.raises(ValueError, match="B would be C1 and C2"):
        ours.changed({one.address: one})


def test_a_nickname_changes_and_no_other_byte() -> None:
    text = f'{HEADER}\r\nC1,BIT,A,0,No,x\r\n"C2","BIT","A, b","0","No","A"\r\n'
    ours = read_table_with_faults(text)
    new = ours.renamed(Address("C", 1), "N 1").renamed(Address("C", 2), "N2")
    assert new.text() == f'{HEADER}\r\nC1,BIT,N 1,0,No,x\r\n"C2","BIT","N2","0","No","A"\r\n'
    assert [row.raw for row in new.rows] == new.text().split("\r\n")[1:3]


# -- tables made up by hypothesis -------------------------------------------------------------------------------------


@st.composite
def pairs(draw: st.DrawFn) -> tuple[AddressTable, AddressTable]:
    """A table in any order with scratch rows in it, and an export that knows many of its names and addresses."""
    ours: list[Row] = draw(made_rows(10))
    theirs: list[Row] = draw(made_rows(10))
    if ours and draw(st.sampled_from([True, False])):
        theirs = draw(st.permutations(ours))[: draw(st.integers(0, 10))]
        names = draw(st.permutations([row.nickname for row in theirs]))
        theirs = [Row(row.address, name, *row.content[2:]) for row, name in zip(theirs, names, strict=True)]
    for address in draw(st.sets(st.sampled_from([Address("C", n) for n in range(1, 7)]), max_size=2)):
        ours = [row for row in ours if row.address != address]
        ours.append(Row(address, scratch_name(address), "0", False, "condition of main rung 12"))
    return _table_of(ours), _table_of(theirs)


def _table_of(rows: list[Row]) -> AddressTable:
    return read("\n".join([HEADER, *map(format_row, rows), ""]).encode())


def said(table: AddressTable) -> dict[Address, Row]:
    shared = (row for row in table.rows if row.address.bank not in ("SC", "SD") and not row.is_default)
    return {row.address: row for row in shared if not is_scratch(row)}


@given(pairs())
def test_everything_taken_is_what_the_export_says(pair: tuple[AddressTable, AddressTable]) -> None:
    ours, theirs = pair
    found = merge(ours, theirs)
    everything = found.taken(ALL)
    refused = {
        row.address
        for conflict in found.conflicts(ALL)
        for row in (conflict.change.before, conflict.change.after)
        if row
    }
    now, wanted = said(everything), said(theirs)
    scratch = {row.address for row in ours.rows if is_scratch(row)}
    for address in {*now, *wanted} - refused - scratch:
        assert now[address].nickname == wanted[address].nickname
        assert differing(now[address], wanted[address]) == []
    assert {row for row in ours.rows if is_scratch(row)} <= set(everything.rows)
    again = merge(everything, theirs)
    assert {change.sort_key for change in again.changes} == {
        conflict.change.sort_key for conflict in again.conflicts(ALL)
    }


@given(pairs(), st.sets(st.sampled_from(KINDS)))
def test_any_kinds_leave_a_legal_table_in_its_order(pair: tuple[AddressTable, AddressTable], kinds: set[str]) -> None:
    ours, theirs = pair
    found = merge(ours, theirs)
    new = found.taken(kinds)
    again = read(new.to_bytes())
    assert [row.content for row in again.rows] == [row.content for row in new.rows]
    untouched = {row.address for row in ours.rows} - {
        row.address for change in found.takes(kinds) for row in (change.before, change.after) if row
    }
    assert [row for row in ours.rows if row.address in untouched] == [
        row for row in new.rows if row.address in untouched
    ]
    kept = [row.address for row in new.rows if row.address in ours.by_address]
    assert kept == [row.address for row in ours.rows if row.address in new.by_address]
    assert len(found.takes(kinds)) + len(found.conflicts(kinds)) == len(found.of(kinds))
    for conflict in found.conflicts(kinds):
        if conflict.accept:
            assert conflict.change in found.takes({*kinds, *conflict.accept})


@given(pairs())
def test_an_export_equal_to_the_table_changes_nothing(pair: tuple[AddressTable, AddressTable]) -> None:
    for each in pair:
        found = merge(each, read(each.to_bytes()))
        assert found.changes == ()
        assert found.taken(ALL).to_bytes() == each.to_bytes()
