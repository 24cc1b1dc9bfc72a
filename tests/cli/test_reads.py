"""Every command reads each file of the project once, however many parts of it ask for that file."""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from types import FrameType

import pytest

from clickgen.cli import main

PROGRAM = """\
from heat import heat

nickname(ds.Speed, ds[5], initial=10, retentive=False)


def main():
    # The motor
    if all(c.Start, nc(x[1])):
        out(c.Motor)
        call(heat)

    if True:
        end()
"""
HEAT = """\
@sub
def heat():
    if c.Start:
        copy(ds.Speed, ds.Out)

    if True:
        return
"""
SETTINGS = """\
programs = ["plc.py", { path = "other.py", nicknames = "nicknames.csv" }]
"""

_BEFORE_WRITING = ("emit/delivery.py deliver", "commands/import_/project.py _former")
"""Who looks again at what is about to be replaced: an import or a build may have read it long before."""
_watched: Counter[tuple[str, str]] | None = None


def _hook(event: str, arguments: tuple[object, ...]) -> None:
    if event != "open" or _watched is None or not isinstance(arguments[0], str | bytes | os.PathLike):
        return
    path, flags = os.path.realpath(os.fsdecode(arguments[0])), arguments[2]
    is_written = isinstance(flags, int) and flags & (os.O_WRONLY | os.O_RDWR)
    frames = list(_callers(sys._getframe(1)))
    # To open with an opener is two events, and the second one is counted.
    if is_written or not frames or frames[0] in ("workspace/disk.py read_file", "workspace/disk.py read_start"):
        return
    if not path.startswith(os.getcwd() + os.sep):
        return
    # While it replaces files, clickgen.text looks at the disk as it is at that very moment.
    if any(frame.startswith("text/") for frame in frames):
        return
    _watched["before writing" if any(frame in _BEFORE_WRITING for frame in frames) else "read", path] += 1


def _callers(frame: FrameType | None) -> Iterator[str]:
    """The functions of clickgen that are running, the innermost first: ``emit/delivery.py deliver``."""
    while frame is not None:
        _, is_ours, file = frame.f_code.co_filename.replace(os.sep, "/").rpartition("/clickgen/")
        if is_ours:
            yield f"{file} {frame.f_code.co_name}"
        frame = frame.f_back


sys.addaudithook(_hook)


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two programs that share a table and a file, with settings, built; and the export of one of them."""
    monkeypatch.chdir(tmp_path)
    for name, text in (("plc.py", PROGRAM), ("heat.py", HEAT), ("clickgen.toml", SETTINGS)):
        (tmp_path / name).write_text(text)
    (tmp_path / "other.py").write_text(
        "def main():\n    if c.Motor:\n        out(c.Lamp)\n\n    if True:\n        end()\n"
    )
    assert main(["build"]) == 0
    export = (tmp_path / "build" / "plc" / "nicknames.csv").read_text()
    (tmp_path / "export.csv").write_text(export.replace("Lamp", "Light"))
    return tmp_path


COMMANDS = (
    "build",
    "build plc.py",
    "check",
    "check plc.py --no-cache --baseline known.json",
    "check plc.py --fix",
    "diff build/plc build/other",
    "diff plc.py build/plc",
    "explain CG101",
    "import build/plc -o imported/plc.py",
    "import build/plc/main.csv -o main/",
    "nicknames check",
    "nicknames check plc.py",
    "nicknames merge export.csv",
    "nicknames merge export.csv --accept all",
    "nicknames rename Speed Tempo",
    "nicknames sync",
    "nicknames sync plc.py --prune",
    "nicknames why Speed plc.py",
    "stubs",
    "workbook plc.py -o plc.xlsx",
)


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("is_edited", [False, True], ids=["as built", "edited"])
def test_a_file_is_read_once(project: Path, command: str, is_edited: bool) -> None:
    """Also where something is to be told and written: a name is new, and one has left."""
    global _watched
    if is_edited:
        program = project / "plc.py"
        program.write_text(program.read_text().replace("c.Motor)", "c.Engine)"))
        (project / "build" / "plc" / "listing.txt").write_text("")
    _watched = Counter()
    try:
        main(command.split())
        found = _watched
    finally:
        _watched = None
    asked = {os.path.relpath(path, project) for _, path in found}
    assert asked >= ({"clickgen.toml"} if not command.startswith(("explain", "diff build")) else set())
    assert {place: count for place, count in found.items() if count > 1} == {}


def test_the_watch_sees_a_file_that_is_read_twice(project: Path) -> None:
    global _watched
    _watched = Counter()
    try:
        for _ in range(2):
            assert main(["nicknames", "why", "Speed", "plc.py"]) == 0
        assert _watched["read", str(project / "plc.py")] == 2
    finally:
        _watched = None
