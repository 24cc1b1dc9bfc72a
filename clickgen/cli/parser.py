"""The arguments of every command."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from typing import NoReturn

from clickgen import __version__
from clickgen.formats import FORMATS

_EXAMPLES = """\
examples:
  clickgen build prog.py              build into build/prog/
  clickgen build prog.py -o out       build into out/
  clickgen build prog.py --frozen     in CI: fail where the address table lacks a name
  clickgen check                      find mistakes, and logic worth a second look
  clickgen diff HEAD:prog.py prog.py  what changed, rung by rung
  clickgen workbook prog.py           the project as an Excel workbook
  clickgen import plant/ -o plant.py  an existing CLICK project as a program
  clickgen stubs                      what editors complete and check programs with
  clickgen explain CG501              what a code means and what to do
"""
_CHECK_EXAMPLES = """\
examples:
  clickgen check                      check the configured programs, else what is below the working folder
  clickgen check plc.py --fix         mend what can be mended without changing what the program does
  clickgen check --diff               show what --fix would change
  clickgen check --select ALL --ignore CG504,CG505
  clickgen check --output-format github --deny-warnings
  cat plc.py | clickgen check - --stdin-filename plc.py

exit codes: 0 nothing to say, or notes only; 1 findings; 2 could not run
"""
_BUILD_EXAMPLES = """\
examples:
  clickgen build prog.py
  clickgen build prog.py -o out --nicknames plant/nicknames.csv
  clickgen build prog.py --frozen
  clickgen build                      every program that the settings name

exit codes: 0 built; 1 problems in the program; 2 could not run
"""


_DIFF_EXAMPLES = """\
examples:
  clickgen diff HEAD:prog.py prog.py          what changed since the last commit
  clickgen diff main:prog.py feature:prog.py  two branches
  clickgen diff prog.py build/prog            is the bundle what the program says?
  clickgen diff prog.py from-the-plc/         is what CLICK holds what is in git?
  clickgen diff prog.py Scr1.tmp -q           the summary alone

A side is a program, a bundle folder, a ladder CSV, a capture of the clipboard, a program file of CLICK (Scr*.tmp), or
one of these in a revision of git: REV:PATH from the repository's root, REV:./PATH from the working folder, :PATH in the
index. A path that exists wins.

exit codes: 0 no difference in logic; 1 logic differs; 2 could not run
"""


_WORKBOOK_EXAMPLES = """\
examples:
  clickgen workbook prog.py                     build/prog/prog.xlsx
  clickgen workbook prog.py -o project.xlsx

exit codes: 0 written; 1 problems in the program; 2 could not run
"""


_STUBS_EXAMPLES = """\
examples:
  clickgen stubs                      for every program that the settings name
  clickgen stubs prog.py
  clickgen stubs --check              in CI: fail where a stub file is stale

exit codes: 0 written, or nothing to do; 1 stale; 2 could not run
"""


_NICKNAMES_EXAMPLES = """\
examples:
  clickgen nicknames sync prog.py           give every name an address
  clickgen nicknames sync --prune           and remove names that clickgen placed and nothing uses
  clickgen nicknames check                  in CI: table and programs agree
  clickgen nicknames merge export.csv       what CLICK says otherwise; new names are taken in
  clickgen nicknames merge export.csv --accept renamed,changed
  clickgen nicknames rename Pump Pump1      in the table and in every program
  clickgen nicknames why Pump               where its address comes from

exit codes: 0 done; 1 problems, or differences that were not taken in; 2 could not run
"""


_IMPORT_EXAMPLES = """\
examples:
  clickgen import plant/ -o plant.py            a folder with main.csv, subroutines/*.csv, nicknames.csv
  clickgen import plant/ -o program/            one file for each subroutine
  clickgen import main.csv -o main.py --nicknames export.csv
  clickgen import copied.bin -o -               rungs from the clipboard, to the terminal
  clickgen import Temp/ -o plant.py             CLICK's own Scr*.tmp files

exit codes: 0 imported, every rung verified; 1 something cannot be kept; 2 could not run
"""


class _Help(argparse.RawDescriptionHelpFormatter):
    """Help as wide as the terminal. argparse asks shutil for the width, which loads every compressor first."""

    def __init__(self, prog: str) -> None:
        try:
            width = int(os.environ.get("COLUMNS") or os.get_terminal_size().columns)
        except (OSError, ValueError):
            width = 80
        super().__init__(prog, width=max(width, 40) - 2)


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        self.exit(2, f"clickgen: {message}{_hint(message, self)}\nsee {self.prog} --help\n")


def _hint(message: str, parser: argparse.ArgumentParser) -> str:
    """``did you mean --frozen?`` for a near miss of a flag or a command."""
    import difflib

    words = message.replace("'", " ").replace(":", " ").split()
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
        formatter_class=_Help,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"clickgen {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", dest="command", parser_class=_Parser)
    # To set up the arguments of every command takes longer than a check out of the cache.
    wanted = [arguments[0]] if arguments and arguments[0] in _COMMANDS else list(_COMMANDS)
    for command in wanted:
        _COMMANDS[command](commands)
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
        formatter_class=_Help,
        allow_abbrev=False,
    )
    build.add_argument("program", metavar="PROG.py", nargs="?", help="the program (default: every configured one)")
    build.add_argument("-o", "--output", metavar="DIR", help="the output folder (default: build/<program>/)")
    build.add_argument(
        "--nicknames",
        metavar="TABLE",
        help="the address table, or a workbook with lists of addresses (default: nicknames.csv beside the program)",
    )
    build.add_argument("--frozen", action="store_true", help="choose no address; fail where one is missing")
    build.add_argument("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
    build.set_defaults(run=_run_build)


def _add_check(commands: argparse._SubParsersAction[_Parser]) -> None:
    check = commands.add_parser(
        "check",
        help="find mistakes, and logic worth a second look",
        description="Check programs: the problems that a build would have, and rules about logic. Nothing is written "
        "unless asked for.",
        epilog=_CHECK_EXAMPLES,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    add = check.add_argument
    add("paths", metavar="PATH", nargs="*", help="files and folders; - is the standard input")
    mend = check.add_argument_group("mending")
    mend.add_argument("--fix", action="store_true", help="apply the safe fixes")
    mend.add_argument("--unsafe-fixes", action="store_true", help="with --fix: also those that could change meaning")
    mend.add_argument("--diff", action="store_true", help="show what fixes would change, and change nothing")
    mend.add_argument("--add-ignore", action="store_true", help="silence every warning by a comment where it stands")
    choose = check.add_argument_group("choosing")
    for flag, what in (
        ("--select", "only these codes or groups of codes, such as CG5 or ALL"),
        ("--extend-select", "these beside those that are on"),
        ("--ignore", "not these; the most specific wins"),
    ):
        choose.add_argument(flag, metavar="CODES", action="append", type=_codes, default=None, help=what)
    choose.add_argument("--exclude", metavar="PATTERN", action="append", default=[], help="leave these paths out")
    choose.add_argument(
        "--force-exclude", action="store_true", help="leave them out also when named, and other Python too"
    )
    choose.add_argument("--baseline", metavar="FILE", help="show only what is new since FILE was made; makes it if new")
    tell = check.add_argument_group("telling")
    tell.add_argument("--output-format", metavar="FORMAT", default="text", help=f"one of {', '.join(FORMATS)}")
    tell.add_argument("-o", "--output", metavar="FILE", help="write the report into FILE")
    tell.add_argument("--statistics", action="store_true", help="count the findings of each code")
    tell.add_argument("-q", "--quiet", action="store_true", help="findings only, no summary")
    tell.add_argument("--exit-zero", action="store_true", help="exit with 0 whatever is found")
    tell.add_argument("--deny-warnings", action="store_true", help="warnings and notes are errors")
    add("--stdin-filename", metavar="FILE", help="the name of what comes from the standard input")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
    add("--no-cache", action="store_true", help="judge everything anew")
    check.set_defaults(run=_run_check)


def _codes(text: str) -> list[str]:
    from clickgen.config import code_prefix

    try:
        return [code_prefix(word.strip()) for word in text.split(",") if word.strip()]
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _run_check(options: argparse.Namespace) -> int:
    from clickgen.cli.check import run

    return run(options)


def _add_nicknames(commands: argparse._SubParsersAction[_Parser]) -> None:
    nicknames = commands.add_parser(
        "nicknames",
        help="keep the address table: sync, check, merge, rename, why",
        description="What concerns the address table that the PLC, the panel and the programs share.",
        epilog=_NICKNAMES_EXAMPLES,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    nicknames.set_defaults(run=_run_nicknames)
    actions = nicknames.add_subparsers(
        title="commands", metavar="COMMAND", dest="action", required=True, parser_class=_Parser
    )

    def action(name: str, help: str, description: str) -> Callable[..., argparse.Action]:
        parser = actions.add_parser(name, help=help, description=description, formatter_class=_Help, allow_abbrev=False)
        parser.add_argument("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
        parser.add_argument("--nicknames", metavar="TABLE", help="the address table")
        return parser.add_argument

    programs = {"metavar": "PROG.py", "nargs": "*", "help": "the programs (default: every configured one)"}
    add = action(
        "sync",
        "give every name an address",
        "Give every name of the programs an address, and name what no program uses. Nothing is dropped.",
    )
    add("programs", **programs)
    add("--prune", action="store_true", help="remove names that clickgen placed and nothing uses any more")
    add("--dry-run", action="store_true", help="say what would be done, and write nothing")
    add = action(
        "check",
        "whether table and programs agree",
        "Check the address table and the names of the programs, without writing anything: for CI.",
    )
    add("programs", **programs)
    add = action(
        "merge",
        "take in a fresh export from CLICK",
        "Show what an export from CLICK says otherwise than the address table, and take in what is new. All else is "
        "taken in only when it is asked for.",
    )
    add("export", metavar="EXPORT.csv", help="the nickname CSV that CLICK wrote")
    add(
        "--accept",
        metavar="KINDS",
        action="append",
        default=[],
        help="take these in too: renamed, moved, removed, changed, all; swapped only by its own name",
    )
    add("--dry-run", action="store_true", help="show the differences, and write nothing")
    add = action(
        "rename",
        "rename in the table and in every source file",
        "Rename a nickname in the address table and in every program that uses the table, all or nothing. The ladder "
        "stays the same, which is tried before anything is written.",
    )
    add("old", metavar="OLD", help="the nickname as it is")
    add("new", metavar="NEW", help="the nickname as it should be")
    add("programs", **programs)
    add("--dry-run", action="store_true", help="say what would be renamed, and write nothing")
    add = action(
        "why",
        "where the address of a name comes from",
        "Say where the address of a name comes from, why it is that one, and where the name is used.",
    )
    add("name", metavar="NAME", help="a nickname, a block, or an address such as DS5")
    add("programs", **programs)


def _run_nicknames(options: argparse.Namespace) -> int:
    from clickgen.cli.nicknames import run

    return run(options)


def _add_workbook(commands: argparse._SubParsersAction[_Parser]) -> None:
    workbook = commands.add_parser(
        "workbook",
        help="write the project as an Excel workbook",
        description="Write a workbook for people: the I/O list, the tags, the cross-reference, timers, memory and "
        "rungs. The address table is read and not changed.",
        epilog=_WORKBOOK_EXAMPLES,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    add = workbook.add_argument
    add("program", metavar="PROG.py", help="the program")
    add("-o", "--output", metavar="FILE.xlsx", help="the workbook (default: build/<program>/<program>.xlsx)")
    add("--nicknames", metavar="TABLE", help="the address table (default: nicknames.csv beside the program)")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
    workbook.set_defaults(run=_run_workbook)


def _run_workbook(options: argparse.Namespace) -> int:
    from clickgen.cli.workbook import run

    return run(options.program, options.output, options.nicknames, options.config)


def _add_diff(commands: argparse._SubParsersAction[_Parser]) -> None:
    diff = commands.add_parser(
        "diff",
        help="compare two programs, bundles or revisions rung by rung",
        description="Show which rungs were added, removed, moved or changed, in the words of the listing. Comments, "
        "nicknames and how a rung is drawn are no logic. Nothing is written.",
        epilog=_DIFF_EXAMPLES,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    add = diff.add_argument
    add("one", metavar="OLD", help="the older side")
    add("other", metavar="NEW", help="the newer side")
    add("--nicknames", metavar="TABLE", help="the address table of programs (default: nicknames.csv beside each)")
    add("--export", metavar="EXPORT.csv", help="the nicknames that CLICK exported, for ladder without a nicknames.csv")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
    add("--output-format", choices=("text", "json"), default="text", help="text or json")
    add("-q", "--quiet", action="store_true", help="the summary alone")
    diff.set_defaults(run=_run_diff)


def _run_diff(options: argparse.Namespace) -> int:
    from clickgen.cli.diff import run

    return run(options)


def _add_stubs(commands: argparse._SubParsersAction[_Parser]) -> None:
    stubs = commands.add_parser(
        "stubs",
        help="write what editors complete and check programs with",
        description="Write __builtins__.pyi beside programs: the language and their nicknames, for editors with "
        "pyright in them.",
        epilog=_STUBS_EXAMPLES,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    add = stubs.add_argument
    add("programs", metavar="PROG.py", nargs="*", help="the programs (default: every configured one)")
    add("--nicknames", metavar="TABLE", help="the address table (default: nicknames.csv beside the program)")
    add("--frozen", action="store_true", help="only names that have an address: a new one may be a misspelling")
    add("--check", action="store_true", help="write nothing; fail where a file is stale")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
    stubs.set_defaults(run=_run_stubs)


def _run_stubs(options: argparse.Namespace) -> int:
    from clickgen.cli.stubs import run

    return run(options.programs, options.nicknames, options.frozen, options.check, options.config)


def _add_rules(commands: argparse._SubParsersAction[_Parser]) -> None:
    rules = commands.add_parser(
        "rules",
        help="list every code",
        description="Every code with its severity and title.",
        formatter_class=_Help,
        allow_abbrev=False,
    )
    rules.add_argument("--output-format", choices=("text", "json"), default="text", help="text or json")
    rules.set_defaults(run=_run_rules)


def _run_rules(options: argparse.Namespace) -> int:
    from clickgen.cli.rules import run

    return run(options.output_format)


def _add_explain(commands: argparse._SubParsersAction[_Parser]) -> None:
    explain = commands.add_parser(
        "explain",
        help="say what a code means",
        description="What a code means and what to do.",
        formatter_class=_Help,
        allow_abbrev=False,
    )
    explain.add_argument("code", metavar="CODE", help="such as CG501")
    explain.set_defaults(run=_run_explain)


def _run_explain(options: argparse.Namespace) -> int:
    from clickgen.cli.explain import run

    return run(options.code)


def _add_import(commands: argparse._SubParsersAction[_Parser]) -> None:
    imports = commands.add_parser(
        "import",
        help="bring an existing CLICK project in",
        description="Write an existing CLICK project as a program, build that in memory, and compare rung by rung. "
        "What cannot be kept exactly stops the import.",
        epilog=_IMPORT_EXAMPLES,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    add = imports.add_argument
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
    imports.set_defaults(run=_run_import)


def _run_import(options: argparse.Namespace) -> int:
    from clickgen.cli.import_ import run

    return run(options)


def _run_build(options: argparse.Namespace) -> int:
    from clickgen.cli.build import run

    return run(options.program, options.output, options.nicknames, options.frozen, options.config)


_COMMANDS: dict[str, Callable[[argparse._SubParsersAction[_Parser]], None]] = {
    "build": _add_build,
    "check": _add_check,
    "nicknames": _add_nicknames,
    "diff": _add_diff,
    "workbook": _add_workbook,
    "stubs": _add_stubs,
    "import": _add_import,
    "rules": _add_rules,
    "explain": _add_explain,
}
"""What sets up the arguments of each command, in the order of the help."""
