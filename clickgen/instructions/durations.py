"""A time as a setpoint that CLICK takes: a whole number, 0..32767, of a unit."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from clickgen.instructions.timers import PRESET_MAX

MILLISECONDS = {"Tms": 1, "Ts": 1000, "Tm": 60_000, "Th": 3_600_000, "Td": 86_400_000}
"""How long each unit is."""
_FAR = Fraction(10**12)


def in_units(number: Fraction, unit: str, setting: Callable[[str, str], str] = "{}={}".format) -> str:
    """``write setpoint=5500, unit=Tms`` for 5.5 seconds: in the unit that was meant, the next smaller or a greater one.

    "" for a time that no timer reaches. ``setting`` writes an argument by its name.
    """
    milliseconds = number * MILLISECONDS[unit]
    names = list(MILLISECONDS)
    place = names.index(unit)
    for name in [*reversed(names[: place + 1]), *names[place + 1 :]]:
        exact = milliseconds / MILLISECONDS[name]
        if exact.denominator == 1 and exact <= PRESET_MAX:
            return f"write {setting('setpoint', str(exact))}, {setting('unit', name)}"
    nearest = next((name for name in names if milliseconds / MILLISECONDS[name] <= PRESET_MAX), "")
    if not nearest or milliseconds > _FAR:
        return ""
    count = round(milliseconds / MILLISECONDS[nearest])
    return f"the nearest that CLICK takes is {setting('setpoint', str(count))}, {setting('unit', nearest)}"
