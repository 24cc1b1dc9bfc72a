"""Program control: call, the for loop, end, return, NOP."""

from __future__ import annotations

from clickgen.instructions.effects import Effects, Flow
from clickgen.instructions.spec import INTEGER, ONESHOT, Param, ParamKind, Slot, Spec, Variant

# click-facts [control.call]
CALL = Spec(
    name="call",
    params=(Param("subroutine", ParamKind.ROUTINE, aliases=("subroutine_name",)),),
    variants=(Variant('call("{subroutine}")'),),
    summary="Run a subroutine.",
    example="call(auto_mode)",
    effects=Effects(flow=Flow.CALL, needs_power=True),
)
# click-facts [control.return]
RETURN = Spec(
    name="return",
    params=(),
    variants=(Variant("return()"),),
    summary="Go back from a subroutine to main.",
    example="return",
    effects=Effects(flow=Flow.RETURN, needs_power=True),
)
# click-facts [control.end]
END = Spec(
    name="end",
    params=(),
    variants=(Variant("end()"),),
    summary="End the scan of the program.",
    example="end()",
    alone=True,
    effects=Effects(flow=Flow.END, needs_power=True),
)
# click-facts [control.for, control.for-count]
FOR = Spec(
    name="for",
    params=(Param("count", slot=Slot(cells=("DS",), constants=(INTEGER,), limits=(1, 32767))), ONESHOT),
    variants=(Variant("for({count}{oneshot})"),),
    summary="Run the rungs up to next_loop() several times in one scan.",
    example="for _ in range(ds.Count): pass",
    alone=True,
    # click-facts [control.for-off]
    effects=Effects(flow=Flow.LOOP),
)
# click-facts [control.next]
NEXT = Spec(
    name="next_loop",
    params=(),
    variants=(Variant("next()"),),
    summary="Close the loop that a for opened.",
    example="next_loop()",
    alone=True,
    effects=Effects(flow=Flow.NEXT, needs_power=True),
)
# click-facts [grid.nop]
NOP = Spec(
    name="pass",
    params=(),
    variants=(Variant("NOP"),),
    summary="Do nothing: keeps a rung without outputs legal (C0003).",
    example="pass",
    effects=Effects(flow=Flow.PASS, needs_power=True),
)

SPECS = (CALL, END, NEXT)
SYNTAX = (RETURN, FOR, NOP)
"""The instructions that are not written as calls: ``return``, ``for`` and ``pass``."""
