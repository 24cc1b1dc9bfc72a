"""The common parts of the subcommands of ``clickgen nicknames``."""

from __future__ import annotations

import argparse
from collections.abc import Iterable

from clickgen.cli.jobs import Job, Run
from clickgen.commands.nicknames.sync import TableSync
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.report.frames import summary
from clickgen.results import BuildResult
from clickgen.table.rows import Row
from clickgen.text.wording import counted
from clickgen.workspace import CouldNotRun


def add_programs(parser: argparse.ArgumentParser) -> None:
    """The argument that names programs."""
    parser.add_argument("programs", metavar="PROG.py", nargs="*", help="the programs (default: every configured one)")


def jobs_of(this: Run, options: argparse.Namespace) -> list[Job]:
    """Return the programs that the options name, else every configured one. Raises CouldNotRun."""
    found = this.jobs(list(options.programs), options.nicknames)
    if len(found) > 1 and options.nicknames and not options.programs:
        raise CouldNotRun("several programs are configured: --nicknames goes with those that you name")
    return found


def table_lines(table: TableSync, is_dry: bool) -> list[str]:
    """One line about a table, and one for each row that is added, changed, removed or unused."""
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


def is_about_names(problem: Diagnostic) -> bool:
    """True for a problem of names, addresses and the table."""
    return problem.code.startswith(("CG2", "CG6"))


def summary_of(results: Iterable[BuildResult]) -> str:
    """``2 errors, 1 warning`` for the problems of several builds."""
    return summary(problem.severity for result in results for problem in result.diagnostics)
