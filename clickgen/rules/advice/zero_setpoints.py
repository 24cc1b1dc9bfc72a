"""A timer that delays nothing although something looks at its bit: its setpoint is the constant 0."""

from __future__ import annotations

from clickgen.facts.facts import Facts, Placed
from clickgen.instructions import drums, timers
from clickgen.ir.operands import Cell, Integer, Single
from clickgen.ir.program import Operands, Pattern
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.rules.rule import Rule, Wrong

CODE = "CG512"

_HAPPENS = {
    "ton": "its bit follows the rung at once",
    "tof": "its bit follows the rung at once",
    "rton": "its bit comes on at once and stays until the reset",
    "rtof": "its bit goes off at once and stays so until the reset",
}


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        setpoint = placed.action.args.get("setpoint")
        if placed.spec in timers.SPECS and isinstance(setpoint, Integer) and setpoint.value == 0:
            timer = placed.action.args["timer"]
            reads = facts.uses.reads(timer.address) if isinstance(timer, Cell) else []
            # A stopwatch has no setpoint either: its current value is what counts.
            if reads and isinstance(timer, Cell):
                fault = f"the setpoint of {facts.shown(timer.address)} is 0: {_HAPPENS[placed.spec.name]}"
                value = f"td[{timer.address.number}]"
                help = f"give it a time; to measure a time, compare its current value {value} and leave the bit alone"
                problems.add(CODE, setpoint.span, fault, help, (Label(reads[0].operand.span, "its bit is used here"),))
        elif placed.spec is drums.TIME_DRUM:
            for step, preset in _empty_steps(placed):
                problems.add(
                    CODE,
                    preset.span,
                    f"step {step} of this drum lasts 0: its outputs are not on for longer than a scan",
                    "give it a time, or leave the step out",
                )


def _empty_steps(placed: Placed) -> list[tuple[int, Single]]:
    """The steps that take no time but drive an output."""
    presets, pattern = placed.action.args["presets"], placed.action.args["pattern"]
    if not (isinstance(presets, Operands) and isinstance(pattern, Pattern)):
        return []
    return [
        (step, preset)
        for step, (preset, row) in enumerate(zip(presets.items, pattern.rows, strict=False), 1)
        if isinstance(preset, Integer) and preset.value == 0 and any(row)
    ]


RULE = Rule(
    CODE,
    check,
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
    holds_in_parts=True,
)
