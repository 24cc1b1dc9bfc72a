"""The record of the names that clickgen placed: a line ``DS5 Speed`` for each, in a file beside the address table.

CLICK's form has no room for who named an address. ``clickgen nicknames sync --prune`` removes what stands here and
nothing else; without the file nothing is removed. A line ``left DS5 for DS9`` says that the name of DS9 was new in the
build in which no program used that of DS5 any more: perhaps somebody renamed it in the text.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from clickgen.device.banks import Address, parse_address
from clickgen.resolve.rows import Row

_LEFT = re.compile(r"left (\S+) for (\S+)")
_HEAD = "# Names that clickgen placed. Commit this file with the address table."


def record_beside(table: Path) -> Path:
    """Where the record of a table stands: ``nicknames.placed`` beside ``nicknames.csv``, where that really is."""
    place = Path(os.path.realpath(table)) if table.is_symlink() else table
    return place.with_suffix(".placed")


def placed_in(data: bytes | None) -> dict[Address, str]:
    """The nickname that clickgen gave to each address; lines that say no such thing are passed over."""
    placed: dict[Address, str] = {}
    for line in (data or b"").decode("utf-8", "replace").splitlines():
        word, _, nickname = line.partition(" ")
        address = parse_address(word)
        if address is not None and nickname:
            placed[address] = nickname
    return placed


def left_in(data: bytes | None) -> dict[Address, Address]:
    """By the address of each name that came when another one left its program: the address where that one stays."""
    lines = (data or b"").decode("utf-8", "replace").splitlines()
    found = (_LEFT.fullmatch(line) for line in lines)
    pairs = ((parse_address(match[2]), parse_address(match[1])) for match in found if match)
    return {came: left for came, left in pairs if came is not None and left is not None}


def record_of(placed: Mapping[Address, str], left: Mapping[Address, Address] | None = None) -> bytes:
    """The file, in CLICK's order. Of ``left`` it keeps what speaks of names that are in it."""
    lines = [f"{address} {placed[address]}" for address in sorted(placed, key=lambda address: address.sort_key)]
    pairs = sorted((left or {}).items(), key=lambda pair: pair[0].sort_key)
    lines += [f"left {old} for {new}" for new, old in pairs if old in placed and new in placed]
    return "\n".join((_HEAD, *lines, "")).encode()


def with_placed(data: bytes | None, rows: Iterable[Row], left: Mapping[Address, Address] | None = None) -> bytes | None:
    """The record with these rows in it, and with the names that left for them; as it is where it has them."""
    placed, known = placed_in(data), left_in(data)
    new = {row.address: row.nickname for row in rows if placed.get(row.address) != row.nickname}
    gone = {came: old for came, old in (left or {}).items() if known.get(came) != old}
    return record_of(placed | new, known | gone) if new or gone else data
