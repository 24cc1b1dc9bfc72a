"""The arguments of every command."""

from __future__ import annotations

import argparse
import difflib
import sys
from collections.abc import Callable, Sequence
from typing import NoReturn

from clickgen import __version__

_EXAMPLES = """\
examples:
  clickgen build prog.py              build into build/prog/
  clickgen build prog.py -o out       build into out/
  clickgen build prog.py --frozen     in CI: fail where the address table lacks a name
"""
_BUILD_EXAMPLES = """\
examples:
  clickgen build prog.py
  clickgen build prog.py -o out --nicknames plant/nicknames.csv
  clickgen build prog.py --frozen

exit codes: 0 built; 1 problems in the program; 2 could not run
"""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        self.exit(2, f"clickgen: {message}{_hint(message, self)}\nsee {self.prog} --help\n")


def _hint(message: str, parser: argparse.ArgumentParser) -> str:
    """``did you mean --frozen?`` for a near miss of a flag or a command."""
    words = message.replace("'", " ").split()
    known = [option for action in parser._actions for option in (*action.option_strings, *(action.choices or ()))]
    unknown = [word for word in words if word.startswith("-") or "invalid choice" in message]
    for word in unknown:
        close = difflib.get_close_matches(word, known, n=1, cutoff=0.6)
        if close and close[0] != word:
            return f"; did you mean {close[0]}?"
    return ""


def parse(arguments: Sequence[str]) -> int:
    """Run the command that the arguments name."""
    parser = _Parser(
        prog="clickgen",
        description="Ladder logic as text for AutomationDirect CLICK PLCs.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"clickgen {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", dest="command", parser_class=_Parser)
    _add_build(commands)
    options, rest = parser.parse_known_args(arguments)
    run: Callable[[argparse.Namespace], int] | None = getattr(options, "run", None)
    if rest:
        commands.choices.get(options.command, parser).error(f"unknown argument {rest[0]}")
    if run is None:
        parser.print_help(sys.stderr)
        return 2
    return run(options)


def _add_build(commands: argparse._SubParsersAction[_Parser]) -> None:
    build = commands.add_parser(
        "build",
        help="build a program into what CLICK takes in",
        description="Build a program: ladder CSV files, the nickname CSV, a listing and a source map.",
        epilog=_BUILD_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    build.add_argument("program", metavar="PROG.py", help="the program")
    build.add_argument("-o", "--output", metavar="DIR", help="the output folder (default: build/<program>/)")
    build.add_argument(
        "--nicknames", metavar="TABLE.csv", help="the address table (default: nicknames.csv beside the program)"
    )
    build.add_argument("--frozen", action="store_true", help="choose no address; fail where one is missing")
    build.set_defaults(run=_run_build)


def _run_build(options: argparse.Namespace) -> int:
    from clickgen.cli.build import run

    return run(options.program, options.output, options.nicknames, options.frozen)
