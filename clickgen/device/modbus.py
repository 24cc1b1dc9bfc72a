"""What Modbus has: register types, their numbers, and how much goes into one request (the Modbus protocol, and the
codec where CLICK's own reading of it counts)."""

from __future__ import annotations

COIL, DISCRETE_INPUT, HOLDING, INPUT = "coil", "discrete_input", "holding", "input"
REGISTER_TYPES = (COIL, DISCRETE_INPUT, HOLDING, INPUT)
"""By the names that laddercodec has for them."""

TYPE_WORDS = {
    COIL: "a coil",
    DISCRETE_INPUT: "a discrete input",
    INPUT: "an input register",
    HOLDING: "a holding register",
}

BIT_TYPES = (COIL, DISCRETE_INPUT)
READ_ONLY_TYPES = (DISCRETE_INPUT, INPUT)

NUMBERS_984 = {
    COIL: (1, 65536),
    DISCRETE_INPUT: (100001, 165536),
    INPUT: (300001, 365536),
    HOLDING: (400001, 465536),
}
"""The 984 numbers of each register type; laddercodec divides them in the same places."""

_MANUAL_TYPES = {1: DISCRETE_INPUT, 3: INPUT, 4: HOLDING}
"""The first of the five digits that manuals print, and what it stands for; CLICK has six digits for the same."""

CLICK_COILS = range(16385, 18385)
"""The coils C1 to C2000 of another CLICK (export of CLICK PLUS 3.41), the only ones between 10001 and 49999."""

HEX_MAX = 0xFFFF
PORT_MAX = 65535
TCP_DEVICE_MAX = 255
"""One byte stands for a device in the network."""
RTU_DEVICE_MAX = 247
"""Devices on one serial line; 0 is all of them at once."""

BITS_WRITTEN_MAX, BITS_READ_MAX = 1968, 2000
WORDS_WRITTEN_MAX, WORDS_READ_MAX = 123, 125
"""The most that one request moves (function codes 15, 1, 16 and 3)."""


def register_type_of(number: int) -> str | None:
    """The register type of a 984 number, or None when there is no such number."""
    return next((name for name, (low, high) in NUMBERS_984.items() if low <= number <= high), None)


def of_manual(number: int) -> tuple[str, int] | None:
    """The register type and the six digits of a number as manuals print it: 42332 is the holding register 402332.

    None for a number that a manual does not print with five digits, or that is a coil of a CLICK.
    """
    first, rest = divmod(number, 10000)
    name = _MANUAL_TYPES.get(first)
    return (name, first * 100000 + rest) if name and rest and number not in CLICK_COILS else None
