"""A time as a setpoint that CLICK takes: a whole number, 0..32767, of a unit."""

from __future__ import annotations

from fractions import Fraction

from clickgen.instructions.timers import PRESET_MAX

MILLISECONDS = {"Tms": 1, "Ts": 1000, "Tm": 60_000, "Th": 3_600_000, "Td": 86_400_000}
"""How long each unit is."""
_FAR = Fraction(10**12)


def in_units(number: Fraction, unit: str) -> str:
    """``write setpoint=5500, unit=Tms`` for 5.5 seconds: in the unit that was meant, the next smaller or a greater one.

    "" for a time that no timer reaches.
    """
    milliseconds = number * MILLISECONDS[unit]
    names = list(MILLISECONDS)
    place = names.index(unit)
    for name in [*reversed(names[: place + 1]), *names[place + 1 :]]:
        count = milliseconds / MILLISECONDS[name]
        if count.denominator == 1 and count <= PRESET_MAX:
            return f"write setpoint={count}, unit={name}"
    nearest = next((name for name in names if milliseconds / MILLISECONDS[name] <= PRESET_MAX), "")
    if not nearest or milliseconds > _FAR:
        return ""
    return f"the nearest that CLICK takes is setpoint={round(milliseconds / MILLISECONDS[nearest])}, unit={nearest}"
