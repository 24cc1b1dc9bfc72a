"""Chooses the place for a workbook, and protects what it may not replace there."""

from __future__ import annotations

import os
from pathlib import Path

from clickgen.emit.workbook import WRITER
from clickgen.workspace import CouldNotRun, Workspace


def place_of(output: str | None, program: str, folder: Path) -> Path:
    """Return the workbook that ``-o`` names, else one in the program's output folder. Raises CouldNotRun."""
    if output is None:
        return folder / f"{Path(program).stem}.xlsx"
    if Path(output).suffix.lower() != ".xlsx":
        raise CouldNotRun(f"the workbook's name must end in .xlsx, and {output or 'the name after -o'} does not")
    return Path(output)


def former(path: Path, table: str | os.PathLike[str] | None, files: Workspace) -> bytes | None:
    """Return the earlier workbook at a place; None if nothing is there.

    Raises CouldNotRun for a file that clickgen did not write, that somebody has saved since, or that is the address
    table.
    """
    if table is not None and os.path.realpath(path) == os.path.realpath(table):
        raise CouldNotRun(f"{path} is the address table; choose another file with -o")
    try:
        before: bytes | None = files.read(path)
    except (FileNotFoundError, NotADirectoryError):
        before = None
    if before is not None and not WRITER.is_own(before):
        raise CouldNotRun(
            f"{path} was not written by clickgen, or somebody has saved it since; move it away, or choose another "
            "file with -o"
        )
    return before
