"""What a difference consists of: changes of rungs, of routines, and of what addresses begin with."""

from __future__ import annotations

from dataclasses import dataclass

from clickgen.commands.diff.sides import Side
from clickgen.commands.diff.words import WordedRung, Wording
from clickgen.device.banks import Address
from clickgen.emit.rung_words import Names

CHANGED, ADDED, REMOVED, MOVED, COMMENTED = KINDS = ("changed", "added", "removed", "moved", "commented")
"""What can happen to a rung; a comment is no logic."""
RENAMED, SAME = "renamed", "same"


@dataclass(frozen=True)
class RungChange:
    """What happened to a rung: as it was, as it is, and how that differs.

    ``is_unknown`` when nobody knows whether both do the same; ``is_drawn`` when words do not show the difference, so
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
        """False where only a comment differs."""
        return self.kind != COMMENTED


@dataclass(frozen=True)
class RoutineChange:
    """A routine: ``same``, ``renamed``, ``added`` or ``removed`` by its name, and what happened to its rungs.

    A rung that moved to another routine stands in both of them. ``rungs`` counts those of the newer side, of a
    removed routine those of the older.
    """

    kind: str
    name: str
    former: str
    rungs: int
    changes: tuple[RungChange, ...] = ()

    @property
    def differs(self) -> bool:
        """True when the routine does something else."""
        return self.kind != SAME or any(change.is_logic for change in self.changes)

    @property
    def counted(self) -> tuple[RungChange, ...]:
        """The changes that count: with a routine that came or went its rungs did, too."""
        return tuple(change for change in self.changes if change.kind != self.kind)


@dataclass(frozen=True)
class ValueChange:
    """An address that begins with another value, or keeps it otherwise when the power goes."""

    address: Address
    what: str
    one: str
    other: str


@dataclass(frozen=True)
class Difference:
    """Everything that two sides differ in. ``drawn_otherwise`` counts rungs that only look different."""

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
        """True when the two do not do the same, as far as is known."""
        return bool(self.values) or any(routine.differs for routine in self.routines)

    def count(self, kind: str) -> int:
        """The rungs to which this happened; one that moved counts once, those of a routine that came or went do not."""
        found = [change for routine in self.routines for change in routine.counted if change.kind == kind]
        return len({id(change) for change in found})

    @property
    def rungs(self) -> int:
        """How many were compared."""
        return sum(routine.rungs for routine in self.routines)
