"""The commands and their arguments, which each command's own file names."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from types import ModuleType
from typing import NoReturn

from clickgen import __version__
from clickgen.cli import begin
from clickgen.text.wording import escaped

COMMANDS = {
    "build": ("clickgen.cli.build", "build a program into what CLICK takes in"),
    "check": ("clickgen.cli.check", "find mistakes, and logic worth a second look"),
    "nicknames": ("clickgen.cli.nicknames", "keep the address table: sync, check, merge, rename, why"),
    "import": ("clickgen.cli.import_", "bring an existing CLICK project in"),
    "diff": ("clickgen.cli.diff", "compare two programs, bundles or revisions rung by rung"),
    "workbook": ("clickgen.cli.workbook", "write the project as an Excel workbook"),
    "stubs": ("clickgen.cli.stubs", "write what editors complete and check programs with"),
    "rules": ("clickgen.cli.rules", "list every code"),
    "explain": ("clickgen.cli.explain", "say what a code, an instruction or a word means"),
}
"""Each command's module and its purpose, in the order of the help."""

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
  clickgen explain ton                what an instruction takes
"""


class _Help(argparse.RawDescriptionHelpFormatter):
    """Help as wide as the terminal. argparse asks shutil for the width, which loads every compressor first."""

    def __init__(self, prog: str) -> None:
        try:
            width = int(os.environ.get("COLUMNS") or os.get_terminal_size().columns)
        except (OSError, ValueError):
            width = 80
        super().__init__(prog, width=max(width, 40) - 2)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        """Keeps examples unchanged and wraps a description."""
        if "\n" in text:
            return super()._fill_text(text, width, indent)
        return argparse.HelpFormatter._fill_text(self, text, width, indent)


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        self.exit(2, f"clickgen: {escaped(message)}{_hint(message, self)}\nsee {self.prog} --help\n")


def _hint(message: str, parser: argparse.ArgumentParser) -> str:
    """``did you mean --frozen?`` for a slip in a flag or a command."""
    from clickgen.problems.diagnostics import did_you_mean

    words = message.replace("'", " ").replace(":", " ").split()
    known = [option for action in parser._actions for option in (*action.option_strings, *(action.choices or ()))]
    # These name flags that are spelled correctly.
    if "are required" in message or "expected" in message:
        return ""
    for word in words:
        if word not in known and (word.startswith("-") or "invalid choice" in message):
            near = did_you_mean(word, [option for option in known if option.startswith("-") == word.startswith("-")])
            if near:
                return f"; {near}"
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
    # Only the requested command is loaded: the others would take longer than a check from the cache.
    wanted = arguments[0] if arguments else ""
    for name, (module, purpose) in COMMANDS.items():
        if name == wanted:
            _add(commands, name, purpose, import_module(module))
        elif wanted not in COMMANDS:
            commands.add_parser(name, help=purpose)
    options, rest = parser.parse_known_args(arguments)
    run: Callable[[argparse.Namespace], int] | None = getattr(options, "run", None)
    if rest:
        commands.choices.get(options.command, parser).error(f"unknown argument {rest[0]}")
    if run is None:
        parser.print_help(sys.stderr)
        return 2
    begin()
    return run(options)


def _add(commands: argparse._SubParsersAction[_Parser], name: str, purpose: str, module: ModuleType) -> None:
    """Set up a command by its module: ``DESCRIPTION``, ``EXAMPLES``, ``add_arguments`` and ``run``."""
    command = commands.add_parser(
        name,
        help=purpose,
        description=module.DESCRIPTION,
        epilog=module.EXAMPLES,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    module.add_arguments(command)
    command.set_defaults(run=module.run)
