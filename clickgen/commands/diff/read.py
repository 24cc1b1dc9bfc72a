"""Turns the names on the command line into sides: a program, ladder of CLICK, or one of both from git."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from clickgen.commands.diff.revision import Named, Tree, named_revision, open_tree
from clickgen.commands.diff.sides import BrokenProgram, Side, is_program, ladder_side, program_in, program_side
from clickgen.config import OWN_FILE, PROJECT_FILE, Config, Settings, find_config, read_config
from clickgen.problems.diagnostics import Diagnostic
from clickgen.table.names import TABLE_NAME
from clickgen.table.rows import Row
from clickgen.text.source import SourceFile, Span
from clickgen.workspace import CouldNotRun, Workspace

_LADDER_FILES = (".csv", ".json", ".tmp", ".scr")
"""The files that are read in a folder: ladder, nicknames, the source map, CLICK's program files."""


@dataclass(frozen=True)
class Wanted:
    """How sides are read: the settings of a program on disk, and the tables and settings that the person named.

    ``nicknames`` is the address table of programs, ``export`` that of ladder without its own. ``placed`` has the
    names that got their addresses on the other side only from a build. ``files`` is what this run has read.
    """

    settings_of: Callable[[str], Settings]
    files: Workspace
    nicknames: str | None = None
    export: str | None = None
    config: str | None = None
    placed: tuple[Row, ...] = ()


def read_side(text: str, wanted: Wanted, folder: Path, note: Callable[[str], None]) -> Side:
    """The side that a text names; a path that exists wins over a revision.

    ``folder`` is empty and receives the files that are read from git. Raises CouldNotRun.
    """
    if os.path.lexists(text):
        if os.path.isdir(text) and (name := program_in(Path(text), text, wanted.files)) is not None:
            text = os.path.join(text, name)
        if is_program(text) and not os.path.isdir(text):
            return program_side(Path(text), text, wanted.settings_of(text), wanted.files, wanted.placed)
        return ladder_side(Path(text), text, Path(wanted.export) if wanted.export else None, wanted.files)
    named = named_revision(text)
    if named is None:
        raise CouldNotRun(
            f"there is no file, folder or revision {text!r}; a revision of git is REV:PATH, such as HEAD:prog.py"
        )
    tree = open_tree(named, folder)
    path, said = tree.find()
    if said:
        note(said)
    try:
        return _Revision(tree, path, wanted).read()
    except BrokenProgram as error:
        raise _reworded(error, tree) from None
    except CouldNotRun as error:
        raise CouldNotRun(*map(tree.reworded, error.lines)) from None


def absent_side(text: str) -> Side:
    """The side for a program that a revision does not have: nothing runs there."""
    named = named_revision(text)
    assert named is not None
    path = posixpath.normpath(named.path)
    return Side(f"{named.revision}:{path}", (), doubt=f"there is no {path} in {named.revision or 'the index'}")


def configured_in(revision: str, wanted: Wanted, folder: Path) -> list[str]:
    """The programs that the settings of a revision name, from the working folder. Raises CouldNotRun."""
    tree = open_tree(Named(revision, "."), folder)
    config = _Revision(tree, "", wanted).config()
    if not config.root.is_relative_to(tree.folder):
        return []
    places = [Path(os.path.relpath(program.path, tree.working_folder)) for program in config.programs]
    return [f"./{place.as_posix()}" for place in places]


@dataclass(frozen=True)
class _Revision:
    """A side from git. Its surroundings, settings and table included, are those of the revision."""

    tree: Tree
    path: str
    wanted: Wanted

    def read(self) -> Side:
        tree, place, shown = self.tree, self.tree.place(self.path), self.tree.shown(self.path)
        if is_program(self.path) and not tree.is_folder(self.path):
            tree.put([self.path], must_be_there=True)
            around = posixpath.dirname(self.path)
            tree.put(tree.below(around, lambda name: "/" not in name and name.endswith(".py")))
            tree.put([posixpath.join(around, TABLE_NAME)], must_be_there=True)
            return program_side(place, shown, self._settings(place), self.wanted.files, self.wanted.placed)
        if tree.is_folder(self.path):
            name = self._program()
            if name is not None:
                return replace(self, path=posixpath.join(self.path, name)).read()
            files = tree.below(self.path, lambda name: name.lower().endswith(_LADDER_FILES))
            tree.put(files, must_be_there=True)
            place.mkdir(parents=True, exist_ok=True)
        else:
            tree.put([self.path], must_be_there=True)
            folders = (posixpath.dirname(self.path), posixpath.dirname(posixpath.dirname(self.path)))
            tree.put(posixpath.join(folder, name) for folder in folders for name in ("main.csv", TABLE_NAME))
        export = self.wanted.export
        return ladder_side(place, shown, self._as_it_was(Path(export)) if export else None, self.wanted.files)

    def _program(self) -> str | None:
        """The program in a folder of programs."""
        tree, place = self.tree, self.tree.place(self.path)
        tree.put(tree.below(self.path, lambda name: "/" not in name and name.lower().endswith((".py", *_LADDER_FILES))))
        place.mkdir(parents=True, exist_ok=True)
        return program_in(place, tree.shown(self.path), self.wanted.files)

    def _settings(self, place: Path) -> Settings:
        config = self.config()
        if config.root.is_relative_to(self.tree.folder):
            own = config.program(place)
        else:
            own = config.program(self._top / self.path)
        named = self.wanted.nicknames
        table = Path(named) if named is not None else own.nicknames
        return Settings(None if table is None else self._as_it_was(table), named is not None, reserved=config.reserved)

    def config(self) -> Config:
        """The named settings, else those of the working folder, as the revision has them."""
        if self.wanted.config:
            return read_config(self._as_it_was(Path(self.wanted.config)), self.wanted.files)
        tree = self.tree
        folder = tree.here
        while True:
            tree.put((posixpath.join(folder, name) for name in (OWN_FILE, PROJECT_FILE)), must_be_there=True)
            if not folder:
                break
            folder = posixpath.dirname(folder)
        tree.working_folder.mkdir(parents=True, exist_ok=True)
        config = find_config(tree.working_folder, self.wanted.files)
        if config.file is None or config.file.is_relative_to(tree.folder):
            return config
        return find_config(self._top.parent, self.wanted.files)

    @property
    def _top(self) -> Path:
        """The root of the repository on disk."""
        depth = len(self.tree.here.split("/")) if self.tree.here else 0
        return (Path.cwd(), *Path.cwd().parents)[depth]

    def _as_it_was(self, path: Path) -> Path:
        """A file as the revision has it; if it does not have it, as it is on disk."""
        inside = self.tree.path_of(path)
        if inside is None:
            absolute = Path(os.path.normpath(path.absolute()))
            inside = absolute.relative_to(self._top).as_posix() if absolute.is_relative_to(self._top) else None
            if inside is None or inside not in self.tree.blobs:
                return path
        self.tree.put([inside], must_be_there=True)
        return self.tree.place(inside)


def _reworded(error: BrokenProgram, tree: Tree) -> BrokenProgram:
    """The problems of a revision's program, at places in the revision."""

    def span(there: Span) -> Span:
        return there._replace(path=tree.reworded(there.path))

    problems: list[Diagnostic] = []
    for each in error.problems:
        labels = tuple(label._replace(span=span(label.span), text=tree.reworded(label.text)) for label in each.labels)
        problems.append(
            each._replace(
                message=tree.reworded(each.message),
                span=each.span and span(each.span),
                help=tree.reworded(each.help),
                labels=labels,
            )
        )
    sources = [SourceFile(tree.reworded(source.path), source.text) for source in error.sources]
    return BrokenProgram(error.shown, problems, sources)
