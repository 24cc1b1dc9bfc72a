"""The record of the names that clickgen placed: a line ``DS5 Speed`` for each, in a file beside the address table.

CLICK's form has no room for who named an address. ``clickgen nicknames sync --prune`` removes only names in this
record; without the file it removes nothing. A line ``left DS5 for DS9`` says that the name of DS9 was new in the
build in which no program used that of DS5 any more: perhaps somebody renamed it in the text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from clickgen.device.banks import Address, parse_address
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import Row
from clickgen.workspace import CouldNotRun, Workspace, leads_elsewhere

_LEFT = re.compile(r"left (\S+) for (\S+)")
_HEAD = "# Names that clickgen placed. Commit this file with the address table."


def read_record(path: Path, workspace: Workspace | None = None) -> bytes | None:
    """Return the bytes of a record; None if there is none.

    Raises CouldNotRun for a link to another place, and for a file that is not a record: clickgen would overwrite it.
    """
    if leads_elsewhere(path):
        raise CouldNotRun(f"{path} is a link to another place; clickgen keeps its own record there: take the link away")
    try:
        data = (workspace or Workspace()).look(path)
    except OSError as error:
        raise CouldNotRun(f"{path} cannot be read: {error.strerror or error}") from None
    lines = _lines(data)
    if _HEAD not in lines and not all(line.startswith("#") or _entry(line) or _left(line) for line in lines):
        raise CouldNotRun(
            f"{path} is not the record of clickgen, which is kept under this name: give the file another name"
        )
    return data


def placed_in(data: bytes | None) -> dict[Address, str]:
    """The nickname that clickgen gave to each address; other lines are skipped."""
    return dict(entry for line in _lines(data) if (entry := _entry(line)))


def placed_still(data: bytes | None, table: AddressTable) -> frozenset[Address]:
    """The addresses of the names that clickgen placed and that the table still has."""
    rows = table.by_address
    return frozenset(at for at, name in placed_in(data).items() if at in rows and rows[at].nickname == name)


def left_in(data: bytes | None) -> dict[Address, Address]:
    """The address of each name that came when another one left its program, with the address of the one that left."""
    return dict(pair for line in _lines(data) if (pair := _left(line)))


def record_of(
    placed: Mapping[Address, str], left: Mapping[Address, Address] | None = None, data: bytes | None = None
) -> bytes:
    """Return the file, in CLICK's order. Of ``left`` it keeps the lines about names that are in it.

    Anything else that a person wrote into the former file, ``data``, stays in it.
    """
    others = [line for line in _lines(data) if line != _HEAD and not _entry(line) and not _left(line)]
    lines = [f"{address} {placed[address]}" for address in sorted(placed, key=lambda address: address.sort_key)]
    pairs = sorted((left or {}).items(), key=lambda pair: pair[0].sort_key)
    lines += [f"left {old} for {new}" for new, old in pairs if old in placed and new in placed]
    return "\n".join((_HEAD, *others, *lines, "")).encode("utf-8", "surrogateescape")


def _lines(data: bytes | None) -> list[str]:
    return [line for line in (data or b"").decode("utf-8", "surrogateescape").splitlines() if line.strip()]


def _entry(line: str) -> tuple[Address, str] | None:
    word, _, nickname = line.partition(" ")
    address = parse_address(word)
    return (address, nickname) if address is not None and nickname else None


def _left(line: str) -> tuple[Address, Address] | None:
    match = _LEFT.fullmatch(line)
    old, new = (parse_address(match[1]), parse_address(match[2])) if match else (None, None)
    return (new, old) if new is not None and old is not None else None


def with_placed(data: bytes | None, rows: Iterable[Row], left: Mapping[Address, Address] | None = None) -> bytes | None:
    """Add these rows to the record, and the names that left for them; unchanged if it has them already."""
    placed, known = placed_in(data), left_in(data)
    new = {row.address: row.nickname for row in rows if placed.get(row.address) != row.nickname}
    gone = {came: old for came, old in (left or {}).items() if known.get(came) != old}
    return record_of(placed | new, known | gone, data) if new or gone else data
