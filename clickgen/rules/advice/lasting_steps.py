"""A step that nothing leaves: its number is written, and no rung that moves on runs while it is there."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.uses import addresses_of
from clickgen.facts.written import Asked, is_relative, left_in, runs_at_start_only, span_of, whole_condition
from clickgen.ir.conditions import Contact
from clickgen.ir.operands import Cell, Hex, Integer
from clickgen.ir.walk import leaves
from clickgen.logic.conditions import terms_of
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

CODE = "CG556"

_BANKS = ("DS", "DD", "DH")
_STEPS_MAX = 128
"""A register with more numbers, or more instructions that write it, is not a step register that a person wrote."""
_GUARDED_MIN = 2
"""At least this many transitions test the step that they leave: else the register is a mode or a setpoint."""


class _Writer(NamedTuple):
    placed: Placed
    asked: Asked
    is_start: bool

    def leads_out(self, address: Address, step: int) -> bool:
        """True if it may run in a step and leave another number."""
        return not self.is_start and self.asked.may_be(step) and left_in(self.placed, address, step) != step


def find(facts: Facts) -> Findings:
    compared = {
        side.address: None
        for compare in facts.comparisons
        if compare.op == "=="
        for side, other in ((compare.left, compare.right), (compare.right, compare.left))
        if isinstance(side, Cell) and isinstance(other, Integer | Hex) and side.bank in _BANKS
    }
    for address in compared:
        placed = facts.writers(address)
        if len(placed) <= _STEPS_MAX and not facts.uses.is_pointed(address.bank, is_written=True):
            yield from _check(facts, address, placed)


def _check(facts: Facts, address: Address, placed: Sequence[Placed]) -> Findings:
    writers = [_Writer(one, Asked(facts, one, address), runs_at_start_only(facts, one)) for one in placed]
    steps, known = _steps(facts, address, writers)
    if len(known) > _STEPS_MAX or not _is_sequence(address, writers, known):
        return
    home = _begins(facts, address)
    aborts = {id(writer) for writer in writers if _is_abort(facts, writer, address, home)}
    for step, span in steps.items():
        ways = [writer for writer in writers if writer.leads_out(address, step)]
        if any(id(writer) not in aborts for writer in ways):
            continue
        shown = facts.shown(address)
        cell = _cell(facts, address)
        name = facts.text(cell) if cell else str(address)
        goes_on = facts.spell.every(facts.spell.compared(name, "==", str(step)), "...")
        labels = tuple(Label(writer.placed.action.span, "this ends any step") for writer in ways)
        but = f", but for line {ways[0].placed.action.span.line}, which ends any step" if ways else ""
        yield finding(
            CODE,
            span,
            f"step {step} of {shown} is never left: no rung that asks for it writes another number{but}",
            f"add the rung that goes on, {facts.spell.rung(goes_on)}, or write {facts.spell.ignore(CODE)} where the "
            "sequence ends here or a panel goes on",
            labels,
        )


def _steps(facts: Facts, address: Address, writers: Sequence[_Writer]) -> tuple[dict[int, Span], set[int]]:
    """The numbers that the program puts into the register, each with its first place, and those of its start too."""
    steps: dict[int, Span] = {}
    home = _begins(facts, address)
    waiting = [home]
    counting = [writer for writer in writers if is_relative(writer.placed, address)]
    for writer in writers:
        number = None if writer in counting else left_in(writer.placed, address, home)
        if number is not None:
            waiting.append(number)
            if not writer.is_start:
                steps.setdefault(number, span_of(writer.placed))
    seen = set(waiting)
    while waiting and len(seen) <= _STEPS_MAX:
        number = waiting.pop()
        for writer in counting:
            after = left_in(writer.placed, address, number) if writer.asked.may_be(number) else None
            if after is not None and after not in seen:
                seen.add(after)
                waiting.append(after)
                steps.setdefault(after, span_of(writer.placed))
    return steps, seen


def _is_sequence(address: Address, writers: Sequence[_Writer], steps: Iterable[int]) -> bool:
    """True if several transitions go from one step to another."""
    left: set[frozenset[int]] = set()
    for writer in writers:
        at = frozenset(step for step in {0, *steps} if writer.asked.may_be(step))
        if writer.asked.is_asked and at and any(left_in(writer.placed, address, step) != step for step in at):
            left.add(at)
    return len(left) >= _GUARDED_MIN


def _begins(facts: Facts, address: Address) -> int:
    """The number that the register begins with."""
    return int(facts.initial(address) or "0", 16 if address.bank == "DH" else 10)


def _is_abort(facts: Facts, writer: _Writer, address: Address, home: int) -> bool:
    """True for an action that holds the register at a number whatever the step is, which is no way on.

    It tests no step and no edge, and leads elsewhere than home, such as to a step for faults; or it runs while
    something is missing, such as a guard or automatic mode. A level that leads home may be a reset button.
    """
    if writer.asked.is_asked:
        return False
    looked = [leaf for term in terms_of(whole_condition(facts, writer.placed)) for leaf in leaves(term)]
    contacts = [leaf for leaf in looked if isinstance(leaf, Contact)]
    if not looked or any(contact.edge for contact in contacts):
        return False
    to = left_in(writer.placed, address, home)
    return (to is not None and to not in (0, home)) or all(
        isinstance(leaf, Contact) and leaf.negated for leaf in looked
    )


def _cell(facts: Facts, address: Address) -> Span | None:
    """A place where the register is written as the person names it."""
    for use in facts.uses.at(address):
        if isinstance(use.operand, Cell) and addresses_of(use.operand) == [address]:
            return use.operand.span
    return None


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a step is never left",
    """
A sequence stops, and the machine with it, when its step register gets a number that no transition asks for, until
somebody presses stop. It is mostly a transition that was never written, or one that compares with a wrong number.

A register counts as one of steps when at least two rungs ask for a step with `==` and write another. A way out is
every write that may run in the step: one that asks for it or for a range of steps, a calculated step, or one that does
not ask at all, such as the edge of a start or reset button. A write in the first scan does not count, nor does one that
holds the register at one number whatever the step is: at that of a fault, or at 0 while a guard or automatic mode is
missing (`nc(...)`).
""",
    wrong=(
        Wrong(
            """
if all(ds.Step == 0, x.Start):
    copy(10, ds.Step)
if all(ds.Step == 10, x.Full):
    copy(20, ds.Step)
if all(ds.Step == 20, t.Mixed):
    copy(30, ds.Step)  # <-
if ds.Step == 20:
    ton(t.Mixed, 60, unit=Ts)
if ds.Step == 30:
    out(y.Drain)
if c.Fault:
    copy(99, ds.Step)
if all(ds.Step == 99, x.Reset):
    copy(0, ds.Step)
if nc(x.EStop):
    copy(0, ds.Step)
if sc._1st_SCAN:
    copy(0, ds.Step)
"""
        ),
        Wrong(
            """
if ds.Step == 1:
    out(c.Filling)
if ds.Step == 2:
    out(c.Draining)
if all(ds.Step == 0, x.Start):
    copy(1, ds.Step)
if all(c.Filling, x.Full):
    copy(3, ds.Step)  # <-
if all(c.Draining, x.Empty):
    copy(0, ds.Step)
"""
        ),
    ),
    right=(
        """
if all(ds.Step == 0, x.Start):
    copy(10, ds.Step)
if all(ds.Step == 10, x.Full):
    copy(20, ds.Step)
if all(ds.Step == 20, x.Empty):
    copy(0, ds.Step)
if nc(x.EStop):
    copy(0, ds.Step)
""",
        """
if all(ds.Step == 0, x.Start):
    copy(1, ds.Step)
if all(ds.Step >= 1, ds.Step < 4, re(x.Next)):
    calc("ds.Step + 1", ds.Step)
if all(ds.Step == 4, t.Done):
    copy(0, ds.Step)
if ds.Step == 4:
    ton(t.Done, 5, unit=Ts)
if c.Fault:
    copy(99, ds.Step)
if re(x.Reset):
    copy(0, ds.Step)
""",
        """
if x.Fast:
    copy(100, ds.Speed)
if nc(x.Fast):
    copy(50, ds.Speed)
if ds.Speed == 100:
    out(y.Lamp)
if ds.Ready == 0:
    copy(1, ds.Ready)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
