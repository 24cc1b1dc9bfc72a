"""``clickgen workbook``: the project as an Excel workbook."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Run
from clickgen.commands.nicknames.elsewhere import build_among
from clickgen.commands.workbook.place import former, place_of
from clickgen.problems.report.frames import summary, write_problems
from clickgen.results import BuildResult
from clickgen.text.wording import counted
from clickgen.text.write import put_in_place

DESCRIPTION = (
    "Write a workbook for people: the I/O list, the tags, the cross-reference, timers, memory and rungs. The "
    "address table is read and not changed."
)
EXAMPLES = """\
examples:
  clickgen workbook prog.py                     build/prog/prog.xlsx
  clickgen workbook prog.py -o project.xlsx

exit codes: 0 written; 1 problems in the program; 2 could not run
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("program", metavar="PROG.py", help="the program")
    add("-o", "--output", metavar="FILE.xlsx", help="the workbook (default: build/<program>/<program>.xlsx)")
    add("--nicknames", metavar="TABLE", help="the address table (default: nicknames.csv beside the program)")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")


def run(options: argparse.Namespace) -> int:
    """Write the workbook of a program; return the exit code."""
    this = Run(options.config)
    (job,) = this.jobs([options.program], options.nicknames)
    this.settle([job])
    path = place_of(options.output, job.program, job.folder)
    before = former(path, job.settings.nicknames, this.files)
    (result,) = build_among([job], lambda: this.settings, this.files)
    write_problems(result.diagnostics, result.sources, sys.stderr, this.files)
    noted = summary(problem.severity for problem in result.diagnostics)
    if not result.ok:
        complain(f"{noted}; nothing was written")
        return PROBLEMS
    from clickgen.emit.workbook.sheets import workbook

    put_in_place({path: workbook(result.built)}, unchanged={path: before}, no_links=[path])
    tell(*_report(result, path, noted))
    return OK


def _report(result: BuildResult, path: Path, noted: str) -> list[str]:
    rungs = sum(len(routine.rungs) for routine in result.routines)
    lines = [f"Wrote {path}: {counted(rungs, 'rung')}, {counted(len(result.rows), 'address', 'addresses')}."]
    new = len(result.new_rows)
    if new:
        which, what = ("is", "it") if new == 1 else ("are", "them")
        lines.append(
            f"{counted(new, 'address', 'addresses')} of it {which} not in {result.table_path} yet: "
            f"clickgen build writes {what}."
        )
    if noted:
        lines.append(f"{noted[0].upper() + noted[1:]} above.")
    return lines
