"""The command line: one file per command, thin; each parses its arguments, calls the API and renders."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

OK, PROBLEMS, COULD_NOT_RUN = 0, 1, 2
"""Exit codes: done; problems in the program; there was nothing to judge (no such file, bad flag, unreadable table)."""

TRACEBACK = "CLICKGEN_TRACEBACK"
"""The environment variable that lets an internal error through, for those who mend it."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code. Never a traceback: what is unforeseen asks to be reported."""
    from clickgen.cli.parser import parse

    _speak_utf8()
    try:
        return parse(sys.argv[1:] if arguments is None else arguments)
    except KeyboardInterrupt:
        print("clickgen: interrupted; nothing was written", file=sys.stderr)
        return 130
    except BrokenPipeError:
        # The reader of our output went away, as head does.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COULD_NOT_RUN
    except Exception as error:
        if os.environ.get(TRACEBACK):
            raise
        print(
            f"clickgen: internal error: {type(error).__name__}: {error}\n"
            f"This is a fault of clickgen, not of your program. Please report it with the program; {TRACEBACK}=1 shows "
            "where it happened.",
            file=sys.stderr,
        )
        return COULD_NOT_RUN


def _speak_utf8() -> None:
    """Output that a Windows console's code page cannot show is replaced, not an error."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure:
            reconfigure(errors="backslashreplace")
