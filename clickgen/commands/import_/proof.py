"""Builds an imported program in memory, and compares every rung of it with the one it comes from."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby

from clickgen.click.compare.outputs import ALONE, Surroundings, touched_by
from clickgen.click.compare.same import Comparison, Likeness, compare
from clickgen.click.read.built import built_ladders
from clickgen.click.read.grid import DrawnRung
from clickgen.commands.import_.routines import ImportedRoutine, RungImport
from clickgen.device.banks import Address
from clickgen.ir.program import Rung, loops_in
from clickgen.problems.diagnostics import Diagnostic
from clickgen.results import BuildResult
from clickgen.text.source import Span


@dataclass(frozen=True)
class Redrawn:
    """A rung that a build draws differently: the CLICK rungs in its place, and whether they need scratch cells."""

    routine: ImportedRoutine
    piece: RungImport
    run: tuple[DrawnRung, ...]
    needs_scratch: bool


@dataclass
class Verdict:
    """The result of the comparison: how many rungs are the same, and which of them are drawn differently."""

    verified: int = 0
    redrawn: list[Redrawn] = field(default_factory=list)
    refused: list[tuple[ImportedRoutine | None, RungImport | None, Diagnostic]] = field(default_factory=list)
    """The errors of a build, each with its rung if it belongs to one."""
    differing: list[tuple[RungImport, Comparison]] = field(default_factory=list)
    """The rungs that come back different, or are not proven to be the same."""


MISSING = Comparison(Likeness.DIFFERENT, "the rung is missing in what was built")


def verdict_of(routines: Sequence[ImportedRoutine], result: BuildResult) -> Verdict:
    """Compare the build with the import. The program has its rungs in the order of the pieces."""
    verdict = Verdict()
    if not result.ok:
        _sort_out(routines, result, verdict)
        return verdict
    scratch = frozenset(row.address for row in result.scratch_rows)
    called = {routine.name: [piece.drawn for piece in routine.pieces if piece.drawn] for routine in routines}
    surroundings: Surroundings | None = None
    runs = _runs(routines, result)
    for routine in routines:
        for piece, run in zip(routine.pieces, runs[routine.name], strict=True):
            if piece.drawn is None or not piece.rungs:
                continue
            if len(run) > 1 and surroundings is None:
                surroundings = Surroundings.of(called)
            compared = _compared(piece.drawn, run, scratch, surroundings or ALONE)
            if not compared.is_same:
                verdict.differing.append((piece, compared))
                continue
            verdict.verified += 1
            if compared.likeness is not Likeness.IDENTICAL:
                needs_scratch = any(touched_by(box).addresses & scratch for rung in run for box in rung.boxes)
                verdict.redrawn.append(Redrawn(routine, piece, tuple(run), needs_scratch))
    return verdict


def _runs(routines: Sequence[ImportedRoutine], result: BuildResult) -> dict[str, list[list[DrawnRung]]]:
    """The CLICK rungs that were built from each piece of each routine; none if the ladder ends before it.

    The last rung of a program includes everything after it.
    """
    drawn = built_ladders(result.files)
    found: dict[str, list[list[DrawnRung]]] = {}
    for built in result.routines:
        sizes = [len(list(group)) for _, group in groupby(built.rungs, key=lambda rung: rung.span)]
        routine = next((routine for routine in routines if routine.name == built.name), None)
        rungs = list(drawn[built.name].rungs) if built.name in drawn else []
        runs = found.setdefault(built.name, [])
        start = group = 0
        for piece in routine.pieces if routine else ():
            count = len(piece.rungs) or 1
            stop = start + sum(sizes[group : group + count])
            runs.append(rungs[start:stop])
            start, group = stop, group + count
        if runs:
            runs[-1] += rungs[start + sum(sizes[group:]) :]
    return found


def _compared(
    drawn: DrawnRung, run: Sequence[DrawnRung], scratch: frozenset[Address], surroundings: Surroundings
) -> Comparison:
    """Compare logic and comment, except spaces at the ends of the comment's lines, which a source cannot keep."""
    if not run:
        return MISSING
    before, after = ([line.rstrip() for line in comment.split("\n")] for comment in (drawn.comment, run[0].comment))
    if before != after:
        return Comparison(Likeness.DIFFERENT, "its comment does not come back")
    return compare([drawn], run, scratch, surroundings)


# -- what a build refuses ---------------------------------------------------------------------------------------------


def _sort_out(routines: Sequence[ImportedRoutine], result: BuildResult, verdict: Verdict) -> None:
    """Yield each error with its rung."""
    places = _Places(routines, result)
    for problem in result.diagnostics:
        if problem.is_error:
            verdict.refused.append((*places.at(problem.span), problem._replace(message=places.seen(problem))))


class _Places:
    """The project's rung, or else routine, for each line of the program's files."""

    def __init__(self, routines: Sequence[ImportedRoutine], result: BuildResult) -> None:
        self._spans: list[tuple[Span, ImportedRoutine, RungImport | None]] = []
        program = result.facts.program if result.facts else None
        read = {routine.name: routine for routine in program.routines} if program else {}
        for routine in routines:
            if routine.name in read:
                written = read[routine.name]
                self._spans += [(written.span, routine, None), (written.named_at, routine, None)]
                pieces = (piece for piece in routine.pieces for _ in piece.rungs or (None,))
                for rung, piece in zip(flattened(written.rungs), pieces, strict=False):
                    self._spans.append((rung.span, routine, piece))
        paths = "|".join(re.escape(source.path) for source in result.sources)
        self._line = re.compile(rf"\bline (\d+)\b|(?P<path>{paths}):(?P<line>\d+)(?::\d+)?")

    def seen(self, problem: Diagnostic) -> str:
        """The message with rungs in place of the lines of a program that nobody has seen."""
        here = problem.span.path if problem.span else ""

        def place(match: re.Match[str]) -> str:
            line = int(match["line"] or match[1])
            routine, piece = self.at(Span(match["path"] or here, line, 1, line, 2))
            if routine is None:
                return match[0]
            return f"{routine.name} rung {piece.drawn.number}" if piece and piece.drawn else routine.file

        return self._line.sub(place, problem.message)

    def at(self, span: Span | None) -> tuple[ImportedRoutine | None, RungImport | None]:
        """The innermost rung around a place."""
        holding = [
            (own.end_line - own.line, index)
            for index, (own, _, _) in enumerate(self._spans)
            if span is not None and span.path == own.path and own.line <= span.line <= own.end_line
        ]
        if not holding:
            return None, None
        _, routine, piece = self._spans[min(holding)[1]]
        return routine, piece


def flattened(rungs: Sequence[Rung]) -> Iterator[Rung]:
    """The rungs as CLICK has them: a loop with a body is its own rung, those of the body, and its own again."""
    for rung in rungs:
        yield rung
        for loop in loops_in(rung.items):
            if loop.body is not None:
                yield from flattened(loop.body)
                yield rung
