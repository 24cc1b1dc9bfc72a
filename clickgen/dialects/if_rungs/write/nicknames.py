"""The nicknames that an imported program is written with, and the address table that stands beside it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from clickgen.device.banks import Address
from clickgen.device.system import find_system_name, system_nicknames
from clickgen.dialects.if_rungs.write.expressions import Names
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.judge_row import address_nickname_fault, may_share_a_name
from clickgen.table.read import TableUnreadable, bytes_of_table, read_table
from clickgen.table.rows import Row, is_scratch
from clickgen.text.wording import counted
from clickgen.workspace import CouldNotRun, Workspace


@dataclass(frozen=True)
class Nicknames:
    """The table without the names that a program cannot use, what is written in place of addresses, and problems.

    Errors among the problems are those that a build would have, too.
    """

    table: AddressTable
    names: Names
    problems: tuple[Diagnostic, ...] = ()
    path: Path | None = None
    """The address table that was read."""

    @property
    def is_given(self) -> bool:
        """False where there is no address table, and CLICK's own names are all there are."""
        return self.path is not None


def no_nicknames() -> Nicknames:
    """CLICK's own names alone."""
    table = AddressTable.empty("")
    return Nicknames(table, names_of(table))


def nicknames_of(path: Path, shown: str, is_kept: bool = False, files: Workspace | None = None) -> Nicknames:
    """The names of an address table, which stays as it is when it ``is_kept``. Raises CouldNotRun when it is none.

    A name that CLICK does not take, or that two addresses have, is left out of the table: what it would mean in a
    program, nobody can say. So are the names that clickgen gave to its own cells in an earlier build.
    """
    try:
        data = bytes_of_table(path, shown, files)
        before = Diagnostics()
        table = read_table(path, shown, before, data)
        if is_kept:
            errors = tuple(problem for problem in before.found if problem.is_error)
            return Nicknames(table, names_of(table), errors, path)
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
    scratch = sum(map(is_scratch, table.rows))
    if scratch:
        cells = counted(scratch, "scratch cell")
        message = f"{shown}: the nicknames of {cells} of an earlier build are left out"
        problems.append(Diagnostic("CG705", message, None, "their addresses are cells of the program like any other"))
    return Nicknames(kept, names_of(kept), tuple(sorted(problems, key=lambda problem: problem.sort_key)), path)


def _place(problem: Diagnostic) -> tuple[str, int]:
    return problem.code, problem.span.line if problem.span else 0


def _left_out(problem: Diagnostic) -> Diagnostic:
    which = "both addresses stand" if problem.code == "CG602" else "the address stands"
    way_out = f"{which} without a name in the program; give each a legal name of its own, and import again"
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
    for row in table.rows:
        if row.nickname and table.by_nickname[row.nickname.lower()] is row:
            names[row.address] = row.nickname
    # CLICK's own points go by CLICK's names: what a table calls them, no build writes.
    for name, address in system_nicknames().values():
        holder = table.by_nickname.get(name.lower())
        if (holder is None or holder.address == address) and find_system_name(name) == (name, address):
            names[address] = name
    return names
