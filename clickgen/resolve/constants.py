"""The type of a constant: the other operand decides whether ``5`` is an integer or ``0005h``."""

from __future__ import annotations

import re

from clickgen.device.banks import BANKS, Kind
from clickgen.ir.operands import Cell, Hex, Immediate, Integer, Named, Pointer, Range, Real, Single, Text

_HEX_TEXT = re.compile(r"([0-9A-Fa-f]{1,8})[hH]")


def kind_of(operand: object) -> Kind | None:
    """The kind of an address's content; None for a constant."""
    if isinstance(operand, Named | Cell | Range | Pointer | Immediate):
        return BANKS[operand.bank].kind
    return None


def typed(constant: Single, kind: Kind | None) -> Single:
    """Return a constant in the form that a value of this kind takes; others are unchanged.

    click-facts [token.constants]
    """
    if isinstance(constant, Text) and kind is not Kind.TEXT:
        match = _HEX_TEXT.fullmatch(constant.value)
        if match:
            return Hex(int(match[1], 16), constant.span)
    if isinstance(constant, Integer) and kind is Kind.HEX and constant.value >= 0:
        return Hex(constant.value, constant.span)
    return constant


def stored(constant: Single, kind: Kind | None) -> Single:
    """Return a constant in the form that a register of this kind holds (click-facts [copy.fill, value.integers])."""
    if isinstance(constant, Real) and kind in (Kind.INT16, Kind.INT32, Kind.HEX) and constant.value.is_integer():
        constant = Integer(int(constant.value), constant.span)
    constant = typed(constant, kind)
    if isinstance(constant, Hex) and kind in (Kind.INT16, Kind.INT32, Kind.FLOAT):
        return Integer(constant.value, constant.span)
    return constant
