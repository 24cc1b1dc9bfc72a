"""Names that clickgen placed and that left the program while new ones came: a rename in the text abandons the value.

A half-done rename leaves both names in the program: one is written and never read, the other read and never
written.

It is not a rule: it needs the address table and the record of what clickgen placed, and a build reports it too.
"""

from __future__ import annotations

import difflib
import os
import re
import shlex
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.facts.uses import Use
from clickgen.problems.codes import LEFT
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.problems.name_slips import is_slip
from clickgen.table.address_table import AddressTable
from clickgen.table.record import left_in, placed_in
from clickgen.table.rows import Row, is_scratch
from clickgen.text.source import Span

_SAME = 0.5
"""Names at least this much alike are taken for an old and a new one, before the order decides."""


class Asked(NamedTuple):
    """The program and its table as commands name them; the table is "" if it is the one beside the program."""

    program: str
    table: str

    @staticmethod
    def of(program: str, nicknames: str | os.PathLike[str] | None) -> Asked:
        """Return the names relative to the working folder."""
        return Asked(program, os.fspath(nicknames or "").removeprefix(os.getcwd() + os.sep))

    @property
    def words(self) -> str:
        """The program and its table as on a command line."""
        return shlex.join([self.program, *(["--nicknames", self.table] if self.table else [])])


class Left(NamedTuple):
    """A name that left, and the one that most likely came in its place."""

    old: Row
    new: Row
    is_half: bool = False
    """True if the program has both names."""
    is_sure: bool = True
    """False if the new name may be another old one as well: that is reported while it is new, and not recorded."""


def find_left(
    facts: Facts,
    table: AddressTable,
    record: bytes | None,
    new: Iterable[Row],
    named_elsewhere: frozenset[str],
    asked: Asked,
    problems: Diagnostics,
) -> tuple[Left, ...]:
    """Report and return the names that left a program. ``record`` is the file of what clickgen placed in the table."""
    if record is None:
        return ()
    rows = [row for row in table.own_rows if row.line]
    found = left_names(facts, rows, placed_in(record), left_in(record), new, named_elsewhere)
    spans = {left.old.address: span for left in found if (span := table.span(left.old))}
    report_left(facts, problems, found, asked.program, asked.table, spans)
    return tuple(each for each in found if each.is_sure)


def left_names(
    facts: Facts,
    rows: Iterable[Row],
    placed: Mapping[Address, str],
    left: Mapping[Address, Address],
    new: Iterable[Row],
    named_elsewhere: frozenset[str] = frozenset(),
) -> list[Left]:
    """Return the retentive names of the table that nothing uses any more, each with the new name of its bank.

    ``placed`` and ``left`` are the record of what clickgen placed, ``new`` are the rows of this build;
    ``named_elsewhere`` has the names, in lower case, and addresses that other programs of the table use.
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
    fresh = [row for row in new if row.nickname]
    whole = [*known, *_paired(waiting, fresh)]
    taken = {each.new.address for each in whole}
    kept = [row for row in table.values() if _keeps_its_value(facts, row, placed) and row.address not in left]
    halves = _halves(facts, kept, [row for row in fresh if row.retentive and row.address not in taken])
    recorded = [
        Left(table[old], table[came], True)
        for came, old in left.items()
        if old in table and came in table and _keeps_its_value(facts, table[old], placed)
        if _are_halves(facts, table[old], table[came])
    ]
    return [*whole, *recorded, *halves]


def _keeps_its_value(facts: Facts, row: Row, placed: Mapping[Address, str]) -> bool:
    """True for a name that clickgen placed and whose cell keeps its value; one that is declared is pinned."""
    is_placed = bool(row.nickname) and placed.get(row.address) == row.nickname
    return is_placed and row.retentive and not is_scratch(row) and row.address not in facts.declared


# -- half-done renames ------------------------------------------------------------------------------------------------


def _halves(facts: Facts, kept: list[Row], new: list[Row]) -> list[Left]:
    """Pair each new name with the old one that it seems to replace, while the program has both.

    Names that are alike are paired, and others only if there is no third one: a program whose panel writes setpoints
    and reads results has many names that are only read or only written.
    """
    if len(new) * len(kept) > _PAIRS_MAX:
        return []
    pairs = [(old, row) for row in new for old in kept if _are_halves(facts, old, row)]
    found: list[Left] = []
    for old, row in pairs:
        rivals = [one for one, other in pairs if other is row and one is not old]
        others = [other for one, other in pairs if one is old and other is not row]
        is_sure = _is_alike(old, row) or not (rivals or others)
        if any(_is_alike(one, row) for one in rivals) or len(rivals) + len(others) > 1:
            is_told = _is_alike(old, row)
        else:
            is_told = True
        # A pair that looks like a slip of the hand is reported as one.
        if is_told and not is_slip(old.nickname, row.nickname):
            found.append(Left(old, row, True, is_sure))
    return found


_PAIRS_MAX = 10_000
"""With this many names nothing shows which is which."""


def _are_halves(facts: Facts, old: Row, new: Row) -> bool:
    """True if one of two names is written and never read, and the other read and never written."""
    if old.address.bank != new.address.bank:
        return False
    ours, others = _sides(facts, old), _sides(facts, new)
    if ours is None or others is None:
        return False
    return len(ours) == len(others) == 1 and ours != others


def _sides(facts: Facts, row: Row) -> set[bool] | None:
    """Whether a name is written, and whether it is read; None if its address is used other than by this name."""
    uses = facts.uses.at(row.address)
    if not all(_is_by_name(facts, use) for use in uses):
        return None
    return {use.is_written for use in uses}


def _is_by_name(facts: Facts, use: Use) -> bool:
    span = use.operand.span
    source = facts.sources.get(span.path)
    text = source.line(span.line)[span.col - 1 :] if source is not None else ""
    return _NAMED.match(text) is not None


_NAMED = re.compile(r"[a-z]{1,3}(?:\.|\[[\"'])")


def _is_alike(one: Row, other: Row) -> bool:
    return _likeness(one, other) >= _SAME


def _likeness(one: Row, other: Row) -> float:
    return difflib.SequenceMatcher(None, one.nickname.lower(), other.nickname.lower()).ratio()


# -- finished renames -------------------------------------------------------------------------------------------------


def _paired(gone: list[Row], new: list[Row]) -> list[Left]:
    """Pair each name that left with a new one of its bank: first those that are alike, the rest in their order."""
    likeness = [
        (_likeness(old, row), n, m)
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
        block.range.bank == address.bank and block.range.first <= address.number <= block.range.last for block in blocks
    )
    return is_declared or bool(facts.uses.at(address))


def report_left(
    facts: Facts, problems: Diagnostics, left: Iterable[Left], program: str, table: str, place: Mapping[Address, Span]
) -> None:
    """Report what left; ``program`` and ``table`` are as commands name them, "" for the table beside the program."""
    words = [shlex.quote(program), *(["--nicknames", shlex.quote(table)] if table else [])]
    for old, new, is_half, is_sure in left:
        use = next(iter(facts.uses.at(new.address)), None)
        if use is None:
            continue
        rename = ["clickgen nicknames rename", shlex.quote(old.nickname), shlex.quote(new.nickname), *words]
        if is_half:
            _report_half(problems, facts, Left(old, new, is_half, is_sure), use, rename, words)
            continue
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


def _report_half(
    problems: Diagnostics, facts: Facts, pair: Left, use: Use, rename: list[str], words: list[str]
) -> None:
    """Report that a rename seems half done, and the commands that finish it."""
    old, new, _, is_sure = pair
    other = next(iter(facts.uses.at(old.address)))
    sync = "clickgen nicknames sync"
    if is_sure:
        steps = [] if new.line else [" ".join([sync, *words])]
    else:
        places = ", ".join(dict.fromkeys(str(each.operand.span) for each in facts.uses.at(new.address)))
        steps = [f"write {old.nickname} again at {places}", " ".join([sync, "--prune", *words])]
    problems.add(
        LEFT,
        use.operand.span,
        f"{old.nickname} ({old.address}) and {new.nickname} ({new.address}) are both in the program, one only written "
        f"and one only read; {new.nickname} took a new cell, and the value of {old.address} is not in it",
        f"if {new.nickname} is {old.nickname} by another name: {', and then '.join([*steps, ' '.join(rename)])}; if "
        "they are two, leave both",
        (Label(other.operand.span, f"{old.nickname} is still here"),),
    )
