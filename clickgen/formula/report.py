"""Problems of one formula, placed by character offsets into its string."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import EmbeddedText

Foreign = Callable[[str, Sequence[str], str], str]
"""What a function of another machine is here: its word, its arguments as written, and where the result goes.

Without arguments it gives an example; "" is for a word that nobody knows.
"""


def unknown(*_: object) -> str:
    """Nothing of any word."""
    return ""


@dataclass
class Report:
    """The problems of one formula so far."""

    text: EmbeddedText
    target: str = ""
    """Where the result goes, as the person wrote it."""
    foreign: Foreign = unknown
    problems: Diagnostics = field(default_factory=Diagnostics)

    def add(self, code: str, start: int, end: int, message: str, help: str = "", instead: str = "") -> None:
        """Add a problem of ``text.value[start:end]``, and the fix that puts a text ``instead`` of it."""
        span = self.text.span(start, end)
        # What the source escapes is no text to be replaced.
        is_plain = self.text.source.text_of(span) == self.text.value[start:end]
        fix = Fix((Edit(span, instead),)) if instead and is_plain else None
        self.problems.add(code, span, message, help, fix=fix)

    def forget(self, start: int, end: int) -> None:
        """Leave out what was said of this stretch: the whole that it is a part of is wrong."""
        inside = self.text.span(start, end)
        first, last = inside[1:3], inside[3:5]
        self.problems.found = [
            one for one in self.problems.found if one.span is None or one.span[1:3] < first or one.span[3:5] > last
        ]
