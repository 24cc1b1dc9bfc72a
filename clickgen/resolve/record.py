"""The record of the names that clickgen placed: a line ``DS5 Speed`` for each, in a file beside the address table.

CLICK's form has no room for who named an address. ``clickgen nicknames sync --prune`` removes what stands here and
nothing else; without the file nothing is removed.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from clickgen.device.banks import Address, parse_address
from clickgen.resolve.rows import Row

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


def record_of(placed: dict[Address, str]) -> bytes:
    """The file, in CLICK's order."""
    lines = [f"{address} {placed[address]}" for address in sorted(placed, key=lambda address: address.sort_key)]
    return "\n".join((_HEAD, *lines, "")).encode()


def with_placed(data: bytes | None, rows: Iterable[Row]) -> bytes | None:
    """The record with these rows in it; as it is where it has them."""
    placed = placed_in(data)
    new = {row.address: row.nickname for row in rows if placed.get(row.address) != row.nickname}
    return record_of(placed | new) if new else data
