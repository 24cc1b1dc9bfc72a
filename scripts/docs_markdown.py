"""Small pieces of Markdown: tables, lists of words, links to the entries of the problems page."""

from __future__ import annotations

import re
from collections.abc import Iterable


def table(*rows: tuple[str, ...]) -> str:
    """A table; its first row is its head."""
    head, *body = (f"| {' | '.join(row)} |" for row in rows)
    return "\n".join([head, "|---" * len(rows[0]) + "|", *body])


def bullets(lines: Iterable[str]) -> str:
    return "\n".join(f"- {line}" for line in lines)


def block(notes: str, language: str, text: str) -> str:
    """A fenced block under the comment that tells the tests what it is."""
    return f"<!-- {notes} -->\n```{language}\n{text.rstrip()}\n```"


def quoted(word: object) -> str:
    return f"`{word}`"


def listed(words: Iterable[str], joiner: str = "or") -> str:
    """``a, b or c``; there must be at least one word."""
    *first, last = words
    return f"{', '.join(first)} {joiner} {last}" if first else last


def anchor(heading: str) -> str:
    """The end of a link to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def problem_link(code: str) -> str:
    """A link to a code's page, from a page of an instruction."""
    return f"[{code}](../problems/{code}.md)"
