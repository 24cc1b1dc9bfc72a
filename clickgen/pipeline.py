"""The one road from a source file to everything that a build leaves behind. Only this file knows every stage."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from clickgen.click.ladder_files import ladder_files
from clickgen.config import Settings
from clickgen.device.banks import Address
from clickgen.dialects.base import Dialect
from clickgen.dialects.discover import importers
from clickgen.dialects.registry import default, dialect_of
from clickgen.facts.facts import Facts
from clickgen.facts.left_names import Asked, Left, find_left
from clickgen.fixes.verdict import judge_proposals
from clickgen.ir.program import Program
from clickgen.lower.place import placed_routines
from clickgen.lower.scratch import Scratch
from clickgen.lower.serves import served
from clickgen.lower.split import ClickRoutine, ClickRung, lower
from clickgen.problems.diagnostics import Diagnostics
from clickgen.resolve.declare import name_program
from clickgen.resolve.resolve import Resolved, resolve
from clickgen.rules.judge import judge
from clickgen.rules.registry import Folder, rules
from clickgen.table.address_table import AddressTable
from clickgen.table.layers import read_layers
from clickgen.table.names import record_beside
from clickgen.table.own_table import tell_of_own_table
from clickgen.table.read import TableUnreadable
from clickgen.table.record import placed_still, read_record
from clickgen.table.rows import Row
from clickgen.text.source import SourceFile
from clickgen.workspace import CouldNotRun, Workspace


@dataclass
class Build:
    """A build under way; each stage fills in what the next one needs."""

    path: Path
    shown: str
    settings: Settings
    files: Workspace
    problems: Diagnostics = field(default_factory=Diagnostics)
    dialect: Dialect = field(default_factory=default)
    sources: tuple[SourceFile, ...] = ()
    program: Program | None = None
    table: AddressTable = field(default_factory=lambda: AddressTable.empty(""))
    table_before: bytes | None = None
    resolved: Resolved | None = None
    facts: Facts | None = None
    scratch: Scratch = field(default_factory=Scratch)
    scratch_rows: tuple[Row, ...] = ()
    routines: tuple[ClickRoutine, ...] = ()
    ladders: dict[str, tuple[ClickRung, ...]] = field(default_factory=dict)
    new_rows: tuple[Row, ...] = ()
    left: tuple[Left, ...] = ()

    @property
    def table_path(self) -> Path:
        return self.settings.table_of(self.path)

    @property
    def record(self) -> bytes | None:
        """The record of what clickgen placed in the table."""
        return read_record(record_beside(self.table_path), self.files)

    @property
    def rows(self) -> dict[Address, Row]:
        """The rows of the table with those that the program adds."""
        rows = {row.address: row for row in self.table.rows}
        added = self.resolved.rows if self.resolved is not None else ()
        rows.update((row.address, row) for row in (*added, *self.scratch_rows))
        return rows


def run(path: str | os.PathLike[str], settings: Settings, workspace: Workspace | None, stages: Stages) -> Build:
    """Send a program through stages: all of them, or as far as they can go. Raises CouldNotRun."""
    state = Build(Path(path), str(path), settings, (workspace or Workspace()).apart())
    for stage, needs_no_errors in stages:
        if needs_no_errors and state.problems.has_errors:
            break
        stage(state)
    return state


# -- the stages -------------------------------------------------------------------------------------------------------


def _read_source(state: Build) -> None:
    try:
        data = state.files.read(state.shown)
    except FileNotFoundError:
        raise CouldNotRun(f"there is no file {state.shown}") from None
    except OSError as error:
        reason = "it is a folder" if state.path.is_dir() else error.strerror or str(error)
        raise CouldNotRun(f"{state.shown} cannot be read: {reason}") from None
    state.dialect = dialect_of(state.shown, data)
    source = state.dialect.decode(state.shown, data, state.problems)
    if source is not None:
        state.program, state.sources = state.dialect.read(source, state.files, state.problems)


def _read_table(state: Build) -> None:
    settings = state.settings
    try:
        state.table, state.table_before = read_layers(
            state.table_path, settings.workbook, settings.table_must_exist, state.files, state.problems
        )
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None


def _resolve(state: Build) -> None:
    if state.program is not None:
        settings = state.settings
        state.resolved = resolve(
            state.program, state.table, settings.frozen, state.problems, state.dialect, settings.reserved
        )
        name_program(Asked.of(state.shown, settings.nicknames).words, state.problems)
        if settings.nicknames is None:
            tell_of_own_table(state.path, state.table_path, state.problems)


def _judge_fixes(state: Build) -> None:
    if state.program is not None and state.resolved is not None:
        is_part = state.settings.is_part
        judge_proposals(state.program.proposals, state.resolved, state.sources, state.dialect, state.problems, is_part)


def _lay_out(state: Build) -> None:
    """The facts, for rules."""
    if state.resolved is None:
        return
    placed = placed_still(state.record, state.table) | {row.address for row in state.resolved.allocated}
    sources = {source.path: source for source in state.sources}
    blocks = tuple(state.resolved.blocks.values())
    state.facts = Facts(
        state.resolved.program,
        state.dialect,
        sources,
        state.rows,
        placed,
        blocks,
        scratch_rows=lambda: state.scratch_rows,
        importers=lambda: importers(state.shown, state.files.read),
    )


def _judge_by(folder: Folder) -> Callable[[Build], None]:
    """The stage of a folder of rules."""

    def stage(state: Build) -> None:
        settings = state.settings
        if state.facts is not None:
            state.problems.found += judge(state.facts, rules(folder), settings.wants, settings.is_part)

    return stage


def _try_fixes(state: Build) -> None:
    """Keep those fixes of errors that mend their statement: the program is read again with them in it."""
    if any(problem.is_error and problem.fix for problem in state.problems.found):
        from clickgen.fixes.trial import Seen, tried

        def look(texts: Mapping[str, bytes]) -> Seen:
            files = state.files.apart({state.files.real(path): data for path, data in texts.items()})
            trial = run(state.path, state.settings, files, _TRIAL)
            is_declared = trial.resolved is not None and trial.resolved.is_declared
            return Seen(trial.problems.found, is_declared, trial.program)

        texts = {source.path: state.files.reads[source.path] or b"" for source in state.sources}
        state.problems.found = tried(state.problems.found, texts, look, state.dialect.idle)


def _lower(state: Build) -> None:
    assert state.resolved is not None
    state.routines = lower(state.resolved.program, state.scratch)


def _place_scratch(state: Build) -> None:
    """Every address is known now: the scratch cells get theirs, and the table its new rows."""
    assert state.resolved is not None
    resolved, table, frozen = state.resolved, state.table, state.settings.frozen
    names = {row.address: row.nickname for row in state.rows.values()}
    serves = served(state.routines, state.scratch.ends, lambda address: names.get(address, ""))
    placed = state.scratch.assign(serves, table, resolved.allocator, frozen, state.problems)
    if len(placed) < len(state.scratch.uses):
        return
    state.routines = placed_routines(state.routines, placed)
    state.scratch_rows = tuple(placed.values())
    state.new_rows = (*resolved.allocated, *(row for row in state.scratch_rows if not table.has_name(row.address)))
    if not frozen:
        state.table = table.extended((*resolved.rows, *state.scratch_rows))


def _find_left(state: Build) -> None:
    assert state.resolved is not None
    if state.settings.is_part or state.facts is None:
        return
    asked = Asked.of(state.shown, state.settings.nicknames)
    elsewhere = state.settings.named_elsewhere
    new = state.resolved.allocated
    state.left = find_left(state.facts, state.table, state.record, new, elsewhere, asked, state.problems)


def _divide(state: Build) -> None:
    state.ladders = ladder_files(state.routines, state.problems)


Stages = tuple[tuple[Callable[[Build], None], bool], ...]

STAGES: Stages = (
    (_read_source, False),
    (_read_table, False),
    (_resolve, False),
    (_judge_fixes, False),
    (_lay_out, False),
    (_judge_by(Folder.ERRORS), False),
    (_try_fixes, False),
    (_lower, True),
    (_place_scratch, True),
    (_judge_by(Folder.LOWERED), True),
    (_find_left, True),
    (_divide, True),
)
"""The stages of a build in their order, each with whether it needs a program without errors."""

CHECKS: Stages = (*STAGES, (_judge_by(Folder.ADVICE), True))
"""The stages of a check."""

_TRIAL: Stages = tuple(stage for stage in STAGES if stage[0] not in (_try_fixes, _find_left))
"""The stages that tell whether a fix leaves an error in its statement."""

NAMES: Stages = tuple(stage for stage in STAGES if stage[0] in (_read_source, _read_table, _resolve, _judge_fixes))
"""The stages that find out the names of a program."""
