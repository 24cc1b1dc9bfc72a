"""Numbers and names in messages, and text made safe to show."""

from __future__ import annotations

import re


def counted(number: int, noun: str, plural: str = "") -> str:
    """``1 rung``, ``2 rungs``, ``3 addresses``."""
    return f"{number} {noun}" if number == 1 else f"{number} {plural or noun + 's'}"


def quoted(text: str) -> str:
    """A text in quotes, double ones if possible: ``"Auto Mode"``."""
    shown = repr(text)
    return shown if '"' in text else f'"{shown[1:-1]}"'


_WRITTEN = {"\n": "\\n", "\r": "\\r", "\t": "\\t"}
_LOG_COMMAND = re.compile(r"#(#(?:vso)?\[)")
"""Text that the runners of GitHub and Azure Pipelines take for a command anywhere in a line of a log."""


def escaped(text: str) -> str:
    """One line of any text, such as a name or a message. Characters that steer a terminal or a log are escaped.

    A line break becomes ``\\n``, other controls, marks of the writing direction and the like ``\\x1b`` or ``\\u202e``.
    """
    if not (text.isascii() and text.isprintable()):
        text = "".join(character if _is_harmless(character) else _written(character) for character in text)
    return _LOG_COMMAND.sub("#\N{MIDDLE DOT}\\1", text) if "##" in text else text


def printable(text: str) -> str:
    """Source text of one line or more, each character in its column: a control character becomes a dot.

    A tab becomes four spaces.
    """
    if not (text.isascii() and text.isprintable()):
        text = "".join(
            character if _is_harmless(character) or character == "\n" else _DOTS.get(character, "\N{MIDDLE DOT}")
            for character in text
        )
    return _LOG_COMMAND.sub("\N{MIDDLE DOT}\\1", text) if "##" in text else text


_DOTS = {"\t": "    "}


def json_text(tree: object, indent: int | None = None) -> str:
    """A tree as JSON that a person can read, without characters that steer a terminal or the writing direction."""
    import json

    text = json.dumps(tree, indent=indent, ensure_ascii=False)
    if text.replace("\n", "").isprintable():
        return text
    return "".join(
        character if _is_harmless(character) or character == "\n" else json.dumps(character)[1:-1] for character in text
    )


def _is_harmless(character: str) -> bool:
    if character.isprintable():
        return True
    import unicodedata

    return unicodedata.category(character) == "Zs"  # spaces of another width


def _written(character: str) -> str:
    return _WRITTEN.get(character) or character.encode("unicode_escape", "surrogatepass").decode()


def shorten(text: str, limit: int = 40) -> str:
    """Source text on one line, for a message."""
    line = " ".join(text.split())
    return line if len(line) <= limit else line[: limit - 3] + "..."


def word_pattern(word: str) -> re.Pattern[str]:
    """A whole word in any case."""
    return re.compile(rf"(?<!\w){re.escape(word)}(?!\w)", re.IGNORECASE)
