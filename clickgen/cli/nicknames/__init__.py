"""``clickgen nicknames``: commands for the address table. Each subcommand is a module of its own."""

from __future__ import annotations

import argparse

from clickgen.cli.nicknames import check, merge, rename, sync, why

DESCRIPTION = "What concerns the address table that the PLC, the panel and the programs share."
EXAMPLES = """\
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


_COMMANDS = {"sync": sync, "check": check, "merge": merge, "rename": rename, "why": why}
"""In the order of the help."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    actions = parser.add_subparsers(title="commands", metavar="COMMAND", dest="action", required=True)
    for name, module in _COMMANDS.items():
        command = actions.add_parser(
            name,
            help=module.HELP,
            description=module.DESCRIPTION,
            formatter_class=parser.formatter_class,
            allow_abbrev=False,
        )
        command.add_argument("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
        command.add_argument("--nicknames", metavar="TABLE", help="the address table")
        module.add_arguments(command)


def run(options: argparse.Namespace) -> int:
    """Run one of the subcommands; return the exit code."""
    code: int = _COMMANDS[options.action].run(options)
    return code
