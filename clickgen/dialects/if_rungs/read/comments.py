"""Rung comments: the block of comment lines directly above a rung."""

from __future__ import annotations

import ast

from clickgen.text.source import SourceFile

DIRECTIVE = "clickgen:"
"""Comments that speak to clickgen, such as ``# clickgen: ignore[...]``, stay in the source."""


def rung_comment(source: SourceFile, rung: ast.stmt, before: ast.stmt | None, header: int) -> str:
    """The text of the comment block that ends right above a rung; a blank line ends the block.

    ``before`` is the statement before the rung in its block, ``header`` the last line of what holds the block: nothing
    at or above its end is a comment of the rung. A comment that is indented like the body of the statement before
    belongs to that body.
    """
    floor = max(header, before.end_lineno or before.lineno) if before else header
    inner = _indent_of_body(source, before)
    lines: list[str] = []
    for number in range(rung.lineno - 1, floor, -1):
        line = source.line(number)
        text = line.lstrip()
        if not text.startswith("#") or (inner and line.startswith(inner)):
            break
        text = text[2:] if text.startswith("# ") else text[1:]
        if not text.strip().startswith(DIRECTIVE):
            lines.append(text.rstrip())
    return "\n".join(reversed(lines))


def _indent_of_body(source: SourceFile, node: ast.stmt | None) -> str:
    """What the lines of a statement's last block begin with; "" for a statement without one, or with it on its line."""
    block = getattr(node, "orelse", None) or getattr(node, "body", None)
    if node is None or not isinstance(block, list) or not isinstance(block[0], ast.stmt):
        return ""
    line = source.line(block[0].lineno)
    indent = line[: len(line) - len(line.lstrip())]
    stands_alone = len(indent) == len(line.encode()[: block[0].col_offset].decode(errors="ignore"))
    return indent if stands_alone else ""
