"""``clickgen check``: the report to the standard output, everything else to the standard error."""

from __future__ import annotations

import argparse
import os
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from clickgen.check.select import Selection
from clickgen.checking.run import Outcome, Request, add_ignores
from clickgen.checking.run import run as run_check
from clickgen.cli import COULD_NOT_RUN, OK, PROBLEMS
from clickgen.codes import CODES
from clickgen.config import Config, find_config, read_config
from clickgen.diagnostics import CouldNotRun, Diagnostic, did_you_mean
from clickgen.formats import FORMATS
from clickgen.report import Report, render, shown_path, use_color
from clickgen.wording import counted

_MANY_FILES = 8
"""From so many programs on a terminal shows how far the check is."""


class _Wrong(CouldNotRun):
    """Flags that do not go together; the message says which."""


def run(options: argparse.Namespace) -> int:
    """Check what the command line names; returns the exit code."""
    try:
        return _run(options)
    except CouldNotRun as error:
        _complain(str(error))
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        _complain(f"{place}{error.strerror or error}; nothing was written")
    return COULD_NOT_RUN


def _complain(text: str) -> None:
    from clickgen.report.frames import printable

    print(f"clickgen: {printable(text)}", file=sys.stderr)


def _run(options: argparse.Namespace) -> int:
    _refuse_contradictions(options)
    config = read_config(Path(options.config)) if options.config else find_config(Path.cwd())
    with _progress() as progress:
        request = _request(options, config, progress)
        outcome = run_check(request, options.fix or options.diff, options.unsafe_fixes)
    if options.diff:
        diff = "".join(_diffs(outcome))
        _put(diff, options.output)
        return PROBLEMS if diff and not options.exit_zero else OK
    if options.add_ignore:
        outcome = add_ignores(outcome)
    elif request.stdin is not None and options.fix:
        sys.stdout.write(outcome.after.get(request.paths[0], request.stdin).decode("utf-8"))
    if request.stdin is None:
        outcome.write()
    if options.add_ignore:
        print(f"{counted(outcome.fixed, 'finding')} silenced in {counted(len(outcome.after), 'file')}", file=sys.stderr)
        return OK
    return _tell(options, outcome, to_stderr=request.stdin is not None and options.fix)


def _refuse_contradictions(options: argparse.Namespace) -> None:
    if options.output_format not in FORMATS:
        near = did_you_mean(options.output_format, FORMATS) or f"the formats: {', '.join(FORMATS)}"
        raise _Wrong(f"there is no format {options.output_format!r}; {near}")
    if options.unsafe_fixes and not (options.fix or options.diff):
        raise _Wrong("--unsafe-fixes goes with --fix or --diff")
    if sum((options.fix, options.diff, options.add_ignore)) > 1:
        raise _Wrong("--fix, --diff and --add-ignore each do something else: give one of them")
    if "-" in options.paths and len(options.paths) > 1:
        raise _Wrong("- stands alone: the standard input is one program")
    if options.add_ignore and "-" in options.paths:
        raise _Wrong("--add-ignore needs a file to write to")


def _request(options: argparse.Namespace, config: Config, progress: Callable[[int, int], None]) -> Request:
    settings = config.check
    select = _joined(options.select)
    selection = Selection(
        settings.select if select is None else select,
        (*(settings.extend_select if select is None else ()), *(_joined(options.extend_select) or ())),
        (*(settings.ignore if select is None else ()), *(_joined(options.ignore) or ())),
    )
    paths = tuple(options.paths)
    stdin = sys.stdin.buffer.read() if paths == ("-",) else None
    if stdin is not None:
        paths = (options.stdin_filename or "stdin.py",)
    return Request(
        config, selection, paths, tuple(options.exclude), options.force_exclude, not options.no_cache, stdin, progress
    )


def _joined(lists: list[list[str]] | None) -> tuple[str, ...] | None:
    return None if lists is None else tuple(code for codes in lists for code in codes)


# -- telling ----------------------------------------------------------------------------------------------------------


def _tell(options: argparse.Namespace, outcome: Outcome, to_stderr: bool) -> int:
    findings = list(outcome.findings)
    skipped: dict[str, int] = {}
    if options.baseline:
        findings, skipped["in the baseline"] = _since(Path(options.baseline), findings, outcome)
    stream = sys.stderr if to_stderr else sys.stdout
    report = Report(
        tuple(findings),
        outcome.checked,
        outcome.line_of,
        outcome.fixed,
        options.deny_warnings,
        use_color(stream) and not options.output,
        skipped,
    )
    text = _statistics(report) if options.statistics else render(options.output_format, report)
    if options.output_format in ("text", "concise") and not options.quiet:
        from clickgen.report.text import summary_line

        text += summary_line(report) + "\n"
    if to_stderr:
        sys.stderr.write(text)
    else:
        _put(text, options.output)
    return PROBLEMS if report.fails and not options.exit_zero else OK


def _since(path: Path, findings: list[Diagnostic], outcome: Outcome) -> tuple[list[Diagnostic], int]:
    """What is new since the baseline was made, and how many findings are not; a new baseline is made here."""
    from clickgen.checking.baseline import baseline_text, keys_of, read_baseline, without_known

    keys = keys_of(findings, lambda file: shown_path(file, str(path.absolute().parent)), outcome.line_of)
    known = read_baseline(path)
    if known is None:
        kept = [key for finding, key in zip(findings, keys, strict=True) if not finding.is_error]
        _put_in_file(path, baseline_text(kept))
        print(f"clickgen: {counted(len(kept), 'finding')} written to {path}", file=sys.stderr)
        known = Counter(kept)
    return without_known(findings, keys, known)


def _statistics(report: Report) -> str:
    """How often each code was found, the most frequent first; ``[*]`` marks those that a safe fix mends."""
    counts = Counter(finding.code for finding in report.findings)
    mended = {finding.code for finding in report.findings if finding.fix and finding.fix.is_safe}
    width = max((len(str(count)) for count in counts.values()), default=0)
    return "".join(
        f"{count:>{width}}  {code}  {'[*]' if code in mended else '   '}  {CODES[code].title}\n"
        for code, count in sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    )


def _diffs(outcome: Outcome) -> Iterator[str]:
    import difflib

    for path, new in sorted(outcome.after.items()):
        old = outcome.before[path].decode("utf-8").splitlines(keepends=True)
        lines = difflib.unified_diff(old, new.decode("utf-8").splitlines(keepends=True), path, path)
        for line in lines:
            yield line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n"


def _put(text: str, output: str | None) -> None:
    if output:
        _put_in_file(Path(output), text)
    else:
        sys.stdout.write(text)


def _put_in_file(path: Path, text: str) -> None:
    from clickgen.emit.write import put_in_place

    # A file name that is no text cannot be written as UTF-8.
    put_in_place({path: text.encode(errors="backslashreplace")})


@contextmanager
def _progress() -> Iterator[Callable[[int, int], None]]:
    """How far a long check is, on a terminal only."""
    if not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield lambda _done, _total: None
        return
    with ExitStack() as stack:
        update: Callable[[int, int], None] | None = None

        def show(done: int, total: int) -> None:
            nonlocal update
            if total >= _MANY_FILES:
                update = update or _bar(stack, total)
                update(done, total)

        yield show


def _bar(stack: ExitStack, total: int) -> Callable[[int, int], None]:
    from rich.console import Console
    from rich.progress import Progress

    progress = stack.enter_context(Progress(console=Console(stderr=True), transient=True))
    task = progress.add_task("checking", total=total)
    return lambda done, _: progress.update(task, completed=done)
