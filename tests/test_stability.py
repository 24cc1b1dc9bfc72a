"""Builds that follow each other: nothing that stands ever moves, and the same input gives the same bytes.

A random program is edited step by step and built after each edit, with the address table carried along.
"""

from __future__ import annotations

import csv
import io
import os
import random
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

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


# -- programs ----------------------------------------------------------------------------------------------------------

RUNGS: tuple[str, ...] = (
    "if {c0}:\n    out({c1})",
    "if all({c0}, nc({c1})):\n    set({c2})\n    if re({c1}):\n        copy({d0}, {d1})",
    'if {c0}:\n    calc("{d0} + {d1} * 2", {d2})',
    # Scratch bits: the condition is written before a box with pins looks at it again.
    "if all({c0}, nc({c1})):\n    set({c1})\n    rton({t0}, {d0}, unit=Ts, reset=lambda: {c2})",
    "if any({c0}, {c1}):\n    reset({c0})\n    ctu({k0}, 10, reset=lambda: all({c1}, {c2}))",
    # Formula pointers take scratch registers of several banks.
    'if {c0}:\n    calc("ds[{d0}] + dd[{d1}]", {d2})',
    'if {c0}:\n    math_hex("xd[0] AND dh[{d0}]", dh.Word{n})',
    "if {c0}:\n    rtof({t0}, {d0}, unit=Tm, reset=lambda: {c1})\nif {t0}:\n    out({c2})",
    "if {c0}:\n    copy_block(dd[900:903], ds.Block{n})",
    "if x[1]:\n    copy_fill({d0}, ds[{n}:{n2}])",
    "if c[{n}:{n2}]:\n    out(c.Whole{n})",
    'if {c0}:\n    copy("TEXT{n}", txt.Text{n})',
    "if " + "any({c0}, " + ", ".join(f"all(c[{1000 + 40 * k}:{1030 + 40 * k}], {{c1}})" for k in range(3)) + "):\n"
    "    out({c2})",
    "if all(td.Elapsed{n} > 3, {c0}):\n    out({c1})\nif {c2}:\n    ton(t.Elapsed{n}, 500)",
    "if x.Input{n}:\n    out(y.Output{n})",
)


@dataclass(frozen=True)
class Piece:
    """Some rungs of main: a form, the names in it, and a number that makes its own names unique."""

    form: int
    number: int
    bits: tuple[int, int, int]
    words: tuple[int, int, int]

    def text(self, renamed: dict[int, str]) -> str:
        number = self.number
        names: dict[str, object] = {"n": number, "n2": number + 3, "t0": f"t.Timer{number}", "k0": f"ct.Count{number}"}
        for place, bit in enumerate(self.bits):
            names[f"c{place}"] = f"c.{renamed.get(bit, f'Bit{bit}')}"
        for place, word in enumerate(self.words):
            names[f"d{place}"] = f"ds.Word_{word}"
        return RUNGS[self.form].format_map(names)


@dataclass
class Draft:
    """A program under way."""

    pieces: list[Piece] = field(default_factory=list)
    routine: list[Piece] = field(default_factory=list)
    renamed: dict[int, str] = field(default_factory=dict)
    extra: list[str] = field(default_factory=list)

    def text(self) -> str:
        def body(pieces: list[Piece]) -> str:
            lines = "\n".join(piece.text(self.renamed) for piece in pieces).splitlines()
            return "".join(f"    {line}\n" for line in lines)

        declared = "".join(f"{line}\n" for line in self.extra)
        return (
            f"{declared}\n@sub\ndef helper():\n{body(self.routine)}    if True:\n        return\n\n"
            f"def main():\n{body(self.pieces)}    if True:\n        call(helper)\n    if True:\n        end()\n"
        )


_small = st.integers(0, 6)


@st.composite
def pieces(draw: st.DrawFn, numbers: Iterator[int]) -> Piece:
    bits = draw(st.lists(_small, min_size=3, max_size=3, unique=True))
    words = draw(st.lists(_small, min_size=3, max_size=3, unique=True))
    form = draw(st.integers(0, len(RUNGS) - 1))
    return Piece(form, next(numbers), (bits[0], bits[1], bits[2]), (words[0], words[1], words[2]))


def edit(data: st.DataObject, draft: Draft, numbers: Iterator[int]) -> None:
    """Change the draft in one place."""
    draw = data.draw
    part = draft.routine if draw(st.integers(0, 4)) == 0 else draft.pieces
    kind = draw(st.sampled_from(["insert", "insert", "remove", "swap", "rename", "declare", "double"]))
    if kind == "insert" or (kind != "declare" and kind != "rename" and not part):
        part.insert(draw(st.integers(0, len(part))), draw(pieces(numbers)))
    elif kind == "remove":
        del part[draw(st.integers(0, len(part) - 1))]
    elif kind == "swap":
        one, other = draw(st.integers(0, len(part) - 1)), draw(st.integers(0, len(part) - 1))
        part[one], part[other] = part[other], part[one]
    elif kind == "rename":
        draft.renamed[draw(_small)] = f"Renamed{next(numbers)}"
    elif kind == "declare":
        number = next(numbers)
        draft.extra.append(f'nickname(ds.Declared{number}, ds[{4000 + number}], initial={number}, comment="d{number}")')
    else:
        # The same need a second time: its scratch cells have the same purpose.
        piece = part[draw(st.integers(0, len(part) - 1))]
        part.insert(draw(st.integers(0, len(part))), Piece(piece.form, next(numbers), piece.bits, piece.words))


# -- a desk ------------------------------------------------------------------------------------------------------------


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

    def build(self, text: str | None = None, *, frozen: bool = False) -> BuildResult:
        if text is not None:
            self.program.write_text(text)
        result = clickgen.build(self.program, frozen=frozen)
        assert result.ok, [(problem.code, problem.message, str(problem.span)) for problem in result.diagnostics]
        return result

    def build_and_write(self, text: str | None = None) -> list[Path]:
        return self.build(text).write(self.out)

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


def numbers_from(first: int) -> Iterator[int]:
    return iter(range(first, first + 900))


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
            here.build_and_write(draft.text())
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
            data.draw(st.sampled_from([3, 4, 5, 7, 12])),
            next(numbers),
            (10 * k, 10 * k + 1, 10 * k + 2),
            (k, 20 + k, 40),
        )
        for k in range(1, data.draw(st.integers(2, 5)))
    ]
    draft = Draft(pieces=list(needs))
    with desk() as here:
        here.build_and_write(draft.text())
        first = {address: without_rung(reason) for address, reason in scratch_of(here.rows()).items()}
        for _ in range(3):
            plain = Piece(data.draw(st.integers(0, 2)), next(numbers), (0, 1, 2), (0, 1, 2))
            draft.pieces.insert(data.draw(st.integers(0, len(draft.pieces))), plain)
            here.build_and_write(draft.text())
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
        first = here.build(draft.text())
        first.write(here.out)
        changed = draft.pieces if in_main else draft.routine
        for _ in range(data.draw(st.integers(1, 3))):
            changed.insert(data.draw(st.integers(0, len(changed))), data.draw(pieces(numbers)))
        second = here.build(draft.text())
        other = "helper" if in_main else "main"
        assert sections(second.files["listing.txt"])[other] == sections(first.files["listing.txt"])[other]
        name = "subroutines/helper.csv" if in_main else "main.csv"
        assert second.files[name] == first.files[name]


# -- the same bytes everywhere -----------------------------------------------------------------------------------------


def _random_program(seed: int) -> str:
    chance = random.Random(seed)

    def some(first: int) -> list[Piece]:
        found = []
        for number in range(first, first + 12):
            bits, words = chance.sample(range(7), 3), chance.sample(range(7), 3)
            form = chance.randrange(len(RUNGS))
            found.append(Piece(form, number, (bits[0], bits[1], bits[2]), (words[0], words[1], words[2])))
        return found

    return Draft(some(100), some(200)).text()


def _in_other_process(folder: Path, seed: str, program: str) -> dict[str, bytes]:
    folder.mkdir()
    (folder / "prog.py").write_text(program)
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
    program = _random_program(number)
    one, two = (_in_other_process(tmp_path / seed, seed, program) for seed in ("0", "4711"))
    assert one == two
    assert len(one) >= 6


def test_the_folder_and_the_way_to_name_it_do_not_matter(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = _random_program(5)
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
        (folder / "prog.py").write_text(program)
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
    program = _random_program(7)
    with desk() as here:
        plain = here.build(program)
        here.program.write_bytes(change(program))
        other = here.build()
        assert dict(other.files) == dict(plain.files)
        assert other.table == plain.table
