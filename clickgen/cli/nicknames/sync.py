"""``clickgen nicknames sync``: give every name an address."""

from __future__ import annotations

import argparse
import sys

from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Run
from clickgen.cli.nicknames.shared import add_programs, is_about_names, jobs_of, summary_of, table_lines
from clickgen.problems.report.frames import write_problems
from clickgen.text.write import put_in_place

HELP = "give every name an address"
DESCRIPTION = "Give every name of the programs an address, and name what no program uses. Nothing is dropped."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add_programs(parser)
    add("--prune", action="store_true", help="remove names that clickgen placed and nothing uses any more")
    add("--dry-run", action="store_true", help="say what would be done, and write nothing")


def run(options: argparse.Namespace) -> int:
    """Give every name an address, or only show it; return the exit code."""
    from clickgen.commands.nicknames.sync import sync

    this = Run(options.config)
    found = jobs_of(this, options)
    if not options.dry_run:
        this.settle(found)
    result = sync(found, this.settings, options.prune, this.files)
    if not result.ok:
        for each in result.results:
            write_problems(each.diagnostics, each.sources, sys.stderr, this.files)
        complain(f"{summary_of(result.results)}; nothing was written")
        return PROBLEMS
    # The table is shown as it was read, so before anything is written.
    for each in result.results:
        write_problems(filter(is_about_names, each.diagnostics), each.sources, sys.stderr, this.files)
    if not options.dry_run:
        put_in_place(result.writes, (), result.unchanged)
    for table in result.tables:
        tell(*table_lines(table, options.dry_run))
    return OK
