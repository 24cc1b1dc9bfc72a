"""The floor plan: a room imports only rooms below it, and heavy libraries load where they are used."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "clickgen"
FLOORS = (
    "records",
    "workspace",
    "text",
    "problems",
    "device",
    "instructions",
    "ir",
    "table",
    "config",
    "logic",
    "formula",
    "dialects.base",
    "dialects",
    "resolve",
    "facts",
    "rules",
    "click.draw",
    "lower",
    "click",
    "emit",
    "fixes",
    "click.read",
    "rules.errors",
    "rules.lowered",
    "rules.advice",
    "click.compare",
    "pipeline",
    "results",
    "api",
    "emit.workbook",
    "commands.check",
    "commands.explain",
    "problems.report",
    "commands.nicknames",
    "commands.diff",
    "commands.workbook",
    "commands.import_",
    "commands.stubs",
    "dialects.if_rungs",
    "cli",
    "start",
    "dsl",
)
"""The rooms from the ground up, each by its dotted name: a room knows nothing of those above it.

A module belongs to the room with the longest name here: ``click.read`` is one, and ``click`` is the rest of that
folder.
"""
LINES_MAX = 400
LONG = {
    "dialects.if_rungs.read.conditions",
    "dialects.if_rungs.read.program",
    "rules.advice.undone_toggle",
}
"""Files that should be divided. The list only shrinks."""
HEAVY = {"libcst", "lark", "openpyxl", "laddercodec"}


def name_of(path: Path) -> str:
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix(".__init__")


def room_of(name: str) -> str:
    """The room of a module; "" for one that no floor has."""
    return max((room for room in FLOORS if f"{name}.".startswith(f"{room}.")), key=len, default="")


def imported_rooms(path: Path) -> set[str]:
    rooms = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        names: list[str] = []
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        rooms |= {room_of(name.removeprefix("clickgen.")) for name in names if name.startswith("clickgen.")}
    return rooms - {""}


FILES = sorted(path for path in PACKAGE.rglob("*.py") if path.parent != PACKAGE or not path.name.startswith("__"))


def test_every_module_is_on_a_floor() -> None:
    empty = {name_of(path) for path in FILES if path.name == "__init__.py"}
    lost = {name for name in map(name_of, FILES) if not room_of(name)}
    # Folders that only hold rooms have nothing of their own.
    assert lost == {"commands"} & empty


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_a_room_imports_only_rooms_below_it(path: Path) -> None:
    room = room_of(name_of(path))
    if not room:
        return
    wrong = {other for other in imported_rooms(path) if FLOORS.index(other) > FLOORS.index(room)}
    assert not wrong, f"{room} must not import {wrong}"


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_a_file_is_short_enough_to_be_read(path: Path) -> None:
    lines = len(path.read_text("utf-8").splitlines())
    assert (lines > LINES_MAX) is (name_of(path) in LONG), f"{path} has {lines} lines"


def test_only_the_registry_names_a_dialect() -> None:
    folders = {path.parent.name for path in (PACKAGE / "dialects").glob("*/__init__.py")}
    for path in FILES:
        own = name_of(path).split(".")
        others = {name for name in folders if own[:2] != ["dialects", name]}
        text = path.read_text("utf-8")
        named = {name for name in others if f'"{name}"' in text or f"dialects.{name}" in text}
        if own == ["dialects", "registry"]:
            assert named == folders
        else:
            assert not named, f"{path} names {named}: it gets its dialect from the registry"


def test_to_choose_a_dialect_loads_none_of_its_readers(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text("def main():\n    if c.A:\n        out(c.B)\n")
    code = (
        "import sys\nfrom pathlib import Path\nfrom clickgen.config import Config\n"
        "from clickgen.dialects.discover import targets\n"
        "assert [one.path for one in targets(['.'], Config(Path('.')))] == ['prog.py']\n"
        f"print(sorted(set(sys.modules) & { ({'dataclasses', *HEAVY})!r}))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_device_knows_no_stage() -> None:
    for path in (PACKAGE / "device").rglob("*.py"):
        assert not imported_rooms(path) & {room for room in FLOORS if FLOORS.index(room) > FLOORS.index("device")}, path


def test_building_a_program_without_formulas_loads_no_lark(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text("def main():\n    if c.A:\n        out(c.B)\n    if True:\n        end()\n")
    other = HEAVY - {"libcst"}
    code = f"import sys, clickgen\nassert clickgen.build('prog.py').ok\nprint(sorted(set(sys.modules) & {other!r}))"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_a_check_out_of_the_cache_loads_only_what_it_needs(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text("def main():\n    if x[1]:\n        out(y[1])\n    if True:\n        end()\n")
    own = ["clickgen.pipeline", "clickgen.rules.registry", "clickgen.problems.report.frames"]
    slow = ["dataclasses", "inspect", *own, *HEAVY]
    code = (
        f"import sys\nfrom clickgen.cli import main\nassert main(['check', 'prog.py', '-q', '-o', 'report.txt']) == 0\n"
        f"print(sorted(set(sys.modules) & {set(slow)!r}))"
    )
    runs = [
        subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
        for _ in range(2)
    ]
    assert "clickgen.pipeline" in runs[0]
    assert runs[1] == "[]\n"
