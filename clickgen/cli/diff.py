"""``clickgen diff``: the differences between two programs, bundles or revisions."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from clickgen.cli import COULD_NOT_RUN, OK, PROBLEMS, complain
from clickgen.cli.jobs import Run
from clickgen.commands.diff.as_text import Line, report, summary
from clickgen.commands.diff.changes import Difference
from clickgen.commands.diff.names import name_changes
from clickgen.commands.diff.pairs import Pair, pairs_of
from clickgen.commands.diff.programs import diff
from clickgen.commands.diff.read import Wanted, absent_side, configured_in, read_side
from clickgen.commands.diff.sides import BrokenProgram
from clickgen.config import Settings
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
    """Compare two sides and show the difference; return the exit code."""
    this = Run(options.config)

    def settings_of(program: str) -> Settings:
        [job] = this.jobs([program], options.nicknames)
        return job.settings

    wanted = Wanted(settings_of, this.files, options.nicknames, options.export, options.config)

    def configured(revision: str) -> list[str]:
        with TemporaryDirectory(prefix="clickgen-") as folder:
            return configured_in(revision, wanted, Path(folder))

    pairs = pairs_of(options.one, options.other, this.settings, configured, this.files)
    compared: list[tuple[Pair, Difference | None]] = []
    for pair in pairs:
        if compared and options.output_format == "text":
            print()
        compared.append((pair, _compared(pair, wanted)))
        _show(*compared[-1], options)
    if options.output_format == "json":
        from clickgen.commands.diff.as_json import render

        sys.stdout.write(render(compared))
    return max(_code(difference) for _, difference in compared)


def _code(difference: Difference | None) -> int:
    return COULD_NOT_RUN if difference is None else PROBLEMS if difference.differs else OK


def _compared(pair: Pair, wanted: Wanted) -> Difference | None:
    """The difference of two sides; None if one of them has errors, which are reported."""
    try:
        with TemporaryDirectory(prefix="clickgen-") as first, TemporaryDirectory(prefix="clickgen-") as second:
            older = absent_side(pair.one) if pair.is_new else read_side(pair.one, wanted, Path(first), complain)
            placed = replace(wanted, placed=older.placed)
            newer = absent_side(pair.other) if pair.is_gone else read_side(pair.other, placed, Path(second), complain)
    except BrokenProgram as error:
        write_problems(error.problems, error.sources, sys.stderr)
        found = counts(problem.severity for problem in error.problems)
        complain(f"{error.shown} has {found}; there is nothing to compare")
        return None
    return diff(older, newer)


def _show(pair: Pair, difference: Difference | None, options: argparse.Namespace) -> None:
    """A difference for people."""
    if difference is not None and options.output_format == "text":
        names = name_changes(difference.one, difference.other)
        if pair.is_new or pair.is_gone:
            shown = difference.other.shown if pair.is_new else difference.one.shown
            why = difference.one.doubt if pair.is_new else difference.other.doubt
            print(escaped(f"{shown} {'is new' if pair.is_new else 'was removed'}: {why}"))
        lines = (Line(" ", line) for line in summary(difference, names)) if options.quiet else report(difference, names)
        color = use_color(sys.stdout)
        sys.stdout.write("".join(f"{_painted(line) if color else escaped(line.text)}\n" for line in lines))


def _painted(line: Line) -> str:
    style = _COLORS.get(line.mark)
    return f"\x1b[{style}m{escaped(line.text)}\x1b[0m" if style else escaped(line.text)
