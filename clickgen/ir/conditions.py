"""Conditions: contacts and comparisons in series (All) and parallel (Any)."""

from __future__ import annotations

from enum import Enum

from clickgen.ir.operands import Cell, Immediate, Named, Range, Single
from clickgen.records import dataclass
from clickgen.text.source import Span

OPPOSITE = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
"""The comparison that holds when another does not."""
MIRRORED = {"==": "==", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
"""The comparison that means the same with its sides exchanged."""


class Edge(Enum):
    """The change of a bit that closes an edge contact for one scan; the value is CLICK's word in a ladder file."""

    RISE = "rise"
    FALL = "fall"

    @property
    def word(self) -> str:
        """The word for a message: ``rising`` or ``falling``."""
        return "rising" if self is Edge.RISE else "falling"


@dataclass(frozen=True, slots=True)
class Contact:
    """A contact on a bit. ``edge`` is None for a level."""

    operand: Named | Cell | Range | Immediate
    span: Span
    negated: bool = False
    edge: Edge | None = None


@dataclass(frozen=True, slots=True)
class Compare:
    """``left op right`` with op one of ``== != < <= > >=``."""

    op: str
    left: Single
    right: Single
    span: Span


@dataclass(frozen=True, slots=True)
class All:
    """Terms in series."""

    terms: tuple[Condition, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Any:
    """Terms in parallel."""

    terms: tuple[Condition, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Always:
    """``True``: the bare power rail."""

    span: Span


Condition = Contact | Compare | All | Any | Always
