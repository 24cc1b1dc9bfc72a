"""A writer that is killed at any point: the next one finds everything done or nothing, and no trace of it."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from collections.abc import Callable, Sequence
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from clickgen.text import lock
from clickgen.text.journal import done_name, journal_name, recover
from clickgen.text.lock import NAME, Busy, locked
from clickgen.text.write import put_in_place

pytestmark = pytest.mark.skipif(os.name != "posix", reason="processes are forked here")

CALLS = ("open", "link", "replace", "rename", "unlink", "fsync", "chmod", "mkdir", "rmdir")
KILLED = 9


def lay_out(folder: Path) -> None:
    (folder / "out" / "subroutines").mkdir(parents=True)
    (folder / "plc").mkdir()
    (folder / "plc" / "nicknames.csv").write_bytes(b"old table")
    (folder / "plc" / "prog.py").write_bytes(b"old program")
    (folder / "out" / "main.csv").write_bytes(b"old main")
    (folder / "out" / "subroutines" / "gone.csv").write_bytes(b"old sub")


def write_all(folder: Path) -> None:
    plc, out = folder / "plc", folder / "out"
    put_in_place(
        {
            plc / "nicknames.csv": b"new table",
            out / "main.csv": b"new main",
            out / "listing.txt": b"new listing",
            plc / "prog.py": b"new program",
            out / "pages" / "main.html": b"new page",
        },
        [out / "subroutines" / "gone.csv"],
        {plc / "nicknames.csv": b"old table", plc / "prog.py": b"old program"},
    )


def tree(folder: Path) -> dict[str, bytes]:
    """Every file. Empty folders do not count: a killed writer may leave some."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def in_a_child(work: Callable[[], None]) -> int:
    """Run it in a process of its own; return the exit code."""
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    try:
        work()
    except BaseException:
        os._exit(1)
    os._exit(0)


def dying(at: int, after: bool, names: Sequence[str] = CALLS) -> None:
    """Let the file system's call number ``at`` be the last thing that this process does, or tries to do."""
    calls = 0

    def wrapped(really: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **named: Any) -> Any:
            nonlocal calls
            calls += 1
            if calls == at and not after:
                os._exit(KILLED)
            result = really(*arguments, **named)
            if calls == at:
                os._exit(KILLED)
            return result

        return call

    setattr(os, "fsync", int)  # noqa: B010 - a disk has no part in this
    for name in names:
        setattr(os, name, wrapped(getattr(os, name)))


def kill_after(replacements: int, folder: Path) -> None:
    """Leave a folder with this many files in place that are to be replaced or removed."""

    def work() -> None:
        dying(replacements, True, ["replace"])
        write_all(folder)

    assert in_a_child(work) == KILLED


@pytest.mark.parametrize("after", [False, True], ids=["before", "after"])
@pytest.mark.parametrize("how", ["all at once", "folder by folder"])
def test_a_writer_killed_at_any_point_leaves_all_or_nothing(tmp_path: Path, after: bool, how: str) -> None:
    lay_out(tmp_path / "model")
    before = tree(tmp_path / "model")
    write_all(tmp_path / "model")
    complete = tree(tmp_path / "model")
    seen = set()
    for at in range(1, 1000):
        folder = tmp_path / f"{at}"
        lay_out(folder)

        def work(at: int = at, folder: Path = folder) -> None:
            dying(at, after)
            write_all(folder)

        code = in_a_child(work)
        if code == 0:
            assert tree(folder) == complete
            break
        assert code == KILLED
        folders = [folder / "plc", folder / "out", folder / "out" / "subroutines", folder / "out" / "pages"]
        if how == "all at once":
            recover(folders)
        else:
            for each in folders:
                recover([each])
        (folder / "plc" / NAME).unlink(missing_ok=True)  # Locked by nobody; the next writer removes these.
        (folder / "out" / NAME).unlink(missing_ok=True)
        (folder / "out" / "subroutines" / NAME).unlink(missing_ok=True)
        (folder / "out" / "pages" / NAME).unlink(missing_ok=True)
        left = tree(folder)
        assert left in (before, complete), f"call {at}: {sorted(left)}"
        seen.add(left == complete)
    else:
        pytest.fail("it never came to its end")
    assert at > 30
    assert seen == {True, False}


def test_recovery_killed_at_any_point_is_taken_up_again(tmp_path: Path) -> None:
    lay_out(tmp_path / "model")
    before = tree(tmp_path / "model")
    for replacements in (1, 4, 6):
        for at in range(1, 200):
            folder = tmp_path / f"{replacements}-{at}"
            lay_out(folder)
            kill_after(replacements, folder)
            assert tree(folder)["plc/nicknames.csv"] == b"new table"
            folders = [folder / "plc", folder / "out", folder / "out" / "subroutines", folder / "out" / "pages"]

            def again(at: int = at, folders: list[Path] = folders) -> None:
                dying(at, True)
                recover(folders)

            code = in_a_child(again)
            recover(folders)
            assert {name: data for name, data in tree(folder).items() if not name.endswith(NAME)} == before
            if code == 0:
                break
            assert code == KILLED


def test_the_next_writer_recovers_by_itself(tmp_path: Path) -> None:
    lay_out(tmp_path)
    kill_after(3, tmp_path)
    assert any(name.endswith(".journal") for name in tree(tmp_path))
    write_all(tmp_path)
    assert tree(tmp_path / "plc") == {"nicknames.csv": b"new table", "prog.py": b"new program"}
    assert sorted(tree(tmp_path / "out")) == ["listing.txt", "main.csv", "pages/main.html"]


def test_what_a_person_saved_after_the_kill_stays(tmp_path: Path) -> None:
    lay_out(tmp_path)
    kill_after(3, tmp_path)
    assert (tmp_path / "plc" / "nicknames.csv").read_bytes() == b"new table"
    (tmp_path / "plc" / "nicknames.csv").write_bytes(b"mine")
    recover([tmp_path / "plc", tmp_path / "out"])
    assert tree(tmp_path / "plc") == {"nicknames.csv": b"mine", "prog.py": b"old program"}


def test_a_moved_repository_recovers_too(tmp_path: Path) -> None:
    lay_out(tmp_path / "here")
    before = tree(tmp_path / "here")
    kill_after(3, tmp_path / "here")
    (tmp_path / "here").rename(tmp_path / "there")
    assert recover([tmp_path / "there" / "out"])
    assert {name: data for name, data in tree(tmp_path / "there").items() if not name.endswith(NAME)} == before


# -- what is no journal of ours ---------------------------------------------------------------------------------------

WORK = "0123456789abcdef"
FORMER = f".clickgen-{WORK}-0.old"
PLAIN = ["main.csv", f".clickgen-{WORK}-0.new", FORMER, False, "0" * 40]


@pytest.mark.parametrize(
    "tree_of_note",
    [
        [],
        {},
        {"folders": ["."], "steps": [5]},
        {"folders": [], "steps": [PLAIN]},
        {"folders": [".."], "steps": [PLAIN]},
        {"folders": ["."], "steps": [["../victim", *PLAIN[1:]]]},
        {"folders": ["."], "steps": [["main.csv", "victim", *PLAIN[2:]]]},
        {"folders": ["."], "steps": [["main.csv", PLAIN[1], "../victim", *PLAIN[3:]]]},
        {"folders": ["."], "steps": [["main.csv", None, "victim", True, None]]},
        {"folders": [".", "../elsewhere"], "steps": [PLAIN]},
    ],
    ids=json.dumps,
)
@pytest.mark.parametrize("name", [journal_name(WORK), done_name(WORK)])
def test_a_forged_journal_does_nothing_beyond_its_folder(tmp_path: Path, tree_of_note: object, name: str) -> None:
    folder = tmp_path / "out"
    folder.mkdir()
    (tmp_path / "elsewhere").mkdir()
    for path in (tmp_path / "victim", folder / "victim", folder / "main.csv", tmp_path / "elsewhere" / "main.csv"):
        path.write_bytes(b"precious")
    (folder / name).write_text(json.dumps(tree_of_note))
    recover([folder])
    kept = {path: data for path, data in tree(tmp_path).items() if ".clickgen" not in path}
    assert kept == dict.fromkeys(("victim", "out/victim", "out/main.csv", "elsewhere/main.csv"), b"precious")


@pytest.mark.parametrize("name", ["\ud800", "\0", "a\0b"])
def test_a_forged_journal_names_what_no_file_can_be_called(tmp_path: Path, name: str) -> None:
    (tmp_path / FORMER).write_bytes(b"precious")
    for step in ([name, None, FORMER, True, None], [name, *PLAIN[1:]]):
        (tmp_path / journal_name(WORK)).write_text(json.dumps({"folders": ["."], "steps": [step]}))
        assert recover([tmp_path]) == []
        assert (tmp_path / FORMER).read_bytes() == b"precious"


def test_a_journal_that_is_a_link_or_a_pipe_is_none(tmp_path: Path) -> None:
    (tmp_path / "main.csv").write_bytes(b"precious")
    os.symlink("/dev/zero", tmp_path / journal_name(WORK))
    os.mkfifo(tmp_path / done_name("f" * 16))
    assert recover([tmp_path]) == []
    assert (tmp_path / "main.csv").read_bytes() == b"precious"


# -- the lock ---------------------------------------------------------------------------------------------------------


def test_a_folder_is_locked_for_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    code = (
        "import sys, time\nfrom clickgen.text.lock import locked\n"
        "with locked([sys.argv[1]]):\n    print('locked', flush=True)\n    sys.stdin.read()\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code, str(tmp_path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == b"locked\n"
        monkeypatch.setattr("clickgen.text.lock.PATIENCE", 0.0)
        with pytest.raises(Busy, match="another clickgen is writing into"), locked([tmp_path]):
            pass
        other.kill()
    monkeypatch.undo()
    with locked([tmp_path]) as ours:
        assert ours == {os.path.realpath(tmp_path)}
        with locked([tmp_path]):
            assert (tmp_path / NAME).exists()
        assert (tmp_path / NAME).exists()
    assert list(tmp_path.iterdir()) == []


def test_a_lock_file_that_is_something_else_locks_nothing_and_stays(tmp_path: Path) -> None:
    os.symlink(tmp_path / "elsewhere", tmp_path / NAME)
    with locked([tmp_path]) as ours:
        assert ours == frozenset()
    assert not (tmp_path / "elsewhere").exists()
    (tmp_path / NAME).unlink()
    (tmp_path / NAME).write_text("mine")
    with locked([tmp_path]):
        pass
    assert (tmp_path / NAME).read_text() == "mine"


def test_a_disk_that_knows_no_file_again_is_written_to_without_a_lock(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(lock, "_is_still_there", lambda *_: False)
    monkeypatch.setattr(lock, "PATIENCE", -1.0)
    with locked([tmp_path]) as ours:
        assert ours == frozenset()
    assert list(tmp_path.iterdir()) == []


# -- Windows ----------------------------------------------------------------------------------------------------------


class Msvcrt(ModuleType):
    """``msvcrt.locking`` by its documentation: bytes from the position on, which only their locker can unlock."""

    LK_NBLCK, LK_UNLCK = 2, 0

    def __init__(self) -> None:
        super().__init__("msvcrt")
        self.held: dict[tuple[int, int], int] = {}
        self.calls: list[int] = []

    def locking(self, descriptor: int, mode: int, count: int) -> None:
        status = os.fstat(descriptor)
        place = (status.st_dev, status.st_ino)
        assert (os.lseek(descriptor, 0, os.SEEK_CUR), count) == (0, 1)
        self.calls.append(mode)
        if mode == self.LK_UNLCK:
            if self.held.get(place) != descriptor:
                raise PermissionError(errno.EACCES, "Permission denied")
            del self.held[place]
        elif place in self.held:
            raise PermissionError(errno.EACCES, "Permission denied")
        else:
            self.held[place] = descriptor


@pytest.fixture
def windows(monkeypatch: pytest.MonkeyPatch) -> tuple[Msvcrt, Callable[[], Any]]:
    """Replacements for Windows, and the module of locks as another process has it there."""
    fake = Msvcrt()
    monkeypatch.setitem(sys.modules, "msvcrt", fake)

    def process() -> Any:
        spec = spec_from_file_location("lock_of_a_process", lock.__file__)
        assert spec is not None
        assert spec.loader is not None
        module = module_from_spec(spec)
        with monkeypatch.context() as patch:
            patch.setattr(sys, "platform", "win32")
            spec.loader.exec_module(module)
        there = ModuleType("sys")
        vars(there)["platform"] = "win32"
        vars(module)["sys"] = there
        return module

    return fake, process


def test_a_folder_is_locked_for_one_on_windows(windows: tuple[Msvcrt, Callable[[], Any]], tmp_path: Path) -> None:
    fake, process = windows
    one, other = process(), process()
    other.PATIENCE = -1.0
    with one.locked([tmp_path]) as ours:
        assert ours == {os.path.realpath(tmp_path)}
        with pytest.raises(other.Busy), other.locked([tmp_path]):
            pass
    with other.locked([tmp_path]) as ours:
        assert ours == {os.path.realpath(tmp_path)}
    assert fake.held == {}
    # It is unlocked before it is closed: Windows takes its time with a file that is only closed.
    assert fake.calls == [2, 2, 0, 2, 0]
    assert list(tmp_path.iterdir()) == []


def test_a_lock_file_that_is_open_elsewhere_stays_and_can_be_locked_again(
    windows: tuple[Msvcrt, Callable[[], Any]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Windows removes no file that somebody has open, such as a waiting writer, or a scanner."""

    def refused(*_: object) -> None:
        raise PermissionError(errno.EACCES, "The process cannot access the file")

    module = windows[1]()
    monkeypatch.setattr(os, "unlink", refused)
    for _ in range(2):
        with module.locked([tmp_path]) as ours:
            assert ours == {os.path.realpath(tmp_path)}
    assert (tmp_path / NAME).read_bytes() == b""


def test_a_lock_file_that_is_just_being_taken_away_is_waited_for(
    windows: tuple[Msvcrt, Callable[[], Any]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = windows[1]()
    really, refusals = module._opened, [PermissionError(errno.EACCES, "Permission denied", str(tmp_path))] * 3

    def opened(path: Path) -> object:
        if refusals:
            raise refusals.pop()
        return really(path)

    monkeypatch.setattr(module, "_opened", opened)
    with module.locked([tmp_path]) as ours:
        assert ours == {os.path.realpath(tmp_path)}
    refusals += [PermissionError(errno.EACCES, "Permission denied", str(tmp_path))]
    module._GRACE = -1.0
    with pytest.raises(PermissionError), module.locked([tmp_path]):
        pass
