"""Problems of one formula, placed by character offsets into its string."""

from __future__ import annotations

from dataclasses import dataclass, field

from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import EmbeddedText


@dataclass
class Report:
    """The problems of one formula so far."""

    text: EmbeddedText
    target: str = ""
    """The destination of the result, as the person wrote it."""
    problems: Diagnostics = field(default_factory=Diagnostics)

    def add(self, code: str, start: int, end: int, message: str, help: str = "") -> None:
        """Add a problem of ``text.value[start:end]``."""
        self.problems.add(code, self.text.span(start, end), message, help)
