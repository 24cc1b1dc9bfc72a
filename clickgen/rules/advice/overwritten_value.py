"""A value that is overwritten before anything can have read it."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

from clickgen.device.banks import Address, parse_address
from clickgen.facts.changes import Changes, Extent, extents_written
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.uses import Use, addresses_of, extents_of
from clickgen.instructions.effects import COPY_FLAGS, MATH_FLAGS, Effects, Shape
from clickgen.instructions.spec import BITS, TEXT
from clickgen.instructions.spec import CODE as CHARACTER
from clickgen.ir.conditions import Condition, Contact
from clickgen.ir.formula_nodes import Binary, Call, walk
from clickgen.ir.operands import Cell, Constant, Operand, Pointer, Range, form_of
from clickgen.ir.program import Action, FormulaText
from clickgen.ir.walk import condition_operands, leaves
from clickgen.logic.conditions import can_hold, implies, terms_of
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG510"

_BANKS = ("C", "DS", "DD", "DH", "DF", "TXT")
_CERTAIN = ("+", "-", "*", "/", "AND", "OR", "XOR", "LSH", "RSH", "LRO", "RRO")
"""The operators that give a result whatever their operands are (click-facts [math.division, math.overflow])."""
_COPY_FLAGS = frozenset(filter(None, map(parse_address, COPY_FLAGS)))
_FLAGS = _COPY_FLAGS | frozenset(filter(None, map(parse_address, (*MATH_FLAGS, "SC46"))))
"""The system bits that may be the purpose of a write, apart from its value; SC46 is CLICK's _Math_Operation_Error
(click-facts [scan.flags])."""
_RUNGS_MAX = 20
_RANGES_MAX = 8
"""An earlier write is not considered."""


def find(facts: Facts) -> Findings:
    looked_at: dict[int, list[Operand]] = defaultdict(list)
    touched: dict[int, list[Use]] = defaultdict(list)
    changes = Changes(facts)
    for use in facts.uses.every:
        if use.action is None or use.leaf:
            looked_at[id(use.rung)].append(use.operand)
        else:
            touched[id(use.action)].append(use)
    walk = _Walk(facts, changes)
    routine, rung = None, None
    for placed in facts.actions:
        if placed.routine is not routine:
            walk, routine = _Walk(facts, changes), placed.routine
        if placed.rung is not rung:
            rung = placed.rung
            walk.enter(looked_at[id(rung)])
        yield from walk.run(placed, touched[id(placed.action)])


class _Write(NamedTuple):
    """A value that nothing has read yet. ``rung`` counts from the routine's first."""

    placed: Placed
    first: int
    last: int
    rung: int


class _Walk:
    """One routine from its first rung to its last, with the values that nothing has read so far."""

    def __init__(self, facts: Facts, changes: Changes) -> None:
        self._facts = facts
        self._changes = changes
        self._flags = frozenset(flag for flag in _FLAGS if facts.uses.reads(flag))
        """The flags that the program looks at anywhere."""
        self._cells: dict[str, dict[int, _Write]] = defaultdict(dict)
        self._ranges: dict[str, list[_Write]] = defaultdict(list)
        self._changed: list[list[Extent]] = []
        """The stretches that each rung has written: bank, first and last number."""
        self._left: set[int] = set()
        """The rungs with a call or a loop: after it their conditions may not hold any more."""

    def enter(self, looked_at: list[Operand]) -> None:
        """Enter a rung: all its conditions are looked at before its first action, those of pins too."""
        self._changed.append([])
        for operand in looked_at:
            self._read(operand)

    def run(self, placed: Placed, touched: list[Use]) -> Findings:
        # What runs after these is not what is written after them, or nobody knows what they read.
        if placed.effects.diverts or placed.effects.is_unknown or placed.loop:
            self._forget()
            self._left.add(id(placed.rung))
            return
        for use in touched:
            if not use.is_written:
                self._read(use.operand)
        for use in touched:
            if use.is_written:
                yield from self._write(placed, use.operand)

    # -- reading ------------------------------------------------------------------------------------------------------

    def _read(self, operand: Operand) -> None:
        if isinstance(operand, Pointer):
            self._cells.pop(operand.bank, None)
            self._ranges.pop(operand.bank, None)
        elif form_of(operand) == "SC" and not _FLAGS.isdisjoint(addresses_of(operand)):
            self._forget()
        for bank, first, last in extents_of(operand):
            self._drop(bank, first, last)

    def _forget(self) -> None:
        self._cells.clear()
        self._ranges.clear()

    def _drop(self, bank: str, first: int, last: int) -> None:
        for write in self._cells_in(bank, first, last):
            del self._cells[bank][write.first]
        ranges = self._ranges.get(bank)
        if ranges:
            self._ranges[bank] = [write for write in ranges if write.last < first or last < write.first]

    def _cells_in(self, bank: str, first: int, last: int) -> list[_Write]:
        cells = self._cells.get(bank, {})
        if first == last:
            return [cells[first]] if first in cells else []
        return [write for number, write in cells.items() if first <= number <= last]

    # -- writing ------------------------------------------------------------------------------------------------------

    def _write(self, placed: Placed, operand: Operand) -> Findings:
        self._changed[-1] += extents_written(operand)
        if isinstance(operand, Pointer):
            return
        is_copied = _puts_value(placed.effects)
        for bank, first, last in extents_of(operand):
            if bank not in _BANKS:
                continue
            if is_copied and _replaces(placed.action):
                yield from self._judge(placed, bank, first, last)
            self._drop(bank, first, last)
            if not is_copied or _becomes_text(placed.action):
                continue
            write = _Write(placed, first, last, len(self._changed))
            if first == last:
                self._cells[bank][first] = write
            else:
                self._ranges[bank] = [*self._ranges[bank][1 - _RANGES_MAX :], write]

    def _judge(self, placed: Placed, bank: str, first: int, last: int) -> Findings:
        lost = self._cells_in(bank, first, last)
        lost += [write for write in self._ranges.get(bank, ()) if first <= write.first and write.last <= last]
        for write in lost:
            if self._is_for_flags(write.placed.action, placed.action) or not self._always_follows(write, placed):
                continue
            here, there = write.placed.action.span, placed.action.span
            ends = [Address(bank, number) for number in sorted({write.first, write.last})]
            shown = " to ".join(map(self._facts.shown, ends))
            yield finding(
                CODE,
                here,
                f"the value for {shown} is overwritten in {there.seen_from(here)} before anything reads it: "
                "this instruction does nothing",
                "remove one of the two, correct the address, or let their conditions exclude each other",
                (Label(there, "overwritten here"),),
            )

    def _is_for_flags(self, lost: Action, action: Action) -> bool:
        """True if the program looks at a flag that the lost action may raise, or that the other one leaves alone."""
        looked_at = _flags_of(lost) & self._flags
        return bool(looked_at) and (_may_raise_flags(lost) or not looked_at <= _flags_of(action))

    def _always_follows(self, write: _Write, placed: Placed) -> bool:
        """True if the second write runs in every scan in which the first one does."""
        one, other = write.placed.condition, placed.condition
        if len(self._changed) - write.rung > _RUNGS_MAX:
            return False
        if placed.is_unconditional or (write.placed.rung is placed.rung and _begins_with(one, other)):
            return True
        if any(isinstance(leaf, Contact) and leaf.edge for leaf in leaves(other)):
            return False
        if write.placed.rung is not placed.rung:
            if id(write.placed.rung) in self._left:
                return False
            changed = [extent for rung in self._changed[write.rung - 1 :] for extent in rung]
            if any(self._changes.may_change(operand, changed) for operand in condition_operands(other)):
                return False
        # CG507 reports a write that never runs at all.
        return implies(one, other) and can_hold(one)


def _begins_with(path: Condition, other: Condition) -> bool:
    """True if ``path`` is ``other``, or a branch below it: one power flow decides both."""
    terms = {id(term) for term in terms_of(path)}
    return all(id(term) in terms for term in terms_of(other))


def _puts_value(effects: Effects) -> bool:
    """True for what puts a value into its target whenever it runs, and does nothing else."""
    return effects.shape is not None and effects.needs_power


def _replaces(action: Action) -> bool:
    """True if the instruction, once it runs, certainly writes its whole target."""
    if action.flag("oneshot") or "options" in action.args or isinstance(action.moved, Pointer):
        return False
    source, target = action.moved, form_of(action.moved_to)
    if isinstance(source, FormulaText):
        nodes = list(walk(source.formula))
        return not any(
            isinstance(node, Call) or (isinstance(node, Binary) and node.op not in _CERTAIN) for node in nodes
        )
    if action.effects.shape is Shape.PACK and isinstance(source, Range) and form_of(source) in BITS:
        # It is not certain what happens to the bits above the packed ones (click-facts [copy.pack-high-bits]).
        return len(source) == (32 if target in ("DD", "DF") else 16)
    # A text that is not a number leaves the target unchanged (click-facts [copy.no-number]).
    return not _becomes_text(action) and (form_of(source) != "TXT" or target == "TXT")


def _becomes_text(action: Action) -> bool:
    """True for a number that is copied to a text without an option: no source says how much that fills
    (click-facts [value.number-text-length])."""
    is_copy = action.effects.shape is Shape.VALUE and "options" not in action.args
    return is_copy and form_of(action.moved_to) == "TXT" and form_of(action.moved) not in ("TXT", TEXT, CHARACTER)


def _flags_of(action: Action) -> frozenset[Address]:
    """The flags that an instruction may change; a formula also changes those of copies if it reads pointers."""
    if action.effects.shape is Shape.FORMULA:
        return _FLAGS
    return frozenset(filter(None, map(parse_address, action.effects.flags)))


def _may_raise_flags(action: Action) -> bool:
    """False for a copy that cannot fail: a constant, or a value of the target's own bank, is copied unchanged."""
    moved = action.moved
    if isinstance(moved, Cell | Range) and moved.bank == form_of(action.moved_to):
        return False
    return not isinstance(moved, Constant)


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a value is overwritten before anything reads it",
    """
Two instructions write the same address, and whenever the first one runs, the second one runs after it, in the same
rung or a few rungs further down, before anything has looked at the value. The first one does nothing. Mostly a line
was copied and its address not changed, so another address misses its value.

The rule speaks only where it is sure: not across a call, an `end()`, a `return` or a loop, not where one of these may
have changed what the conditions look at, not where a pointer may read the value, and not where the second instruction
is a one-shot, hangs on an edge, or may leave its target as it is. It is silent too where the program looks at a flag
that the first one may raise, such as SC40 (_Division_Error): the instruction may be there for that.
""",
    wrong=(
        Wrong(
            """
if c.LoadRecipe:
    copy(ds[101], ds.FillTime)
    copy(ds[102], ds.CapTime)  # <-
    copy(ds[103], ds.CapTime)
"""
        ),
        Wrong(
            """
if all(c.Auto, c.Fast):
    copy(80, ds.Speed)  # <-

if c.Auto:
    copy(50, ds.Speed)
"""
        ),
        Wrong(
            """
if re(x.Start):
    calc("ds.Base + 1", ds[5])  # <-

if True:
    copy_fill(0, ds[1:11])
"""
        ),
    ),
    right=(
        """
if True:
    copy(50, ds.Speed)

if c.Fast:
    copy(80, ds.Speed)
""",
        """
if c.Load:
    copy(101, ds.Row)
    copy(ds[ds.Row], ds.FillTime)
    copy(102, ds.Row)
    copy(ds[ds.Row], ds.CapTime)
""",
        """
if ds.Step == 1:
    copy(2, ds.Next)
    reset(c.Ready)

if all(ds.Step == 1, c.Ready):
    copy(5, ds.Next)
""",
        """
if c.Start:
    copy(0, ds.Total)

if c.Start:
    copy(ds.Offset, ds.Total, oneshot=True)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
