"""Puts scratch addresses in place of their placeholders, when every use has one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from clickgen.device.banks import Address
from clickgen.ir.operands import Cell, Named
from clickgen.ir.walk import Rewriter, condition_operands, items_operands
from clickgen.lower.split import ClickRoutine, ClickRung
from clickgen.table.rows import Row


def placed_routines(routines: tuple[ClickRoutine, ...], placed: Mapping[Address, Row]) -> tuple[ClickRoutine, ...]:
    """Return the routines with scratch addresses; ``placed`` gives the table row of each placeholder."""
    if not placed:
        return routines
    rewriter = PlaceScratch({placeholder: row.address for placeholder, row in placed.items()})
    return tuple(rewriter.routine(routine) for routine in routines)


class PlaceScratch(Rewriter):
    """``addresses`` gives each placeholder its address."""

    def __init__(self, addresses: Mapping[Address, Address]) -> None:
        self._addresses = addresses

    def routine(self, routine: ClickRoutine) -> ClickRoutine:
        """Return the routine with its scratch addresses; rungs without any keep their drawing too."""
        return replace(routine, rungs=tuple(map(self._rung, routine.rungs)))

    def _rung(self, rung: ClickRung) -> ClickRung:
        operands = (*condition_operands(rung.condition), *items_operands(rung.items))
        if not any(isinstance(operand, Cell) and operand.address in self._addresses for operand in operands):
            return rung
        return replace(rung, condition=self.condition(rung.condition), items=self.items(rung.items))

    def cell(self, cell: Named | Cell) -> Named | Cell:
        address = self._addresses.get(cell.address) if isinstance(cell, Cell) else None
        return cell if address is None else Cell(address, cell.span)
