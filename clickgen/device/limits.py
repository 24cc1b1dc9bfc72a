"""CLICK's limits on files, routines and comments, in numbers."""

from __future__ import annotations

import re
import unicodedata

RUNGS_MAX = 256
"""Rungs in one ladder file (click-facts [limit.file])."""
ROWS_AND_RUNGS_MAX = 2047
"""Expanded grid rows plus rungs in one ladder file; beyond it the codec corrupts silently
(click-facts [limit.rows])."""
SUBROUTINES_MAX = 986
SUBROUTINE_NAME_MAX = 24
"""Characters (click-facts [limit.subroutine-names, limit.subroutines])."""
COMMENT_BYTES_MAX = 1400
"""Bytes of a rung comment after RTF encoding (click-facts [limit.comment])."""

_SUBSTITUTES = str.maketrans(
    {
        "\N{EM DASH}": "-",
        "\N{EN DASH}": "-",
        "\N{RIGHTWARDS ARROW}": "->",
        "\N{LEFTWARDS ARROW}": "<-",
        "\N{GREATER-THAN OR EQUAL TO}": ">=",
        "\N{LESS-THAN OR EQUAL TO}": "<=",
        "\N{NOT EQUAL TO}": "!=",
        "\N{LEFT DOUBLE QUOTATION MARK}": '"',
        "\N{RIGHT DOUBLE QUOTATION MARK}": '"',
        "\N{LEFT SINGLE QUOTATION MARK}": "'",
        "\N{RIGHT SINGLE QUOTATION MARK}": "'",
    }
)
_STYLES = (
    (re.compile(r"\*\*(.+?)\*\*", re.DOTALL), "b"),
    (re.compile(r"(?<!\w)__(.+?)__(?!\w)", re.DOTALL), "ul"),
    (re.compile(r"\*(.+?)\*", re.DOTALL), "i"),
    (re.compile(r"(?<!\w)_(.+?)_(?!\w)", re.DOTALL), "i"),
)
"""The marks that turn text bold, underlined or italic, with RTF's word for each."""
_STYLED_MAX = 2 * COMMENT_BYTES_MAX
"""The number of characters that are searched for marks."""
_LINE_BREAK = 5
"""The bytes of a line break in RTF."""


def comment_bytes(comment: str) -> int:
    """The length of a rung comment as CLICK stores it: a line break costs 5 bytes, each of ``\\ { }`` two."""
    text = "".join(map(_down_converted, comment.translate(_SUBSTITUTES)))
    for character in "\\{}":
        text = text.replace(character, "\\" + character)
    # Marks only make a comment longer, and searching a comment that is far too long could take for ever.
    for pattern, word in _STYLES if len(text) <= _STYLED_MAX else ():
        text = pattern.sub(rf"{{\\{word} \1}}", text)
    return len(text) + (_LINE_BREAK - 1) * text.count("\n")


def _down_converted(character: str) -> str:
    """The replacement of a character outside ASCII: its base letter, nothing for a mark, else a question mark."""
    if character.isascii():
        return character
    kept = []
    for part in unicodedata.normalize("NFKD", character):
        if part.isascii():
            kept.append(part)
        elif not unicodedata.category(part).startswith("M"):
            kept.append("?")
    return "".join(kept)


def styled_part(comment: str) -> str:
    """The first stretch of a comment that CLICK would show bold, underlined or italic; "" if there is none."""
    for pattern, _ in _STYLES:
        match = pattern.search(comment[:_STYLED_MAX])
        if match:
            return match.group()
    return ""
