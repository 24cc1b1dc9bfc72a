"""Turns one source rung into one or more CLICK rungs with the same meaning.

Every condition of a source rung is looked at before any of its actions runs. If the rung has to be split, a
condition that an earlier part could change, or that must not be looked at twice, goes to a scratch bit first.
``effects.py`` knows which these are.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate, takewhile

from clickgen.click.draw.grid import COLUMNS, MAX_ROWS, DoesNotFit, Grid, draw
from clickgen.click.draw.network import bits, is_range, network
from clickgen.click.draw.words import condition_words
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import All, Always, Any, Condition, Contact
from clickgen.ir.made import coil, loop_closing
from clickgen.ir.operands import Cell, Immediate, Range
from clickgen.ir.program import Action, Branch, Item, Loop, Program, Routine, Rung, Value, actions_in, rungs_in
from clickgen.ir.walk import leaves
from clickgen.lower.effects import Effects
from clickgen.lower.expand import OffDelays, Own, expand
from clickgen.lower.looks import asserted, look_of, looking_at
from clickgen.lower.scratch import Scratch, shown_in_reason
from clickgen.lower.steps import Node, Part, Past, Step, apart, is_of_program, nodes_of, pins_of, run_by
from clickgen.text.source import Span

_FREE_COLUMNS = COLUMNS - 1
"""A condition whose legs merge, or that feeds several outputs, leaves the last column for the wire after the merge."""


@dataclass(frozen=True)
class ClickRung:
    """One rung of CLICK: a condition and what depends on it, in instructions that CLICK has."""

    condition: Condition
    items: tuple[Item, ...]
    comment: str
    span: Span

    @cached_property
    def grid(self) -> Grid:
        """The drawn rung. Raises DoesNotFit."""
        return draw(self.condition, self.items)

    @property
    def actions(self) -> tuple[Action, ...]:
        return tuple(actions_in(self.items))


@dataclass(frozen=True)
class ClickRoutine:
    name: str
    is_main: bool
    rungs: tuple[ClickRung, ...]
    span: Span


def lower(program: Program, scratch: Scratch) -> tuple[ClickRoutine, ...]:
    """Return every routine in CLICK rungs, with placeholders for scratch cells. The program must have no problems."""
    delays = OffDelays(scratch.take)
    for routine in program.routines:
        for rung in rungs_in(routine.rungs):
            for action in actions_in(rung.items):
                if action.spec.built_from is not None:
                    delays.add(action)
    if delays:
        program = delays.program(program)
    effects = Effects(program.routines, delays)
    return tuple(_RoutineLowering(routine, effects, scratch, delays).run() for routine in program.routines)


@dataclass
class _RoutineLowering:
    """The CLICK rungs of one routine, in the order in which they are made."""

    routine: Routine
    effects: Effects
    scratch: Scratch
    delays: OffDelays
    rungs: list[ClickRung] = field(default_factory=list)

    def run(self) -> ClickRoutine:
        self.lower(self.routine.rungs)
        return ClickRoutine(self.routine.name, self.routine.is_main, tuple(self.rungs), self.routine.span)

    def lower(self, rungs: Sequence[Rung]) -> None:
        for rung in rungs:
            if self.scratch.is_over:
                return  # The program has no address for more: nothing of it is drawn.
            _RungSplit(self, rung).run()


class _RungSplit:
    """Lowers one source rung."""

    def __init__(self, home: _RoutineLowering, rung: Rung) -> None:
        self._home = home
        self._rung = rung
        self._comment = rung.comment

    def run(self) -> None:
        condition, items = _joined(self._rung.condition, self._rung.items)
        steps = list(self._steps(items, Node(condition)))
        # One NOP keeps a rung legal; a second one, or one beside an output, does not (click-facts [grid.nop]).
        parts = apart([step for step in steps if step.action.effects.flow is not Flow.PASS] or steps[:1])
        rung = self._rung_of(parts[0])
        if len(parts) == 1 and _draws(rung) and not parts[0][0].action.spec.pins:
            self._emit_drawn(parts[0], rung)
            return
        looking = [part for part in parts if is_of_program(part)]
        if len(looking) > 1 or not _draws(self._rung_of(looking[0])):
            self._look_once(parts)
        for node in nodes_of(parts):
            node.condition = self._reduced(node.condition)
        parts = [piece for part in parts for piece in self._fitting(part)]
        for node in self._unsafe(parts):
            node.condition = self._on_scratch(node.condition, "condition")
        self._hoist_pins(parts)
        for part in parts:
            self._emit_part(part)

    # -- taking the rung apart ----------------------------------------------------------------------------------------

    def _steps(self, items: tuple[Item, ...], node: Node) -> Iterator[Step]:
        """Yield every action in source order with its conditions, in instructions that CLICK has."""
        for item in items:
            if isinstance(item, Branch):
                condition, inner = _joined(item.condition, item.items)
                yield from self._steps(inner, Node(condition, node))
            elif isinstance(item, Loop):
                yield Step(node, item.action, item.body)
            else:
                for expanded in expand(item, self._take, self._home.delays):
                    if isinstance(expanded, Own):
                        yield Step(Node(expanded.condition, is_own=True), expanded.action)
                    else:
                        yield Step(node, expanded)

    def _fitting(self, part: Part) -> Iterator[Part]:
        """Yield a part in the fewest pieces that fit CLICK's rows, each as long as possible."""
        while len(part) > 1:
            # Each output takes its rows, whatever the conditions are: more steps than these cannot fit.
            rows = accumulate(step.action.height for step in part)
            most = max(sum(1 for _ in takewhile(lambda used: used <= MAX_ROWS, rows)), 1)
            if most == len(part) and _draws(self._rung_of(part)):
                break
            # Fitting is monotone: find the longest beginning that fits; one step alone is reduced later.
            count = bisect_left(range(2, most + 1), True, key=lambda n: not _draws(self._rung_of(part[:n]))) + 1
            yield part[:count]
            part = part[count:]
        yield part

    def _rung_of(self, part: Part) -> ClickRung:
        condition, items = _tree(part, 0)
        return ClickRung(condition, items, self._comment, self._rung.span)

    # -- keeping the meaning ------------------------------------------------------------------------------------------

    def _look_once(self, parts: list[Part]) -> None:
        """Put each contact that changes by itself, and that several conditions look at, on one scratch bit for all."""
        nodes = [node for node in nodes_of(parts) if not node.is_own]
        steps = [step for part in parts for step in part]
        conditions = [*(node.condition for node in nodes), *(pin for step in steps for pin in pins_of(step).values())]
        looks = Counter(look_of(leaf) for condition in conditions for leaf in leaves(condition))
        kept: dict[str, Contact] = {}
        for condition in conditions:
            for leaf in leaves(condition):
                look = look_of(leaf)
                if looks[look] > 1 and look not in kept and self._home.effects.is_volatile(leaf):
                    kept[look] = self._on_scratch(asserted(leaf), "contact")
        if not kept:
            return
        for node in nodes:
            node.condition = looking_at(node.condition, kept)
        for step in steps:
            step.take_pins({name: looking_at(pin, kept) for name, pin in pins_of(step).items()})

    def _unsafe(self, parts: list[Part]) -> list[Node]:
        """The conditions that would have changed for a later part, or that must not be looked at twice."""
        unsafe: dict[Node, None] = {}
        for part, past in self._with_past(parts):
            for node in nodes_of([part]):
                if not node.is_own and past.spoils(node.condition):
                    unsafe[node] = None
        return list(unsafe)

    def _hoist_pins(self, parts: list[Part]) -> None:
        """Hoist pins whose condition an earlier part changes, or whose parallel legs do not fit the grid."""
        for part, past in self._with_past(parts):
            for step in part:
                for name, condition in pins_of(step).items():
                    reduced = self._reduced(condition)
                    too_tall = _height(reduced) > 1 and name != step.action.spec.pins[-1].name
                    if too_tall or past.spoils(condition):
                        reduced = self._on_scratch(reduced, f"{name} input")
                    step.take_pins({name: reduced})

    def _with_past(self, parts: list[Part]) -> Iterator[tuple[Part, Past]]:
        """Yield each part with what ran in this rung before it."""
        past = Past(self._home.effects)
        for part in parts:
            yield part, past
            past.has_run = past.has_run or is_of_program(part)
            for action in run_by(part):
                past.written.update(self._home.effects.writes(action))
                past.may_have_left = past.may_have_left or action.effects.leaves

    def _on_scratch(self, condition: Condition, purpose: str) -> Contact:
        """Put a condition on a scratch bit, in an earlier rung; return the contact that reads it."""
        content = condition
        match condition:
            case All(terms=(Contact() as contact,)) if is_range(contact):
                # Tables of earlier versions name the bits of a range that was cut.
                content = All(tuple(bits(contact)), condition.span)
        cell = self._take("C", purpose, condition.span, condition_words(content, shown_in_reason))
        self._emit(condition, (coil(cell, condition.span),))
        return Contact(cell, condition.span)

    def _take(self, bank: str, purpose: str, span: Span, content: str = "") -> Cell:
        return self._home.scratch.take(bank, f"{purpose} of {self._home.routine.name}", span, content)

    # -- conditions too large for the grid ----------------------------------------------------------------------------

    def _reduced(self, condition: Condition) -> Condition:
        """Return a condition that fits the grid: parts of a larger one go to scratch bits."""
        if _fits_alone(condition):
            return condition
        is_series = not isinstance(condition, Any)
        terms = [term if is_series and isinstance(term, Contact) else self._reduced(term) for term in _terms(condition)]
        limit = _FREE_COLUMNS if is_series else MAX_ROWS
        join = All if is_series else Any
        sizes = [_width(term) if is_series else _height(term) for term in terms]
        while sum(sizes) > limit:
            stop = bisect_right(list(accumulate(sizes)), limit)
            if is_series and len(pieces := _divided(terms[stop], limit - sum(sizes[:stop]))) > 1:
                terms[stop : stop + 1] = pieces
                sizes[stop : stop + 1] = map(_width, pieces)
                continue
            # A single contact gains nothing on a scratch bit: then the term after it is the one that is too large.
            start = 1 if stop == 1 and sizes[0] == 1 else 0
            stop = max(stop, start + 1)
            chunk = join(tuple(terms[start:stop]), condition.span)
            terms[start:stop] = [self._on_scratch(chunk, "part of the condition")]
            sizes[start:stop] = [1]
        return join(tuple(terms), condition.span)

    # -- putting CLICK rungs down -------------------------------------------------------------------------------------

    def _emit_part(self, part: Part) -> None:
        rung = self._rung_of(part)
        self._emit_drawn(part, rung if _draws(rung) else self._squeezed(part[0]))

    def _emit_drawn(self, part: Part, rung: ClickRung) -> None:
        self._put(rung)
        body = part[-1].body
        if body is not None:
            self._home.lower(body)
            self._emit(Always(part[-1].action.span), (loop_closing(part[-1].action.span),))

    def _squeezed(self, step: Step) -> ClickRung:
        """Lower one action whose conditions fit one by one but not together: they go to scratch bits."""
        action = step.action
        path = All(tuple(node.condition for node in step.node.path), self._rung.condition.span)
        enable: Condition = self._reduced(path)
        if not self._takes(enable, action) and _is_large(enable):
            enable = self._on_scratch(enable, "condition")
        if not self._takes(enable, action):
            pins: dict[str, Value] = {}
            for param in action.spec.pins:
                pin = action.pin(param.name)
                if pin is not None and _is_large(pin):
                    pins[param.name] = self._on_scratch(pin, f"{param.name} input")
            action = Action(action.spec, {**action.args, **pins}, action.span)
        return ClickRung(enable, (action,), self._comment, self._rung.span)

    def _takes(self, condition: Condition, action: Action) -> bool:
        return _draws(ClickRung(condition, (action,), "", self._rung.span))

    def _emit(self, condition: Condition, items: tuple[Item, ...]) -> None:
        self._put(ClickRung(condition, items, self._comment, self._rung.span))

    def _put(self, rung: ClickRung) -> None:
        """Add the next CLICK rung; the first one has the source rung's comment."""
        self._home.rungs.append(rung)
        self._comment = ""


def _joined(condition: Condition, items: tuple[Item, ...]) -> tuple[Condition, tuple[Item, ...]]:
    """A condition in series with that of a lone branch: nested ifs and ``all(...)`` become the same rung."""
    while len(items) == 1 and isinstance(items[0], Branch):
        branch = items[0]
        terms = tuple(term for one in (condition, branch.condition) for term in _flat(one, All))
        condition = All(terms, condition.span)
        items = branch.items
    return condition, items


def _flat(condition: Condition, join: type[All] | type[Any]) -> Iterator[Condition]:
    """The terms of a series, including those of a series in it; or of a parallel, with a parallel in it."""
    if isinstance(condition, join):
        for term in condition.terms:
            yield from _flat(term, join)
    else:
        yield condition


def _tree(part: Part, depth: int) -> tuple[Condition, tuple[Item, ...]]:
    """The condition at this depth of the part's first step, and what depends on it; lone branches join their parent."""
    condition = part[0].node.path[depth].condition
    items: list[Item] = []
    index = 0
    while index < len(part):
        path = part[index].node.path
        if len(path) == depth + 1:
            items.append(part[index].action)
            index += 1
            continue
        stop = index
        while stop < len(part) and part[stop].node.path[depth + 1 : depth + 2] == path[depth + 1 : depth + 2]:
            stop += 1
        inner, inner_items = _tree(part[index:stop], depth + 1)
        items.append(Branch(inner, inner_items, inner.span))
        index = stop
    if len(items) == 1 and isinstance(items[0], Branch):
        branch = items[0]
        return All((condition, branch.condition), condition.span), branch.items
    return condition, tuple(items)


def _width(condition: Condition) -> int:
    net = network(condition)
    return net.width if net is not None else 0


def _height(condition: Condition) -> int:
    net = network(condition)
    return net.height if net is not None else 0


def _is_large(condition: Condition) -> bool:
    """True if the condition takes more than the one contact of a scratch bit."""
    return _width(condition) > 1 or _height(condition) > 1


def _fits_alone(condition: Condition) -> bool:
    return _width(condition) <= _FREE_COLUMNS and _height(condition) <= MAX_ROWS


def _draws(rung: ClickRung) -> bool:
    try:
        return rung.grid is not None
    except DoesNotFit:
        return False


def _terms(condition: Condition) -> list[Condition]:
    """The parts of a series or a parallel. A contact on a range is a series of its bits."""
    return list(_flat(condition, Any if isinstance(condition, Any) else All))


def _divided(condition: Condition, width: int) -> list[Condition]:
    """Divide a contact on a range in two, the first with this many bits; anything else is unchanged."""
    if not (isinstance(condition, Contact) and is_range(condition) and 0 < width < _width(condition)):
        return [condition]
    operand = condition.operand
    whole = operand.target if isinstance(operand, Immediate) else operand
    assert isinstance(whole, Range)
    numbers = [address.number for address in whole.addresses()]
    parts = [Range(whole.bank, part[0], part[-1], whole.span) for part in (numbers[:width], numbers[width:])]
    is_immediate = isinstance(operand, Immediate)
    return [replace(condition, operand=Immediate(part, operand.span) if is_immediate else part) for part in parts]
