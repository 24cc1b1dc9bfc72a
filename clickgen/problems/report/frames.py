"""Problems for a person at a terminal: code, place, source line with the span marked, the way out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from typing import TextIO

from clickgen.problems.codes import Severity
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.report import use_color
from clickgen.text.source import SourceFile, Span
from clickgen.text.wording import counted, escaped, printable
from clickgen.workspace import Workspace

_COLORS = {Severity.ERROR: "31", Severity.WARNING: "33", Severity.INFO: "36"}
_FRAME_WIDTH = 110
"""How much of a long source line is shown, in characters."""


class Renderer:
    """Writes problems for people. ``line_of`` gives the text of a file's line for the frame."""

    def __init__(
        self,
        color: bool,
        line_of: Callable[[str, int], str],
        severity_of: Callable[[Diagnostic], Severity] = lambda problem: problem.severity,
    ) -> None:
        self._color = color
        self._line_of = line_of
        self._severity_of = severity_of

    def render(self, problem: Diagnostic) -> str:
        severity = self._severity_of(problem)
        head = self._paint(f"{severity.value}[{problem.code}]", f"1;{_COLORS[severity]}")
        place = f"{escaped(str(problem.span))}: " if problem.span else ""
        lines = [f"{self._paint(place, '1')}{head}: {escaped(problem.message)}"]
        if problem.span:
            lines += self._frame(problem.span, "^", _COLORS[severity])
        for label in problem.labels:
            where = label.span.seen_from(problem.span) if problem.span else str(label.span)
            lines.append(f"  {self._paint('note', '1')}: {escaped(label.text)} ({escaped(where)})")
            lines += self._frame(label.span, "-", "36")
        if problem.help:
            lines.append(f"  {self._paint('help', '1;32')}: {escaped(problem.help)}")
        return "\n".join(lines)

    def _frame(self, span: Span, mark: str, color: str) -> Iterator[str]:
        text = "" if span.sheet else self._line_of(span.path, span.line)
        if not text.strip():
            return
        number = str(span.line)
        end = span.end_col if span.end_line == span.line else len(text) + 1
        start = max(0, min(span.col - 1, len(text)) - _FRAME_WIDTH // 2) if len(text) > _FRAME_WIDTH else 0
        shown = text[start : start + _FRAME_WIDTH]
        before = _width(printable(shown[: span.col - 1 - start]))
        marked = max(1, _width(printable(shown[span.col - 1 - start : max(end - 1 - start, 0)])))
        gutter = " " * len(number)
        yield f"  {number} | {printable(shown)}"
        yield f"  {gutter} | {' ' * before}{self._paint(mark * marked, color)}"

    def _paint(self, text: str, style: str) -> str:
        return f"\x1b[{style}m{text}\x1b[0m" if self._color and text else text


_NARROW = "\u0300"
"""Before the first combining mark, every character takes one column."""


def _width(text: str) -> int:
    """The columns that a text takes in a terminal."""
    if text.isascii() or max(text) < _NARROW:
        return len(text)
    from rich.cells import cell_len

    return cell_len(text)


_NOUNS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}


def summary(severities: Iterable[Severity]) -> str:
    """``2 errors, 1 warning``, or ""."""
    counts = Counter(severities)
    return ", ".join(counted(counts[severity], noun) for severity, noun in _NOUNS.items() if counts[severity])


def source_lines(sources: Iterable[SourceFile], files: Workspace | None = None) -> Callable[[str, int], str]:
    """A reader of lines for frames, from the sources or else from ``files``; what cannot be read has no lines."""
    files = files or Workspace()
    cache: dict[str, list[str]] = {source.path: source.lines for source in sources}

    def line_of(path: str, number: int) -> str:
        if path not in cache:
            try:
                text = files.read(path).decode("utf-8-sig", "replace")
                cache[path] = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
            except OSError:
                cache[path] = []
        lines = cache[path]
        return lines[number - 1] if 0 < number <= len(lines) else ""

    return line_of


def write_problems(
    problems: Iterable[Diagnostic], sources: Iterable[SourceFile], stream: TextIO, files: Workspace | None = None
) -> None:
    """Write all problems, a blank line after each; lines of other files than ``sources`` come from ``files``."""
    renderer = Renderer(use_color(stream), source_lines(sources, files))
    for problem in problems:
        stream.write(renderer.render(problem) + "\n\n")
