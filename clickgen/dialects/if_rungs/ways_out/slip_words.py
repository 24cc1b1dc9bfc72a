"""Conditions in words or without any, which Python cannot read: ``ds.A between 1 and 5``, ``x[1] x[2]``."""

from __future__ import annotations

import re

from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.ways_out.slip_line import Line, Told, after_head, condition_of, without
from clickgen.ir.addresses import BANK_NAMES

_BANKS = "|".join(sorted(BANK_NAMES, key=len, reverse=True))
_ADDRESS = rf"\b(?:{_BANKS})(?:\[[^\[\]]{{1,60}}\]|\.[A-Za-z_]\w{{0,40}})"
_OPERAND = rf"(?:{_ADDRESS}|-?\d[\w.]{{0,20}}|\"[^\"]{{0,20}}\")"

BETWEEN = re.compile(
    rf"(?P<value>{_ADDRESS})\s+(?:is\s+)?(?P<not>not\s+)?(?:between|within|from)\b\s*\(?\s*(?P<low>{_OPERAND})"
    rf"\s*(?:\band\b|\bto\b|,)\s*(?P<high>{_OPERAND})\s*\)?",
    re.IGNORECASE,
)
_MORE, _LESS = "greater|more|bigger|higher|larger|above|over", "less|lower|smaller|fewer|below|under"
COMPARED = re.compile(
    rf"(?P<value>{_ADDRESS})\s+(?:is\s+)?(?:(?P<unlike>not\s+equals?|differs?\s+from)|(?P<equal>equals?)"
    rf"|(?P<least>at\s+least)|(?P<most>at\s+most)|(?P<more>{_MORE})|(?P<less>{_LESS}))(?:\s+than)?(?:\s+to)?"
    rf"(?P<or>\s+or\s+equals?(?:\s+to)?)?\s+(?P<other>{_OPERAND})",
    re.IGNORECASE,
)
STATE = re.compile(
    rf"(?P<value>{_ADDRESS})\s+(?:is\s+)?(?P<not>not\s+)?(?P<state>on|off|true|false)\b(?!\s*[(.\[])", re.IGNORECASE
)
HALF = re.compile(
    rf"(?P<value>{_ADDRESS})\s*(?:[<>]=?|==|!=)\s*{_OPERAND}\s+(?:and|or)\s+(?P<place>)(?=[<>]=?|==|!=)", re.IGNORECASE
)
HEAD = re.compile(r"^\s*(?:if|elif|while)\b")
GAP = re.compile(rf"(?<=[\w\])\"])(?P<gap>\s+)(?=(?:{_BANKS})[\[.]|(?:all|any|nc|re|fe)\(|not\b)")
_JOINS = frozenset(("and", "or", "not", "in", "is", "if", "elif", "while", "else", "lambda", "then"))
LISTED = re.compile(rf"(?P<value>{_ADDRESS})\s+(?:not\s+)?in\s+(?P<list>{_OPERAND}(?:\s*,\s*{_OPERAND})+)")


def between(line: Line, match: re.Match[str]) -> Told | None:
    """``ds.A between 1 and 5``"""
    text = line.text
    edits = []
    for found in BETWEEN.finditer(line.code):
        value, low, high = (text[slice(*found.span(name))] for name in ("value", "low", "high"))
        edits.append((*found.span(), f"({'not ' if found['not'] else ''}{low} <= {value} <= {high})"))
    return _told(line, "there is no such comparison", match.span(), edits)


def compared(line: Line, match: re.Match[str]) -> Told | None:
    """``ds.A greater than 5``, ``ds.A equals 5``"""
    edits = []
    for found in COMPARED.finditer(line.code):
        sign = "!=" if found["unlike"] else "==" if found["equal"] else ">" if found["more"] else "<"
        sign = ">=" if found["least"] else "<=" if found["most"] else sign
        sign += "=" if found["or"] and len(sign) == 1 else ""
        edits.append((found.end("value"), found.start("other"), f" {sign} "))
    return _told(line, "a comparison has a sign", match.span(), edits)


def state(line: Line, match: re.Match[str]) -> Told | None:
    """``x[1] on``, ``x[1] is off``"""
    edits = [
        (found.end("value"), found.end(), f" == {(found['state'].lower() in ('on', 'true')) is not bool(found['not'])}")
        for found in STATE.finditer(line.code)
    ]
    return _told(line, "a bit is a condition by itself", match.span(), edits)


def half(line: Line, match: re.Match[str]) -> Told | None:
    """``ds.A > 5 and < 10``"""
    edits = [
        (found.start("place"), found.start("place"), f"{line.text[slice(*found.span('value'))]} ")
        for found in HALF.finditer(line.code)
    ]
    return _told(line, "each comparison names what it compares", match.span(), edits)


def listed(line: Line, match: re.Match[str]) -> Told | None:
    """``ds.A in 1, 2, 3``"""
    start, end = match.span("list")
    return _told(line, "CLICK has no such comparison", match.span(), [(start, end, f"({line.text[start:end]})")])


def _told(line: Line, message: str, at: tuple[int, int], edits: list[tuple[int, int, str]]) -> Told | None:
    help = condition_of(line, after_head(without(line, edits)))
    return Told(message, help, at) if help else None


def missing_word(line: Line, _: re.Match[str]) -> Told | None:
    """``x[1] x[2]``: in series or in parallel, which only its writer knows."""
    places = []
    for found in GAP.finditer(line.code):
        before = re.search(r"\w+$", line.code[: found.start()])
        if before is None or before[0].lower() not in _JOINS:
            places.append(found.span("gap"))
    if not places:
        return None
    ways = []
    for word in ("and", "or"):
        text = without(line, [(*at, f" {word} ") for at in places])
        ways.append(condition_of(line, after_head(text)))
    if not all(way.startswith("write if ") for way in ways):
        return None
    series, parallel = (way.removeprefix("write ") for way in ways)
    help = f"write {series} for both in series, {parallel} for one of them in parallel"
    return Told("a word is missing between two conditions", help, places[0])


# -- actions beside their condition -----------------------------------------------------------------------------------

ACTED = re.compile(
    r"^\s*(?:(?P<first>[A-Za-z_]\w*\(.*\))\s+(?:if|when|IF|WHEN)\s+(?P<after>\S.*?)"
    r"|(?:if|IF|If)\s+(?P<before>\S.*?)\s+(?:(?:then|THEN|Then)\s+)?(?P<second>[A-Za-z_]\w*\(.*\))"
    r"|(?P<left>\S.*?)\s*(?:->|=>)\s*(?P<right>[A-Za-z_]\w*\(.*\)))\s*[:;]?\s*$"
)


def acted(line: Line, match: re.Match[str]) -> Told | None:
    """``out(y[1]) if x[1]``, ``if x[1] then out(y[1])``, ``x[1] -> out(y[1])``"""
    spans = [match.span(name) for name in ("first", "second", "right", "after", "before", "left") if match[name]]
    action, test = (line.text[slice(*span)].strip() for span in spans)
    name = re.match(r"\w+", action)
    action = f"{name[0].lower()}{action[name.end() :]}" if name else action
    if not fits_action(line.context, action):
        return None
    way = condition_of(line, test)
    is_right = way.startswith("write if ")
    return Told("an action belongs under its condition", f"{way} {action}", spans[0]) if is_right else None
