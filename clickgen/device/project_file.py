"""CLICK's own project file, ``.ckp``: how it is known. Only CLICK reads what is in it
(click-facts [click-file.project])."""

from __future__ import annotations

import io
import zipfile
import zlib

_MARKS = (b"SC-PRJ", b"scp.bin.zi")
"""Each alone marks a project: some have both, some the first alone."""
_MEMBERS_MAX = 64
_ENDING = ".ckp"


def is_click_project(data: bytes, name: str = "") -> bool:
    """True for the bytes of a project, or for a file that is named like one."""
    if name.casefold().endswith(_ENDING) or data.startswith(_MARKS[0]):
        return True
    # A comment of a text may hold a mark.
    if b"\0" in data and any(mark in data for mark in _MARKS):
        return True
    return data.startswith(b"PK\x03\x04") and _has_project(data)


def _has_project(data: bytes) -> bool:
    """True for an archive with a member that begins as a project does."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for member in archive.infolist()[:_MEMBERS_MAX]:
                with archive.open(member) as file:
                    if file.read(len(_MARKS[0])) == _MARKS[0]:
                        return True
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError, EOFError, ValueError, zlib.error):
        pass  # damaged, encrypted, or packed in a way that is not known
    return False
