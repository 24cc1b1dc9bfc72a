"""A timer that delays nothing although something looks at its bit: its setpoint is the constant 0."""

from __future__ import annotations

from clickgen.device.banks import current_value
from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Effects
from clickgen.ir.operands import Integer, Single
from clickgen.ir.program import Operands, Pattern
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG512"


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        setpoint = placed.action.args.get("setpoint")
        if not placed.effects.is_timed:
            continue
        if isinstance(setpoint, Integer) and setpoint.value == 0:
            timer = placed.action.owned
            reads = facts.uses.reads(timer.address) if timer is not None else []
            # A stopwatch has no setpoint either: its current value is what counts.
            if reads and timer is not None:
                fault = f"the setpoint of {facts.shown(timer.address)} is 0: {_what_happens(placed.effects)}"
                value = facts.spell.cell(current_value(timer.address))
                help = f"give it a time; to measure a time, compare its current value {value} and leave the bit alone"
                yield finding(CODE, setpoint.span, fault, help, (Label(reads[0].operand.span, "its bit is used here"),))
        else:
            for step, preset in _empty_steps(placed):
                yield finding(
                    CODE,
                    preset.span,
                    f"step {step} of this drum lasts 0: its outputs are not on for longer than a scan",
                    "give it a time, or leave the step out",
                )


def _what_happens(effects: Effects) -> str:
    if not effects.reset_by:
        return "its bit follows the rung at once"
    return (
        f"its bit {'comes on at once and stays' if effects.done else 'goes off at once and stays so'} until the reset"
    )


def _empty_steps(placed: Placed) -> list[tuple[int, Single]]:
    """The steps that take no time but drive an output."""
    presets, pattern = placed.action.args.get("presets"), placed.action.args.get("pattern")
    if not (isinstance(presets, Operands) and isinstance(pattern, Pattern)):
        return []
    return [
        (step, preset)
        for step, (preset, row) in enumerate(zip(presets.items, pattern.rows, strict=False), 1)
        if isinstance(preset, Integer) and preset.value == 0 and any(row)
    ]


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a timer's setpoint is 0",
    """
A timer with the setpoint 0 delays nothing: whoever reads `t.Delay` believes that something waits. It is mostly a number
that was to be filled in later. Where the time is set on a panel, name the register: `setpoint=ds.Delay`; a register may
be 0.

The rule speaks only where the program uses the timer's bit. A timer with the setpoint 0 whose bit nobody uses is a
stopwatch: its current value keeps counting past the setpoint, and a comparison or a panel reads that.

A step of a time drum that lasts 0 and drives an output does not keep it on for longer than a scan. A step of 0 that
drives nothing is left alone: that is how a step is taken out without renumbering the others.
""",
    wrong=(
        Wrong(
            """
if x.Door:
    ton(t.DoorOpen, setpoint=0, unit=Ts)  # <-
    tof(t.Light, 0)  # <-

if t.DoorOpen:
    out(y.Horn)

if t.Light:
    out(y.Lamp)
"""
        ),
        Wrong(
            """
if c.Run:
    time_drum(
        outputs=[y.A, y.B],
        presets=[20, 0],  # <-
        unit=Ts,
        pattern=[[1, 0], [0, 1]],
        current_step=ds.Step,
        accumulator=td.Passed,
        completion_flag=c.Done,
        reset=lambda: c.Clear,
    )
"""
        ),
    ),
    right=(
        """
if x.Door:
    ton(t.DoorOpen, setpoint=30, unit=Ts)
    tof(t.Light, ds.LightTime)

if all(t.DoorOpen, t.Light):
    out(y.Lamp)
""",
        """
if y.Motor:
    ton(t.Running, setpoint=0, unit=Ts)

if td.Running > 30:
    out(y.Lamp)
""",
        """
if c.Run:
    time_drum(
        outputs=[y.A, y.B],
        presets=[20, 0, 5],
        unit=Ts,
        pattern=[[1, 0], [0, 0], [0, 1]],
        current_step=ds.Step,
        accumulator=td.Passed,
        completion_flag=c.Done,
        reset=lambda: c.Clear,
    )
""",
        """
if re(x.Part):
    ctud(ct.Stock, setpoint=0).down(re(x.Taken)).reset(c.Clear)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
