"""The names of the files that belong to an address table."""

from __future__ import annotations

import os
from pathlib import Path

TABLE_NAME = "nicknames.csv"
"""The address table beside a program, if none is named."""
_WORKBOOKS = (".xlsx", ".xlsm")


def is_workbook(path: Path) -> bool:
    """True for a file that is read as a workbook, judged by the end of its name."""
    return path.suffix.lower() in _WORKBOOKS


def record_beside(table: Path) -> Path:
    """The record of a table: ``nicknames.placed`` beside the real place of ``nicknames.csv``."""
    place = Path(os.path.realpath(table)) if table.is_symlink() else table
    return place.with_suffix(".placed")
