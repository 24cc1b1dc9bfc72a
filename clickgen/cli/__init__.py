"""The command line: one file per command, thin; each parses its arguments, calls the API and renders."""

from __future__ import annotations

import contextlib
import gc
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

OK, PROBLEMS, COULD_NOT_RUN = 0, 1, 2
"""Exit codes: done; problems in the program; there was nothing to judge (no such file, bad flag, unreadable table)."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code. Never a traceback: what is unforeseen asks to be reported."""
    from clickgen.cli.parser import parse

    _speak_utf8()
    try:
        return parse(sys.argv[1:] if arguments is None else arguments)
    except KeyboardInterrupt:
        return _interrupted()
    except BrokenPipeError:
        # The reader of our output went away, as head does.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COULD_NOT_RUN
    except Exception as error:
        if isinstance(error.__cause__, KeyboardInterrupt):  # Python wraps one that comes while a class is made.
            return _interrupted()
        from clickgen.diagnostics import TRACEBACK

        reason = _reason(error)
        if reason is None and os.environ.get(TRACEBACK):
            raise
        complain(
            reason
            or f"internal error: {type(error).__name__}: {error}\n"
            f"This is a fault of clickgen, not of your program. Please report it with the program; {TRACEBACK}=1 shows "
            "where it happened."
        )
        return COULD_NOT_RUN


def complain(text: str) -> None:
    """Say what is in the way, on the standard error."""
    from clickgen.report.frames import printable

    print(f"clickgen: {printable(text)}", file=sys.stderr)


def _reason(error: Exception) -> str | None:
    """What kept a command from running; None for a fault of clickgen."""
    from clickgen.diagnostics import CouldNotRun

    if isinstance(error, CouldNotRun):
        return str(error)
    if isinstance(error, OSError):
        # Without a file it is the terminal or a pipe: then the files may be in place already.
        if not error.filename:
            return f"the output could not be shown: {error.strerror or error}"
        return f"{error.filename}: {error.strerror or error}; nothing was written"
    return None


def _interrupted() -> int:
    print("clickgen: interrupted; nothing was written", file=sys.stderr)
    return 130


def run() -> NoReturn:
    """The command as a process of its own: run it and end.

    A build makes hundreds of thousands of objects and few cycles. Collecting them in between, and taking all of them
    apart at the end, costs a fifth of the time; the system takes the memory back anyway.
    """
    gc.disable()
    for name in ("stdout", "stderr"):
        # Closed by who called us, as >&- does. What stands in for it stays open until the process ends.
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
    try:
        code = main()
    except SystemExit as stop:
        code = stop.code if isinstance(stop.code, int) else COULD_NOT_RUN
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError):
            stream.flush()
    os._exit(code)


def _speak_utf8() -> None:
    """Output that a Windows console's code page cannot show is replaced, not an error."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure:
            reconfigure(errors="backslashreplace")
