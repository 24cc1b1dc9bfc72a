"""Coils: out, set, reset (click-facts [coil.immediate, coil.oneshot, coil.targets])."""

from __future__ import annotations

from clickgen.instructions.effects import Drive, Drives, Effects
from clickgen.instructions.spec import ONESHOT, Access, Param, Slot, Spec, Variant

_TARGETS = ("Y", "C", "SC")
_COIL = Param("address", slot=Slot(cells=_TARGETS, ranges=_TARGETS, immediates=("Y",), access=Access.WRITE))

OUT = Spec(
    name="out",
    params=(_COIL, ONESHOT),
    variants=(Variant("out({address}{oneshot})"),),
    summary="Drive a bit: on while the rung is true, off while it is false.",
    example="out(y.Motor)",
    effects=Effects(Drive("address", Drives.POWER)),
    notes=("A one-shot on a range becomes one coil for each bit; a one-shot immediate coil does not exist.",),
)
SET = Spec(
    name="set",
    params=(_COIL,),
    variants=(Variant("latch({address})"),),
    summary="Turn a bit on; it stays on until reset.",
    example="set(c.Running)",
    effects=Effects(Drive("address", Drives.ON), needs_power=True),
)
RESET = Spec(
    name="reset",
    params=(_COIL,),
    variants=(Variant("reset({address})"),),
    summary="Turn a bit off.",
    example="reset(c.Running)",
    effects=Effects(Drive("address", Drives.OFF), needs_power=True),
)

SPECS = (OUT, SET, RESET)
