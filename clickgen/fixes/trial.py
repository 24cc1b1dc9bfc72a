"""Tries the fixes of errors: one is offered only if the statement that it fixes has no error any more.

The program is read again with the fix in it, and with the fixes of the errors that come up in the same lines:
``x[1] AND x[2]`` becomes ``x[1] and x[2]``, and that ``all(x[1], x[2])``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from clickgen.ir.operands import Immediate, Named
from clickgen.ir.program import Program
from clickgen.ir.walk import rung_operands
from clickgen.problems.diagnostics import Diagnostic
from clickgen.text.edits import Edit, Fix, apply_fixes, fixes_that_fit

_ROUNDS_MAX = 6
"""This many times a fix may make room for another one in its lines."""
_TRIALS_MAX = 40
"""This many readings are spent on fixes that fail together; any left after that are offered after the others."""
_BROKEN_MAX = 20
"""This many other lines that Python cannot read are put aside to see the fixed one."""

_ACTION = "CG112"
"""A statement that becomes an action. ``fixes.judge`` has judged those in conditions."""
_OF_THE_ROUTINE = ("CG401", "CG403", "CG404", "CG408", "CG409")
"""Errors that another line of the routine removes."""

Idle = Callable[[str], str]
"""A line that does nothing in the place of one that cannot be read; "" where there is none."""


class Seen(NamedTuple):
    """A program and its findings. ``is_declared`` is False if some of what declares names could not be read."""

    problems: Sequence[Diagnostic]
    is_declared: bool
    program: Program | None = None
    """The program as it is written, with names."""


Look = Callable[[Mapping[str, bytes]], Seen]
"""Reads the program with other contents of some files, by their paths as problems name them."""


def tried(problems: Sequence[Diagnostic], texts: Mapping[str, bytes], look: Look, idle: Idle) -> list[Diagnostic]:
    """Return the problems, with only those fixes of errors that mend their statement.

    A fix that writes an action with a name is not safe if a declaration could not be read: it may name a block.
    """
    with_fix = [one for one in problems if one.is_error and one.fix is not None and _file_of(one) in texts]
    trials = _Trials(texts, look, idle)
    verdicts: dict[Diagnostic, _Verdict] = {}
    for is_safe in (True, False):
        group = [one for one in with_fix if one.fix is not None and one.fix.is_safe is is_safe]
        for one, verdict in trials.of(group, is_safe).items():
            verdicts[one] = verdict
    return [_judged(one, verdicts[one]) if one in verdicts else one for one in problems]


class _Verdict(NamedTuple):
    holds: bool
    is_declared: bool
    has_names: bool
    """True if the fix writes an action with a name."""
    fault: Diagnostic | None
    """The problem of the statement after the fix."""
    written: frozenset[str]
    """The texts that the fix writes, and those of the fixes that it makes room for."""


def _judged(problem: Diagnostic, verdict: _Verdict) -> Diagnostic:
    fix = problem.fix
    assert fix is not None
    if not verdict.holds:
        return problem._replace(fix=None, help=_help(problem, verdict))
    if fix.is_safe and verdict.has_names:
        return problem._replace(fix=fix._replace(is_safe=verdict.is_declared, rests_on_names=True))
    return problem


def _help(problem: Diagnostic, verdict: _Verdict) -> str:
    """A way out that works: if the text's own one meets another error, that error's way out is given."""
    written, fault = problem.help.removeprefix("write "), verdict.fault
    if fault is None or written not in verdict.written:
        return problem.help
    told = f"{written} would not build here, because {fault.message}"
    return f"{told}: {fault.help}" if fault.help else told


class _Trials:
    def __init__(self, texts: Mapping[str, bytes], look: Look, idle: Idle) -> None:
        self._texts = texts
        self._idle = idle
        self._look = look
        self._left = _TRIALS_MAX

    def of(self, group: Sequence[Diagnostic], is_safe: bool) -> dict[Diagnostic, _Verdict]:
        """The verdict of each: tried together first, as ``check --fix`` writes them, and those that fail alone."""
        if not group:
            return {}
        verdicts = self._together(group, is_safe)
        if len(group) > 1:
            for one, verdict in list(verdicts.items()):
                if not verdict.holds and self._left > 0:
                    verdicts[one] = self._together([one], is_safe)[one]
        return verdicts

    def _together(self, group: Sequence[Diagnostic], is_safe: bool) -> dict[Diagnostic, _Verdict]:
        files = {path: _File(self._texts[path]) for path in dict.fromkeys(map(_file_of, group))}
        places: dict[Diagnostic, _Place] = {}
        waiting = {id(one.fix): one for one in group}
        for path, file in files.items():
            fixes = [one.fix for one in group if one.fix is not None and _file_of(one) == path]
            for fix in file.taken(fixes):
                places[waiting[id(fix)]] = file.track(fix, waiting[id(fix)])
        for file in files.values():
            file.write()
        seen, is_whole, followers = self._until_quiet(files, is_safe)
        errors = [one for one in seen.problems if one.is_error and one.code not in _OF_THE_ROUTINE]
        verdicts: dict[Diagnostic, _Verdict] = {}
        for one in group:
            place = places.get(one)
            fault = next((each for each in errors if place and place.holds(each)), None)
            holds = place is not None and fault is None and is_whole[_file_of(one)]
            written = frozenset(edit.text for fix in (one.fix, *followers) if fix for edit in fix.edits)
            has_names = holds and place is not None and one.code == _ACTION and _writes_names(one, place, seen.program)
            verdicts[one] = _Verdict(holds, seen.is_declared, has_names, fault, written)
        return verdicts

    def _until_quiet(self, files: Mapping[str, _File], is_safe: bool) -> tuple[Seen, dict[str, bool], list[Fix]]:
        """Find what is left when no error in the fixed lines has a fix of its own any more.

        Also return whether each file could be read then, with other lines that Python cannot read put aside, and the
        fixes that were written on the way.
        """
        broken = rounds = 0
        followers: list[Fix] = []
        is_whole = dict.fromkeys(files, True)
        while True:
            self._left -= 1
            seen = self._look({path: file.data for path, file in files.items()})
            errors = [one for one in seen.problems if one.is_error and one.span is not None]
            fixes: dict[str, list[Fix]] = {}
            for one in errors:
                path = _file_of(one) if one.fix else ""
                if one.fix and path in files and (one.fix.is_safe or not is_safe) and files[path].is_mended(one):
                    fixes.setdefault(path, []).append(one.fix)
            if fixes and rounds < _ROUNDS_MAX:
                rounds += 1
                for path, found in fixes.items():
                    followers += files[path].taken(found)
                    files[path].write()
                continue
            unread = {
                one.span.path: one for one in errors if one.span and one.code in _UNREAD and one.span.path in files
            }
            put_aside = False
            for path, one in unread.items():
                if files[path].is_mended(one) or broken >= _BROKEN_MAX or not files[path].put_aside(one, self._idle):
                    is_whole[path] = False
                else:
                    broken += 1
                    put_aside = True
            if not put_aside:
                return seen, is_whole, followers


def _writes_names(problem: Diagnostic, place: _Place, program: Program | None) -> bool:
    """True if the fix of a problem writes the name of an address into its statement."""
    texts = [edit.text for edit in problem.fix.edits] if problem.fix else []
    path = _file_of(problem)
    routines = [one for one in program.routines if one.span.path == path] if program is not None else []
    operands = (one for routine in routines for rung in routine.rungs for one in rung_operands(rung))
    targets = (one.target if isinstance(one, Immediate) else one for one in operands if one.span.line in place.lines)
    return any(isinstance(one, Named) and any(one.name in text for text in texts) for one in targets)


_UNREAD = ("CG101", "CG118")
"""The errors that keep a file from being read at all."""


class _Place:
    """The lines that a fix wrote; other edits of the file move them."""

    def __init__(self, lines: Iterable[int]) -> None:
        self.lines = set(lines)

    def holds(self, problem: Diagnostic) -> bool:
        span = problem.span
        return span is not None and any(line in self.lines for line in range(span.line, span.end_line + 1))


class _File:
    """A file under trial."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self._places: list[_Place] = []
        self._chosen: list[Fix] = []

    def taken(self, fixes: Sequence[Fix]) -> list[Fix]:
        """Those of the fixes that can be written together; ``write`` writes them."""
        self._chosen = fixes_that_fit(self.data.decode("utf-8"), fixes)
        return self._chosen

    def track(self, fix: Fix, problem: Diagnostic) -> _Place:
        # A new line below another one leaves that one unchanged.
        written = [edit.span for edit in fix.edits if not edit.text.startswith("\n")]
        lines = {line for span in written for line in range(span.line, span.end_line + 1)}
        place = _Place(lines | ({problem.span.line} if problem.span else set()))
        self._places.append(place)
        return place

    def is_mended(self, problem: Diagnostic) -> bool:
        return any(place.holds(problem) for place in self._places)

    def write(self) -> None:
        text, _ = apply_fixes(self.data.decode("utf-8"), self._chosen)
        edits = sorted((edit for fix in self._chosen for edit in fix.edits), key=lambda edit: edit.span[1:])
        for place in self._places:
            place.lines = _moved(place.lines, edits)
        self.data = text.encode("utf-8")

    def put_aside(self, problem: Diagnostic, idle: Idle) -> bool:
        """Put what does nothing in the place of a line that cannot be read; False where there is nothing."""
        assert problem.span is not None
        lines = self.data.decode("utf-8").splitlines(keepends=True)
        number = problem.span.line - 1
        if not 0 <= number < len(lines):
            return False
        instead = idle(lines[number])
        if not instead:
            return False
        lines[number] = instead
        self.data = "".join(lines).encode("utf-8")
        return True


def _moved(lines: Iterable[int], edits: Sequence[Edit]) -> set[int]:
    """The lines of a text after these edits, which are in order and do not overlap."""
    moved: set[int] = set()
    for line in lines:
        # Everything that replaces a rewritten line belongs to it.
        there = [edit for edit in edits if edit.span.line <= line <= edit.span.end_line]
        first = min([line, *(edit.span.line for edit in there)])
        before = [edit for edit in edits if edit.span.end_line < first]
        first += sum(edit.text.count("\n") - (edit.span.end_line - edit.span.line) for edit in before)
        moved.update(range(first, first + sum(edit.text.count("\n") for edit in there) + 1))
    return moved


def _file_of(problem: Diagnostic) -> str:
    """The file that a fix changes; "" for one of several files."""
    assert problem.fix is not None
    paths = {edit.span.path for edit in problem.fix.edits}
    return paths.pop() if len(paths) == 1 else ""
