"""Puts several files in place, all of them or none, whoever else writes and whenever it is stopped.

Folders are locked while their files are replaced (``lock.py``). The plan is noted first, so that the next
writer puts back what a killed one left half done (``journal.py``).
"""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import stat
import threading
from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path
from types import FrameType

from clickgen.text.journal import Note, Step, done_name, journal_name, recover, sibling_name
from clickgen.text.lock import locked
from clickgen.workspace import CouldNotRun, leads_elsewhere, read_file, read_if_there
from clickgen.workspace.digest import digest_of

written: list[Path] = []
"""Every path that this process has put in place, for callers who report them when it is stopped."""


class ChangedMeanwhile(CouldNotRun):
    """A file that the new contents were made from is no longer what it was; nothing has been written."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"{path} was changed by someone else in the meantime; run again")
        self.path = path


def put_in_place(
    writes: Mapping[Path, bytes],
    removals: Iterable[Path] = (),
    unchanged: Mapping[Path, bytes | None] | None = None,
    no_links: Collection[Path] = (),
) -> list[Path]:
    """Write and remove files, all or nothing; returns the paths that really changed, as they were given.

    A file that already holds its bytes is not touched. A symbolic link stays one, and its target is written; a
    link among ``no_links`` is refused: these were not read, so nobody knows where it leads.
    ``unchanged`` gives files the bytes that they must still have (None: must not exist) just before they are replaced.
    Raises ChangedMeanwhile if they have not, and OSError with the path as ``filename``; after either, and after any
    other exception, every file is as it was before. A process that is killed leaves a journal, with which the next one
    that writes into these folders puts everything back.
    """
    removals, unchanged = list(removals), unchanged or {}
    work = _Work(unchanged, no_links)
    with contextlib.ExitStack() as stack:
        stack.callback(work.drop_folders)
        folders = work.folders(writes, removals)
        stack.enter_context(locked(folders))
        try:
            recover(folders)
            for path, data in writes.items():
                work.stage(path, data)
            for path in removals:
                work.plan_removal(path)
            for path, expected in unchanged.items():
                _require(path, expected)
            with _undisturbed():
                work.apply()
                work.commit()
        except BaseException as error:
            if not work.is_done:
                with _undisturbed():
                    work.undo(error)
            raise
    return work.changed


class _Step:
    """One file: what is to be at ``target`` (None: nothing), and where its former content is kept meanwhile."""

    def __init__(
        self, path: Path, target: Path, staged: Path | None, former: Path, existed: bool, digest: str | None = None
    ) -> None:
        self.path = path
        self.target = target
        self.staged = staged
        self.former = former
        self.existed = existed
        self.digest = digest
        self.begun = False

    @property
    def noted(self) -> Step:
        staged = self.staged.name if self.staged else None
        return Step(self.target.name, staged, self.former.name, self.existed, self.digest)


class _Work:
    def __init__(self, unchanged: Mapping[Path, bytes | None], no_links: Collection[Path]) -> None:
        self.name = os.urandom(8).hex()
        self.unchanged = unchanged
        self.no_links = {*no_links}
        self.steps: list[_Step] = []
        self.notes: list[Path] = []
        """The journals that were written; the last one counts."""
        self.made_folders: list[Path] = []
        self.targets: dict[str, list[Path]] = {}
        """Every file to be written, by its folded name."""
        self.is_done = False

    @property
    def changed(self) -> list[Path]:
        return [step.path for step in self.steps]

    def folders(self, writes: Mapping[Path, bytes], removals: Iterable[Path]) -> list[Path]:
        """The folders in which there is something to do; missing ones are made."""
        found: dict[Path, None] = {}
        for path, data in writes.items():
            with _naming(path):
                target = self._target(path)
                if not _is_regular(target) or read_file(target) != data:
                    self._make_folders(target.parent)
                    found[target.parent] = None
        for path in removals:
            if _mode(path, follow=False) is not None:
                found[path.parent] = None
        return list(found)

    def _target(self, path: Path) -> Path:
        """The file itself. Raises OSError for a link that must not be written through."""
        if path in self.no_links and leads_elsewhere(path):
            raise _os_error(
                errno.EMLINK, "this is a link to another place; take it away, or choose another place", path
            )
        return Path(os.path.realpath(path))

    def stage(self, path: Path, data: bytes) -> None:
        """Write the new content beside its place, under a name of its own."""
        with _naming(path):
            target = self._target(path)
            if self._is_written(target):
                raise _os_error(errno.EEXIST, "two outputs are to be the same file", path)
            self.targets.setdefault(target.name.casefold(), []).append(target)
            mode = _mode(target)
            if mode is not None:
                if stat.S_ISDIR(mode):
                    raise _os_error(errno.EISDIR, "a folder is in the way of this file", path)
                if not stat.S_ISREG(mode):
                    raise _os_error(errno.EINVAL, "this is a device or a pipe, not a file", path)
                if read_file(target) == data:
                    return
                # Renaming over a read-only file works on POSIX but not on Windows; it was protected on purpose.
                if not os.access(target, os.W_OK):
                    raise _os_error(errno.EACCES, "the file is read-only", path)
            self._make_folders(target.parent)
            staged = self._sibling(target, "new")
            self.steps.append(
                _Step(path, target, staged, self._sibling(target, "old"), mode is not None, digest_of(data))
            )
            _write(staged, data)
            if mode is not None:
                os.chmod(staged, stat.S_IMODE(mode))

    def plan_removal(self, path: Path) -> None:
        with _naming(path):
            mode = _mode(path, follow=False)
            if mode is None or self._is_written(path):
                return
            if stat.S_ISDIR(mode):
                raise _os_error(errno.EISDIR, "a folder is in the place of a file to be removed", path)
            target = Path(os.path.realpath(path.parent), path.name)
            self.steps.append(_Step(path, target, None, self._sibling(target, "old"), True))

    def _sibling(self, target: Path, kind: str) -> Path:
        # Not the target's own name with a suffix: that can be too long for the file system.
        return target.with_name(sibling_name(self.name, len(self.steps), kind))

    def _note(self) -> None:
        """Note the plan in each folder; the note that counts comes last."""
        folders = tuple(dict.fromkeys(str(step.target.parent) for step in self.steps))
        for folder in reversed(folders):
            note = Note(folders, tuple(step.noted for step in self.steps if str(step.target.parent) == folder))
            path = Path(folder, journal_name(self.name))
            self.notes.append(path)
            # Under another name until it is complete: half a note says nothing.
            with _naming(Path(folder)):
                _write(path.with_suffix(".new"), note.to_bytes(folder))
                os.rename(path.with_suffix(".new"), path)

    def apply(self) -> None:
        self._note()
        for step in self.steps:
            with _naming(step.path):
                # Noted first, so that an interrupt between the two finds the step among those to undo.
                step.begun = True
                if step.staged is None:
                    with contextlib.suppress(FileNotFoundError):
                        os.replace(step.target, step.former)
                    continue
                if step.existed:
                    self._replace(step)
                    continue
                if os.path.lexists(step.target):
                    # Someone was faster, or this disk treats the names of two outputs as one (Fill.csv, fill.csv).
                    step.begun = False
                    raise _os_error(errno.EEXIST, "another file has appeared in the place of this one", step.path)
                os.replace(step.staged, step.target)

    def _replace(self, step: _Step) -> None:
        """Put the new content over the former, unless somebody has saved the file since it was read.

        The former content stays under a second name, so that even a save at this moment is not lost. The only gap
        is a save by renaming between two calls that follow each other.
        """
        assert step.staged is not None
        expected = self.unchanged.get(step.path)
        _keep_copy(step.target, step.former)
        if expected is not None:
            _require(step.path, expected, step.former)
            _require(step.path, expected)
        os.replace(step.staged, step.target)
        if expected is not None:
            _require(step.path, expected, step.former)

    def commit(self) -> None:
        """Everything is in place: from here on only tidying up remains."""
        if self.notes:
            with _naming(self.notes[-1].parent):
                os.rename(self.notes[-1], self.notes[-1].with_name(done_name(self.name)))
        self.is_done = True
        written.extend(self.changed)
        self.tidy()

    def undo(self, cause: BaseException) -> None:
        """Put back what was there. What cannot be put back is kept, and the exception says where."""
        for note in self.notes[-1:]:
            done = note.with_name(done_name(self.name))
            if os.path.lexists(done):
                os.rename(done, note)
        for step in reversed(self.steps):
            try:
                try:
                    self._undo(step)
                except KeyboardInterrupt:  # A second Ctrl-C is no reason to leave half of the files.
                    self._undo(step)
            except OSError as error:
                kept = f"; its former content is in {step.former}" if os.path.lexists(step.former) else ""
                cause.add_note(f"{step.path} could not be put back ({error.strerror or error}){kept}")
        if not getattr(cause, "__notes__", None):
            # In the order in which they were written: the last one says that the work is not done.
            half = [note.with_suffix(".new") for note in self.notes]
            for path in (*(step.staged for step in self.steps), *half, *self.notes):
                if path is not None:
                    with contextlib.suppress(OSError):
                        _remove(path)

    def drop_folders(self) -> None:
        """Remove folders that were made for nothing."""
        for folder in reversed(self.made_folders if not self.is_done else []):
            with contextlib.suppress(OSError):
                folder.rmdir()

    def _undo(self, step: _Step) -> None:
        replaced = step.staged is not None and step.begun and not step.staged.exists()
        if step.existed:
            # A rename between two names of one file does nothing, so the second name is removed after it.
            if os.path.lexists(step.former) and (replaced or step.staged is None):
                os.replace(step.former, step.target)
            _remove(step.former)
        elif replaced:
            _remove(step.target)

    def tidy(self) -> None:
        """Everything is in place: drop the former contents."""
        done = [note.with_name(done_name(self.name)) for note in self.notes[-1:]]
        for path in (*(step.former for step in self.steps), *self.notes[:-1], *done):
            with contextlib.suppress(OSError):
                try:
                    _remove(path)
                except KeyboardInterrupt:  # Too late to go back, so go on to the end.
                    _remove(path)

    def _is_written(self, path: Path) -> bool:
        return any(_same_entry(path, target) for target in self.targets.get(path.name.casefold(), ()))

    def _make_folders(self, folder: Path) -> None:
        missing: list[Path] = []
        while not folder.exists():
            missing.append(folder)
            folder = folder.parent
        if not folder.is_dir():
            raise _os_error(errno.ENOTDIR, f"{folder} is a file, and a folder is needed there", folder)
        for new in reversed(missing):
            self.made_folders.append(new)
            try:
                new.mkdir()
            except FileExistsError:
                # Another writer was faster; it is that one's folder now.
                self.made_folders.remove(new)
                if not new.is_dir():
                    raise


@contextlib.contextmanager
def _undisturbed() -> Iterator[None]:
    """Hold back Ctrl-C and the like until the block ends: the files are in place by then, or as they were."""
    kinds = [signal.SIGINT, signal.SIGTERM]
    if threading.current_thread() is not threading.main_thread() or any(
        signal.getsignal(kind) is None for kind in kinds
    ):
        yield
        return
    came: list[tuple[int, FrameType | None]] = []
    former = {kind: signal.signal(kind, lambda number, frame: came.append((number, frame))) for kind in kinds}
    try:
        yield
    finally:
        for kind, handler in former.items():
            signal.signal(kind, handler)
        for number, frame in came[:1]:
            handler = former[signal.Signals(number)]
            if callable(handler):
                handler(number, frame)
            elif handler == signal.SIG_DFL:
                signal.raise_signal(number)


def _write(path: Path, data: bytes) -> None:
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    # 0o666 less the umask, as for any new file; the tempfile module would make it private.
    with open(os.open(path, flags, 0o666), "wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def _keep_copy(target: Path, former: Path) -> None:
    """Give the existing file a second name; a copy if the file system has no hard links."""
    try:
        os.link(target, former)
    except OSError:
        import shutil

        with contextlib.suppress(shutil.SameFileError):  # a network disk may link and answer that it did not
            shutil.copy2(target, former)


def _remove(path: Path) -> None:
    with contextlib.suppress(FileNotFoundError):
        path.unlink()


def _mode(path: Path, *, follow: bool = True) -> int | None:
    try:
        return os.stat(path, follow_symlinks=follow).st_mode
    except (FileNotFoundError, NotADirectoryError):
        return None


def _is_regular(path: Path) -> bool:
    mode = _mode(path)
    return mode is not None and stat.S_ISREG(mode)


def _require(path: Path, expected: bytes | None, place: Path | None = None) -> None:
    """Raise ChangedMeanwhile if a file, or what is kept of it, does not hold what it must hold."""
    with _naming(path):
        if read_if_there(place or path) != expected:
            raise ChangedMeanwhile(path)


def _same_entry(path: Path, target: Path) -> bool:
    """True if two names that differ at most in case are one file, which the file system decides."""
    if path == target:
        return True
    with contextlib.suppress(OSError):
        return os.path.samefile(path.parent, target.parent) and os.path.samefile(path, target)
    return False


def _os_error(code: int, message: str, path: Path) -> OSError:
    return OSError(code, message, str(path))  # Python picks the subclass from the code.


@contextlib.contextmanager
def _naming(path: Path) -> Iterator[None]:
    """Errors name the file that the user knows, not a temporary one."""
    try:
        yield
    except OSError as error:
        if error.errno is None or error.filename == str(path):
            raise
        raise OSError(error.errno, error.strerror or str(error), str(path)) from error
