"""Numbers in words."""

from __future__ import annotations


def counted(number: int, noun: str, plural: str = "") -> str:
    """``1 rung``, ``2 rungs``, ``3 addresses``."""
    return f"{number} {noun}" if number == 1 else f"{number} {plural or noun + 's'}"
