"""Fixes that the text of a program suggests: the facts that a fix needs, and what must be proved before it is safe.

The reader proposes; ``clickgen.fixes`` judges, once names are addresses, and only then the dialect writes the fix.
"""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.ir.conditions import Compare, Condition, Contact
from clickgen.ir.program import Item, Rung
from clickgen.records import dataclass
from clickgen.text.source import Span


@dataclass(frozen=True, slots=True)
class Alternative:
    """One arm of an if with elif and else. Only the first is part of the program."""

    test: Condition
    """The arm's own condition; ``Always`` for an else."""
    alone: Condition
    """The condition that the fix writes, so that the arm can stand alone."""
    items: tuple[Item, ...]
    word: Span
    """The place of the arm's ``if``, ``elif`` or ``else``."""


@dataclass(frozen=True, slots=True)
class Rewrite:
    """An expression, by its span, and what a fix puts in its place."""

    span: Span
    meaning: Span
    """The expression whose meaning is written in the language."""
    is_wanted: bool = True
    """False if the opposite of the meaning is written."""
    text: str = ""
    """The text to write, where the expression's own terms do not make it."""


@dataclass(frozen=True, slots=True)
class Proposal:
    """The fix of the problem with this code and span; without a rewrite and without arms that are written, none."""

    code: str
    span: Span
    rewrite: Rewrite | None
    turned: tuple[Contact | Compare, ...]
    """The conditions, as written, that the fix replaces by their opposites."""
    arms: tuple[Alternative, ...] = ()
    is_written: bool = False
    """True if the fix gives the arms their own conditions."""
    is_branch: bool = False
    """True if the arms become branches of one rung, which looks at all their conditions before it acts."""
    is_read: bool = True
    """False if part of it could not be read, so that nobody knows what it asks or does."""

    def rungs(self) -> Iterator[Rung]:
        """All parts of the proposal in the form of rungs."""
        for arm in self.arms:
            yield Rung(arm.test, arm.items, "", self.span, self.span)
        for leaf in self.turned:
            yield Rung(leaf, (), "", self.span, self.span)
