"""A bundle or a ladder file: the order of routines, and damage that is reported."""

from __future__ import annotations

import io
import json
import os
import zipfile
from pathlib import Path

import pytest
from ladder_sources import (
    END,
    HEAT,
    MAIN,
    NICKNAMES,
    Rung,
    calls,
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

import clickgen
from clickgen.click.read import project
from clickgen.click.read.project import read_project
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.read import TableUnreadable, read_table

# -- bundles -----------------------------------------------------------------------------------------------------------


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


# -- the order of a bundle ---------------------------------------------------------------------------------------------


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


# -- one ladder file ---------------------------------------------------------------------------------------------------


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
    """Alone there is nothing to read; in place of a routine it is a problem."""
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

    def locked(path: str, _size: int) -> bytes:
        raise PermissionError(13, "Permission denied", path)

    monkeypatch.setattr("clickgen.workspace.read_start", locked)
    assert refused(tmp_path) == f"{tmp_path / 'main.csv'} cannot be read: Permission denied"


def test_a_name_that_is_no_text(tmp_path: Path) -> None:
    path = tmp_path / os.fsdecode(b"caf\xe9.csv")
    try:
        path.write_text(ladder(MAIN), "utf-8")
    except (OSError, UnicodeError):
        pytest.skip("no such names here")
    assert whole(path).routines[0].file.encode().endswith("caf\ufffd.csv".encode())
