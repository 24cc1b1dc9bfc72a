"""sources.json: the source lines of each CLICK rung, the reason for each scratch address, what was written."""

from __future__ import annotations

import json
import os
from functools import cache

from clickgen.emit.built import BuiltProgram
from clickgen.emit.writer import digest_of, one_file
from clickgen.text.wording import json_text

PATH = "sources.json"
FORMAT = 1
"""The version of the file's form."""


def source_map(built: BuiltProgram) -> str:
    """The map as JSON text, with one rung on a line so that it diffs well. Rungs count from 1 in each routine.

    It names the outputs of this build, so that the next one knows what it may replace, and holds the digests of the
    ladder files, so that the next one knows what it may remove. Source files are named relative to the folder of the
    program.
    """
    rows = []
    for routine in built.routines:
        rungs = [
            json_text(
                {
                    "rung": number,
                    "file": _relative(rung.span.path, built.folder),
                    "lines": [rung.span.line, rung.span.end_line],
                }
            )
            for number, rung in enumerate(routine.rungs, 1)
        ]
        rows.append(f"    {json.dumps(routine.name)}: [\n      " + ",\n      ".join(rungs) + "\n    ]")
    reasons = [
        "    " + json.dumps({"address": str(row.address), "nickname": row.nickname, "reason": row.comment})
        for row in sorted(built.scratch, key=lambda row: row.address.sort_key)
    ]
    digests = [
        f"    {json.dumps(path)}: {json.dumps(digest_of(text.encode()))}" for path, text in built.ladder_texts.items()
    ]
    parts = [
        f'  "format": {FORMAT}',
        '  "generator": "clickgen"',
        f'  "files": {json.dumps(built.outputs)}',
        '  "digests": {\n' + ",\n".join(digests) + "\n  }",
        '  "routines": {\n' + ",\n".join(rows) + "\n  }",
        '  "scratch": [' + ("\n" + ",\n".join(reasons) + "\n  ]" if reasons else "]"),
    ]
    return "{\n" + ",\n".join(parts) + "\n}\n"


@cache
def _relative(path: str, folder: str) -> str:
    """The same for every way to name the program, and with forward slashes on Windows too."""
    return os.path.relpath(path, folder or ".").replace(os.sep, "/")


# folder.py asks for the owner's mark before it believes any other line of the map.
WRITER = one_file(PATH, source_map, lambda _: True, rank=90)
