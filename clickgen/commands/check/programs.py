"""One check of a repository: judge, select, silence, fix."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from clickgen.commands.check.agree import agreed
from clickgen.commands.check.cache import Cache, Cached
from clickgen.commands.check.judging import Judge
from clickgen.config import Config
from clickgen.dialects.discover import Target, discover, partly_judged, wholly_judged
from clickgen.dialects.registry import dialect_of
from clickgen.problems.codes import CODES, LEFT, waits_for_errors
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.rules.select import Selection
from clickgen.text.edits import Fix
from clickgen.text.patterns import matches
from clickgen.workspace import Workspace
from clickgen.workspace.memory import Memory

if TYPE_CHECKING:
    from clickgen.commands.check.baseline import Baseline
    from clickgen.text.source import SourceFile

_ROUNDS_MAX = 10
"""Fixes may make room for others; this many rounds, also in case one fix undoes another."""


class Request(NamedTuple):
    """The files to check and the settings. ``stdin`` is the text of the only path, which need not exist then."""

    config: Config
    selection: Selection = Selection()
    paths: tuple[str, ...] = ()
    exclude: tuple[str, ...] = ()
    force_exclude: bool = False
    use_cache: bool = True
    stdin: bytes | None = None
    progress: Callable[[int, int], None] = lambda *_: None
    baseline: Baseline | None = None
    """Known findings: neither reported nor fixed nor silenced."""
    elsewhere: Callable[[Target], frozenset[str]] | None = None
    """The names that the other programs around the table of one use: called if a name seems to have left."""
    files: Workspace | None = None
    """The files that this run has read already."""


class Outcome(NamedTuple):
    """The findings in the files that were ``checked``, read in ``workspace``, with the changes of fixes in it."""

    findings: tuple[Diagnostic, ...]
    checked: tuple[str, ...]
    workspace: Workspace
    empty: tuple[str, ...] = ()
    """Folders that were to be checked and have no program."""
    known: int = 0
    """How many findings the baseline keeps back."""
    fixed: int = 0
    before: Mapping[str, bytes] = {}
    """Files that fixes change, as they are on disk."""
    after: Mapping[str, bytes] = {}

    @property
    def line_of(self) -> Callable[[str, int], str]:
        """The text of a line of a file as it was judged; "" if there is none."""

        @cache
        def lines(path: str) -> list[str]:
            try:
                source = _decoded(path, self.workspace.read(path))
            except OSError:
                return []
            return source.lines if source else []

        return lambda path, number: lines(path)[number - 1] if 0 < number <= len(lines(path)) else ""

    def write(self) -> list[Path]:
        """Put the fixed files in place, all of them or none. Raises OSError, ChangedMeanwhile."""
        if not self.after:
            return []
        from clickgen.text.write import put_in_place

        return put_in_place(
            {Path(path): data for path, data in self.after.items()},
            (),
            {Path(path): data for path, data in self.before.items()},
        )


def run(request: Request, fix: bool = False, unsafe: bool = False) -> Outcome:
    """Check, and with ``fix`` apply fixes in memory. Raises CouldNotRun."""
    given = {os.path.realpath(request.paths[0]): request.stdin} if request.stdin is not None else {}
    files = request.files or Workspace()
    if request.use_cache:
        files.memory = Memory(request.config.root)
    workspace = files.apart(given)
    found, empty = discover(request.paths, request.config, request.exclude, request.force_exclude, workspace)
    outcome = _look(request, found, workspace)
    if not fix:
        return outcome._replace(empty=empty)
    before: dict[str, bytes] = {}
    after: dict[str, bytes] = {}
    count = 0
    for _ in range(_ROUNDS_MAX):
        changed = _mended(outcome, workspace, unsafe)
        if not changed:
            break
        for path, (old, new, number) in changed.items():
            before.setdefault(path, old)
            after[path] = new
            count += number
        workspace = workspace.apart({os.path.realpath(path): new for path, (_, new, _) in changed.items()})
        outcome = _look(request, found, workspace)
    return outcome._replace(empty=empty, fixed=count, before=before, after=after)


def add_ignores(outcome: Outcome) -> Outcome:
    """The outcome with a comment in the source for each finding that a comment can silence."""
    from clickgen.problems.silence import silenceable

    before: dict[str, bytes] = {}
    after: dict[str, bytes] = {}
    count = 0
    for path in outcome.checked:
        data = outcome.workspace.read(path)
        source = _decoded(path, data)
        fix = dialect_of(path, data).ignoring(source, outcome.findings) if source else None
        if source is not None and fix is not None:
            before[path], after[path] = data, _fixed(data, [fix])[0]
            count += len(silenceable(source, outcome.findings))
    return outcome._replace(fixed=count, before=before, after=after)


# -- checking ---------------------------------------------------------------------------------------------------------


def _look(request: Request, found: Sequence[Target], workspace: Workspace) -> Outcome:
    judge = Judge(
        Cache(workspace),
        request.selection,
        request.config.reserved,
        workspace,
        lambda done: request.progress(done, len(found)),
    )
    judged = judge(found)
    if request.elsewhere is not None:
        for target, cached in judged.items():
            if any(finding.code == LEFT for finding in cached.findings):
                judged[target] = judge.again(target, request.elsewhere(target))
    checked = tuple(sorted({path for cached in judged.values() for path in cached.sources}))

    def partly(paths: Iterable[str]) -> set[str]:
        return partly_judged(paths, judged, request.config, workspace)

    findings = agreed(judged, partly, workspace.real)
    left, about = _heard(request, findings, checked, judged, workspace)
    ignored = _Ignored(request.config)
    shown = [finding for finding in (*left, *about) if not ignored(finding)]
    outcome = Outcome(tuple(sorted(shown, key=lambda finding: finding.sort_key)), checked, workspace)
    if request.baseline is None:
        return outcome
    news = request.baseline.news(list(outcome.findings), outcome.line_of)
    return outcome._replace(findings=tuple(news), known=len(outcome.findings) - len(news))


def _heard(
    request: Request,
    findings: list[Diagnostic],
    checked: Sequence[str],
    judged: Mapping[Target, Cached],
    workspace: Workspace,
) -> tuple[list[Diagnostic], list[Diagnostic]]:
    """The findings that no comment silences, and the problems of such comments."""
    speaking = {path: data for path in checked if b"clickgen" in (data := workspace.read(path)).lower()}
    if not speaking:
        return findings, []
    from clickgen.problems.silence import Directive, report_unused, silenced

    problems = Diagnostics()
    directives: list[Directive] = []
    sources: list[SourceFile] = []
    for path, data in speaking.items():
        source = _decoded(path, data)
        if source is not None:
            sources.append(source)
            directives += dialect_of(path, data).directives(source, problems)
    # A finding that the settings silence needs no comment either.
    ignored = _Ignored(request.config)
    waiting = [finding for finding in findings if not ignored(finding)]
    left, _ = silenced(waiting, directives)
    whole = wholly_judged([source.path for source in sources], judged, request.config, workspace)
    for source in sources:
        if source.path in whole:
            without = dialect_of(source.path, source.text).without
            report_unused(source, directives, _judged_codes(request, source.path, judged), without, problems)
    return left, [finding for finding in problems.found if request.selection.wants(finding.code)]


def _decoded(path: str, data: bytes) -> SourceFile | None:
    return dialect_of(path, data).decode(path, data, Diagnostics())


class _Ignored:
    """The warnings that the settings silence in their files; each file meets each pattern once."""

    def __init__(self, config: Config) -> None:
        self._root = config.root
        self._patterns = config.check.per_file_ignores
        self._codes: dict[str, tuple[str, ...]] = {}

    def __call__(self, finding: Diagnostic) -> bool:
        if finding.span is None or finding.is_error or not self._patterns:
            return False
        path = finding.span.path
        if path not in self._codes:
            met = (codes for pattern, codes in self._patterns if matches(pattern, path, self._root))
            self._codes[path] = tuple({code: None for codes in met for code in codes})
        return finding.code.startswith(self._codes[path])


def _judged_codes(request: Request, path: str, judged: Mapping[Target, Cached]) -> list[str]:
    """The codes for which a file was really judged: the rules about logic wait until there are no errors."""
    whole = not any(
        finding.is_error for cached in judged.values() if path in cached.sources for finding in cached.findings
    )
    return [code for code in CODES if request.selection.wants(code) and (whole or not waits_for_errors(code))]


# -- fixing -----------------------------------------------------------------------------------------------------------


def _mended(outcome: Outcome, workspace: Workspace, unsafe: bool) -> dict[str, tuple[bytes, bytes, int]]:
    """The source files that the fixes change: each before and after, and how many fixes were applied.

    A fix changes one file, which is one of those that were checked.
    """
    programs = {*outcome.checked}
    fixes: dict[str, list[Fix]] = {}
    for finding in outcome.findings:
        if finding.fix and (finding.fix.is_safe or unsafe):
            paths = {edit.span.path for edit in finding.fix.edits}
            if len(paths) == 1 and paths <= programs:
                fixes.setdefault(paths.pop(), []).append(finding.fix)
    changed: dict[str, tuple[bytes, bytes, int]] = {}
    for path, wanted in fixes.items():
        old = workspace.read(path)
        new, count = _fixed(old, wanted)
        if new != old:
            changed[path] = (old, new, count)
    return changed


def _fixed(data: bytes, fixes: Sequence[Fix]) -> tuple[bytes, int]:
    from clickgen.text.edits import apply_fixes

    text, count = apply_fixes(data.decode("utf-8"), fixes)
    return text.encode("utf-8"), count
