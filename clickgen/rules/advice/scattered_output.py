"""An output that several routines drive."""

from __future__ import annotations

from itertools import combinations, islice, product

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import FIRST_SCAN, Facts, Placed
from clickgen.ir.conditions import Condition, Contact
from clickgen.ir.operands import Cell
from clickgen.logic.conditions import are_exclusive, implies
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span

CODE = "CG522"

_PAIRS_MAX = 1000
"""If this many pairs of drivers exclude each other, the rest is assumed to do so too; this many pairs of routines are
looked at, which is every pair of 45."""

_Drivers = list[Placed]
"""All drivers of one output in one routine."""


def find(facts: Facts) -> Findings:
    for number in BANKS["Y"].numbers():
        output = Address("Y", number)
        drivers: dict[str, _Drivers] = {}
        for placed in facts.writers(output):
            # Nobody knows whether it drives the output.
            if placed.effects.is_unknown:
                continue
            drivers.setdefault(placed.routine.name, []).append(placed)
        if len(drivers) > 1:
            yield from _judge(facts, output, list(drivers.values()))


def _judge(facts: Facts, output: Address, drivers: list[_Drivers]) -> Findings:
    working = [[placed for placed in own if not _is_start_up(facts, placed)] for own in drivers]
    pairs = islice(combinations(filter(None, working), 2), _PAIRS_MAX)
    meeting = [pair for pair in pairs if _meet(facts, *pair)]
    together = [own for own in working if any(own is one for pair in meeting for one in pair)]
    if together:
        yield from _report(facts, output, together)


def _is_start_up(facts: Facts, placed: Placed) -> bool:
    """True for an action of the first scan only, which is over before any routine works, or one that nothing calls."""
    return all(any(map(_in_first_scan, way)) for way in _ways(facts, placed))


def _in_first_scan(condition: Condition) -> bool:
    return implies(condition, Contact(Cell(FIRST_SCAN, condition.span), condition.span))


def _meet(facts: Facts, one: _Drivers, other: _Drivers) -> bool:
    """True if two routines may drive the output in the same scan and get in each other's way."""
    if all(any(placed.effects.follows_power for placed in drivers) for drivers in (one, other)):
        return False  # CG501 reports it.
    mine, theirs = ({placed.action.turns for placed in drivers} for drivers in (one, other))
    if None not in mine | theirs and not (True in mine and True in theirs):
        return False  # A latch that one routine sets, and that another turns off as well.
    for turns, late, early in ((mine, one, other), (theirs, other, one)):
        if turns == {False} and min(_moments(facts, late)) > max(_moments(facts, early)):
            return False  # Turned off at the end of the scan, whatever its state before.
    if facts.run_apart(one[0].routine, other[0].routine):
        return False
    pairs = [pair for pair in islice(product(one, other), _PAIRS_MAX) if not _agree(*pair)]
    return not all(_are_apart(facts, first, second) for first, second in pairs)


def _agree(one: Placed, other: Placed) -> bool:
    """True for two that do the same, whichever comes first: turn the output on, or off."""
    return one.action.turns is not None and one.action.turns is other.action.turns


def _moments(facts: Facts, drivers: _Drivers) -> list[Span]:
    """The places where main drives the output, or calls the routine that does."""
    routine = drivers[0].routine
    return [placed.action.span for placed in (drivers if routine.is_main else facts.calls[routine.name])]


def _are_apart(facts: Facts, one: Placed, other: Placed) -> bool:
    return all(are_exclusive(*mine, *theirs) for mine, theirs in product(_ways(facts, one), _ways(facts, other)))


def _ways(facts: Facts, placed: Placed) -> list[list[Condition]]:
    """The conditions for the action to write, for each call that leads to it."""
    # It may write its outputs while its rung is off, or in its own time.
    own = facts.ways_to(placed) if placed.effects.needs_power else []
    if placed.routine.is_main:
        return [[*own]]
    return [[*facts.ways_to(call), *own] for call in facts.calls.get(placed.routine.name, ())]


def _report(facts: Facts, output: Address, together: list[_Drivers]) -> Findings:
    second = together[1][0]
    names = [drivers[0].routine.name for drivers in together]
    others = [drivers[0] for drivers in together if drivers[0] is not second]
    yield finding(
        CODE,
        second.action.span,
        f"{facts.shown(output)} is driven in {', '.join(names[:-1])} and {names[-1]}: the routine that runs last in a "
        "scan decides",
        "drive it in one routine, from bits that the others set; or call them under conditions that exclude each other",
        tuple(Label(placed.action.span, f"driven in {placed.routine.name}") for placed in others),
    )


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "an output is driven from several routines",
    """
Several routines write this output, and in one scan more than one of them may run. The last one decides, so the output
flickers or does not come although the rung in front of you is on; and nobody finds from one place why it is on.

Drive an output in one routine, from C bits that the others write. Routines whose calls have conditions that
exclude each other may share an output; a latch that some routines set may be reset in one other; and a reset that runs
after all the rest of the scan may turn off what it likes. If each of them uses `out`, CG501 reports it.
""",
    wrong=(
        Wrong(
            """
def main():
    if True:
        call(filling)
        call(cleaning)

    if True:
        end()


@sub
def filling():
    if c.Fill:
        out(y.Valve)

    if True:
        return


@sub
def cleaning():
    if c.Rinse:
        set(y.Valve)  # <-

    if c.Clean:
        reset(y.Valve)

    if True:
        return
"""
        ),
    ),
    right=(
        """
def main():
    if ds.Mode == 1:
        call(filling)

    if ds.Mode == 2:
        call(cleaning)

    if all(ds.Mode != 1, ds.Mode != 2):
        reset(y.Valve)

    if True:
        end()


@sub
def filling():
    if c.Fill:
        out(y.Valve)

    if True:
        return


@sub
def cleaning():
    if c.Rinse:
        set(y.Valve)

    if c.Clean:
        reset(y.Valve)

    if True:
        return
""",
        """
def main():
    if True:
        call(filling)

    if x.EmergencyStop:
        reset(y[1:17])

    if True:
        end()


@sub
def filling():
    if c.Fill:
        set(y.Valve)

    if x.Full:
        reset(y.Valve)

    if True:
        return
""",
    ),
)

RULE = Rule(find, (ABOUT,))
