"""Blocks: names for ranges of addresses, as ClickNick marks them in address comments.

``<Recipe>`` in the comment of the first address opens a block and ``</Recipe>`` in that of the last closes it;
``<Recipe />`` is a block of one. A mark may have text before and after it, and a colour in it: ``<Recipe bg="Red">``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from clickgen.device.banks import CURRENT_VALUE_OF, Address
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import Row
from clickgen.text.source import Span


class Block(NamedTuple):
    """A name for consecutive addresses, both ends included, and where the name comes from."""

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
        """True if the block has this bank: its own, or TD and CTD for a block of T and CT."""
        return bank == self.bank or CURRENT_VALUE_OF.get(bank) == self.bank

    def meets(self, other: Block) -> bool:
        """True if the two blocks share an address."""
        return self.bank == other.bank and self.first <= other.last and other.first <= self.last

    def lies_in(self, other: Block) -> bool:
        return self.bank == other.bank and other.first <= self.first and self.last <= other.last

    def __str__(self) -> str:
        first = str(Address(self.bank, self.first))
        return first if self.size == 1 else f"{first} to {Address(self.bank, self.last)}"


def covered(blocks: Iterable[Block]) -> set[Address]:
    """The addresses of blocks; where blocks are nested, each stretch is visited once."""
    found: set[Address] = set()
    bank, end = "", 0
    for block in sorted(blocks, key=lambda block: (block.bank, block.first)):
        start = block.first if block.bank != bank else max(block.first, end + 1)
        found.update(Address(block.bank, number) for number in range(start, block.last + 1))
        end = block.last if block.bank != bank else max(block.last, end)
        bank = block.bank
    return found


class Mark(NamedTuple):
    """A block's mark in a comment; ``word`` is the text between the angle brackets."""

    name: str
    opens: bool
    closes: bool
    word: str


_MARK_MAX = 200
"""The longest mark to look for: a comment has room for 128 characters (click-facts [name.length])."""
_MARK = re.compile(rf"(?=<(?P<word>[^>]{{0,{_MARK_MAX}}})>)")
_COLOR = re.compile(r"""(?<!\s)\s+bg=["']([^"']{1,200})["']""")


def mark_in(comment: str) -> Mark | None:
    """The first mark in a comment, as ClickNick finds it; its name has at least one letter.

    click-facts [nickname-file.blocks]
    """
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
    """A comment with a block's mark in front; unchanged if it has that mark already."""
    mark = mark_in(comment)
    if mark and (mark.name.lower(), mark.opens, mark.closes) == (name.lower(), opens, closes):
        return comment
    word = f"{name} /" if opens and closes else name if opens else f"/{name}"
    return f"<{word}>{comment}"


def renamed_mark(comment: str, old: str, new: str) -> str:
    """A comment with another block name in its mark; unchanged if it has no mark of that name."""
    mark = mark_in(comment)
    if mark is None or mark.name.lower() != old.lower():
        return comment
    return comment.replace(f"<{mark.word}>", f"<{mark.word.replace(mark.name, new, 1)}>", 1)


class MarkedRow(NamedTuple):
    row: Row
    mark: Mark


class Marks(NamedTuple):
    """The marks in the comments of a table."""

    rows: tuple[MarkedRow, ...]
    """In CLICK's order."""
    blocks: dict[str, Block]
    """By their lowercase names."""
    doubles: tuple[tuple[Block, Block], ...]
    """Blocks whose name another block already has, each with that other block."""
    halves: tuple[MarkedRow, ...]
    """The ``rows`` that open a block which no row closes, or close one that no row opens."""


def read_marks(table: AddressTable) -> Marks:
    """Return the blocks of a table. An end belongs to the last beginning before it, as in ClickNick."""
    rows = _marked_rows(table)
    open_rows: dict[tuple[str, str], list[MarkedRow]] = {}
    blocks: dict[str, Block] = {}
    doubles: list[tuple[Block, Block]] = []
    halves: list[MarkedRow] = []
    for each in rows:
        row, mark = each
        waiting = open_rows.setdefault((row.address.bank, mark.name.lower()), [])
        if mark.opens and not mark.closes:
            waiting.append(each)
        elif not mark.opens and not waiting:
            halves.append(each)
        else:
            block = _block(mark.name, row if mark.opens else waiting.pop().row, row, table)
            other = blocks.setdefault(mark.name.lower(), block)
            if other is not block:
                doubles.append((block, other))
    halves += (each for waiting in open_rows.values() for each in waiting)
    return Marks(tuple(rows), blocks, tuple(doubles), tuple(halves))


def _marked_rows(table: AddressTable) -> list[MarkedRow]:
    found = ((row, mark_in(row.comment)) for row in table.rows if "<" in row.comment)
    rows = [MarkedRow(row, mark) for row, mark in found if mark is not None]
    return sorted(rows, key=lambda each: each.row.address.sort_key)


def _block(name: str, first: Row, last: Row, table: AddressTable) -> Block:
    bank, start, _ = first.address
    return Block(name, bank, start, last.address.number, table.place(first), table.span(first))


def marked_blocks(table: AddressTable) -> dict[str, Block]:
    """The blocks that the comments of a table mark, by their lowercase names; an unclosed one is not a block."""
    return read_marks(table).blocks


def unclosed_block(table: AddressTable, name: str) -> Row | None:
    """The row that opens a block of this name which no row closes."""
    halves = read_marks(table).halves
    return next((row for row, mark in halves if mark.opens and mark.name.lower() == name.lower()), None)
