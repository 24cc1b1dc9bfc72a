"""Fixes that the text of a program suggests: the edits, and what must be proved before one may be called safe.

The reader proposes; ``clickgen.fixes`` judges, once names are addresses.
"""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.ir.conditions import Compare, Condition, Contact
from clickgen.ir.program import Item, Rung
from clickgen.records import dataclass
from clickgen.text.edits import Edit
from clickgen.text.source import Span


@dataclass(frozen=True, slots=True)
class Alternative:
    """One arm of an if with elif and else. Only the first is part of the program."""

    test: Condition
    """The arm's own condition; ``Always`` for an else."""
    alone: Condition
    """The condition that the fix writes, so that the arm can stand alone."""
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Proposal:
    """The fix of the problem with this code and span; without edits there is none to write."""

    code: str
    span: Span
    edits: tuple[Edit, ...]
    help: str
    """The help of the problem if the fix holds; "" keeps the problem's own."""
    turned: tuple[Contact | Compare, ...]
    """The conditions, as written, that the fix replaces by their opposites."""
    arms: tuple[Alternative, ...] = ()
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
