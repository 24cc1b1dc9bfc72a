"""sources.json: which source lines each CLICK rung comes from, and what each scratch address is for."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from functools import cache

from clickgen.lower.split import ClickRoutine
from clickgen.table.rows import Row
from clickgen.text.wording import json_text

FORMAT = 1
"""The version of the file's form."""


def source_map(routines: Iterable[ClickRoutine], scratch: Iterable[Row], files: Iterable[str], base: str) -> str:
    """The map as JSON text with one rung on a line, so that it diffs well. Rungs count from 1 in each routine.

    ``files`` are the outputs of this build, by which the next one knows what it may replace. Source files are named
    relative to ``base``, the folder of the program.
    """
    rows = []
    for routine in routines:
        rungs = [
            json_text(
                {
                    "rung": number,
                    "file": _relative(rung.span.path, base),
                    "lines": [rung.span.line, rung.span.end_line],
                }
            )
            for number, rung in enumerate(routine.rungs, 1)
        ]
        rows.append(f"    {json.dumps(routine.name)}: [\n      " + ",\n      ".join(rungs) + "\n    ]")
    reasons = [
        "    " + json.dumps({"address": str(row.address), "nickname": row.nickname, "reason": row.comment})
        for row in sorted(scratch, key=lambda row: row.address.sort_key)
    ]
    parts = [
        f'  "format": {FORMAT}',
        '  "generator": "clickgen"',
        f'  "files": {json.dumps(list(files))}',
        '  "routines": {\n' + ",\n".join(rows) + "\n  }",
        '  "scratch": [' + ("\n" + ",\n".join(reasons) + "\n  ]" if reasons else "]"),
    ]
    return "{\n" + ",\n".join(parts) + "\n}\n"


@cache
def _relative(path: str, base: str) -> str:
    """The same for every way to name the program, and with forward slashes on Windows too."""
    return os.path.relpath(path, base or ".").replace(os.sep, "/")
