"""How a program moves a register by itself: the numbers that it gives it, and the steps that count it up."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.written import Asked, is_relative, left_in
from clickgen.ir.conditions import All
from clickgen.ir.operands import Cell, Integer
from clickgen.ir.program import Action
from clickgen.logic.conditions import implies, terms_of


class Step(NamedTuple):
    """An instruction that counts a register up."""

    placed: Placed
    size: int
    times: int | None
    """How often one run of its loop does so; None outside of loops."""
    moves: Placed
    """The action that decides whether it counts: the loop, or the action itself under the conditions of each turn."""

    @property
    def size_at_once(self) -> int:
        """How much it counts before anything that decides it is looked at again."""
        return self.size * (self.times or 1) if self.moves is not self.placed else self.size


class Walk(NamedTuple):
    """How a program moves a register: the numbers that it gives it, and the steps that count it up."""

    numbers: tuple[int, ...]
    steps: tuple[Step, ...]
    size: int
    """The greatest number that it is counted up by at once."""
    wraps: tuple[Placed, ...]
    """The actions that take it back to a number under a condition on the register itself."""
    starts: tuple[tuple[Placed, int], ...]
    """The actions that give it a number whenever it is counted up, with that number."""


def walk_of(facts: Facts, address: Address) -> Walk | None:
    """Return how the program moves a register; None if a panel or a calculation may give it any number."""
    numbers: list[int] = []
    steps: list[Step] = []
    wraps: list[Placed] = []
    givers: list[tuple[Placed, int]] = []
    for writer in facts.writers(address):
        left = left_in(writer, address, 1)
        if left is None:
            return None
        if not is_relative(writer, address):
            numbers.append(left)
            if Asked(facts, writer, address).is_asked:
                wraps.append(writer)
            else:
                givers.append((writer, left))
            continue
        size = left - 1
        if size <= 0 or left_in(writer, address, 100) != 100 + size:
            return None
        step = _step(facts, writer, size, address)
        if step is None:
            return None
        steps.append(step)
    if not numbers and not steps:
        return None
    starts = tuple(
        (giver, number) for giver, number in givers if all(_runs_with(facts, giver, step.moves) for step in steps)
    )
    return Walk(tuple(numbers), tuple(steps), max((step.size_at_once for step in steps), default=0), (*wraps,), starts)


def _step(facts: Facts, writer: Placed, size: int, address: Address) -> Step | None:
    """A step, and how often a loop repeats it; None if that is not known."""
    if writer.loop is None:
        return Step(writer, size, None, writer)
    times = _times(facts, writer.loop)
    if times is None:
        return None
    loop = facts.place_of(writer.loop)
    inside = each_turn(facts, writer)
    return Step(inside, size, times, inside if Asked(facts, inside, address).is_asked else loop)


def each_turn(facts: Facts, placed: Placed) -> Placed:
    """An action of a loop with only the conditions that each turn looks at, not those of the loop itself."""
    if placed.loop is None:
        return placed
    above = {id(term) for term in terms_of(facts.place_of(placed.loop).condition)}
    own = tuple(term for term in terms_of(placed.condition) if id(term) not in above)
    return replace(placed, condition=All(own, placed.action.span))


def _times(facts: Facts, loop: Action) -> int | None:
    """How often a loop runs at most; None if its register may hold any number."""
    count = loop.args["count"]
    if isinstance(count, Integer):
        return count.value
    if not isinstance(count, Cell) or not facts.writers(count.address):
        return None
    given = [left_in(writer, count.address, 0) for writer in facts.writers(count.address)]
    begins = facts.initial(count.address)
    known = [number for number in given if number is not None]
    return max(*known, int(begins or 0)) if len(known) == len(given) and (not begins or begins.isdecimal()) else None


def _runs_with(facts: Facts, giver: Placed, moves: Placed) -> bool:
    """True for an action that gives the register a number in every scan in which it is counted up."""
    if giver.action.flag("oneshot") and not moves.action.flag("oneshot"):
        return False
    if giver.routine is not moves.routine:
        return giver.is_unconditional and facts.sometimes(giver.routine) is None
    return implies(moves.condition, giver.condition)
