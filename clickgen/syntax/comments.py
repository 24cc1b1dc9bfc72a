"""Rung comments: the block of comment lines directly above a rung."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import libcst

DIRECTIVE = "clickgen:"
"""Comments that speak to clickgen, such as ``# clickgen: ignore[...]``, stay in the source."""


def rung_comment(leading_lines: Sequence[libcst.EmptyLine]) -> str:
    """The text of the comment block that ends right above a rung; a blank line ends the block."""
    lines: list[str] = []
    for empty in reversed(leading_lines):
        if empty.comment is None:
            break
        text = empty.comment.value[1:]
        text = text[1:] if text.startswith(" ") else text
        if not text.strip().startswith(DIRECTIVE):
            lines.append(text.rstrip())
    return "\n".join(reversed(lines))
