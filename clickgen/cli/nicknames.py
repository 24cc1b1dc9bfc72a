"""``clickgen nicknames``: what concerns the address table: sync, check, merge, rename, why."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path

from clickgen.cli import COULD_NOT_RUN, OK, PROBLEMS
from clickgen.cli.jobs import Job, jobs, settings_of
from clickgen.diagnostics import CouldNotRun, Diagnostic, Diagnostics
from clickgen.emit.write import put_in_place
from clickgen.nicknames.changes import KINDS, RENAMED
from clickgen.nicknames.merge import Merge
from clickgen.nicknames.sync import TableSync
from clickgen.pipeline import TABLE_NAME, BuildResult, build
from clickgen.report.frames import printable, summary, write_problems
from clickgen.resolve.rows import Row
from clickgen.resolve.table import AddressTable
from clickgen.wording import counted


def run(options: argparse.Namespace) -> int:
    """Run one of the commands; returns the exit code."""
    try:
        return _COMMANDS[options.action](options)
    except CouldNotRun as error:
        _say(printable(str(error)))
    except BrokenPipeError:
        raise
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        _say(f"{printable(place)}{error.strerror or error}; nothing was written")
    return COULD_NOT_RUN


def _say(text: str) -> None:
    print(f"clickgen: {text}", file=sys.stderr)


def _jobs(options: argparse.Namespace, programs: Iterable[str]) -> list[Job]:
    found = jobs(list(programs), options.nicknames, config=options.config)
    if len(found) > 1 and options.nicknames and not options.programs:
        raise CouldNotRun("several programs are configured: --nicknames goes with those that you name")
    return found


# -- sync -------------------------------------------------------------------------------------------------------------


def _sync(options: argparse.Namespace) -> int:
    from clickgen.nicknames.sync import sync

    result = sync(_jobs(options, options.programs), settings_of(options.config), options.prune)
    if not result.ok:
        for each in result.results:
            write_problems(each.diagnostics, each.sources, sys.stderr)
        _say(f"{_summary(result.results)}; nothing was written")
        return PROBLEMS
    # What is shown of the table is what was read, so before anything is written.
    for each in result.results:
        write_problems(filter(_is_about_names, each.diagnostics), each.sources, sys.stderr)
    if not options.dry_run:
        put_in_place(result.writes, (), result.unchanged)
    for table in result.tables:
        print("\n".join(_table_lines(table, options.dry_run)))
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
    from clickgen.nicknames.sync import sync

    found = _jobs(options, options.programs)
    results = [build(job.program, settings=replace(job.settings, frozen=True)) for job in found]
    told = 0
    for result in results:
        own = [problem for problem in result.diagnostics if _is_about_names(problem)]
        others = [problem for problem in result.diagnostics if problem.is_error and not _is_about_names(problem)]
        write_problems(own, result.sources, sys.stdout)
        told += len([problem for problem in own if problem.is_error]) + len(others)
        if others:
            _say(f"{result.program} has {counted(len(others), 'other error')}: see clickgen check {result.program}")
    if told:
        return PROBLEMS
    lacking = [table for table in sync(found, settings_of(options.config)).tables if table.added or table.changed]
    for table in lacking:
        print("\n".join(_table_lines(replace(table, unused=()), is_dry=True)))
    if lacking:
        _say("run clickgen nicknames sync and commit the table")
        return PROBLEMS
    tables = {str(result.table_path): len(result.rows) for result in results}
    for path, count in tables.items():
        print(f"{path}: {counted(count, 'address', 'addresses')}, in agreement with {_programs(results, path)}")
    return OK


def _is_about_names(problem: Diagnostic) -> bool:
    return problem.code.startswith(("CG2", "CG6"))


def _programs(results: Iterable[BuildResult], path: str) -> str:
    return ", ".join(str(result.program) for result in results if str(result.table_path) == path)


# -- merge ------------------------------------------------------------------------------------------------------------


def _merge(options: argparse.Namespace) -> int:
    from clickgen.nicknames.diff import conflict_lines, diff_lines, summary
    from clickgen.nicknames.merge import merge
    from clickgen.nicknames.programs import Files, programs_around
    from clickgen.nicknames.uses import places_in

    kinds = _kinds(options.accept)
    path, found = _table_to_merge(options)
    table, before = _read(path, must_exist=False)
    export, _ = _read(Path(options.export), must_exist=True)
    around = programs_around(found, settings_of(options.config), Files(), [path])
    key = os.path.realpath(path)
    used = places_in(name for program in around if program.table_key == key for name in program.names)
    result = merge(table, export, used)
    conflicts = conflict_lines(result, kinds)
    left = [change for change in result.changes if change.kind not in kinds]
    print("\n".join([f"{options.export}: {summary(result)}", *_indented(diff_lines(result))]))
    if conflicts:
        print("\n".join(["cannot be taken so:", *_indented(conflicts)]), file=sys.stderr)
        return PROBLEMS
    after = result.taken(kinds).to_bytes()
    if not options.dry_run and after != before and (before is not None or result.of(kinds)):
        put_in_place({path: after}, (), {path: before})
    if result.changes:
        print(_merged(result, kinds, len(left), options.dry_run))
    for change in result.of({RENAMED} & kinds):
        if change.before and change.after and change.used and not change.is_case_only:
            old, new = change.before.nickname, change.after.nickname
            print(f"{old} stands in programs: clickgen nicknames rename {old} {new} renames it there too")
    return PROBLEMS if left else OK


def _merged(merged: Merge, kinds: set[str], left: int, is_dry: bool) -> str:
    taken = len(merged.changes) - left
    said = f"{counted(taken, 'change')} {'would be ' if is_dry else ''}taken"
    if left:
        waiting = sorted({change.kind for change in merged.changes if change.kind not in kinds}, key=KINDS.index)
        said += f", {left} not: take {'them' if left > 1 else 'it'} with --accept {','.join(waiting)}"
    return said


def _kinds(accepted: Iterable[str]) -> set[str]:
    words = {word.strip() for words in accepted for word in words.split(",") if word.strip()}
    kinds = {"added", *(KINDS if "all" in words else words)}
    unknown = sorted(kinds - set(KINDS))
    if unknown:
        from clickgen.diagnostics import did_you_mean

        hint = did_you_mean(unknown[0], [*KINDS, "all"]) or f"the kinds: {', '.join(KINDS)}, all"
        raise CouldNotRun(f"there is no kind of change {unknown[0]!r}; {hint}")
    return kinds


def _table_to_merge(options: argparse.Namespace) -> tuple[Path, list[Job]]:
    """The table that takes the export in, and the programs that are known to use it."""
    config = settings_of(options.config)
    found = jobs([], config=options.config) if config.programs else []
    if options.nicknames:
        return Path(options.nicknames), found
    from clickgen.nicknames.programs import table_of

    tables = list(dict.fromkeys(table_of(job.program, job.settings) for job in found))
    if len(tables) > 1:
        raise CouldNotRun(f"the settings know {len(tables)} tables: name one with --nicknames")
    return (tables[0] if tables else Path(TABLE_NAME)), found


def _read(path: Path, must_exist: bool) -> tuple[AddressTable, bytes | None]:
    from clickgen.resolve.read_table import TableUnreadable, read_table

    if not must_exist and not path.exists():
        return AddressTable.empty(str(path)), None
    problems = Diagnostics()
    try:
        table = read_table(path, str(path), problems)
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None
    if problems.has_errors:
        write_problems(problems.in_order(), [], sys.stderr)
        raise CouldNotRun(f"{path} has {summary(problem.severity for problem in problems.found)}; nothing was written")
    return table, table.to_bytes()


def _indented(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]


# -- rename -----------------------------------------------------------------------------------------------------------


def _rename(options: argparse.Namespace) -> int:
    from clickgen.nicknames.rename import rename

    found = _jobs(options, options.programs)
    result = rename(options.old, options.new, found, settings_of(options.config))
    if not options.dry_run:
        put_in_place(result.writes, (), result.unchanged)
    would = "would be " if options.dry_run else ""
    for path in sorted(result.writes):
        print(f"{path}: {counted(result.counts[path], 'time')} {would}renamed")
    for path, count in sorted(result.comments.items()):
        print(f"{path}: {counted(count, 'comment')} still {'say' if count > 1 else 'says'} {result.old}")
    print(f"{result.old} {would or 'is '}{result.new} now; the ladder of {', '.join(result.programs)} is the same")
    return OK


# -- why --------------------------------------------------------------------------------------------------------------


def _why(options: argparse.Namespace) -> int:
    from clickgen.nicknames.why import suggestion, why
    from clickgen.resolve.record import record_beside

    found = _jobs(options, options.programs)
    results = [build(job.program, settings=job.settings) for job in found]
    broken = [result for result in results if not result.ok]
    for result in broken:
        write_problems([problem for problem in result.diagnostics if problem.is_error], result.sources, sys.stderr)
    if broken:
        _say(f"{_summary(broken)}; a program with errors has no addresses yet")
        return PROBLEMS
    said = []
    for job, result in zip(found, results, strict=True):
        record = record_beside(result.table_path)
        data = record.read_bytes() if record.is_file() else None
        said += why(options.name, result, job.settings.reserved, data)
    if not said:
        hint = suggestion(options.name, results)
        _say(f"no program knows {options.name}{f'; {hint}' if hint else ''}")
        return PROBLEMS
    print("\n".join(said))
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
