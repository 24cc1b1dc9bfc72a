"""Captures and program files of CLICK; damaged files of every kind."""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator, Sequence
from pathlib import Path

import budget
import laddercodec
import pytest
from judges.program_files import program_file
from ladder_sources import (
    EITHER,
    HEAT,
    MAIN,
    NICKNAMES,
    Rung,
    every_problem,
    ladder,
    messages,
    names,
    put,
    refused,
    row,
    sets,
    shape,
    whole,
)

from clickgen.click.read.project import DrawnRoutine, read_project
from clickgen.click.read.rungs import import_rung
from clickgen.workspace import CouldNotRun


def capture(path: Path, rungs: Sequence[Rung]) -> bytes:
    """The rungs as CLICK has them in the clipboard."""
    table = path / "capture.csv"
    table.write_text(ladder(rungs), "utf-8")
    return bytes(laddercodec.encode(laddercodec.read_csv(table)))


# -- captures and program files ----------------------------------------------------------------------------------------


def test_a_capture_has_the_rungs_of_the_text(tmp_path: Path) -> None:
    for name, rungs in (("plant", MAIN), ("Heat", HEAT), ("one", [("", sets("C1"))])):
        put(tmp_path, {f"{name}.csv": ladder(rungs), f"{name}.clipboard.bin": capture(tmp_path, rungs)})
        [text], [binary] = (whole(tmp_path / f"{name}{end}").routines for end in (".csv", ".clipboard.bin"))
        assert (binary.name, binary.is_main) == (text.name, text.is_main)
        assert shape(binary.rungs) == shape(text.rungs)
        assert {line.line for rung in binary.rungs for line in rung.rows} == {0}
        assert [import_rung(one).notes for one in binary.rungs] == [import_rung(one).notes for one in text.rungs]
        assert whole(tmp_path / f"{name}.clipboard.bin").texts == {}


def test_a_capture_knows_its_kind_by_its_content(tmp_path: Path) -> None:
    put(tmp_path, {"x.csv": capture(tmp_path, MAIN), "y.bin": ladder(MAIN), "z.csv": program_file("Heat", 2, HEAT)})
    put(tmp_path, {"bundle/main.csv": capture(tmp_path, MAIN)})
    assert [names(whole(tmp_path / name)) for name in ("x.csv", "y.bin", "z.csv", "bundle")] == [
        ["main"],
        ["main"],
        ["Heat"],
        ["main"],
    ]


def test_a_program_file_has_the_rungs_of_the_text(tmp_path: Path) -> None:
    put(tmp_path, {"main.csv": ladder(MAIN), "Heat.csv": ladder(HEAT)})
    put(tmp_path, {"Scr1.tmp": program_file("Main Program", 1, MAIN), "x.scr": program_file("Heat", 7, HEAT)})
    for text, binary in (("main.csv", "Scr1.tmp"), ("Heat.csv", "x.scr")):
        [a], [b] = whole(tmp_path / text).routines, whole(tmp_path / binary).routines
        assert (a.name, a.is_main) == (b.name, b.is_main)
        assert shape(a.rungs) == shape(b.rungs)


def test_a_folder_of_program_files_has_the_order_of_click(tmp_path: Path) -> None:
    names_and_indexes = [("Main Program", 1), ("Zeta", 2), ("Heat Up", 3), ("Alpha", 300)]
    for place, (name, index) in enumerate(reversed(names_and_indexes)):
        put(
            tmp_path,
            {f"sCr{place}.TMP" if place else "saved.scr": program_file(name, index, MAIN if index == 1 else HEAT)},
        )
    put(tmp_path, {"other.tmp": "x", "readme.txt": "", "Heat.csv": ladder(HEAT), "nicknames.csv": NICKNAMES})
    found = whole(tmp_path)
    assert names(found) == ["main", "Zeta", "Heat Up", "Alpha"]
    assert [routine.is_main for routine in found.routines] == [True, False, False, False]
    assert found.nicknames == tmp_path / "nicknames.csv"
    put(tmp_path, {"main.csv": ladder(MAIN)})
    assert names(read_project(tmp_path)) == ["main"]


def test_program_files_that_do_not_fit_together(tmp_path: Path) -> None:
    main, heat, cool = (
        program_file(name, index, HEAT) for name, index in (("Main Program", 1), ("Heat", 2), ("Cool", 2))
    )
    no_main = put(tmp_path / "a", {"Scr2.tmp": heat})
    assert refused(no_main) == f"{no_main} holds program files of CLICK, and none of them is the main program"
    two = put(tmp_path / "b", {"Scr1.tmp": main, "Scr2.tmp": main})
    where = f"{two / 'Scr1.tmp'} and {two / 'Scr2.tmp'}"
    assert refused(two) == f"{where} are both main programs: import reads one project at a time"
    same = put(tmp_path / "c", {"Scr1.tmp": main, "Scr2.tmp": heat, "Scr3.tmp": cool})
    assert messages(same) == ["Scr3.tmp: the file is of the same routine as Scr2.tmp: are these two projects?"]
    assert names(read_project(same)) == ["main", "Heat", "Cool"]
    broken = put(tmp_path / "d", {"Scr1.tmp": main, "Scr2.tmp": b"\0" * 900})
    assert messages(broken) == ["Scr2.tmp: the file is no program file of CLICK, as its name says: is it damaged?"]
    cut = put(tmp_path / "e", {"Scr1.tmp": main[:80], "Scr2.tmp": heat})
    assert "and none of them is the main program (" in refused(cut)


def test_a_damaged_program_file_keeps_its_name_and_place(tmp_path: Path) -> None:
    main, heat = program_file("Main Program", 1, MAIN), program_file("Heat", 2, HEAT)
    put(tmp_path, {"Scr1.tmp": main, "Scr2.tmp": heat[:-300], "Scr3.tmp": program_file("Cool", 3, HEAT)})
    found = read_project(tmp_path)
    assert [(one.name, len(one.rungs)) for one in found.routines] == [("main", 3), ("Heat", 0), ("Cool", 2)]
    [problem] = found.problems
    assert (os.path.basename(problem.file), problem.row, problem.rung) == ("Scr2.tmp", 0, 2)
    assert str(problem).startswith(
        f"{tmp_path / 'Scr2.tmp'}: rung 2: the file is damaged, or of a form that is not known ("
    )


def test_a_rung_that_is_not_known_is_the_only_one_lost(tmp_path: Path) -> None:
    bad: list[list[str]] = [row("X001", "mystery()", out="out(C1)")]
    put(tmp_path, {"x.scr": program_file("Heat", 2, [("Why\nnot", bad), *HEAT])})
    [routine] = read_project(tmp_path / "x.scr").routines
    assert [len(rung.problems) for rung in routine.rungs] == [1, 0, 0]
    first = routine.rungs[0]
    assert (first.comment, first.rows, first.boxes) == ("Why\nnot", (), ())
    assert str(first.problems[0]).startswith(
        f"{tmp_path / 'x.scr'}: rung 1: the rung is damaged, or holds something that is not known (WriterError: "
    )


def test_a_fault_in_a_drawing_knows_its_rung(tmp_path: Path) -> None:
    loose: list[list[str]] = [row("X001", "T", out="out(C1)"), row("", "T"), row("", "", "|")]
    put(tmp_path, {"x.scr": program_file("Heat", 2, [*HEAT, ("", loose)])})
    assert messages(tmp_path / "x.scr") == ["x.scr: rung 3: a wire leads down from the last row of the rung"]


def test_a_comment_of_another_code_page_is_not_lost_in_silence(tmp_path: Path) -> None:
    data = program_file("Heat", 2, HEAT).replace(b"ansicpg1252", b"ansicpg0932")
    put(tmp_path, {"x.scr": data, "x.bin": capture(tmp_path, HEAT[::-1]).replace(b"ansicpg1252", b"ansicpg0932")})
    assert messages(tmp_path / "x.scr") == ["x.scr: rung 2: the comment cannot be read"]
    assert "Unsupported RTF code page" in messages(tmp_path / "x.bin")[0]


COMMENTS = ["**bold** and *leaning* and __line__", "  two  \n\n\n spaces ", 'a "quote", a comma', "-", "R", "#"]


@pytest.mark.parametrize("comment", COMMENTS)
def test_comments_are_kept_exactly(tmp_path: Path, comment: str) -> None:
    put(tmp_path, {"x.scr": program_file("Heat", 2, [(comment, sets("C1")), *HEAT])})
    assert whole(tmp_path / "x.scr").routines[0].rungs[0].comment == comment


def test_a_program_file_needs_no_name(tmp_path: Path) -> None:
    put(tmp_path, {"old plant!.scr": program_file("", 2, HEAT)})
    assert names(whole(tmp_path / "old plant!.scr")) == ["old plant_"]


# -- damage ------------------------------------------------------------------------------------------------------------


def sources(folder: Path) -> Iterator[tuple[str, bytes]]:
    yield "x.csv", ladder(HEAT + MAIN).encode()
    yield "x.bin", capture(folder, MAIN)
    yield "one.bin", capture(folder, [("Alone", EITHER)])
    yield "x.scr", program_file("Heat", 2, HEAT + MAIN)


def found_in(path: Path) -> tuple[list[DrawnRoutine], bool]:
    """The routines, and whether a problem is reported in them."""
    try:
        found = read_project(path)
    except CouldNotRun:
        return [], True
    for problem in every_problem(found):
        assert str(problem).startswith(str(path)), problem
    return [*found.routines], bool(every_problem(found))


@pytest.mark.parametrize("kind", range(4))
def test_a_file_that_is_cut_off_is_never_taken_for_a_whole_one(tmp_path: Path, kind: int) -> None:
    name, data = list(sources(tmp_path))[kind]
    path = put(tmp_path, {name: data}) / name
    [complete] = whole(path).routines
    for size in range(0, len(data), 97):
        path.write_bytes(data[:size])
        routines, is_told = found_in(path)
        if not is_told:  # a text may end after any line
            assert name == "x.csv"
            assert data[:size].endswith(b"\n") or data[size:].startswith(b"\n")
            assert shape(routines[0].rungs[:-1]) == shape(complete.rungs[: len(routines[0].rungs) - 1])


@pytest.mark.parametrize("kind", range(4))
def test_a_file_that_goes_on_with_nuls_is_never_taken_for_a_whole_one(tmp_path: Path, kind: int) -> None:
    name, data = list(sources(tmp_path))[kind]
    path = put(tmp_path, {name: data}) / name
    expected = shape(whole(path).routines[0].rungs)
    for size in range(0, len(data.rstrip(b"\0")), 97):
        path.write_bytes(data[:size] + bytes(len(data) - size))
        routines, is_told = found_in(path)
        # A box that lost a part becomes an unknown one.
        is_raw = any(
            box.token.startswith("raw(") for routine in routines for rung in routine.rungs for box in rung.boxes
        )
        assert is_told or is_raw or shape(routines[0].rungs) == expected


@pytest.mark.property
@pytest.mark.parametrize("kind", range(4))
def test_a_damaged_byte_never_stops_the_reading(tmp_path: Path, kind: int) -> None:
    name, data = list(sources(tmp_path))[kind]
    path = tmp_path / name
    for place in budget.some(range(0, len(data), 31), 6):
        path.write_bytes(data[:place] + bytes((data[place] ^ 0xFF,)) + data[place + 1 :])
        found_in(path)


def test_whatever_laddercodec_raises_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put(tmp_path, {"x.scr": program_file("Heat", 2, HEAT), "x.bin": capture(tmp_path, HEAT)})
    for error in (struct.error("odd"), IndexError(), AssertionError("no"), RecursionError("deep"), MemoryError()):

        def fails(*_: object, error: Exception = error) -> object:
            raise error

        for function in ("decode", "decode_program"):
            monkeypatch.setattr(laddercodec, function, fails)
        for name in ("x.scr", "x.bin"):
            [message] = messages(tmp_path / name)
            assert f"({type(error).__name__}" in message
