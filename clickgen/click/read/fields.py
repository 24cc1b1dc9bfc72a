"""Compares an instruction of a file with what laddercodec writes for it, and finds the first difference."""

from __future__ import annotations

from clickgen.click.read.blobs import UNINDEXED, Blob, Field
from clickgen.click.read.harmless import MEANINGS, reason_for


def first_difference(said: Blob, made: Blob) -> str:
    """The first field of a clipboard's instruction that counts and differs; "" if there is none."""
    if said.head != made.head:
        return f"{said.head.name} is read as {made.head.name}, or is of another type"
    if len(said.fields) != len(made.fields):
        return f"{said.head.name} has {len(said.fields)} fields, and {len(made.fields)} are read"
    for one, other in zip(said.fields, made.fields, strict=True):
        if one != other and not reason_for(one, other, said, made):
            return told(said.head.name, one, other.value)
    return _unnumbered(said, made)


def _unnumbered(said: Blob, made: Blob) -> str:
    """An array that CLICK numbers and laddercodec does not must be numbered consecutively."""
    counts: dict[int, int] = {}
    for one, other in zip(said.fields, made.fields, strict=True):
        if one.slot != other.slot and other.slot == UNINDEXED:
            if one.slot != counts.get(one.tag, 0):
                return told(said.head.name, one, other.value)
            counts[one.tag] = one.slot + 1
    return ""


def told(name: str, said: Field, made: str) -> str:
    """A difference in words."""
    meaning = f" ({MEANINGS[said.tag]})" if said.tag in MEANINGS else ""
    return f"{name} has {said.value!r} in its field {said.name}{meaning}, and {made!r} is read"
