"""What a file is: a program of the language, a part of one, or other Python that is left alone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from clickgen.dialects.base import Look


class FileLook(Look):
    """What a look at a file tells, found out when it is asked for."""

    def __init__(self, text: str) -> None:
        self._text = text

    @cached_property
    def _code(self) -> str:
        return _code_of(self._text)

    @cached_property
    def is_program(self) -> bool:
        return _is_program(self._code)

    @cached_property
    def has_main(self) -> bool:
        # A text in quotes may show a main.
        return bool(_MAIN.search(self._text) and _MAIN.search(self._code))

    @cached_property
    def imports(self) -> tuple[str, ...]:
        """The names of the files beside it that it imports; not all of them need be there."""
        return tuple(dict.fromkeys(_siblings(self._text)))


# fmt: off
BANK_WORDS = frozenset((
    "x", "y", "c", "t", "ct", "sc", "ds", "dd", "dh", "df", "xd", "yd", "td", "ctd", "sd", "txt",
))
CALL_WORDS = frozenset((
    "calc", "call", "copy", "copy_block", "copy_fill", "copy_pack", "copy_unpack", "ctd", "ctu", "ctud", "end",
    "event_drum", "math_hex", "next_loop", "nickname", "not_imported", "out", "raw", "receive", "reset", "rtof", "rton",
    "search", "send", "set", "shift", "time_drum", "tof", "ton",
))
# fmt: on
_OWN_WORDS = BANK_WORDS | CALL_WORDS | {"sub"}
_BUILTINS = {"set"}
"""What every Python program may call."""

_ESCAPED = re.compile(r"\\[^\n]")
_TEXTS = re.compile(
    r"""(?=["'#<=>|])(?:"""
    r'"""[^"]*+(?:"(?!"")[^"]*+)*+"""'
    r"|'''[^']*+(?:'(?!'')[^']*+)*+'''"
    r'|"[^"\n]*+"'
    r"|'[^'\n]*+'"
    r"|#[^\n]*"
    r"|^(?:<{7}|={7}|>{7}|\|{7})(?: [^\n]*)?$)",
    re.MULTILINE | re.DOTALL,
)
"""Everything that is not code: texts in quotes, comments, the marks of a merge. See ``_code_of``."""


def _code_of(text: str) -> str:
    """The code in a text. An escaped quote ends no text; without those, no look for an end is ever repeated."""
    return _TEXTS.sub("", _ESCAPED.sub("__", text) if "\\" in text else text)


_NAME = re.compile(r"([A-Za-z_@.]\w*)([\w.]*)[ \t]*([\[(]?)")
"""A name, what hangs on it with dots, and the bracket behind. One behind a dot or an @ is no name of its own."""
_MAKING = re.compile(r"(?:def|class|import)[ \t]+(\w+)")

# What few files need is compiled when they do: a repeated check is over before all of it would be.
_SUB = r"(?m)^@sub[ \t]*(?:\([\s,]*\)[ \t]*)?$"
"""Also ``@sub("Auto Mode")``, of which the text is gone."""
_ROUTINE = r"(?m)^(?:(?:async[ \t]+)?def[ \t]+main\b|@sub\b|nickname\b|\w+[ \t]*\(\s*\w+[.\[])"
_EDITOR = r"(?m)^from[ \t]+clickgen\.dsl[ \t]+import\b"
_STAR = r"import[ \t]*\*"
_FIRST_INDENT = r"(?m)^([ \t]+)\S"
_RUNG = rf"(?:if|for|pass|{'|'.join(sorted(CALL_WORDS))})\b|[)\]}}]"


def is_program(text: str) -> bool:
    """True for a text that looks like clickgen's, valid or broken. Other Python is left alone.

    Python has to make a name before it uses it; clickgen has its banks and instructions without that. So a file is
    clickgen's when it uses one of them, ``c.Auto``, ``y[1]`` or ``out(...)``, and nowhere makes a name like it. That
    holds however broken the rest is.
    """
    return _is_program(_code_of(text))


def _is_program(code: str) -> bool:
    """``is_program`` of a text without what is in quotes."""
    if "clickgen.dsl" in code and re.search(_EDITOR, code):
        return True
    has_routine = "\ndef main(" in code or re.search(_ROUTINE, code) is not None
    is_plain = has_routine and not ("*" in code and re.search(_STAR, code))
    return (is_plain or _is_made_of_rungs(code)) and _uses_own_words(code)


def _uses_own_words(code: str) -> bool:
    used: set[str] = set()
    made: set[str] = _BUILTINS.union(_MAKING.findall(code))
    for word, rest, bracket in set(_NAME.findall(code)):
        if word in _OWN_WORDS:
            is_own = word in BANK_WORDS and _is_cell(rest[1:], bracket) if rest else _is_own(word, bracket)
            (used if is_own else made).add(word)
    return bool(used - made) or ("sub" not in made and re.search(_SUB, code) is not None)


def _is_cell(rest: str, bracket: str) -> bool:
    """True for what stands behind the dot of ``c.Name``, also with a modifier behind it; not for a method."""
    nickname, dot, modifier = rest.partition(".")
    return modifier.startswith(("immediate", "as_")) if dot else bool(nickname) and not bracket


def _is_own(word: str, bracket: str) -> bool:
    return (bracket == "[" and word in BANK_WORDS) or (bracket == "(" and word in CALL_WORDS)


def _is_made_of_rungs(code: str) -> bool:
    """True when most statements are a rung's. It decides where there is no main or @sub, or an ``import *``."""
    indent = re.search(_FIRST_INDENT, code)
    inner: list[str] = re.findall(rf"^{indent[1]}(?=\S)(.*)", code, re.MULTILINE) if indent else []
    return len(inner) < 2 * sum(re.match(_RUNG, line) is not None for line in inner)


# -- what stands in a file --------------------------------------------------------------------------------------------

_MAIN = re.compile(r"^(?:async[ \t]+)?def[ \t]+main\b", re.MULTILINE)
_IMPORT = re.compile(r"^[ \t]*(?:from[ \t]+(?:\.[ \t]*)?(\w+)[ \t]+import\b|import[ \t]+([\w., \t]+))", re.MULTILINE)


def _siblings(text: str) -> Iterator[str]:
    """The files that a file's imports stand for."""
    for source, listed in _IMPORT.findall(text):
        for name in (source, *listed.split(",")):
            module = name.split()[0] if name.strip() else ""
            if module and "." not in module:
                yield f"{module}.py"
