"""Successive builds: nothing that has a place ever moves, and the same input gives the same bytes.

A random program is edited step by step and built after each edit, with the address table carried along.
"""

from __future__ import annotations

import csv
import io
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st
from strategies.edits import MESSAGES, PLAIN, SCRATCH, Draft, Piece, edit, numbers_from, pieces, random_draft

import clickgen
from clickgen.device.banks import Address
from clickgen.instructions.coils import OUT
from clickgen.ir.conditions import Contact
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action
from clickgen.lower.serves import served
from clickgen.lower.split import ClickRoutine, ClickRung
from clickgen.results import BuildResult
from clickgen.text.source import Span

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment"
FOREIGN = (
    'X003,BIT,"Panel door",0,No,"by hand"',
    'C2,BIT,Loose,1,Yes,"a row, that the user wrote"',
    'C1998,BIT,"Upper end",0,No,""',
    'SC1,BIT,"_Always_ON",0,No,""',
    'DS2,INT,"",7,No,"unnamed, but set"',
    'TD9,INT,"Elapsed here",0,No,""',
    'DS4500,INT,"Top",0,Yes,"say ""when"""',
)
"""Rows of the user's, some not in clickgen's own form and some where scratch would go."""


# -- a desk ------------------------------------------------------------------------------------------------------------


def put(folder: Path, texts: dict[str, str], change: Callable[[str], bytes] = str.encode) -> None:
    for name, text in texts.items():
        (folder / name).write_bytes(change(text))


@dataclass
class Desk:
    folder: Path

    @property
    def program(self) -> Path:
        return self.folder / "prog.py"

    @property
    def table(self) -> Path:
        return self.folder / "nicknames.csv"

    @property
    def out(self) -> Path:
        return self.folder / "out"

    def build(self, program: str | dict[str, str] = "", *, frozen: bool = False) -> BuildResult:
        """Build a program, given by its text or the texts of its files, or the one that is there."""
        if program:
            for path in self.folder.glob("*.py"):
                path.unlink()
            put(self.folder, program if isinstance(program, dict) else {"prog.py": program})
        result = clickgen.build(self.program, frozen=frozen)
        assert result.ok, [(problem.code, problem.message, str(problem.span)) for problem in result.diagnostics]
        return result

    def build_and_write(self, program: str | dict[str, str] = "") -> list[Path]:
        return self.build(program).write(self.out)

    def everything(self) -> dict[str, bytes]:
        files = {path.relative_to(self.out).as_posix(): path.read_bytes() for path in self.out.rglob("*.*")}
        return {**files, "table": self.table.read_bytes() if self.table.exists() else b""}

    def rows(self) -> dict[str, tuple[str, ...]]:
        """The table's rows by address."""
        if not self.table.exists():
            return {}
        return {
            row[0]: tuple(row)
            for row in csv.reader(io.StringIO(self.table.read_text()))
            if len(row) == 6 and row[0] != "Address"
        }


@contextmanager
def desk() -> Iterator[Desk]:
    with tempfile.TemporaryDirectory() as folder:
        yield Desk(Path(folder))


def by_name(rows: dict[str, tuple[str, ...]]) -> dict[str, str]:
    return {row[2]: address for address, row in rows.items() if row[2]}


def scratch_of(rows: dict[str, tuple[str, ...]]) -> dict[str, str]:
    """Scratch addresses, each with its purpose."""
    return {address: row[5] for address, row in rows.items() if row[2] == f"Scratch_{address}"}


def check_nothing_moved(before: dict[str, tuple[str, ...]], after: dict[str, tuple[str, ...]]) -> None:
    for address, row in before.items():
        if row[2] == f"Scratch_{address}":
            assert after[address][:5] == row[:5]
        else:
            assert after[address] == row


def check_no_address_serves_two(desk: Desk) -> None:
    """Every name has one address, and no scratch cell's address is written by number or reached by a range."""
    addresses = list(by_name(desk.rows()).values())
    assert len(addresses) == len(set(addresses))


@examples(6)
@given(st.data(), st.booleans())
def test_edit_after_edit_nothing_moves(data: st.DataObject, with_foreign: bool) -> None:
    numbers = numbers_from(100)
    draft = Draft()
    with desk() as here:
        if with_foreign:
            here.table.write_text("".join(f"{line}\n" for line in (HEADER, *FOREIGN)))
        for _ in range(data.draw(st.integers(2, 7))):
            before = here.rows()
            for _ in range(data.draw(st.integers(1, 3))):
                edit(data, draft, numbers)
            here.build_and_write(draft.texts())
            check_nothing_moved(before, here.rows())
            check_no_address_serves_two(here)
            state = here.everything()

            # A second build changes nothing, not even a file's time.
            assert here.build_and_write() == []
            assert here.everything() == state

            # Frozen gives the same, right after.
            frozen = here.build(frozen=True)
            assert {name: text.encode() for name, text in frozen.files.items()} == {
                name: text for name, text in state.items() if name != "table"
            }
            assert frozen.table == state["table"]
            assert not frozen.new_rows

        if with_foreign:
            lines = here.table.read_text().splitlines()
            assert [line for line in lines if line in FOREIGN] == list(FOREIGN)

        # Without the output folder, the same files are made again.
        state = here.everything()
        for path in sorted(here.out.rglob("*"), reverse=True):
            path.rmdir() if path.is_dir() else path.unlink()
        here.build_and_write()
        assert here.everything() == state


@examples(6)
@given(st.data())
def test_scratch_of_unchanged_needs_stays(data: st.DataObject) -> None:
    """Rungs inserted before, after and between change nothing in a scratch row."""
    numbers = numbers_from(100)
    # Every need has a purpose of its own here: bits that no other piece has.
    needs = [
        Piece(
            data.draw(st.sampled_from(SCRATCH)),
            next(numbers),
            (10 * k, 10 * k + 1, 10 * k + 2),
            (k, 20 + k, 40),
        )
        for k in range(1, data.draw(st.integers(2, 5)))
    ]
    draft = Draft(pieces=list(needs))
    with desk() as here:
        here.build_and_write(draft.texts())
        first = scratch_of(here.rows())
        for _ in range(3):
            plain = Piece(data.draw(st.sampled_from(PLAIN)), next(numbers), (0, 1, 2), (0, 1, 2))
            draft.pieces.insert(data.draw(st.integers(0, len(draft.pieces))), plain)
            here.build_and_write(draft.texts())
            assert scratch_of(here.rows()) == first


TWICE = """\
def main():
{front}    if all(c.Go, nc(c.Done)):
        set(c.Done)
        rton(t.First, 5, reset=lambda: c.Clear)
    if all(c.Go, nc(c.Done)):
        set(c.Done)
        rton(t.Second, 5, reset=lambda: c.Clear)
    if True:
        end()
"""


@pytest.mark.parametrize("count", [1, 2, 3, 4, 7])
def test_two_needs_of_the_same_purpose_do_not_change_places(count: int) -> None:
    with desk() as here:
        here.build_and_write(TWICE.format(front=""))
        before = [line for line in (here.out / "main.csv").read_text().splitlines() if "C2000" in line]
        here.build_and_write(TWICE.format(front="    if x[1]:\n        out(y[1])\n" * count))
        assert [line for line in (here.out / "main.csv").read_text().splitlines() if "C2000" in line] == before


def test_a_need_that_comes_back_finds_a_scratch_cell_again() -> None:
    with desk() as here:
        with_need = TWICE.format(front="")
        here.build_and_write(with_need)
        state = here.everything()
        here.build_and_write("def main():\n    if True:\n        end()\n")
        assert set(scratch_of(here.rows())) == {"C1999", "C2000"}
        here.build_and_write(with_need)
        assert here.everything() == state


FIRST_VERSION = {
    "C1998": "reset input of main rung 4: C3",
    "C1999": "condition of main rung 1: C1 and not C2",
    "C2000": "condition of main rung 3: C1 and not C2",
    "C1997": "rtof T3: on while its rung is true",
    "C1996": "rtof T3: its output, read in place of T3",
    "C1995": "condition of Pump rung 3 rung 1: not C2",
    "C1994": "part of the condition of Pump rung 3 rung 12: " + " and ".join(f"C{n}" for n in range(101, 131)),
}
"""Rows of earlier versions, at other addresses than a first build would choose."""
MIGRATED = {
    "C1998": "reset input of main: rton T2 Second",
    "C1999": "condition of main: rton T1 First",
    "C2000": "condition of main: rton T2 Second",
    "C1997": "rtof T3: on while its rung is true",
    "C1996": "rtof T3: its output, read in place of T3",
    "C1995": "condition of Pump rung 3: ctu CT1 Parts",
    "C1994": "part of the condition of Pump rung 3: out Y001",
}
OLD_PROGRAM = """\
@sub("Pump rung 3")
def pump():
    if nc(c.Done):
        set(c.Done)
        ctu(ct.Parts, 5, reset=lambda: c.Clear)
    if c[101:141]:
        out(y[1])
    if True:
        return


def main():
    if all(c.Go, nc(c.Done)):
        set(c.Done)
        rton(t.First, 5, reset=lambda: c[50])
    if all(c.Go, nc(c.Done)):
        reset(c.Clear)
        set(c.Done)
        rton(t.Second, 5, reset=lambda: c.Clear)
    if c.Go:
        rtof(t.Idle, 5, reset=lambda: c[50])
        call(pump)
    if True:
        end()
"""


def test_a_table_of_an_earlier_version_keeps_every_address() -> None:
    """Its comments hold the rung and the condition; the next build says the same in the new words."""
    names = {"C1": "Go", "C2": "Done", "C3": "Clear", "T1": "First", "T2": "Second", "T3": "Idle", "CT1": "Parts"}
    lines = [f'{address},BIT,"{name}",0,{"Yes" if "CT" in address else "No"},""' for address, name in names.items()]
    for address, reason in FIRST_VERSION.items():
        comment = reason if len(reason) <= 128 else reason[:125] + "..."
        lines.append(f'{address},BIT,"Scratch_{address}",0,No,"{comment}"')
    with desk() as here:
        here.table.write_text("\n".join((HEADER, *lines, "")))
        frozen = here.build(OLD_PROGRAM, frozen=True)
        here.build_and_write()
        assert scratch_of(here.rows()) == MIGRATED
        assert {name: address for address, name in names.items()}.items() <= by_name(here.rows()).items()
        assert frozen.files == here.build(frozen=True).files
        again = here.table.read_bytes()
        here.build_and_write()
        assert here.table.read_bytes() == again


ONE = TWICE.format(front="")
OTHER = """\
def main():
    if nc(c.Busy):
        set(c.Busy)
        ctu(ct.Boxes, 5, reset=lambda: c.Clear)
    if all(c.Go, nc(c.Done)):
        set(c.Done)
        rton(t.Second, 5, reset=lambda: c.Clear)
    if True:
        end()
"""


def test_programs_of_one_table_leave_each_others_scratch_cells_alone() -> None:
    """They share cells for the same need; else each has its own, and no build changes the other's."""
    with desk() as here:
        for program in (ONE, OTHER):
            here.build(program).write(here.out)
        table = here.table.read_bytes()
        assert scratch_of(here.rows()) == {
            "C2000": "condition of main: rton T1 First",
            "C1999": "condition of main: rton T2 Second",
            "C1998": "condition of main: ctu CT1 Boxes",
        }
        for program in (ONE, OTHER, ONE, OTHER):
            assert here.build(program, frozen=True).table == table
            here.build(program).write(here.out)
            assert here.table.read_bytes() == table


def test_another_name_changes_a_scratch_comment_and_no_address() -> None:
    with desk() as here:
        here.build_and_write(ONE)
        before = here.rows()
        table = here.table.read_text().replace('"First"', '"Start"')
        here.table.write_text(table)
        here.build_and_write(ONE.replace("First", "Start"))
        after = here.rows()
        assert after["C2000"][5] == "condition of main: rton T1 Start"
        assert {address: row for address, row in after.items() if address not in ("T1", "C2000")} == {
            address: row for address, row in before.items() if address not in ("T1", "C2000")
        }


def test_needs_of_the_same_output_are_numbered() -> None:
    shift = "shift(c[1:9], clock=lambda: x[2], reset=lambda: x[3])"
    rung = f"    if all(c.Go, nc(c.Done)):\n        set(c.Done)\n        {shift}\n"
    with desk() as here:
        here.build_and_write(f"def main():\n{rung * 3}    if True:\n        end()\n")
        first = scratch_of(here.rows())
        assert first == {
            "C2000": "condition of main: shift C1..C8",
            "C1999": "condition of main: shift C1..C8 (2)",
            "C1998": "condition of main: shift C1..C8 (3)",
        }
        here.build_and_write(f"def main():\n{rung * 2}    if True:\n        end()\n")
        assert scratch_of(here.rows()) == first


def test_a_full_bank_gives_up_what_the_program_does_not_need() -> None:
    with desk() as here:
        here.build_and_write(ONE)
        rows = "".join(f'C{n},BIT,"N{n}",0,No,""\n' for n in range(4, 1999))
        here.table.write_text(here.table.read_text() + rows)
        here.build_and_write(ONE.replace("t.First", "t.Third"))
        assert scratch_of(here.rows()) == {
            "C2000": "condition of main: rton T3 Third",
            "C1999": "condition of main: rton T2 Second",
        }


def test_a_long_chain_of_scratch_cells_serves_what_its_last_one_serves() -> None:
    nowhere = Span("", 0, 0, 0, 0)

    def cell(number: int) -> Cell:
        return Cell(Address("C", -number), nowhere)

    def rung(number: int, target: Cell) -> ClickRung:
        coil = Action(OUT, {"address": target}, nowhere)
        return ClickRung(Contact(cell(number), nowhere), (coil,), "", nowhere)

    rungs = [rung(number, cell(number + 1)) for number in range(1, 3000)]
    rungs.append(rung(3000, Cell(Address("Y", 1), nowhere)))
    found = served([ClickRoutine("main", True, tuple(rungs), nowhere)], {}, lambda _: "Motor")
    assert len(found) == 3000
    assert set(found.values()) == {"out Y001 Motor"}


def test_a_removed_name_keeps_its_address_and_finds_it_again() -> None:
    program = "def main():\n    if c.{}:\n        out(c.{})\n    if True:\n        end()\n"
    with desk() as here:
        here.build_and_write(program.format("A", "B"))
        here.build_and_write(program.format("C", "D"))
        here.build_and_write(program.format("B", "A"))
        assert by_name(here.rows()) == {"A": "C1", "B": "C2", "C": "C3", "D": "C4"}


# -- one routine's listing ---------------------------------------------------------------------------------------------


def sections(listing: str) -> dict[str, str]:
    """The text of each routine of a listing, and of the cross-reference, by its heading."""
    parts = listing.split("\n\n\n")
    return {part.split("\n", 1)[0]: part.split("\n", 2)[2] for part in parts[1:]}


@examples(6)
@given(st.data())
def test_a_change_in_one_routine_leaves_the_text_of_the_others(data: st.DataObject) -> None:
    numbers = numbers_from(100)
    draft = Draft()
    for part in (draft.routine, draft.pieces):
        part += [data.draw(pieces(numbers)) for _ in range(data.draw(st.integers(1, 3)))]
    in_main = data.draw(st.booleans())
    with desk() as here:
        first = here.build(draft.texts())
        first.write(here.out)
        changed = draft.pieces if in_main else draft.routine
        for _ in range(data.draw(st.integers(1, 3))):
            # A new message may change what another routine looks at, and so how its rungs are split.
            piece = data.draw(pieces(numbers).filter(lambda piece: piece.form not in MESSAGES))
            changed.insert(data.draw(st.integers(0, len(changed))), piece)
        second = here.build(draft.texts())
        other = "helper" if in_main else "main"
        assert sections(second.files["listing.txt"])[other] == sections(first.files["listing.txt"])[other]
        name = "subroutines/helper.csv" if in_main else "main.csv"
        assert second.files[name] == first.files[name]


@examples(6)
@given(st.data())
def test_a_routine_moves_to_a_file_of_its_own_and_nothing_else_changes(data: st.DataObject) -> None:
    numbers = numbers_from(100)
    draft = Draft()
    for part in (draft.routine, draft.pieces):
        part += [data.draw(pieces(numbers)) for _ in range(data.draw(st.integers(1, 3)))]
    with desk() as here:
        here.build_and_write(draft.texts())
        first = here.everything()
        draft.is_apart = True
        here.build_and_write(draft.texts())
        second = here.everything()
    for name in first:
        if name.endswith(".csv") or name == "table":
            assert second[name] == first[name], name


# -- the same bytes everywhere -----------------------------------------------------------------------------------------


def _in_other_process(folder: Path, seed: str, program: dict[str, str]) -> dict[str, bytes]:
    folder.mkdir()
    put(folder, program)
    subprocess.run(
        [sys.executable, "-m", "clickgen", "build", "prog.py", "-o", "out"],
        cwd=folder,
        env={**os.environ, "PYTHONHASHSEED": seed},
        check=True,
        capture_output=True,
    )
    # What is remembered of a file is named by its place and signed for one user.
    shutil.rmtree(folder / ".clickgen_cache")
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()
    }


@pytest.mark.parametrize("number", range(2))
def test_an_empty_table_gives_the_same_bytes_under_any_hash_seed(tmp_path: Path, number: int) -> None:
    program = random_draft(number)
    one, two = (_in_other_process(tmp_path / seed, seed, program) for seed in ("0", "4711"))
    assert one == two
    assert len(one) >= 6


def test_the_folder_and_the_way_to_name_it_do_not_matter(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = random_draft(5)
    found = []
    ways: list[Callable[[Path], str]] = [
        lambda folder: str(folder / "prog.py"),
        lambda folder: os.path.join("..", folder.name, "prog.py"),
        lambda _: "prog.py",
    ]
    for number, way in enumerate(ways):
        folder = tmp_path / f"at {number}"
        folder.mkdir()
        monkeypatch.chdir(folder)
        put(folder, program)
        result = clickgen.build(way(folder))
        assert result.ok
        found.append((dict(result.files), result.table))
    assert found[0] == found[1] == found[2]


@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace("\n", "\r\n").encode(),
        lambda text: b"\xef\xbb\xbf" + text.encode(),
        lambda text: text.rstrip("\n").encode(),
    ],
    ids=["crlf", "bom", "no final newline"],
)
def test_line_ends_and_marks_of_the_source_do_not_matter(change: Callable[[str], bytes]) -> None:
    program = random_draft(7)
    with desk() as here:
        plain = here.build(program)
        put(here.folder, program, change)
        other = here.build()
        assert dict(other.files) == dict(plain.files)
        assert other.table == plain.table
