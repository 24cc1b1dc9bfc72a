"""What reading a condition depends on, and what running an instruction may change."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from clickgen.device.banks import BANKS, TWIN_BANKS, Address, parse_address
from clickgen.instructions.control import CALL
from clickgen.instructions.raw import RAW
from clickgen.instructions.spec import COPY_FLAGS
from clickgen.ir.conditions import Condition
from clickgen.ir.operands import Cell, Immediate, Operand, Pointer, Range
from clickgen.ir.program import Action, Routine, actions_in, rungs_in
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands, leaves
from clickgen.lower.expand import OffDelays, copied_first


@dataclass
class Cells:
    """A set of addresses; a pointer's target may be any cell of its bank."""

    addresses: set[Address] = field(default_factory=set)
    banks: set[str] = field(default_factory=set)

    def add(self, operand: Operand) -> None:
        if isinstance(operand, Immediate):
            operand = operand.target
        if isinstance(operand, Cell):
            self.addresses.add(operand.address)
        elif isinstance(operand, Range):
            self.addresses.update(operand.addresses())
        elif isinstance(operand, Pointer):
            self.banks.add(operand.bank)

    def update(self, other: Cells) -> None:
        self.addresses |= other.addresses
        self.banks |= other.banks

    def meets(self, other: Cells) -> bool:
        """True when some cell may be in both."""
        if not self.addresses.isdisjoint(other.addresses):
            return True
        mine, theirs = self._touched_banks(), other._touched_banks()
        if self.banks & theirs or other.banks & mine:
            return True
        return any(TWIN_BANKS.get(bank) in theirs for bank in mine)

    def _touched_banks(self) -> set[str]:
        return self.banks | {address.bank for address in self.addresses}


def reads(condition: Condition) -> Cells:
    """The cells that a condition looks at."""
    cells = Cells()
    for operand in condition_operands(condition):
        cells.add(operand)
    return cells


def has_edge(condition: Condition) -> bool:
    return any(getattr(leaf, "edge", "") for leaf in leaves(condition))


def is_volatile(condition: Condition) -> bool:
    """True when looking twice in one scan may differ though no instruction wrote between: immediate contacts."""
    return any(isinstance(operand, Immediate) for operand in condition_operands(condition))


class Effects:
    """What instructions write. A call writes what its subroutine writes, and an instruction that CLICK does not have
    what the instructions write that stand for it. One that is kept may write anything, also what it does not name."""

    def __init__(self, routines: Iterable[Routine], delays: OffDelays) -> None:
        self._routines: Mapping[str, Routine] = {routine.name: routine for routine in routines}
        self._delays = delays
        self._called: dict[str, Cells] = {}

    def writes(self, action: Action) -> Cells:
        """The cells that running an action may change, CLICK's status bits included."""
        if action.spec is CALL:
            return self._writes_of(action.word("subroutine"))
        if action.spec is RAW:
            return Cells(banks=set(BANKS))
        cells = Cells()
        flags = action.spec.sets_flags + (COPY_FLAGS if copied_first(action) else ())
        for flag in flags:
            address = parse_address(flag)
            assert address is not None
            cells.addresses.add(address)
        for bit in self._delays.bits_of(action):
            cells.add(bit)
        for touch in touches(action):
            if touch.is_written:
                cells.add(touch.operand)
        return cells

    def _writes_of(self, name: str) -> Cells:
        if name not in self._called:
            self._called[name] = cells = Cells()
            routine = self._routines.get(name)
            for rung in rungs_in(routine.rungs) if routine else ():
                for action in actions_in(rung.items):
                    cells.update(self.writes(action))
        return self._called[name]
