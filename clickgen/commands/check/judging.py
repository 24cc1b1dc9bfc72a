"""Judges programs: each by the pipeline, several on all cores, an unchanged one from the cache."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from clickgen.commands.check.cache import Cache, Cached, key_of
from clickgen.dialects.discover import Target
from clickgen.problems.diagnostics import TRACEBACK, Diagnostic
from clickgen.rules.select import Selection
from clickgen.text.source import Span
from clickgen.workspace import CouldNotRun, Workspace

if TYPE_CHECKING:
    from clickgen.device.banks import Address

_MANY = 4
"""Fewer programs than this are judged one after the other: starting processes costs more."""

Judged = tuple[Cached, Mapping[str, bytes | None]]
"""The findings of a program, and the files read for them."""


class Judge(NamedTuple):
    """``workspace`` has the files; if it has contents that replace those on disk, nothing is cached.

    ``progress`` is called after each program with the number of finished ones.
    """

    cache: Cache
    selection: Selection
    reserved: tuple[Address, ...]
    workspace: Workspace
    progress: Callable[[int], None] = lambda _: None

    def __call__(self, targets: Sequence[Target]) -> dict[Target, Cached]:
        """Return the findings of each target. Raises CouldNotRun if one cannot be read."""
        found: dict[Target, Cached] = {}
        keys = {target: self._key(target) for target in targets} if not self.workspace.overlay else {}
        for target, key in keys.items():
            cached = self.cache.get(key)
            if cached is not None:
                found[target] = cached
        waiting = [target for target in targets if target not in found]
        for target, (cached, reads) in self._judged(waiting, is_one_of_many=len(targets) > 1):
            found[target] = cached
            if reads and not self.workspace.overlay:
                self.cache.put(keys[target], cached, reads)
            self.progress(len(found))
        self.workspace.memory.save()
        return found

    def again(self, target: Target, named_elsewhere: frozenset[str]) -> Cached:
        """Return the findings of a target, given the names that other programs use: they are not cached."""
        return judge(target, self.selection, self.reserved, self.workspace, named_elsewhere)[0]

    def _key(self, target: Target) -> str:
        return key_of(target, self.reserved, self.selection)

    def _judged(self, targets: list[Target], is_one_of_many: bool) -> Iterator[tuple[Target, Judged]]:
        judged = judged_at_any_rate if is_one_of_many else judge
        cores = min(len(targets), os.cpu_count() or 1)
        if len(targets) < _MANY or cores < 2:
            yield from ((target, judged(target, self.selection, self.reserved, self.workspace)) for target in targets)
            return
        from clickgen.commands.check.pool import in_processes

        # What this process has read stays here: sending it would cost more than reading it again.
        workspace = Workspace(self.workspace.overlay, self.workspace.memory)
        tasks = [(target, self.selection, self.reserved, workspace) for target in targets]
        yield from zip(targets, in_processes(judged, tasks, cores), strict=True)


def judged_at_any_rate(
    target: Target, selection: Selection, reserved: tuple[Address, ...], workspace: Workspace
) -> Judged:
    """``judge`` for one program of several: if it cannot be judged, that is its problem and does not stop the others.

    Such a problem is not cached: nothing shows what it depends on.
    """
    try:
        return judge(target, selection, reserved, workspace)
    except CouldNotRun as error:
        reason, help = str(error), "mend this, and check again"
    except Exception as error:
        if os.environ.get(TRACEBACK):
            raise
        reason = f"internal error: {type(error).__name__}: {error}"
        help = f"this is a fault of clickgen: please report it with the program; {TRACEBACK}=1 shows where it happened"
    problem = Diagnostic("CG140", reason, Span(target.path, 1, 1, 1, 2), help)
    return Cached((problem,), ()), {}


def judge(
    target: Target,
    selection: Selection,
    reserved: tuple[Address, ...],
    workspace: Workspace,
    named_elsewhere: frozenset[str] = frozenset(),
) -> Judged:
    """Return the wanted findings about one program. Raises CouldNotRun."""
    from clickgen.api import check
    from clickgen.config import Settings

    settings = Settings(
        target.nicknames,
        reserved=reserved,
        wants=selection.wants,
        is_part=target.is_part,
        named_elsewhere=named_elsewhere,
    )
    result = check(target.path, settings, workspace)
    workspace.memory.save()
    findings = tuple(finding for finding in result.diagnostics if selection.wants(finding.code))
    return Cached(findings, tuple(source.path for source in result.sources)), result.reads
