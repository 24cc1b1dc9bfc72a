"""Modbus: register types, their numbers, and the size of one request (by the Modbus protocol, or by the codec where
CLICK reads it in its own way); and the Modbus number of each address of CLICK."""

from __future__ import annotations

from typing import NamedTuple

from clickgen.device.banks import BANKS, UPPER_BYTE_BANKS, Address
from clickgen.device.system import WRITABLE_SC, WRITABLE_SD

COIL, DISCRETE_INPUT, HOLDING, INPUT = "coil", "discrete_input", "holding", "input"
REGISTER_TYPES = (COIL, DISCRETE_INPUT, HOLDING, INPUT)
"""By laddercodec's names for them."""

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
"""The 984 numbers of each register type; laddercodec divides them at the same places
(click-facts [modbus.six-digits])."""

_MANUAL_TYPES = {1: DISCRETE_INPUT, 3: INPUT, 4: HOLDING}
"""The first of the five digits that manuals print, and its register type; CLICK has six digits for the same
(click-facts [modbus.six-digits])."""

HEX_MAX = 0xFFFF
PORT_MAX = 65535
TCP_DEVICE_MAX = 255
"""One byte identifies a device in the network."""
RTU_DEVICE_MAX = 247
"""Devices on one serial line; 0 is all of them at once (click-facts [modbus.devices])."""

BITS_WRITTEN_MAX, BITS_READ_MAX = 1968, 2000
WORDS_WRITTEN_MAX, WORDS_READ_MAX = 123, 125
"""The most that one request moves (function codes 15, 1, 16 and 3; click-facts [modbus.requests])."""


def register_type_of(number: int) -> str | None:
    """The register type of a 984 number, or None if there is no such number."""
    return next((name for name, (low, high) in NUMBERS_984.items() if low <= number <= high), None)


# -- CLICK's own addresses over Modbus --------------------------------------------------------------------------------


class ModbusNumber(NamedTuple):
    """Where a master finds an address of CLICK: the register type and the offset in it, from 0 to 0xFFFF."""

    register_type: str
    offset: int

    @property
    def decimal(self) -> str:
        """The 984 number, as CLICK shows it: ``400001``."""
        return str(NUMBERS_984[self.register_type][0] + self.offset)

    @property
    def hexadecimal(self) -> str:
        """CLICK's hexadecimal number: ``0000h``."""
        return f"{self.offset:04X}h"

    @property
    def function_code(self) -> str:
        """The function codes that read and write it, in CLICK's words."""
        return FUNCTION_CODES[self.register_type]


FUNCTION_CODES = {COIL: "FC=01,05,15", DISCRETE_INPUT: "FC=02", HOLDING: "FC=03,06,16", INPUT: "FC=04"}
"""The words of the column Function Code in a nickname export of CLICK PLUS 3.41
(click-facts [modbus.function-codes])."""


class _Place(NamedTuple):
    """The beginning of a bank, how many addresses one register takes, and how many registers one address takes."""

    register_type: str
    base: int
    registers: int = 1
    sharing: int = 1


_PLACES = {
    "X": _Place(DISCRETE_INPUT, 0x0000),
    "Y": _Place(COIL, 0x2000),
    "C": _Place(COIL, 0x4000),
    "T": _Place(DISCRETE_INPUT, 0xB000),
    "CT": _Place(DISCRETE_INPUT, 0xC000),
    "SC": _Place(DISCRETE_INPUT, 0xF000),
    "DS": _Place(HOLDING, 0x0000),
    "DD": _Place(HOLDING, 0x4000, registers=2),
    "DH": _Place(HOLDING, 0x6000),
    "DF": _Place(HOLDING, 0x7000, registers=2),
    "XD": _Place(INPUT, 0xE000, registers=2),
    "YD": _Place(HOLDING, 0xE200, registers=2),
    "TD": _Place(HOLDING, 0xB000),
    "CTD": _Place(HOLDING, 0xC000, registers=2),
    "SD": _Place(INPUT, 0xF000),
    "TXT": _Place(HOLDING, 0x9000, sharing=2),
}
"""The export of CLICK PLUS 3.41 (fixtures/click-3.41/modbus.csv), which lists every address
(click-facts [modbus.numbers, modbus.upper-words, modbus.word-order])."""

_CLICK_COILS = range(_PLACES["C"].base + 1, _PLACES["C"].base + 1 + BANKS["C"].last)
"""C1 to C2000 of another CLICK: its only coils between 10001 and 49999."""

_SLOT_POINTS = 32
"""Registers of a slot of X or Y; only 16 are points of the module, and slot 0 has two groups of 16
(click-facts [modbus.slots])."""

_WRITABLE = {
    "SC": (WRITABLE_SC - {303, 304, 305, 306, 323, 324, 325, 326}, COIL),
    "SD": (WRITABLE_SD, HOLDING),
}
"""The addresses of read-only banks that a master may write according to the export, and their type there
(click-facts [modbus.writable])."""


def modbus_number(address: Address) -> ModbusNumber:
    """The register where an address begins. Two TXT share one, the first in its low byte.

    click-facts [modbus.text]
    """
    place = _PLACES[address.bank]
    if address.bank in ("X", "Y"):
        slot, point = divmod(address.number, 100)
        offset = slot * _SLOT_POINTS + (point - 5 if point > 16 else point - 1)
    elif address.bank in UPPER_BYTE_BANKS:
        offset = address.number * place.registers + address.upper
    else:
        offset = (address.number - 1) * place.registers // place.sharing
    writable, written_as = _WRITABLE.get(address.bank, (frozenset[int](), COIL))
    register_type = written_as if address.number in writable else place.register_type
    return ModbusNumber(register_type, place.base + offset)


def of_manual(number: int) -> tuple[str, int] | None:
    """The register type and the six digits of a number as manuals print it: 42332 is the holding register 402332.

    None for a number that a manual does not print with five digits, or that is a coil of a CLICK.
    """
    first, rest = divmod(number, 10000)
    name = _MANUAL_TYPES.get(first)
    return (name, first * 100000 + rest) if name and rest and number not in _CLICK_COILS else None
