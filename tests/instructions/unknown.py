"""Instructions that no file of clickgen knows. CLICK has none of them: they show that a Spec is all that is needed."""

from __future__ import annotations

from clickgen.instructions.effects import Drive, Drives, Effects, Flow, Keeps, Move, Shape
from clickgen.instructions.spec import INTEGER, ONESHOT, Access, Param, ParamKind, Slot, Spec, Variant

_CLEARED = ("Y", "C", "DS", "DD", "DH", "DF", "TD", "CTD", "TXT")

CLEAR = Spec(
    name="clear",
    params=(Param("range", slot=Slot(cells=_CLEARED, ranges=_CLEARED, access=Access.WRITE)), ONESHOT),
    variants=(Variant("zero({range}{oneshot})"),),
    summary="Put 0 into every address of a range.",
    example="clear(ds[101:111])",
    effects=Effects(moves=Move("", "range", Shape.FILL, value=0), needs_power=True),
)
"""It has no source: what it writes, its effects alone say."""

HOLD = Spec(
    name="hold",
    params=(
        Param("coil", slot=Slot(cells=("Y", "C"), access=Access.WRITE)),
        Param("release", ParamKind.PIN, pin=".release()"),
    ),
    variants=(Variant("hold({coil})"),),
    summary="Drive a bit by two inputs.",
    example="hold(c.Held, release=lambda: c.Free)",
    height=2,
    effects=Effects(Drive("coil", Drives.POWER), keeps=frozenset((Keeps.BITS,)), reset_by="release"),
)
"""A box with an input that acts while its rung is off."""

PULSE = Spec(
    name="pulse",
    params=(
        Param("owner", slot=Slot(cells=("T",), access=Access.OWN)),
        Param("setpoint", slot=Slot(cells=("DS",), constants=(INTEGER,), limits=(0, 32767)), by_name=True),
    ),
    variants=(Variant("pulse_timer({owner},{owner_value},preset={setpoint})"),),
    summary="Keep a timer's bit on for a time.",
    example="pulse(t.Pulse, setpoint=500)",
    height=2,
    effects=Effects(keeps=frozenset((Keeps.TIME,)), done=False),
)
"""A timer whose number is no ``timer`` among its parameters."""

HALT = Spec(
    name="halt",
    params=(),
    variants=(Variant("halt()"),),
    summary="End the scan where it is.",
    example="halt()",
    alone=True,
    effects=Effects(flow=Flow.END, needs_power=True),
)

PUZZLE = Spec(
    name="puzzle",
    params=(
        Param("given", slot=Slot(cells=("DS",))),
        Param("answer", slot=Slot(cells=("DS",), access=Access.WRITE)),
    ),
    variants=(Variant("puzzle({given},{answer})"),),
    summary="Nobody says what it does.",
    example="puzzle(ds.Given, ds.Answer)",
)
"""It declares no effects."""

UNKNOWN = (CLEAR, HOLD, PULSE, HALT, PUZZLE)
