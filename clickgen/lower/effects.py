"""What reading a condition depends on, and what running an instruction may change.

The one model that splitting, import, comparing and the fixes ask. Where no source says when CLICK changes something, it
may be at any moment (click-facts [message.later, scan.system-points]). Timers and counters are the exception: their
bits and current values change only where their instruction runs, or where another instruction writes the current value
(click-facts [bank.bit-and-value]). A split for every timer's bit would leave no rung as it was drawn.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from clickgen.device.banks import BANKS, TWIN_BANKS, Address, parse_address, twins_of
from clickgen.device.system import changes_by_itself
from clickgen.instructions.effects import COPY_FLAGS, Flow
from clickgen.ir.conditions import Condition, Contact
from clickgen.ir.operands import Cell, Immediate, Integer, Operand, Pointer, Range
from clickgen.ir.program import Action, Routine, actions_in, rungs_in
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands, leaves
from clickgen.lower.expand import OffDelays, copied_first

_INPUTS = ("X", "XD")


@dataclass
class Cells:
    """A set of addresses; a pointer's target may be any cell of its bank."""

    addresses: set[Address] = field(default_factory=set)
    banks: set[str] = field(default_factory=set)

    @classmethod
    def anything(cls) -> Cells:
        """All that an unknown instruction may write. No instruction writes an input (click-facts [bank.read-only])."""
        return cls(banks=set(BANKS).difference(_INPUTS))

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
        """True when some cell may be in both, or changes with one that may be.

        A word changes with its points, and the bit of a timer or counter with its current value.
        """
        few, many = sorted((self, other), key=lambda cells: len(cells.addresses))
        pointed = many._pointed_banks()
        for cell in few.addresses:
            if cell in many.addresses or cell.bank in pointed or not many.addresses.isdisjoint(twins_of(cell)):
                return True
        reached = few._pointed_banks()
        return bool(reached) and (
            not reached.isdisjoint(pointed) or any(cell.bank in reached for cell in many.addresses)
        )

    def _pointed_banks(self) -> set[str]:
        return self.banks | {TWIN_BANKS[bank] for bank in self.banks if bank in TWIN_BANKS}


def reads(condition: Condition) -> Cells:
    """The cells that a condition looks at."""
    cells = Cells()
    for operand in condition_operands(condition):
        cells.add(operand)
    return cells


def has_edge(condition: Condition) -> bool:
    return any(isinstance(leaf, Contact) and leaf.edge for leaf in leaves(condition))


def is_volatile(condition: Condition, received: Cells | None = None) -> bool:
    """True when looking twice in one scan may differ though no instruction wrote between.

    So it is with immediate contacts (click-facts [scan.io]), with system points that CLICK changes by itself, and with
    what arrives from other devices: ``received``, which ``Effects.received`` knows of a program.
    """
    if any(isinstance(operand, Immediate) for operand in condition_operands(condition)):
        return True
    cells = reads(condition)
    return any(map(changes_by_itself, cells.addresses)) or (received is not None and cells.meets(received))


def received_by(action: Action) -> Cells:
    """The cells that an instruction changes later in its own time: what messages bring, and how they fared."""
    cells = Cells()
    for touch in touches(action) if action.may_be_late else ():
        if touch.is_written:
            cells.add(touch.operand)
    return cells


class Effects:
    """What the instructions of a program write, and what changes in it by itself.

    A call writes what its subroutine writes, and an instruction that CLICK does not have what the instructions write
    that stand for it. One that is kept may write anything, also what it does not name.
    """

    def __init__(self, routines: Iterable[Routine], delays: OffDelays) -> None:
        self._routines: Mapping[str, Routine] = {routine.name: routine for routine in routines}
        self._delays = delays
        self._called: dict[str, Cells] = {}

    def writes(self, action: Action) -> Cells:
        """The cells that running an action may change, CLICK's status bits included."""
        if action.effects.flow is Flow.CALL:
            return self._writes_of(action.called)
        if action.effects.is_unknown:
            return Cells.anything()
        cells = Cells()
        flags = action.effects.flags + (COPY_FLAGS if _copies_first(action) else ())
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

    @cached_property
    def received(self) -> Cells:
        """What arrives from other devices, whenever that is: every message of the program may still be under way."""
        cells = Cells()
        for routine in self._routines.values():
            for rung in rungs_in(routine.rungs):
                for action in actions_in(rung.items):
                    cells.update(received_by(action))
        return cells

    def is_volatile(self, condition: Condition) -> bool:
        """True when looking twice in one scan of this program may differ though no instruction wrote between."""
        return is_volatile(condition, self.received)

    def _writes_of(self, name: str) -> Cells:
        if name not in self._called:
            self._called[name] = cells = Cells()
            routine = self._routines.get(name)
            for rung in rungs_in(routine.rungs) if routine else ():
                for action in actions_in(rung.items):
                    cells.update(self.writes(action))
        return self._called[name]


def _copies_first(action: Action) -> bool:
    """True for an instruction in front of which ``expand`` puts a copy."""
    return bool(copied_first(action)) or isinstance(action.args.get("jump_step"), Integer)
