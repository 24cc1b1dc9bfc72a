"""The parts of a difference: changes of rungs, of routines, and of initial values of addresses."""

from __future__ import annotations

from dataclasses import dataclass

from clickgen.commands.diff.sides import Side
from clickgen.commands.diff.words import WordedRung, Wording
from clickgen.device.banks import Address
from clickgen.emit.rung_words import Names

CHANGED, ADDED, REMOVED, MOVED, COMMENTED = KINDS = ("changed", "added", "removed", "moved", "commented")
"""The kinds of change of a rung; a comment is not logic."""
RENAMED, SAME = "renamed", "same"


@dataclass(frozen=True)
class RungChange:
    """The change of a rung: as it was, as it is, and the difference.

    ``is_unknown`` if nobody knows whether both do the same; ``is_drawn`` if words do not show the difference, so
    that the cells must.
    """

    kind: str
    one: WordedRung | None
    other: WordedRung | None
    reason: str = ""
    is_unknown: bool = False
    is_drawn: bool = False

    @property
    def is_logic(self) -> bool:
        """False if only a comment differs."""
        return self.kind != COMMENTED


@dataclass(frozen=True)
class RoutineChange:
    """A routine: ``same``, ``renamed``, ``added`` or ``removed`` by its name, and the changes of its rungs.

    A rung that moved to another routine is in both of them. ``rungs`` counts those of the newer side, for a
    removed routine those of the older.
    """

    kind: str
    name: str
    former: str
    rungs: int
    changes: tuple[RungChange, ...] = ()

    @property
    def differs(self) -> bool:
        """True if the routine does something else."""
        return self.kind != SAME or any(change.is_logic for change in self.changes)

    @property
    def counted(self) -> tuple[RungChange, ...]:
        """The changes that count: if a routine came or went, so did its rungs."""
        return tuple(change for change in self.changes if change.kind != self.kind)


@dataclass(frozen=True)
class ValueChange:
    """An address with another initial value, or another retention."""

    address: Address
    what: str
    one: str
    other: str


@dataclass(frozen=True)
class Difference:
    """All the differences of two sides. ``drawn_otherwise`` counts rungs that only look different."""

    one: Side
    other: Side
    names: tuple[Names, Names]
    routines: tuple[RoutineChange, ...]
    values: tuple[ValueChange, ...]
    drawn_otherwise: int
    notes: tuple[str, ...]
    wording: Wording

    @property
    def differs(self) -> bool:
        """True if the two do not do the same, as far as is known."""
        return bool(self.values) or any(routine.differs for routine in self.routines)

    def count(self, kind: str) -> int:
        """The rungs with this change; one that moved counts once, those of a routine that came or went do not."""
        found = [change for routine in self.routines for change in routine.counted if change.kind == kind]
        return len({id(change) for change in found})

    @property
    def rungs(self) -> int:
        """How many rungs were compared."""
        return sum(routine.rungs for routine in self.routines)
