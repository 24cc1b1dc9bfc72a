"""``clickgen nicknames why``: where the address of a name comes from."""

from __future__ import annotations

import argparse
import sys

from clickgen.api import build
from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Run
from clickgen.cli.nicknames.shared import add_programs, jobs_of, summary_of
from clickgen.problems.report.frames import write_problems

HELP = "where the address of a name comes from"
DESCRIPTION = "Say where the address of a name comes from, why it is that one, and where the name is used."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME", help="a nickname, a block, or an address such as DS5")
    add_programs(parser)


def run(options: argparse.Namespace) -> int:
    """Say where the address of a name comes from; return the exit code."""
    from clickgen.commands.nicknames.why import suggestion, why
    from clickgen.table.names import record_beside
    from clickgen.table.record import read_record

    this = Run(options.config)
    found = jobs_of(this, options)
    results = [build(job.program, settings=job.settings, workspace=this.files) for job in found]
    broken = [result for result in results if not result.ok]
    for result in broken:
        errors = [problem for problem in result.diagnostics if problem.is_error]
        write_problems(errors, result.sources, sys.stderr, this.files)
    if broken:
        complain(f"{summary_of(broken)}; a program with errors has no addresses yet")
        return PROBLEMS
    said = []
    for job, result in zip(found, results, strict=True):
        data = read_record(record_beside(result.table_path), this.files)
        said += why(options.name, result, job.settings.reserved, data)
    if not said:
        hint = suggestion(options.name, results)
        complain(f"no program knows {options.name}{f'; {hint}' if hint else ''}")
        return PROBLEMS
    tell(*said)
    return OK
