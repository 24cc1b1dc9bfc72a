"""A rung that acts in the same scan on what a rung above it has just changed: a toggle goes back at once."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.changes import Changes, Extent, meets
from clickgen.facts.copied import put_in
from clickgen.facts.facts import STARTING, Facts, Placed
from clickgen.facts.pulses import Pulses
from clickgen.facts.uses import addresses_of
from clickgen.formula.nodes import Binary, Number
from clickgen.formula.nodes import Operand as FormulaOperand
from clickgen.instructions import maths
from clickgen.instructions.coils import RESET, SET
from clickgen.instructions.control import END, FOR, NEXT, RETURN
from clickgen.instructions.copies import COPY, COPY_FILL
from clickgen.instructions.raw import NOT_IMPORTED, RAW
from clickgen.ir.conditions import All, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Hex, Immediate, Integer, Operand, Real, Single
from clickgen.ir.program import FormulaText
from clickgen.ir.walk import condition_operands
from clickgen.logic.conditions import are_exclusive, implies, terms_of
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.rules.rule import Rule, Wrong
from clickgen.text.source import Span

# click-facts [scan.conditions]
CODE = "CG544"

_BARRIERS = (END, RETURN, FOR, NEXT, RAW, NOT_IMPORTED)
"""Past these nobody knows whether the next rung runs in the same scan, or what it finds."""
_BITS_MAX = 16
"""A set or reset of more bits than this is no toggle."""
_BEFORE_MAX = 4
"""So many writes of one address before an action are looked at."""
_RUNGS_MAX = 20
"""A rung further up is not looked for."""


class _Write(NamedTuple):
    """A constant that an action puts into an address."""

    placed: Placed
    value: Single | None
    """None for a bit that is turned off or on."""
    is_on: bool
    rung: int


def check(facts: Facts, problems: Diagnostics) -> None:
    changes, pulses = Changes(facts), Pulses(facts)
    walk: _Walk | None = None
    for placed in facts.actions:
        if walk is None or placed.routine is not walk.routine:
            walk = _Walk(facts, problems, changes, pulses, placed)
        walk.run(placed)


class _Walk:
    """One routine from its first rung to its last, with the constants that its rungs have written so far."""

    def __init__(self, facts: Facts, problems: Diagnostics, changes: Changes, pulses: Pulses, first: Placed) -> None:
        self.routine = first.routine
        self._facts, self._problems, self._changes, self._pulses = facts, problems, changes, pulses
        self._rung = first.rung
        self._number = 0
        self._numbers = {id(first.rung): 0}
        """The rungs so far, each with its place in the routine."""
        self._writes: dict[Address, list[_Write]] = defaultdict(list)
        self._changed: list[list[tuple[int, Extent]]] = [[]]
        """What each rung has written, with the id of the action that did."""
        self._said: set[int] = set()

    def run(self, placed: Placed) -> None:
        if placed.rung is not self._rung:
            self._rung = placed.rung
            self._number += 1
            self._numbers[id(placed.rung)] = self._number
            self._changed.append([])
        if placed.spec in _BARRIERS or placed.loop:
            self._writes.clear()
            return
        for address, value, is_on in _constants(placed):
            write = _Write(placed, value, is_on, self._number)
            for earlier in self._writes[address]:
                self._judge(address, earlier, write)
            self._writes[address] = [*self._writes[address][1 - _BEFORE_MAX :], write]
        identity = id(placed.action)
        self._changed[-1] += [(identity, extent) for extent in self._changes.of(placed.action)]

    def _judge(self, address: Address, first: _Write, second: _Write) -> None:
        if second.rung - first.rung not in range(1, _RUNGS_MAX + 1) or id(second.placed.rung) in self._said:
            return
        if _same(first, second) or first.placed.depends_only_on(STARTING):
            return
        condition = self._seen_through(second.placed.condition, first, second)
        looks = any(address in addresses_of(operand) for operand in condition_operands(condition))
        if looks and self._follows(address, first, second, condition):
            self._said.add(id(second.placed.rung))
            self._report(address, first, second)

    def _seen_through(self, condition: Condition, first: _Write, second: _Write) -> Condition:
        """A condition with what drives it in the place of each coil whose rung stands between the two writes."""
        if isinstance(condition, All):
            return All(tuple(self._seen_through(term, first, second) for term in condition.terms), condition.span)
        driven = self._facts.seen_through(condition)
        if driven is condition or not isinstance(condition, Contact) or not isinstance(condition.operand, Cell):
            return condition
        (writer,) = self._facts.writers(condition.operand.address)
        number = self._numbers.get(id(writer.rung), -1)
        return driven if first.rung < number < second.rung else condition

    def _follows(self, address: Address, first: _Write, second: _Write, condition: Condition) -> bool:
        """True when the second action, under this condition, always runs in a scan in which the first one has run."""
        own = id(first.placed.action)
        changed = [extent for rung in self._changed[first.rung : second.rung] for one, extent in rung if one != own]
        span = second.placed.action.span
        after = _holds(address, first, span)
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
        if self._has_pulse(first.placed) and self._has_pulse(second.placed):
            return True
        # On a level the second rung may be one that takes back what the first did for the rungs between.
        is_put_back = implies(first.placed.condition, _holds(address, second, span))
        return is_put_back and not self._is_read_between(address, first, second)

    def _has_pulse(self, placed: Placed) -> bool:
        return self._pulses.has(placed.condition, placed.routine)

    def _may_differ(self, operand: Operand, changed: list[Extent]) -> bool:
        if isinstance(operand, Immediate) or not self._changes.arriving.isdisjoint(addresses_of(operand)):
            return True
        return meets(changed, operand)

    def _is_read_between(self, address: Address, first: _Write, second: _Write) -> bool:
        """True when a rung between the two looks at the address, or a subroutine may."""
        lines = range(first.placed.rung.span.line + 1, second.placed.rung.span.line)
        uses = self._facts.uses.reads(address)
        return any(use.routine is not self.routine or use.rung.span.line in lines for use in uses)

    def _report(self, address: Address, first: _Write, second: _Write) -> None:
        here, there = second.placed.rung.head, first.placed.action.span
        name = self._facts.shown(address)
        is_back = implies(first.placed.condition, _holds(address, second, here))
        what = "goes back at once" if is_back else "goes through both"
        self._problems.add(
            CODE,
            here,
            f"this rung acts in the same scan as line {there.line}: that has just {_done(first, name)}, and this one "
            f"{_does(second)}, so {name} {what}",
            "make them two branches of one rung, below the condition that they share: CLICK looks at both before "
            "either acts",
            (Label(there, "changed here first"),),
        )


def _constants(placed: Placed) -> Iterator[tuple[Address, Single | None, bool]]:
    """The addresses into which an action puts a constant, or turns on or off."""
    if placed.spec in (SET, RESET):
        bits = addresses_of(placed.action.args["address"])
        yield from ((bit, None, placed.spec is SET) for bit in bits[:_BITS_MAX] if len(bits) <= _BITS_MAX)
    elif placed.spec in (COPY, COPY_FILL) and "options" not in placed.action.args:
        targets = addresses_of(placed.action.args["destination"])
        for address in targets[:_BITS_MAX] if len(targets) <= _BITS_MAX else ():
            value = put_in(placed, address)
            if isinstance(value, Integer | Hex | Real):
                yield address, value, False
    elif placed.spec in maths.SPECS:
        yield from _calculated(placed)


def _calculated(placed: Placed) -> Iterator[tuple[Address, Single | None, bool]]:
    """A register that is counted up or down by a constant, where the condition says what it holds: a step."""
    formula, target = placed.action.args["formula"], placed.action.args["destination"]
    if not isinstance(formula, FormulaText) or not isinstance(target, Cell):
        return
    root = formula.formula.root
    if not (isinstance(root, Binary) and isinstance(root.left, FormulaOperand) and isinstance(root.right, Number)):
        return
    register = root.left.ref
    if root.op not in ("+", "-") or not isinstance(register, Cell) or register.address != target.address:
        return
    for term in terms_of(placed.condition):
        if isinstance(term, Compare) and term.op == "==":
            sides = (term.left, term.right), (term.right, term.left)
            for cell, held in sides:
                if isinstance(cell, Cell) and cell.address == target.address and isinstance(held, Integer):
                    value = held.value + (root.right.value if root.op == "+" else -root.right.value)
                    if isinstance(value, int):
                        yield target.address, Integer(value, target.span), False


def _same(one: _Write, other: _Write) -> bool:
    if one.value is None or other.value is None:
        return one.is_on is other.is_on
    return getattr(one.value, "value", None) == getattr(other.value, "value", None)


def _holds(address: Address, write: _Write, span: Span) -> Condition:
    """What a write leaves behind, as a condition."""
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


RULE = Rule(
    CODE,
    check,
    """
A rung sees what the rungs above it have written in the same scan, and an edge is there for all of them. Two rungs that
are to take turns, one that turns a bit on when it is off and one that turns it off when it is on, both run in one scan:
the first turns the bit on, the second finds it on and turns it off again. The lamp never comes on, whatever is pressed.
In the same way one press walks through all steps of a sequence whose rungs stand in the order of the steps.

Make branches of one rung of them, below the condition that they share. CLICK looks at all conditions of a rung before
the first action of the rung runs, so only one branch acts. For steps it is enough to put the last step first.

The rule speaks where it is sure that the second rung follows: not across a loop, an `end()` or a `return`, and not
where something in between may have changed what it looks at. Without an edge it speaks only where the second rung puts
back what was there before, and nothing in between has looked at it.
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
