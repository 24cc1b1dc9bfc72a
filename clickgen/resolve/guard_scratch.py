"""Refuse programs that use the scratch cells of clickgen."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.device.banks import Address
from clickgen.ir.operands import Cell, Immediate, Operand, Range
from clickgen.ir.program import Program
from clickgen.ir.reach import reaching
from clickgen.ir.walk import program_operands
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import is_scratch


def guard_scratch(program: Program, table: AddressTable, problems: Diagnostics) -> None:
    """Refuse a program that uses one of clickgen's own scratch cells: both would write it."""
    scratch = {row.address: row for row in table.rows if is_scratch(row)}
    if not scratch:
        return
    touched = [(operand, addresses_in([operand])) for operand in program_operands(program)]
    for operand, length in reaching(program):
        if isinstance(operand, Cell):
            bank, number, _ = operand.address
            touched.append((operand, (Address(bank, number + n) for n in range(length))))
    for operand, addresses in touched:
        for address in addresses:
            row = scratch.get(address)
            if row is not None:
                problems.add(
                    "CG205",
                    operand.span,
                    f"{address} is {row.nickname}, which clickgen uses for itself ({table.place(row)})",
                    "use another address here, or delete that row of the table: then clickgen chooses another cell",
                )
                break


def addresses_in(operands: Iterable[Operand]) -> Iterable[Address]:
    """Yield every address that the operands name by number."""
    for operand in operands:
        if isinstance(operand, Immediate):
            operand = operand.target
        if isinstance(operand, Cell):
            yield operand.address
        elif isinstance(operand, Range):
            yield from operand.addresses()
