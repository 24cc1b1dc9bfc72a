"""``clickgen workbook``: the project as an Excel workbook."""

from __future__ import annotations

import argparse
import os
import sys
from functools import partial
from pathlib import Path

from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Job, jobs, settings_of, settle
from clickgen.commands.nicknames.elsewhere import build_among
from clickgen.pipeline import BuildResult
from clickgen.problems.diagnostics import CouldNotRun
from clickgen.problems.report.frames import summary, write_problems
from clickgen.text.wording import counted
from clickgen.text.write import put_in_place
from clickgen.workspace import read_if_there

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
    """Write the workbook of a program; returns the exit code."""
    (job,) = jobs([options.program], options.nicknames, config=options.config)
    settle([job], options.config)
    path = _place(job, options.output)
    before = _former(path, job)
    (result,) = build_among([job], partial(settings_of, options.config))
    write_problems(result.diagnostics, result.sources, sys.stderr)
    noted = summary(problem.severity for problem in result.diagnostics)
    if not result.ok:
        complain(f"{noted}; nothing was written")
        return PROBLEMS
    put_in_place({path: _workbook(result, job)}, unchanged={path: before}, no_links=[path])
    tell(*_report(result, path, noted))
    return OK


def _place(job: Job, output: str | None) -> Path:
    """Where the workbook goes; without ``-o`` beside what ``clickgen build`` makes of the program."""
    if output is None:
        return job.folder / f"{Path(job.program).stem}.xlsx"
    if Path(output).suffix.lower() != ".xlsx":
        raise CouldNotRun(f"the workbook's name must end in .xlsx, and {output or 'the name after -o'} does not")
    return Path(output)


def _former(path: Path, job: Job) -> bytes | None:
    """What stands where the workbook goes. Raises CouldNotRun where that is not an earlier workbook of clickgen."""
    from clickgen.emit.workbook.archive import is_ours

    table = job.settings.nicknames
    if table is not None and os.path.realpath(path) == os.path.realpath(table):
        raise CouldNotRun(f"{path} is the address table; choose another file with -o")
    before = read_if_there(path)
    if before is None:
        return None
    if not is_ours(before):
        raise CouldNotRun(
            f"{path} was not written by clickgen, or somebody has saved it since; move it away, or choose another "
            "file with -o"
        )
    return before


def _workbook(result: BuildResult, job: Job) -> bytes:
    from clickgen.commands.nicknames.why import blocks_of
    from clickgen.emit.workbook import Project, workbook
    from clickgen.table.blocks import covered

    blocks = frozenset(covered(blocks_of(result)))
    return workbook(
        Project(
            result.program.stem,
            result.routines,
            result.rows,
            result.scratch_rows,
            frozenset(job.settings.reserved),
            len(result.new_rows),
            os.path.dirname(str(result.program)),
            blocks,
        )
    )


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
