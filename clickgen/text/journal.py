"""A writer's plan, noted on disk: the next writer after one that was killed puts back what it left.

Each folder gets a note of the steps in it before the first file is replaced. Only the note of the first folder
counts: as long as it exists, the work is not done, and everything is put back. When all files are in
place, that note gets another name, and only tidying up remains. A note covers files in its own folder
alone, by plain names, and a file is put back only while it holds what the writer put there: a forged note can do
nothing outside its folder.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import stat
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from clickgen.text.lock import locked
from clickgen.workspace import read_file
from clickgen.workspace.digest import digest_of

_OWN = re.compile(r"\.clickgen-([0-9a-f]{16})(?:-\d+)?\.(new|old|journal|done)")
_NOTE_MAX = 16 * 2**20


def journal_name(work: str) -> str:
    """The file that says which work is under way; ``work`` is 16 hexadecimal digits."""
    return f".clickgen-{work}.journal"


def done_name(work: str) -> str:
    """The name of the first journal when everything is in place."""
    return f".clickgen-{work}.done"


def sibling_name(work: str, number: int, kind: str) -> str:
    """The name of a new (``new``) or former (``old``) content until everything is in place."""
    return f".clickgen-{work}-{number}.{kind}"


class Step(NamedTuple):
    """One file, by names in its folder: its new content (None: it is removed) and its former content (if any)."""

    name: str
    staged: str | None
    former: str
    existed: bool
    digest: str | None
    """Of the new content."""


class Note(NamedTuple):
    """The steps of one folder, and all folders of the work by their real paths, starting with the first."""

    folders: tuple[str, ...]
    steps: tuple[Step, ...]

    def to_bytes(self, folder: str) -> bytes:
        """The note for one of the folders. It names the others relative to that one: a repository may be moved."""
        return json.dumps(
            {"folders": [_seen_from(folder, other) for other in self.folders], "steps": self.steps}
        ).encode()


def _seen_from(folder: str, other: str) -> str:
    try:
        return os.path.relpath(other, folder)
    except ValueError:  # another drive of Windows
        return other


def recover(folders: Iterable[str | os.PathLike[str]]) -> list[Path]:
    """Put back what killed writers left half done in these folders, and tidy up after them.

    Returns the files that were put back. If no writer was killed, nothing is touched. Raises OSError and Busy.
    """
    marked = {os.path.realpath(folder) for folder in folders if _traces(folder)}
    if not marked:
        return []
    with locked(_with_companions(marked)) as ours:
        # The lock ended with its owner: these files belong to nobody now.
        return [path for folder in sorted(ours) for path in _recovered(folder, ours)]


def _with_companions(folders: set[str]) -> set[str]:
    """These folders, and those in which the same work was under way."""
    notes = [(work, note) for folder in folders for work, note in _notes(folder)]
    others = {other for work, note in notes for other in note.folders if _note_of(work, other)}
    return folders | others


def _recovered(folder: str, ours: frozenset[str]) -> Iterator[Path]:
    for work, note in _notes(folder):
        first = note.folders[0]
        if first not in ours and os.path.isdir(first) and _note_of(work, first):
            continue
        if Path(first, journal_name(work)).is_file():
            yield from _roll_back(work, note)
        elif Path(first, done_name(work)).is_file():
            _finish(work, note)
        elif not any(Path(folder, step.former).exists() for step in note.steps):
            _tidy(folder, note)  # It had not begun.
            _remove(Path(folder, journal_name(work)))
    noted = {work for work, _ in _notes(folder)}
    for name, (work, kind) in _traces(folder).items():
        if kind == "new" and work not in noted:
            _remove(Path(folder, name))


def _roll_back(work: str, note: Note) -> Iterator[Path]:
    """Put back everything that one writer did; the note that counts goes last."""
    for folder in reversed(note.folders):
        own = _note_of(work, folder)
        for step in own.steps if own else ():
            if _put_back(Path(folder), step):
                yield Path(folder, step.name)
        if own:
            _tidy(folder, own)
        _remove(Path(folder, journal_name(work)))


def _finish(work: str, note: Note) -> None:
    """Everything is in place: drop what was kept in case of a failure."""
    for folder in reversed(note.folders):
        own = _note_of(work, folder)
        if own:
            _tidy(folder, own)
        _remove(Path(folder, journal_name(work)))
    _remove(Path(note.folders[0], done_name(work)))


def _put_back(folder: Path, step: Step) -> bool:
    """Undo one step; True if there was something to undo. A file that someone has changed since stays."""
    target, former = folder / step.name, folder / step.former
    if step.staged is None:
        if _is_plain(former) and not os.path.lexists(target):
            os.replace(former, target)
            return True
        return False
    if (folder / step.staged).exists() or not _is_plain(target) or digest_of(read_file(target)) != step.digest:
        return False
    if not step.existed:
        _remove(target)
        return True
    if _is_plain(former):
        os.replace(former, target)
        return True
    return False


def _tidy(folder: str, note: Note) -> None:
    for step in note.steps:
        for name in (step.staged, step.former):
            if name is not None:
                _remove(Path(folder, name))


def _traces(folder: str | os.PathLike[str]) -> dict[str, tuple[str, str]]:
    """The files of writers in a folder: the work that each belongs to, and its kind."""
    try:
        names = os.listdir(folder)
    except OSError:
        return {}
    matches = ((name, _OWN.fullmatch(name)) for name in names if name.startswith(".clickgen-"))
    return {name: (match[1], match[2]) for name, match in matches if match}


def _notes(folder: str) -> list[tuple[str, Note]]:
    """The works that have a note in a folder."""
    works = sorted({work for work, kind in _traces(folder).values() if kind in ("journal", "done")})
    return [(work, note) for work in works if (note := _note_of(work, folder))]


def _note_of(work: str, folder: str) -> Note | None:
    """A writer's note in a folder; None if there is nothing that a writer can have noted."""
    for name in (journal_name(work), done_name(work)):
        path = Path(folder, name)
        try:
            if not _is_plain(path):
                continue
            tree = json.loads(read_file(path, _NOTE_MAX))
            folders = tuple(os.path.realpath(os.path.join(folder, other)) for other in tree["folders"])
            steps = tuple(Step(*step) for step in tree["steps"])
        except (OSError, ValueError, LookupError, TypeError, RecursionError):
            continue
        if os.path.realpath(folder) in folders and all(_is_sound(step, work) for step in steps):
            return Note(folders, steps)
    return None


def _is_sound(step: Step, work: str) -> bool:
    if not (isinstance(step.name, str) and isinstance(step.former, str) and isinstance(step.existed, bool)):
        return False
    names: Sequence[object] = (step.former,) if step.staged is None else (step.former, step.staged)
    own = [isinstance(name, str) and _OWN.fullmatch(name) for name in names]
    is_plain = (
        step.name not in ("", ".", "..") and os.path.basename(step.name) == step.name and _can_be_named(step.name)
    )
    return is_plain and ":" not in step.name[1:2] and all(match and match[1] == work for match in own)


def _can_be_named(name: str) -> bool:
    """False for a name that no file can have, though JSON can hold it."""
    try:
        return b"\0" not in os.fsencode(name)
    except UnicodeEncodeError:
        return False


def _is_plain(path: Path) -> bool:
    try:
        return stat.S_ISREG(os.lstat(path).st_mode)
    except (OSError, ValueError):
        return False


def _remove(path: Path) -> None:
    with contextlib.suppress(FileNotFoundError):
        os.unlink(path)
