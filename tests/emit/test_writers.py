"""Writers are a registry: an output that no other file knows is built, noted, and cleaned up."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

import clickgen
import clickgen.emit
from clickgen.cli import main
from clickgen.emit import registry
from clickgen.emit.built import BuiltProgram
from clickgen.emit.writer import Writer, one_file

WRITER = """
import re

from clickgen.emit.writer import Writer

HEAD = b"rungs: "

WRITER = Writer(
    paths=lambda built: (f"counts/{routine.name}.txt" for routine in built.routines),
    write=lambda built, path: "rungs: " + path + "\\n",
    owns=re.compile(r"counts/[^/]+\\.txt"),
    is_own=lambda data: data.startswith(HEAD),
    folders=("counts",),
)
"""
PROGRAM = """\
@sub
def wash():
    if True:
        out(y[1])
    if True:
        return


def main():
    if True:
        call(wash)
    if True:
        end()
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder with a program, while ``emit`` has one writer more."""
    (tmp_path / "more").mkdir()
    (tmp_path / "more" / "counts_of_rungs.py").write_text(WRITER)
    monkeypatch.setattr(clickgen.emit, "__path__", [*clickgen.emit.__path__, str(tmp_path / "more")])
    registry.writers.cache_clear()
    (tmp_path / "plant").mkdir()
    monkeypatch.chdir(tmp_path / "plant")
    Path("prog.py").write_text(PROGRAM)
    yield tmp_path / "plant"
    registry.writers.cache_clear()


OUT = Path("build/prog")


def noted() -> list[str]:
    files = json.loads((OUT / "sources.json").read_text("utf-8"))["files"]
    assert isinstance(files, list)
    return files


@pytest.mark.usefixtures("folder")
def test_a_new_writer_is_one_file() -> None:
    result = clickgen.build("prog.py")
    assert result.files["counts/wash.txt"] == "rungs: counts/wash.txt\n"
    assert main(["build", "prog.py"]) == 0
    assert (OUT / "counts" / "wash.txt").read_text() == "rungs: counts/wash.txt\n"
    assert {"counts/main.txt", "counts/wash.txt"} <= {*noted()}
    assert noted()[-1] == "sources.json"
    assert result.write(OUT) == []


@pytest.mark.usefixtures("folder")
def test_what_a_new_writer_no_longer_makes_is_removed() -> None:
    assert main(["build", "prog.py"]) == 0
    Path("prog.py").write_text(PROGRAM.replace("wash", "rinse"))
    assert main(["build", "prog.py"]) == 0
    assert sorted(path.name for path in (OUT / "counts").iterdir()) == ["main.txt", "rinse.txt"]


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("is_noted", [True, False], ids=["noted", "not noted"])
def test_a_file_of_a_person_stays_where_a_new_writer_works(is_noted: bool) -> None:
    assert main(["build", "prog.py"]) == 0
    mine = OUT / "counts" / "mine.txt"
    mine.write_text("mine" if is_noted else "rungs: mine")
    if is_noted:
        text = (OUT / "sources.json").read_text("utf-8")
        (OUT / "sources.json").write_text(text.replace('"files": [', '"files": ["counts/mine.txt", '))
    Path("prog.py").write_text(PROGRAM.replace("wash", "rinse"))
    assert main(["build", "prog.py"]) == 0
    assert mine.exists()
    assert not (OUT / "counts" / "wash.txt").exists()


@pytest.mark.usefixtures("folder")
def test_a_new_writer_takes_no_file_of_a_person(capsys: pytest.CaptureFixture[str]) -> None:
    (OUT / "counts").mkdir(parents=True)
    (OUT / "counts" / "wash.txt").write_text("mine")
    assert main(["build", "prog.py"]) == 2
    assert "counts/wash.txt" in capsys.readouterr().err
    assert (OUT / "counts" / "wash.txt").read_text() == "mine"


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    "name", ["../counts.txt", "counts/../../counts.txt", "counts/..", "./listing.txt", "/counts.txt", "counts/\0.txt"]
)
def test_a_forged_map_leads_to_no_file_outside_of_the_folder(name: str, folder: Path) -> None:
    assert main(["build", "prog.py"]) == 0
    outside = [folder / "counts.txt", folder / "build" / "counts.txt"]
    for path in outside:
        path.write_text("rungs: mine")
    text = (OUT / "sources.json").read_text("utf-8")
    (OUT / "sources.json").write_text(text.replace('"files": [', f'"files": [{json.dumps(name)}, '))
    assert main(["build", "prog.py"]) == 0
    assert all(path.exists() for path in outside)
    assert (OUT / "listing.txt").exists()


def test_every_output_of_a_program_belongs_to_one_writer(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text(PROGRAM)
    result = clickgen.build(tmp_path / "prog.py")
    for path, text in result.files.items():
        owners = [writer for writer in registry.writers() if writer.owns.fullmatch(path)]
        assert len(owners) == 1, path
        assert owners[0].is_own(text.encode()), path


def test_a_text_is_made_when_it_is_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[str] = []

    def note(path: str) -> Writer:
        def write(_: BuiltProgram) -> str:
            made.append(path)
            return path

        return one_file(path, write, lambda _: True)

    monkeypatch.setattr(registry, "writers", lambda: (note("one.txt"), note("other.txt")))
    (tmp_path / "prog.py").write_text(PROGRAM)
    files = clickgen.build(tmp_path / "prog.py").files
    assert (len(files), sorted(files), made) == (2, ["one.txt", "other.txt"], [])
    assert files["one.txt"] == files["one.txt"] == "one.txt"
    assert made == ["one.txt"]


def test_no_module_but_its_own_names_a_writer() -> None:
    """The pipeline and the output folder ask the registry."""
    package = Path(clickgen.__file__).parent
    for path in (package / "pipeline.py", package / "emit" / "folder.py", package / "emit" / "registry.py"):
        text = path.read_text("utf-8")
        found = [word for word in ("listing", "nickname_csv", "ladder_csv", "emit.ladder", "workbook") if word in text]
        assert not [word for word in found if f"emit.{word}" in text or f"import {word}" in text], path
