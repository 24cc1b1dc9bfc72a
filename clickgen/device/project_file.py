"""CLICK's own files: recognizes projects, program files, captures, and other files given in place of a program.

The marks are in click-facts [click-file.captures, click-file.program, click-file.project].
"""

from __future__ import annotations

import io
import os
import re
import shlex

_MARKS = (b"SC-PRJ", b"scp.bin.zi")
"""Each alone marks a project: some have both, some only the first."""
_MEMBERS_MAX = 64
_ENDING = ".ckp"
PROGRAM_MAGIC = b"SC-SCR  "
CLIPBOARD_MAGIC = b"CLICK   "
_ARCHIVES = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")
"""An archive, such as a workbook, and the form of older Office files."""

ONLY_CLICK = "a project of CLICK, which only CLICK opens"
CLICKS_LADDER = (
    "the folder of the Scr*.tmp files that CLICK keeps of an open project, or rungs copied to the clipboard and saved "
    "by ClickNick"
)


def no_program(data: bytes, name: str) -> tuple[str, str] | None:
    """Return the kind of a file given in place of a program, and the way out; None for what may be a program."""
    ending = os.path.splitext(name)[1].casefold()
    is_text = b"\0" not in data[:4096] and not data.startswith(_ARCHIVES)
    if is_click_project(data, name):
        return ONLY_CLICK, f"open it there, and give clickgen import {CLICKS_LADDER}"
    if data.startswith((PROGRAM_MAGIC, CLIPBOARD_MAGIC)) or (
        not is_text and re.fullmatch(r"scr[0-9]+\.(tmp|scr)", os.path.basename(name), re.IGNORECASE)
    ):
        kind = "a capture of CLICK's clipboard" if data.startswith(CLIPBOARD_MAGIC) else "a program file of CLICK"
        return kind, f"make a program of it: clickgen import {shlex.quote(name)} -o prog.py"
    if ending == ".adpro":
        return "a project of other programming software", "clickgen reads what CLICK makes: see clickgen import --help"
    if data.startswith(_ARCHIVES):
        way = "name the program, and an I/O list in a workbook after --nicknames"
        return ("a workbook", way) if ending in (".xlsx", ".xlsm", ".xls") else ("an archive or a workbook", way)
    if ending == ".csv" and is_text:
        start = data[:4096].removeprefix(b"\xef\xbb\xbf").lstrip(b"# ").lower()
        if start.startswith(b"marker,"):
            return "a ladder file", f"make a program of it: clickgen import {shlex.quote(name)} -o prog.py"
        if start.startswith((b"address,", b'"address"')):
            return "an address table", f"name the program, and the table after it: --nicknames {shlex.quote(name)}"
    return None


def is_click_project(data: bytes, name: str = "") -> bool:
    """True for the bytes of a project, or for a file that is named like one."""
    if name.casefold().endswith(_ENDING) or data.startswith(_MARKS[0]):
        return True
    # A comment in a text may hold a mark.
    if b"\0" in data and any(mark in data for mark in _MARKS):
        return True
    return data.startswith(b"PK\x03\x04") and _has_project(data)


def _has_project(data: bytes) -> bool:
    """True for an archive with a member that begins like a project."""
    # Few programs are archives.
    import zipfile
    import zlib

    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for member in archive.infolist()[:_MEMBERS_MAX]:
                with archive.open(member) as file:
                    if file.read(len(_MARKS[0])) == _MARKS[0]:
                        return True
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError, EOFError, ValueError, zlib.error):
        pass  # damaged, encrypted, or packed in an unknown way
    return False
