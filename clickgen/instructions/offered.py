"""The instructions that a message offers to a person, by what they are for.

A message may say that ``copy_fill`` would do what was meant, and so has to name it. What a program's own instruction
does, its ``effects`` say: nothing compares an instruction with one of these.
"""

from __future__ import annotations

from clickgen.instructions.coils import OUT as COIL
from clickgen.instructions.coils import RESET as UNLATCH
from clickgen.instructions.coils import SET as LATCH
from clickgen.instructions.control import CALL, END, FOR, NEXT, NOP, RETURN
from clickgen.instructions.copies import COPY, COPY_BLOCK, COPY_FILL, COPY_PACK, COPY_UNPACK
from clickgen.instructions.counters import CTU
from clickgen.instructions.data import SEARCH
from clickgen.instructions.raw import RAW as KEPT
from clickgen.instructions.timers import RTON, TON

__all__ = [
    "CALL",
    "COIL",
    "COPY",
    "COPY_BLOCK",
    "COPY_FILL",
    "COPY_PACK",
    "COPY_UNPACK",
    "CTU",
    "END",
    "FOR",
    "KEPT",
    "LATCH",
    "NEXT",
    "NOP",
    "RETURN",
    "RTON",
    "SEARCH",
    "TON",
    "UNLATCH",
]
