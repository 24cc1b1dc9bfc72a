"""The problem that stops an import, with its place."""

from __future__ import annotations


class LadderProblem(Exception):
    """Something that cannot be kept: the file as shown, the place in it, and why.

    ``row`` is the line (from 1; 0 if the file has none, or the problem is about all of it), ``rung`` the number of the
    rung in its routine (from 1; 0 if it belongs to none). ``code`` is that of the import's problem.
    """

    def __init__(self, message: str, file: str, row: int = 0, rung: int = 0, code: str = "CG701") -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.file = file
        self.row = row
        self.rung = rung

    def in_rung(self, rung: int) -> LadderProblem:
        """Return the same problem, for the rung with this number."""
        return LadderProblem(self.message, self.file, self.row, rung, self.code)

    @property
    def place(self) -> str:
        """``main.csv:45``, or ``main.scr: rung 12`` in a file without lines."""
        if self.row:
            return f"{self.file}:{self.row}"
        return f"{self.file}: rung {self.rung}" if self.rung else self.file

    def __str__(self) -> str:
        return f"{self.place}: {self.message}"
