"""Conditions: contacts and comparisons in series (All) and parallel (Any)."""

from __future__ import annotations

from dataclasses import dataclass

from clickgen.ir.operands import Cell, Immediate, Named, Range, Single
from clickgen.text.source import Span

OPPOSITE = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
"""The comparison that holds where another does not."""
MIRRORED = {"==": "==", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
"""The comparison that says the same with its sides exchanged."""

EDGE_FUNCTIONS = {"rise": "re", "fall": "fe"}
"""How the language writes a contact on an edge."""


@dataclass(frozen=True, slots=True)
class Contact:
    """A contact on a bit. ``edge`` is "" for a level, "rise" or "fall" for one scan of change."""

    operand: Named | Cell | Range | Immediate
    span: Span
    negated: bool = False
    edge: str = ""


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
