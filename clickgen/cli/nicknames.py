"""``clickgen nicknames``: what concerns the address table: sync, check, merge, rename, why."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from clickgen.api import build
from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Job, jobs, near, settings_of, settle
from clickgen.commands.nicknames.changes import KINDS, RENAMED, SWAPPED
from clickgen.commands.nicknames.merge import Merge
from clickgen.commands.nicknames.programs import Program
from clickgen.commands.nicknames.rename import Rename, rename
from clickgen.commands.nicknames.sync import TableSync
from clickgen.commands.nicknames.uses import FileNames
from clickgen.problems.diagnostics import CouldNotRun, Diagnostic, Diagnostics
from clickgen.problems.report.frames import summary, write_problems
from clickgen.results import BuildResult
from clickgen.table.address_table import AddressTable
from clickgen.table.names import TABLE_NAME, is_workbook
from clickgen.table.rows import Row
from clickgen.text.source import SourceFile
from clickgen.text.wording import counted
from clickgen.text.write import put_in_place
from clickgen.workspace import Workspace

DESCRIPTION = "What concerns the address table that the PLC, the panel and the programs share."
EXAMPLES = """\
examples:
  clickgen nicknames sync prog.py           give every name an address
  clickgen nicknames sync --prune           and remove names that clickgen placed and nothing uses
  clickgen nicknames check                  in CI: table and programs agree
  clickgen nicknames merge export.csv       what CLICK says otherwise; new names are taken in
  clickgen nicknames merge export.csv --accept renamed,changed
  clickgen nicknames rename Pump Pump1      in the table and in every program
  clickgen nicknames why Pump               where its address comes from

exit codes: 0 done; 1 problems, or differences that were not taken in; 2 could not run
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    actions = parser.add_subparsers(title="commands", metavar="COMMAND", dest="action", required=True)

    def action(name: str, help: str, description: str) -> Callable[..., argparse.Action]:
        command = actions.add_parser(
            name, help=help, description=description, formatter_class=parser.formatter_class, allow_abbrev=False
        )
        command.add_argument("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
        command.add_argument("--nicknames", metavar="TABLE", help="the address table")
        return command.add_argument

    programs = {"metavar": "PROG.py", "nargs": "*", "help": "the programs (default: every configured one)"}
    add = action(
        "sync",
        "give every name an address",
        "Give every name of the programs an address, and name what no program uses. Nothing is dropped.",
    )
    add("programs", **programs)
    add("--prune", action="store_true", help="remove names that clickgen placed and nothing uses any more")
    add("--dry-run", action="store_true", help="say what would be done, and write nothing")
    add = action(
        "check",
        "whether table and programs agree",
        "Check the address table and the names of the programs, without writing anything: for CI.",
    )
    add("programs", **programs)
    add = action(
        "merge",
        "take in a fresh export from CLICK",
        "Show what an export from CLICK says otherwise than the address table, and take in what is new. All else is "
        "taken in only when it is asked for.",
    )
    add("export", metavar="EXPORT.csv", help="the nickname CSV that CLICK wrote")
    add(
        "--accept",
        metavar="KINDS",
        action="append",
        default=[],
        help="take these in too: renamed, moved, removed, changed, all; swapped only by its own name",
    )
    add("--dry-run", action="store_true", help="show the differences, and write nothing")
    add = action(
        "rename",
        "rename in the table and in every source file",
        "Rename a nickname or a block in the address table and in every program that uses the table, all or nothing. "
        "The ladder stays the same, which is tried before anything is written, and what changes is said first.",
    )
    add("old", metavar="OLD", help="the nickname or block as it is")
    add("new", metavar="NEW", help="the name as it should be")
    add("programs", **programs)
    add("--dry-run", action="store_true", help="say what would be renamed, and write nothing")
    add = action(
        "why",
        "where the address of a name comes from",
        "Say where the address of a name comes from, why it is that one, and where the name is used.",
    )
    add("name", metavar="NAME", help="a nickname, a block, or an address such as DS5")
    add("programs", **programs)


def run(options: argparse.Namespace) -> int:
    """Run one of the commands; returns the exit code."""
    return _COMMANDS[options.action](options)


def _jobs(options: argparse.Namespace, programs: Iterable[str]) -> list[Job]:
    found = jobs(list(programs), options.nicknames, config=options.config)
    if len(found) > 1 and options.nicknames and not options.programs:
        raise CouldNotRun("several programs are configured: --nicknames goes with those that you name")
    return found


# -- sync -------------------------------------------------------------------------------------------------------------


def _sync(options: argparse.Namespace) -> int:
    from clickgen.commands.nicknames.sync import sync

    found = _jobs(options, options.programs)
    if not options.dry_run:
        settle(found, options.config)
    result = sync(found, settings_of(options.config), options.prune)
    if not result.ok:
        for each in result.results:
            write_problems(each.diagnostics, each.sources, sys.stderr)
        complain(f"{_summary(result.results)}; nothing was written")
        return PROBLEMS
    # What is shown of the table is what was read, so before anything is written.
    for each in result.results:
        write_problems(filter(_is_about_names, each.diagnostics), each.sources, sys.stderr)
    if not options.dry_run:
        put_in_place(result.writes, (), result.unchanged)
    for table in result.tables:
        tell(*_table_lines(table, options.dry_run))
    return OK


def _table_lines(table: TableSync, is_dry: bool) -> list[str]:
    would = "would be " if is_dry else ""
    facts = [f"{counted(len(table.added), 'address', 'addresses')} {would}added"] if table.added else []
    facts += [f"{counted(len(table.changed), 'address', 'addresses')} {would}changed"] if table.changed else []
    facts += [f"{counted(len(table.removed), 'address', 'addresses')} {would}removed"] if table.removed else []
    left = [row for row in table.unused if row not in table.removed]
    facts += [f"{counted(len(left), 'name')} that no program uses"] if left else []
    lines = [f"{table.path}: {', '.join(facts) or 'up to date'}"]
    lines += [f"  + {_shown(row)}" for row in table.added]
    lines += [f"  ~ {_shown(row)}" for row in table.changed]
    lines += [f"  - {_shown(row)}" for row in table.removed]
    lines += [f"  ? {_shown(row)}{_reason(table, row)}" for row in left]
    return lines


def _shown(row: Row) -> str:
    return f"{row.address} {row.nickname or row.comment or 'without a name'}"


def _reason(table: TableSync, row: Row) -> str:
    reason = table.kept.get(row.address)
    return f" ({reason})" if reason else ""


# -- check ------------------------------------------------------------------------------------------------------------


def _check(options: argparse.Namespace) -> int:
    """The problems of names, addresses and the table; others are counted, for ``clickgen check`` tells them."""
    from clickgen.commands.nicknames.sync import sync

    found = _jobs(options, options.programs)
    results = [build(job.program, settings=job.settings._replace(frozen=True)) for job in found]
    told = 0
    for result in results:
        own = [problem for problem in result.diagnostics if _is_about_names(problem)]
        others = [problem for problem in result.diagnostics if problem.is_error and not _is_about_names(problem)]
        write_problems(own, result.sources, sys.stdout)
        told += len([problem for problem in own if problem.is_error]) + len(others)
        if others:
            complain(f"{result.program} has {counted(len(others), 'other error')}: see clickgen check {result.program}")
    if told:
        return PROBLEMS
    lacking = [table for table in sync(found, settings_of(options.config)).tables if table.added or table.changed]
    for table in lacking:
        tell(*_table_lines(replace(table, unused=()), is_dry=True))
    if lacking:
        complain("run clickgen nicknames sync and commit the table")
        return PROBLEMS
    tables = {str(result.table_path): len(result.rows) for result in results}
    for path, count in tables.items():
        tell(f"{path}: {counted(count, 'address', 'addresses')}, in agreement with {_programs(results, path)}")
    return OK


def _is_about_names(problem: Diagnostic) -> bool:
    return problem.code.startswith(("CG2", "CG6"))


def _programs(results: Iterable[BuildResult], path: str) -> str:
    return ", ".join(str(result.program) for result in results if str(result.table_path) == path)


# -- merge ------------------------------------------------------------------------------------------------------------


class _Merging(NamedTuple):
    """What an export is taken into: the table, the workbook that it adds to, and programs that are known to use it."""

    table: Path
    workbook: Path | None
    jobs: list[Job]


def _merge(options: argparse.Namespace) -> int:
    from clickgen.commands.nicknames.changed_rows import conflict_lines, diff_lines, never_lines, summary
    from clickgen.commands.nicknames.merge import merge
    from clickgen.commands.nicknames.programs import programs_around
    from clickgen.commands.nicknames.uses import ProgramsSay, places_in

    kinds = _kinds(options.accept)
    target = _table_to_merge(options)
    path = target.table
    if not options.dry_run:
        settle(target.jobs, options.config)
    table, before = _read(path, bool(options.nicknames) and target.workbook is None, target.workbook)
    export, _ = _read(Path(options.export), must_exist=True)
    around = programs_around(target.jobs, settings_of(options.config), Workspace(), [path])
    own = [program for program in around if program.table_key == os.path.realpath(path)]
    names = [_seen_from_here(file) for program in own for file in program.names]
    result = merge(table, export, places_in(names), ProgramsSay(names))
    conflicts = conflict_lines(result, kinds)
    tell(f"{options.export}: {summary(result)}", *_indented(diff_lines(result)))
    if conflicts:
        tell("cannot be taken so:", *_indented(conflicts), file=sys.stderr)
        return PROBLEMS
    after = result.taken(kinds).to_bytes()
    if not options.dry_run and after != before and (before is not None or result.of(kinds)):
        put_in_place({path: after}, (), {path: before})
    never = never_lines(result, kinds)
    if never:
        tell("cannot be taken at all:", *_indented(never))
    if result.changes:
        tell(_merged(result, kinds, options.dry_run))
    tell(*_after_renames(options, result, kinds, own))
    return OK if all(change.kind in kinds for change in result.changes) else PROBLEMS


def _seen_from_here(file: FileNames) -> FileNames:
    """A file of a program whose messages name it as seen from the working folder."""
    path = str(near(Path(file.source.path)))
    declarations = tuple(replace(each, span=each.span._replace(path=path)) for each in file.declarations)
    return replace(file, source=SourceFile(path, file.source.text), declarations=declarations)


def _merged(merged: Merge, kinds: set[str], is_dry: bool) -> str:
    left = [change for change in merged.changes if change.kind not in kinds]
    said = f"{counted(len(merged.changes) - len(left), 'change')} {'would be ' if is_dry else ''}taken"
    if not left:
        return said
    never = {conflict.change for conflict in merged.never}
    waiting = sorted({change.kind for change in left if change not in never}, key=KINDS.index)
    them = "those that can be" if never & {*left} else "them" if len(left) > 1 else "it"
    return f"{said}, {len(left)} not" + (f": take {them} with --accept {','.join(waiting)}" if waiting else "")


def _after_renames(
    options: argparse.Namespace, merged: Merge, kinds: set[str], programs: list[Program]
) -> Iterator[str]:
    """What is to be done in programs, and what they would do, where names have changed their addresses."""
    for change in merged.of({RENAMED} & kinds):
        if change.before and change.after and change.used and not change.is_case_only:
            old, new = change.before.nickname, change.after.nickname
            words = ["clickgen", "nicknames", "rename", old, new, *_program_with(old, programs), *_table_words(options)]
            yield f"{old} stands in programs: {shlex.join(words)} renames it there too"
    swapped = merged.of([SWAPPED])
    if swapped:
        places = list(dict.fromkeys(place for change in swapped for place in change.used or ()))
        did = "drive other addresses now" if SWAPPED in kinds and not options.dry_run else "would drive other addresses"
        yield (
            f"{counted(len(swapped), 'address', 'addresses')} swapped names that programs use: no rename follows that, "
            f"and the programs {did} at {', '.join(places)}"
        )


def _program_with(name: str, programs: list[Program]) -> list[str]:
    """A program that uses a name, or one that stands for the parts that do: a rename finds all others."""
    whole = [program for program in programs if not program.is_part]
    using = [program for program in whole if any(file.of(name) for file in program.names)]
    return [str(near(Path(program.path))) for program in (using or whole)[:1]]


def _table_words(options: argparse.Namespace) -> list[str]:
    words = ["--nicknames", options.nicknames] if options.nicknames else []
    return [*words, *(["--config", options.config] if options.config else [])]


def _kinds(accepted: Iterable[str]) -> set[str]:
    words = {word.strip() for words in accepted for word in words.split(",") if word.strip()}
    # What programs do changes with swapped names: these are asked for by their own word alone.
    everything = {*KINDS} - {SWAPPED} if "all" in words else set()
    kinds = {"added"} | everything | (words - {"all"})
    unknown = sorted(kinds - set(KINDS))
    if unknown:
        from clickgen.problems.diagnostics import did_you_mean

        hint = did_you_mean(unknown[0], [*KINDS, "all"]) or f"the kinds: {', '.join(KINDS)}, all"
        raise CouldNotRun(f"there is no kind of change {unknown[0]!r}; {hint}")
    return kinds


def _table_to_merge(options: argparse.Namespace) -> _Merging:
    """The table that takes the export in: the one that is named, else the one of the settings."""
    config = settings_of(options.config)
    found = jobs([], config=options.config) if config.programs else []
    named = Path(options.nicknames) if options.nicknames else None
    if named is not None and not is_workbook(named):
        own = [job for job in found if _same(job.settings.table_of(job.program), named)]
        return _Merging(named, _one_workbook(own), found)
    own = [job for job in found if named is None or _same(job.settings.nicknames, named)] or found
    others = [job for job in found if job not in own]
    if named is not None:
        own = [replace(job, settings=job.settings._replace(nicknames=named)) for job in own]
    tables = list(dict.fromkeys(job.settings.table_of(job.program) for job in own))
    if len(tables) > 1:
        raise CouldNotRun(f"the settings know {len(tables)} tables: name one of them with --nicknames")
    return _Merging(tables[0] if tables else Path(TABLE_NAME), named or _one_workbook(own), own + others)


def _same(one: str | os.PathLike[str] | None, other: Path) -> bool:
    return one is not None and os.path.realpath(one) == os.path.realpath(other)


def _one_workbook(own: Iterable[Job]) -> Path | None:
    """The workbook that the programs of a table have in the settings."""
    named = (Path(job.settings.nicknames) for job in own if job.settings.nicknames is not None)
    books = list(dict.fromkeys(path for path in named if is_workbook(path)))
    if len(books) > 1:
        raise CouldNotRun(f"the settings know {len(books)} workbooks for this table: name one with --nicknames")
    return books[0] if books else None


def _read(path: Path, must_exist: bool, workbook: Path | None = None) -> tuple[AddressTable, bytes | None]:
    """A table, with the rows of a workbook in front, and the bytes of its file."""
    from clickgen.table.layers import read_layers
    from clickgen.table.read import TableUnreadable

    problems = Diagnostics()
    try:
        table, before = read_layers(path, workbook, must_exist, Workspace(), problems)
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None
    if problems.has_errors:
        write_problems(problems.in_order(), [], sys.stderr)
        raise CouldNotRun(f"{path} has {summary(problem.severity for problem in problems.found)}; nothing was written")
    return table, before


def _indented(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]


# -- rename -----------------------------------------------------------------------------------------------------------


def _adoption_lines(result: Rename, is_dry: bool) -> Iterator[str]:
    """What became of a rename that somebody had begun in the programs."""
    assert result.adoption is not None
    programs = ", ".join(str(near(Path(program))) for program in result.programs)
    address, is_now = result.adoption.row.address, "would be" if is_dry else "is"
    yield f"{address} {is_now} {result.new} and no longer {result.old}, as {programs} said already"
    for row in result.adoption.freed:
        had = f"{row.address}, which a build had given to {result.new}"
        yield f"{had}, {is_now} free: build again and load that into CLICK"


def _rename(options: argparse.Namespace) -> int:
    found = _jobs(options, options.programs)
    if not options.dry_run:
        settle(found, options.config)
    result = rename(options.old, options.new, found, settings_of(options.config))
    programs = ", ".join(str(near(Path(program))) for program in result.programs)
    becomes, stays = ("would become", "would be") if options.dry_run else ("becomes", "stays")
    tell(f"{result.old} {becomes} {result.new}; the ladder of {programs} {stays} the same:")
    for path, count in sorted((near(path), count) for path, count in result.counts.items()):
        tell(f"  {path}: {counted(count, 'time')}")
    for path, count in sorted((near(path), count) for path, count in result.comments.items()):
        tell(f"  {path}: {counted(count, 'comment')} still {'say' if count > 1 else 'says'} {result.old}")
    for span in result.left:
        place = f"{near(Path(span.path))}:{span.line}"
        tell(f"  {place} says {result.old} too, in a file that no program imports: it stays as it is")
    if options.dry_run:
        if result.adoption is not None:
            tell(*_adoption_lines(result, options.dry_run))
        return OK
    sys.stdout.flush()
    put_in_place(result.writes, (), result.unchanged)
    tell(*(_adoption_lines(result, False) if result.adoption is not None else [f"{result.old} is {result.new} now"]))
    return OK


# -- why --------------------------------------------------------------------------------------------------------------


def _why(options: argparse.Namespace) -> int:
    from clickgen.commands.nicknames.why import suggestion, why
    from clickgen.table.names import record_beside
    from clickgen.table.record import read_record

    found = _jobs(options, options.programs)
    results = [build(job.program, settings=job.settings) for job in found]
    broken = [result for result in results if not result.ok]
    for result in broken:
        write_problems([problem for problem in result.diagnostics if problem.is_error], result.sources, sys.stderr)
    if broken:
        complain(f"{_summary(broken)}; a program with errors has no addresses yet")
        return PROBLEMS
    said = []
    for job, result in zip(found, results, strict=True):
        data = read_record(record_beside(result.table_path))
        said += why(options.name, result, job.settings.reserved, data)
    if not said:
        hint = suggestion(options.name, results)
        complain(f"no program knows {options.name}{f'; {hint}' if hint else ''}")
        return PROBLEMS
    tell(*said)
    return OK


def _summary(results: Iterable[BuildResult]) -> str:
    return summary(problem.severity for result in results for problem in result.diagnostics)


_COMMANDS: dict[str, Callable[[argparse.Namespace], int]] = {
    "sync": _sync,
    "check": _check,
    "merge": _merge,
    "rename": _rename,
    "why": _why,
}
