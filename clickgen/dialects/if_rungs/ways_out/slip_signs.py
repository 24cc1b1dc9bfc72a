"""Slips in signs: those of word processors, of comments in other languages, and between arguments."""

from __future__ import annotations

import re
from itertools import accumulate

from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.ways_out.slip_line import Line, Told, after_head, condition_of, depth, without

_SIGNS = {
    "\N{LEFT DOUBLE QUOTATION MARK}": '"',
    "\N{RIGHT DOUBLE QUOTATION MARK}": '"',
    "\N{DOUBLE LOW-9 QUOTATION MARK}": '"',
    "\N{LEFT-POINTING DOUBLE ANGLE QUOTATION MARK}": '"',
    "\N{RIGHT-POINTING DOUBLE ANGLE QUOTATION MARK}": '"',
    "\N{LEFT SINGLE QUOTATION MARK}": "'",
    "\N{RIGHT SINGLE QUOTATION MARK}": "'",
    "\N{SINGLE LOW-9 QUOTATION MARK}": "'",
    "\N{GREATER-THAN OR EQUAL TO}": ">=",
    "\N{LESS-THAN OR EQUAL TO}": "<=",
    "\N{NOT EQUAL TO}": "!=",
    "\N{MINUS SIGN}": "-",
    "\N{EN DASH}": "-",
    "\N{EM DASH}": "-",
    "\N{NO-BREAK SPACE}": " ",
    "\N{ZERO WIDTH SPACE}": "",
    "\N{ZERO WIDTH NO-BREAK SPACE}": "",
    "\N{FULLWIDTH LEFT PARENTHESIS}": "(",
    "\N{FULLWIDTH RIGHT PARENTHESIS}": ")",
    "\N{FULLWIDTH COMMA}": ",",
    "\N{FULLWIDTH COLON}": ":",
    "\N{FULLWIDTH EQUALS SIGN}": "=",
}
"""Signs that word processors and web pages put in, and the plain ones."""
SIGN = re.compile(f"[{''.join(_SIGNS)}]")


def _plain(text: str) -> tuple[tuple[int, int, str], ...]:
    """The plain signs in the place of the others, outside of texts and comments: what stands in quotes stays as it is.

    Nothing where a text would end elsewhere than the person sees it end.
    """
    edits: list[tuple[int, int, str]] = []
    at = 0
    while at < len(text) and text[at] != "#":
        quote = text[at] if text[at] in ("'", '"') else _SIGNS.get(text[at], "")
        if quote not in ("'", '"'):
            if text[at] in _SIGNS:
                edits.append((at, at + 1, quote))
            at += 1
            continue
        end = _end_of_text(text, at, quote)
        if end is None or quote in text[at + 1 : end] or "\\" in text[at + 1 : end]:
            return ()
        edits += [(place, place + 1, quote) for place in (at, end) if text[place] != quote]
        at = end + 1
    return tuple(edits)


def _end_of_text(text: str, start: int, quote: str) -> int | None:
    """Where a text in quotes of any kind ends: at the same plain quote, or at the next one that closes."""
    if text[start] == quote and (plain := text.find(quote, start + 1)) >= 0:
        return plain
    closing = (at for at in range(start + 1, len(text)) if quote in (text[at], _SIGNS.get(text[at])))
    return next(closing, None)


def typographic(line: Line, match: re.Match[str]) -> Told:
    edits = _plain(line.text)
    plain = _SIGNS[match[0]]
    if plain in ('"', "'"):
        help = f"write straight quotes, {plain}"
        return Told("these quotes come from a word processor", help, match.span(), edits)
    if not plain.strip():
        return Told("this blank comes from a word processor", "write a plain blank", match.span(), edits)
    meant = condition_of(line, after_head(without(line, list(edits))))
    return Told("this sign is not on a keyboard", meant or f"write {plain}", match.span(), edits)


def comment(line: Line, match: re.Match[str]) -> Told:
    """``// comment``, which is one for certain on a line of its own, after a call and after a colon."""
    before = line.code[: match.start("sign")].strip()
    is_sure = not before or (depth(before) == 0 and (before.endswith(":") or _CALL.fullmatch(before) is not None))
    edits = ((*match.span("sign"), "#"),) if is_sure else ()
    shown = line.text[match.end("sign") :].strip()
    return Told("a comment begins with #", f"write # {shown}".rstrip(), match.span("sign"), edits)


_CALL = re.compile(r"[a-z_]+\(.*\)")


def old_comment(line: Line, match: re.Match[str]) -> Told | None:
    """A comment that begins with --, ;, ' or REM."""
    if match["sign"] == "'" and "unterminated" not in line.fault:
        return None
    return Told("a comment begins with #", "write # at its beginning", match.span("sign"))


def second_half(_: Line, match: re.Match[str]) -> Told:
    help = "a rung has no else: write another rung with the opposite condition, if nc(c.A):"
    return Told("else stands on a line of its own, and a rung has none", help, match.span("word"))


def semicolon(line: Line, _: re.Match[str]) -> Told | None:
    """``copy(5; ds.A)``"""
    depths = accumulate((sign in "([{") - (sign in ")]}") for sign in line.code)
    place = next(
        (at for at, (sign, depth) in enumerate(zip(line.code, depths, strict=True)) if sign == ";" and depth > 0), None
    )
    if place is None:
        return None
    edit = (place, place + 1, ",")
    text = without(line, [edit]).strip().rstrip(";")
    is_right = fits_action(line.context, text)
    help = f"write {text}" if is_right else "write copy(5, ds.A)"
    return Told("arguments are separated by commas", help, edit[:2], (edit,) if is_right else ())
