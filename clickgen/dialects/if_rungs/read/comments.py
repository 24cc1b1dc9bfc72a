"""Rung comments: the block of comment lines directly above a rung."""

from __future__ import annotations

import libcst as cst

from clickgen.problems.silence import DIRECTIVE


def rung_comment(rung: cst.If) -> str:
    """The text of the comment lines right above a rung; a blank line ends them.

    libcst leaves a comment that is indented like the body of the statement before to that body.
    """
    lines: list[str] = []
    for line in reversed(rung.leading_lines):
        if line.comment is None:
            break
        text = line.comment.value
        text = text[2:] if text.startswith("# ") else text[1:]
        if not text.strip().startswith(DIRECTIVE):
            lines.append(text.rstrip())
    return "\n".join(reversed(lines))
