"""sources.json: which source lines each CLICK rung comes from, what each scratch address is for, what was written."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Mapping
from functools import cache

from clickgen.lower.split import ClickRoutine
from clickgen.settings import TABLE_NAME
from clickgen.table.rows import Row
from clickgen.text.wording import json_text

NAME = "sources.json"
FORMAT = 1
"""The version of the file's form."""


def is_ladder(name: str) -> bool:
    """True for an output that holds ladder, and so is in the way when the program has no such routine any more."""
    return name.endswith(".csv") and name != TABLE_NAME


def digest_of(ladder: bytes) -> str:
    """What tells one ladder file from another. Git may have changed the ends of its lines."""
    return hashlib.blake2b(ladder.replace(b"\r\n", b"\n"), digest_size=16).hexdigest()


def source_map(routines: Iterable[ClickRoutine], scratch: Iterable[Row], files: Mapping[str, str], base: str) -> str:
    """The map as JSON text with one rung on a line, so that it diffs well. Rungs count from 1 in each routine.

    ``files`` are the other outputs of this build, by which the next one knows what it may replace; ladder files have
    their digests, by which it knows what it may remove. Source files are named relative to ``base``, the folder of the
    program.
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
    digests = [
        f"    {json.dumps(name)}: {json.dumps(digest_of(text.encode()))}"
        for name, text in files.items()
        if is_ladder(name)
    ]
    parts = [
        f'  "format": {FORMAT}',
        '  "generator": "clickgen"',
        f'  "files": {json.dumps([*dict.fromkeys((*files, NAME))])}',
        '  "digests": {\n' + ",\n".join(digests) + "\n  }",
        '  "routines": {\n' + ",\n".join(rows) + "\n  }",
        '  "scratch": [' + ("\n" + ",\n".join(reasons) + "\n  ]" if reasons else "]"),
    ]
    return "{\n" + ",\n".join(parts) + "\n}\n"


@cache
def _relative(path: str, base: str) -> str:
    """The same for every way to name the program, and with forward slashes on Windows too."""
    return os.path.relpath(path, base or ".").replace(os.sep, "/")
