"""The language by an import, for editors: ``from clickgen.dsl import *``. The types are in ``dsl.pyi``.

A program is read by clickgen and never run. To import one does no harm: the words of the language do nothing here.
What would decide by a condition is refused.
"""

from __future__ import annotations

from typing import NoReturn

from clickgen.device.banks import BANKS
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.timers import UNITS


class _Word:
    """A word of the language, and whatever is written with it."""

    def __getattr__(self, name: str) -> _Word:
        if name.startswith("__"):
            raise AttributeError(name)
        return self

    def __getitem__(self, key: object) -> _Word:
        return self

    __lt__ = __le__ = __gt__ = __ge__ = __getitem__

    def __call__(self, *_: object, **__: object) -> _Word:
        return self

    def __bool__(self) -> NoReturn:
        raise RuntimeError("a clickgen program is read, not run: clickgen build PROG.py")

    def __iter__(self) -> NoReturn:
        bool(self)


_CONDITIONS = ("all", "any", "nc", "re", "fe")
_DECLARATIONS = ("nickname", "sub", "range", "ModbusTcpTarget", "ModbusRtuTarget", "ModbusAddress")
_BANKS = (bank.dsl for bank in BANKS.values())

__all__ = [*dict.fromkeys((*_BANKS, *INSTRUCTIONS, *_CONDITIONS, *UNITS, *CONVERSIONS, *_DECLARATIONS))]

globals().update(dict.fromkeys(__all__, _Word()))
