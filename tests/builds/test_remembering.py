"""What is remembered changes no result: programs are edited, and read each time with the memory and without it.

The cold run knows nothing of earlier ones. After each step both must give the same bytes, problems and trees.
"""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st
from strategies.edits import Draft, edit, numbers_from, pieces
from strategies.mutations import CHANGES, mutated

import clickgen
from clickgen.api import build, check
from clickgen.config import Settings
from clickgen.device.banks import Address
from clickgen.ir.data import to_data
from clickgen.results import BuildResult
from clickgen.workspace import Workspace, memory
from clickgen.workspace.memory import FOLDER, Memory

HEAD = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
ROWS = (
    'C40,BIT,"Bit0",0,No,"a row"',
    'C41,BIT,"Bit1",1,Yes,""',
    'DS40,INT,"Word_2",5,No,""',
    'C2000,BIT,"Top",0,No,""',
    'DS40,INT,"Word_3",5,No,"an address twice"',
)
SETTINGS = (
    Settings(),
    Settings(frozen=True),
    Settings(reserved=tuple(Address("C", number) for number in range(1, 30))),
)


@pytest.fixture(autouse=True)
def _own_secret(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


def everything(settings: Settings, memory: Memory) -> tuple[object, ...]:
    """All that a build and a check of the program in this folder tell."""
    files = Workspace(memory=memory)
    built = build("prog.py", settings=settings, workspace=files)
    memory.save()
    # The second reading may find what the first has left.
    checked = check("prog.py", settings, Workspace(memory=memory))
    memory.save()
    return dict(built.files), built.table, built.diagnostics, _tree(built), checked.diagnostics, checked.reads


def _tree(built: BuildResult) -> object:
    """The resolved program with every place in it, as data."""
    if built.facts is None:
        return None
    program = built.facts.program
    by_path = {source.path: source for source in built.sources}
    return [
        [to_data(item, by_path[item.span.path], 0) for item in items]
        for items in (program.routines, program.declarations, program.blocks)
    ]


def damage(chance: random.Random) -> None:
    """Do something to the files of the memory."""
    files = sorted(path for path in Path(FOLDER).glob("*.json"))
    if not files:
        return
    path, other = chance.choice(files), chance.choice(files)
    data = path.read_bytes()
    at = chance.randrange(len(data) + 1)
    path.write_bytes(
        chance.choice(
            (
                b"",
                data[:at],
                data[:at] + bytes([chance.randrange(256)]) + data[at + 1 :],
                data[at:],
                other.read_bytes(),
                data.replace(b'"C', b'"Y'),
                data.split(b"\n", 1)[0] + b"\n{}",
            )
        )
    )


@examples(25)
@given(st.data())
def test_a_remembered_build_is_the_same_as_a_cold_one(data: st.DataObject) -> None:
    draw = data.draw
    numbers = numbers_from(100)
    draft = Draft([draw(pieces(numbers)) for _ in range(draw(st.integers(1, 4)))])
    with tempfile.TemporaryDirectory() as folder, pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        rows: list[str] = []
        settings = SETTINGS[0]
        for _ in range(draw(st.integers(2, 5))):
            texts = draft.texts()
            kind = draw(st.sampled_from(["edit", "mutate", "shift", "table", "settings", "version", "damage", "same"]))
            if kind == "edit":
                edit(data, draft, numbers)
                texts = draft.texts()
            elif kind == "mutate":
                name = draw(st.sampled_from(sorted(texts)))
                change = draw(st.sampled_from(sorted(CHANGES)))
                texts[name] = mutated(texts[name], change, draw(st.integers(0, 99)))
            elif kind == "shift":
                lines = draw(st.sampled_from(["\n\n", "# a comment\n", "# Prüfung\n\n", "\r\n", "LIMIT = 5\n"]))
                texts = {name: lines + text for name, text in texts.items()}
            elif kind == "table":
                rows = draw(st.lists(st.sampled_from(ROWS), unique=True))
            elif kind == "settings":
                settings = draw(st.sampled_from(SETTINGS))
            elif kind == "version":
                state = draw(st.integers(0, 3))
                patch.setattr(memory, "own_state", lambda state=state: str(state))
            elif kind == "damage":
                damage(random.Random(draw(st.integers(0, 999))))
            for name, text in texts.items():
                Path(name).write_text(text, "utf-8", newline="")
            Path("nicknames.csv").write_text(HEAD + "".join(f"{row}\n" for row in rows))
            assert everything(settings, Memory(folder)) == everything(settings, Memory())


def example(name: str) -> str:
    return (Path(__file__).parents[2] / "fixtures" / "cases" / name / "prog.py").read_text("utf-8")


CASES = sorted(path.parent.name for path in (Path(__file__).parents[2] / "fixtures" / "cases").glob("*/prog.py"))


@pytest.mark.parametrize("name", CASES)
def test_every_case_is_built_out_of_the_memory(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second time, libcst reads nothing of a program without problems of its text."""
    place = tmp_path / "case"
    place.mkdir()
    for file in (Path(__file__).parents[2] / "fixtures" / "cases" / name).glob("*.*"):
        (place / file.name).write_bytes(file.read_bytes())
    monkeypatch.chdir(place)
    cold = everything(SETTINGS[0], Memory())
    first = everything(SETTINGS[0], Memory(place))
    again = everything(SETTINGS[0], Memory(place))
    assert cold == first == again


GOOD = 'def main():\n    if c.A:\n        calc("ds.In + 1", ds.Out)\n    if True:\n        end()\n'


def loaded(tmp_path: Path) -> str:
    """The parsers that a build in a process of its own loads."""
    code = (
        "import sys\nfrom clickgen.cli import main\nassert main(['build', 'prog.py']) == 0\n"
        "print(sorted({'libcst', 'lark', 'ast'} & set(sys.modules)), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    return done.stderr.strip().splitlines()[-1]


def test_no_parser_is_loaded_for_what_is_remembered(tmp_path: Path) -> None:
    place = tmp_path / "repository"
    place.mkdir()
    (place / "prog.py").write_text(GOOD)
    assert "libcst" in loaded(place)
    (place / "nicknames.csv").write_text(HEAD + 'DS7,INT,"In",0,No,""\n')
    assert not {"libcst", "lark"} & set(json.loads(loaded(place).replace("'", '"')))
    assert "DS7" in (place / "build" / "prog" / "main.csv").read_text()
    (place / "prog.py").write_text(GOOD.replace("+ 1", "+ 2"))
    assert "libcst" in loaded(place)


def test_only_what_has_no_problem_is_remembered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("prog.py").write_text(GOOD.replace("end()", "end(5)"))
    said = [everything(SETTINGS[0], Memory(tmp_path))[2] for _ in range(3)]
    assert said[0] == said[1] == said[2] != ()


def test_nothing_is_written_without_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("prog.py").write_text(GOOD)
    assert clickgen.build("prog.py").ok
    assert os.listdir() == ["prog.py"]
