"""Timers: ton, tof, rton, rtof (click-facts [timer.no-rtof, timer.setpoint])."""

from __future__ import annotations

from clickgen.instructions.effects import Effects, Keeps
from clickgen.instructions.spec import INTEGER, Access, Param, ParamKind, Slot, Spec, Variant

UNITS = ("Tms", "Ts", "Tm", "Th", "Td")
PRESET_MAX = 32767

_TIMER = Param("timer", slot=Slot(cells=("T",), access=Access.OWN))
_SETPOINT = Param("setpoint", slot=Slot(cells=("DS",), constants=(INTEGER,), limits=(0, PRESET_MAX)), by_name=True)
UNIT = Param("unit", ParamKind.UNIT, default="Tms")
_RESET = Param("reset", ParamKind.PIN, pin=".reset()")
_ARGUMENTS = "({timer},{timer_value},preset={setpoint},unit={unit})"


def _delays(done: bool, reset_by: str = "") -> Effects:
    return Effects(keeps=frozenset((Keeps.TIME,)), done=done, reset_by=reset_by)


# click-facts [timer.on-delay]
TON = Spec(
    name="ton",
    params=(_TIMER, _SETPOINT, UNIT),
    variants=(Variant("on_delay" + _ARGUMENTS),),
    summary="On-delay timer: its bit comes on when the rung has been true for the setpoint.",
    example="ton(t.StartDelay, setpoint=5, unit=Ts)",
    height=2,
    effects=_delays(done=True),
)
# click-facts [timer.off-delay]
TOF = Spec(
    name="tof",
    params=(_TIMER, _SETPOINT, UNIT),
    variants=(Variant("off_delay" + _ARGUMENTS),),
    summary="Off-delay timer: its bit goes off when the rung has been false for the setpoint.",
    example="tof(t.RunOn, setpoint=3, unit=Ts)",
    height=2,
    effects=_delays(done=False),
)
# click-facts [timer.retentive]
RTON = Spec(
    name="rton",
    params=(_TIMER, _SETPOINT, UNIT, _RESET),
    variants=(Variant("on_delay" + _ARGUMENTS),),
    summary="Retentive on-delay timer: adds up the time the rung is true until it is reset.",
    example="rton(t.RunHours, setpoint=100, unit=Th, reset=lambda: c.Serviced)",
    height=2,
    effects=_delays(done=True, reset_by="reset"),
    # click-facts [grid.retentive-enable]
    bare_enable=True,
)
RTOF = Spec(
    name="rtof",
    params=(_TIMER, _SETPOINT, UNIT, _RESET),
    variants=(Variant("on_delay" + _ARGUMENTS),),
    summary="Retentive off-delay timer: adds up the time the rung is false until it is reset.",
    example="rtof(t.Idle, setpoint=30, unit=Tm, reset=lambda: c.Awake)",
    height=2,
    effects=_delays(done=False, reset_by="reset"),
    built_from=RTON,
    notes=("CLICK has no such timer: it is built from a retentive on-delay timer and two scratch bits.",),
)

SPECS = (TON, TOF, RTON, RTOF)
