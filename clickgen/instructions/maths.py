"""Mathematics: calc and math_hex (click-facts [math.destinations])."""

from __future__ import annotations

from clickgen.instructions.spec import MATH_FLAGS, ONESHOT, Access, Param, ParamKind, Slot, Spec, Variant

_FORMULA = Param("formula", ParamKind.FORMULA)


def _destination(*banks: str) -> Param:
    return Param("destination", slot=Slot(cells=banks, access=Access.WRITE), aliases=("result_destination",))


# click-facts [math.float, math.overflow]
CALC = Spec(
    name="calc",
    params=(_FORMULA, _destination("DS", "TD", "SD", "DD", "CTD", "DF"), ONESHOT),
    variants=(Variant("math({formula},{destination},mode=decimal{oneshot})"),),
    summary="Decimal mathematics; a result too large for the destination wraps around.",
    example='calc("ds.Raw * 100 / 4095", df.Percent)',
    sets_flags=MATH_FLAGS,
)
MATH_HEX = Spec(
    name="math_hex",
    params=(_FORMULA, _destination("DH"), ONESHOT),
    variants=(Variant("math({formula},{destination},mode=hex{oneshot})"),),
    summary="Hexadecimal mathematics and bit operations on 16-bit words.",
    example='math_hex("dh.Inputs AND 0x00FF", dh.LowByte)',
    sets_flags=MATH_FLAGS,
)

SPECS = (CALC, MATH_HEX)
