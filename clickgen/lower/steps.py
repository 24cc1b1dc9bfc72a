"""The steps of a source rung that is taken apart: actions with the conditions above them, and what ran before."""

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
    """One action with the conditions it stands on; a loop's ``for`` brings the rungs of its body."""

    node: Node
    action: Action
    body: tuple[Rung, ...] | None = None

    def take_pins(self, pins: Mapping[str, Condition]) -> None:
        """The same action with other conditions on these inputs."""
        if pins:
            self.action = Action(self.action.spec, {**self.action.args, **pins}, self.action.span)


@dataclass
class Past:
    """What ran in a rung before one of its parts."""

    effects: Effects
    has_run: bool = False
    """False as long as only what clickgen itself needs has run."""
    written: Cells = field(default_factory=Cells)
    may_have_left: bool = False

    def spoils(self, condition: Condition) -> bool:
        """True when a condition may look otherwise now than it did before the first part.

        Something it reads was written; or it holds an edge, which a scan that left early has not seen; or it reads
        something that changes by itself, and actions of the rung have run.
        """
        left = self.may_have_left and has_edge(condition)
        is_late = self.has_run and self.effects.is_volatile(condition)
        return left or is_late or reads(condition).meets(self.written)


Part = list[Step]
"""Steps that share one CLICK rung."""


def is_of_program(part: Part) -> bool:
    """False for what clickgen needs alone, without a condition of the program in it."""
    return any(step.action.spec.pins or not step.node.is_own for step in part)


def pins_of(step: Step) -> dict[str, Condition]:
    """The conditions of a step's inputs, by their names."""
    pins = ((param.name, step.action.pin(param.name)) for param in step.action.spec.pins)
    return {name: condition for name, condition in pins if condition is not None}


def run_by(part: Part) -> Iterator[Action]:
    """Every action that runs in a part, those in the body of a loop included."""
    for step in part:
        yield step.action
        for rung in rungs_in(step.body or ()):
            yield from actions_in(rung.items)


def apart(steps: list[Step]) -> list[Part]:
    """Instructions with pins, and those that stand alone, get a part of their own (click-facts [grid.one-branch]).

    So does a return with outputs below it: whether CLICK still runs these within one rung, no source says (click-facts
    [control.return-below]).
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
