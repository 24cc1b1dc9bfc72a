"""Classes of values and ranges of constants, for the rules about operands."""

from __future__ import annotations

from clickgen.device.banks import Kind
from clickgen.ir.operands import CharCode, Hex, Integer, Operand, Real, Text
from clickgen.resolve.constants import kind_of

_CLASSES = {
    Kind.INT16: "decimal",
    Kind.INT32: "decimal",
    Kind.FLOAT: "decimal",
    Kind.HEX: "hexadecimal",
    Kind.TEXT: "text",
    Kind.BIT: "bit",
}
_RANGES = {Kind.INT16: (-32768, 32767), Kind.INT32: (-(2**31), 2**31 - 1)}
_FLOAT_MAX = 3.4028235e38
_FLOAT_MIN = 1.1754944e-38


def value_class(operand: Operand) -> str:
    """``decimal``, ``hexadecimal``, ``text`` or ``bit``."""
    kind = kind_of(operand)
    if kind is not None:
        return _CLASSES[kind]
    if isinstance(operand, Hex):
        return "hexadecimal"
    return "text" if isinstance(operand, Text | CharCode) else "decimal"


def constant_fault(constant: Operand, kind: Kind | None) -> str:
    """What is wrong with a constant that a value of this kind is to take; "" when nothing is, or it is no constant."""
    if isinstance(constant, Real) and kind in (Kind.INT16, Kind.INT32, Kind.HEX) and not constant.value.is_integer():
        return f"{constant.text} loses its fraction in a whole number"
    return range_fault(constant, kind)


def range_fault(constant: Operand, kind: Kind | None) -> str:
    """The same for a constant that is only compared with a value of this kind."""
    if isinstance(constant, Integer):
        if kind in _RANGES:
            low, high = _RANGES[kind]
            if not low <= constant.value <= high:
                return f"{constant.value} is outside {low}..{high}"
        elif kind is Kind.HEX:
            return f"{constant.value} is negative; a hexadecimal word holds 0..FFFFh"
        elif not -(2**31) <= constant.value < 2**31:
            return f"{constant.value} is outside -2147483648..2147483647"
    if isinstance(constant, Hex) and constant.value > 0xFFFF:
        return f"{constant.value:X}h is outside 0000h..FFFFh"
    if isinstance(constant, Real) and not -_FLOAT_MAX <= constant.value <= _FLOAT_MAX:
        return f"{constant.text} is outside -3.4028235E+38..3.4028235E+38"
    if isinstance(constant, Real) and 0 < abs(constant.value) < _FLOAT_MIN:
        return f"{constant.text} is closer to 0 than a floating-point register can hold"
    if isinstance(constant, Text):
        if not constant.value:
            return "the text is empty"
        if not constant.value.isascii() or not constant.value.isprintable():
            return "TXT addresses hold printable ASCII characters"
    if isinstance(constant, CharCode) and constant.value > 0x7F:
        return f"${constant.value:02X} is outside $00..$7F"
    return ""
