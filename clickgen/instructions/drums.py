"""Drum sequencers: event_drum, time_drum (click-facts [drum.inputs, drum.lists, drum.registers])."""

from __future__ import annotations

from clickgen.instructions.effects import Drive, Drives, Effects, Keeps
from clickgen.instructions.spec import BITS, INTEGER, Access, Param, ParamKind, Slot, Spec, Variant
from clickgen.instructions.timers import PRESET_MAX, UNIT

STEPS_MAX = 16
OUTPUTS_MAX = 16

_OUTPUTS = Param("outputs", ParamKind.OPERANDS, slot=Slot(cells=("Y", "C"), access=Access.WRITE), by_name=True)
_EVENTS = Param("events", ParamKind.OPERANDS, slot=Slot(cells=BITS), by_name=True)
# click-facts [drum.presets]
_PRESETS = Param(
    "presets",
    ParamKind.OPERANDS,
    slot=Slot(cells=("DS",), constants=(INTEGER,), limits=(0, PRESET_MAX), disputed=("DS",)),
    by_name=True,
)
_PATTERN = Param("pattern", ParamKind.PATTERN, by_name=True)
_CURRENT_STEP = Param("current_step", slot=Slot(cells=("DS",), access=Access.WRITE), by_name=True)
_ACCUMULATOR = Param("accumulator", slot=Slot(cells=("TD",), access=Access.OWN), by_name=True)
_COMPLETION_FLAG = Param("completion_flag", slot=Slot(cells=("C",), access=Access.WRITE), by_name=True)
_RESET = Param("reset", ParamKind.PIN, pin=".reset()")
_JUMP = Param("jump", ParamKind.PIN, default=None, pin=".jump({jump_step})")
_JUMP_STEP = Param(
    "jump_step",
    slot=Slot(cells=("DS",), constants=(INTEGER,), limits=(1, STEPS_MAX)),
    default=None,
    chained="step",
    of_pin="jump",
    by_name=True,
)
_JOG = Param("jog", ParamKind.PIN, default=None, pin=".jog()")
_PINS = (_RESET, _JUMP, _JUMP_STEP, _JOG)

_NOTES = (
    f"A drum has 1 to {STEPS_MAX} steps and 1 to {OUTPUTS_MAX} outputs.",
    "`pattern` has one row for each step and in it one 0 or 1 for each output.",
    "An output or an event is one bit; a slice in the list stands for its bits: `outputs=[y[1:5], c.Lamp]`.",
    "CLICK jumps to the step that a DS register holds: a constant step is copied to a scratch register before.",
)


def _sequences(*keeps: Keeps) -> Effects:
    drive, reports = Drive("outputs", Drives.STEP), ("current_step", "completion_flag")
    return Effects(drive, keeps=frozenset((Keeps.STEP, *keeps)), reset_by="reset", reports=reports)


# click-facts [drum.work]
EVENT_DRUM = Spec(
    name="event_drum",
    params=(_OUTPUTS, _EVENTS, _PATTERN, _CURRENT_STEP, _COMPLETION_FLAG, *_PINS),
    variants=(
        Variant(
            "event_drum(outputs=[{outputs}],events=[{events}],pattern=[{pattern}],"
            "current_step={current_step},completion_flag={completion_flag})"
        ),
    ),
    summary="Drum sequencer: each step drives its row of the pattern until its event comes.",
    example="event_drum(outputs=[y.Fill, y.Mix], events=[x.Full, x.Mixed], pattern=[[1, 0], [0, 1]], "
    "current_step=ds.Step, completion_flag=c.Done, reset=lambda: c.Restart, "
    "jump=lambda: c.Skip, jump_step=2, jog=lambda: c.Next)",
    height=4,
    effects=_sequences(),
    notes=_NOTES,
)
TIME_DRUM = Spec(
    name="time_drum",
    params=(_OUTPUTS, _PRESETS, UNIT, _PATTERN, _CURRENT_STEP, _ACCUMULATOR, _COMPLETION_FLAG, *_PINS),
    variants=(
        Variant(
            "time_drum(outputs=[{outputs}],presets=[{presets}],unit={unit},pattern=[{pattern}],"
            "current_step={current_step},accumulator={accumulator},completion_flag={completion_flag})"
        ),
    ),
    summary="Drum sequencer: each step drives its row of the pattern for its time.",
    example="time_drum(outputs=[y.Fill, y.Mix], presets=[20, 45], unit=Ts, pattern=[[1, 0], [0, 1]], "
    "current_step=ds.Step, accumulator=td.Elapsed, completion_flag=c.Done, "
    "reset=lambda: c.Restart, jump=lambda: c.Skip, jump_step=2, jog=lambda: c.Next)",
    height=4,
    effects=_sequences(Keeps.TIME),
    notes=(
        *_NOTES,
        "The accumulator belongs to the drum alone: no timer may have its number.",
    ),
)

SPECS = (EVENT_DRUM, TIME_DRUM)
