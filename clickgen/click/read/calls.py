"""Splits an output token: ``copy(DS1,DS2,oneshot=1)`` is a name, arguments, and arguments by name."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

_CALL = re.compile(r"(\.?[A-Za-z_]\w*)\((.*)\)", re.DOTALL)
_KEYWORD = re.compile(r"([A-Za-z_]\w*)\s*=(?!=)\s*(.*)", re.DOTALL)
_PIECES = re.compile(r'"(?:[^"]|"")*"|[^"]', re.DOTALL)
_DEPTH = {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}


@dataclass(frozen=True)
class Call:
    """A token as text: nothing of it is understood yet."""

    name: str
    arguments: tuple[str, ...] = ()
    keywords: dict[str, str] = field(default_factory=dict)


def call_of(token: str) -> Call | None:
    """Return the parts of a token; None if it is not a call, or its quotes or brackets do not match."""
    match = _CALL.fullmatch(token.strip())
    parts = split(match[2]) if match else None
    if match is None or parts is None:
        return None
    arguments: list[str] = []
    keywords: dict[str, str] = {}
    for part in parts:
        keyword = _KEYWORD.fullmatch(part)
        if keyword and keyword[1] not in keywords:
            keywords[keyword[1]] = keyword[2]
        elif keyword or keywords:
            return None
        else:
            arguments.append(part)
    return Call(match[1], tuple(arguments), keywords)


def unquoted(text: str) -> str | None:
    """Return the text inside quotes, where a quote is doubled; None if the text is not in quotes."""
    is_quoted = len(text) > 1 and text[0] == text[-1] == '"'
    return text[1:-1].replace('""', '"') if is_quoted else None


def split(text: str) -> list[str] | None:
    """Return the parts between commas, except those inside quotes and brackets; None if these do not match."""
    if not text.strip():
        return []
    parts, depth = [""], 0
    pieces = _PIECES.findall(text)
    if len("".join(pieces)) != len(text):
        return None
    for piece in pieces:
        depth += _DEPTH.get(piece, 0)
        if depth < 0:
            return None
        if piece == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += piece
    return None if depth else [part.strip() for part in parts]
