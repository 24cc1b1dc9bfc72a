"""The nicknames in an imported program, and the address table beside it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from clickgen.device.banks import CURRENT_VALUE_OF, Address
from clickgen.device.system import find_system_name, system_nicknames
from clickgen.ir.operands import Cell, Immediate
from clickgen.ir.program import Routine
from clickgen.ir.walk import rung_operands
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.judge_row import address_nickname_fault, may_share_a_name
from clickgen.table.read import TableUnreadable, bytes_of_table, read_table
from clickgen.table.rows import Row, is_scratch
from clickgen.text.wording import counted
from clickgen.workspace import CouldNotRun, Workspace

Names = Mapping[Address, str]
"""The nicknames to write in place of addresses."""


@dataclass(frozen=True)
class Nicknames:
    """The table without the names that a program cannot use, the text in place of addresses, and problems.

    The errors among the problems are those that a build would report too.
    """

    table: AddressTable
    names: Names
    problems: tuple[Diagnostic, ...] = ()
    path: Path | None = None
    """The address table that was read."""

    @property
    def is_given(self) -> bool:
        """False if there is no address table, and CLICK's own names are all there are."""
        return self.path is not None


def no_nicknames() -> Nicknames:
    """CLICK's own names alone."""
    table = AddressTable.empty("")
    return Nicknames(table, names_of(table))


def nicknames_of(path: Path, shown: str, is_kept: bool = False, files: Workspace | None = None) -> Nicknames:
    """Return the names of an address table, unchanged if it ``is_kept``. Raises CouldNotRun if it is not a table.

    A name that CLICK does not take, or that two addresses have, is left out of the table: nobody can say what it would
    mean in a program. So are the names that clickgen gave to its own cells in an earlier build.
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
    which = "both addresses are" if problem.code == "CG602" else "the address is"
    way_out = f"{which} in the program without a name; give each a legal name of its own, and import again"
    return Diagnostic("CG706", problem.message, problem.span, way_out, problem.labels)


def _unusable(table: AddressTable) -> list[Row]:
    """The rows whose nicknames do not have one clear meaning, and those of clickgen's own cells."""
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


def declared_rows(routines: Iterable[Routine], nicknames: Nicknames) -> list[Row]:
    """Every row of the table with a name that these routines are written with and that only a declaration gives."""
    used: set[Address] = set()
    for routine in routines:
        for operand in (operand for rung in routine.rungs for operand in rung_operands(rung)):
            cell = operand.target if isinstance(operand, Immediate) else operand
            if isinstance(cell, Cell):
                used.add(cell.address)
                bit = CURRENT_VALUE_OF.get(cell.bank)
                if bit and cell.address not in nicknames.names:
                    used.add(Address(bit, cell.address.number))
    rows = [row for row in nicknames.table.rows if row.address in used and not _is_known(row)]
    rows = [row for row in rows if row.nickname and nicknames.names.get(row.address) == row.nickname]
    return sorted(rows, key=lambda row: row.address.sort_key)


def _is_known(row: Row) -> bool:
    """True for a name of CLICK's own that means this address without a declaration."""
    own = find_system_name(row.nickname)
    return own is not None and own[1] == row.address


def names_of(table: AddressTable) -> Names:
    """The name that a program can write for an address and mean just that; CLICK's own names included."""
    names: dict[Address, str] = {}
    for row in table.rows:
        if row.nickname and table.by_nickname[row.nickname.lower()] is row:
            names[row.address] = row.nickname
    # CLICK's own points have CLICK's names: no build writes the table's names for them.
    for name, address in system_nicknames().values():
        holder = table.by_nickname.get(name.lower())
        if (holder is None or holder.address == address) and find_system_name(name) == (name, address):
            names[address] = name
    return names
