"""What stops an import, with its place."""

from __future__ import annotations


class LadderProblem(Exception):
    """Something that cannot be kept: the file as shown, the line in it (from 1), and why."""

    def __init__(self, message: str, file: str, row: int) -> None:
        super().__init__(message)
        self.message = message
        self.file = file
        self.row = row

    def __str__(self) -> str:
        return f"{self.file}:{self.row}: {self.message}"
