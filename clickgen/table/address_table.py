"""The address table: CLICK's nickname CSV, kept beside the program like a lock file.

A PLC keeps its data by address, so a name that once has an address keeps it. Reading and writing the table keeps
every row that nobody changed, byte for byte.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

from clickgen.device.banks import ORDER, Address
from clickgen.table.form import PLAIN, TableForm
from clickgen.table.rows import HEADER, Row, default_row, text_span
from clickgen.text.source import Span

BOM = b"\xef\xbb\xbf"

_FIELD = r'(?:"(?:[^"]|"")*"|[^",][^,]*|)'
"""A field as the csv module reads it: quotes count where a field begins with one."""
_NICKNAME = rf"((?:{_FIELD},){{%d}})({_FIELD})"
"""A row up to its nickname, which is in a column counted from 0, and the nickname as written."""
_NICKNAME_FIELD = 2


class Entry(NamedTuple):
    """A stretch of the file: a row, or text that is not a row (the header, a blank line, a malformed row)."""

    row: Row | None
    text: str
    end: str


@dataclass(frozen=True)
class AddressTable:
    """The rows of an address table and the exact text around them.

    ``base`` is the rows of a workbook that the table adds to: they count first, and are never written.
    """

    path: str
    _entries: tuple[Entry, ...]
    newline: str = "\n"
    """The line end of the header, which new rows take too."""
    bom: bool = False
    base: tuple[Row, ...] = ()
    form: TableForm = PLAIN

    @staticmethod
    def empty(path: str) -> AddressTable:
        """A table without rows: the header alone."""
        return AddressTable(path, (Entry(None, HEADER, "\n"),))

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """Every row: those of the workbook, then those of the file, each in its order."""
        given = {row.address for row in self.base}
        return (*self.base, *(row for row in self.own_rows if row.address not in given))

    @property
    def own_rows(self) -> tuple[Row, ...]:
        """The rows of the file itself."""
        return tuple(entry.row for entry in self._entries if entry.row is not None)

    @cached_property
    def by_nickname(self) -> dict[str, Row]:
        """The rows that have a nickname, by its lowercase form. If SC and SD rows share one, the first counts."""
        names: dict[str, Row] = {}
        for row in self.rows:
            if row.nickname:
                names.setdefault(row.nickname.lower(), row)
        return names

    @cached_property
    def spares(self) -> dict[str, Row]:
        """The words that a workbook has in place of nicknames, in lower case, each with the first row that has it."""
        spares: dict[str, Row] = {}
        for row in self.base:
            if row.spare:
                spares.setdefault(row.spare.lower(), row)
        return spares

    @cached_property
    def by_address(self) -> dict[Address, Row]:
        return {row.address: row for row in self.rows}

    def has_name(self, address: Address) -> bool:
        """True if an address has a nickname; a table may list an address without one."""
        row = self.by_address.get(address)
        return row is not None and bool(row.nickname)

    @property
    def final_newline(self) -> bool:
        return self._entries[-1].end != ""

    def span(self, row: Row) -> Span | None:
        """The place of a row, or None for a new one."""
        if row.cell is not None:
            return row.cell
        return text_span(self.path, row.line, row.raw, 0, len(row.raw)) if row.line else None

    def place(self, row: Row) -> str:
        """The place of a row in words: ``line 5 of nicknames.csv``."""
        return f"{row.cell.cell} of {row.cell.path}" if row.cell else f"line {row.line} of {self.path}"

    def named(self, address: Address, nickname: str, comment: str = "") -> Row:
        """Return a row that gives an address its nickname and keeps what an unnamed row there already says."""
        stands = self.by_address.get(address)
        if stands is None or stands.nickname:
            return default_row(address, nickname, comment)
        return replace(stands, nickname=nickname, comment=comment or stands.comment, line=0, raw="")

    def extended(self, rows: Iterable[Row]) -> AddressTable:
        """Return the table with these rows added in CLICK's row order; existing rows stay where they are.

        A row whose address is already there takes that row's place if it has no nickname or the same one; a row that
        repeats what is there changes nothing. Raises ValueError if a name or an address would move.
        """
        added: list[Row] = []
        replaced: dict[Address, Row] = {}
        names = {name: row.address for name, row in self.by_nickname.items()}
        given: dict[Address, Row] = {}
        in_base = {row.address for row in self.base}
        for row in sorted(rows, key=lambda row: row.address.sort_key):
            stands = self.by_address.get(row.address)
            if stands is not None and stands.nickname and stands.nickname != row.nickname:
                raise ValueError(f"{row.address} is {stands.nickname} and cannot become {row.nickname}")
            if row.nickname and names.setdefault(row.nickname.lower(), row.address) != row.address:
                raise ValueError(f"{row.nickname} is {names[row.nickname.lower()]} and cannot move to {row.address}")
            first = given.setdefault(row.address, row)
            if first.content != row.content:
                raise ValueError(f"{row.address} is given twice: {first.nickname} and {row.nickname}")
            if first is not row or row.address in in_base:
                continue
            if stands is None:
                added.append(replace(row, line=0, raw=""))
            elif stands.content != row.content:
                replaced[row.address] = replace(row, line=0, raw="")
        if not added and not replaced:
            return self

        places = _places(self._entries)
        at: dict[int, list[Row]] = {}
        for row in added:
            at.setdefault(places(row.address), []).append(row)
        entries: list[Entry] = []
        for index, entry in enumerate((*self._entries, None)):
            entries += [Entry(row, self.form.format(row), self.newline) for row in at.get(index, ())]
            if entry is not None:
                new = replaced.get(entry.row.address) if entry.row else None
                entries.append(Entry(new, self.form.format(new), entry.end) if new else entry)
        if not self.final_newline:
            entries = [entry if entry.end else entry._replace(end=self.newline) for entry in entries]
            entries[-1] = entries[-1]._replace(end="")
        return replace(self, _entries=tuple(entries))

    def changed(self, rows: Mapping[Address, Row | None]) -> AddressTable:
        """Return the table with these rows at their addresses, whatever was there; None removes a row with its line.

        A row that repeats what is there changes nothing, and new rows go where ``extended`` puts them. Raises
        ValueError for a row of the workbook, and if a nickname would be at two addresses.
        """
        fixed = next((row for row in self.base if row.address in rows), None)
        if fixed is not None:
            raise ValueError(f"{fixed.address} stands in {self.place(fixed)}")
        entries: list[Entry] = []
        for entry in self._entries:
            old = entry.row
            new = rows.get(old.address, old) if old else None
            if old is None or (new is not None and new.content == old.content):
                entries.append(entry)
            elif new is not None:
                entries.append(Entry(replace(new, line=0, raw=""), self.form.format(new), entry.end))
        if not self.final_newline:
            entries[-1] = entries[-1]._replace(end="")
        kept = replace(self, _entries=tuple(entries))
        added = [row for row in rows.values() if row is not None and row.address not in self.by_address]
        table = kept.extended(added)
        for row in table.rows:
            holder = table.by_nickname.get(row.nickname.lower(), row)
            if holder is not row and {holder.address.bank, row.address.bank} - {"SC", "SD"}:
                raise ValueError(f"{row.nickname} would be {holder.address} and {row.address}")
        return table

    def recommented(self, address: Address, old: str, new: str) -> AddressTable:
        """Replace ``old`` by ``new`` in the comment of an address; every other byte stays.

        Neither may be part of any nickname or number.
        """
        entries = list(self._entries)
        for index, (row, text, end) in enumerate(entries):
            if row is not None and row.address == address:
                comment = row.comment.replace(old, new, 1)
                doubled = old.replace('"', '""')
                text = (
                    text.replace(doubled, new.replace('"', '""'), 1) if doubled in text else text.replace(old, new, 1)
                )
                entries[index] = Entry(replace(row, comment=comment, raw=text if row.raw else ""), text, end)
        return replace(self, _entries=tuple(entries))

    def renamed(self, address: Address, nickname: str) -> AddressTable:
        """Return the table with another nickname at an address; every other byte stays, those of the row included."""
        entries = list(self._entries)
        pattern = re.compile(_NICKNAME % self.form.column(_NICKNAME_FIELD))
        for index, (row, text, end) in enumerate(entries):
            if row is not None and row.address == address:
                match = pattern.match(text)
                assert match is not None
                written = f'"{nickname}"' if match[2].startswith('"') else nickname
                text = match[1] + written + text[match.end() :]
                entries[index] = Entry(replace(row, nickname=nickname, raw=text if row.raw else ""), text, end)
        return replace(self, _entries=tuple(entries))

    def text(self) -> str:
        """The file's text, without a byte order mark."""
        return "".join(entry.text + entry.end for entry in self._entries)

    def to_bytes(self) -> bytes:
        """The file."""
        return (BOM if self.bom else b"") + self.text().encode("utf-8")


def _with_upper_words(entries: tuple[Entry, ...], index: int) -> int:
    while index + 1 < len(entries) and entries[index + 1].text.startswith((",", '"",')):
        index += 1
    return index


def _places(entries: tuple[Entry, ...]) -> Callable[[Address], int]:
    """Return the function that says before which entry a new row goes.

    After the last row of its bank with a smaller number, else before the first row of its bank, else after the last
    row of the nearest bank before it, else first of all. In a table in CLICK's order that is the one place in order.
    """
    banks: dict[int, list[tuple[int, bool, int]]] = {}
    for index, (row, _, _) in enumerate(entries):
        if row is not None:
            banks.setdefault(ORDER[row.address.bank], []).append((row.address.number, row.address.upper, index))
    first = {bank: min(item[2] for item in items) for bank, items in banks.items()}
    for items in banks.values():
        # A row without an address, for the upper word of an XD or YD, stays below the row of its lower word.
        items[:] = [(number, upper, _with_upper_words(entries, index)) for number, upper, index in items]
    last = {bank: max(item[2] for item in items) for bank, items in banks.items()}
    furthest: dict[int, list[int]] = {}
    for bank, items in banks.items():
        items.sort()
        furthest[bank] = list(accumulate((item[2] for item in items), max))

    def place(address: Address) -> int:
        bank = ORDER[address.bank]
        if bank in banks:
            smaller = bisect_left(banks[bank], (address.number, address.upper, -1))
            return furthest[bank][smaller - 1] + 1 if smaller else first[bank]
        before = max((other for other in banks if other < bank), default=None)
        # Entry 0 is the header.
        return 1 if before is None else last[before] + 1

    return place
