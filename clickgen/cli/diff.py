"""``clickgen diff``: what two programs, bundles or revisions do otherwise."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from clickgen.cli import COULD_NOT_RUN, OK, PROBLEMS, complain
from clickgen.cli.jobs import jobs
from clickgen.cli.jobs import settings_of as settings_of_folder
from clickgen.commands.diff.as_text import Line, report, summary
from clickgen.commands.diff.names import name_changes
from clickgen.commands.diff.pairs import pairs_of
from clickgen.commands.diff.programs import diff
from clickgen.commands.diff.read import Wanted, read_side
from clickgen.commands.diff.sides import BrokenProgram
from clickgen.config import Settings
from clickgen.problems.diagnostics import CouldNotRun
from clickgen.problems.report import use_color
from clickgen.problems.report.frames import summary as counts
from clickgen.problems.report.frames import write_problems
from clickgen.text.wording import escaped

_COLORS = {"-": "31", "+": "32"}

DESCRIPTION = (
    "Show which rungs were added, removed, moved or changed, in the words of the listing, and what addresses begin "
    "with. Comments, nicknames, how a rung is drawn or divided, and clickgen's own scratch cells are no logic. "
    "Nothing is written."
)
EXAMPLES = """\
examples:
  clickgen diff HEAD:prog.py prog.py          what changed since the last commit
  clickgen diff main:prog.py feature:prog.py  two branches
  clickgen diff HEAD~1 HEAD                   every program of the settings, or the only one here
  clickgen diff prog.py build/prog            is the bundle what the program says?
  clickgen diff prog.py from-the-plc/         is what CLICK holds what is in git?
  clickgen diff prog.py Scr1.tmp -q           the summary alone

A side is a program, a bundle folder, a ladder CSV, a capture of the clipboard, a program file of CLICK (Scr*.tmp), or
one of these in a revision of git: REV:PATH from the repository's root, REV:./PATH from the working folder, :PATH in the
index. A folder with one program in it is that program. A path that exists wins.

exit codes: 0 no difference in logic; 1 logic differs; 2 could not run
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("one", metavar="OLD", help="the older side")
    add("other", metavar="NEW", help="the newer side")
    add("--nicknames", metavar="TABLE", help="the address table of programs (default: nicknames.csv beside each)")
    add("--export", metavar="EXPORT.csv", help="the nicknames that CLICK exported, for ladder without a nicknames.csv")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
    add("--output-format", choices=("text", "json"), default="text", help="text or json")
    add("-q", "--quiet", action="store_true", help="the summary alone")


def run(options: argparse.Namespace) -> int:
    """Compare two sides and show the difference; returns the exit code."""

    def settings_of(program: str) -> Settings:
        [job] = jobs([program], options.nicknames, config=options.config)
        return job.settings

    wanted = Wanted(settings_of, options.nicknames, options.export, options.config)
    pairs = pairs_of(options.one, options.other, settings_of_folder(options.config))
    if len(pairs) > 1 and options.output_format == "json":
        raise CouldNotRun("the settings name several programs, and JSON is told of one: name it, such as HEAD:prog.py")
    codes: list[int] = []
    for one, other in pairs:
        if codes and options.output_format == "text":
            print()
        codes.append(_compare(one, other, wanted, options))
    return max(codes)


def _compare(one: str, other: str, wanted: Wanted, options: argparse.Namespace) -> int:
    try:
        with TemporaryDirectory(prefix="clickgen-") as first, TemporaryDirectory(prefix="clickgen-") as second:
            older = read_side(one, wanted, Path(first), complain)
            newer = read_side(other, replace(wanted, placed=older.placed), Path(second), complain)
    except BrokenProgram as error:
        write_problems(error.problems, error.sources, sys.stderr)
        found = counts(problem.severity for problem in error.problems)
        complain(f"{error.shown} has {found}; there is nothing to compare")
        return COULD_NOT_RUN
    difference = diff(older, newer)
    names = name_changes(older, newer)
    if options.output_format == "json":
        from clickgen.commands.diff.as_json import render

        sys.stdout.write(render(difference, names))
    else:
        lines = (Line(" ", line) for line in summary(difference, names)) if options.quiet else report(difference, names)
        color = use_color(sys.stdout)
        sys.stdout.write("".join(f"{_painted(line) if color else escaped(line.text)}\n" for line in lines))
    return PROBLEMS if difference.differs else OK


def _painted(line: Line) -> str:
    style = _COLORS.get(line.mark)
    return f"\x1b[{style}m{escaped(line.text)}\x1b[0m" if style else escaped(line.text)
