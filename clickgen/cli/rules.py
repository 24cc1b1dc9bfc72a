"""``clickgen rules``: every code with its severity and title."""

from __future__ import annotations

from clickgen.cli import OK
from clickgen.codes import CODES


def run(output_format: str) -> int:
    """Print the list; returns the exit code."""
    if output_format == "json":
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
