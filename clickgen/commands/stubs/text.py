"""Pieces of stub files: functions, classes, documentation, names."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

WIDTH = 120


@dataclass(frozen=True)
class Argument:
    """One parameter of a function; without a default it must be given."""

    name: str
    type: str
    default: str = ""

    def __str__(self) -> str:
        return f"{self.name}: {self.type}" + (f" = {self.default}" if self.default else "")


@dataclass(frozen=True)
class Signature:
    """The parameters of a function: those by position or name, and those by name alone."""

    positional: tuple[Argument, ...] = ()
    named: tuple[Argument, ...] = ()
    is_method: bool = False

    def written(self) -> list[str]:
        first = ["self"] if self.is_method else []
        star = ["*"] if self.named else []
        return [*first, *map(str, self.positional), *star, *map(str, self.named)]


def function_text(name: str, parameters: Sequence[str], returns: str, doc: str = "") -> str:
    """A function without a body, with one parameter to a line where one line is too short for all."""
    head = f"def {name}({', '.join(parameters)}) -> {returns}:"
    if len(head) > WIDTH - len("     ..."):
        lines = "".join(f"    {parameter},\n" for parameter in parameters)
        head = f"def {name}(\n{lines}) -> {returns}:"
    return f"{head}\n{indented(docstring(doc))}" if doc else f"{head} ...\n"


def overloads_text(name: str, signatures: Sequence[Signature], returns: str, doc: str) -> str:
    """A function with all of its signatures; each carries the documentation, because editors show one at a time."""
    mark = "@overload\n" if len(signatures) > 1 else ""
    return "".join(mark + function_text(name, signature.written(), returns, doc) for signature in signatures)


def class_text(name: str, base: str, doc: str, members: Iterable[str] = ()) -> str:
    """A class with documentation and members."""
    head = f"class {name}({base}):" if base else f"class {name}:"
    return f"{head}\n{indented(docstring(doc) + ''.join(members))}"


def docstring(text: str) -> str:
    """Quote any text as the documentation of what it is in or under."""
    escaped = text.replace("\\", "\\\\")
    escaped = re.sub(r'"{2,}|"$', lambda quotes: quotes[0].replace('"', '\\"'), escaped)
    plain = "".join(c if c.isprintable() or c == "\n" else c.encode("unicode_escape").decode() for c in escaped)
    return f'"""{plain}"""\n'


def indented(text: str) -> str:
    return "".join(f"    {line}" if line.strip() else line for line in text.splitlines(keepends=True))


def is_attribute(name: str) -> bool:
    """True for a nickname that can follow a dot."""
    return name.isidentifier() and not keyword.iskeyword(name)
