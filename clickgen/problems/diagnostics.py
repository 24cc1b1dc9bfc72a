"""Problems: what is wrong, where, and the way out. The codes are a table in ``codes.py``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from clickgen.problems.codes import CODES, Severity
from clickgen.text.edits import Fix
from clickgen.text.source import Span

TRACEBACK = "CLICKGEN_TRACEBACK"
"""The environment variable that lets an internal error through, for those who fix it."""


class Label(NamedTuple):
    """A second place that a problem speaks of, such as the earlier of two owners."""

    span: Span
    text: str


class Diagnostic(NamedTuple):
    """One problem. ``span`` is None only for a problem that has no place in a file."""

    code: str
    message: str
    span: Span | None
    help: str = ""
    labels: tuple[Label, ...] = ()
    fix: Fix | None = None

    @property
    def severity(self) -> Severity:
        return CODES[self.code].severity

    @property
    def is_error(self) -> bool:
        return self.severity is Severity.ERROR

    @property
    def sort_key(self) -> tuple[str, str, int, int, str, str]:
        """By file, in a workbook by sheet, and by place."""
        span = self.span or Span("", 0, 0, 0, 0)
        return (span.path, span.sheet, span.line, span.col, self.code, self.message)


class Diagnostics:
    """The problems that the stages have found so far. Stages add; nothing stops at the first."""

    def __init__(self) -> None:
        self.found: list[Diagnostic] = []

    def add(
        self,
        code: str,
        span: Span | None,
        message: str,
        help: str = "",
        labels: tuple[Label, ...] = (),
        fix: Fix | None = None,
    ) -> None:
        self.found.append(Diagnostic(code, message, span, help, labels, fix))

    @property
    def has_errors(self) -> bool:
        return any(problem.is_error for problem in self.found)

    def in_order(self) -> tuple[Diagnostic, ...]:
        """Every problem once, by file and position."""
        return tuple(sorted(dict.fromkeys(self.found), key=lambda problem: problem.sort_key))


class Suggestions:
    """``did_you_mean`` for the mistakes of one program.

    Each one compares a word with all the names of a kind, so only the first ones are answered: a program with so
    many mistakes has a problem other than its spelling.
    """

    def __init__(self) -> None:
        self._left = _SUGGESTED_MAX

    def __call__(self, word: str, known: Iterable[str]) -> str:
        """Return ``did you mean x?``; "" if nothing is near, and after many answers."""
        self._left -= 1
        return did_you_mean(word, known) if self._left >= 0 else ""


_SUGGESTED_MAX = 100


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return ``did you mean x?`` for a slip of the keyboard, whatever its case; else ""."""
    from clickgen.problems.suggest import near_words

    near = near_words(word, known)
    shown = f"{', '.join(near[:-1])} or {near[-1]}" if len(near) > 1 else "".join(near)
    return f"did you mean {shown}?" if near else ""
