"""Build a program, check it, list its names: the calls of commands and Python programs. Nothing here writes a file."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress

from clickgen.config import Settings
from clickgen.emit.built import BuiltProgram
from clickgen.emit.registry import Outputs
from clickgen.pipeline import CHECKS, NAMES, STAGES, run
from clickgen.results import BuildResult, CheckResult, KnownNames
from clickgen.table.blocks import marked_blocks
from clickgen.workspace import CouldNotRun, Workspace

__all__ = ["BuildResult", "CheckResult", "CouldNotRun", "Settings", "build", "build_all", "check", "known_names"]


def build(
    path: str | os.PathLike[str],
    *,
    nicknames: str | os.PathLike[str] | None = None,
    frozen: bool = False,
    settings: Settings | None = None,
    workspace: Workspace | None = None,
) -> BuildResult:
    """Build the program at ``path``: everything in memory, nothing written (see ``BuildResult.write``).

    ``nicknames`` names the address table, which must exist; without it, it is ``nicknames.csv`` beside the program,
    which need not. ``frozen`` forbids choosing addresses. ``settings`` say both and more. ``workspace`` has what counts
    instead of files on disk. Problems of the program are in the result's ``diagnostics``. Raises CouldNotRun when the
    program or the table cannot be read.
    """
    state = run(path, settings or Settings(nicknames, nicknames is not None, frozen), workspace, STAGES)
    problems, table = state.problems.in_order(), (state.table_path, state.table, state.table_before, state.dialect)
    if state.problems.has_errors or state.resolved is None:
        nothing = BuiltProgram(state.shown, (), ())
        return BuildResult(state.path, state.sources, problems, {}, nothing, (), state.facts, *table, state.left)
    blocks, reserved = tuple(state.resolved.blocks.values()), frozenset(state.settings.reserved)
    built = BuiltProgram(
        state.shown,
        state.routines,
        tuple(state.rows.values()),
        state.scratch_rows,
        state.ladders,
        blocks,
        reserved,
        len(state.new_rows),
    )
    files = Outputs(built)
    return BuildResult(
        state.path, state.sources, problems, files, built, state.new_rows, state.facts, *table, state.left
    )


def build_all(programs: Iterable[tuple[str, Settings]], workspace: Workspace | None = None) -> list[BuildResult]:
    """Build programs one after the other, each with the address table that those before it made of theirs."""
    results: list[BuildResult] = []
    files = workspace or Workspace()
    for path, settings in programs:
        result = build(path, settings=settings, workspace=files)
        if result.ok:
            files = files.apart({os.path.realpath(result.table_path): result.table})
        results.append(result)
    return results


def check(
    path: str | os.PathLike[str], settings: Settings | None = None, workspace: Workspace | None = None
) -> CheckResult:
    """Judge the program at ``path`` as ``build`` would, and by the rules about logic; nothing is written.

    Raises CouldNotRun if the program or the table cannot be read.
    """
    state = run(path, settings or Settings(), workspace, CHECKS)
    return CheckResult(state.path, state.sources, state.problems.in_order(), state.files.reads)


def known_names(
    path: str | os.PathLike[str], settings: Settings | None = None, workspace: Workspace | None = None
) -> KnownNames:
    """Return the names of the program at ``path``; if it has errors, those that are known. Nothing is written.

    Raises CouldNotRun if the program or the table cannot be read.
    """
    state = run(path, settings or Settings(), workspace, NAMES)
    rows, table = tuple(state.rows.values()), state.table
    # Rows that contradict the table have their problem.
    with suppress(ValueError):
        table = table.extended(state.resolved.rows if state.resolved is not None else ())
    blocks = tuple(marked_blocks(table).values())
    return KnownNames(rows, blocks, state.problems.in_order(), state.table_path, table.to_bytes())
