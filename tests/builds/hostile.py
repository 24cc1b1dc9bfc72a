"""Repositories laid out by somebody else."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from clickgen.cli import main

posix_only = pytest.mark.skipif(os.name != "posix", reason="about POSIX links, pipes and devices")


GOOD = """\
def main():
    if c.Start:
        out(y[1])
    if True:
        call(wash)
    if True:
        end()


@sub
def wash():
    if c.Start:
        out(y[2])
    if True:
        return
"""


DOUBLE = "def main():\n    if c.A:\n        out(y[1])\n    if c.B:\n        out(y[1])\n    if True:\n        end()\n"


MENDED = "def main():\n    if c.A and c.B:\n        out(y[1])\n    if True:\n        end()\n"


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository to work in, beside a folder that is not part of it."""
    (tmp_path / "repository").mkdir()
    (tmp_path / "outside").mkdir()
    monkeypatch.chdir(tmp_path / "repository")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "cache"))
    Path("prog.py").write_text(GOOD)
    return tmp_path


def outside(place: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in (place / "outside").iterdir()}


def check(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str]:
    code = main(["check", "--output-format", "concise", *arguments])
    return code, capsys.readouterr().out
