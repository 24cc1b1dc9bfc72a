"""Instructions in the form of CLICK's own files: a class, a type and numbered fields; and as laddercodec writes them.

A blob of the clipboard is read here without laddercodec, every byte of it, so that two of them are equal exactly when
their bytes are (the form: laddercodec 0.2.2, instructions/raw.py).
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

UNINDEXED = 0xFFFFFFFF
"""The slot of a field that is not part of an array."""


class BlobFault(Exception):
    """Bytes that are not a blob."""


class Field(NamedTuple):
    """One field of an instruction; ``slot`` is its place in an array, UNINDEXED outside of one."""

    tag: int
    slot: int
    value: str

    @property
    def name(self) -> str:
        """The name in laddercodec's ``raw(...)``: ``3a05``, ``3a05[2]``."""
        return f"{self.tag:04x}" if self.slot == UNINDEXED else f"{self.tag:04x}[{self.slot}]"


class Head(NamedTuple):
    """The kind of an instruction: CLICK's class, its type, and the number and numbers of its parts."""

    name: str
    type: int
    parts: int
    numbers: bytes


class _Blob(NamedTuple):
    head: Head
    fields: tuple[Field, ...]


class Blob(_Blob):
    """One instruction."""

    @cached_property
    def values(self) -> Mapping[tuple[int, int], str]:
        """Each field's value by its tag and slot."""
        return {(field.tag, field.slot): field.value for field in self.fields}

    def value(self, tag: int) -> str:
        """The value of a field outside of arrays; "" without one."""
        return self.values.get((tag, UNINDEXED), "")


def read_blob(data: bytes, start: int) -> tuple[Blob, int]:
    """Return the instruction at a place, and the place after it. Raises BlobFault."""
    try:
        name, at = _text(data, start)
        type_, parts = struct.unpack_from("<IH", data, at)
        at += 6
        numbers = data[at : at + max(parts - 1, 0)]
        at += max(parts - 1, 0)
        [count] = struct.unpack_from("<I", data, at)
        at += 4
        fields = []
        for _ in range(count):
            tag, index = struct.unpack_from("<HI", data, at)
            value, at = _text(data, at + 6)
            fields.append(Field(tag, index, value))
    except struct.error as error:
        raise BlobFault("an instruction is cut off") from error
    return Blob(Head(name, type_, parts, numbers), tuple(fields)), at


def _text(data: bytes, start: int) -> tuple[str, int]:
    """A text of two bytes for each character, up to its NUL."""
    at = data.find(b"\0\0", start)
    while at >= 0 and (at - start) % 2:
        at = data.find(b"\0\0", at + 1)
    if at < 0:
        raise BlobFault("a text without an end")
    return data[start:at].decode("utf-16-le", "surrogatepass"), at + 2
