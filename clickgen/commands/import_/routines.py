"""The routines of a project on their way into a program: each drawn rung and its result."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from clickgen.click.read.grid import DrawnRung
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.project import DrawnRoutine, Project
from clickgen.click.read.rungs import import_rung, is_comment_kept, routine_of
from clickgen.dialects.registry import default
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import Always
from clickgen.ir.made import ending, left_out, nothing
from clickgen.ir.program import Action, Item, Routine, Rung, actions_in
from clickgen.text.source import Span


@dataclass
class RungImport:
    """One drawn rung and its form in the program: one rung, or several if a build draws it as several.

    Without any it cannot be kept, and ``faults`` say why. ``drawn`` is None for a placeholder for damaged
    text between the rungs of a file.
    """

    drawn: DrawnRung | None
    rungs: tuple[Rung, ...] = ()
    notes: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    """Remarks on the rung for a person, and on details that do nothing."""
    faults: list[tuple[str, LadderProblem]] = field(default_factory=list)
    """The reasons why it cannot be kept, each with the code of its problem."""
    is_settled: bool = False
    """True if it has been written as a build draws it, so that a second import gives the same source."""

    def lose(self, code: str, reason: str) -> None:
        """Record that it cannot be kept after all."""
        assert self.drawn is not None
        self.rungs, self.notes, self.remarks = (), (), ()
        self.faults.append((code, LadderProblem(reason, self.drawn.file, self.drawn.line, self.drawn.number)))


@dataclass
class ImportedRoutine:
    """A routine of the project, by CLICK's name and by that of its function."""

    name: str
    function: str
    is_main: bool
    file: str
    pieces: list[RungImport]

    @property
    def count(self) -> int:
        """The rungs that were drawn."""
        return sum(piece.drawn is not None for piece in self.pieces)


def imported_routines(project: Project) -> list[ImportedRoutine]:
    """Every routine of a project, rung by rung."""
    functions: set[str] = set()
    found: list[ImportedRoutine] = []
    for routine in project.routines:
        # A function must not be called like another subroutine.
        others = {other.name for other in project.routines if other is not routine}
        function = "main" if routine.is_main else default().function_name(routine.name, functions | others)
        functions.add(function)
        pieces = [_piece(drawn) for drawn in routine.rungs]
        pieces += [RungImport(None, faults=[(problem.code, problem)]) for problem in _between(project, routine)]
        found.append(ImportedRoutine(routine.name, function, routine.is_main, routine.file, pieces))
    names = {routine.name.lower(): routine.name for routine in project.routines}
    for piece in (piece for routine in found for piece in routine.pieces):
        for called in calls_of(piece):
            name = names.get(called.lower(), called)
            if name != called and piece.drawn is not None:
                piece.lose("CG702", f"it calls {called!r}, and the subroutine is called {name!r}")
                break
    return found


def _piece(drawn: DrawnRung) -> RungImport:
    if drawn.problems:
        return RungImport(drawn, faults=[(problem.code, problem) for problem in drawn.problems])
    try:
        imported = import_rung(drawn)
    except LadderProblem as problem:
        return RungImport(drawn, faults=[("CG702", problem.in_rung(drawn.number))])
    return RungImport(drawn, (imported.rung,), imported.notes, imported.remarks)


def _between(project: Project, routine: DrawnRoutine) -> Iterator[LadderProblem]:
    """The problems in the files of a routine outside its rungs; main has those that belong to no routine."""
    if not project.problems:
        return
    files = {rung.file for rung in routine.rungs} | {routine.file}
    others = {file for other in project.routines for file in (other.file, *(rung.file for rung in other.rungs))}
    for problem in project.problems:
        if problem.file in files or (routine is project.routines[0] and problem.file not in others):
            yield problem


# -- as a program -----------------------------------------------------------------------------------------------------


def as_routines(routines: Iterable[ImportedRoutine]) -> list[Routine]:
    """The routines as they are written, with marked rungs in place of those that could not be kept."""
    return [
        _routine(routine, [rung for piece in routine.pieces for rung in piece.rungs or (_marked(piece),)])
        for routine in routines
    ]


def as_proof(routines: Iterable[ImportedRoutine]) -> list[Routine]:
    """The routines for a build: a NOP in place of each rung that could not be kept, and the missing parts added.

    Main ends with ``end()``, a subroutine with ``return``, every subroutine that is called exists, and there is a main.
    """
    found: list[Routine] = []
    routines = list(routines)
    for routine in routines:
        rungs = [rung for piece in routine.pieces for rung in piece.rungs or (_nothing(piece),)]
        last = rungs[-1:] if not routine.is_main else rungs
        if not any(_is_ending(rung, routine.is_main) for rung in last):
            span = rungs[-1].span if rungs else Span(routine.file, 1, 1, 1, 2)
            rungs.append(_rung(span, ending(routine.is_main, span)))
        found.append(_routine(routine, rungs))
    span = Span("", 1, 1, 1, 2)
    if not any(routine.is_main for routine in routines):
        found.insert(0, Routine("main", (_rung(span, ending(True, span)),), span, True))
    empty = (_rung(span, ending(False, span)),)
    missing = missing_subroutines(routines)
    taken = {*missing, *(routine.name for routine in routines), *(routine.function for routine in routines)}
    for name in missing:
        function = default().function_name(name, taken - {name})
        taken.add(function)
        found.append(routine_of(name, empty, False, function))
    return found


def missing_subroutines(routines: Iterable[ImportedRoutine]) -> list[str]:
    """The subroutines that are called but do not exist."""
    routines = list(routines)
    known = {routine.name for routine in routines}
    called = dict.fromkeys(name for routine in routines for piece in routine.pieces for name in calls_of(piece))
    return [name for name in called if name not in known]


def calls_of(piece: RungImport) -> Iterator[str]:
    """The subroutines that a rung calls, by CLICK's names."""
    for rung in piece.rungs:
        for action in actions_in(rung.items):
            if action.effects.flow is Flow.CALL:
                yield action.called


def is_complete(routine: ImportedRoutine) -> bool:
    """True if the routine ends as CLICK wants it: main somewhere with ``end()``, a subroutine with ``return``.

    click-facts [control.end, control.return]
    """
    pieces = routine.pieces if routine.is_main else routine.pieces[-1:]
    return any(not piece.rungs or any(_is_ending(rung, routine.is_main) for rung in piece.rungs) for piece in pieces)


def _is_ending(rung: Rung, is_main: bool) -> bool:
    """True for an unconditional ``end()`` in main, or ``return`` in a subroutine."""
    flow = Flow.END if is_main else Flow.RETURN
    return isinstance(rung.condition, Always) and any(
        isinstance(item, Action) and item.effects.flow is flow for item in rung.items
    )


def _routine(routine: ImportedRoutine, rungs: list[Rung]) -> Routine:
    return routine_of(routine.name, rungs, routine.is_main, routine.function)


def _nothing(piece: RungImport) -> Rung:
    """The placeholder for a rung that could not be kept while the others are compared."""
    return _rung(_span(piece), nothing(_span(piece)))


def _marked(piece: RungImport) -> Rung:
    """The rung that a build refuses, with the comment of the one that could not be kept."""
    span = _span(piece)
    reason = "; ".join(str(fault) for _, fault in piece.faults)
    rung = _rung(span, left_out(reason, span))
    comment = piece.drawn.comment if piece.drawn else ""
    return replace(rung, comment=comment if is_comment_kept(comment) else "")


def _rung(span: Span, *items: Item) -> Rung:
    return Rung(Always(span), items, "", span, span)


def _span(piece: RungImport) -> Span:
    if piece.drawn is not None:
        return piece.drawn.span
    [_, fault] = piece.faults[0]
    return Span(fault.file, fault.row or 1, 1, fault.row or 1, 2)
