"""Hints for a setpoint that CLICK does not take, in a unit in which it does: 5.5 seconds are 5500 ms."""

from __future__ import annotations

import re
from fractions import Fraction

from clickgen.device.elsewhere import UNITS
from clickgen.dialects.base import Spelling
from clickgen.instructions.durations import in_units
from clickgen.instructions.spec import Param, ParamKind
from clickgen.ir.operands import Constant, Integer, Real, Text
from clickgen.ir.program import Action

_TIME = re.compile(r"(?:T(?:IME)?#)?\s*([0-9]{1,9}(?:\.[0-9]{1,9})?)\s*([A-Za-z]{1,12})", re.IGNORECASE)


def setpoint_hint(spell: Spelling, action: Action, param: Param, constant: Constant) -> str:
    """The way out for a setpoint that is a fraction, too great, or a text such as ``"5s"``; "" for any other."""
    if param.name != "setpoint":
        return ""
    has_unit = any(other.kind is ParamKind.UNIT for other in action.spec.params)
    if not has_unit:
        return f"a counter counts whole numbers: {spell.setting('setpoint', '5')}" if isinstance(constant, Real) else ""
    if isinstance(constant, Text):
        match = _TIME.fullmatch(constant.value)
        unit = UNITS.get(match[2].lower(), "") if match else ""
        return in_units(Fraction(match[1]), unit, spell.setting) if match and unit else ""
    if not isinstance(constant, Integer | Real) or constant.value < 0:
        return ""
    unit = action.word("unit") if "unit" in action.args else "Tms"
    value = Fraction(constant.value) if isinstance(constant, Integer) else Fraction(constant.text)
    if isinstance(constant, Real) and "unit" not in action.args:
        seconds = in_units(value, "Ts", spell.setting)
        return f"a setpoint is a whole number of its unit; for {constant.text} seconds {seconds}" if seconds else ""
    return in_units(value, unit, spell.setting)
