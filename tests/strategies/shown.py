"""How Hypothesis prints what was generated."""

from __future__ import annotations

from typing import Protocol


class Printer(Protocol):
    def text(self, obj: str) -> None: ...


class ShownAsText:
    """Printed as its text. Printing how it was made would take time exponential in the depth of the strategies."""

    @property
    def text(self) -> str:
        raise NotImplementedError

    def _repr_pretty_(self, printer: Printer, _cycle: bool) -> None:
        printer.text(f"\n{self.text}")
