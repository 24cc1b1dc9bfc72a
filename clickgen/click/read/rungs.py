"""Turns drawn rungs into rungs of a program: outputs with their conditions, branches, the inputs of boxes, loops."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from keyword import iskeyword

from clickgen.click.read.grid import DrawnBox, DrawnRung
from clickgen.click.read.kept import fault_of, raw_of
from clickgen.click.read.network import RAIL, Arc, Network, Place, network_of
from clickgen.click.read.operands import missing_address
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.reduce import TooEntangled, series, tree_of
from clickgen.click.read.tokens import action_of, specs_of
from clickgen.device.system import ALWAYS_ON
from clickgen.dialects.registry import default
from clickgen.instructions.effects import Flow
from clickgen.instructions.raw import WORD
from clickgen.ir.conditions import Always, Condition, Contact
from clickgen.ir.made import NOP_TOKEN, nothing
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action, Branch, Item, Loop, Routine, Rung, actions_in
from clickgen.problems.silence import DIRECTIVE
from clickgen.text.source import Span

ENTANGLED = "the contacts are wired in too many ways to be written as a condition"


@dataclass(frozen=True)
class ImportedRung:
    """A rung of the program, and notes on it for a person."""

    rung: Rung
    notes: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    """The parts left out because they do nothing."""


@dataclass(frozen=True)
class _Output:
    """An action and the conditions on the way to it."""

    path: tuple[Arc, ...]
    action: Action


def import_rung(drawn: DrawnRung) -> ImportedRung:
    """Return a drawn rung as a program has it. Raises LadderProblem if it cannot be kept."""
    if drawn.problems:
        raise drawn.problems[0]
    network = network_of(drawn)
    span = drawn.span
    notes = list(network.notes)
    remarks = _comment_remarks(drawn)
    boxes = list(drawn.boxes)
    if len(boxes) > 1 and any(box.token == NOP_TOKEN for box in boxes):
        remarks.append("NOP beside an output does nothing: it is left out")
        boxes = [box for box in boxes if box.token != NOP_TOKEN]
    if not boxes:
        remarks.append("the rung has no output: it becomes NOP")
        nop = _rung(drawn, Always(span), (nothing(span),))
        return ImportedRung(nop, tuple(notes), tuple(remarks))
    fed = {RAIL, *(arc.stop for arc in network.arcs)}
    for box in boxes:
        if network.ends[box.row] not in fed and box.token != NOP_TOKEN:
            raise _problem(drawn, box.row, f"{_shortened(box.token)} is not connected to the power rail")
    try:
        ends, taps = {network.ends[box.row] for box in boxes} & fed, {*network.ends.values()} & fed
        tree = tree_of(network.arcs, ends)
        # A pin taps the part that it shares with an output, too.
        notes += dict.fromkeys((tree if taps == ends else tree_of(network.arcs, taps)).notes)
        actions = [_action(drawn, network, box, fed) for box in boxes]
    except TooEntangled:
        raise LadderProblem(ENTANGLED, drawn.file, drawn.line) from None
    paths = [tree.path(network.ends[box.row]) if network.ends[box.row] in fed else () for box in boxes]
    items = _items([_Output(path, action) for path, action in zip(paths, actions, strict=True)])
    condition: Condition = Always(span)
    if len(items) == 1 and isinstance(items[0], Branch):
        condition, items = items[0].condition, items[0].items
    return ImportedRung(_rung(drawn, condition, items), tuple(notes), tuple(remarks))


def _comment_remarks(drawn: DrawnRung) -> list[str]:
    """The remarks on the comment. Raises LadderProblem for one that would not come back."""
    if not is_comment_kept(drawn.comment):
        message = f"a line of the comment begins with {DIRECTIVE!r}, which speaks to clickgen, or no file can hold it"
        raise LadderProblem(message, drawn.file, drawn.line)
    has_spaces = any(line != line.rstrip() for line in drawn.comment.split("\n"))
    return ["spaces at the ends of the comment's lines are left out"] if has_spaces else []


def is_comment_kept(comment: str) -> bool:
    """False if a line of a comment would be read as something else, or is not possible in a UTF-8 file."""
    if "\0" in comment or any("\ud800" <= character <= "\udfff" for character in comment):
        return False
    return not any(line.strip().startswith(DIRECTIVE) for line in comment.split("\n"))


def _rung(drawn: DrawnRung, condition: Condition, items: tuple[Item, ...]) -> Rung:
    return Rung(condition, items, drawn.comment, drawn.span, drawn.span)


def _problem(drawn: DrawnRung, row: int, message: str) -> LadderProblem:
    return LadderProblem(message, drawn.file, drawn.rows[row].line)


def _shortened(token: str) -> str:
    return token if len(token) <= 60 else f"{token[:57]}..."


# -- outputs ----------------------------------------------------------------------------------------------------------


def _action(drawn: DrawnRung, network: Network, box: DrawnBox, fed: set[Place]) -> Action:
    line = drawn.rows[box.row].line
    span = Span(drawn.file, line, 1, line, 2)
    pins = {token: _pin(network, network.ends[row], fed, span) for token, row in box.pins}
    action = action_of(box.token, pins, span)
    if action is None and not pins:
        action = raw_of(box.token, span)
    if action is None:
        with_pins = f" with {', '.join(pins)}" if pins else ""
        raise _problem(drawn, box.row, f"{_shortened(box.token)}{with_pins} {_why_unknown(box.token)}")
    return action


def _why_unknown(token: str) -> str:
    """The reason why a token is not an instruction, to follow the token."""
    missing = missing_address(token)
    if missing:
        return f"names {missing}, which CLICK does not have"
    if token.startswith((f"{WORD}(", "math(")):
        fault = fault_of(token)
        if fault is None:
            return "has inputs that it cannot have"
        return f"cannot be kept: {fault.message}; {fault.way_out(default().spell)}"
    if specs_of(token):
        return "is not written as CLICK writes it: look at its arguments and its inputs"
    return "is no instruction that CLICK is known for"


def _pin(network: Network, end: Place, fed: set[Place], span: Span) -> Condition:
    """The condition of an input; one that is not connected is never on."""
    if end not in fed:
        return Contact(Cell(ALWAYS_ON, span), span, negated=True)
    return series((arc.condition for arc in tree_of(network.arcs, {end}).path(end)), span)


def _items(outputs: Sequence[_Output]) -> tuple[Item, ...]:
    """Actions and branches in the order of the outputs; a branch that is interrupted is opened again."""
    items: list[Item] = []
    for arc, group in groupby(outputs, key=lambda output: output.path[0] if output.path else None):
        if arc is None:
            items += [output.action for output in group]
            continue
        inner = _items([replace(output, path=output.path[1:]) for output in group])
        span = inner[0].span
        if isinstance(arc.condition, Always):
            items += inner
        elif len(inner) == 1 and isinstance(inner[0], Branch):
            items.append(Branch(series((arc.condition, inner[0].condition), span), inner[0].items, span))
        else:
            items.append(Branch(arc.condition, inner, span))
    return tuple(items)


# -- routines ---------------------------------------------------------------------------------------------------------


def routine_of(name: str, rungs: Sequence[Rung], is_main: bool, function: str = "") -> Routine:
    """Return the rungs of a file as a routine, with loops closed around their rungs.

    ``name`` is CLICK's, ``function`` the source's; without one it is the same name. Raises LadderProblem for a name
    that a function cannot have.
    """
    span = rungs[0].span if rungs else Span(name, 1, 1, 1, 2)
    function = function or name
    is_function = function.isascii() and function.isidentifier() and not iskeyword(function)
    if not is_function or is_main != (name == "main") or is_main != (function == "main"):
        raise LadderProblem(f"a subroutine cannot have the name {function!r} here", span.path, span.line)
    return Routine(name, with_loops(rungs), span, is_main, function=function)


def with_loops(rungs: Sequence[Rung]) -> tuple[Rung, ...]:
    """Return the rungs between ``for`` and ``next()`` as the body of a loop, if that means the same."""
    found: list[Rung] = []
    index = 0
    while index < len(rungs):
        rung, stop = rungs[index], _end_of_loop(rungs, index)
        if stop is None:
            found.append(_with_open_loop(rung))
            index += 1
            continue
        [action] = rung.items
        assert isinstance(action, Action)
        found.append(replace(rung, items=(Loop(action, tuple(rungs[index + 1 : stop])),)))
        index = stop + 1
    return tuple(found)


def _end_of_loop(rungs: Sequence[Rung], start: int) -> int | None:
    """The rung of the ``next()`` that closes the loop of this rung; None if it is not a loop or does not close so."""
    if not _is_alone(rungs[start], Flow.LOOP):
        return None
    for index in range(start + 1, len(rungs)):
        rung = rungs[index]
        if _is_alone(rung, Flow.NEXT):
            is_plain = isinstance(rung.condition, Always) and not rung.comment
            return index if is_plain and index > start + 1 else None
        if any(action.effects.flow in (Flow.LOOP, Flow.NEXT) for action in actions_in(rung.items)):
            return None
    return None


def _is_alone(rung: Rung, flow: Flow) -> bool:
    return len(rung.items) == 1 and isinstance(rung.items[0], Action) and rung.items[0].effects.flow is flow


def _with_open_loop(rung: Rung) -> Rung:
    is_open = any(action.effects.flow is Flow.LOOP for action in actions_in(rung.items))
    return replace(rung, items=_opened(rung.items)) if is_open else rung


def _opened(items: Sequence[Item]) -> tuple[Item, ...]:
    """Return the items with every ``for`` as a loop that ``next_loop()`` closes."""
    found: list[Item] = []
    for item in items:
        if isinstance(item, Branch):
            found.append(replace(item, items=_opened(item.items)))
        else:
            found.append(Loop(item, None) if isinstance(item, Action) and item.effects.flow is Flow.LOOP else item)
    return tuple(found)
