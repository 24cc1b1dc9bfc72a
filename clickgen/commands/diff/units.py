"""Rungs that belong together: one of them writes a scratch cell that only others of them read."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from functools import cached_property

from clickgen.click.compare.outputs import Said, touched_by
from clickgen.commands.diff.routines import Routines
from clickgen.commands.diff.words import WordedRung, without
from clickgen.device.banks import Address
from clickgen.ir.conditions import Contact
from clickgen.ir.operands import Cell
from clickgen.lower.effects import Cells, reads

_RUNGS_MAX = 48
"""Rungs further apart do not come from one rung of a program."""
_BANK = "C"
"""The bank of scratch bits, which one rung drives and others look at; scratch registers only hold values."""


@dataclass(frozen=True)
class Unit:
    """Neighbouring rungs, most often one, by their ``places``; ``own`` has the scratch cells that only they use.

    ``outputs`` are what they drive, these cells aside; in ``words`` they have no numbers.
    """

    places: range
    rungs: tuple[WordedRung, ...]
    own: tuple[Address, ...] = ()

    @cached_property
    def outputs(self) -> tuple[Said, ...]:
        coils = {f"out({address})" for address in self.own}
        return tuple(said for rung in self.rungs for said in rung.outputs if said.token not in coils)

    @cached_property
    def words(self) -> tuple[Hashable, ...]:
        if not self.own:
            return tuple(rung.words for rung in self.rungs)
        words = tuple(rung.lines for rung in self.rungs)
        for number, address in enumerate(self.own):
            words = tuple(tuple(without(line, address, f"scratch {number}") for line in lines) for lines in words)
        return words


class Units:
    """The rungs of one side, and which of them use its scratch cells."""

    def __init__(self, routines: Routines, scratch: frozenset[Address]) -> None:
        self._scratch = frozenset(address for address in scratch if address.bank == _BANK)
        self._users: defaultdict[Address, set[int]] = defaultdict(set)
        self._cells: defaultdict[int, list[Address]] = defaultdict(list)
        self._loose: set[Address] = set()
        """Scratch bits in more than a coil and its contacts: their numbers may matter."""
        for rungs in routines.values() if self._scratch else ():
            for rung in rungs:
                self._add(rung)

    def _add(self, rung: WordedRung) -> None:
        used: list[Address] = []
        for row in rung.drawn.rows:
            for contact in (square.contact for square in row.squares):
                if isinstance(contact, Contact) and isinstance(contact.operand, Cell):
                    used.append(contact.operand.address)
                elif contact is not None:
                    self._loose |= self._met(reads(contact))
        for box in rung.drawn.boxes:
            met = self._met(touched_by(box))
            coil = {address for address in met if box.token == f"out({address})"}
            used += coil
            self._loose |= met - coil
        for address in dict.fromkeys(used):
            if address in self._scratch:
                self._users[address].add(id(rung))
                self._cells[id(rung)].append(address)

    def _met(self, cells: Cells) -> frozenset[Address]:
        """The scratch bits that may be among these cells."""
        return self._scratch if _BANK in cells.banks else self._scratch & cells.addresses

    def of(self, rungs: Sequence[WordedRung], places: range) -> list[Unit]:
        """The rungs at these places, those that share scratch cells of their own in one unit."""
        place = {id(rungs[n]): n for n in places}
        units: list[Unit] = []
        start = places.start
        while start < places.stop:
            stop, reached = start + 1, start
            while reached < stop:
                own = [address for address in self._cells.get(id(rungs[reached]), ()) if address not in self._loose]
                users = [self._users[address] for address in own if self._users[address] <= place.keys()]
                last = max((place[user] for those in users for user in those), default=reached)
                stop, reached = max(stop, last + 1), reached + 1
            if stop - start > _RUNGS_MAX:
                stop = start + 1
            units.append(self._unit(rungs, range(start, stop)))
            start = stop
        return units

    def _unit(self, rungs: Sequence[WordedRung], places: range) -> Unit:
        held = [rungs[n] for n in places]
        return Unit(places, tuple(held), tuple(self.own(held)))

    def own(self, rungs: Sequence[WordedRung]) -> list[Address]:
        """The scratch cells that these rungs use and no other rung of this side, in the order of their first use."""
        users = {id(rung) for rung in rungs}
        cells = dict.fromkeys(address for rung in rungs for address in self._cells.get(id(rung), ()))
        return [address for address in cells if address not in self._loose and self._users[address] <= users]
