"""Scratch addresses: cells that clickgen needs for itself, taken from the top of a bank downward, one for each use.

While rungs are lowered, a scratch use has a placeholder. When all uses are known, each gets its address: the one it had
in the address table, else the highest free one. A use is identified by its purpose, its comment in the table: the
routine and the output or timer that it serves. So a rung inserted before it moves nothing and changes no comment. A
cell whose purpose this program does not have may belong to another program of the same table, and is left alone.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from clickgen.click.draw.tokens import operand_token
from clickgen.device.banks import BANKS, Address
from clickgen.device.nicknames import COMMENT_MAX
from clickgen.ir.operands import Cell, Operand
from clickgen.problems.diagnostics import Diagnostics
from clickgen.resolve.allocate import Allocator
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import Row, is_scratch, scratch_name
from clickgen.text.source import Span

_RUNG_NUMBER = re.compile(
    r"(?<= rung )[0-9]+(?=$|: (?:(?:not|rise|fall|all|none|always|scratch)(?![a-z_])|immediate\(|[^a-z]))"
)
"""Earlier versions wrote the rung and the condition: ``condition of main rung 12: C1 and not C2``.

The name of a routine may also hold the word and a number: then an instruction follows.
"""
_NICKNAME = re.compile(r"(?<=: )((?!call )[a-z_]+(?: to)? [A-Z]+[0-9]+u?) ([^()]+?)(?=$| \([0-9]+\)$)")
_ORDINAL = re.compile(r" \(([0-9]+)\)$")
_CUT = "..."
_NOTHING = "nothing"
_SURE = COMMENT_MAX - len(_CUT) - 7
"""This much of an earlier comment is certain without its rung number, however long that is."""


@dataclass(frozen=True)
class ScratchUse:
    """One need of a scratch cell. ``reason`` gives its purpose, ``content`` the condition that it holds."""

    placeholder: Address
    reason: str
    span: Span
    content: str = ""

    @property
    def has_end(self) -> bool:
        """True if the reason is complete: ``rtof T1: ...``."""
        return ":" in self.reason

    @property
    def former(self) -> str:
        """The comment of an earlier version for it, without the rung number, up to the part that is certain."""
        return (f"{self.reason} rung " + (f": {self.content}" if self.content else ""))[:_SURE]


def purpose_of(comment: str) -> str:
    """The common part of scratch cells of one purpose: the comment without nickname and number."""
    if _RUNG_NUMBER.search(comment):
        return _RUNG_NUMBER.sub("", comment, count=1)
    return _NICKNAME.sub(r"\1", _ORDINAL.sub("", comment))


def renamed_reason(comment: str, old: str, new: str) -> str:
    """A comment with another nickname for what the cell serves; unchanged if that has another name."""
    match = _NICKNAME.search(comment)
    if match is None or match[2].lower() != old.lower():
        return comment
    return comment[: match.start(2)] + new + comment[match.end(2) :]


def rung_of(comment: str) -> int:
    """The number that tells cells of one purpose apart: that of the rung, or at the end of the comment; else 0."""
    match = _RUNG_NUMBER.search(comment)
    if match:
        return int(match[0])
    ordinal = _ORDINAL.search(comment)
    return int(ordinal[1]) if ordinal else 0


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
        """True if a bank has too few addresses for the placeholders: ``assign`` will say so."""
        return any(count > BANKS[bank].last for bank, count in self._taken.items())

    def take(self, bank: str, reason: str, span: Span, content: str = "") -> Cell:
        """Return a cell of ``bank`` for one use; ``content`` is the condition that it holds, in words."""
        placeholder = Address(bank, -1 - len(self.uses))
        self._taken[bank] += 1
        self.uses.append(ScratchUse(placeholder, reason, span, content))
        return Cell(placeholder, span)

    @property
    def ends(self) -> dict[Address, str]:
        """The placeholders with a purpose of their own, each with its short form: ``rtof T1``."""
        return {use.placeholder: use.reason.partition(":")[0] for use in self.uses if use.has_end}

    def assign(
        self,
        served: Mapping[Address, str],
        table: AddressTable,
        allocator: Allocator,
        frozen: bool,
        problems: Diagnostics,
    ) -> dict[Address, Row]:
        """Return the table row of each placeholder; ``served`` names what each serves."""
        assigned: dict[Address, Row] = {}
        for bank in sorted({use.placeholder.bank for use in self.uses}):
            uses = [use for use in self.uses if use.placeholder.bank == bank]
            comments = _comments(uses, served)
            old = [row for row in table.rows if row.address.bank == bank and is_scratch(row)]
            rows, left = _matched(uses, comments, old)
            addresses = {use: row.address for use, row in rows.items()}
            for use in (use for use in uses if use not in addresses):
                address = None if frozen else _free(allocator, bank, table) or _given_up(left)
                if address is not None:
                    addresses[use] = address
                    continue
                _no_scratch(use, comments[use], frozen, table, problems)
                if not frozen:
                    break  # the bank is full for all that follow
            for use, address in addresses.items():
                assigned[use.placeholder] = _row(table, address, comments[use])
        return assigned


def _comments(uses: list[ScratchUse], served: Mapping[Address, str]) -> dict[ScratchUse, str]:
    """The comment of each use, all different: ``condition of main: out Y001 Motor``, the next one with ``(2)``."""
    comments: dict[ScratchUse, str] = {}
    counts: Counter[str] = Counter()
    for use in uses:
        comment = use.reason if use.has_end else f"{use.reason}: {served.get(use.placeholder, _NOTHING)}"
        counts[purpose_of(comment)] += 1
        number = counts[purpose_of(comment)]
        ordinal = f" ({number})" if number > 1 else ""
        room = COMMENT_MAX - len(ordinal)
        comments[use] = (comment if len(comment) <= room else comment[: room - len(_CUT)] + _CUT) + ordinal
    return comments


def _free(allocator: Allocator, bank: str, table: AddressTable) -> Address | None:
    """The highest free address whose scratch name is free too."""
    address = allocator.highest(bank)
    while address is not None and scratch_name(address).lower() in table.by_nickname:
        address = allocator.highest(bank)
    return address


def _matched(
    uses: list[ScratchUse], comments: Mapping[ScratchUse, str], old: list[Row]
) -> tuple[dict[ScratchUse, Row], list[Row]]:
    """Match uses with the rows of earlier builds; also return the rows that are left over.

    First by the comment; else by all of it except nicknames, which may have changed; else, in a table of an earlier
    version, by the condition, where rows of one condition are in the order of their rungs.
    """
    rows: dict[ScratchUse, Row] = {}
    waiting = sorted(old, key=lambda row: (rung_of(row.comment), -row.address.number))

    def match(of_use: Callable[[ScratchUse], object], of_row: Callable[[Row], object]) -> None:
        found: dict[object, list[Row]] = {}
        for row in reversed(waiting):
            found.setdefault(of_row(row), []).append(row)
        for use in uses:
            candidates = found.get(of_use(use))
            if candidates and use not in rows:
                rows[use] = candidates.pop()
        taken = {row.address for row in rows.values()}
        waiting[:] = [row for row in waiting if row.address not in taken]

    match(lambda use: comments[use], lambda row: row.comment)
    match(
        lambda use: (purpose_of(comments[use]), rung_of(comments[use])),
        lambda row: (purpose_of(row.comment), rung_of(row.comment)),
    )
    match(lambda use: use.former, lambda row: purpose_of(row.comment)[:_SURE])
    return rows, waiting


def _given_up(left: list[Row]) -> Address | None:
    """A cell that no use of this program has, for when a bank is full."""
    return left.pop(0).address if left else None


def _row(table: AddressTable, address: Address, comment: str) -> Row:
    stands = table.by_address.get(address)
    if stands is not None and stands.nickname:
        return stands if stands.comment == comment else replace(stands, comment=comment, line=0, raw="")
    return table.named(address, scratch_name(address), comment)


def _no_scratch(use: ScratchUse, comment: str, frozen: bool, table: AddressTable, problems: Diagnostics) -> None:
    bank = use.placeholder.bank
    if frozen:
        problems.add(
            "CG209",
            use.span,
            f"this rung needs a scratch {bank} address that is not in {table.path} yet ({comment})",
            "build once without --frozen and commit the table",
        )
    else:
        problems.add(
            "CG208",
            use.span,
            f"no {bank} address is free for scratch use ({comment})",
            f"write simpler conditions, or free some {bank} addresses of the program and of {table.path}",
        )
