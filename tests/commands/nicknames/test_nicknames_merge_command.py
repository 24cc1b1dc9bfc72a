"""``clickgen nicknames merge``: the command, and tables that stay legal and in their order."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_tables import made_rows
from merging import ALL, read, read_table_with_faults, row, rows, table

from clickgen.cli import main
from clickgen.commands.nicknames.changes import differing
from clickgen.commands.nicknames.merge import KINDS, merge
from clickgen.device.banks import Address
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import HEADER, Row, default_row, format_row, is_scratch, scratch_name

# -- the command -------------------------------------------------------------------------------------------------------


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
    # Relative to the working folder if the settings name the program too.
    put("nicknames.csv", "C7 Decl")
    put("b.py", "nickname(c.More, c[9])\n\n\n" + program("c.Decl"))
    put("clickgen.toml", 'programs = ["a.py", "b.py"]\n')
    put("e.csv", "C7 Decl", "C10 More")
    assert run("merge", "e.csv").err.endswith(": More is C9 by nickname(...) at b.py:1\n")


# -- the table itself --------------------------------------------------------------------------------------------------


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


# -- tables made up by hypothesis --------------------------------------------------------------------------------------


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
