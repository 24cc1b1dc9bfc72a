"""The files as one command sees them: read once, with unsaved texts over them, and noted."""

from __future__ import annotations

import ast
import os
from pathlib import Path

import pytest
from hostile import posix_only

import clickgen
from clickgen.api import build, check
from clickgen.workspace import NoRegularFile, Workspace

CLEAN = "def main():\n    if c.A:\n        out(c.B)\n    if True:\n        end()\n"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_file_is_read_once() -> None:
    Path("a").write_bytes(b"one")
    files = Workspace()
    assert files.read("a") == b"one"
    Path("a").write_bytes(b"two")
    assert files.read(os.path.abspath("a")) == b"one"
    assert files.apart().read("a") == b"one"
    assert Workspace().read("a") == b"two"


def test_what_is_not_there_stays_so() -> None:
    files = Workspace()
    assert files.look("a") is None
    Path("a").write_bytes(b"one")
    assert files.look("a") is None
    with pytest.raises(FileNotFoundError):
        files.read("a")


def test_the_overlay_counts_first_and_need_not_be_on_disk() -> None:
    Path("a").write_bytes(b"one")
    files = Workspace({os.path.realpath("a"): b"unsaved"})
    other = files.apart({os.path.realpath("new"): b"new"})
    assert (files.read("a"), other.read("a"), other.read("new")) == (b"unsaved", b"unsaved", b"new")
    assert other.has("new")
    assert not files.has("new")
    assert files.look("new") is None
    assert other.found == {}


def test_each_reader_notes_what_it_read() -> None:
    Path("a").write_bytes(b"one")
    files = Workspace()
    files.read("a")
    other = files.apart()
    other.look("b")
    assert (files.reads, other.reads) == ({"a": b"one"}, {"b": None})
    assert (files.found, other.found) == ({"a": b"one"}, {"b": None})


def test_only_a_whole_file_is_remembered() -> None:
    Path("a").write_bytes(b"abcdef")
    files = Workspace()
    assert files.start("a", 3) == b"abc"
    assert files.read("a") == b"abcdef"
    assert files.start("a", 3) == b"abc"
    with pytest.raises(OSError, match="it has more than"):
        files.read("a", 5)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such pipes")
def test_a_pipe_is_not_opened() -> None:
    os.mkfifo("pipe")
    with pytest.raises(NoRegularFile):
        Workspace().read("pipe")
    os.symlink("nowhere", "link")
    files = Workspace()
    for _ in range(2):
        with pytest.raises(FileNotFoundError):
            files.look("link")


def test_a_check_names_everything_that_it_rests_on() -> None:
    Path("prog.py").write_text(f"from lib import fill\n\n\n{CLEAN}")
    Path("lib.py").write_text("@sub\ndef fill():\n    if True:\n        return\n")
    result = check("prog.py")
    assert result.reads == {
        "prog.py": Path("prog.py").read_bytes(),
        "lib.py": Path("lib.py").read_bytes(),
        "nicknames.csv": None,
        "nicknames.placed": None,
    }


def test_a_program_is_built_from_a_text_that_is_not_saved() -> None:
    saved = build("prog.py", workspace=Workspace({os.path.realpath("prog.py"): CLEAN.encode()}))
    Path("prog.py").write_text(CLEAN)
    assert saved.files == clickgen.build("prog.py").files


def test_what_a_command_reads_goes_through_the_workspace() -> None:
    """Other modules open no file: a pipe, a device and a file without an end are refused in one place."""
    package = Path(clickgen.__file__).parent
    ours = {
        "workspace/disk.py",  # the place
        "text/write.py", "text/lock.py", "workspace/secret.py", "workspace/memory.py",  # files of clickgen
        "formula/parse.py", "device/system.py", "commands/explain.py", "problems/declared.py",  # installed with it
        "emit/workbook/archive.py", "device/project_file.py", "table/workbook/archive.py",  # parts of an archive
        "cli/__init__.py",  # the null device
    }  # fmt: skip
    found = {
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        if any(map(_opens, ast.walk(ast.parse(path.read_text("utf-8")))))
    }
    assert found <= ours, found - ours


def _opens(node: ast.AST) -> bool:
    """True for a call of ``open`` and of what pathlib has for it."""
    if not isinstance(node, ast.Call):
        return False
    if isinstance(node.func, ast.Name):
        return node.func.id == "open"
    is_method = isinstance(node.func, ast.Attribute) and node.func.attr in ("open", "read_text", "read_bytes")
    return is_method and ast.unparse(node.func) not in ("os.open", "self.read_bytes")


@posix_only
def test_a_real_path_is_that_of_the_system(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "there" / "deep").mkdir(parents=True)
    (tmp_path / "there" / "deep" / "file.py").write_text("")
    (tmp_path / "link").symlink_to(tmp_path / "there")
    (tmp_path / "there" / "own.py").symlink_to("deep/file.py")
    (tmp_path / "round").symlink_to("round")
    monkeypatch.chdir(tmp_path / "there")
    paths = (
        *("own.py", "./own.py", "deep/file.py", "../link/own.py", "../link/deep/../own.py"),
        *("", ".", "..", "/", "deep/"),
        *("nowhere.py", "nowhere/file.py", "../round", "../round/file.py", str(tmp_path / "link" / "deep" / "file.py")),
        *("a/" * 2000, "deep/../" * 600 + "own.py"),
    )
    files = Workspace()
    assert [files.real(path) for path in paths] == [os.path.realpath(path) for path in paths]
