"""``clickgen nicknames check``: whether table and programs agree."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable

from clickgen.api import build, build_all
from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Run
from clickgen.cli.nicknames.shared import add_programs, is_about_names, jobs_of, table_lines
from clickgen.problems.report.frames import write_problems
from clickgen.results import BuildResult
from clickgen.text.wording import counted

HELP = "whether table and programs agree"
DESCRIPTION = "Check the address table and the names of the programs, without writing anything: for CI."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add_programs(parser)


def run(options: argparse.Namespace) -> int:
    """Report the problems of names, addresses and the table; count the others, which ``clickgen check`` reports."""
    from clickgen.commands.nicknames.sync import table_changes

    this = Run(options.config)
    found = jobs_of(this, options)
    built = build_all(((job.program, job.settings) for job in found), this.files)
    results = built
    if not all(map(_needs_nothing, built)):
        # Report what is missing as a frozen build does.
        frozen = [(job.program, job.settings._replace(frozen=True)) for job in found]
        results = [build(program, settings=settings, workspace=this.files) for program, settings in frozen]
    told = 0
    for result in results:
        own = [problem for problem in result.diagnostics if is_about_names(problem)]
        others = [problem for problem in result.diagnostics if problem.is_error and not is_about_names(problem)]
        write_problems(own, result.sources, sys.stdout, this.files)
        told += len([problem for problem in own if problem.is_error]) + len(others)
        if others:
            complain(f"{result.program} has {counted(len(others), 'other error')}: see clickgen check {result.program}")
    if told:
        return PROBLEMS
    lacking = [table for table in table_changes(built) if table.added or table.changed]
    for table in lacking:
        tell(*table_lines(table, is_dry=True))
    if lacking:
        complain("run clickgen nicknames sync and commit the table")
        return PROBLEMS
    tables = {str(result.table_path): len(result.rows) for result in results}
    for path, count in tables.items():
        tell(f"{path}: {counted(count, 'address', 'addresses')}, in agreement with {_programs(results, path)}")
    return OK


def _needs_nothing(result: BuildResult) -> bool:
    """True if a frozen build of the program gives the same result."""
    return result.ok and not result.new_rows and result.table == result.table_before


def _programs(results: Iterable[BuildResult], path: str) -> str:
    return ", ".join(str(result.program) for result in results if str(result.table_path) == path)
