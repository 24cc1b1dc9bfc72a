"""A pointer whose register gets a number that no address of the bank has."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import FIRST_SCAN, Facts, Placed
from clickgen.facts.uses import addresses_of
from clickgen.instructions.effects import Shape
from clickgen.ir.conditions import All, Any, Compare, Condition, Contact, Edge
from clickgen.ir.operands import Cell, Immediate, Integer, Operand, Pointer, form_of
from clickgen.ir.program import Routine
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands, leaves
from clickgen.logic.conditions import are_exclusive, implies, terms_of
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG518"

_WRITERS_MAX = 8
"""If more instructions write a register, only the nearest are looked at."""


def find(facts: Facts) -> Findings:
    through = {id(use.action) for use in facts.uses.every if isinstance(use.operand, Pointer)}
    # If pointers write DS registers, any of them may write the pointer's own.
    if not through or facts.uses.is_pointed("DS", True):
        return
    registers = _Registers(facts)
    rung, since = None, 0
    for place, placed in enumerate(facts.actions):
        if placed.rung is not rung or placed.effects.diverts:
            rung, since = placed.rung, place
        if id(placed.action) in through and placed.loop is None and not placed.effects.is_unknown:
            pointers = {touch.operand: None for touch in touches(placed.action) if isinstance(touch.operand, Pointer)}
            for pointer in pointers:
                if isinstance(pointer.register, Cell):
                    use = _Use(placed, place, since, pointer, pointer.register)
                    found = _find(facts, use, registers.of(pointer.register.address))
                    if found:
                        yield from _report(facts, use, *found)


class _Use(NamedTuple):
    """A pointer and its place. From ``since`` on, only its own rung's instructions run before it."""

    placed: Placed
    place: int
    since: int
    pointer: Pointer
    register: Cell

    @property
    def condition(self) -> Condition:
        return self.placed.condition

    def leads_nowhere(self, number: int | None) -> bool:
        return number is not None and not BANKS[self.pointer.bank].has(number)

    def finds(self, writer: _Writer) -> Condition:
        """The condition that the use runs and finds the writer's number, by its rung's conditions on the register."""
        assert writer.number is not None
        span = self.register.span
        return All((self.condition, Compare("==", self.register, Integer(writer.number, span), span)), span)


class _Writer(NamedTuple):
    """An action that gives a register a number; ``place`` is its place in the program."""

    placed: Placed
    condition: Condition
    place: int
    number: int | None
    """None if it is not always the same."""

    @property
    def clears_block(self) -> bool:
        """True for an action that clears a block, whoever fills the block."""
        return self.placed.effects.shape is Shape.FILL and self.number == 0

    def surely_runs_with(self, use: _Use) -> bool:
        """True if the writer runs whenever the use does, as far as their conditions are looked at together."""
        if self.placed.action.flag("oneshot"):
            return False
        held = {id(term) for term in terms_of(use.condition)}
        asked = tuple(term for term in terms_of(self.condition) if id(term) not in held)
        return not asked or implies(use.condition, All(asked, asked[0].span))


class _Register(NamedTuple):
    """What the program does with the register of a pointer; ``home`` is None if some number is unknown."""

    writers: tuple[_Writer, ...] = ()
    home: Routine | None = None
    """The routine that has all writers outside of loops, if every scan runs it."""
    end: int = 0
    """The place in it from which an ``end()`` or ``return`` may stop actions from running; no writer comes after it."""
    is_open: bool = False
    """True if nothing that the program writes decides which writers run."""
    asked: frozenset[int] = frozenset()
    """The contacts and comparisons that look at the register."""


def _report(facts: Facts, use: _Use, writer: _Writer, is_sure: bool) -> Findings:
    span, bank, number = use.pointer.span, BANKS[use.pointer.bank], writer.number
    there = writer.placed.action.span.seen_from(span)
    said = f"is {number} after {there}" if is_sure else f"may still be {number} from {there}"
    # What CLICK does then: click-facts [copy.wild-pointer]
    yield finding(
        CODE,
        span,
        f"{facts.shown(use.register.address)} {said}, and there is no {bank.name}{number}: "
        f"CLICK {'' if is_sure else 'then '}skips this and sets SC44 (_Address_Error)",
        f"{bank.name} has {bank.describe_range()}: give the pointer such a number first, or test it in the condition "
        "of this rung",
        (Label(writer.placed.action.span, f"{number} comes from here"),),
    )


class _Registers:
    """Each register of a pointer, looked at once."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        self._known: dict[Address, _Register] = {}
        self._places = facts.places
        self._ends: dict[int, int] = {}
        """The place of each routine's first ``end()`` or ``return``: the actions after it may not run."""
        for place, placed in enumerate(facts.actions):
            if placed.effects.leaves:
                self._ends.setdefault(id(placed.routine), place)

    def of(self, address: Address) -> _Register:
        if address not in self._known:
            self._known[address] = self._look_at(address)
        return self._known[address]

    def _look_at(self, address: Address) -> _Register:
        writers = []
        for placed in self._facts.writers(address):
            moved = placed.action.moved if placed.effects.shape in (Shape.VALUE, Shape.FILL) else None
            number = moved.value if isinstance(moved, Integer) else None
            writers.append(_Writer(placed, placed.condition, self._places[id(placed.action)], number))
        if not writers:
            return _Register()
        writers.sort(key=lambda writer: writer.place)
        end = self._ends.get(id(writers[0].placed.routine), len(self._places))
        if any(writer.number is None for writer in writers):
            return _Register(tuple(writers), end=end)
        home = self._home(writers) if writers[-1].place < end else None
        is_open = len(writers) <= _WRITERS_MAX and all(_is_free(self._facts, each.condition) for each in writers)
        asked = frozenset(id(use.leaf) for use in self._facts.uses.reads(address) if use.leaf is not None)
        return _Register(tuple(writers), home, end, is_open, asked)

    def _home(self, writers: Sequence[_Writer]) -> Routine | None:
        home = writers[0].placed.routine
        if any(writer.placed.routine is not home or writer.placed.loop for writer in writers):
            return None
        calls = self._facts.calls.get(home.name, ())
        return home if home.is_main or (calls and all(call.is_unconditional for call in calls)) else None


# -- the number that arrives ------------------------------------------------------------------------------------------


def _find(facts: Facts, use: _Use, register: _Register) -> tuple[_Writer, bool] | None:
    """The writer of a number that leads nowhere and is there when the use runs, and whether that is always so."""
    index = bisect_left(register.writers, use.place, key=lambda writer: writer.place)
    before = register.writers[max(0, index - _WRITERS_MAX) : index]
    is_home = use.placed.routine is register.home and use.place < register.end
    is_open = is_home and register.is_open and _is_free(facts, use.condition, use.register.address)
    may_stay = is_open and _is_left_alone(use, register)
    later: list[Condition] = []
    for writer in reversed(before):
        is_near = writer.place >= use.since
        if not (is_near or is_open or (is_home and writer.placed.is_unconditional)):
            return None
        if are_exclusive(use.condition, writer.condition):
            continue
        if writer.number is None:
            return None
        is_sure = writer.surely_runs_with(use)
        if use.leads_nowhere(writer.number):
            if not later and (is_near or (is_sure and _is_possible(use.finds(writer)))):
                return writer, is_sure
            if may_stay and _comes_from(writer, use, later):
                return writer, False
        if is_sure:
            return None
        later.append(writer.condition)
    return _left_from_before(use, register.writers, index) if may_stay else None


def _comes_from(writer: _Writer, use: _Use, later: Sequence[Condition]) -> bool:
    """True if the writer may run and the use find its number, while none of the later writers runs."""
    condition = All((use.finds(writer), writer.condition), use.register.span)
    return not writer.clears_block and _is_possible(condition, later)


def _left_from_before(use: _Use, writers: Sequence[_Writer], index: int) -> tuple[_Writer, bool] | None:
    """The writer whose number may be left from an earlier scan: the ``index`` writers before the use do not run."""
    before = [writer.condition for writer in writers[:index]]
    starts = [use.condition] if use.placed.action.flag("oneshot") else []
    for number, writer in enumerate(writers, 1):
        after = [other.condition for other in writers[number:]]
        if (
            use.leads_nowhere(writer.number)
            and not writer.clears_block
            and _is_possible(writer.condition, [*after, *starts])
            and _is_possible(use.finds(writer), before)
        ):
            return writer, False
    return None


def _is_left_alone(use: _Use, register: _Register) -> bool:
    """True if the program gives the register good numbers too, and looks at it only in the use's condition.

    A register that the program only clears is a panel's, and another condition may keep wrong numbers from the use. A
    bit that is looked at both for its edge and its level goes on and off in an order that the conditions alone do not
    show.
    """
    own = {id(leaf) for leaf in leaves(use.condition)}
    has_good = not all(use.leads_nowhere(writer.number) for writer in register.writers)
    conditions = [use.condition, *(writer.condition for writer in register.writers)]
    return has_good and register.asked <= own and _edges_agree(conditions)


def _edges_agree(conditions: Iterable[Condition]) -> bool:
    edges: dict[Address, Edge | None] = {}
    contacts = (leaf for condition in conditions for leaf in leaves(condition) if isinstance(leaf, Contact))
    return all(
        edges.setdefault(address, contact.edge) == contact.edge
        for contact in contacts
        for address in addresses_of(contact.operand)
    )


def _is_free(facts: Facts, condition: Condition, besides: Address | None = None) -> bool:
    """True if a condition looks at nothing that the program or CLICK changes, except one register and the start."""
    return all(
        _stays(facts, operand) or addresses_of(operand) == [besides] for operand in condition_operands(condition)
    )


def _stays(facts: Facts, operand: Operand) -> bool:
    if isinstance(operand, Immediate) or facts.uses.may_be_written(operand):
        return False
    return form_of(operand) not in ("SC", "SD") or addresses_of(operand) == [FIRST_SCAN]


def _is_possible(condition: Condition, others: Sequence[Condition] = ()) -> bool:
    """True if the condition may hold while none of the others does."""
    return not implies(condition, Any(tuple(others), condition.span))


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a pointer may lead to no address",
    """
A pointer whose register holds 0, or a number beyond the bank, leads nowhere: CLICK skips the copy, sets SC44 and goes
on with the old value. Nothing on the panel says why a recipe did not load.

The rule speaks only where the program itself writes such a number: every write of the register is a constant, and none
goes through a pointer. It says that the number is there where the write surely runs before the pointer in the same
scan. It says that the number may still be there where nothing but inputs and what a panel writes decides which of the
writes comes last, and no other condition looks at the register: then nothing in the program keeps the number away. A
register that the program only clears, never writes, or calculates, is left alone: who gives it its numbers is not
known.
""",
    wrong=(
        Wrong(
            """
if c.Reset:
    copy(0, ds.Row)
if c.First:
    copy(101, ds.Row)
if c.Load:
    copy(ds[ds.Row], ds.Value)  # <-
"""
        ),
        Wrong(
            """
if c.Load:
    copy(2001, ds.Index)
    copy(c[ds.Index], c.Copy)  # <-
    copy(ds[ds.Index], ds.Value)
if ds.Row < 500:
    copy(600, ds.Row)
    calc("df[ds.Row] / 2", df.Half)  # <-
"""
        ),
    ),
    right=(
        """
if c.Load:
    copy(ds[ds.FromPanel], ds.Value)
""",
        """
if c.Reset:
    copy(0, ds.Row)
    copy(0, ds.Line)
if c.First:
    copy(101, ds.Row)
    copy(1, ds.Line)
if all(c.Load, ds.Row > 0):
    copy(ds[ds.Row], ds.Value)
if ds.Line == 0:
    copy(1, ds.Line)
if c.Load:
    copy(dd[ds.Line], dd.Total)
""",
        """
if c.Reset:
    copy(0, ds.Row)
if c.Next:
    calc("ds.Row + 1", ds.Row)
    copy(ds[ds.Row], ds.Value)
""",
        """
if c.Load:
    copy(101, ds.Row)
    copy(ds[ds.Row], ds.First)
if c.Clear:
    copy(0, ds.Row)
if sc._1st_SCAN:
    copy_fill(0, ds[1:50])
if c.Show:
    copy(txt[ds[7]], txt[1])
""",
    ),
)

RULE = Rule(find, (ABOUT,))
