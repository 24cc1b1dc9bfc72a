"""Classes of values and ranges of constants, for the rules about operands."""

from __future__ import annotations

from collections.abc import Callable

from clickgen.device.banks import FLOAT_MAX, FLOAT_MIN, INTEGER_RANGES, VALUE_CLASSES, Kind
from clickgen.dialects.base import Spelling
from clickgen.instructions.offered import COPY
from clickgen.instructions.spec import Spec
from clickgen.ir.operands import CharCode, Hex, Integer, Operand, Real, Text, form_of
from clickgen.resolve.constants import kind_of


def value_class(operand: Operand) -> str:
    """``decimal``, ``hexadecimal``, ``text`` or ``bit``."""
    kind = kind_of(operand)
    if kind is not None:
        return VALUE_CLASSES[kind]
    if isinstance(operand, Hex):
        return "hexadecimal"
    return "text" if isinstance(operand, Text | CharCode) else "decimal"


def constant_fault(constant: Operand, kind: Kind | None) -> str:
    """The fault of a constant for a value of this kind; "" if it has none, or is not a constant."""
    if isinstance(constant, Real) and kind in (Kind.INT16, Kind.INT32, Kind.HEX) and not constant.value.is_integer():
        return f"{constant.text} loses its fraction in a whole number"
    return range_fault(constant, kind)


def range_fault(constant: Operand, kind: Kind | None) -> str:
    """The same for a constant that is only compared with a value of this kind."""
    if isinstance(constant, Integer):
        if kind is Kind.HEX:
            return f"{constant.value} is negative; a hexadecimal word holds 0..FFFFh"
        low, high = INTEGER_RANGES[kind if kind in INTEGER_RANGES else Kind.INT32]
        if not low <= constant.value <= high:
            return f"{constant.value} is outside {low}..{high}"
    if isinstance(constant, Hex) and constant.value > 0xFFFF:
        return f"{constant.value:X}h is outside 0000h..FFFFh"
    if isinstance(constant, Real) and not -FLOAT_MAX <= constant.value <= FLOAT_MAX:
        return f"{constant.text} is outside -3.4028235E+38..3.4028235E+38"
    if isinstance(constant, Real) and 0 < abs(constant.value) < FLOAT_MIN:
        return f"{constant.text} is closer to 0 than a floating-point register can hold"
    if isinstance(constant, Text):
        if not constant.value:
            return "the text is empty"
        if not constant.value.isascii() or not constant.value.isprintable():
            return "TXT addresses hold printable ASCII characters"
    if isinstance(constant, CharCode) and constant.value > 0x7F:
        return f"${constant.value:02X} is outside $00..$7F"
    return ""


def fitting(constant: Operand, kind: Kind | None, text: str, spell: Spelling, copied: Callable[[str], str]) -> str:
    """A constant that a value of this kind takes, or a register that takes this one.

    ``text`` is the constant as the program writes it, ``copied`` gives the action with another in its place.
    """
    if isinstance(constant, Real):
        if kind in (Kind.INT16, Kind.INT32, Kind.HEX) and abs(constant.value) <= FLOAT_MAX:
            copy = spell.call(COPY, text, spell.name("DF", "Name"))
            return f"DF holds decimals: {copy}; a whole number near it is {int(constant.value)}"
        return "DF holds -3.4028235E+38 to 3.4028235E+38, and nothing nearer to 0 than 1.1754944E-38 but 0"
    if not isinstance(constant, Integer | Hex):
        return "write a constant that fits"
    value, low, high = constant.value, *INTEGER_RANGES[Kind.INT32]
    bits = 32 if kind is Kind.INT32 else 16
    if kind is Kind.HEX and -(2**15) <= value < 0:
        return f"DH holds 0x0000 to 0xFFFF; these 16 bits are {copied(spell.hexadecimal(value + 2**16))}"
    ways = []
    is_hex = text[:2].lower() == "0x" or text.rstrip("'\"").lower().endswith("h")
    if is_hex and kind is not Kind.HEX and 2 ** (bits - 1) <= value < 2**bits:
        ways.append(f"these {bits} bits are {copied(str(value - 2**bits))}")
        if bits == 16:
            ways.append(f"DH holds them as they are: {spell.call(COPY, text, spell.name('DH', 'Name'))}")
    if bits == 16 and low <= value <= high:
        ways.append(f"DD holds {low} to {high}: {spell.call(COPY, str(value), spell.name('DD', 'Name'))}")
    elif abs(value) <= FLOAT_MAX:
        copy = spell.call(COPY, f"{value}.0", spell.name("DF", "Name"))
        ways.append(f"DF holds greater numbers, to 7 digits: {copy}")
    return "; ".join(ways) or "write a constant that fits"


def copies(spec: Spec, source: object, target: object) -> bool:
    """True if an instruction of the copy family copies from one of these to the other."""
    pairs = [pair for variant in spec.variants for pair in variant.pairs]
    return any(form_of(source) in pair.sources and form_of(target) in pair.targets for pair in pairs)
