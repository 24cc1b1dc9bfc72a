"""Several files are put in place together or not at all, whatever goes wrong and whenever."""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from clickgen.text import write
from clickgen.text.write import ChangedMeanwhile, put_in_place

Tree = dict[str, tuple[str, bytes, int] | tuple[str, str]]

posix_only = pytest.mark.skipif(os.name != "posix", reason="about POSIX file systems")


def tree(folder: Path) -> Tree:
    """Everything in a folder: content and mode of files, targets of links, and that folders are there."""
    found: Tree = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_symlink():
            found[name] = ("link", os.readlink(path))
        elif path.is_dir():
            found[name] = ("folder", "")
        else:
            found[name] = ("file", path.read_bytes(), stat.S_IMODE(path.stat().st_mode))
    return found


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """A bundle from an earlier build."""
    folder = tmp_path / "out"
    (folder / "subroutines").mkdir(parents=True)
    (folder / "main.csv").write_bytes(b"old main")
    (folder / "nicknames.csv").write_bytes(b"same")
    (folder / "subroutines" / "gone.csv").write_bytes(b"old sub")
    return folder


def plan(out: Path) -> tuple[dict[Path, bytes], list[Path]]:
    """The next build: one file changed, one unchanged, two new ones (one in new folders), one to remove."""
    writes = {
        out / "main.csv": b"new main",
        out / "nicknames.csv": b"same",
        out / "subroutines" / "fill.csv": b"new sub",
        out / "listing" / "html" / "main.html": b"new page",
    }
    return writes, [out / "subroutines" / "gone.csv"]


def test_files_are_written_kept_and_removed(out: Path) -> None:
    writes, removals = plan(out)
    before = (out / "nicknames.csv").stat()
    changed = put_in_place(writes, removals)
    assert changed == [
        out / "main.csv",
        out / "subroutines" / "fill.csv",
        out / "listing" / "html" / "main.html",
        out / "subroutines" / "gone.csv",
    ]
    for path, data in writes.items():
        assert path.read_bytes() == data
    assert sorted(path.name for path in out.rglob("*") if path.is_file()) == [
        "fill.csv", "main.csv", "main.html", "nicknames.csv"
    ]  # fmt: skip
    after = (out / "nicknames.csv").stat()
    assert (after.st_mtime_ns, after.st_ino) == (before.st_mtime_ns, before.st_ino)
    assert put_in_place(writes, removals) == []


def test_nothing_to_do_makes_no_folder(tmp_path: Path) -> None:
    assert put_in_place({}, [tmp_path / "no" / "such" / "file"], {tmp_path / "nor" / "this": None}) == []
    assert tree(tmp_path) == {}


def test_relative_paths(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(out)
    assert put_in_place({Path("main.csv"): b"new", Path("new.csv"): b"new"}, [Path("subroutines/gone.csv")]) == [
        Path("main.csv"),
        Path("new.csv"),
        Path("subroutines/gone.csv"),
    ]
    assert (out / "main.csv").read_bytes() == (out / "new.csv").read_bytes() == b"new"
    assert not (out / "subroutines" / "gone.csv").exists()


@posix_only
def test_modes(out: Path) -> None:
    (out / "main.csv").chmod(0o640)
    mask = os.umask(0o027)
    try:
        put_in_place({out / "main.csv": b"new", out / "fresh.csv": b"new"})
    finally:
        os.umask(mask)
    assert stat.S_IMODE((out / "main.csv").stat().st_mode) == 0o640
    assert stat.S_IMODE((out / "fresh.csv").stat().st_mode) == 0o640


@posix_only
def test_a_link_stays_a_link(out: Path, tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "table.csv").write_bytes(b"old")
    (out / "linked.csv").symlink_to("../real/table.csv")
    (out / "dangling.csv").symlink_to("../real/later.csv")
    put_in_place({out / "linked.csv": b"new", out / "dangling.csv": b"later"})
    assert (out / "linked.csv").is_symlink()
    assert (tmp_path / "real" / "table.csv").read_bytes() == b"new"
    assert (tmp_path / "real" / "later.csv").read_bytes() == b"later"
    put_in_place({}, [out / "linked.csv"])
    assert not (out / "linked.csv").is_symlink()
    assert (tmp_path / "real" / "table.csv").read_bytes() == b"new"


@posix_only
def test_two_ways_to_one_file(out: Path) -> None:
    (out / "alias").symlink_to("subroutines")
    before = tree(out)
    with pytest.raises(FileExistsError, match="same file"):
        put_in_place({out / "alias" / "a.csv": b"1", out / "subroutines" / "a.csv": b"2"})
    assert tree(out) == before
    # A file that is written is not removed under its other name.
    put_in_place({out / "subroutines" / "gone.csv": b"new"}, [out / "alias" / "gone.csv"])
    assert (out / "subroutines" / "gone.csv").read_bytes() == b"new"


def test_a_name_as_long_as_the_disk_takes(tmp_path: Path) -> None:
    path = tmp_path / ("n" * 250 + ".csv")
    put_in_place({path: b"1"})
    put_in_place({path: b"2"})
    assert path.read_bytes() == b"2"


# -- what the new contents were made from -----------------------------------------------------------------------------


@pytest.mark.parametrize("stands", [None, b"other"], ids=["absent", "changed"])
def test_a_source_that_changed(out: Path, stands: bytes | None) -> None:
    writes, removals = plan(out)
    source = out.parent / "prog.py"
    if stands is not None:
        source.write_bytes(stands)
    before = tree(out.parent)
    with pytest.raises(ChangedMeanwhile, match=r"prog\.py was changed by someone else") as caught:
        put_in_place(writes, removals, {out / "main.csv": b"old main", source: b"read"})
    assert caught.value.path == source
    assert tree(out.parent) == before


def test_a_table_that_appeared(out: Path) -> None:
    before = tree(out)
    with pytest.raises(ChangedMeanwhile):
        put_in_place({out / "main.csv": b"new"}, [], {out / "nicknames.csv": None})
    assert tree(out) == before
    put_in_place(
        {out / "main.csv": b"new"}, [], {out / "absent" / "nicknames.csv": None, out / "main.csv": b"old main"}
    )
    assert (out / "main.csv").read_bytes() == b"new"


# -- what is in the way -----------------------------------------------------------------------------------------------


def refused(kind: type[OSError], out: Path, path: Path, said: str, removals: list[Path] | None = None) -> None:
    before = tree(out)
    writes = {out / "main.csv": b"new main", out / "new" / "a.csv": b"a"}
    if removals is None:
        writes[path] = b"x"
    with pytest.raises(kind, match=said) as caught:
        put_in_place(writes, removals or [])
    assert caught.value.filename == str(path)
    assert tree(out) == before


def test_a_folder_in_the_way(out: Path) -> None:
    (out / "nicknames").mkdir()
    refused(IsADirectoryError, out, out / "nicknames", "a folder is in the way")
    refused(IsADirectoryError, out, out / "nicknames", "a folder is in the place", [out / "nicknames"])


def test_a_file_where_a_folder_is_needed(out: Path) -> None:
    refused(NotADirectoryError, out, out / "main.csv" / "a" / "b.csv", r"main\.csv is a file, and a folder is needed")


def test_a_read_only_file(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (out / "nicknames.csv").chmod(0o444)
    # Simulated, since root may write anything.
    monkeypatch.setattr(os, "access", lambda path, _: Path(path).name != "nicknames.csv")
    refused(PermissionError, out, out / "nicknames.csv", "the file is read-only")
    assert put_in_place({out / "nicknames.csv": b"same"}) == []


def test_a_folder_that_takes_no_files(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    really_open = os.open

    def denied(path: Any, *more: Any, **named: Any) -> int:
        if Path(path).parent == out / "subroutines":
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return really_open(path, *more, **named)

    monkeypatch.setattr(os, "open", denied)
    refused(PermissionError, out, out / "subroutines" / "a.csv", "Permission denied")


@posix_only
def test_a_device_is_not_replaced(out: Path) -> None:
    os.mkfifo(out / "pipe")
    with pytest.raises(OSError, match="a device or a pipe"):
        put_in_place({out / "pipe": b"x"})
    assert stat.S_ISFIFO((out / "pipe").stat().st_mode)
    with pytest.raises(OSError, match="a device or a pipe"):
        put_in_place({Path(os.devnull): b"x"})


def test_a_file_that_appears_in_between_is_not_overwritten(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also what happens if the disk takes Fill.csv and fill.csv for one file."""
    really = write._Work.apply

    def apply(self: write._Work) -> None:
        (out / "fresh.csv").write_bytes(b"someone else's")
        really(self)

    monkeypatch.setattr(write._Work, "apply", apply)
    with pytest.raises(FileExistsError, match="another file has appeared") as caught:
        put_in_place({out / "main.csv": b"new", out / "fresh.csv": b"ours"})
    assert caught.value.filename == str(out / "fresh.csv")
    assert (out / "main.csv").read_bytes() == b"old main"
    assert (out / "fresh.csv").read_bytes() == b"someone else's"
    assert not list(out.glob(".*"))


# -- failure at every point -------------------------------------------------------------------------------------------

CALLS = ["open", "fsync", "chmod", "link", "replace", "rename", "stat"]
ERRORS = [OSError(errno.ENOSPC, "No space left on device"), KeyboardInterrupt(), MemoryError()]


def failing(really: Callable[..., Any], error: BaseException, at: int, after: bool) -> Callable[..., Any]:
    """The function, failing in its call number ``at`` only: before or after doing its work."""
    calls = 0

    def wrapper(*arguments: Any, **named: Any) -> Any:
        nonlocal calls
        calls += 1
        if calls != at:
            return really(*arguments, **named)
        if after:
            with contextlib.suppress(FileNotFoundError):
                really(*arguments, **named)
        raise error

    return wrapper


@pytest.mark.parametrize("error", ERRORS, ids=["disk full", "Ctrl-C", "no memory"])
@pytest.mark.parametrize("after", [False, True], ids=["before", "after"])
@pytest.mark.parametrize("call", CALLS)
def test_all_or_nothing(
    out: Path, monkeypatch: pytest.MonkeyPatch, call: str, after: bool, error: BaseException
) -> None:
    """Each call that the work makes fails once, as if it had not been made and as if it had."""
    if call == "link" and isinstance(error, OSError):
        pytest.skip("copies are made instead, see below")
    (out / "main.csv").chmod(0o640)
    shutil.copytree(out, out.parent / "trial")
    really = getattr(os, call)
    calls = 0

    def counted(*arguments: Any, **named: Any) -> Any:
        nonlocal calls
        calls += 1
        return really(*arguments, **named)

    with monkeypatch.context() as patched:
        patched.setattr(os, call, counted)
        put_in_place(*plan(out.parent / "trial"))
    assert calls

    before = tree(out)
    for at in range(1, calls + 1):
        with monkeypatch.context() as patched:
            patched.setattr(os, call, failing(really, error, at, after))
            with pytest.raises(type(error)) as caught:
                put_in_place(*plan(out))
        assert tree(out) == before, f"{call} number {at}"
        # Without a file it would count as one of the terminal.
        if isinstance(caught.value, OSError) and call != "stat":
            assert caught.value.filename, f"{call} number {at}"
        assert not getattr(caught.value, "__notes__", [])


@pytest.mark.parametrize("error", ERRORS[:2], ids=["disk full", "Ctrl-C"])
def test_a_write_that_stops_half_way(out: Path, monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    writes, removals = plan(out)
    before = tree(out)

    def half(path: Path, data: bytes) -> None:
        path.write_bytes(data[: len(data) // 2])
        raise error

    monkeypatch.setattr(write, "_write", half)
    with pytest.raises(type(error)) as caught:
        put_in_place(writes, removals)
    assert tree(out) == before
    if isinstance(caught.value, OSError):
        assert caught.value.filename == str(out / "main.csv")
        assert "No space left" in str(caught.value)


def test_a_disk_without_hard_links(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def link(*_: Any) -> None:
        raise OSError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(os, "link", link)
    writes, removals = plan(out)
    before = tree(out)
    replace = os.replace
    with monkeypatch.context() as patched:
        patched.setattr(os, "replace", failing(replace, OSError(errno.EIO, "I/O error"), 3, False))
        with pytest.raises(OSError, match="I/O error"):
            put_in_place(writes, removals)
    assert tree(out) == before
    put_in_place(writes, removals)
    assert {path: path.read_bytes() for path in writes} == writes


def test_a_second_ctrl_c_while_putting_back(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    writes, removals = plan(out)
    before = tree(out)
    really, calls = os.replace, 0

    def replace(source: Any, target: Any) -> None:
        nonlocal calls
        calls += 1
        if calls in (3, 4, 6):
            raise KeyboardInterrupt
        really(source, target)

    monkeypatch.setattr(os, "replace", replace)
    with pytest.raises(KeyboardInterrupt):
        put_in_place(writes, removals)
    assert tree(out) == before


def test_a_ctrl_c_after_the_last_file_changes_nothing_any_more(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    writes, removals = plan(out)
    monkeypatch.setattr(write, "_remove", failing(write._remove, KeyboardInterrupt(), 1, False))
    assert len(put_in_place(writes, removals)) == 4
    assert not [path for path in out.rglob("*") if path.name.startswith(".")]


def test_what_cannot_be_put_back_is_kept_and_named(out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    really, calls = os.replace, 0

    def replace(source: Any, target: Any) -> None:
        nonlocal calls
        calls += 1
        if calls > 1:
            raise OSError(errno.EIO, "I/O error")
        really(source, target)

    monkeypatch.setattr(os, "replace", replace)
    with pytest.raises(OSError, match="I/O error") as caught:
        put_in_place({out / "main.csv": b"new main", out / "nicknames.csv": b"new names"})
    (note,) = caught.value.__notes__
    assert note.startswith(f"{out / 'main.csv'} could not be put back (I/O error); its former content is in ")
    assert Path(note.rpartition(" in ")[2]).read_bytes() == b"old main"
    assert (out / "nicknames.csv").read_bytes() == b"same"
