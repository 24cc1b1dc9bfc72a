"""The kind of a file, by its content, whatever the file is called."""

from __future__ import annotations

import csv
from enum import Enum, auto

from clickgen.click.ladder_csv import HEADER
from clickgen.device.project_file import CLICKS_LADDER, CLIPBOARD_MAGIC, ONLY_CLICK, PROGRAM_MAGIC, is_click_project
from clickgen.table.form import without_marks
from clickgen.table.rows import COLUMNS as NICKNAME_COLUMNS

HEAD_BYTES = 4096
"""The beginning of a file that shows its kind: the first line ends in it."""


class Kind(Enum):
    """The kinds that read_project can read, and the rest."""

    LADDER = auto()
    CLIPBOARD = auto()
    PROGRAM = auto()
    OTHER = auto()


def kind_of(data: bytes) -> Kind:
    """The kind of a file. A ladder file has its own first line; one whose first line is damaged still counts as one."""
    if data.startswith(PROGRAM_MAGIC):
        return Kind.PROGRAM
    if data.startswith(CLIPBOARD_MAGIC):
        return Kind.CLIPBOARD
    is_ladder = any(field.casefold().startswith(HEADER[0]) for field in _first_line(data)[:1])
    return Kind.LADDER if is_ladder else Kind.OTHER


def other_kind(data: bytes, name: str = "") -> str:
    """The description of a file of this name that is not ladder, after ``the file is``."""
    first = _first_line(data)
    if is_click_project(data, name):
        return f"{ONLY_CLICK}: open it there, and give {CLICKS_LADDER}"
    if not data.strip(b"\x00\xef\xbb\xbf \t\r\n"):
        return "empty"
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "UTF-16 text, and a ladder file UTF-8: save it again as CSV UTF-8"
    if data.startswith((b"PK\x03\x04", b"\xd0\xcf\x11\xe0")):
        return "a workbook or an archive, not ladder"
    if tuple(map(without_marks, first[:2])) == NICKNAME_COLUMNS[:2]:
        return "a nickname table, not ladder"
    if b"\x00" in data[:HEAD_BYTES]:
        return "neither text nor anything that CLICK makes"
    return f"no ladder: its first line is not {HEADER[0]},{HEADER[1]},...,{HEADER[-1]}"


def _first_line(data: bytes) -> list[str]:
    """The fields of the first line that is not empty."""
    lines = data[:HEAD_BYTES].decode("utf-8-sig", "replace").strip().splitlines()
    return [field.strip() for field in next(csv.reader(lines[:1]), [])]
