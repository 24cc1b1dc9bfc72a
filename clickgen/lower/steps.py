"""The steps of a source rung that is split: actions with the conditions above them, and what ran before."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import Condition
from clickgen.ir.program import Action, Rung, actions_in, rungs_in
from clickgen.lower.effects import Cells, Effects, has_edge, reads


@dataclass(eq=False)
class Node:
    """A rung's or a branch's condition, by identity."""

    condition: Condition
    parent: Node | None = None
    is_own: bool = False

    @property
    def path(self) -> tuple[Node, ...]:
        return (*(self.parent.path if self.parent else ()), self)


@dataclass
class Step:
    """One action with its conditions; a loop's ``for`` brings the rungs of its body."""

    node: Node
    action: Action
    body: tuple[Rung, ...] | None = None

    def take_pins(self, pins: Mapping[str, Condition]) -> None:
        """Replace the conditions on these inputs of the action."""
        if pins:
            self.action = Action(self.action.spec, {**self.action.args, **pins}, self.action.span)


@dataclass
class Past:
    """The actions that ran in a rung before one of its parts."""

    effects: Effects
    has_run: bool = False
    """False as long as only clickgen's own actions have run."""
    written: Cells = field(default_factory=Cells)
    may_have_left: bool = False

    def spoils(self, condition: Condition) -> bool:
        """True if a condition may look different now than it did before the first part.

        Something it reads was written; or it holds an edge, which a scan that left early has not seen; or it reads
        something that changes by itself, and actions of the rung have run.
        """
        left = self.may_have_left and has_edge(condition)
        is_late = self.has_run and self.effects.is_volatile(condition)
        return left or is_late or reads(condition).meets(self.written)


Part = list[Step]
"""Steps that share one CLICK rung."""


def is_of_program(part: Part) -> bool:
    """False for a part that clickgen alone needs, without a condition of the program in it."""
    return any(step.action.spec.pins or not step.node.is_own for step in part)


def pins_of(step: Step) -> dict[str, Condition]:
    """The conditions of a step's inputs, by their names."""
    pins = ((param.name, step.action.pin(param.name)) for param in step.action.spec.pins)
    return {name: condition for name, condition in pins if condition is not None}


def run_by(part: Part) -> Iterator[Action]:
    """Yield every action that runs in a part, including those in the body of a loop."""
    for step in part:
        yield step.action
        for rung in rungs_in(step.body or ()):
            yield from actions_in(rung.items)


def apart(steps: list[Step]) -> list[Part]:
    """Split off instructions with pins, and those that must be alone, as parts of their own (click-facts
    [grid.one-branch]).

    The same goes for a return with outputs below it: no source says whether CLICK still runs these in one rung
    (click-facts [control.return-below]).
    """
    parts: list[Part] = []
    joins = False
    for step in steps:
        spec = step.action.spec
        leaves_some = spec.effects.flow is Flow.RETURN and step is not steps[-1]
        single = bool(spec.pins) or spec.alone or step.node.is_own or leaves_some
        if joins and not single:
            parts[-1].append(step)
        else:
            parts.append([step])
        joins = not single
    return parts


def nodes_of(parts: Sequence[Part]) -> list[Node]:
    """Every condition of these parts once, in source order."""
    return list(dict.fromkeys(node for part in parts for step in part for node in step.node.path))
