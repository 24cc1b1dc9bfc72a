"""Counters: ctu, ctd, ctud (click-facts [counter.forms, counter.setpoint])."""

from __future__ import annotations

from clickgen.device.banks import INTEGER_RANGES, Kind
from clickgen.instructions.effects import Effects, Keeps
from clickgen.instructions.spec import INTEGER, Access, Param, ParamKind, Slot, Spec, Variant

_COUNTER = Param("counter", slot=Slot(cells=("CT",), access=Access.OWN))
_SETPOINT = Param(
    "setpoint",
    slot=Slot(cells=("DS", "DD"), constants=(INTEGER,), limits=INTEGER_RANGES[Kind.INT32]),
    by_name=True,
)
_RESET = Param("reset", ParamKind.PIN, default=None, pin=".reset()", missing_pin="CG418")
_DOWN = Param("count_down", ParamKind.PIN, pin=".down()", chained="down")
# click-facts [counter.edges]
_EDGE = "Sources disagree whether a counter counts every scan in which its rung is true, or edges: count `re(...)`."
_EFFECTS = Effects(keeps=frozenset((Keeps.COUNT,)), done=True, reset_by="reset")
_ARGUMENTS = "({counter},{counter_value},preset={setpoint})"

# click-facts [counter.limits]
CTU = Spec(
    name="ctu",
    params=(_COUNTER, _SETPOINT, _RESET),
    variants=(Variant("count_up" + _ARGUMENTS),),
    summary="Count up; the counter bit is on from the setpoint upward.",
    example="ctu(ct.Parts, setpoint=100, reset=lambda: c.NewBatch)",
    height=3,
    effects=_EFFECTS,
    notes=(_EDGE,),
)
CTD = Spec(
    name="ctd",
    params=(_COUNTER, _SETPOINT, _RESET),
    variants=(Variant("count_down" + _ARGUMENTS),),
    summary="Count down.",
    example="ctd(ct.Left, setpoint=50, reset=lambda: c.Refilled)",
    height=3,
    effects=_EFFECTS,
    own_row=1,  # click-facts [grid.down-counter]
    notes=(
        _EDGE,
        # click-facts [counter.count-down]
        "Sources disagree about counting down: from a preloaded value to the setpoint, or from 0 to its negative.",
    ),
)
CTUD = Spec(
    name="ctud",
    params=(_COUNTER, _SETPOINT, _DOWN, _RESET),
    variants=(Variant("count_up" + _ARGUMENTS),),
    summary="Count up on the rung and down on a second input.",
    example="ctud(ct.Level, setpoint=50, count_down=lambda: re(c.Taken), reset=lambda: c.Empty)",
    height=3,
    effects=_EFFECTS,
    notes=(_EDGE,),
)

SPECS = (CTU, CTD, CTUD)
