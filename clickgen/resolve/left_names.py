"""Names that clickgen placed and that left the program while new ones came: a rename in the text abandons the value.

It is no rule: it needs the address table and the record of what clickgen placed, and a build tells it too.
"""

from __future__ import annotations

import difflib
import os
import shlex
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.problems.codes import LEFT
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.table.address_table import AddressTable
from clickgen.table.record import left_in, placed_in
from clickgen.table.rows import Row, is_scratch
from clickgen.text.source import Span

_SAME = 0.5
"""Names that are at least so much alike are taken for an old and a new one, before the order decides."""


class Asked(NamedTuple):
    """The program and its table as commands name them; the table is "" where it is the one beside the program."""

    program: str
    table: str

    @staticmethod
    def of(program: str, nicknames: str | os.PathLike[str] | None) -> Asked:
        """Names as seen from the working folder."""
        return Asked(program, os.fspath(nicknames or "").removeprefix(os.getcwd() + os.sep))


class Left(NamedTuple):
    """A name that left, and the one that most likely came in its place."""

    old: Row
    new: Row


def find_left(
    facts: Facts,
    table: AddressTable,
    record: bytes | None,
    new: Iterable[Row],
    named_elsewhere: frozenset[str],
    asked: Asked,
    problems: Diagnostics,
) -> tuple[Left, ...]:
    """The names that left a program, each reported. ``record`` is the file of what clickgen placed in the table."""
    if record is None:
        return ()
    rows = [row for row in table.own_rows if row.line]
    found = left_names(facts, rows, placed_in(record), left_in(record), new, named_elsewhere)
    spans = {left.old.address: span for left in found if (span := table.span(left.old))}
    report_left(facts, problems, found, asked.program, asked.table, spans)
    return tuple(found)


def left_names(
    facts: Facts,
    rows: Iterable[Row],
    placed: Mapping[Address, str],
    left: Mapping[Address, Address],
    new: Iterable[Row],
    named_elsewhere: frozenset[str] = frozenset(),
) -> list[Left]:
    """The retentive names of the table that nothing uses any more, each with the new name of its bank.

    ``placed`` and ``left`` are the record of what clickgen placed, ``new`` are the rows of this build;
    ``named_elsewhere`` has the names, in small letters, and addresses that other programs of the table use.
    """
    table = {row.address: row for row in rows if row.line}
    gone = {
        row.address: row
        for row in table.values()
        if row.nickname and placed.get(row.address) == row.nickname and row.retentive and not is_scratch(row)
        if not _is_used(facts, row.address)
        if row.nickname.lower() not in named_elsewhere and str(row.address) not in named_elsewhere
    }
    known = [
        Left(gone[old], table[came])
        for came, old in left.items()
        if old in gone and came in table and table[came].nickname and _is_used(facts, came)
    ]
    told = {each.old.address for each in known}
    waiting = [row for address, row in sorted(gone.items(), key=lambda item: item[0].sort_key) if address not in told]
    return [*known, *_paired(waiting, [row for row in new if row.nickname])]


def _paired(gone: list[Row], new: list[Row]) -> list[Left]:
    """Each name that left with a new one of its bank: first those that are alike, the rest in their order."""
    likeness = [
        (difflib.SequenceMatcher(None, old.nickname.lower(), row.nickname.lower()).ratio(), n, m)
        for n, old in enumerate(gone)
        for m, row in enumerate(new)
        if old.address.bank == row.address.bank
    ]
    pairs: dict[int, int] = {}
    for ratio, n, m in sorted(likeness, key=lambda one: (-one[0], one[1], one[2])):
        if ratio >= _SAME and n not in pairs and m not in pairs.values():
            pairs[n] = m
    for _, n, m in sorted(likeness, key=lambda one: one[1:]):
        if n not in pairs and m not in pairs.values():
            pairs[n] = m
    return [Left(gone[n], new[m]) for n, m in sorted(pairs.items())]


def _is_used(facts: Facts, address: Address) -> bool:
    blocks = facts.program.blocks
    is_declared = address in facts.declared or any(
        block.range.bank == address.bank and address in block.range.addresses() for block in blocks
    )
    return is_declared or bool(facts.uses.at(address))


def report_left(
    facts: Facts, problems: Diagnostics, left: Iterable[Left], program: str, table: str, place: Mapping[Address, Span]
) -> None:
    """Say what left; ``program`` and ``table`` are as commands name them, "" for the table beside the program."""
    words = [shlex.quote(program), *(["--nicknames", shlex.quote(table)] if table else [])]
    for old, new in left:
        use = next(iter(facts.uses.at(new.address)), None)
        if use is None:
            continue
        rename = ["clickgen nicknames rename", shlex.quote(old.nickname), shlex.quote(new.nickname), *words]
        labels = (Label(place[old.address], f"{old.nickname} is still here"),) if old.address in place else ()
        problems.add(
            LEFT,
            use.operand.span,
            f"{old.nickname} ({old.address}) left the program and its value stays behind; {new.nickname} "
            f"({new.address}) came new, without it",
            f"if {new.nickname} is {old.nickname} by another name: {' '.join(rename)}; if not, remove the old one: "
            f"{' '.join(['clickgen nicknames sync --prune', *words])}",
            labels,
        )
