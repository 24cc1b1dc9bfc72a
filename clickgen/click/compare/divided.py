"""A run of rungs as one: its outputs, when each has power, and whether one rung would do the same.

In one rung every condition is looked at before the first output runs. In a run a later rung looks again, after the
outputs of the earlier ones. That is the same as long as a contact reads nothing that an earlier output may change, and
nothing that must not be looked at twice. Splitting puts every other condition on a scratch bit (``lower/split.py``).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property

from clickgen.click.compare.contacts import Literal, literal_of
from clickgen.click.compare.outputs import (
    ALONE,
    Said,
    Surroundings,
    Writes,
    action_in,
    leaves_early,
    loops,
    outputs_of,
    said_by,
    touched_by,
)
from clickgen.click.compare.power import Logic, contacts_before, power_of
from clickgen.click.read.grid import DrawnBox, DrawnRung
from clickgen.device.banks import Address
from clickgen.ir.conditions import Compare, Contact
from clickgen.ir.operands import Cell, Immediate
from clickgen.lower.effects import Cells, is_volatile, reads


@dataclass
class _Part:
    """One rung of a run: its outputs, those that define scratch bits, and the contacts that decide."""

    rung: DrawnRung
    outputs: list[DrawnBox]
    contacts: list[Contact | Compare]
    definitions: dict[Address, int] = field(default_factory=dict)
    """The row of each scratch bit that later rungs of the run read."""


@dataclass(frozen=True)
class Run:
    """Rungs that together represent one. ``scratch`` has the addresses that may serve this run alone."""

    rungs: tuple[DrawnRung, ...]
    scratch: frozenset[Address] = frozenset()
    surroundings: Surroundings = ALONE

    @cached_property
    def _parts(self) -> list[_Part]:
        parts: list[_Part] = []
        looked_at: set[Address] = set()
        for rung in reversed(self.rungs):
            outputs = outputs_of(rung)
            rows = [row for box in outputs for row in (box.row, *(row for _, row in box.pins))]
            part = _Part(rung, outputs, list(contacts_before(rung, rows)))
            for box in outputs:
                defined = _coil(box)
                if defined in looked_at:
                    part.definitions[defined] = box.row
            part.outputs = [box for box in outputs if _coil(box) not in part.definitions]
            looked_at |= {bit for contact in part.contacts if (bit := _bit(contact)) in self.scratch}
            parts.append(part)
        return parts[::-1]

    @cached_property
    def outputs(self) -> list[Said]:
        """The outputs in order, except definitions of scratch bits."""
        return [said_by(box) for part in self._parts for box in part.outputs]

    @cached_property
    def literals(self) -> dict[Literal, None]:
        """The contacts in the order of the drawing, with those that decide nothing at the end."""
        defined = {str(bit) for part in self._parts for bit in part.definitions}
        contacts = [contact for part in self._parts for contact in part.contacts]
        squares = (square for rung in self.rungs for row in rung.rows for square in row.squares)
        contacts += [square.contact for square in squares if square.contact is not None]
        found = dict.fromkeys(map(literal_of, contacts))
        return {literal: None for literal in found if literal.name and literal.name not in defined}

    @cached_property
    def looks(self) -> Counter[str]:
        """How often the rungs look at something that may change between two looks.

        A rung looks at its conditions before its outputs run, but at a terminal itself once for each contact.
        """
        looks: Counter[str] = Counter()
        for rung in self.rungs:
            squares = (square for row in rung.rows for square in row.squares)
            contacts = [square.contact for square in squares if square.contact is not None]
            looks.update(literal_of(contact).name for contact in contacts if _is_immediate(contact))
            looks.update({literal_of(contact).name for contact in contacts if self._arrives(contact)})
        return looks

    def _arrives(self, contact: Contact | Compare) -> bool:
        """True for something that CLICK or another device changes in its own time, except terminals.

        click-facts [message.later, scan.system-points]
        """
        return not _is_immediate(contact) and is_volatile(contact, self.surroundings.received)

    def powers(self, logic: Logic) -> list[list[int]]:
        """For each output, when it and then each of its inputs has power, by what was on before the run."""
        known: dict[str, int] = {"": logic.always}

        def conducts(contact: Contact | Compare) -> int:
            name, is_negated = literal_of(contact)
            value = known[name] if name in known else logic.variable(name)
            return logic.opposite(value) if is_negated else value

        found: list[list[int]] = []
        for part in self._parts:
            level = power_of(part.rung, conducts, logic)
            found += [[level[box.row], *(level[row] for _, row in box.pins)] for box in part.outputs]
            known |= {str(bit): level[row] for bit, row in part.definitions.items()}
        return found

    # -- what only one rung would do ----------------------------------------------------------------------------------

    @cached_property
    def doubt(self) -> str:
        """The reason why the rungs together may not do the same as one rung; "" if they must."""
        return next(self._doubts(), "")

    def _doubts(self) -> Iterator[str]:
        past = _Past()
        dropped = Cells({bit for part in self._parts for bit in part.definitions})
        for index, part in enumerate(self._parts):
            for contact in part.contacts:
                bit = _bit(contact)
                if bit in self.scratch and bit is not None:
                    if bit not in past.defined:
                        yield f"rung {index + 1} reads the scratch bit {bit}, which no rung above it defines"
                    elif past.writes.cells.meets(reads(contact)):
                        yield f"the scratch bit {bit} may be written between its definition and rung {index + 1}"
                elif reads(contact).addresses & self.scratch:
                    yield f"rung {index + 1} looks at the scratch address {literal_of(contact).name}"
                else:
                    yield from past.doubts(contact, index, self.surroundings)
            is_last = index + 1 == len(self._parts)
            for box in part.outputs:
                if len(self._parts) > 1 and loops(box) and not (is_last and box is part.outputs[-1]):
                    yield f"{said_by(box).token} is between the rungs"
                if leaves_early(box) and not is_last:
                    # Within one rung CLICK may run the outputs below it: click-facts [control.return-below]
                    yield f"{said_by(box).token} is above outputs of the same rung, and is drawn in an earlier rung"
                if touched_by(box).meets(dropped):
                    yield f"{said_by(box).token} may touch a scratch bit"
            past.add(part, self.surroundings)


@dataclass
class _Past:
    """What ran before a rung of the run."""

    writes: Writes = field(default_factory=Writes)
    defined: set[Address] = field(default_factory=set)
    has_run: bool = False

    def add(self, part: _Part, surroundings: Surroundings) -> None:
        for box in part.outputs:
            self.writes.add(box, surroundings.calls)
            self.has_run = True
        self.defined |= part.definitions.keys()

    def doubts(self, contact: Contact | Compare, index: int, surroundings: Surroundings) -> Iterator[str]:
        """The reasons why a contact may look different in this rung than before the first one."""
        name = literal_of(contact).name
        if not name:
            return
        where = f"{name} in rung {index + 1}"
        if self.has_run and is_volatile(contact, surroundings.received):
            look = "looks at the terminal itself, which" if _is_immediate(contact) else "changes by itself: it"
            yield f"{where} {look} may have changed since the first rung"
        if self.writes.cells.meets(reads(contact)):
            writer = f": {self.writes.anything} may change anything" if self.writes.anything else ""
            yield f"{where} may be changed by an output above it{writer}"


def _is_immediate(contact: Contact | Compare) -> bool:
    return isinstance(contact, Contact) and isinstance(contact.operand, Immediate)


def _bit(contact: Contact | Compare) -> Address | None:
    """The bit of a plain contact."""
    if not isinstance(contact, Contact) or contact.edge or not isinstance(contact.operand, Cell):
        return None
    return contact.operand.address


def _coil(box: DrawnBox) -> Address | None:
    """The bit that a plain coil drives."""
    action = action_in(box)
    if action is None or not action.effects.follows_power or len(action.args) != 1:
        return None
    target = action.driven
    return target.address if isinstance(target, Cell) else None
