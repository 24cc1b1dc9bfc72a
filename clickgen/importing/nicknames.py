"""The nicknames that an imported program is written with, and the address table that stands beside it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from clickgen.device.banks import Address
from clickgen.device.system import find_system_name, system_nicknames
from clickgen.diagnostics import CouldNotRun, Diagnostic, Diagnostics
from clickgen.importing.pieces import Names
from clickgen.resolve.judge_row import address_nickname_fault, may_share_a_name
from clickgen.resolve.read_table import TableUnreadable, bytes_of_table, read_table
from clickgen.resolve.rows import Row, is_scratch
from clickgen.resolve.table import AddressTable


@dataclass(frozen=True)
class Nicknames:
    """The table without the names that a program cannot use, what is written in place of addresses, and problems.

    Errors among the problems are those that a build would have, too.
    """

    table: AddressTable
    names: Names
    problems: tuple[Diagnostic, ...] = ()


def no_nicknames() -> Nicknames:
    """CLICK's own names alone."""
    table = AddressTable.empty("")
    return Nicknames(table, names_of(table))


def nicknames_of(path: Path, shown: str, is_kept: bool = False) -> Nicknames:
    """The names of an address table, which stays as it is when it ``is_kept``. Raises CouldNotRun when it is none.

    A name that CLICK does not take, or that two addresses have, is left out of the table: what it would mean in a
    program, nobody can say. So are the names that clickgen gave to its own cells in an earlier build.
    """
    try:
        data = bytes_of_table(path, shown)
        before = Diagnostics()
        table = read_table(path, shown, before, data)
        if is_kept:
            return Nicknames(table, names_of(table), tuple(problem for problem in before.found if problem.is_error))
        kept = table
        for row in _unusable(table):
            kept = kept.renamed(row.address, "")
        after = Diagnostics()
        kept = read_table(path, shown, after, kept.to_bytes())
    except TableUnreadable as error:
        raise CouldNotRun(str(error)) from None
    remaining = [problem for problem in after.found if problem.is_error]
    places = {_place(problem) for problem in remaining}
    left_out = [problem for problem in before.found if problem.is_error and _place(problem) not in places]
    problems = [*remaining, *(_left_out(problem) for problem in left_out)]
    return Nicknames(kept, names_of(kept), tuple(sorted(problems, key=lambda problem: problem.sort_key)))


def _place(problem: Diagnostic) -> tuple[str, int]:
    return problem.code, problem.span.line if problem.span else 0


def _left_out(problem: Diagnostic) -> Diagnostic:
    way_out = "the program has the address in its place; give the address a name that CLICK takes, and import again"
    return Diagnostic("CG706", problem.message, problem.span, way_out, problem.labels)


def _unusable(table: AddressTable) -> list[Row]:
    """The rows whose nicknames have no one meaning, and those of clickgen's own cells."""
    holders: dict[str, list[Row]] = {}
    for row in table.rows:
        holders.setdefault(row.nickname.lower(), []).append(row)
    found: list[Row] = []
    for row in table.rows:
        others = (other for other in holders[row.nickname.lower()] if other is not row)
        is_shared = any(not may_share_a_name(row.address, other.address) for other in others)
        if row.nickname and (is_shared or is_scratch(row) or address_nickname_fault(row.address, row.nickname)):
            found.append(row)
    return found


def names_of(table: AddressTable) -> Names:
    """What a program can write in place of an address, and mean that address; CLICK's own names included."""
    names: dict[Address, str] = {}
    for name, address in system_nicknames().values():
        if name.lower() not in table.by_nickname and find_system_name(name) == (name, address):
            names[address] = name
    for row in table.rows:
        if row.nickname and table.by_nickname[row.nickname.lower()] is row:
            names[row.address] = row.nickname
    return names
