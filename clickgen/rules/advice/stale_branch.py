"""A branch that looks at what its own rung writes: CLICK has looked at it before the first action ran
(click-facts [scan.conditions])."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from clickgen.device.banks import parse_address
from clickgen.facts.changes import Changes, Extent, meets
from clickgen.facts.facts import Facts
from clickgen.facts.uses import addresses_of, extents_of
from clickgen.instructions.effects import Effects, Flow, Keeps
from clickgen.ir.conditions import Compare, Condition, Contact
from clickgen.ir.operands import Immediate, Operand
from clickgen.ir.program import Action, Branch, Item, Loop, Routine, Rung
from clickgen.ir.walk import condition_operands, leaves
from clickgen.logic.conditions import are_exclusive
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG542"


class _Write(NamedTuple):
    action: Action
    path: tuple[Condition, ...]
    """The conditions above it, its rung's first."""
    extents: list[Extent]


class _Look(NamedTuple):
    condition: Condition
    path: tuple[Condition, ...]
    """The conditions in series with it."""
    what: str


def find(facts: Facts) -> Findings:
    writes = _Writes(facts)
    for routine in facts.program.routines:
        for rung in _rungs_with_several(routine.rungs):
            yield from _judge(facts, writes, rung)


def _rungs_with_several(rungs: tuple[Rung, ...]) -> Iterator[Rung]:
    """Yield the rungs, those of loops' bodies too, in which something can come before a branch or a box."""
    for rung in rungs:
        if len(rung.items) > 1 or any(isinstance(item, Branch) for item in rung.items):
            yield rung
        for item in rung.items:
            if isinstance(item, Loop):
                yield from _rungs_with_several(item.body or ())


def _judge(facts: Facts, writes: _Writes, rung: Rung) -> Findings:
    written = _Written()
    for step in _steps(rung.items, (rung.condition,)):
        if isinstance(step, _Look):
            for leaf in leaves(step.condition):
                write = next((one for one in written.near(leaf) if _is_stale(step, leaf, one)), None)
                if write is not None:
                    yield from _report(facts, step, leaf, write)
        else:
            action, path = step
            extents = writes.of(action)
            if extents:
                written.add(_Write(action, path, extents))


class _Written:
    """The writes of a rung's actions so far, by address: a contact asks only for those that may concern it."""

    def __init__(self) -> None:
        self._writes: list[_Write] = []
        self._at: dict[tuple[str, int], list[int]] = {}
        self._wide: dict[str, list[int]] = {}
        """The writes over a long stretch of a bank."""

    def add(self, write: _Write) -> None:
        index = len(self._writes)
        self._writes.append(write)
        for bank, first, last in write.extents:
            if last - first >= _LONG:
                self._wide.setdefault(bank, []).append(index)
            else:
                for number in range(first, last + 1):
                    self._at.setdefault((bank, number), []).append(index)

    def near(self, leaf: Contact | Compare) -> list[_Write]:
        """The writes that may meet what a contact or a comparison reads, in their order."""
        found: set[int] = set()
        for bank, first, last in (extent for operand in condition_operands(leaf) for extent in extents_of(operand)):
            found.update(self._wide.get(bank, ()))
            found.update(index for number in range(first, last + 1) for index in self._at.get((bank, number), ()))
        return [self._writes[index] for index in sorted(found)]


_LONG = 64

_Step = tuple[Action, tuple[Condition, ...]] | _Look


def _steps(items: tuple[Item, ...], path: tuple[Condition, ...]) -> Iterator[_Step]:
    """Yield what a rung does and looks at, in the order of the source."""
    for item in items:
        if isinstance(item, Branch):
            yield _Look(item.condition, (*path, item.condition), "branch")
            yield from _steps(item.items, (*path, item.condition))
        elif isinstance(item, Action):
            for param in item.spec.pins:
                pin = item.pin(param.name)
                if pin is not None:
                    yield _Look(pin, (pin,), f"input {param.name}")
            yield item, path


def _is_stale(look: _Look, leaf: Contact | Compare, write: _Write) -> bool:
    operands = [one for one in condition_operands(leaf) if not isinstance(one, Immediate)]
    seen = [one for one in operands if meets(write.extents, one)]
    if not seen:
        return False
    # Steps and toggles in the branches of one rung want the earlier value.
    if any(_reads(condition, seen) for condition in write.path):
        return False
    return not are_exclusive(*write.path, *look.path)


def _reads(condition: Condition, operands: Iterable[Operand]) -> bool:
    extents = [extent for operand in condition_operands(condition) for extent in extents_of(operand)]
    return any(meets(extents, operand) for operand in operands)


def _takes_its_time(effects: Effects) -> bool:
    """True where what is written changes in some later scan anyway, or where nobody knows when."""
    return effects.is_late or effects.is_unknown or not effects.keeps.isdisjoint((Keeps.TIME, Keeps.STEP))


class _Writes:
    """The addresses that an action certainly writes in this scan: CLICK's flags too, and a called routine's writes."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        self._changes = Changes(facts)
        self._by_routine: dict[str, list[Extent]] = {}

    def of(self, action: Action) -> list[Extent]:
        if _takes_its_time(action.effects):
            return []
        if action.effects.flow is Flow.CALL:
            return self._of_routine(action.called)
        flags = filter(None, map(parse_address, action.effects.flags))
        return [*self._changes.surely(action), *((flag.bank, flag.number, flag.number) for flag in flags)]

    def _of_routine(self, name: str) -> list[Extent]:
        if name not in self._by_routine:
            found = self._by_routine[name] = []
            for routine in self._facts.program.subroutines:
                if routine.name == name:
                    found += self._surely(routine)
        return self._by_routine[name]

    def _surely(self, routine: Routine) -> Iterator[Extent]:
        """The addresses that a run of a subroutine writes in any case, up to where it may be left."""
        for placed in self._facts.actions_of(routine):
            if placed.effects.leaves:
                return
            always_writes = placed.is_unconditional or placed.effects.follows_power
            if always_writes and not placed.loop and not _takes_its_time(placed.effects):
                yield from self._changes.surely(placed.action)


def _report(facts: Facts, look: _Look, leaf: Contact | Compare, write: _Write) -> Findings:
    operand = next(one for one in condition_operands(leaf) if meets(write.extents, one))
    name = facts.listed(addresses_of(operand))
    place = write.action.span.seen_from(leaf.span)
    yield finding(
        CODE,
        leaf.span,
        f"this {look.what} sees {name} as it was before the {write.action.spec.name} in {place}: CLICK looks at all "
        "conditions of a rung before its first action",
        f"put the {look.what.partition(' ')[0]} into a rung of its own below this one: there it sees the new value"
        if look.what == "branch"
        else "put the box into a rung of its own below this one: there its inputs see the new value",
        (Label(write.action.span, "written here, in the same rung"),),
    )


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a branch looks at what its own rung writes",
    """
CLICK looks at all conditions of a rung, those of its branches and of the inputs of its boxes too, before the first
action of the rung runs. A branch below an action sees what was there before that action: where the rung stays on, it
comes a scan late; where the rung is on for one scan only, it never sees the new value, or sees that of the last time.

Give the branch a rung of its own below, with the condition of the first one in series. A rung of its own sees what the
rungs above it have written.

Branches that step on from each other, `if c.A: reset(c.A)` beside `if nc(c.A): set(c.A)`, want the value from before:
if the action's own condition looks at the same address, the rule is silent. It is silent too about timers,
drums and messages, which change in some later scan in any case.
""",
    wrong=(
        Wrong(
            """
if re(x.Part):
    calc("ds.Parts + 1", ds.Parts)
    if ds.Parts >= 10:  # <-
        set(c.BatchFull)
"""
        ),
        Wrong(
            """
if re(x.Find):
    search(ds[101:151] == ds.Wanted, result=ds.FoundAt, found=c.Found)
    if c.Found:  # <-
        copy(ds.FoundAt, ds.Row)
"""
        ),
        Wrong(
            """
if re(x.Weigh):
    calc("ds.Gross / ds.Count", ds.Each)
    if sc[40]:  # <-
        set(c.NoCount)
"""
        ),
        Wrong(
            """
def main():
    if re(x.Part):
        call(measure)
        if ds.Length > 500:  # <-
            set(c.TooLong)
    if True:
        end()


@sub
def measure():
    if True:
        calc("ds.Last - ds.First", ds.Length)
    if True:
        return
"""
        ),
    ),
    right=(
        """
if re(x.Part):
    calc("ds.Parts + 1", ds.Parts)

if all(re(x.Part), ds.Parts >= 10):
    set(c.BatchFull)
""",
        """
if re(x.Button):
    if nc(c.Lamp):
        set(c.Lamp)
    if c.Lamp:
        reset(c.Lamp)
""",
        """
if True:
    if ds.Value != ds.Before:
        set(c.Changed)
    copy(ds.Value, ds.Before)
""",
        """
if y.Motor:
    ton(t.RunUp, setpoint=3, unit=Ts)
    if t.RunUp:
        out(y.Ready)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
