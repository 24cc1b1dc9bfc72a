"""Functions for subroutines: a name that Python takes for each name that CLICK has."""

from __future__ import annotations

import builtins
import keyword
import re
from collections.abc import Collection
from itertools import count
from types import BuiltinFunctionType

from clickgen.device.banks import BANKS
from clickgen.dialects.if_rungs.read.conditions import FUNCTIONS
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.timers import UNITS

_OTHERS = ("main", "nickname", "range", "sub", "ModbusAddress", "ModbusRtuTarget", "ModbusTcpTarget")
RESERVED = frozenset(
    (
        *(bank.dsl for bank in BANKS.values()),
        *INSTRUCTIONS,
        *FUNCTIONS,
        *UNITS,
        *CONVERSIONS,
        *_OTHERS,
        *keyword.kwlist,
        *keyword.softkwlist,
        # Functions that a site adds, such as exit, are not built in.
        *(name for name, value in vars(builtins).items() if isinstance(value, type | BuiltinFunctionType)),
    )
)
"""Words with another meaning: those of the language and Python's own."""


def function_name(name: str, taken: Collection[str]) -> str:
    """Return the function for a subroutine: its own name if Python and the language have no other use for it.

    ``Auto Mode`` is ``Auto_Mode``, ``2nd-Line`` is ``sub_2nd_Line``, ``reset`` is ``reset_``. A name that is ``taken``,
    whatever its case, gets a number, since it may be the name of a file as well. The same names in the same order
    get the same functions.
    """
    word = re.sub(r"[^A-Za-z0-9_]+", "_", name)
    if not word.strip("_"):
        word = "sub"
    if word[0].isdigit():
        word = f"sub_{word}"
    if word in RESERVED or word in INSTRUCTIONS:
        word = f"{word}_"
    others = {other.lower() for other in taken}
    numbered = (f"{word.rstrip('_')}_{number}" for number in count(2))
    return word if word.lower() not in others else next(one for one in numbered if one.lower() not in others)
