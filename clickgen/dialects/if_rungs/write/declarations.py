"""Declares in the program the names of a program that has no address table beside it."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.device.banks import BANKS, Kind
from clickgen.dialects.if_rungs.write.expressions import operand_text, quoted
from clickgen.dialects.if_rungs.write.layout import Atom, Brackets, Keyword, Piece, lines
from clickgen.ir.operands import Cell, Named
from clickgen.table.rows import Row, default_row, initial_fault
from clickgen.text.source import Span

_HERE = Span("", 1, 1, 1, 2)


def declarations(rows: Iterable[Row]) -> str:
    """``nickname(c.Run, c[7])`` for each of these rows."""
    return "\n".join(line for row in rows for line in lines(_declaration(row), 0))


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
