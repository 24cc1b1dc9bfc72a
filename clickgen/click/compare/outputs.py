"""Instructions of the output column in one spelling, and what each of them looks at and may change."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import NamedTuple

from clickgen.click.compare.contacts import operand_name
from clickgen.click.draw.tokens import action_token, pin_token
from clickgen.click.read.grid import DrawnBox, DrawnRung
from clickgen.click.read.operands import ADDRESS
from clickgen.click.read.tokens import action_of, specs_of
from clickgen.device.banks import Address, parse_address
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import Always
from clickgen.ir.made import NOP_TOKEN
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action
from clickgen.ir.reach import touches
from clickgen.lower.effects import Cells, Effects, received_by
from clickgen.lower.expand import OffDelays
from clickgen.text.source import Span

_ADDRESS = re.compile(rf"(?<![A-Za-z]){ADDRESS}")
_NOWHERE = Span("", 1, 1, 1, 2)


class Said(NamedTuple):
    """An instruction and its inputs, as tokens."""

    token: str
    pins: tuple[str, ...] = ()


def outputs_of(rung: DrawnRung) -> list[DrawnBox]:
    """The instructions of a rung that do anything."""
    return [box for box in rung.boxes if box.token != NOP_TOKEN]


def said_by(box: DrawnBox) -> Said:
    """A box in the one spelling of its meaning, numbers by their value; as written if it is unknown."""
    return _said(_written(box))


def action_in(box: DrawnBox) -> Action | None:
    """The instruction of a box, its inputs always on; None if it is unknown."""
    return _action(_written(box))


def _written(box: DrawnBox) -> Said:
    return Said(box.token, tuple(token for token, _ in box.pins))


def _action(written: Said) -> Action | None:
    action = _parsed(written)
    return action if action is None or not action.effects.is_unknown else None


@lru_cache(maxsize=4096)
def _parsed(written: Said) -> Action | None:
    return action_of(written.token, {pin: Always(_NOWHERE) for pin in written.pins}, _NOWHERE)


@lru_cache(maxsize=4096)
def _said(written: Said) -> Said:
    action = _action(written)
    if action is None:
        return written
    pins = tuple(
        pin_token(action, param, operand_name) for param in action.spec.pins if action.pin(param.name) is not None
    )
    return Said(action_token(action, operand_name), pins) if len(pins) == len(written.pins) else written


# -- effects ----------------------------------------------------------------------------------------------------------


def _no_scratch(bank: str, purpose: str, span: Span) -> Cell:
    """Unused: what CLICK holds is not lowered any more."""
    raise NotImplementedError


_EFFECTS = Effects((), OffDelays(_no_scratch))
"""What CLICK's own instructions write; except calls, whose subroutines are not known here."""


@dataclass
class Writes:
    """The addresses that instructions may have changed; ``anything`` is the token of one that may have changed any."""

    cells: Cells = field(default_factory=Cells)
    anything: str = ""

    @classmethod
    def unknown(cls, token: str) -> Writes:
        """The writes of an unknown instruction."""
        return cls(Cells.anything(), token)

    def add(self, box: DrawnBox, calls: Mapping[str, Writes]) -> None:
        action = action_in(box)
        if action is None:
            self.update(Writes.unknown(box.token))
        elif action.effects.flow is Flow.CALL:
            self.update(calls.get(action.called) or Writes.unknown(box.token))
        else:
            self.cells.update(_EFFECTS.writes(action))

    def update(self, other: Writes) -> None:
        self.cells.update(other.cells)
        self.anything = self.anything or other.anything


@dataclass(frozen=True)
class Surroundings:
    """The known facts of the program around the compared rungs.

    ``calls`` has what each subroutine may change; a call of any other may change everything. ``received`` is what
    arrives from other devices in its own time.
    """

    calls: Mapping[str, Writes] = field(default_factory=dict)
    received: Cells = field(default_factory=Cells)

    @classmethod
    def of(cls, routines: Mapping[str, Sequence[DrawnRung]]) -> Surroundings:
        """``routines`` has all of the program's routines by CLICK's names, main among them."""
        received = Cells()
        for box in (box for rungs in routines.values() for rung in rungs for box in rung.boxes):
            received.update(_received_by(box))
        return cls({name: _writes_of(rungs) for name, rungs in routines.items()}, received)


ALONE = Surroundings()
"""The surroundings of rungs whose program is unknown."""


def _writes_of(rungs: Iterable[DrawnRung]) -> Writes:
    """The addresses that the rungs of a subroutine may change. CLICK has no calls in subroutines."""
    found = Writes()
    for rung in rungs:
        for box in rung.boxes:
            found.add(box, {})
    return found


def _received_by(box: DrawnBox) -> Cells:
    action = _parsed(_written(box))
    return touched_by(box) if action is None else received_by(action)


def touched_by(box: DrawnBox) -> Cells:
    """The cells that an instruction looks at or changes; for an unknown one, the whole banks that it names."""
    action = action_in(box)
    if action is None:
        texts = (box.token, *(token for token, _ in box.pins))
        return Cells(banks={address.bank for text in texts for address in _addresses(text)})
    cells = Cells()
    for touch in touches(action):
        cells.add(touch.operand)
    return cells


def _addresses(text: str) -> Iterator[Address]:
    for match in _ADDRESS.finditer(text):
        address = parse_address(match[0])
        if address is not None:
            yield address


def leaves_early(box: DrawnBox) -> bool:
    """True if an instruction keeps CLICK from looking at the rest of a routine in this scan."""
    return any(spec.effects.leaves for spec in specs_of(_name(box)))


def loops(box: DrawnBox) -> bool:
    """True for both ends of a loop."""
    return any(spec.effects.flow in (Flow.LOOP, Flow.NEXT) for spec in specs_of(_name(box)))


def _name(box: DrawnBox) -> str:
    return box.token.partition("(")[0].strip()
