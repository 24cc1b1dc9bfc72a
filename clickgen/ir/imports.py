"""The imports of a program file from sibling files."""

from __future__ import annotations

from clickgen.records import dataclass
from clickgen.text.source import Span


@dataclass(frozen=True, slots=True)
class Import:
    """``from auto import auto_mode``; without names, ``import wiring``, it brings only the file's declarations.

    An empty ``module`` is an import that could not be read.
    """

    module: str
    names: tuple[tuple[str, Span], ...]
    span: Span
