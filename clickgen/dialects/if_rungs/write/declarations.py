"""Declares in the program the names of a program that has no address table beside it."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address, Kind
from clickgen.device.system import find_system_name
from clickgen.dialects.if_rungs.write.expressions import operand_text, quoted
from clickgen.dialects.if_rungs.write.layout import Atom, Brackets, Keyword, Piece, lines
from clickgen.dialects.if_rungs.write.nicknames import Nicknames
from clickgen.ir.operands import Cell, Immediate, Named
from clickgen.ir.program import Routine
from clickgen.ir.walk import rung_operands
from clickgen.table.rows import Row, default_row, initial_fault
from clickgen.text.source import Span

_HERE = Span("", 1, 1, 1, 2)


def declarations(routines: Iterable[Routine], nicknames: Nicknames) -> str:
    """``nickname(c.Run, c[7])`` for every name of the table that these routines use."""
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
    rows.sort(key=lambda row: row.address.sort_key)
    return "\n".join(line for row in rows for line in lines(_declaration(row), 0))


def _is_known(row: Row) -> bool:
    """True for a name of CLICK's own that means this address without a declaration."""
    own = find_system_name(row.nickname)
    return own is not None and own[1] == row.address


def _declaration(row: Row) -> Piece:
    address, plain = row.address, default_row(row.address, row.nickname)
    parts: list[Piece] = [
        Atom(operand_text(Named(address.bank, row.nickname, _HERE))),
        Atom(operand_text(Cell(address, _HERE))),
    ]
    if not BANKS[address.bank].settings_fixed:
        # A value that the bank cannot hold is an error of the table, which the import has reported.
        if row.initial not in ("", "0", plain.initial) and initial_fault(address.kind, row.initial) is None:
            parts.append(Keyword("initial=", Atom(_initial(row))))
        if row.retentive != plain.retentive:
            parts.append(Keyword("retentive=", Atom(str(row.retentive))))
    if row.comment:
        parts.append(Keyword("comment=", Atom(quoted(row.comment))))
    return Brackets("nickname(", tuple(parts), ")")


def _initial(row: Row) -> str:
    if row.address.kind is Kind.HEX:
        return f"0x{int(row.initial, 16):04X}"
    return quoted(row.initial) if row.address.kind is Kind.TEXT else row.initial
