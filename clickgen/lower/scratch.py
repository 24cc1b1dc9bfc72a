"""Scratch addresses: cells that clickgen needs for itself, taken from the top of a bank downward, one for each use.

While rungs are lowered a scratch use has a placeholder; when all uses are known each gets its address: the one it had
in the address table, else one that an earlier build left over, else the highest free one. A use is known by what it
is for, the rung number aside, so that a rung inserted before it moves nothing.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass, replace

from clickgen.device.banks import BANKS, Address
from clickgen.device.nicknames import COMMENT_MAX
from clickgen.diagnostics import Diagnostics
from clickgen.ir.operands import Cell, Operand
from clickgen.lower.tokens import operand_token
from clickgen.resolve.allocate import Allocator
from clickgen.resolve.rows import Row, is_scratch, scratch_name
from clickgen.resolve.table import AddressTable
from clickgen.source import Span

_RUNG_NUMBER = re.compile(r"(?<= rung )[0-9]+(?=:|$)")
"""Of the first that is followed by a condition or nothing; the name of a routine may hold the word and a number."""


@dataclass(frozen=True)
class ScratchUse:
    """One need of a scratch cell: ``reason`` is its comment in the address table."""

    placeholder: Address
    reason: str
    span: Span

    @property
    def purpose(self) -> str:
        """The reason without the rung number."""
        return purpose_of(self.reason)


def purpose_of(comment: str) -> str:
    """A reason without the rung number: what a scratch cell is known by."""
    return _RUNG_NUMBER.sub("", comment, count=1)


def shown_in_reason(operand: Operand) -> str:
    """An operand in a scratch reason, where another scratch cell has no address yet."""
    if isinstance(operand, Cell) and operand.address.number < 0:
        return "scratch"
    return operand_token(operand)


class Scratch:
    """Hands out placeholders, and addresses for them at the end."""

    def __init__(self) -> None:
        self.uses: list[ScratchUse] = []
        self._taken: Counter[str] = Counter()

    @property
    def is_over(self) -> bool:
        """True when a bank has not enough addresses for what was taken: ``assign`` will say so."""
        return any(count > BANKS[bank].last for bank, count in self._taken.items())

    def take(self, bank: str, reason: str, span: Span) -> Cell:
        """A cell of ``bank`` for one use."""
        placeholder = Address(bank, -1 - len(self.uses))
        reason = reason if len(reason) <= COMMENT_MAX else reason[: COMMENT_MAX - 3] + "..."
        self._taken[bank] += 1
        self.uses.append(ScratchUse(placeholder, reason, span))
        return Cell(placeholder, span)

    def assign(
        self, table: AddressTable, allocator: Allocator, frozen: bool, problems: Diagnostics
    ) -> dict[Address, Row]:
        """The table row of each placeholder."""
        assigned: dict[Address, Row] = {}
        for bank in sorted({use.placeholder.bank for use in self.uses}):
            uses = [use for use in self.uses if use.placeholder.bank == bank]
            old = [row for row in table.rows if row.address.bank == bank and is_scratch(row)]
            addresses = _matched(uses, old)
            for use in (use for use in uses if use not in addresses):
                address = None if frozen else _free(allocator, bank, table)
                if address is not None:
                    addresses[use] = address
                    continue
                _no_scratch(use, bank, frozen, table, problems)
                if not frozen:
                    break  # the bank is full for all that follow
            _settle(addresses)
            for use, address in addresses.items():
                assigned[use.placeholder] = _row(table, address, use.reason)
        return assigned


def _free(allocator: Allocator, bank: str, table: AddressTable) -> Address | None:
    """The highest free address whose scratch name is free too."""
    address = allocator.highest(bank)
    while address is not None and scratch_name(address).lower() in table.by_nickname:
        address = allocator.highest(bank)
    return address


def _matched(uses: list[ScratchUse], old: list[Row]) -> dict[ScratchUse, Address]:
    """Uses matched with the rows of earlier builds: by purpose, in the order of the rungs, then what is left over.

    Purposes hold the routine, so that rows of one purpose stand in the order in which the last build met their uses.
    """
    addresses: dict[ScratchUse, Address] = {}
    waiting = sorted(old, key=lambda row: (rung_of(row.comment), -row.address.number))
    for key in (purpose_of, lambda _: ""):
        rows: dict[str, list[Row]] = {}
        for row in waiting:
            rows.setdefault(key(row.comment), []).append(row)
        for use in uses:
            left = rows.get(key(use.reason))
            if use not in addresses and left:
                row = left.pop(0)
                addresses[use] = row.address
                waiting.remove(row)
    return addresses


def rung_of(comment: str) -> int:
    """The rung number of a reason; 0 where it has none."""
    match = _RUNG_NUMBER.search(comment)
    return int(match[0]) if match else 0


def _settle(addresses: dict[ScratchUse, Address]) -> None:
    """Uses with the same comment get their addresses in descending order, so that the next build matches them alike."""
    groups: dict[str, list[ScratchUse]] = {}
    for use in sorted(addresses, key=lambda use: -use.placeholder.number):
        groups.setdefault(use.reason, []).append(use)
    for group in groups.values():
        for use, address in zip(group, sorted((addresses[use] for use in group), key=lambda a: -a.number), strict=True):
            addresses[use] = address


def _row(table: AddressTable, address: Address, reason: str) -> Row:
    stands = table.by_address.get(address)
    if stands is not None and stands.nickname:
        return stands if stands.comment == reason else replace(stands, comment=reason, line=0, raw="")
    return table.named(address, scratch_name(address), reason)


def _no_scratch(use: ScratchUse, bank: str, frozen: bool, table: AddressTable, problems: Diagnostics) -> None:
    if frozen:
        problems.add(
            "CG209",
            use.span,
            f"this rung needs a scratch {bank} address that is not in {table.path} yet ({use.reason})",
            "build once without --frozen and commit the table",
        )
    else:
        problems.add(
            "CG208",
            use.span,
            f"no {bank} address is free for scratch use ({use.reason})",
            f"write simpler conditions, or free some {bank} addresses of the program and of {table.path}",
        )
