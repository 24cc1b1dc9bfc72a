"""A running current value compared with == or !=: a timer skips values, a counter counts on when nobody looks."""

from __future__ import annotations

from collections.abc import Mapping

from clickgen.device.banks import Address, current_value
from clickgen.facts.copied import origin_registers
from clickgen.facts.facts import Facts
from clickgen.instructions.timers import PRESET_MAX, UNIT
from clickgen.ir.conditions import Compare, Contact
from clickgen.ir.operands import Cell, Integer, Single
from clickgen.ir.program import Routine
from clickgen.ir.walk import leaves
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span

CODE = "CG511"

_RESTS = (0, PRESET_MAX)
"""The values at which a timer stops: at rest, and at its end (click-facts [timer.on-delay])."""


def find(facts: Facts) -> Findings:
    yield from _check_timers(facts)
    yield from _check_counters(facts)


def _check_counters(facts: Facts) -> Findings:
    """Check for a counter that counts on while the subroutine that tests one of its values is not called."""
    for site in facts.sites:
        if site.routine.is_main:
            continue
        for leaf in leaves(site.condition):
            counter = _counter_in(leaf)
            if counter and facts.sometimes(site.routine) and _counts_elsewhere(facts, counter.address, site.routine):
                yield finding(
                    CODE,
                    leaf.span,
                    f"{facts.shown(counter.address)} counts on while {site.routine.name} is not called: the value may "
                    "have passed by then",
                    "compare with >=, or compare in main and set a bit",
                )


def _counter_in(leaf: Contact | Compare) -> Cell | None:
    """The counter whose value is compared for equality with a number."""
    if isinstance(leaf, Compare) and leaf.op == "==":
        for side, other in ((leaf.left, leaf.right), (leaf.right, leaf.left)):
            if isinstance(side, Cell) and side.bank == "CTD" and isinstance(other, Integer) and other.value:
                return side
    return None


def _counts_elsewhere(facts: Facts, value: Address, routine: Routine) -> bool:
    writers = facts.writers(value)
    return bool(writers) and all(writer.routine is not routine for writer in writers)


def _check_timers(facts: Facts) -> Findings:
    compares = [compare for compare in facts.comparisons if compare.op in ("==", "!=") and _has_timer(compare)]
    if not compares:
        return
    running = _counting_milliseconds(facts)
    for compare in compares:
        for side, other in ((compare.left, compare.right), (compare.right, compare.left)):
            if isinstance(side, Cell) and side.address in running and not _meets(facts, side.address, other):
                yield from _report(facts, compare, side)
                break


def _report(facts: Facts, compare: Compare, timer: Cell) -> Findings:
    leaps = f"{facts.shown(timer.address)} counts milliseconds, several in each scan, and leaps over values"
    if compare.op == "==":
        fix = _fix(facts, compare, is_left=timer is compare.left)
        yield finding(CODE, compare.span, f"{leaps}: it may never be equal", "compare with >=", fix=fix)
    else:
        # < and > both differ from what is written, so neither is offered as a fix.
        yield finding(CODE, compare.span, f"{leaps}: it is nearly always different", "compare with < or >")


def _has_timer(compare: Compare) -> bool:
    return any(isinstance(side, Cell) and side.bank == "TD" for side in (compare.left, compare.right))


def _meets(facts: Facts, timer: Address, other: Single) -> bool:
    """True if equality is certain to come: at the values where a timer rests, and with a copy of the timer."""
    if isinstance(other, Integer):
        return other.value in _RESTS
    return isinstance(other, Cell) and timer in origin_registers(facts, other.address)


def _counting_milliseconds(facts: Facts) -> Mapping[Address, None]:
    """The current values of timers and time drums whose unit is the millisecond."""
    found: dict[Address, None] = {}
    for placed in facts.actions:
        owner = placed.action.owned if placed.effects.is_timed else None
        if owner is not None and (placed.action.word("unit") or UNIT.default) == "Tms":
            found[current_value(owner.address)] = None
    return found


def _fix(facts: Facts, compare: Compare, is_left: bool) -> Fix | None:
    left, right = compare.left.span, compare.right.span
    gap = Span(left.path, left.end_line, left.end_col, right.line, right.col)
    text = facts.text(gap)
    if text.strip() != compare.op:
        return None
    return Fix((Edit(gap, text.replace(compare.op, ">=" if is_left else "<=")),), is_safe=False)


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a running value is compared for equality",
    """
The current value of a timer in milliseconds grows by the length of a scan: 0, 7, 15, 22. It passes most values without
ever being equal to them, so a step that waits for `td.Cycle == 500` comes on some days and not on others. Ask `>=`
instead; with `all(td.Cycle >= 500, td.Cycle < 600)` for a window. A timer does not stop at its setpoint either. With
`!=` the same condition is on nearly all the time: ask `<` or `>`, whichever is meant.

Equality with 0 (the timer is at rest), with 32767 (it counts no further) and with a copy of the value is fine. So are
timers in seconds and longer units: they keep each value for many scans. Counters count one by one, and equality meets
every value, where it is asked in every scan: in a subroutine that is called now and then the counter may have gone on.

The fix writes `>=` for `==`. It is not safe: the condition then stays on from that value until the timer is reset,
while `==` is on for a scan at most. What must happen once needs an edge: drive a bit with `td.Cycle >= 500` and ask
`re(...)` of it.
""",
    wrong=(
        Wrong(
            """
if c.Run:
    ton(t.Cycle, setpoint=2000)
if td.Cycle == 500:  # <-
    set(c.Half)
if all(c.Run, ds.Wait == td.Cycle, 900 != td.Cycle):  # <-  # <-
    set(c.Late)
""",
            """
if c.Run:
    ton(t.Cycle, setpoint=2000)
if td.Cycle >= 500:  # <-
    set(c.Half)
if all(c.Run, ds.Wait <= td.Cycle, 900 != td.Cycle):  # <-  # <-
    set(c.Late)
""",
        ),
        Wrong(
            """
if c.Run:
    time_drum(
        outputs=[y.A],
        presets=[200, 300],
        pattern=[[1], [0]],
        current_step=ds.Step,
        accumulator=td.Passed,
        completion_flag=c.Done,
        reset=lambda: c.Clear,
    )
if td.Passed == 150:  # <-
    set(c.Close)
""",
            """
if c.Run:
    time_drum(
        outputs=[y.A],
        presets=[200, 300],
        pattern=[[1], [0]],
        current_step=ds.Step,
        accumulator=td.Passed,
        completion_flag=c.Done,
        reset=lambda: c.Clear,
    )
if td.Passed >= 150:  # <-
    set(c.Close)
""",
        ),
    ),
    right=(
        """
if c.Run:
    ton(t.Cycle, setpoint=2000)
if all(td.Cycle >= 500, td.Cycle < 600):
    set(c.Half)
if any(td.Cycle == 0, td.Cycle != 0, td.Cycle):
    set(c.Seen)
if td.Cycle != ds.Shown:
    copy(td.Cycle, ds.Shown)
""",
        """
if c.Run:
    ton(t.Cycle, setpoint=90, unit=Ts)
if td.Cycle == 30:
    out(y.Horn)
""",
        """
if re(x.Part):
    ctu(ct.Parts, setpoint=12).reset(c.NewBox)
if ctd.Parts == 6:
    out(y.Divider)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
