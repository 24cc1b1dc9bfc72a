"""Building an imported program in memory, and comparing every rung of it with the one it comes from."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby

from clickgen.comparing.outputs import Writes, writes_of
from clickgen.comparing.same import Likeness, compare
from clickgen.diagnostics import Diagnostic
from clickgen.importing.routines import ImportedRoutine, Piece
from clickgen.ir.program import Rung, loops_in
from clickgen.ladder.grid import DrawnRung, read_ladder
from clickgen.pipeline import BuildResult
from clickgen.source import Span


@dataclass
class Verdict:
    """What the comparison found: how many rungs are the same, and which of them are drawn otherwise."""

    verified: int = 0
    redrawn: list[tuple[ImportedRoutine, Piece]] = field(default_factory=list)
    refused: list[tuple[ImportedRoutine | None, Piece | None, Diagnostic]] = field(default_factory=list)
    """What a build does not take, with the rung where it belongs to one."""
    differing: list[tuple[ImportedRoutine, Piece, str]] = field(default_factory=list)
    """The rungs that do not come back, and why."""


def verdict_of(routines: Sequence[ImportedRoutine], result: BuildResult) -> Verdict:
    """Compare what was built with what was imported. The built program has a rung for every piece, in order."""
    verdict = Verdict()
    if not result.ok:
        _sort_out(routines, result, verdict)
        return verdict
    scratch = {row.address for row in result.scratch_rows}
    drawn = _drawn(result.files)
    built = {routine.name: routine for routine in result.routines}
    called = {routine.name: [piece.drawn for piece in routine.pieces if piece.drawn] for routine in routines}
    calls: dict[str, Writes] = {}
    for routine in routines:
        runs: list[list[DrawnRung]] = []
        rungs = drawn.get(routine.name, [])
        start = 0
        for _, group in groupby(built[routine.name].rungs, key=lambda rung: rung.span):
            stop = start + len(list(group))
            runs.append(rungs[start:stop])
            start = stop
        if runs and routine.pieces:
            # Nothing may stand behind the last rung.
            runs[min(len(runs), len(routine.pieces)) - 1] += rungs[start:]
        for piece, run in zip(routine.pieces, runs, strict=False):
            if piece.drawn is None or piece.rung is None:
                continue
            if not run:
                verdict.differing.append((routine, piece, "the rung is missing in what was built"))
                continue
            reason = _difference(piece.drawn, run)
            if len(run) > 1 and not calls:
                calls = {name: writes_of(rungs) for name, rungs in called.items()}
            compared = compare([piece.drawn], run, scratch, calls)
            if reason or not compared.is_same:
                verdict.differing.append((routine, piece, reason or compared.reason))
                continue
            verdict.verified += 1
            if compared.likeness is not Likeness.IDENTICAL:
                verdict.redrawn.append((routine, piece))
        if len(runs) < len(routine.pieces):
            piece = routine.pieces[len(runs)]
            verdict.differing.append((routine, piece, "the rung is missing in what was built"))
    return verdict


def _difference(drawn: DrawnRung, run: Sequence[DrawnRung]) -> str:
    """What is wrong with the comment; spaces at the ends of lines, which a source cannot keep, aside."""
    before = [line.rstrip() for line in drawn.comment.split("\n")]
    after = [line.rstrip() for line in run[0].comment.split("\n")]
    return "" if before == after else "its comment does not come back"


def _drawn(files: Mapping[str, str]) -> dict[str, list[DrawnRung]]:
    """The rungs of each routine out of the files of a build, main's parts one behind the other."""
    found: dict[str, list[DrawnRung]] = {}
    for name, text in sorted(files.items(), key=lambda item: _part(item[0])):
        if re.fullmatch(r"main(_\d+)?\.csv", name):
            found.setdefault("main", []).extend(read_ladder(text, name).rungs)
        elif name.startswith("subroutines/"):
            stem = name.removeprefix("subroutines/").removesuffix(".csv")
            found[stem] = list(read_ladder(text, name).rungs)
    return found


def _part(name: str) -> int:
    match = re.fullmatch(r"main_(\d+)\.csv", name)
    return int(match[1]) if match else 0


# -- what a build refuses ---------------------------------------------------------------------------------------------


def _sort_out(routines: Sequence[ImportedRoutine], result: BuildResult, verdict: Verdict) -> None:
    """Each error with the rung that it stands in."""
    places = _Places(routines, result)
    for problem in result.diagnostics:
        if problem.is_error:
            verdict.refused.append((*places.at(problem.span), problem._replace(message=places.seen(problem))))


class _Places:
    """Which rung of the project the lines of the program's files come from."""

    def __init__(self, routines: Sequence[ImportedRoutine], result: BuildResult) -> None:
        self._rungs: list[tuple[Span, ImportedRoutine, Piece]] = []
        program = result.facts.program if result.facts else None
        read = {routine.name: routine for routine in program.routines} if program else {}
        for routine in routines:
            if routine.name in read:
                written = flattened(read[routine.name].rungs)
                for rung, piece in zip(written, routine.pieces, strict=False):
                    self._rungs.append((rung.span, routine, piece))

    def seen(self, problem: Diagnostic) -> str:
        """The message with rungs in the place of the lines of a program that nobody has seen."""
        message = problem.message
        for label in problem.labels:
            routine, piece = self.at(label.span)
            if problem.span and routine and piece and piece.drawn:
                place = f"{routine.name} rung {piece.drawn.number}"
                message = message.replace(label.span.seen_from(problem.span), place)
        return message

    def at(self, span: Span | None) -> tuple[ImportedRoutine | None, Piece | None]:
        holding = [
            (own.end_line - own.line, index)
            for index, (own, _, _) in enumerate(self._rungs)
            if span is not None and span.path == own.path and own.line <= span.line <= own.end_line
        ]
        if not holding:
            return None, None
        _, routine, piece = self._rungs[min(holding)[1]]
        return routine, piece


def flattened(rungs: Sequence[Rung]) -> Iterator[Rung]:
    """The rungs as CLICK has them: a loop with a body is its own rung, those of the body, and its own again."""
    for rung in rungs:
        yield rung
        for loop in loops_in(rung.items):
            if loop.body is not None:
                yield from flattened(loop.body)
                yield rung
