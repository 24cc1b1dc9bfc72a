"""``clickgen import``: an existing CLICK project to a program."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from pathlib import Path

from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Run, near
from clickgen.commands.import_.project import ImportResult, Target, import_project
from clickgen.config import Settings
from clickgen.problems.report.frames import summary, write_problems
from clickgen.text.wording import counted
from clickgen.workspace import CouldNotRun

_SHOWN_MAX = 10
"""How many rungs are named in one line."""

DESCRIPTION = (
    "Write an existing CLICK project as a program, build that in memory, and compare rung by rung. What "
    "cannot be kept exactly stops the import."
)
EXAMPLES = """\
examples:
  clickgen import plant/ -o plant.py            a folder with main.csv, subroutines/*.csv, nicknames.csv
  clickgen import plant/ -o program/            one file for each subroutine
  clickgen import main.csv -o main.py --nicknames export.csv
  clickgen import copied.bin -o -               rungs from the clipboard, to the terminal
  clickgen import Temp/ -o plant.py             CLICK's own Scr*.tmp files

exit codes: 0 imported, every rung verified; 1 something cannot be kept; 2 could not run
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "source",
        metavar="SOURCE",
        help="a folder with main.csv, a ladder CSV, a clipboard capture, or CLICK's Scr*.tmp files",
    )
    add("-o", "--output", metavar="PROG.py", required=True, help="the program; DIR/: a file for each subroutine; -")
    add("--nicknames", metavar="TABLE", help="a nickname CSV (default: the one in SOURCE, else the one beside PROG.py)")
    add("--keep-going", action="store_true", help="leave a marked rung, which build refuses, for what cannot be kept")
    add("--no-verify", dest="verify", action="store_false", help="do not build and compare")
    add("--force", action="store_true", help="overwrite program files that say something else")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")


def run(options: argparse.Namespace) -> int:
    """Import, verify and write, all of it or nothing; return the exit code."""
    table = Path(options.nicknames) if options.nicknames is not None else None
    this = Run(options.config)
    target = _target(options.output, this)
    result = import_project(Path(options.source), target, table, options.keep_going, options.verify, this.files)
    write_problems(result.diagnostics, result.sources, sys.stderr, this.files)
    noted = summary(problem.severity for problem in result.diagnostics)
    if not result.files:
        complain(f"{noted}; nothing was written")
        return PROBLEMS
    if options.output == "-":
        sys.stdout.flush()
        sys.stdout.buffer.write(result.files[target.program])
        tell(*_verified(result), file=sys.stderr)
        return OK if result.ok else PROBLEMS
    result.write(options.force)
    tell(*_report(result, noted))
    return OK if result.ok else PROBLEMS


def _target(output: str, this: Run) -> Target:
    """The place for the program: a file that ends in .py, else a folder; ``-`` is the standard output."""
    if output == "-":
        return Target(Path("<standard output>") / "prog.py", is_shown=True)
    if not output:
        raise CouldNotRun("the place after -o is empty")
    path = Path(output)
    is_folder = path.is_dir() or output.endswith(("/", os.sep)) or path.suffix.lower() != ".py"
    if is_folder and path.suffix and not path.is_dir() and not output.endswith(("/", os.sep)):
        raise CouldNotRun(f"{output} does not end in .py; to make a folder of this name write {output}/")
    program = path / "main.py" if is_folder else path
    settings = this.settings
    own = settings.program(program)
    return Target(
        program, is_folder, settings=Settings(own.nicknames and near(own.nicknames), False, False, settings.reserved)
    )


def _report(result: ImportResult, noted: str) -> list[str]:
    place = result.target.program.parent if result.target.is_folder else result.target.program
    lines = [f"Imported {result.source} into {near(place)}: {_counts(result)}.", *_verified(result)]
    if result.left_out:
        marked = f"{counted(result.left_out, 'rung')} could not be kept"
        lines.append(f"{marked}: look for not_imported in the program; a build refuses it until then.")
    if noted:
        lines.append(f"{noted[0].upper() + noted[1:]} above.")
    if result.names:
        lines.append(f"{counted(result.names, 'nickname')} in {near(result.target.table)}: commit it with the program.")
    program = shlex.quote(str(near(result.target.program)))
    if result.ok and result.is_whole:
        lines += ["Next:", f"  1. clickgen check {program}", f"  2. clickgen build {program}"]
    return lines


def _counts(result: ImportResult) -> str:
    main = [routine for routine in result.routines if routine.is_main]
    others = [routine for routine in result.routines if not routine.is_main]
    parts = [f"{counted(routine.count, 'rung')} in main" for routine in main]
    if others:
        rungs = sum(routine.count for routine in others)
        parts.append(f"{counted(rungs, 'rung')} in {counted(len(others), 'subroutine')}")
    return ", ".join(parts)


def _verified(result: ImportResult) -> list[str]:
    if result.verdict is None:
        return [f"0 of {counted(result.rungs, 'rung')} verified: --no-verify was given."]
    verdict = result.verdict
    identical = verdict.verified - len(verdict.redrawn)
    lines = [f"{verdict.verified} of {counted(result.rungs, 'rung')} verified, {identical} identical cell by cell."]
    if verdict.redrawn:
        drawn = ((each.routine, each.piece.drawn) for each in verdict.redrawn)
        names = [f"{routine.name} rung {rung.number}" for routine, rung in drawn if rung]
        more = f" and {len(names) - _SHOWN_MAX} more" if len(names) > _SHOWN_MAX else ""
        lines.append(f"Drawn otherwise, the same logic: {', '.join(names[:_SHOWN_MAX])}{more}.")
    return lines
