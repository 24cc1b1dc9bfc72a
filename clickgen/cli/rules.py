"""``clickgen rules``: every code with its severity and title."""

from __future__ import annotations

import argparse

from clickgen.cli import OK
from clickgen.problems.codes import CODES

DESCRIPTION = "Every code with its severity and title."
EXAMPLES = ""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--output-format", choices=("text", "json"), default="text", help="text or json")


def run(options: argparse.Namespace) -> int:
    """Print the list; return the exit code."""
    if options.output_format == "json":
        import json

        rows = [
            {"code": name, "severity": code.severity.value, "title": code.title, "on": code.is_on}
            for name, code in CODES.items()
        ]
        print(json.dumps(rows, indent=2))
        return OK
    for name, code in CODES.items():
        print(f"{name}  {code.severity.value:<7}  {code.title}{'' if code.is_on else ' (off by default)'}")
    return OK
