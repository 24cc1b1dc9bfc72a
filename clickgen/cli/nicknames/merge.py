"""``clickgen nicknames merge``: merge a fresh export from CLICK."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from clickgen.cli import OK, PROBLEMS, tell
from clickgen.cli.jobs import Job, Run, near
from clickgen.commands.nicknames.changes import KINDS, RENAMED, SWAPPED
from clickgen.commands.nicknames.merge import Merge
from clickgen.commands.nicknames.programs import Program
from clickgen.commands.nicknames.uses import FileNames
from clickgen.problems.diagnostics import Diagnostics
from clickgen.problems.report.frames import summary, write_problems
from clickgen.table.address_table import AddressTable
from clickgen.table.names import TABLE_NAME, is_workbook
from clickgen.text.source import SourceFile
from clickgen.text.wording import counted
from clickgen.text.write import put_in_place
from clickgen.workspace import CouldNotRun, Workspace

HELP = "take in a fresh export from CLICK"
DESCRIPTION = (
    "Show what an export from CLICK says otherwise than the address table, and take in what is new. All else is "
    "taken in only when it is asked for."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("export", metavar="EXPORT.csv", help="the nickname CSV that CLICK wrote")
    add(
        "--accept",
        metavar="KINDS",
        action="append",
        default=[],
        help="take these in too: renamed, moved, removed, changed, all; swapped only by its own name",
    )
    add("--dry-run", action="store_true", help="show the differences, and write nothing")


class _Merging(NamedTuple):
    """The target of an export: the table, the workbook that it adds to, and programs that are known to use it."""

    table: Path
    workbook: Path | None
    jobs: list[Job]


def run(options: argparse.Namespace) -> int:
    """Show the differences of an export, and take those that are wanted; return the exit code."""
    from clickgen.commands.nicknames.changed_rows import conflict_lines, diff_lines, never_lines, summary
    from clickgen.commands.nicknames.merge import merge
    from clickgen.commands.nicknames.programs import programs_around
    from clickgen.commands.nicknames.uses import ProgramsSay, places_in

    kinds = _kinds(options.accept)
    this = Run(options.config)
    target = _table_to_merge(this, options)
    path = target.table
    if not options.dry_run:
        this.settle(target.jobs)
    table, before = _read(this.files, path, bool(options.nicknames) and target.workbook is None, target.workbook)
    export, _ = _read(this.files, Path(options.export), must_exist=True)
    around = programs_around(target.jobs, this.settings, this.files, [path])
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
    """A file of a program whose messages name it relative to the working folder."""
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
    """What to do in programs, and what they would do, if names have changed their addresses."""
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
    """A program that uses a name, or one that represents the parts that do: a rename finds all others."""
    whole = [program for program in programs if not program.is_part]
    using = [program for program in whole if any(file.of(name) for file in program.names)]
    return [str(near(Path(program.path))) for program in (using or whole)[:1]]


def _table_words(options: argparse.Namespace) -> list[str]:
    words = ["--nicknames", options.nicknames] if options.nicknames else []
    return [*words, *(["--config", options.config] if options.config else [])]


def _kinds(accepted: Iterable[str]) -> set[str]:
    words = {word.strip() for words in accepted for word in words.split(",") if word.strip()}
    # Swapped names change what programs do: these are taken only by their own word.
    everything = {*KINDS} - {SWAPPED} if "all" in words else set()
    kinds = {"added"} | everything | (words - {"all"})
    unknown = sorted(kinds - set(KINDS))
    if unknown:
        from clickgen.problems.diagnostics import did_you_mean

        hint = did_you_mean(unknown[0], [*KINDS, "all"]) or f"the kinds: {', '.join(KINDS)}, all"
        raise CouldNotRun(f"there is no kind of change {unknown[0]!r}; {hint}")
    return kinds


def _table_to_merge(this: Run, options: argparse.Namespace) -> _Merging:
    """The table that takes the export: the named one, else the one of the settings."""
    found = this.jobs([]) if this.settings.programs else []
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


def _read(
    files: Workspace, path: Path, must_exist: bool, workbook: Path | None = None
) -> tuple[AddressTable, bytes | None]:
    """A table, with the rows of a workbook in front, and the bytes of its file."""
    from clickgen.table.layers import read_layers
    from clickgen.table.read import TableUnreadable

    problems = Diagnostics()
    try:
        table, before = read_layers(path, workbook, must_exist, files, problems)
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None
    if problems.has_errors:
        write_problems(problems.in_order(), [], sys.stderr, files)
        raise CouldNotRun(f"{path} has {summary(problem.severity for problem in problems.found)}; nothing was written")
    return table, before


def _indented(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]
