"""The dialects that there are, and which of them a file is written in."""

from __future__ import annotations

from functools import cache
from importlib import import_module

from clickgen.dialects.base import Dialect

NAMES = ["if_rungs"]
"""Their folders. The first is the one for files that none of them knows, and the one that an import writes."""


@cache
def named(name: str) -> Dialect:
    """A dialect by its name; it is loaded when somebody asks."""
    dialect: Dialect = import_module(f"clickgen.dialects.{name}").DIALECT
    return dialect


def default() -> Dialect:
    """The dialect of a text that no dialect knows, and of what is written anew."""
    return named(NAMES[0])


def every() -> list[Dialect]:
    """All dialects in their order."""
    return [named(name) for name in NAMES]


def suffixes() -> tuple[str, ...]:
    """How the names of programs end."""
    return tuple(dict.fromkeys(dialect.suffix for dialect in every()))


def dialect_of(path: str, text: str | bytes) -> Dialect:
    """The dialect of a file: of those with its suffix, the first that takes its text for a program."""
    those = [dialect for dialect in every() if path.endswith(dialect.suffix)] or every()
    if len(those) == 1:
        return those[0]
    shown = text.decode("utf-8", "replace") if isinstance(text, bytes) else text
    return next((one for one in those if one.look(path, shown).is_program), those[0])
