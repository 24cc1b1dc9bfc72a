"""An import from beginning to end, in memory: read, write as source, build, compare, report."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.project import MAIN, Project, read_project
from clickgen.click.read.rungs import import_rung
from clickgen.commands.import_.nicknames import Nicknames, declared_rows, nicknames_of, no_nicknames
from clickgen.commands.import_.routines import (
    ImportedRoutine,
    RungImport,
    as_proof,
    as_routines,
    calls_of,
    imported_routines,
    is_complete,
    missing_subroutines,
)
from clickgen.config import Settings
from clickgen.dialects.registry import default
from clickgen.instructions.offered import END, RETURN
from clickgen.ir.program import Routine, Rung
from clickgen.problems.diagnostics import Diagnostic
from clickgen.text.source import SourceFile, Span
from clickgen.text.wording import counted
from clickgen.text.write import put_in_place
from clickgen.workspace import CouldNotRun, Workspace, read_if_there

if TYPE_CHECKING:
    from clickgen.commands.import_.proof import Redrawn, Verdict
    from clickgen.results import BuildResult


@dataclass(frozen=True)
class Target:
    """The place for the program, and the settings for a build of it.

    ``program`` is its main file; ``is_folder`` gives each subroutine a file of its own beside it.
    """

    program: Path
    is_folder: bool = False
    is_shown: bool = False
    """True for a program without a place, which therefore declares its names itself."""
    settings: Settings = field(default_factory=Settings)

    @property
    def table(self) -> Path:
        """The address table that a build would use."""
        return self.settings.table_of(self.program)


@dataclass(frozen=True)
class ImportResult:
    """The result of an import, in memory. ``files`` has the files to write, the address table included."""

    source: Path
    target: Target
    routines: tuple[ImportedRoutine, ...]
    files: Mapping[Path, bytes]
    diagnostics: tuple[Diagnostic, ...]
    sources: tuple[SourceFile, ...]
    """The ladder files that were read as text."""
    verdict: Verdict | None
    """None if nothing was to be verified."""
    names: int
    """The addresses that have a nickname."""
    named_by: Path | None
    """The address table that the names come from."""

    @property
    def rungs(self) -> int:
        """The number of rungs in the source."""
        return sum(routine.count for routine in self.routines)

    @property
    def left_out(self) -> int:
        """The marked rungs in place of those that could not be kept."""
        return sum(not piece.rungs for routine in self.routines for piece in routine.pieces)

    @property
    def is_whole(self) -> bool:
        """True if nothing is missing that CLICK wants in a program."""
        has_main = any(routine.is_main for routine in self.routines)
        return has_main and not any(problem.code == "CG707" for problem in self.diagnostics)

    @property
    def ok(self) -> bool:
        """True if there is no error."""
        return not any(problem.is_error for problem in self.diagnostics)

    def write(self, replaces: bool = False) -> list[Path]:
        """Put the files in place, all of them or none; return those that really changed.

        Raises CouldNotRun if an existing file differs, unless this ``replaces`` it (an address table
        is never replaced), and OSError.
        """
        before = {path: _former(path) for path in self.files}
        taken = [path for path, data in self.files.items() if path.exists() and before[path] != data]
        table = self.target.table
        if table in taken and self.named_by is not None and table.resolve() == self.named_by.resolve():
            message = f"{table} would lose the nicknames that are left out"
            raise CouldNotRun(f"{message}: give these addresses legal names there, or choose another place with -o")
        if table in taken:
            message = f"{table} says otherwise than {self.named_by}"
            raise CouldNotRun(f"{message}: take them in with clickgen nicknames merge, or choose another place with -o")
        if taken and not replaces:
            names = ", ".join(map(str, taken))
            raise CouldNotRun(f"{names} would be overwritten: choose another place with -o, or add --force")
        return put_in_place(self.files, (), before, no_links=self.files)


def _former(path: Path) -> bytes | None:
    """Read a file that is about to be replaced. It may have changed since the import read it, so this reads it anew."""
    return read_if_there(path) if path.is_file() else None


def import_project(
    source: Path,
    target: Target,
    nicknames: Path | None = None,
    keep_going: bool = False,
    verifies: bool = True,
    files: Workspace | None = None,
) -> ImportResult:
    """Import the contents of ``source``: a bundle, a ladder CSV, a clipboard capture, CLICK's program files.

    ``nicknames`` names the address table to take names from; without it that of the bundle, else the one at the
    place for the program. A rung that cannot be kept is an error; with ``keep_going`` a marked rung takes its
    place. Nothing is written (see ``ImportResult.write``). Raises CouldNotRun if there is nothing to import.
    """
    files = files or Workspace()
    project = read_project(source, files)
    for routine in project.routines:
        if routine.name == MAIN and not routine.is_main:
            raise CouldNotRun(f"{routine.file}: a subroutine cannot be called main, as the main program is")
    if not any(routine.rungs for routine in project.routines) and not project.problems:
        raise CouldNotRun(f"{source} holds no rungs")
    names = _nicknames(project, target, nicknames, files)
    run = _Import(project, target, keep_going, imported_routines(project), names, files)
    verdict = run.verified() if verifies else None
    return run.result(verdict)


def _nicknames(project: Project, target: Target, given: Path | None, files: Workspace) -> Nicknames:
    for path in (given, project.nicknames):
        if path is not None:
            return nicknames_of(path, str(path), files=files)
    if target.table.exists() and not target.table.is_dir():
        return nicknames_of(target.table, str(target.table), True, files)
    return no_nicknames()


@dataclass
class _Import:
    """An import in progress."""

    project: Project
    target: Target
    keep_going: bool
    routines: list[ImportedRoutine]
    nicknames: Nicknames
    files: Workspace
    problems: list[Diagnostic] = field(default_factory=list)
    _written: tuple[Sequence[Routine], dict[Path, str]] = ((), {})
    """The routines that were written last, and their texts: most often the proof and the result write the same ones."""

    def verified(self) -> Verdict:
        """Build and compare. Rungs that a build refuses, or that come back different, are no longer kept.

        Without some of its rungs a program may be refused for another reason, and a rung that a build draws differently
        may be written differently: so this repeats until nothing changes.
        """
        from clickgen.click.compare.same import Likeness
        from clickgen.commands.import_.proof import verdict_of

        while True:
            verdict = verdict_of(self.routines, self._built())
            is_lost = False
            lost_before = self._lost()
            for routine, piece, problem in verdict.refused:
                if piece is None:
                    self._refuse(routine, problem)
                elif piece.rungs:
                    after = f"; this may follow from {lost_before}, which is not kept" * (problem.code in _LOOPS)
                    reason = f"a build refuses it: {problem.message} ({problem.code}){after if lost_before else ''}"
                    piece.lose("CG702", reason)
                    is_lost = True
            for piece, compared in verdict.differing:
                is_wrong = compared.likeness is Likeness.DIFFERENT
                what = "it would not be the same" if is_wrong else "it cannot be proven the same"
                piece.lose("CG703" if is_wrong else "CG702", f"{what}: {compared.reason}")
                is_lost = True
            settled = [] if is_lost else [_settle(redrawn) for redrawn in verdict.redrawn]
            if not is_lost and not any(settled):
                return verdict

    def _lost(self) -> str:
        """The first rung that could not be kept."""
        pieces = ((routine, piece) for routine in self.routines for piece in routine.pieces if not piece.rungs)
        return next((_named(*pair).removesuffix(": ") for pair in pieces), "")

    def _refuse(self, routine: ImportedRoutine | None, problem: Diagnostic) -> None:
        """Report a problem that belongs to no rung. The address table has reported its own faults."""
        if any((own.code, own.message) == (problem.code, problem.message) for own in self.nicknames.problems):
            return
        place = LadderProblem(problem.message, routine.file) if routine else None
        message = f"a build refuses {routine.name if routine else 'the program'}: {problem.message} ({problem.code})"
        self._add("CG702", message, place, "change it in CLICK and import again")

    def _built(self) -> BuildResult:
        from clickgen.api import build

        files = {path: text.encode() for path, text in self._texts(as_proof(self.routines)).items()}
        overlay = {os.path.realpath(path): data for path, data in {**files, **self._table()}.items()}
        return build(self.target.program, settings=self.target.settings, workspace=self.files.apart(overlay))

    def _table(self) -> dict[Path, bytes]:
        """The address table at its place; none if names were not given, or are declared in the program."""
        is_written = self.nicknames.is_given and not self.target.is_shown
        return {self.target.table: self.nicknames.table.to_bytes()} if is_written else {}

    def _texts(self, routines: Sequence[Routine]) -> dict[Path, str]:
        if routines != self._written[0]:
            self._written = routines, self._text_of(routines)
        return self._written[1]

    def _text_of(self, routines: Sequence[Routine]) -> dict[Path, str]:
        names = self.nicknames.names
        if not self.target.is_folder:
            declared = declared_rows(routines, self.nicknames) if self.target.is_shown else ()
            return {self.target.program: default().write(routines, names, declared)}
        return {
            self.target.program.parent / name: text for name, text in default().write_files(routines, names).items()
        }

    # -- reporting ----------------------------------------------------------------------------------------------------

    def result(self, verdict: Verdict | None) -> ImportResult:
        """Return the files to write and the report; without ``keep_going`` an error leaves nothing to write."""
        table = self.nicknames.table
        files = {path: text.encode() for path, text in self._texts(as_routines(self.routines)).items()}
        files |= self._table()
        self.problems += self.nicknames.problems
        for routine in self.routines:
            for piece in routine.pieces:
                self._report(routine, piece)
        self._report_missing()
        stops = not self.keep_going and any(problem.is_error for problem in self.problems)
        return ImportResult(
            self.project.source,
            self.target,
            tuple(self.routines),
            {} if stops else files,
            tuple(dict.fromkeys(self.problems)),
            tuple(SourceFile(name, text) for name, text in self.project.texts.items()),
            verdict,
            sum(bool(row.nickname) for row in table.rows),
            self.nicknames.path,
        )

    def _report(self, routine: ImportedRoutine, piece: RungImport) -> None:
        for code, fault in piece.faults:
            self._add(code, f"{_named(routine, piece)}{fault.message}", fault)
        notes_of_file = piece.drawn.notes if piece.drawn is not None and piece.rungs else ()
        for code, notes in (("CG704", piece.notes), ("CG705", piece.remarks), ("CG709", notes_of_file)):
            for note in notes:
                assert piece.drawn is not None
                place = LadderProblem(note, piece.drawn.file, piece.drawn.line, piece.drawn.number)
                self._add(code, f"{_named(routine, piece)}{note}", place)

    def _report_missing(self) -> None:
        for name in missing_subroutines(self.routines):
            calls = ((routine, piece) for routine in self.routines for piece in routine.pieces)
            routine, piece = next(pair for pair in calls if name in calls_of(pair[1]))
            assert piece.drawn is not None
            message = f"{_named(routine, piece)}it calls {name!r}, which {self.project.source} does not hold"
            place = LadderProblem(message, piece.drawn.file, piece.drawn.line, piece.drawn.number)
            self._add("CG707", message, place, "import the whole project, or write the subroutine by hand")
        for routine in self.routines:
            if not is_complete(routine):
                spell = default().spell
                missing = spell.call(END if routine.is_main else RETURN)
                message = f"{routine.name} has no unconditional {missing}: what was imported is a part of a program"
                self._add("CG707", message, None, f"add {spell.rung('', missing)} at the end before you build it")

    def _add(self, code: str, message: str, place: LadderProblem | None, help: str = "") -> None:
        span = Span(place.file, place.row, 1, place.row, 2) if place is not None and place.row else None
        if span is None and place is not None:
            message = f"{place.file}: {message}"
        self.problems.append(Diagnostic(code, message, span, help or _HELP.get(code, "")))


_HELP = {
    "CG701": "mend the file, or export it again; --keep-going leaves a marked rung in its place",
    "CG702": "change it in CLICK and import again, or use --keep-going, which leaves a marked rung in its place",
    "CG703": "if CLICK drew the rung, please report it with the file; if another program wrote the file, draw the rung "
    "as CLICK does, or use --keep-going, which leaves a marked rung in its place",
    "CG708": "draw the rung again in CLICK, or use --keep-going, which leaves a marked rung in its place",
    "CG710": "in CLICK, put some of the contacts on a bit in a rung before and copy the rungs again; or copy the "
    "others without this one, and write it by hand",
    "CG709": "look whether the comment says in the program what it says in CLICK",
    "CG704": "what it does is the same: look whether it was meant so",
    "CG705": "there is nothing to do",
}


_LOOPS = ("CG407", "CG408", "CG409", "CG422", "CG425")
"""The codes for one end of a loop without the other."""


def _settle(redrawn: Redrawn) -> bool:
    """Write a rung as a build draws it, so that a second import gives the same source; return False if it stays.

    A rung that needs scratch cells stays as it was drawn: nobody would write it with them.
    """
    piece = redrawn.piece
    if piece.is_settled:
        return False
    piece.is_settled = True
    if redrawn.needs_scratch:
        count = counted(len(redrawn.run), "rung")
        piece.notes += (f"a build draws it as {count} of CLICK, with scratch cells: see the comments in the table",)
        return False
    try:
        found = tuple(import_rung(drawn).rung for drawn in redrawn.run)
    except LadderProblem:
        return False
    found = (replace(found[0], comment=piece.rungs[0].comment), *found[1:])
    if _written(found) == _written(piece.rungs):
        return False
    piece.rungs = found
    if len(found) > 1:
        piece.notes += (f"it becomes {counted(len(found), 'rung')}, as a build has to draw it",)
    return True


def _written(rungs: tuple[Rung, ...]) -> str:
    return default().write([Routine("", rungs, Span("", 1, 1, 1, 2), True)], {})


def _named(routine: ImportedRoutine, piece: RungImport) -> str:
    return f"{routine.name} rung {piece.drawn.number}: " if piece.drawn is not None else ""
