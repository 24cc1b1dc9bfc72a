"""Parts of a comment that laddercodec leaves out; CLICK keeps it as RTF (click-facts [click-file.comments])."""

from __future__ import annotations

import re
from collections.abc import Iterator

_KEPT = frozenset(("par", "line", "tab", "b", "i", "ul", "ulnone", "plain", "u", "uc"))
"""Control words that laddercodec 0.2.2 turns into text and styles (decode.py, _decode_rtf)."""
_USUAL = frozenset(("pard", "f0", "fs20", "lang1033"))
"""The form of every comment of CLICK at its beginning."""
_SYMBOLS = frozenset("\\{}~_-")
_HEAD = re.compile(r"\\fs-?[0-9]+ ")
_CONTROL = re.compile(r"\\(?:(?P<word>[A-Za-z]+)(?P<number>-?[0-9]+)?|'(?P<code>..)|(?P<symbol>.))", re.DOTALL)
_CODE = re.compile(r"[0-9A-Fa-f]{2}")


def left_out(comment: bytes) -> list[str]:
    """The marks in a comment that laddercodec ignores, such as a colour; each once."""
    text = comment.decode("cp1252", "replace")
    head = _HEAD.search(text)
    return list(dict.fromkeys(_unknown(text[head.end() :] if head else text)))


def _unknown(text: str) -> Iterator[str]:
    for match in _CONTROL.finditer(text):
        word, code = match["word"], match["code"]
        if word is not None:
            is_known = word in _KEPT or f"{word}{match['number'] or ''}" in _USUAL
        elif code is not None:
            is_known = _CODE.fullmatch(code) is not None and _is_character(int(code, 16))
        else:
            is_known = match["symbol"] in _SYMBOLS
        if not is_known:
            yield match[0]


def _is_character(code: int) -> bool:
    try:
        bytes((code,)).decode("cp1252")
    except UnicodeDecodeError:
        return False
    return True
