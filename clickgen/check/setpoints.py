"""A setpoint that CLICK does not take, in a unit in which it does: 5.5 seconds are 5500 ms."""

from __future__ import annotations

import re
from fractions import Fraction

from clickgen.instructions.spec import Param, ParamKind
from clickgen.instructions.timers import PRESET_MAX
from clickgen.ir.operands import Constant, Integer, Real, Text
from clickgen.ir.program import Action
from clickgen.trade import UNITS

_MILLISECONDS = {"Tms": 1, "Ts": 1000, "Tm": 60_000, "Th": 3_600_000, "Td": 86_400_000}
"""How long each unit is."""
_TIME = re.compile(r"(?:T(?:IME)?#)?\s*([0-9]{1,9}(?:\.[0-9]{1,9})?)\s*([A-Za-z]{1,12})", re.IGNORECASE)
_FAR = Fraction(10**12)


def setpoint_hint(action: Action, param: Param, constant: Constant) -> str:
    """The way out for a setpoint that is a fraction, too great, or a text such as ``"5s"``; "" for any other."""
    if param.name != "setpoint":
        return ""
    has_unit = any(other.kind is ParamKind.UNIT for other in action.spec.params)
    if not has_unit:
        return "a counter counts whole numbers: setpoint=5" if isinstance(constant, Real) else ""
    if isinstance(constant, Text):
        match = _TIME.fullmatch(constant.value)
        unit = UNITS.get(match[2].lower(), "") if match else ""
        return _in_units(Fraction(match[1]) * _MILLISECONDS[unit], unit) if match and unit else ""
    if not isinstance(constant, Integer | Real) or constant.value < 0:
        return ""
    unit = action.word("unit") if "unit" in action.args else "Tms"
    value = Fraction(constant.value) if isinstance(constant, Integer) else Fraction(constant.text)
    if isinstance(constant, Real) and "unit" not in action.args:
        seconds = _in_units(value * 1000, "Ts")
        return f"a setpoint is a whole number of its unit; for {constant.text} seconds {seconds}" if seconds else ""
    return _in_units(value * _MILLISECONDS[unit], unit)


def _in_units(milliseconds: Fraction, unit: str) -> str:
    """``write setpoint=5500, unit=Tms``: the unit that was meant or the next smaller one, else the next greater."""
    if milliseconds > _FAR:
        return ""
    names = list(_MILLISECONDS)
    place = names.index(unit)
    for name in [*reversed(names[: place + 1]), *names[place + 1 :]]:
        count = milliseconds / _MILLISECONDS[name]
        if count.denominator == 1 and count <= PRESET_MAX:
            return f"write setpoint={count}, unit={name}"
    nearest = next((name for name in names if milliseconds / _MILLISECONDS[name] <= PRESET_MAX), "")
    rounded = round(milliseconds / _MILLISECONDS[nearest]) if nearest else 0
    return f"the nearest that CLICK takes is setpoint={rounded}, unit={nearest}" if nearest else ""
