"""Makes a CLICK program file (``Scr*.tmp``) from rows of ladder, in the form that laddercodec's manual describes.

It knows contacts, out, call, return and end: enough for every shape of a rung and every order of routines.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable, Sequence

_INSTRUCTIONS = (
    (re.compile(r"(?:T:)?([A-Z]+\d+)"), "ContactNO", 0x2711, 0x6065),
    (re.compile(r"(?:T:)?~([A-Z]+\d+)"), "ContactNO", 0x2712, 0x6065),
    (re.compile(r"out\((\w+)\)"), "Out", 0x2715, 0x6066),
    (re.compile(r'call\("(.*)"\)'), "Call", 0x2723, 0x6208),
    (re.compile(r"return\(\)()"), "Return", 0x2724, 0),
    (re.compile(r"end\(\)()"), "End", 0x2727, 0),
    (re.compile(r"mystery\(\)()"), "Mystery", 0x2777, 0),
)
_MAIN = 1


def program_file(name: str, index: int, rungs: Iterable[tuple[str, Sequence[Sequence[str]]]]) -> bytes:
    """Each rung is a comment and rows of 32 cells, the output last. An empty rung follows, as CLICK keeps one."""
    all_rungs = [*rungs, ("", [[""] * 32])]
    data = bytearray(b"SC-SCR  ".ljust(0x40, b"\0") + struct.pack("<H", index))
    data += _text(name) + struct.pack("<H", 32) + struct.pack("<H", 65) * 32 + b"\x0d"
    data += struct.pack("<H", len(all_rungs))
    for number, (comment, rows) in enumerate(all_rungs):
        rtf = _rtf(comment) if comment else b""
        data += struct.pack("<HI", number, len(rtf)) + rtf + _wires(rows)
        found = [(row, column, cell) for row, cells in enumerate(rows, 1) for column, cell in enumerate(cells)]
        placed = [(row, column, one) for row, column, cell in found if (one := _instruction(cell))]
        data += struct.pack("<H", len(placed)) + (struct.pack("<I", 0x90) if placed else b"")
        for sequence, (row, column, (kind, code, tag, operand)) in enumerate(placed):
            data += bytes((row, column, 1, 1, sequence, 0, 0, 0)) + _text(kind) + struct.pack("<H", code)
            data += bytes(6) + b"\x01" + bytes((sequence,))
            fields = struct.pack("<H", tag) + _text(operand) if tag else b""
            data += struct.pack("<I", len(data) + 4 + len(fields) + 2) + fields + b"\0\0" + b"\0\0"
    return bytes(data) + (b"\x3b\x0e" if index == _MAIN else b"")


def _text(text: str) -> bytes:
    """Encode a text; the NUL after it has one byte."""
    data = text.encode("utf-16-le") + b"\0"
    return bytes((len(data),)) + data


def _rtf(comment: str) -> bytes:
    head = rb"{\rtf1\ansi\ansicpg1252\deff0\deflang1033{\fonttbl{\f0\fnil\fcharset0 Arial;}}"
    body = comment.replace("\n", "\r\n\\par ").encode("cp1252")
    return head + b"\r\n\\viewkind4\\uc1\\pard\\fs20 " + body + b"\r\n\\par }\r\n"


def _wires(rows: Sequence[Sequence[str]]) -> bytes:
    """Encode the rows, of which the first is the comment's, then for each column those with a wire down."""
    data = struct.pack("<H", len(rows) + 1) + b"\x03\0\0"
    for cells in rows:
        right = [column for column, cell in enumerate(cells) if cell not in ("", "|")]
        data += struct.pack("<BH", 1, len(right)) + b"".join(bytes((1, column)) for column in right)
    data += struct.pack("<H", 32)
    for column in range(32):
        down = [row for row, cells in enumerate(rows, 1) if cells[column] in ("T", "|") or cells[column][:2] == "T:"]
        data += struct.pack("<H", len(down)) + bytes(down)
    return data


def _instruction(cell: str) -> tuple[str, int, int, str] | None:
    for pattern, kind, code, tag in _INSTRUCTIONS:
        match = pattern.fullmatch(cell)
        if match:
            return kind, code, tag, match[1]
    return None
