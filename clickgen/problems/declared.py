"""A code as it is declared: severity, title, why it matters, and examples. Explanations and tests are made from it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

from clickgen.problems.codes import Severity

FOLDER = Path(__file__).parent / "explanations"
"""The pages of the codes that no rule reports: a stage that reads, places or imports something does."""
WORDS = {Severity.ERROR: "Error", Severity.WARNING: "Warning", Severity.INFO: "Note"}
_SEVERITIES = {word: severity for severity, word in WORDS.items()}
_HEAD = re.compile(r"# (\w+): (.+)\n\n")


class Wrong(NamedTuple):
    """An example with the problem: rungs of main, or a whole program. ``# <-`` ends each line that has a finding.

    ``fixed`` is the example after its fix; "" where there is none.
    """

    text: str
    fixed: str = ""


class Code(NamedTuple):
    """One code. ``why`` is Markdown for the person who got the finding: what can go wrong, and what to do.

    The examples of ``right`` are written like those of ``wrong``, and have no finding of this code.
    """

    name: str
    severity: Severity
    title: str
    why: str
    wrong: tuple[Wrong, ...] = ()
    right: tuple[str, ...] = ()
    is_on: bool = True
    """False for a rule that says something only when it is asked for."""


def page_of(name: str) -> Code | None:
    """The code that a page of ``FOLDER`` declares; None where it has no page."""
    path = FOLDER / f"{name}.md"
    return _read(path) if path.is_file() else None


def pages() -> tuple[Code, ...]:
    """Every code that has a page."""
    return tuple(_read(path) for path in sorted(FOLDER.glob("*.md")))


def _read(path: Path) -> Code:
    text = path.read_text("utf-8")
    head = _HEAD.match(text)
    if head is None or head[1] not in _SEVERITIES:
        raise ValueError(f"{path} begins with # Error: TITLE, # Warning: TITLE or # Note: TITLE")
    return Code(path.stem, _SEVERITIES[head[1]], head[2], text[head.end() :])
