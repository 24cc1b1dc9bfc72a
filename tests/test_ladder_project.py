"""What a file or folder holds: every kind of source, the order of routines, and damage that is told."""

from __future__ import annotations

import csv
import io
import json
import os
import re
import struct
import zipfile
from collections.abc import Iterator, Sequence
from pathlib import Path

import budget
import laddercodec
import pytest
from judges.power import HEADER
from judges.program_files import program_file

import clickgen
from clickgen.click.read import project
from clickgen.click.read.grid import DrawnRung, Square
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.project import DrawnRoutine, Project, read_project
from clickgen.click.read.rungs import import_rung
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.read import TableUnreadable, read_table
from clickgen.workspace import CouldNotRun

WIDTH = 31
SPAN = re.compile(r"Span\([^)]*\)")
END = [["-"] * WIDTH + ["end()"]]
RETURN = [["-"] * WIDTH + ["return()"]]
NICKNAMES = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\nC1,BIT,Start,0,0,\n"

Rung = tuple[str, list[list[str]]]


def row(*cells: str, out: str = "") -> list[str]:
    """One row, its wire led on to the output."""
    return [*cells, *(["-" if out else ""] * (WIDTH - len(cells))), out]


def sets(bit: str, by: str = "X001") -> list[list[str]]:
    return [row(by, out=f"out({bit})")]


def calls(*names: str) -> list[Rung]:
    return [("", [row(out=f'call("{name}")')]) for name in names]


EITHER: list[list[str]] = [row("X001", "T", out="out(C1)"), row("~X002", "-")]
MAIN: list[Rung] = [("Start\n  either way", EITHER), *calls("Heat"), ("", END)]
HEAT: list[Rung] = [("", sets("C2")), ("Back", RETURN)]


def ladder(rungs: Sequence[Rung], marker: str = "R") -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for comment, rows in rungs:
        writer.writerows(("#", line) for line in comment.split("\n") if comment)
        writer.writerows([(marker if not index else "", *cells) for index, cells in enumerate(rows)])
    return text.getvalue()


def put(folder: Path, files: dict[str, str | bytes]) -> Path:
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)
    return folder


def capture(path: Path, rungs: Sequence[Rung]) -> bytes:
    """The rungs as CLICK has them in the clipboard."""
    table = path / "capture.csv"
    table.write_text(ladder(rungs), "utf-8")
    return bytes(laddercodec.encode(laddercodec.read_csv(table)))


def every_problem(found: Project) -> list[LadderProblem]:
    return [*found.problems, *(one for routine in found.routines for rung in routine.rungs for one in rung.problems)]


def whole(path: Path) -> Project:
    found = read_project(path)
    assert not every_problem(found), list(map(str, every_problem(found)))
    return found


def names(found: Project) -> list[str]:
    return [routine.name for routine in found.routines]


def messages(path: Path) -> list[str]:
    """With the places as seen from the folder."""
    folder = path if path.is_dir() else path.parent
    return [str(problem).replace(f"{folder}{os.sep}", "") for problem in every_problem(read_project(path))]


def shape(rungs: Sequence[DrawnRung]) -> list[object]:
    """The rungs without their places."""
    rows = [[(*map(drawn, line.squares), line.output) for line in rung.rows] for rung in rungs]
    return [(rung.number, rung.comment, rung.boxes, row) for rung, row in zip(rungs, rows, strict=True)]


def drawn(square: Square) -> tuple[bool, bool, str]:
    return square.right, square.down, SPAN.sub("", repr(square.contact))


def refused(path: Path) -> str:
    with pytest.raises(CouldNotRun) as caught:
        read_project(path)
    return str(caught.value)


# -- bundles ----------------------------------------------------------------------------------------------------------


def test_a_bundle_is_main_and_its_subroutines(tmp_path: Path) -> None:
    files: dict[str, str | bytes] = {"main.csv": ladder(MAIN), "subroutines/Heat.csv": ladder(HEAT)}
    put(tmp_path, {**files, "nicknames.csv": NICKNAMES, "listing.txt": "x", "readme.csv": "a,b\n"})
    found = whole(tmp_path)
    assert [(one.name, one.is_main, len(one.rungs)) for one in found.routines] == [
        ("main", True, 3),
        ("Heat", False, 2),
    ]
    assert [one.file for one in found.routines] == [
        str(tmp_path / "main.csv"),
        str(tmp_path / "subroutines" / "Heat.csv"),
    ]
    assert found.nicknames == tmp_path / "nicknames.csv"
    assert found.texts == {
        one.file: files[os.path.relpath(one.file, tmp_path).replace(os.sep, "/")] for one in found.routines
    }
    assert found.source == tmp_path
    assert [rung.comment for rung in found.routines[0].rungs] == ["Start\n  either way", "", ""]
    assert [(rung.number, rung.line) for rung in found.routines[0].rungs] == [(1, 4), (2, 6), (3, 7)]


PROGRAM = """def main():
    if c.A:
        call(a)
        call(z)
    if c.B:
        call(y)
    if True:
        end()
"""
SUBROUTINE = "\n\n@sub\ndef {0}():\n    if c.A:\n        out(c.Lamp_{0})\n    if True:\n        return\n"


def test_what_clickgen_builds_is_read(tmp_path: Path) -> None:
    put(tmp_path, {"prog.py": PROGRAM + "".join(map(SUBROUTINE.format, "zya"))})
    result = clickgen.build(tmp_path / "prog.py")
    assert result.ok, result.diagnostics
    built = put(tmp_path / "build", dict(result.files))
    assert names(whole(built)) == ["main", "z", "y", "a"]
    (built / "sources.json").unlink()
    assert names(whole(built)) == ["main", "a", "z", "y"]


def test_the_parts_of_main_follow_each_other_by_number(tmp_path: Path) -> None:
    put(tmp_path, {"main.csv": ladder([("", sets("C1"))])})
    put(tmp_path, {f"main_{number:02}.csv": ladder([("", sets(f"C{number}"))]) for number in range(2, 12)})
    [main] = whole(tmp_path).routines
    assert [rung.boxes[0].token for rung in main.rungs] == [f"out(C{number})" for number in range(1, 12)]
    assert [rung.number for rung in main.rungs] == list(range(1, 12))
    assert [rung.line for rung in main.rungs] == [2] * 11
    assert {os.path.basename(rung.file) for rung in main.rungs} > {"main.csv", "main_02.csv", "main_11.csv"}
    assert os.path.basename(main.file) == "main.csv"


def test_a_fault_in_a_later_part_knows_its_rung_in_the_routine(tmp_path: Path) -> None:
    put(tmp_path, {"main.csv": ladder(MAIN), "main_2.csv": ladder([*HEAT, ("", sets("C1", by="oops"))])})
    found = read_project(tmp_path)
    assert [rung.number for rung in found.routines[0].rungs] == [1, 2, 3, 4, 5, 6]
    [problem] = every_problem(found)
    assert (os.path.basename(problem.file), problem.row, problem.rung) == ("main_2.csv", 5, 6)
    assert str(problem).startswith(f"{tmp_path / 'main_2.csv'}:5: column A holds 'oops'")


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        (["main_2.csv", "main_4.csv"], ["main_4.csv: part 3 of main is missing"]),
        (["main_3.csv"], ["main_3.csv: part 2 of main is missing"]),
        (["main_02.csv", "main_2.csv"], ["main_2.csv: main_02.csv is the same part of main"]),
        (
            ["Heat.csv"],
            ["Heat.csv: the file is ladder and belongs to no routine: subroutines are read from subroutines/"],
        ),
        (
            ["main_1.csv"],
            ["main_1.csv: the file is ladder and belongs to no routine: subroutines are read from subroutines/"],
        ),
        (["main.clipboard.csv", ".main_2.csv", "._main.csv", "main_2.csv.bak"], []),
    ],
)
def test_what_stands_beside_main(tmp_path: Path, files: list[str], expected: list[str]) -> None:
    put(tmp_path, {name: ladder([("", sets("C1"))]) for name in ["main.csv", *files]})
    assert messages(tmp_path) == expected


def test_tables_that_are_no_ladder_lie_there_in_peace(tmp_path: Path) -> None:
    put(
        tmp_path,
        {
            "main.csv": ladder(MAIN),
            "export.csv": NICKNAMES,
            "recipe.csv": "1;2;3\n",
            "empty.csv": b"",
            "x.csv": b"\xff\0",
        },
    )
    assert whole(tmp_path).nicknames is None


def test_names_of_a_folder_from_windows(tmp_path: Path) -> None:
    put(tmp_path, {"Main.CSV": ladder(MAIN), "MAIN_2.Csv": ladder(HEAT[:1]), "NickNames.CSV": NICKNAMES})
    put(tmp_path, {"Subroutines/Heat Up-2.CSV": ladder(HEAT)})
    found = whole(tmp_path)
    assert names(found) == ["main", "Heat Up-2"]
    assert len(found.routines[0].rungs) == 4
    assert found.nicknames is not None
    assert found.nicknames.name == "NickNames.CSV"


def test_two_files_of_one_subroutine(tmp_path: Path) -> None:
    put(
        tmp_path, {"main.csv": ladder(MAIN), "subroutines/Heat.csv": ladder(HEAT), "subroutines/Heat.CSV": ladder(HEAT)}
    )
    if len(list((tmp_path / "subroutines").iterdir())) == 2:
        [message] = messages(tmp_path)
        assert message == "subroutines/Heat.csv: subroutines/Heat.CSV has the same name".replace("/", os.sep)


def test_a_subroutine_called_main_is_not_main(tmp_path: Path) -> None:
    put(tmp_path, {"main.csv": ladder(MAIN), "subroutines/main.csv": ladder(HEAT)})
    assert [(one.name, one.is_main) for one in whole(tmp_path).routines] == [("main", True), ("main", False)]


def test_copies_of_laddercodec_are_no_subroutines(tmp_path: Path) -> None:
    copies = {"subroutines/Heat.clipboard.csv": ladder(HEAT), "subroutines/Cool.clipboard.csv": ladder(HEAT)}
    put(tmp_path, {"main.csv": ladder(MAIN), "subroutines/Heat.csv": ladder(HEAT), **copies})
    assert names(whole(tmp_path)) == ["main", "Heat", "Cool.clipboard"]


# -- the order of a bundle --------------------------------------------------------------------------------------------


def ordered(folder: Path, sources: str | bytes | None = None) -> list[str]:
    main = [*calls("c", "a"), ("", [row("X001", "T", out='call("c")'), row("", "-", out='call("B")')]), ("", END)]
    put(folder, {"main.csv": ladder(main)})
    put(folder, {f"subroutines/{name}.csv": ladder(HEAT) for name in ("a", "b", "c", "d", "Z")})
    if sources is not None:
        put(folder, {"sources.json": sources})
    return names(whole(folder))


BY_CALLS = ["main", "c", "a", "b", "Z", "d"]


def test_without_a_source_map_main_says_the_order(tmp_path: Path) -> None:
    assert ordered(tmp_path) == BY_CALLS


def test_a_source_map_says_the_order(tmp_path: Path) -> None:
    routines: dict[str, list[object]] = {name: [] for name in ("main", "d", "c", "b", "a", "Z")}
    assert ordered(tmp_path, json.dumps({"generator": "clickgen", "routines": routines})) == [*routines]


@pytest.mark.parametrize(
    "sources",
    [
        b"",
        b"\xff\xfe",
        b"[" * 100_000,
        b"[]",
        b'{"generator": "clickgen"}',
        b'{"generator": "clickgen", "routines": ["main", "a", "b", "c", "d", "Z"]}',
        b'{"generator": "clickgen", "routines": {"main": [], "d": [], "c": [], "b": [], "a": []}}',
        b'{"generator": "clickgen", "routines": {"main": [], "d": [], "c": [], "b": [], "a": [], "Z": [], "y": []}}',
        b'{"generator": "other", "routines": {"main": [], "d": [], "c": [], "b": [], "a": [], "Z": []}}',
    ],
)
def test_a_source_map_of_something_else_does_not(tmp_path: Path, sources: bytes) -> None:
    assert ordered(tmp_path, sources) == BY_CALLS


# -- one ladder file --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "rungs", "expected"),
    [
        ("plant.csv", MAIN, ("main", True)),
        ("plant.csv", [("", sets("C1"))], ("main", True)),
        ("plant.csv", HEAT + MAIN, ("main", True)),
        ("Heat.csv", HEAT, ("Heat", False)),
        ("main.csv", HEAT, ("main", True)),
        ("Main_2.CSV", HEAT, ("main", True)),
        ("Heat.clipboard.csv", HEAT, ("Heat", False)),
        ("heat (copy 2) of the old plant.csv", HEAT, ("heat _copy 2_ of the old", False)),
        ("äöü.txt", HEAT, ("___", False)),
        ("subroutines/Heat.csv", MAIN, ("Heat", False)),
        ("Subroutines/main.clipboard.csv", HEAT, ("main", False)),
    ],
)
def test_a_file_alone_is_main_or_says_otherwise(
    tmp_path: Path, name: str, rungs: list[Rung], expected: tuple[str, bool]
) -> None:
    put(tmp_path, {name: ladder(rungs), "nicknames.csv": NICKNAMES})
    found = whole(tmp_path / name)
    [routine] = found.routines
    assert (routine.name, routine.is_main) == expected
    assert found.nicknames is None
    assert [*found.texts] == [routine.file] == [str(tmp_path / name)]


def test_the_folder_of_a_file_is_known_from_inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(put(tmp_path / "subroutines", {"Heat.csv": ladder(MAIN)}))
    assert names(whole(Path("Heat.csv"))) == ["Heat"]


def test_byte_order_mark_line_ends_and_numbered_markers(tmp_path: Path) -> None:
    plain, rich = ladder(MAIN), "\ufeff\r\n" + ladder(MAIN, "R17").replace("\n", "\r\n")
    put(tmp_path, {"a.csv": plain, "b.csv": rich})
    [a], [b] = whole(tmp_path / "a.csv").routines, whole(tmp_path / "b.csv").routines
    assert shape(a.rungs) == shape(b.rungs)


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (
            ladder(MAIN).replace("Start", "Start at 20 °C").encode("cp1252"),
            ["a.csv:2: the file is not UTF-8 text: byte 0xB0"],
        ),
        (ladder(MAIN).replace(",", ";"), ["a.csv:1: the header of a ladder file is marker,A,...,AF"]),
        (
            ladder(MAIN).replace("Start", '"' + "x" * 200_000),
            [
                "a.csv:2: the quotes of this line do not fit, or the file is cut off here"
                " (field larger than field limit (131072))"
            ],
        ),
        (
            ladder(MAIN).replace("X001,T,-", "X001,T"),
            ["a.csv:4: the line has 32 columns, not 33: is it cut off?"],
        ),
        (ladder(MAIN) + "#,more\n", ["a.csv:8: a comment at the end belongs to no rung"]),
        (ladder([]), []),
    ],
    ids=["encoding", "semicolons", "huge", "columns", "comment", "empty"],
)
def test_damage_is_told_with_its_line(tmp_path: Path, content: str | bytes, expected: list[str]) -> None:
    put(tmp_path, {"a.csv": content})
    assert messages(tmp_path / "a.csv") == expected
    put(tmp_path / "bundle", {"main.csv": content})
    assert messages(tmp_path / "bundle") == [message.replace("a.csv", "main.csv") for message in expected]


def archived(members: dict[str, bytes]) -> bytes:
    """A zip archive, packed so that its members cannot be read from outside."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return data.getvalue()


OTHERS = [
    (b"", "empty"),
    (b"\xef\xbb\xbf\r\n \n", "empty"),
    (bytes(5000), "empty"),
    (NICKNAMES.encode(), "a nickname table, not ladder"),
    (
        b"\xef\xbb\xbf" + NICKNAMES.replace("Address,Data Type", '"Address","Data Type"').encode(),
        "a nickname table, not",
    ),
    (b"PK\x03\x04" + bytes(100), "a workbook or an archive, not ladder"),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "a workbook or an archive, not ladder"),
    (b"M\x08t\0" + bytes(100) + b"PK\x03\x04 scp.bin.zi", "a project of CLICK, which only CLICK opens"),
    (b"SC-PRJ  \x01\x00" + bytes(100), "a project of CLICK, which only CLICK opens"),
    (archived({"SC-PRJ": b"x" * 99}), "a project of CLICK, which only CLICK opens"),
    (archived({"SC-PRJ": b"x" * 99, "scp.bin.zi": b"y"}), "a project of CLICK, which only CLICK opens"),
    (archived({"data.bin": b"SC-PRJ  " + b"x" * 99}), "a project of CLICK, which only CLICK opens"),
    (archived({"data.bin": b"x" * 99}), "a workbook or an archive, not ladder"),
    (b"def main():\n    pass  # SC-PRJ and scp.bin.zi\n", "no ladder: its first line is not"),
    (ladder(MAIN).encode("utf-16"), "UTF-16 text, and a ladder file UTF-8"),
    (b"\x7fELF\x00\x01", "neither text nor anything that CLICK makes"),
    (b"def main():\n", "no ladder: its first line is not marker,A,...,AF"),
    (b'"' * 9000, "no ladder: its first line is not marker,A,...,AF"),
]


@pytest.mark.parametrize(("content", "expected"), OTHERS)
def test_what_is_no_ladder(tmp_path: Path, content: bytes, expected: str) -> None:
    """Alone there is nothing to read; in the place of a routine it is a problem."""
    put(tmp_path, {"x.csv": content, "bundle/main.csv": ladder(MAIN), "bundle/subroutines/Heat.csv": content})
    message = refused(tmp_path / "x.csv")
    assert message.startswith(f"{tmp_path / 'x.csv'} is {expected}")
    assert message.endswith("a folder with main.csv, or with the Scr*.tmp files of a project")
    [told] = messages(tmp_path / "bundle")
    assert told.startswith(f"subroutines{os.sep}Heat.csv:1: the file is {expected}")


@pytest.mark.parametrize("content", [b"anything", bytes(40), archived({"SC-PRJ": b"x"}), b""])
def test_a_project_file_of_click_is_known_by_its_name_too(tmp_path: Path, content: bytes) -> None:
    put(tmp_path, {"plant.ckp": content})
    for path in (tmp_path / "plant.ckp", tmp_path):
        message = refused(path)
        assert "only CLICK opens" in message
        assert "Scr*.tmp" in message
    with pytest.raises(TableUnreadable, match="project of CLICK, which only CLICK opens: open it there, export its"):
        read_table(tmp_path / "plant.ckp", "plant.ckp", Diagnostics())


def test_what_is_not_there(tmp_path: Path) -> None:
    put(tmp_path, {"x.csv/y.txt": "", "bundle/main.csv/z": "", "scr/Scr1.tmp": b"", "file": ""})
    assert refused(tmp_path / "nothing") == f"there is no file or folder {tmp_path / 'nothing'}"
    assert refused(tmp_path / "file" / "below") == f"there is no file or folder {tmp_path / 'file' / 'below'}"
    for folder in ("", "x.csv", "bundle", "scr"):
        message = refused(tmp_path / folder)
        assert message.startswith(
            f"{tmp_path / folder} holds neither main.csv nor a program file of CLICK; import reads a"
        )


def test_what_is_too_large(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(project, "_BYTES_MAX", 99)
    put(tmp_path, {"main.csv": ladder(MAIN)})
    size = (tmp_path / "main.csv").stat().st_size
    for path in (tmp_path, tmp_path / "main.csv"):
        assert refused(path) == f"{tmp_path / 'main.csv'} is too large for ladder ({size} bytes)"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_pipe_is_no_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "main.csv")
    assert refused(tmp_path / "main.csv") == f"{tmp_path / 'main.csv'} is no file"
    assert refused(tmp_path) == f"{tmp_path / 'main.csv'} is a pipe or a device, not a file"


def test_what_cannot_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put(tmp_path, {"main.csv": ladder(MAIN)})

    def locked(path: Path, _limit: int) -> bytes:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr("clickgen.click.read.project.read_file", locked)
    assert refused(tmp_path) == f"{tmp_path / 'main.csv'} cannot be read: Permission denied"


def test_a_name_that_is_no_text(tmp_path: Path) -> None:
    path = tmp_path / os.fsdecode(b"caf\xe9.csv")
    try:
        path.write_text(ladder(MAIN), "utf-8")
    except (OSError, UnicodeError):
        pytest.skip("no such names here")
    assert whole(path).routines[0].file.encode().endswith("caf\ufffd.csv".encode())


# -- captures and program files ---------------------------------------------------------------------------------------


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


# -- damage -----------------------------------------------------------------------------------------------------------


def sources(folder: Path) -> Iterator[tuple[str, bytes]]:
    yield "x.csv", ladder(HEAT + MAIN).encode()
    yield "x.bin", capture(folder, MAIN)
    yield "one.bin", capture(folder, [("Alone", EITHER)])
    yield "x.scr", program_file("Heat", 2, HEAT + MAIN)


def found_in(path: Path) -> tuple[list[DrawnRoutine], bool]:
    """The routines, and whether a problem is told of them."""
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
        if not is_told:  # a text may end behind any line
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
        # A box of which a part is gone becomes one that nobody knows.
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
