"""Blocks: names for ranges of addresses, as ClickNick marks them in address comments.

``<Recipe>`` in the comment of the first address opens a block and ``</Recipe>`` in that of the last closes it;
``<Recipe />`` is a block of one. Text may stand before and behind a mark, and a colour in it: ``<Recipe bg="Red">``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from clickgen.device.banks import CURRENT_VALUE_OF, Address
from clickgen.resolve.rows import Row
from clickgen.resolve.table import AddressTable
from clickgen.source import Span


class Block(NamedTuple):
    """A name for consecutive addresses, both ends included, and where it comes from."""

    name: str
    bank: str
    first: int
    last: int
    said_by: str
    span: Span | None = None

    @property
    def size(self) -> int:
        return self.last - self.first + 1

    def addresses(self) -> list[Address]:
        return [Address(self.bank, number) for number in range(self.first, self.last + 1)]

    def is_seen_as(self, bank: str) -> bool:
        """True where the block goes by this bank: its own, or TD and CTD for one of T and CT."""
        return bank == self.bank or CURRENT_VALUE_OF.get(bank) == self.bank

    def __str__(self) -> str:
        return f"{Address(self.bank, self.first)} to {Address(self.bank, self.last)}"


class Mark(NamedTuple):
    """A block's mark in a comment; ``word`` is what it says between the angle brackets."""

    name: str
    opens: bool
    closes: bool
    word: str


_MARK = re.compile(r"(?=<(?P<word>[^>]*)>)")
_COLOR = re.compile(r"""\s+bg=["']([^"']+)["']""")


def mark_in(comment: str) -> Mark | None:
    """The first mark in a comment, as ClickNick finds it (pyclickplc, blocks.py); a name has a letter in it."""
    if "<" in comment:
        for match in _MARK.finditer(comment):
            mark = _read_mark(match["word"])
            if any(character.isalpha() for character in mark.name):
                return mark
    return None


def _read_mark(word: str) -> Mark:
    text = word.rstrip()
    if text.endswith("/"):
        return Mark(_COLOR.sub("", text[:-1].strip(), count=1).strip(), True, True, word)
    if text.startswith("/"):
        return Mark(text[1:].strip(), False, True, word)
    return Mark(_COLOR.sub("", word, count=1).strip(), True, False, word)


def marked(comment: str, name: str, opens: bool, closes: bool) -> str:
    """A comment with a block's mark in front; as it is where it has that mark already."""
    mark = mark_in(comment)
    if mark and (mark.name, mark.opens, mark.closes) == (name, opens, closes):
        return comment
    word = f"{name} /" if opens and closes else name if opens else f"/{name}"
    return f"<{word}>{comment}"


def marked_blocks(table: AddressTable) -> dict[str, Block]:
    """The blocks that the comments of a table mark, by their lowercase names; what is not closed is none."""
    open_rows: dict[tuple[str, str], Row] = {}
    blocks: dict[str, Block] = {}
    for row in sorted(_with_marks(table.rows), key=lambda row: row.address.sort_key):
        mark = mark_in(row.comment)
        assert mark is not None
        key = (row.address.bank, mark.name.lower())
        if mark.opens and not mark.closes:
            open_rows.setdefault(key, row)
            continue
        first = row if mark.opens else open_rows.pop(key, None)
        if first is not None:
            block = Block(
                mark.name,
                row.address.bank,
                first.address.number,
                row.address.number,
                table.place(first),
                table.span(first),
            )
            blocks.setdefault(mark.name.lower(), block)
    return blocks


def unclosed_block(table: AddressTable, name: str) -> Row | None:
    """The row that opens a block of this name where no row closes it."""
    return next((row for row in _with_marks(table.rows) if _opens(row, name)), None)


def _opens(row: Row, name: str) -> bool:
    mark = mark_in(row.comment)
    return mark is not None and mark.opens and mark.name.lower() == name.lower()


def _with_marks(rows: Iterable[Row]) -> list[Row]:
    return [row for row in rows if "<" in row.comment and mark_in(row.comment)]
