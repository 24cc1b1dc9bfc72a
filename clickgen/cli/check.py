"""``clickgen check``: the report to the standard output, everything else to the standard error."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.commands.check.programs import Outcome, Request, add_ignores
from clickgen.commands.check.programs import run as run_check
from clickgen.config import Config, code_prefix, find_config, read_config
from clickgen.dialects.discover import Target
from clickgen.problems.codes import CODES
from clickgen.problems.diagnostics import did_you_mean
from clickgen.problems.formats import FORMATS
from clickgen.problems.report import Report, render, shown_path, use_color
from clickgen.rules.select import Selection
from clickgen.text.wording import counted, escaped
from clickgen.workspace import READ_MAX, CouldNotRun, Workspace, require_size

if TYPE_CHECKING:
    from clickgen.commands.check.baseline import Baseline

_MANY_FILES = 8
"""From this many programs a terminal shows how far the check is."""


class _Wrong(CouldNotRun):
    """Flags that exclude each other; the message says which."""


DESCRIPTION = (
    "Check programs: the problems that a build would have, and rules about logic. Nothing is written unless asked for."
)
EXAMPLES = """\
examples:
  clickgen check                      check the configured programs, else what is below the working folder
  clickgen check plc.py --fix         mend what can be mended without changing what the program does
  clickgen check --diff               show what --fix would change
  clickgen check --select ALL --ignore CG504,CG505
  clickgen check --output-format github --deny-warnings
  cat plc.py | clickgen check - --stdin-filename plc.py

exit codes: 0 nothing to say, or notes only; 1 findings; 2 could not run
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("paths", metavar="PATH", nargs="*", help="files and folders; - is the standard input")
    mend = parser.add_argument_group("mending")
    mend.add_argument("--fix", action="store_true", help="apply the safe fixes")
    mend.add_argument("--unsafe-fixes", action="store_true", help="with --fix: also those that could change meaning")
    mend.add_argument("--diff", action="store_true", help="show what fixes would change, and change nothing")
    mend.add_argument("--add-ignore", action="store_true", help="silence every warning by a comment where it stands")
    choose = parser.add_argument_group("choosing")
    for flag, what in (
        ("--select", "only these codes or groups of codes, such as CG5 or ALL"),
        ("--extend-select", "these beside those that are on"),
        ("--ignore", "not these; the most specific wins"),
    ):
        choose.add_argument(flag, metavar="CODES", action="append", type=_codes, default=None, help=what)
    choose.add_argument("--exclude", metavar="PATTERN", action="append", default=[], help="leave these paths out")
    choose.add_argument(
        "--force-exclude", action="store_true", help="leave them out also when named, and other Python too"
    )
    choose.add_argument("--baseline", metavar="FILE", help="show only what is new since FILE was made; makes it if new")
    tell = parser.add_argument_group("telling")
    tell.add_argument("--output-format", metavar="FORMAT", default="text", help=f"one of {', '.join(FORMATS)}")
    tell.add_argument("-o", "--output", metavar="FILE", help="write the report into FILE")
    tell.add_argument("--statistics", action="store_true", help="count the findings of each code")
    tell.add_argument("-q", "--quiet", action="store_true", help="findings only, no summary")
    tell.add_argument("--exit-zero", action="store_true", help="exit with 0 whatever is found")
    tell.add_argument("--deny-warnings", action="store_true", help="warnings and notes are errors")
    add("--stdin-filename", metavar="FILE", help="the name of what comes from the standard input")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")
    add("--no-cache", action="store_true", help="judge everything anew")


def _codes(text: str) -> list[str]:
    try:
        return [code_prefix(word.strip()) for word in text.split(",") if word.strip()]
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def run(options: argparse.Namespace) -> int:
    """Check what the command line names; return the exit code."""
    _refuse_contradictions(options)
    files = Workspace()
    config = read_config(Path(options.config), files) if options.config else find_config(Path.cwd(), files)
    _refuse_input(options, _inputs(options, config))
    if options.fix or options.add_ignore:
        _put_back(options, config)
    with _progress() as progress:
        request = _request(options, config, files, progress)
        outcome = run_check(request, options.fix or options.diff, options.unsafe_fixes)
    _refuse_input(options, outcome.checked)
    for folder in outcome.empty:
        complain(f"no program in {folder}")
    if options.baseline and request.baseline is None:
        outcome = _begin_baseline(Path(options.baseline), outcome)
    if options.diff:
        return _tell_diff(options, outcome)
    if options.add_ignore:
        return _silence(options, outcome)
    if request.stdin is None:
        outcome.write()
    elif options.fix:
        # Bytes, as they came: a pipe's encoding must not change the program.
        sys.stdout.flush()
        sys.stdout.buffer.write(outcome.workspace.read(request.paths[0]))
        sys.stdout.buffer.flush()
    return _tell(options, outcome, to_stderr=request.stdin is not None and options.fix)


def _tell_diff(options: argparse.Namespace, outcome: Outcome) -> int:
    """Show what fixes would change; on the standard error how much is left that none fixes."""
    diff = "".join(_diffs(outcome))
    _put(diff, options.output)
    left = _report(options, outcome)._replace(fixed=0)  # Nothing was written.
    if left.findings and not options.quiet:
        from clickgen.problems.report.text import summary_line

        tell(f"clickgen: besides what this mends: {summary_line(left)}", file=sys.stderr)
    return PROBLEMS if (diff or left.fails) and not options.exit_zero else OK


def _silence(options: argparse.Namespace, outcome: Outcome) -> int:
    silenced = add_ignores(outcome)
    silenced.write()
    done = f"{counted(silenced.fixed, 'finding')} silenced in {counted(len(silenced.after), 'file')}"
    left = len(outcome.findings) - silenced.fixed
    rest = f"; {counted(left, 'finding')} that no comment silences: see clickgen check" if left else ""
    tell(done + rest, file=sys.stderr)
    return PROBLEMS if left and not options.exit_zero else OK


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
    if options.add_ignore and options.output:
        raise _Wrong("--add-ignore makes no report: leave -o out")
    if options.stdin_filename and "-" not in options.paths:
        raise _Wrong(
            "--stdin-filename names what comes from the standard input: clickgen check - --stdin-filename FILE"
        )
    if options.statistics and options.output_format not in _COUNTED:
        raise _Wrong(f"--statistics is told as {' or '.join(_COUNTED)}")


_NO_REPORTS = (".py", ".pyi", ".csv", ".placed", ".toml", ".xlsx", ".xlsm")
"""The endings of programs, tables and settings, which no report has."""


def _inputs(options: argparse.Namespace, config: Config) -> Iterator[str | os.PathLike[str] | None]:
    """The files that this check is about to read, as far as they are known before it."""
    yield from (options.config, config.file, options.baseline)
    for program in config.programs:
        yield from (program.path, program.nicknames)
    yield from (path for path in options.paths if os.path.isfile(path))


def _put_back(options: argparse.Namespace, config: Config) -> None:
    """Put back what a killed command left where this one is about to write."""
    from clickgen.cli.jobs import put_back

    named = [Path(path) for path in options.paths or ["."]]
    programs = [program.path for program in config.programs]
    put_back(path if path.is_dir() else path.parent for path in (*named, *programs))


def _refuse_input(options: argparse.Namespace, inputs: Iterable[str | os.PathLike[str] | None]) -> None:
    """Refuse a report that would replace anything but an earlier one. Raises CouldNotRun."""
    if not options.output:
        return
    place = os.path.realpath(options.output)
    is_input = any(os.path.realpath(path) == place or _is_same(path, place) for path in inputs if path is not None)
    if is_input or options.output.lower().endswith(_NO_REPORTS):
        what = "is read by this check" if is_input else "has the name of a program, a table or settings"
        raise _Wrong(f"-o {options.output} {what}, and a report would take its place: name another file")


def _is_same(path: str | os.PathLike[str], place: str) -> bool:
    """True for two names of one file, for example where case does not count."""
    return os.path.exists(path) and os.path.exists(place) and os.path.samefile(path, place)


def _request(
    options: argparse.Namespace, config: Config, files: Workspace, progress: Callable[[int, int], None]
) -> Request:
    settings = config.check
    select = _joined(options.select)
    selection = Selection(
        settings.select if select is None else select,
        (*(settings.extend_select if select is None else ()), *(_joined(options.extend_select) or ())),
        (*(settings.ignore if select is None else ()), *(_joined(options.ignore) or ())),
    )
    paths = tuple(options.paths)
    stdin = _standard_input() if paths == ("-",) else None
    if stdin is not None:
        require_size(stdin, "the standard input")
        paths = (options.stdin_filename or "stdin.py",)
    return Request(
        config,
        selection,
        paths,
        tuple(options.exclude),
        options.force_exclude,
        not options.no_cache,
        stdin,
        progress,
        _baseline(Path(options.baseline), files) if options.baseline else None,
        partial(_named_elsewhere, config, files),
        files,
    )


def _standard_input() -> bytes:
    """Return the program on the standard input. Raises CouldNotRun if the caller of the command closed it."""
    if sys.stdin is None:
        raise CouldNotRun("the standard input is closed: clickgen check - < prog.py")
    return sys.stdin.buffer.read(READ_MAX + 1)


def _named_elsewhere(config: Config, files: Workspace, target: Target) -> frozenset[str]:
    """The names that the other programs around the table of one use."""
    from clickgen.cli.jobs import Job
    from clickgen.commands.nicknames.elsewhere import named_elsewhere
    from clickgen.config import Settings

    job = Job(target.path, Settings(target.nicknames, reserved=config.reserved), Path())
    return named_elsewhere(job, config, files)


def _joined(lists: list[list[str]] | None) -> tuple[str, ...] | None:
    return None if lists is None else tuple(code for codes in lists for code in codes)


# -- reporting --------------------------------------------------------------------------------------------------------


def _tell(options: argparse.Namespace, outcome: Outcome, to_stderr: bool) -> int:
    report = _report(options, outcome, use_color(sys.stderr if to_stderr else sys.stdout) and not options.output)
    text = _statistics(report, options.output_format) if options.statistics else render(options.output_format, report)
    if options.output_format in ("text", "concise") and not options.quiet:
        from clickgen.problems.report.text import summary_line

        text += summary_line(report) + "\n"
    if to_stderr and not options.output:
        sys.stderr.write(text)
    else:
        _put(text, options.output)
    return PROBLEMS if report.fails and not options.exit_zero else OK


def _report(options: argparse.Namespace, outcome: Outcome, color: bool = False) -> Report:
    return Report(
        outcome.findings,
        outcome.checked,
        outcome.line_of,
        outcome.fixed,
        options.deny_warnings,
        color,
        {"in the baseline": outcome.known} if options.baseline else {},
    )


def _baseline(path: Path, files: Workspace) -> Baseline | None:
    """The findings from when the repository began; None if this run should write them."""
    from clickgen.commands.check.baseline import Baseline, read_baseline

    known = read_baseline(path, files)
    return None if known is None else Baseline(known, _named_from(path))


def _begin_baseline(path: Path, outcome: Outcome) -> Outcome:
    """Write the findings into a new baseline; only the errors are left."""
    from clickgen.commands.check.baseline import Baseline, baseline_text
    from clickgen.problems.finding_keys import keys_of

    findings = [finding for finding in outcome.findings if not finding.is_error]
    keys = keys_of(findings, _named_from(path), outcome.line_of)
    _put_in_file(path, baseline_text(keys))
    tell(f"clickgen: {counted(len(keys), 'finding')} written to {path}", file=sys.stderr)
    news = Baseline(Counter(keys), _named_from(path)).news(list(outcome.findings), outcome.line_of)
    return outcome._replace(findings=tuple(news), known=len(keys))


def _named_from(path: Path) -> Callable[[str], str]:
    """A file's name in a baseline: relative to its own folder."""
    folder = os.path.dirname(os.path.abspath(path))
    return lambda file: shown_path(file, folder)


_COUNTED = ("text", "concise", "json")


def _statistics(report: Report, output_format: str) -> str:
    """How often each code was found, the most frequent first; ``[*]`` marks those that a safe fix corrects."""
    counts = Counter(finding.code for finding in report.findings)
    mended = Counter(finding.code for finding in report.findings if finding.fix and finding.fix.is_safe)
    width = max((len(str(count)) for count in counts.values()), default=0)
    rows = sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    if output_format == "json":
        import json

        entries = [
            {"code": code, "count": count, "fixable": mended[code], "title": CODES[code].title} for code, count in rows
        ]
        return json.dumps(entries, indent=2) + "\n"
    return "".join(
        f"{count:>{width}}  {code}  {'[*]' if code in mended else '   '}  {CODES[code].title}\n" for code, count in rows
    )


def _diffs(outcome: Outcome) -> Iterator[str]:
    import difflib

    for path, new in sorted(outcome.after.items()):
        old = outcome.before[path].decode("utf-8")
        name = escaped(path)
        lines = difflib.unified_diff(_lines(old), _lines(new.decode("utf-8")), name, name)
        for line in lines:
            yield line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n"


def _lines(text: str) -> list[str]:
    """Lines with their ends, as patch knows them: only a line feed ends one."""
    return [line for line in re.split(r"(?<=\n)", text) if line]


def _put(text: str, output: str | None) -> None:
    if output:
        _put_in_file(Path(output), text)
    else:
        sys.stdout.write(text)


def _put_in_file(path: Path, text: str) -> None:
    from clickgen.text.write import put_in_place

    # A file name that is not text cannot be written as UTF-8.
    put_in_place({path: text.encode(errors="backslashreplace")}, no_links=[path])


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
