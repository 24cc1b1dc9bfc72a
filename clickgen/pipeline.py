"""The one road from a source file to everything that a build leaves behind. Only this file knows every stage."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path

from clickgen.device.banks import Address
from clickgen.device.limits import ROWS_AND_RUNGS_MAX, RUNGS_MAX
from clickgen.dialects.if_rungs.read.imports import importers, read_program
from clickgen.dialects.if_rungs.read.parse import decode
from clickgen.emit.built import BuiltProgram
from clickgen.emit.folder import ForeignFiles, stale_files
from clickgen.emit.registry import Outputs
from clickgen.facts.facts import Facts
from clickgen.fixes.verdict import judge_proposals
from clickgen.instructions.raw import RAW
from clickgen.ir.program import Program
from clickgen.lower.place import PlaceScratch
from clickgen.lower.scratch import Scratch
from clickgen.lower.serves import served
from clickgen.lower.split import ClickRoutine, ClickRung, lower
from clickgen.problems.diagnostics import CouldNotRun, Diagnostic, Diagnostics
from clickgen.resolve.left_names import Left, left_names, report_left
from clickgen.resolve.resolve import Resolved, resolve
from clickgen.rules.errors import RULES, scratch_bits
from clickgen.settings import Settings
from clickgen.table.address_table import AddressTable
from clickgen.table.blocks import Block, marked_blocks
from clickgen.table.layers import beside_workbook
from clickgen.table.read import TableUnreadable, read_table
from clickgen.table.record import left_in, placed_in, read_record, record_beside, with_placed
from clickgen.table.rows import Row
from clickgen.text.source import SourceFile
from clickgen.text.write import put_in_place
from clickgen.workspace import read_file, read_if_there

__all__ = ["BuildResult", "CheckResult", "CouldNotRun", "KnownNames", "Settings", "build", "check", "known_names"]


@dataclass(frozen=True)
class BuildResult:
    """What a build made, in memory.

    ``files`` maps each output's path inside the output folder (``main.csv``, ``subroutines/auto.csv``) to its text; a
    text is made when it is asked for. It is empty when there are errors.
    """

    program: Path
    sources: tuple[SourceFile, ...]
    """The program files as they were read."""
    diagnostics: tuple[Diagnostic, ...]
    files: Mapping[str, str]
    built: BuiltProgram
    """What the outputs are made from; without routines and rows when there are errors."""
    new_rows: tuple[Row, ...]
    """The addresses that clickgen chose in this build, scratch included."""
    facts: Facts | None
    """The program without names, as far as it could be read."""
    table_path: Path
    address_table: AddressTable
    """As it should be after the build."""
    table_before: bytes | None
    """The file as it was read; None where there was none."""
    left: tuple[Left, ...] = ()
    """The names that left the program while others came."""

    @property
    def routines(self) -> tuple[ClickRoutine, ...]:
        """The program in CLICK rungs; empty when there are errors."""
        return self.built.routines

    @property
    def rows(self) -> tuple[Row, ...]:
        """Every row of the address table as it should be after the build; empty when there are errors."""
        return self.built.rows

    @property
    def scratch_rows(self) -> tuple[Row, ...]:
        """Those of ``rows`` that clickgen needs for itself in this program."""
        return self.built.scratch

    @property
    def table(self) -> bytes:
        """The file of the address table as it should be after the build."""
        return self.address_table.to_bytes()

    @property
    def ok(self) -> bool:
        """True when nothing is an error."""
        return not any(problem.is_error for problem in self.diagnostics)

    @cached_property
    def needed(self) -> frozenset[Address]:
        """The addresses that the program declares, marks as blocks, or that clickgen needs for itself in it."""
        declared = self.facts.program if self.facts else None
        addresses = [row.address for row in self.scratch_rows]
        addresses += [each.cell.address for each in declared.declarations] if declared else []
        addresses += [address for block in declared.blocks for address in block.range.addresses()] if declared else []
        return frozenset(addresses)

    @property
    def placed_rows(self) -> tuple[Row, ...]:
        """The names that clickgen placed in this build."""
        return tuple(row for row in self.new_rows if row not in self.scratch_rows)

    @property
    def main(self) -> ClickRoutine:
        """The main program in CLICK rungs; only when ``ok``."""
        return next(routine for routine in self.routines if routine.is_main)

    @property
    def subroutines(self) -> tuple[ClickRoutine, ...]:
        return tuple(routine for routine in self.routines if not routine.is_main)

    def write(self, folder: Path) -> list[Path]:
        """Put the outputs into ``folder`` and the extended address table in its place: all of it or none.

        Files that an earlier build left there and this one does not make are removed. Returns what really changed.
        Raises CouldNotRun when the folder holds files that are not clickgen's and in the way; OSError when something
        cannot be written; ChangedMeanwhile when the table changed since it was read.
        """
        return write_all([(self, folder)])


def build_all(programs: Iterable[tuple[str, Settings]]) -> list[BuildResult]:
    """Build programs one after the other, each with the address table that those before it made of theirs."""
    results: list[BuildResult] = []
    tables: dict[str, bytes] = {}
    for path, settings in programs:
        result = build(path, settings=replace(settings, overlay={**settings.overlay, **tables}))
        if result.ok:
            tables[os.path.realpath(result.table_path)] = result.table
        results.append(result)
    return results


def write_all(results: Sequence[tuple[BuildResult, Path]]) -> list[Path]:
    """Write several results, each into its folder, as ``BuildResult.write`` does: all of them or none.

    Of programs that share an address table each must have been built with the table that the one before it made.
    """
    writes: dict[Path, bytes] = {}
    removals: list[Path] = []
    tables: dict[str, tuple[Path, bytes | None, bytes]] = {}
    placed: dict[Path, list[Row]] = {}
    left: dict[Path, dict[Address, Address]] = {}
    no_links: list[Path] = []
    for result, folder in results:
        if not result.ok:
            raise CouldNotRun("a program with errors is not written")
        outputs = {name: text.encode() for name, text in result.files.items()}
        writes.update((folder / name, data) for name, data in outputs.items())
        no_links += (folder / name for name in outputs)
        try:
            removals += stale_files(folder, outputs)
        except ForeignFiles as error:
            raise CouldNotRun(str(error)) from None
        own = result.address_table
        if own.base and result.table_before is None and not own.own_rows:
            continue  # The workbook lacks nothing.
        place = os.path.realpath(result.table_path)
        first = tables.get(place, (result.table_path, result.table_before, b""))
        tables[place] = (*first[:2], result.table)
        beside = record_beside(first[0])
        placed.setdefault(beside, []).extend(result.placed_rows)
        left.setdefault(beside, {}).update((each.new.address, each.old.address) for each in result.left)
    for path in writes:
        if os.path.realpath(path) in tables:
            raise CouldNotRun(f"{path.parent} holds the address table {path.name}; choose another folder with -o")
    unchanged: dict[Path, bytes | None] = {}
    for path, before, after in tables.values():
        # A result that is written a second time finds the table as it wants it.
        written = read_if_there(path) == after
        unchanged[path] = after if written else before
        if after != before:
            writes[path] = after
    for path, rows in placed.items():
        data = read_record(path)
        record = with_placed(data, rows, left[path])
        if record is not None and record != data:
            writes[path], unchanged[path] = record, data
    return put_in_place(writes, removals, unchanged, [*no_links, *placed])


@dataclass(frozen=True)
class CheckResult:
    """What is to be said about a program: what a build would say, and what the rules about logic find."""

    program: Path
    sources: tuple[SourceFile, ...]
    diagnostics: tuple[Diagnostic, ...]
    reads: Mapping[str, bytes | None]
    """What was read, by path; None for a file that is not there. The same bytes give the same result."""


@dataclass(frozen=True)
class KnownNames:
    """Every name that a program can use: those of the address table, and those that it declares or would give."""

    rows: tuple[Row, ...]
    blocks: tuple[Block, ...]
    diagnostics: tuple[Diagnostic, ...]
    table_path: Path
    table: bytes
    """The address table with the names of the program, where these agree with it."""


@dataclass
class _Build:
    """A build under way; each stage fills in what the next one needs."""

    path: Path
    shown: str
    table_path: Path
    workbook: Path | None
    """A list of addresses that the table adds to."""
    settings: Settings
    reads: dict[str, bytes | None] = field(default_factory=dict)
    problems: Diagnostics = field(default_factory=Diagnostics)
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


def build(
    path: str | os.PathLike[str],
    *,
    nicknames: str | os.PathLike[str] | None = None,
    frozen: bool = False,
    settings: Settings | None = None,
) -> BuildResult:
    """Build the program at ``path``: everything in memory, nothing written (see ``BuildResult.write``).

    ``nicknames`` names the address table, which must exist; without it, it is ``nicknames.csv`` beside the program,
    which need not. ``frozen`` forbids choosing addresses. ``settings`` say both and more. Problems of the program are
    in the result's ``diagnostics``. Raises CouldNotRun when the program or the table cannot be read.
    """
    state = _run(path, settings or Settings(nicknames, nicknames is not None, frozen), STAGES)
    built = _built(state)
    return BuildResult(
        state.path,
        state.sources,
        state.problems.in_order(),
        Outputs(built) if built.routines else {},
        built,
        state.new_rows if built.routines else (),
        state.facts,
        state.table_path,
        state.table,
        state.table_before,
        state.left,
    )


def check(path: str | os.PathLike[str], settings: Settings | None = None) -> CheckResult:
    """Judge the program at ``path`` as ``build`` would, and by the rules about logic; nothing is written.

    Raises CouldNotRun when the program or the table cannot be read.
    """
    state = _run(path, settings or Settings(), CHECKS)
    return CheckResult(state.path, state.sources, state.problems.in_order(), state.reads)


def known_names(path: str | os.PathLike[str], settings: Settings | None = None) -> KnownNames:
    """The names of the program at ``path``; of one with errors those that are known. Nothing is written.

    Raises CouldNotRun when the program or the table cannot be read.
    """
    state = _run(path, settings or Settings(), NAMES)
    rows, table = tuple(_rows(state).values()), state.table
    # Rows that contradict the table have their problem.
    with suppress(ValueError):
        table = table.extended(state.resolved.rows if state.resolved is not None else ())
    blocks = tuple(marked_blocks(table).values())
    return KnownNames(rows, blocks, state.problems.in_order(), state.table_path, table.to_bytes())


def _run(path: str | os.PathLike[str], settings: Settings, stages: _Stages) -> _Build:
    program = Path(path)
    state = _Build(program, str(path), settings.table_of(program), settings.workbook, settings)
    for stage, needs_no_errors in stages:
        if needs_no_errors and state.problems.has_errors:
            break
        stage(state)
    return state


# -- the stages -------------------------------------------------------------------------------------------------------


def _read_table(state: _Build) -> None:
    path, shown = state.table_path, str(state.table_path)
    data = state.settings.overlay.get(os.path.realpath(path))
    must_exist = state.settings.table_must_exist and state.workbook is None
    try:
        if data is None and not path.exists() and not path.is_symlink() and not must_exist:
            state.table = AddressTable.empty(shown)
            state.reads[shown] = None
        else:
            state.table = read_table(path, shown, state.problems, data)
            state.table_before = state.reads[shown] = state.table.to_bytes()
        if state.workbook is not None:
            _read_workbook(state, state.workbook)
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None


def _read_workbook(state: _Build, path: Path) -> None:
    from clickgen.table.workbook.archive import bytes_of_workbook
    from clickgen.table.workbook.read import read_workbook

    shown = str(path)
    state.reads[shown] = data = bytes_of_workbook(path, shown)
    rows = read_workbook(path, shown, state.problems, data)
    state.table = beside_workbook(state.table, rows, state.problems)


def _read_source(state: _Build) -> None:
    try:
        data = _bytes_of(state, state.shown)
    except FileNotFoundError:
        raise CouldNotRun(f"there is no file {state.shown}") from None
    except OSError as error:
        reason = "it is a folder" if state.path.is_dir() else error.strerror or str(error)
        raise CouldNotRun(f"{state.shown} cannot be read: {reason}") from None
    source = decode(state.shown, data, state.problems)
    if source is not None:
        state.program, state.sources = read_program(source, partial(_bytes_of, state), state.problems)


def _bytes_of(state: _Build, path: str) -> bytes:
    state.reads[path] = None
    data = state.settings.overlay.get(os.path.realpath(path))
    state.reads[path] = data = read_file(path) if data is None else data
    return data


def _resolve(state: _Build) -> None:
    if state.program is not None:
        settings = state.settings
        state.resolved = resolve(state.program, state.table, settings.frozen, state.problems, settings.reserved)
        if settings.nicknames is None:
            _name_own_table(state)


def _name_own_table(state: _Build) -> None:
    """The table beside the program may be that of another PLC: where both disagree, say once how to have an own one."""
    for index, problem in enumerate(state.problems.found):
        in_table = any(label.span.path == str(state.table_path) for label in problem.labels)
        if problem.code in ("CG204", "CG205") and in_table:
            own = f"give it a table of its own in clickgen.toml: {own_table_setting(state.path)}"
            help = f"{problem.help}; if this program is for another PLC, {own}"
            state.problems.found[index] = problem._replace(help=help)
            return


def own_table_setting(program: Path) -> str:
    """How the settings of the working folder give a program an address table of its own."""
    path = Path(program.name) if program.is_absolute() else program
    return f'programs = [{{ path = "{path.as_posix()}", nicknames = "{path.with_suffix(".csv").as_posix()}" }}]'


def _judge_fixes(state: _Build) -> None:
    if state.program is not None and state.resolved is not None:
        is_part = state.settings.is_part
        judge_proposals(state.program.proposals, state.resolved, state.sources, state.problems, is_part)


def _check(state: _Build) -> None:
    if state.resolved is not None:
        sources = {source.path: source for source in state.sources}
        blocks = tuple(state.resolved.blocks.values())
        placed = _placed(state, state.resolved)
        state.facts = Facts(state.resolved.program, sources, _rows(state), placed, blocks)
        for rule in RULES:
            rule(state.facts, state.problems)
        _check_kept(state.facts, state.problems)
        if state.settings.is_part:
            # A part has no main of its own.
            state.problems.drop("CG401")
        elif state.program is not None and state.program.main is None:
            _name_programs(state)


def _name_programs(state: _Build) -> None:
    """Tell of a file without a main which programs it is a part of."""
    programs = importers(state.shown, partial(_bytes_of, state))
    if programs:
        help = f"this file is a part of {' and of '.join(programs[:3])}: build {programs[0]}"
        found = state.problems.found
        state.problems.found = [one._replace(help=help) if one.code == "CG401" else one for one in found]


def _placed(state: _Build, resolved: Resolved) -> frozenset[Address]:
    """The addresses that clickgen chose: those of this build, and those of its record that still have their names."""
    rows = state.table.by_address
    kept = (at for at, name in placed_in(_record(state)).items() if at in rows and rows[at].nickname == name)
    return frozenset((*kept, *(row.address for row in resolved.allocated)))


def _record(state: _Build) -> bytes | None:
    """The record of what clickgen placed in the table, read once."""
    path = record_beside(state.table_path)
    if str(path) not in state.reads:
        state.reads[str(path)] = read_record(path)
    return state.reads[str(path)]


def _check_kept(facts: Facts, problems: Diagnostics) -> None:
    """The tokens that a program keeps, which few do; the readers of ladder files know them."""
    if any(placed.spec is RAW for placed in facts.actions):
        from clickgen.click.read.kept import check

        check(facts, problems)


def _lint(state: _Build) -> None:
    from clickgen.rules.advice import RULES as LINT_RULES

    assert state.facts is not None
    for rule in LINT_RULES:
        if state.settings.wants(rule.code) and (rule.holds_in_parts or not state.settings.is_part):
            rule.check(state.facts, state.problems)


def _lower(state: _Build) -> None:
    assert state.resolved is not None
    state.routines = lower(state.resolved.program, state.scratch)


def _place_scratch(state: _Build) -> None:
    """Every address is known now: the scratch cells get theirs, and the table its new rows."""
    assert state.resolved is not None
    resolved = state.resolved
    nicknames = _nicknames(state)
    serves = served(state.routines, state.scratch.ends, lambda address: nicknames.get(address, ""))
    placed = state.scratch.assign(serves, state.table, resolved.allocator, state.settings.frozen, state.problems)
    if len(placed) < len(state.scratch.uses):
        return
    if placed:
        rewriter = PlaceScratch({placeholder: row.address for placeholder, row in placed.items()})
        state.routines = tuple(rewriter.routine(routine) for routine in state.routines)
    state.scratch_rows = tuple(placed.values())
    state.new_rows = (
        *resolved.allocated,
        *(row for row in state.scratch_rows if _is_new(row, state.table)),
    )
    if not state.settings.frozen:
        state.table = state.table.extended((*resolved.rows, *state.scratch_rows))
    if state.facts is not None:
        scratch_bits.check(state.facts, state.scratch_rows, state.problems)


def _find_left(state: _Build) -> None:
    """Names that left the program, which the record of what clickgen placed and the table still know."""
    assert state.resolved is not None
    if state.settings.is_part or state.facts is None:
        return
    record = _record(state)
    if record is None:
        return
    rows = [row for row in state.table.own_rows if row.line]
    found = left_names(
        state.facts, rows, placed_in(record), left_in(record), state.resolved.allocated, state.settings.named_elsewhere
    )
    state.left = tuple(found)
    spans = {left.old.address: span for left in found if (span := state.table.span(left.old))}
    named = os.fspath(state.settings.nicknames or "")
    here = os.getcwd() + os.sep
    named = named.removeprefix(here)
    report_left(state.facts, state.problems, found, state.shown, named, spans)


def _is_new(row: Row, table: AddressTable) -> bool:
    """True for a name that the table lacks; the table may list its address without a name."""
    stands = table.by_address.get(row.address)
    return stands is None or not stands.nickname


def _divide(state: _Build) -> None:
    """Divide the routines into files within CLICK's limits."""
    for routine in state.routines:
        parts = list(_within_limits(routine.rungs))
        if len(parts) > 1 and not routine.is_main:
            state.problems.add(
                "CG415",
                routine.span,
                f"{routine.name} has {len(routine.rungs)} CLICK rungs; one file holds {RUNGS_MAX} rungs and "
                f"{ROWS_AND_RUNGS_MAX} rows with rungs counted in",
                "divide it into two subroutines and call both",
            )
        elif len(parts) > 1:
            state.problems.add(
                "CG424",
                routine.span,
                f"main has {len(routine.rungs)} CLICK rungs and goes into {len(parts)} ladder files",
                "paste them one behind the other, in the order of their names",
            )
        # ClickNick pastes main's parts sorted by name (click-facts, section 7): all numbers have as many digits.
        digits = len(str(len(parts)))
        for number, part in enumerate(parts, 1):
            stem = "main" if routine.is_main else f"subroutines/{routine.name}"
            state.ladders[f"{stem}_{number:0{digits}}.csv" if number > 1 else f"{stem}.csv"] = part


def _within_limits(rungs: tuple[ClickRung, ...]) -> Iterator[tuple[ClickRung, ...]]:
    """Stretches of rungs that one clipboard buffer takes (click-facts, trap 1)."""
    start = size = 0
    for index, rung in enumerate(rungs):
        cost = len(rung.grid) + 1
        if index - start == RUNGS_MAX or size + cost > ROWS_AND_RUNGS_MAX:
            yield rungs[start:index]
            start, size = index, 0
        size += cost
    yield rungs[start:]


def _rows(state: _Build) -> dict[Address, Row]:
    """The rows of the table with those that the program adds."""
    rows = {row.address: row for row in state.table.rows}
    added = state.resolved.rows if state.resolved is not None else ()
    rows.update((row.address, row) for row in (*added, *state.scratch_rows))
    return rows


def _nicknames(state: _Build) -> dict[Address, str]:
    return {row.address: row.nickname for row in _rows(state).values() if row.nickname}


def _built(state: _Build) -> BuiltProgram:
    """What writers make outputs from; of a program with errors there is nothing."""
    if state.problems.has_errors or state.resolved is None:
        return BuiltProgram(state.shown, (), ())
    return BuiltProgram(
        state.shown,
        state.routines,
        tuple(_rows(state).values()),
        state.scratch_rows,
        state.ladders,
        tuple(state.resolved.blocks.values()),
        frozenset(state.settings.reserved),
        len(state.new_rows),
    )


_Stages = tuple[tuple[Callable[[_Build], None], bool], ...]

STAGES: _Stages = (
    (_read_source, False),
    (_read_table, False),
    (_resolve, False),
    (_judge_fixes, False),
    (_check, False),
    (_lower, True),
    (_place_scratch, True),
    (_find_left, True),
    (_divide, True),
)
"""The stages of a build in their order, each with whether it needs a program without errors."""

CHECKS: _Stages = (*STAGES, (_lint, True))
"""The stages of a check."""

NAMES: _Stages = tuple(stage for stage in STAGES if stage[0] in (_read_source, _read_table, _resolve, _judge_fixes))
"""The stages that find out the names of a program."""
