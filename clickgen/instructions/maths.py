"""Mathematics: calc and math_hex (click-facts [math.destinations])."""

from __future__ import annotations

from clickgen.instructions.effects import MATH_FLAGS, Effects, Move, Shape
from clickgen.instructions.spec import ONESHOT, Access, Param, ParamKind, Slot, Spec, Variant

_EFFECTS = Effects(moves=Move("formula", "destination", Shape.FORMULA), flags=MATH_FLAGS, needs_power=True)


def _formula(is_hex: bool) -> Param:
    return Param("formula", ParamKind.FORMULA, is_hex=is_hex)


def _destination(*banks: str) -> Param:
    return Param("destination", slot=Slot(cells=banks, access=Access.WRITE), aliases=("result_destination",))


# click-facts [math.float, math.overflow]
CALC = Spec(
    name="calc",
    params=(_formula(is_hex=False), _destination("DS", "TD", "SD", "DD", "CTD", "DF"), ONESHOT),
    variants=(Variant("math({formula},{destination},mode=decimal{oneshot})"),),
    summary="Decimal mathematics; a result too large for the destination wraps around.",
    example='calc("ds.Raw * 100 / 4095", df.Percent)',
    effects=_EFFECTS,
)
MATH_HEX = Spec(
    name="math_hex",
    params=(_formula(is_hex=True), _destination("DH"), ONESHOT),
    variants=(Variant("math({formula},{destination},mode=hex{oneshot})"),),
    summary="Hexadecimal mathematics and bit operations on 16-bit words.",
    example='math_hex("dh.Inputs AND 0x00FF", dh.LowByte)',
    effects=_EFFECTS,
)

SPECS = (CALC, MATH_HEX)
