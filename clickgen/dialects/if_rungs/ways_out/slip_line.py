"""A line that Python cannot read, the message about it, and helpers for every kind of slip."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple

from clickgen.dialects.if_rungs.read.conditions import as_condition, condition_fault
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile


class Told(NamedTuple):
    """What is wrong with a line and the way out. ``at`` is the stretch of the line that is marked, from 0."""

    message: str
    help: str
    at: tuple[int, int]
    edits: tuple[tuple[int, int, str], ...] = ()
    """Stretches of the line and the text for each: a fix, where the meaning is certain."""


class Line(NamedTuple):
    """A line, and the same with blanks for its comment and for what stands in quotes."""

    text: str
    code: str
    plain: str
    """The line with blanks for what stands in quotes alone."""
    context: Context
    fault: str
    """What Python says."""


def line_of(source: SourceFile, number: int, fault: str) -> Line:
    """Return a line of a file that Python cannot read, with the reason."""
    text = source.line(number)
    context = Context(SourceFile(source.path, text), Diagnostics())
    return Line(text, _blanked(text, True), _blanked(text, False), context, fault)


_QUOTED = re.compile(r"""("(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')|(#.*)""")


def _blanked(text: str, with_comment: bool) -> str:
    """The line with blanks in the place of what stands between quotes, and of its comment."""

    def blank(found: re.Match[str]) -> str:
        if found[1]:
            return f'"{" " * (len(found[0]) - 2)}"'
        return " " * len(found[0]) if with_comment else found[0]

    return _QUOTED.sub(blank, text)


HEAD = re.compile(r"\s*(?:if|elif|while)\b\s*", re.IGNORECASE)
"""The word before a condition."""


def condition_of(line: Line, text: str) -> str:
    """``write if all(...):`` for the text of an if without its slip; what is wrong with it then, or ""."""
    expression = text.strip().rstrip(":;").strip()
    context = line.context.of_text(expression, is_trial=False)
    node = context.expression()
    if node is None:
        return ""
    written = as_condition(context, node)
    if written:
        return f"write if {written}:"
    fault = condition_fault(context, expression)
    return fault.help if fault else ""


def without(line: Line, edits: list[tuple[int, int, str]]) -> str:
    """The text of the line after these edits."""
    parts, done = [], 0
    for start, end, new in edits:
        parts += [line.text[done:start], new]
        done = end
    return "".join([*parts, line.text[done:]])


def after_head(text: str) -> str:
    """Return the text after the word of an if, without a comment."""
    head = HEAD.match(text)
    rest = text[head.end() :] if head else ""
    comment = re.search(r":\s*#", rest)
    return rest[: comment.start() + 1] if comment else rest


def depth(code: str) -> int:
    """Count the brackets that are open at the end."""
    return sum(code.count(sign) for sign in "([{") - sum(code.count(sign) for sign in ")]}")


def says(message: str, help: str, group: str = "") -> Callable[[Line, re.Match[str]], Told]:
    """Tell the same words for every match; ``group`` names the part of it to mark."""

    def tell(_: Line, match: re.Match[str]) -> Told:
        return Told(message, help, match.span(group) if group else match.span())

    return tell
