"""``clickgen build``: a program into the folder that goes into CLICK."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Job, Run, near
from clickgen.commands.nicknames.elsewhere import build_among
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.name_slips import Spellings
from clickgen.problems.report.frames import summary, write_problems
from clickgen.results import BuildResult, write_all
from clickgen.table.own_table import own_table_setting
from clickgen.table.rows import Row
from clickgen.text.lock import locked
from clickgen.text.wording import counted
from clickgen.text.write import ChangedMeanwhile
from clickgen.workspace import CouldNotRun, Workspace

_NAMES_MAX = 8
"""A build lists this many new names."""

DESCRIPTION = "Build a program: ladder CSV files, the nickname CSV, a listing and a source map."
EXAMPLES = """\
examples:
  clickgen build prog.py
  clickgen build prog.py -o out --nicknames plant/nicknames.csv
  clickgen build prog.py --frozen
  clickgen build                      every program that the settings name

exit codes: 0 built; 1 problems in the program; 2 could not run
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("program", metavar="PROG.py", nargs="?", help="the program (default: every configured one)")
    parser.add_argument("-o", "--output", metavar="DIR", help="the output folder (default: build/<program>/)")
    parser.add_argument(
        "--nicknames",
        metavar="TABLE",
        help="the address table, or a workbook with lists of addresses (default: nicknames.csv beside the program)",
    )
    parser.add_argument("--frozen", action="store_true", help="choose no address; fail where one is missing")
    parser.add_argument("--no-cache", action="store_true", help="read everything anew, and remember nothing")
    parser.add_argument("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")


def run(options: argparse.Namespace) -> int:
    """Build and write one program or, without one, every configured one, all of them or none; return the exit code."""
    this = Run(options.config)
    if not options.no_cache:
        this.remember()
    jobs = _jobs(this, options.program, options.output, options.nicknames, options.frozen)
    this.settle(jobs)
    results = _built(jobs, this)
    if not all(result.ok for result in results):
        complain(f"{_summary(results)}; nothing was written")
        return PROBLEMS
    for job, result in zip(jobs, results, strict=True):
        tell(*_report(result, job, this))
    return OK


_TRIES = 5


def _built(jobs: Sequence[Job], this: Run) -> list[BuildResult]:
    """Build and write; if a table changed in between, again, now with the folders locked against other builds."""
    told: set[Diagnostic] = set()
    files = this.files
    with ExitStack() as stack:
        for left in reversed(range(_TRIES)):
            results = build_among(jobs, lambda: this.settings, files)
            # The table is shown as it was read, so before anything is written.
            for result in results:
                news = [each for each in result.diagnostics if each not in told]
                write_problems(news, result.sources, sys.stderr, files)
                told.update(result.diagnostics)
            if not all(result.ok for result in results):
                break
            try:
                write_all([(result, job.folder) for job, result in zip(jobs, results, strict=True)])
                files.memory.save()
                break
            except ChangedMeanwhile:
                if not left:
                    raise
                files = Workspace(memory=files.memory)  # Somebody wrote a table after it was read.
                stack.enter_context(locked(folder for job in jobs for folder in job.folders[1:] if folder.is_dir()))
    return results


def _jobs(this: Run, program: str | None, output: str | None, nicknames: str | None, frozen: bool) -> list[Job]:
    if output == "":
        raise CouldNotRun("the output folder after -o is empty")
    found = this.jobs([program] if program is not None else [], nicknames, frozen)
    if len(found) > 1 and (output or nicknames):
        raise CouldNotRun("several programs are configured: -o and --nicknames go with one, so name it")
    if output:
        return [replace(job, folder=Path(output)) for job in found]
    folders = [job.folder for job in found]
    twice = next((folder for folder in folders if folders.count(folder) > 1), None)
    if twice:
        raise CouldNotRun(f"two programs would be built into {twice}: give each an output in the settings")
    return found


def _report(result: BuildResult, job: Job, this: Run) -> list[str]:
    folder = job.folder
    main, subroutines = result.main, result.subroutines
    counts = [f"{counted(len(main.rungs), 'rung')} in main"]
    if subroutines:
        rungs = sum(len(routine.rungs) for routine in subroutines)
        counts.append(f"{counted(rungs, 'rung')} in {counted(len(subroutines), 'subroutine')}")
    new = result.new_rows
    lines = [f"Built {near(result.program)}: {', '.join(counts)}."]
    if new:
        lines.append(f"{counted(len(new), 'new address', 'new addresses')} in {result.table_path}: commit it.")
        lines += _new_names(result)
        lines += _shared(result, job, this)
    noted = _summary([result])
    if noted:
        lines.append(f"{noted[0].upper() + noted[1:]} above.")
    lines += [f"Files: {folder}", "Next:"]
    steps = [f"in CLICK: File > Import > Nicknames, {folder / 'nicknames.csv'}"]
    if subroutines:
        names = ", ".join(routine.name for routine in subroutines)
        steps.append(f"in CLICK: create {counted(len(subroutines), 'subroutine')} by hand, named {names}")
    steps.append(f"in ClickNick: Ladder > Open in Guided Paste, {folder}")
    lines += [f"  {number}. {step}" for number, step in enumerate(steps, 1)]
    return lines


def _new_names(result: BuildResult) -> list[str]:
    """The names that were new to the build, a few of them, and each that another name of its bank looks like."""
    new = sorted(result.placed_rows, key=lambda row: row.address.sort_key)
    if not new:
        return []
    listed = [f"{row.address} {row.nickname}" for row in new[:_NAMES_MAX]]
    more = f" and {len(new) - _NAMES_MAX} more" if len(new) > _NAMES_MAX else ""
    lines = [f"New names: {', '.join(listed)}{more}."]
    by_bank: dict[str, dict[str, Row]] = defaultdict(dict)
    for row in result.rows:
        if row.nickname:
            by_bank[row.address.bank][row.nickname] = row
    spellings = {bank: Spellings(names) for bank, names in by_bank.items()}
    fresh = {row.address for row in new}
    for row in new:
        bank = row.address.bank
        for other in (by_bank[bank][name] for name in spellings[bank].near(row.nickname)):
            # One line is enough for two new names that look alike.
            if other.address not in fresh or other.address.sort_key < row.address.sort_key:
                pair = f"{row.address} {row.nickname} looks like {other.address} {other.nickname}"
                lines.append(f"  {pair}: is one of them misspelled?")
                break
    return lines


_MAIN = re.compile(rb"^def main\(", re.MULTILINE)


def _shared(result: BuildResult, job: Job, this: Run) -> Iterator[str]:
    """How to separate two programs that share a table because nobody named one.

    If the settings name both, somebody has decided it.
    """
    if job.settings.nicknames is not None:
        return
    configured = {os.path.realpath(program.path) for program in this.settings.programs}
    is_configured = os.path.realpath(result.program) in configured
    own = {os.path.realpath(source.path) for source in result.sources}
    for path in sorted(result.program.parent.glob("*.py")):
        if is_configured and os.path.realpath(path) in configured:
            continue
        if os.path.realpath(path) not in own and path.is_file() and _has_main(path, this.files):
            copy = near(result.program).with_suffix(".csv")
            yield f"{near(path)} has this table too. For two PLCs copy it to {copy}, and name that in clickgen.toml:"
            yield f"  {own_table_setting(near(result.program))}"
            return


def _has_main(path: Path, files: Workspace) -> bool:
    """True for a program; a neighbour that cannot be read is no reason for a build to fail after it has written."""
    try:
        return _MAIN.search(files.read(path)) is not None
    except OSError:
        return False


def _summary(results: Iterable[BuildResult]) -> str:
    return summary(problem.severity for result in results for problem in result.diagnostics)
