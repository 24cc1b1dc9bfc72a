"""The road is straight: a room imports only rooms before it, and heavy libraries load where they are used."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "clickgen"
BELOW = (
    "wording",
    "formats",
    "codes",
    "workspace",
    "source",
    "suggest",
    "diagnostics",
    "spelling",
    "fixing",
    "device",
    "trade",
    "config",
    "instructions",
    "dsl",
)
ROAD = (
    "ir",
    "formula",
    "syntax",
    "resolve",
    "check",
    "lower",
    "fixes",
    "emit",
    "ladder",
    "comparing",
    "results",
    "pipeline",
    "api",
    "stubs",
    "importing",
    "checking",
    "nicknames",
    "diffing",
    "explain",
    "report",
    "cli",
)
"""syntax and formula make what ir declares; so ir comes first, and only its walkers look into formulas."""
EXCEPTIONS = {("ir", "formula")}
HEAVY = {"libcst", "lark", "openpyxl", "laddercodec"}
"""libcst is loaded by what really reads a program, and by nothing else."""


def room_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return parts[0]


def imported_rooms(path: Path) -> set[str]:
    rooms = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        names: list[str] = []
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        rooms |= {name.split(".")[1] for name in names if name.startswith("clickgen.")}
    return rooms & {*BELOW, *ROAD}


FILES = sorted(path for path in PACKAGE.rglob("*.py") if room_of(path) in (*BELOW, *ROAD))


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_a_room_imports_only_rooms_before_it(path: Path) -> None:
    order = (*BELOW, *ROAD)
    room = room_of(path)
    wrong = {
        other
        for other in imported_rooms(path)
        if order.index(other) > order.index(room) and (room, other) not in EXCEPTIONS
    }
    assert not wrong, f"{room} must not import {wrong}"


def test_device_knows_no_stage() -> None:
    for path in (PACKAGE / "device").rglob("*.py"):
        assert not imported_rooms(path) & {*ROAD, "instructions"}, path


def test_building_a_program_without_formulas_loads_no_lark(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text("def main():\n    if c.A:\n        out(c.B)\n    if True:\n        end()\n")
    other = HEAVY - {"libcst"}
    code = f"import sys, clickgen\nassert clickgen.build('prog.py').ok\nprint(sorted(set(sys.modules) & {other!r}))"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_a_check_out_of_the_cache_loads_only_what_it_needs(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text("def main():\n    if x[1]:\n        out(y[1])\n    if True:\n        end()\n")
    slow = ["dataclasses", "inspect", "clickgen.pipeline", "clickgen.problems.report.frames", *HEAVY]
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
