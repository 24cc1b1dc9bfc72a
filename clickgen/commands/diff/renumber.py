"""Scratch cells of one side under the numbers of the other: they correspond if they have the same purpose.

Whichever cells are exchanged, a program does the same as before as long as all of them are clickgen's own and every
place that names one is changed. So a wrong choice may show a false difference, but never hides one.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from clickgen.click.compare.outputs import action_in, touched_by
from clickgen.click.read.grid import DrawnBox, DrawnRow, DrawnRung, Square
from clickgen.click.read.operands import ADDRESS
from clickgen.commands.diff.sides import Side
from clickgen.device.banks import Address, parse_address
from clickgen.ir.conditions import Compare, Contact
from clickgen.ir.operands import Cell, Operand, Pointer
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands
from clickgen.lower.effects import Cells
from clickgen.lower.place import PlaceScratch
from clickgen.lower.scratch import purpose_of, rung_of

_ADDRESS = re.compile(rf"(?<!\w){ADDRESS}(?!\w)")

Numbers = Mapping[Address, Address]
"""The scratch cells of the newer side, each with the address under which it is compared; no two share one."""


def numbers_of(one: Side, other: Side) -> Numbers:
    """Return the addresses for comparing the scratch cells of the other side; unchanged ones are left out."""
    if not other.scratch:
        return {}
    used = _Used(other)
    own = {address for address in other.scratch if used.is_alone(address)}
    waiting: defaultdict[tuple[str, str], list[Address]] = defaultdict(list)
    for bank, purpose, address in _purposes(one):
        waiting[bank, purpose].append(address)
    chosen: dict[Address, Address] = {}
    for bank, purpose, address in _purposes(other):
        if waiting[bank, purpose]:
            target = waiting[bank, purpose].pop(0)
            if address in own and (target in own or not used.meets(target)):
                chosen[address] = target
    # A cell displaced from its address takes one that has become free.
    order = sorted(chosen, key=lambda address: address.sort_key)
    targets = set(chosen.values())
    free = [address for address in order if address not in targets]
    driven = [address for address in sorted(targets, key=lambda each: each.sort_key) if address not in chosen]
    for address in driven:
        place = next(each for each in free if each.bank == address.bank)
        free.remove(place)
        chosen[address] = place
    return {address: target for address, target in chosen.items() if address != target}


def _purposes(side: Side) -> Iterator[tuple[str, str, Address]]:
    """Yield bank and purpose of each scratch cell, in the order of the rungs."""
    for row in sorted(side.scratch_rows, key=lambda row: (rung_of(row.comment), -row.address.number)):
        yield row.address.bank, purpose_of(row.comment), row.address


class _Used:
    """The addresses that a side names, and those that it may touch without naming them."""

    def __init__(self, side: Side) -> None:
        self._cells = Cells()
        self._unnamed = Cells()
        for routine in side.routines:
            for rung in routine.rungs:
                for row in rung.rows:
                    for square in row.squares:
                        if square.contact is not None:
                            self._add(condition_operands(square.contact))
                for box in rung.boxes:
                    self._add_box(box)

    def _add_box(self, box: DrawnBox) -> None:
        action = action_in(box)
        if action is None:
            self._unnamed.update(touched_by(box))
        else:
            self._add(touch.operand for touch in touches(action))

    def _add(self, operands: Iterable[Operand]) -> None:
        for operand in operands:
            cells = Cells()
            cells.add(operand)
            self._cells.update(cells)
            # The text of this program does not decide which cell a pointer finds; no program relies on a scratch cell.
            if len(cells.addresses) > 1 and not isinstance(operand, Cell | Pointer):
                self._unnamed.update(cells)

    def is_alone(self, address: Address) -> bool:
        """True for an address that is touched only where it is named."""
        return address not in self._unnamed.addresses and address.bank not in self._unnamed.banks

    def meets(self, address: Address) -> bool:
        return address in self._cells.addresses or not self.is_alone(address)


def renumbered(rung: DrawnRung, numbers: Numbers) -> DrawnRung:
    """Return the rung with other numbers; one that names none of these cells is the same object."""
    if not numbers:
        return rung
    rewriter = PlaceScratch(numbers)

    def square(each: Square) -> Square:
        contact = rewriter.condition(each.contact) if each.contact is not None else None
        assert contact is None or isinstance(contact, Contact | Compare)
        return each if contact == each.contact else replace(each, contact=contact)

    def text(token: str) -> str:
        parts = token.split('"')
        parts[::2] = (_ADDRESS.sub(lambda match: _in_place_of(match[0], numbers), part) for part in parts[::2])
        return '"'.join(parts)

    def row(each: DrawnRow) -> DrawnRow:
        return replace(each, squares=tuple(map(square, each.squares)), output=text(each.output))

    rows = tuple(map(row, rung.rows))
    boxes = tuple(
        replace(box, token=text(box.token), pins=tuple((text(token), place) for token, place in box.pins))
        for box in rung.boxes
    )
    return rung if (rows, boxes) == (rung.rows, rung.boxes) else replace(rung, rows=rows, boxes=boxes)


def _in_place_of(token: str, numbers: Numbers) -> str:
    address = parse_address(token)
    return str(numbers[address]) if address is not None and address in numbers else token
