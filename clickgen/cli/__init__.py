"""The command line: one file per command, thin; each parses its arguments, calls the API and renders."""

from __future__ import annotations

import contextlib
import errno
import gc
import io
import os
import signal
import sys
from collections.abc import Callable, Sequence

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn, TextIO

    from typing_extensions import Buffer

OK, PROBLEMS, COULD_NOT_RUN = 0, 1, 2
"""Exit codes: done; problems in the program; nothing to judge (no such file, bad flag, unreadable table)."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code. Never a traceback: an unforeseen error asks to be reported."""
    try:
        from clickgen.cli.parser import parse

        _speak_utf8()
        _written().clear()
        given = sys.argv[1:] if arguments is None else arguments
        if any("\0" in argument for argument in given):
            # No system passes one; a caller of this function may.
            complain("an argument holds a NUL character, which no file name can have")
            return COULD_NOT_RUN
        code = parse(given)
        sys.stdout.flush()  # Output that cannot be shown is an error only while that can be reported.
        return code
    except KeyboardInterrupt as stop:
        return _stopped(stop)
    except BrokenPipeError:
        # The reader of our output went away, as head does.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COULD_NOT_RUN
    except Exception as error:
        if isinstance(error.__cause__, KeyboardInterrupt):  # Python wraps one that comes while a class is made.
            return _stopped(error.__cause__)
        from clickgen.problems.diagnostics import TRACEBACK

        reason = _reason(error)
        if reason is None and os.environ.get(TRACEBACK):
            raise
        complain(
            *(
                reason
                or (
                    f"internal error: {type(error).__name__}: {error}",
                    "This is a fault of clickgen, not of your program. Please report it with the program; "
                    f"{TRACEBACK}=1 shows where it happened.",
                )
            )
        )
        return COULD_NOT_RUN


def tell(*lines: str, file: TextIO | None = None) -> None:
    """Print lines, on the standard output by default. Each stays one line, whatever names are in it."""
    from clickgen.text.wording import escaped

    for line in lines:
        print(escaped(line), file=file)


def complain(*lines: str) -> None:
    """Report what is in the way, on the standard error, if anybody can hear it."""
    with contextlib.suppress(OSError, ValueError):
        tell(f"clickgen: {lines[0]}", *lines[1:], file=sys.stderr)


def _reason(error: Exception) -> tuple[str, ...] | None:
    """The error that kept a command from running; None for a fault of clickgen."""
    from clickgen.workspace import CouldNotRun

    if isinstance(error, CouldNotRun):
        return error.lines
    if isinstance(error, OSError):
        # Without a file it is the terminal or a pipe: then the files may be in place already.
        if not error.filename and isinstance(error, FileNotFoundError):
            return (f"the working folder is not there any more; {_what_was_written()}",)
        if not error.filename:
            return (f"the output could not be shown: {error.strerror or error}",)
        return (f"{os.fsdecode(error.filename)}: {error.strerror or error}; {_what_was_written()}",)
    return None


_NAMED_MAX = 5


def _what_was_written() -> str:
    """The work that a command has done before it was stopped."""
    written = _written()
    if not written:
        return "nothing was written"
    more = f" and {len(written) - _NAMED_MAX} more" if len(written) > _NAMED_MAX else ""
    return f"already written: {', '.join(map(str, written[:_NAMED_MAX]))}{more}"


def _written() -> list[object]:
    """The files that this command has put in place, if it has loaded the module that does that."""
    found: list[object] = getattr(sys.modules.get("clickgen.text.write"), "written", [])
    return found


# -- being stopped ----------------------------------------------------------------------------------------------------


class Stopped(KeyboardInterrupt):
    """A signal that ends the command."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


def _stopped(stop: KeyboardInterrupt) -> int:
    number = stop.number if isinstance(stop, Stopped) else signal.SIGINT
    complain(f"{'interrupted' if number == signal.SIGINT else 'terminated'}; {_what_was_written()}")
    return 128 + number


class _Signals:
    """Ctrl-C and SIGTERM in a process of our own."""

    def __init__(self) -> None:
        self._is_running = False
        self._is_stopping = False

    def take(self) -> None:
        for number in (signal.SIGINT, signal.SIGTERM):
            # A shell that starts a command in the background may want it to ignore them.
            if signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, self._stop)
        sys.unraisablehook = self._unraisable

    def begin(self) -> None:
        """Mark the command as loaded: from here on a signal is an exception, so that files can be put back."""
        self._is_running = True

    def _stop(self, number: int, _: object) -> None:
        if not self._is_running or self._is_stopping:
            # Nothing is at stake yet, or somebody is in a hurry; an exception while modules load shows its traceback.
            self._leave(number)
        self._is_stopping = True
        raise Stopped(number)

    def _leave(self, number: int) -> NoReturn:
        if not self._is_stopping:
            _stopped(Stopped(number))
        os._exit(128 + number)

    def _unraisable(self, fault: sys.UnraisableHookArgs) -> None:
        """Handle an exception where Python lets none through, such as a callback of the garbage collector."""
        if isinstance(fault.exc_value, KeyboardInterrupt):
            self._is_stopping = False
            self._leave(fault.exc_value.number if isinstance(fault.exc_value, Stopped) else signal.SIGINT)
        sys.__unraisablehook__(fault)


_signals = _Signals()
begin = _signals.begin


# -- a process of its own ---------------------------------------------------------------------------------------------


def run() -> NoReturn:
    """Run the command as a process of its own, and end.

    A build makes hundreds of thousands of objects and few cycles. Collecting them in between, and taking all of them
    apart at the end, costs a fifth of the time; the system takes the memory back anyway.
    """
    _signals.take()
    gc.disable()
    for name in ("stdout", "stderr"):
        # Closed by the caller, as >&- does. Its replacement stays open until the process ends.
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
    _let_readers_go()
    try:
        code = main()
    except SystemExit as stop:
        code = stop.code if isinstance(stop.code, int) else COULD_NOT_RUN
    except KeyboardInterrupt as stop:  # A second one.
        code = 128 + (stop.number if isinstance(stop, Stopped) else signal.SIGINT)
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError, KeyboardInterrupt):
            stream.flush()
    os._exit(code)


class _Output(io.RawIOBase):
    """A standard stream that accepts output even when nobody reads it any more: the work is done in any case."""

    def __init__(self, stream: TextIO, raw: io.RawIOBase, forgives: Callable[[OSError], bool]) -> None:
        self._stream = stream  # It closes what is below it when nobody holds it.
        self._raw = raw
        self._forgives = forgives

    def write(self, data: Buffer) -> int | None:
        try:
            return self._raw.write(data)
        except OSError as error:
            if not self._forgives(error):
                raise
            return memoryview(data).nbytes

    def writable(self) -> bool:
        return True

    def fileno(self) -> int:
        return self._raw.fileno()

    def isatty(self) -> bool:
        return self._raw.isatty()


def _is_gone(error: OSError) -> bool:
    """True if the reader of a pipe went away, as head does; Windows has no error of its own for it."""
    return isinstance(error, BrokenPipeError) or (os.name == "nt" and error.errno == errno.EINVAL)


def _let_readers_go() -> None:
    """Let no report that cannot be heard change the exit code.

    On the standard output that is one whose reader went away: a full disk is an error. If the standard error fails,
    nobody can be told.
    """
    for name, forgives in (("stdout", _is_gone), ("stderr", lambda _: True)):
        stream = getattr(sys, name)
        buffer = getattr(stream, "buffer", None)
        raw = getattr(buffer, "raw", buffer)
        if isinstance(raw, io.RawIOBase) and not stream.isatty():
            output = io.BufferedWriter(_Output(stream, raw, forgives))
            # With PYTHONUNBUFFERED there is no buffer.
            by_line = stream.line_buffering or raw is buffer
            text = io.TextIOWrapper(output, stream.encoding, stream.errors, line_buffering=by_line)
            setattr(sys, name, text)


def _speak_utf8() -> None:
    """Output that a Windows console's code page cannot show is replaced, not an error."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure:
            reconfigure(errors="backslashreplace")
