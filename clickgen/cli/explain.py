"""``clickgen explain CODE``: what a code means and what to do."""

from __future__ import annotations

import argparse

from clickgen.cli import COULD_NOT_RUN, OK, complain
from clickgen.codes import CODES
from clickgen.diagnostics import did_you_mean
from clickgen.explain import explanation, plain

DESCRIPTION = "What a code means and what to do."
EXAMPLES = ""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("code", metavar="CODE", help="such as CG501")


def run(options: argparse.Namespace) -> int:
    """Print the page of a code; returns the exit code."""
    name = options.code.upper()
    if name not in CODES:
        group = [known for known in CODES if known.startswith(name)]
        hint = f"it begins {', '.join(group)}" if group else did_you_mean(name, CODES) or "clickgen rules lists them"
        complain(f"there is no code {options.code}; {hint}")
        return COULD_NOT_RUN
    print(plain(explanation(name)), end="")
    return OK
