"""A rung that acts in the same scan on what a rung above it has just changed: a toggle goes back at once."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.changes import Changes, Extent, extents_written, meets
from clickgen.facts.copied import put_in
from clickgen.facts.facts import STARTING, Facts, Placed
from clickgen.facts.pulses import Pulses
from clickgen.facts.scan import Step, scans
from clickgen.facts.uses import addresses_of
from clickgen.facts.written import is_relative, left_in
from clickgen.instructions.effects import Effects, Flow, Shape
from clickgen.ir.conditions import All, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Hex, Immediate, Integer, Operand, Real, Single
from clickgen.ir.program import Rung
from clickgen.ir.walk import condition_operands
from clickgen.logic.conditions import are_exclusive, implies, terms_of
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

# click-facts [scan.conditions]
CODE = "CG544"

_BITS_MAX = 16
"""A set or reset of more bits than this is not a toggle."""
_BEFORE_MAX = 4
"""This many writes of one address before an action are looked at."""
_RUNGS_MAX = 20
"""A rung further up is not considered."""


@dataclass(eq=False, slots=True)
class _Frame:
    """A run through a routine, from its call to its return."""

    start: int
    barrier: int = -1
    """The last step after which nobody knows what runs in it."""
    rung: Rung | None = None
    number: int = -1
    """How many of its rungs have run before this one."""


class _Write(NamedTuple):
    """A constant that an action puts into an address."""

    step: Step
    frame: _Frame
    at: int
    """The place of the step in the scan."""
    number: int
    """The place of its rung in its run through the routine."""
    slot: int
    """The place of its rung in the scan."""
    value: Single | None
    """None for a bit that is turned off or on."""
    is_on: bool

    @property
    def placed(self) -> Placed:
        return self.step.placed


class _Slot(NamedTuple):
    """A rung in its scan: its reads and its writes, with the ids of the actions that wrote."""

    rung: Rung
    looked_at: list[list[Extent]]
    changed: list[tuple[int, list[Extent]]]


def find(facts: Facts) -> Findings:
    shared = _Shared(facts)
    for steps in scans(facts):
        walk = _Walk(shared)
        for step in steps:
            walk.run(step)
    yield from shared.found


class _Shared:
    """Shared look-ups of the walks through a program."""

    def __init__(self, facts: Facts) -> None:
        self.facts = facts
        self.found: list[Diagnostic] = []
        self.changes, self.pulses = Changes(facts), Pulses(facts)
        self.said: set[int] = set()
        """The rungs that were reported."""
        self.reads: dict[int, list[Extent]] = defaultdict(list)
        """The stretches that each rung looks at and reads."""
        self.reads_of: dict[str, list[Extent]] = defaultdict(list)
        """The same for each routine."""
        for use in facts.uses.every:
            if not use.is_written:
                extents = extents_written(use.operand)
                self.reads[id(use.rung)] += extents
                self.reads_of[use.routine.name] += extents


class _Walk:
    """One scan from its first rung to its last, with the constants that its rungs have written so far."""

    def __init__(self, shared: _Shared) -> None:
        self._shared, self._facts, self._changes = shared, shared.facts, shared.changes
        self._base = self._frame = _Frame(0)
        self._call: Placed | None = None
        self._at = 0
        self._slots: list[_Slot] = []
        self._slot_of: dict[int, int] = {}
        """The slot of each rung so far."""
        self._writes: dict[Address, list[_Write]] = defaultdict(list)

    def run(self, step: Step) -> None:
        placed, frame = step.placed, self._enter(step)
        self._at += 1
        if _is_barrier(placed.effects) or placed.loop:
            frame.barrier = self._at
            return
        slot = self._slots[-1]
        for address, value, is_on in _constants(placed):
            write = _Write(step, frame, self._at, frame.number, len(self._slots) - 1, value, is_on)
            for earlier in self._writes[address]:
                self._judge(address, earlier, write)
            self._writes[address] = [*self._writes[address][1 - _BEFORE_MAX :], write]
        slot.changed.append((id(placed.action), self._changes.of(placed.action)))
        if placed.effects.flow is Flow.CALL:
            slot.looked_at.append(self._shared.reads_of[placed.action.called])

    def _enter(self, step: Step) -> _Frame:
        is_new = step.call is not self._call
        if is_new:
            self._call = step.call
            self._frame = self._base
            if step.call is not None:
                self._frame = _Frame(self._at)
                self._open(step.call.rung)
        frame, rung = self._frame, step.placed.rung
        if frame.rung is not rung:
            frame.rung, frame.number = rung, frame.number + 1
            is_new = True
        if is_new:
            self._open(rung)
        return frame

    def _open(self, rung: Rung) -> None:
        self._slot_of[id(rung)] = len(self._slots)
        self._slots.append(_Slot(rung, [self._shared.reads[id(rung)]], []))

    def _judge(self, address: Address, first: _Write, second: _Write) -> None:
        if not self._comes_next(address, first, second):
            return
        if _same(first, second) or first.placed.depends_only_on(STARTING):
            return
        condition = self._seen_through(second.placed.condition, first, second)
        if _looks(condition, address) and self._follows(address, first, second, condition):
            self._report(address, first, second)

    def _comes_next(self, address: Address, first: _Write, second: _Write) -> bool:
        """True for a write in a rung further down that runs in the same scan, as far as loops, returns and ends go."""
        if max(first.frame.barrier, self._base.barrier) > first.at:
            return False
        if first.frame is second.frame:
            return 1 <= second.number - first.number <= _RUNGS_MAX
        if second.frame.barrier > second.frame.start or second.slot - first.slot > _RUNGS_MAX:
            return False
        # CLICK looks at all conditions of a rung, those of its calls too, before the first action runs.
        call = second.step.call
        return first.step.rung is not second.step.rung or (call is not None and not _looks(call.condition, address))

    def _seen_through(self, condition: Condition, first: _Write, second: _Write) -> Condition:
        """A condition with each coil whose rung is between the two writes replaced by what drives it."""
        if isinstance(condition, All):
            return All(tuple(self._seen_through(term, first, second) for term in condition.terms), condition.span)
        driven = self._facts.seen_through(condition)
        if driven is condition or not isinstance(condition, Contact) or not isinstance(condition.operand, Cell):
            return condition
        (writer,) = self._facts.writers(condition.operand.address)
        return driven if first.slot < self._slot_of.get(id(writer.rung), -1) < second.slot else condition

    def _follows(self, address: Address, first: _Write, second: _Write, condition: Condition) -> bool:
        """True if the second action, under this condition, always runs in a scan in which the first one has run."""
        own, span = id(first.placed.action), second.placed.action.span
        after = _holds(address, first, span)
        between = self._slots[first.slot : second.slot]
        changed = [extent for slot in between for one, extents in slot.changed if one != own for extent in extents]
        if self._may_differ(Cell(address, span), changed):
            return False
        kept = [
            term
            for term in terms_of(first.placed.condition)
            if not any(
                address in addresses_of(operand) or self._may_differ(operand, changed)
                for operand in condition_operands(term)
            )
        ]
        known = All((*kept, after), span)
        if not implies(known, condition) or are_exclusive(known) or implies(after, condition):
            return False
        if self._has_pulse(first.step) and self._has_pulse(second.step):
            return True
        # On a level, the second rung may undo what the first did for the rungs between.
        is_put_back = implies(first.placed.condition, _holds(address, second, span))
        return is_put_back and not self._is_read_between(address, first, second)

    def _has_pulse(self, step: Step) -> bool:
        pulses = self._shared.pulses
        ways = (step.own, step.call) if step.call else (step.own,)
        return any(pulses.has(way.condition, way.routine) for way in ways)

    def _may_differ(self, operand: Operand, changed: list[Extent]) -> bool:
        if isinstance(operand, Immediate) or not self._changes.arriving.isdisjoint(addresses_of(operand)):
            return True
        return meets(changed, operand)

    def _is_read_between(self, address: Address, first: _Write, second: _Write) -> bool:
        """True if a rung between the two looks at the address, or a subroutine may."""
        cell = Cell(address, second.placed.action.span)
        own = {id(rung) for write in (first, second) for rung in (write.step.rung, write.placed.rung)}
        between = (slot for slot in self._slots[first.slot + 1 : second.slot] if id(slot.rung) not in own)
        return any(meets(extents, cell) for slot in between for extents in slot.looked_at)

    def _report(self, address: Address, first: _Write, second: _Write) -> None:
        call, there = second.step.call, first.placed.action.span
        # If the call has the condition, its rung is the one to change.
        rung = call.rung if call and not _looks(second.step.own.condition, address) else second.placed.rung
        if id(rung) in self._shared.said:
            return
        self._shared.said.add(id(rung))
        here, name = rung.head, self._facts.shown(address)
        is_back = implies(first.placed.condition, _holds(address, second, here))
        what = "goes back at once" if is_back else "goes through both"
        fault = (
            f"this rung acts in the same scan as {there.seen_from(here)}: that has just {_done(first, name)}, and this "
            f"one {_does(second)}, so {name} {what}"
        )
        help = (
            "make them two branches of one rung, below the condition that they share: CLICK looks at both before "
            "either acts"
        )
        self._shared.found.append(finding(CODE, here, fault, help, (Label(there, "changed here first"),)))


def _is_barrier(effects: Effects) -> bool:
    """True where nobody knows whether the next rung runs in the same scan, or what it finds."""
    return effects.is_unknown or (effects.diverts and effects.flow is not Flow.CALL)


def _looks(condition: Condition, address: Address) -> bool:
    return any(address in addresses_of(operand) for operand in condition_operands(condition))


def _constants(placed: Placed) -> Iterator[tuple[Address, Single | None, bool]]:
    """The addresses into which an action puts a constant, or which it turns on or off."""
    turns = placed.action.turns
    if turns is not None:
        bits = addresses_of(placed.action.driven)
        yield from ((bit, None, turns) for bit in bits[:_BITS_MAX] if len(bits) <= _BITS_MAX)
    elif placed.effects.shape in (Shape.VALUE, Shape.FILL) and "options" not in placed.action.args:
        targets = addresses_of(placed.action.moved_to)
        for address in targets[:_BITS_MAX] if len(targets) <= _BITS_MAX else ():
            value = put_in(placed, address)
            if isinstance(value, Integer | Hex | Real):
                yield address, value, False
    elif placed.effects.shape is Shape.FORMULA:
        yield from _calculated(placed)


def _calculated(placed: Placed) -> Iterator[tuple[Address, Single | None, bool]]:
    """A register that gets a constant, or is calculated from its own number if the condition fixes that: a step."""
    target = placed.action.moved_to
    if not isinstance(target, Cell):
        return
    address = target.address
    held: list[int] = [] if is_relative(placed, address) else [0]
    for term in terms_of(placed.condition) if not held else ():
        if isinstance(term, Compare) and term.op == "==":
            for cell, number in ((term.left, term.right), (term.right, term.left)):
                if isinstance(cell, Cell) and cell.address == address and isinstance(number, Integer | Hex):
                    held.append(number.value)
    for before in held:
        left = left_in(placed, address, before)
        if left is not None:
            yield address, Hex(left, target.span) if address.bank == "DH" else Integer(left, target.span), False


def _same(one: _Write, other: _Write) -> bool:
    if one.value is None or other.value is None:
        return one.is_on is other.is_on
    return getattr(one.value, "value", None) == getattr(other.value, "value", None)


def _holds(address: Address, write: _Write, span: Span) -> Condition:
    """The result of a write, as a condition."""
    cell = Cell(address, span)
    if write.value is None:
        return Contact(cell, span, negated=not write.is_on)
    return Compare("==", cell, write.value, span)


def _done(write: _Write, name: str) -> str:
    if write.value is None:
        return f"turned {name} {'on' if write.is_on else 'off'}"
    return f"put {getattr(write.value, 'value', '')} into {name}"


def _does(write: _Write) -> str:
    if write.value is None:
        return f"turns it {'on' if write.is_on else 'off'}"
    return f"puts {getattr(write.value, 'value', '')} there"


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a rung undoes in the same scan what a rung before it did",
    """
A rung sees what the rungs above it have written in the same scan, and an edge is there for all of them. Two rungs that
should take turns, one that turns a bit on when it is off and one that turns it off when it is on, both run in one scan:
the first turns the bit on, the second finds it on and turns it off again. The lamp never comes on, whatever is pressed.
In the same way one press walks through all steps of a sequence whose rungs are in the order of the steps.

Make branches of one rung of them, below the condition that they share. CLICK looks at all conditions of a rung before
the first action of the rung runs, so only one branch acts. For steps it is enough to put the last step first.

The rule follows the calls of main into their subroutines. It speaks where it is sure that the second rung follows:
not across a loop, an `end()` or a `return`, and not where something in between may have changed what it looks at.
Without an edge it speaks only where the second rung puts back what was there before, and nothing in between has
looked at it.
""",
    wrong=(
        Wrong(
            """
if all(re(x.Button), nc(c.Lamp)):
    set(c.Lamp)

if all(re(x.Button), c.Lamp):  # <-
    reset(c.Lamp)
"""
        ),
        Wrong(
            """
if all(re(x.Button), c.Lamp):
    reset(c.Lamp)

if all(re(x.Button), nc(c.Lamp)):  # <-
    set(c.Lamp)
"""
        ),
        Wrong(
            """
if re(x.Button):
    out(c.Pressed)

if all(c.Pressed, ds.State == 0):
    copy(1, ds.State)

if all(c.Pressed, ds.State == 1):  # <-
    copy(0, ds.State)
"""
        ),
        Wrong(
            """
if all(re(x.Next), ds.Step == 1):
    copy(2, ds.Step)

if all(re(x.Next), ds.Step == 2):  # <-
    copy(3, ds.Step)
"""
        ),
        Wrong(
            """
if all(re(x.Button), nc(y.Lamp)):
    set(c.Lit)

if c.Lit:
    out(y.Lamp)

if all(re(x.Button), y.Lamp):  # <-
    reset(c.Lit)
"""
        ),
        Wrong(
            """
if all(re(x.Button), ds.State == 0):
    calc("1", ds.State)

if all(re(x.Button), ds.State == 1):  # <-
    calc("0", ds.State)
"""
        ),
        Wrong(
            """
def main():
    if all(re(x.Button), nc(c.Lamp)):
        call(light)
    if all(re(x.Button), c.Lamp):  # <-
        call(darken)
    if True:
        end()


@sub
def light():
    if True:
        set(c.Lamp)
    if True:
        return


@sub
def darken():
    if True:
        reset(c.Lamp)
    if True:
        return
"""
        ),
    ),
    right=(
        """
if re(x.Button):
    if nc(c.Lamp):
        set(c.Lamp)
    if c.Lamp:
        reset(c.Lamp)
""",
        """
def main():
    if re(x.Button):
        if nc(c.Lamp):
            call(light)
        if c.Lamp:
            call(darken)
    if True:
        end()


@sub
def light():
    if True:
        set(c.Lamp)
    if True:
        return


@sub
def darken():
    if True:
        reset(c.Lamp)
    if True:
        return
""",
        """
if all(re(x.Next), ds.Step == 2):
    copy(3, ds.Step)

if all(re(x.Next), ds.Step == 1):
    copy(2, ds.Step)
""",
        """
if re(x.Part):
    set(c.Waiting)

if c.Waiting:
    calc("ds.Parts + 1", ds.Parts)
    reset(c.Waiting)
""",
        """
if all(ds.Step == 1, x.Closed):
    copy(2, ds.Step)

if all(ds.Step == 2, x.Open):
    copy(3, ds.Step)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
