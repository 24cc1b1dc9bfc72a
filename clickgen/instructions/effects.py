"""What running an instruction does, as data: lowering, the rules, import, diff and the cross-reference ask it.

Which addresses an instruction reads and writes, its parameters say (``Slot.access``). Here is what else it does with
them, and when. A field names parameters of the instruction by their names. The defaults claim nothing: an instruction
that declares no more may act whenever CLICK comes past it, and what it writes may be anything.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto


class Drives(Enum):
    """What decides whether a driven bit is on."""

    POWER = "on while the rung is on, off while it is off"
    ON = "turned on"
    OFF = "turned off"
    STEP = "on in the steps of the instruction that say so"


@dataclass(frozen=True)
class Drive:
    """The bits that an instruction turns on or off."""

    target: str
    how: Drives


class Shape(Enum):
    """How a value gets from its source to its target."""

    VALUE = "one value to one address"
    FILL = "one value to every address of a range"
    BLOCK = "each address of a range to one of its own"
    PACK = "several addresses into one"
    UNPACK = "one address into several"
    FORMULA = "what a formula gives to one address"
    MESSAGE = "over a port, to another device or from it"


@dataclass(frozen=True)
class Move:
    """A value that an instruction takes from ``source`` to ``target``; without a source it is the number ``value``."""

    source: str
    target: str
    shape: Shape = Shape.VALUE
    value: int = 0


@dataclass(frozen=True)
class Find:
    """A range in which an instruction looks for a value. A flag may let it go on from its last result."""

    start: str
    end: str
    comparison: str
    value: str
    goes_on: str
    result: str


class Flow(Enum):
    """Where CLICK goes on after an instruction, if not with the next one."""

    PASS = "it does nothing"
    CALL = "a subroutine runs first"
    RETURN = "the subroutine is left"
    END = "the scan is over"
    LOOP = "the rungs up to the next NEXT run several times"
    NEXT = "the loop is closed"


class Keeps(Enum):
    """What an instruction remembers from one run to the next, and changes whenever it runs."""

    TIME = auto()
    COUNT = auto()
    STEP = auto()
    BITS = auto()


@dataclass(frozen=True)
class Effects:
    """What an instruction does where CLICK comes past it."""

    drives: Drive | None = None
    moves: Move | None = None
    finds: Find | None = None
    flow: Flow | None = None
    keeps: frozenset[Keeps] = frozenset()
    done: bool | None = None
    """What the bit that it owns becomes when its setpoint is reached: on or off; None where it owns no bit."""
    reset_by: str = ""
    """The input that takes what it keeps back to the beginning. Without one, what it keeps goes with its rung."""
    reports: tuple[str, ...] = ()
    """What it writes to say how it fares, and must write, whoever reads it."""
    flags: tuple[str, ...] = ()
    """The system bits that running it can change."""
    needs_power: bool = False
    """True for what surely changes nothing while its rung is off."""
    is_late: bool = False
    """True for what changes all that it writes in its own time, in some later scan."""
    is_unknown: bool = False
    """True where nobody knows what it does, nor when."""

    @property
    def leaves(self) -> bool:
        """True for what keeps the rest of its routine from running in this scan."""
        return self.flow is Flow.RETURN or self.flow is Flow.END

    @property
    def diverts(self) -> bool:
        """True where the instruction that runs next is not the one that is written next."""
        return self.flow is not None and self.flow is not Flow.PASS

    @property
    def follows_power(self) -> bool:
        """True for a coil that is on while its rung is on, and off while it is off."""
        return self.drives is not None and self.drives.how is Drives.POWER

    @property
    def turns_off(self) -> bool:
        """True for a coil that turns its bits off, and never on."""
        return self.drives is not None and self.drives.how is Drives.OFF

    @property
    def is_coil(self) -> bool:
        """True for what drives its bits by the power of its rung alone."""
        return self.drives is not None and self.drives.how is not Drives.STEP

    @property
    def shape(self) -> Shape | None:
        """How it moves a value; None where it moves none."""
        return self.moves.shape if self.moves is not None else None

    @property
    def is_timed(self) -> bool:
        """True for what counts time."""
        return Keeps.TIME in self.keeps

    @property
    def falls_back(self) -> bool:
        """True for a timer that is at its beginning, and its bit off, whenever its rung is off."""
        return self.is_timed and self.done is True and not self.reset_by


COPY_FLAGS = ("SC43", "SC44")
"""Out of range, address error (click-facts [scan.flags])."""
MATH_FLAGS = ("SC40", "SC43")
"""Division error, out of range (click-facts [scan.flags])."""
