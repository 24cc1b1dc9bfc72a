"""Puts several files in place, all of them or none."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from clickgen.diagnostics import CouldNotRun


class ChangedMeanwhile(CouldNotRun):
    """A file that the new contents were made from is no longer what it was; nothing has been written."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"{path} was changed by someone else in the meantime; run again")
        self.path = path


def put_in_place(
    writes: Mapping[Path, bytes],
    removals: Iterable[Path] = (),
    unchanged: Mapping[Path, bytes | None] | None = None,
) -> list[Path]:
    """Write and remove files, all or nothing; returns the paths that really changed, as they were given.

    A file that already holds its bytes is not touched. A symbolic link stays one, and what it points to is written.
    ``unchanged`` gives files the bytes that they must still have (None: must not exist) just before the first file
    is put in place. Raises ChangedMeanwhile where they have not, and OSError with the path as ``filename``; after
    either, and after any other exception, every file is as it was before.
    """
    work = _Work()
    try:
        for path, data in writes.items():
            work.stage(path, data)
        for path in removals:
            work.plan_removal(path)
        for path, expected in (unchanged or {}).items():
            if _content(path) != expected:
                raise ChangedMeanwhile(path)
        work.apply()
    except BaseException as error:
        work.undo(error)
        raise
    work.tidy()
    return work.changed


class _Step:
    """One file: what is to stand at ``target`` (None: nothing), and where its former content is kept meanwhile."""

    def __init__(self, path: Path, target: Path, staged: Path | None, former: Path, existed: bool) -> None:
        self.path = path
        self.target = target
        self.staged = staged
        self.former = former
        self.existed = existed
        self.begun = False


class _Work:
    def __init__(self) -> None:
        self.steps: list[_Step] = []
        self.made_folders: list[Path] = []
        self.targets: dict[str, list[Path]] = {}
        """Every file to be written, by its folded name."""

    @property
    def changed(self) -> list[Path]:
        return [step.path for step in self.steps]

    def stage(self, path: Path, data: bytes) -> None:
        """Write the new content beside its place, under a name of its own."""
        with _naming(path):
            target = Path(os.path.realpath(path))
            if self._is_written(target):
                raise _os_error(errno.EEXIST, "two outputs are to be the same file", path)
            self.targets.setdefault(target.name.casefold(), []).append(target)
            mode = _mode(target)
            if mode is not None:
                if stat.S_ISDIR(mode):
                    raise _os_error(errno.EISDIR, "a folder is in the way of this file", path)
                if not stat.S_ISREG(mode):
                    raise _os_error(errno.EINVAL, "this is a device or a pipe, not a file", path)
                if target.read_bytes() == data:
                    return
                # Renaming over a read-only file works on POSIX and not on Windows; it was protected on purpose.
                if not os.access(target, os.W_OK):
                    raise _os_error(errno.EACCES, "the file is read-only", path)
            self._make_folders(target.parent)
            step = _Step(path, target, _sibling(target, "new"), _sibling(target, "old"), mode is not None)
            self.steps.append(step)
            assert step.staged is not None
            _write(step.staged, data)
            if mode is not None:
                os.chmod(step.staged, stat.S_IMODE(mode))

    def plan_removal(self, path: Path) -> None:
        with _naming(path):
            mode = _mode(path, follow=False)
            if mode is None or self._is_written(path):
                return
            if stat.S_ISDIR(mode):
                raise _os_error(errno.EISDIR, "a folder is in the place of a file to be removed", path)
            self.steps.append(_Step(path, path, None, _sibling(path, "old"), True))

    def apply(self) -> None:
        for step in self.steps:
            with _naming(step.path):
                # Noted first, so that an interrupt between the two finds the step among those to undo.
                step.begun = True
                if step.staged is None:
                    with contextlib.suppress(FileNotFoundError):
                        os.replace(step.target, step.former)
                    continue
                if step.existed:
                    _keep_copy(step.target, step.former)
                elif os.path.lexists(step.target):
                    # Someone was faster, or this disk takes the names of two outputs for one (Fill.csv, fill.csv).
                    step.begun = False
                    raise _os_error(errno.EEXIST, "another file has appeared in the place of this one", step.path)
                os.replace(step.staged, step.target)

    def undo(self, cause: BaseException) -> None:
        """Put back what was there. What cannot be put back is kept, and the exception says where."""
        for step in reversed(self.steps):
            try:
                try:
                    self._undo(step)
                except KeyboardInterrupt:  # A second Ctrl-C is no reason to leave half of the files.
                    self._undo(step)
            except OSError as error:
                kept = f"; its former content is in {step.former}" if os.path.lexists(step.former) else ""
                cause.add_note(f"{step.path} could not be put back ({error.strerror or error}){kept}")
        for folder in reversed(self.made_folders):
            with contextlib.suppress(OSError):
                folder.rmdir()

    def _undo(self, step: _Step) -> None:
        replaced = step.staged is not None and step.begun and not step.staged.exists()
        if step.staged is not None:
            _remove(step.staged)
        if step.existed:
            # A rename between two names of one file does nothing, so the second name is taken away after it.
            if os.path.lexists(step.former) and (replaced or step.staged is None):
                os.replace(step.former, step.target)
            _remove(step.former)
        elif replaced:
            _remove(step.target)

    def tidy(self) -> None:
        """Everything is in place: drop the former contents."""
        for step in self.steps:
            with contextlib.suppress(OSError):
                try:
                    _remove(step.former)
                except KeyboardInterrupt:  # Too late to go back, so this goes on to the end.
                    _remove(step.former)

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
            new.mkdir()


def _sibling(target: Path, kind: str) -> Path:
    # Not the target's own name with something added: that can be too long for the file system.
    return target.with_name(f".clickgen-{os.urandom(8).hex()}.{kind}")


def _write(path: Path, data: bytes) -> None:
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    # 0o666 less the umask, as for any new file; the tempfile module would make it private.
    with open(os.open(path, flags, 0o666), "wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def _keep_copy(target: Path, former: Path) -> None:
    """A second name for what stands there; where the file system has no hard links, a copy."""
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


def _content(path: Path) -> bytes | None:
    with _naming(path):
        try:
            return path.read_bytes()
        except (FileNotFoundError, NotADirectoryError):
            return None


def _same_entry(path: Path, target: Path) -> bool:
    """True where two names that differ at most in case are one file, which is for the file system to say."""
    if path == target:
        return True
    with contextlib.suppress(OSError):
        return os.path.samefile(path.parent, target.parent) and os.path.samefile(path, target)
    return False


def _os_error(code: int, message: str, path: Path) -> OSError:
    return OSError(code, message, str(path))  # Python picks the subclass from the code.


@contextlib.contextmanager
def _naming(path: Path) -> Iterator[None]:
    """Errors speak of the file that the user knows, not of a temporary one."""
    try:
        yield
    except OSError as error:
        if error.errno is None or error.filename == str(path):
            raise
        raise OSError(error.errno, error.strerror or str(error), str(path)) from error
