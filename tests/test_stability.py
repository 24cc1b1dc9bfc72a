"""Builds that follow each other: nothing that stands ever moves, and the same input gives the same bytes.

A random program is edited step by step and built after each edit, with the address table carried along.
"""

from __future__ import annotations

import csv
import io
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from strategies.edits import MESSAGES, PLAIN, SCRATCH, Draft, Piece, edit, numbers_from, pieces, random_draft

import clickgen
from clickgen.pipeline import BuildResult

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
"""Rows of the user's, some of them not in clickgen's own form and some where scratch would go."""


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
        """Build a program, given by its text or the texts of its files, or the one that stands there."""
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
    """Scratch addresses to what they are for."""
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


SLOW = settings(
    max_examples=18,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


@SLOW
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


@SLOW
@given(st.data())
def test_scratch_of_unchanged_needs_stays(data: st.DataObject) -> None:
    """Rungs put in front, behind and between change the rung number in a scratch comment, and nothing else of it."""
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
        first = {address: without_rung(reason) for address, reason in scratch_of(here.rows()).items()}
        for _ in range(3):
            plain = Piece(data.draw(st.sampled_from(PLAIN)), next(numbers), (0, 1, 2), (0, 1, 2))
            draft.pieces.insert(data.draw(st.integers(0, len(draft.pieces))), plain)
            here.build_and_write(draft.texts())
            assert {address: without_rung(reason) for address, reason in scratch_of(here.rows()).items()} == first


def without_rung(reason: str) -> str:
    words = reason.split(" ")
    if "rung" in words:
        place = words.index("rung")
        words[place + 1] = "N"
    return " ".join(words)


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


@SLOW
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


@SLOW
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
