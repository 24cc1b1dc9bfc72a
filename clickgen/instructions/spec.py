"""How an instruction is declared: its signature, operands, pins, height and ladder token, as data.

Every stage reads the same Spec: signature checks, operand checks, grid heights, tokens, listing, documentation.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property
from typing import Final

from clickgen.device.banks import READ_ONLY
from clickgen.instructions.effects import Effects

BITS = ("X", "Y", "C", "T", "CT", "SC")
REGISTERS = ("DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "SD", "TXT")
INTEGER, HEX, REAL, TEXT, CODE = "integer", "hex", "real", "text", "code"
"""The forms of constants; they stand beside bank names in a ``Slot`` and a ``Pair``."""

NUMBERS = (INTEGER, HEX, REAL)
CONSTANTS = (INTEGER, HEX, REAL, TEXT, CODE)


class Access(Enum):
    """What an instruction does to an operand. A timer or counter OWNs its number: bit and current value."""

    READ = "read"
    WRITE = "written"
    OWN = "owned"


@dataclass(frozen=True)
class Slot:
    """What one operand position takes, by form; each field names banks (or forms of constants)."""

    cells: tuple[str, ...] = ()
    ranges: tuple[str, ...] = ()
    pointers: tuple[str, ...] = ()
    immediates: tuple[str, ...] = ()
    constants: tuple[str, ...] = ()
    limits: tuple[int, int] | None = None
    """The least and greatest integer constant."""
    disputed: tuple[str, ...] = ()
    """Banks among these that are not known to work: they are taken with a warning."""
    access: Access = Access.READ
    reversible: bool = False
    """True where a reversed range means something (a shift register's direction)."""

    def describe(self) -> str:
        """What the slot takes, for a message: ``a DS register or an integer 0..32767``."""
        parts = []
        cells, ranges = (self._usable(banks) for banks in (self.cells, self.ranges))
        if cells:
            parts.append(f"an address in {_listed(cells)}")
        if ranges:
            parts.append(f"a range in {_listed(ranges)}")
        if self.immediates:
            parts.append(f"an immediate {_listed(self.immediates)}")
        if self.pointers:
            parts.append("a pointer")
        if INTEGER in self.constants:
            parts.append("an integer" + (f" {self.limits[0]}..{self.limits[1]}" if self.limits else ""))
        parts += [_FORM_TITLES[form] for form in self.constants if form != INTEGER]
        return _listed(tuple(parts), "or")

    def _usable(self, banks: tuple[str, ...]) -> tuple[str, ...]:
        """These banks without those that nothing writes, where the operand is written."""
        return tuple(bank for bank in banks if self.access is not Access.WRITE or bank not in READ_ONLY)


_FORM_TITLES = {HEX: "a hexadecimal constant", REAL: "a number", TEXT: "a text", CODE: "a character code"}


def _listed(words: tuple[str, ...], joiner: str = "or") -> str:
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} {joiner} {words[-1]}"


class ParamKind(Enum):
    """How an argument is written; the value completes "… must be"."""

    OPERAND = "an address or a constant"
    OPERANDS = "a list: [y[1], c.Lamp]"
    PATTERN = "a list of rows of 0 and 1: [[1, 0], [0, 1]]"
    TARGET = (
        'ModbusTcpTarget(ip="192.168.1.10", port=502, device_id=1) or ModbusRtuTarget(com_port="cpu2", device_id=5)'
    )
    REMOTE = 'an address of the other device: "DS1" or ModbusAddress(address=400001)'
    FLAG = "True or False"
    UNIT = "Tms, Ts, Tm, Th or Td"
    PIN = "a condition, written as a lambda: reset=lambda: c.Reset"
    OPTIONS = "to_value, to_ascii, to_binary or to_text(...)"
    FORMULA = 'a formula in quotes: "ds.A * 2"'
    ROUTINE = "a subroutine, by its function or by its name in quotes"
    RANGE_COMPARISON = "a comparison of a range with a value: ds[1:101] >= 100"
    COMPARISON = 'a comparison in quotes: "==", "!=", "<", "<=", ">" or ">="'
    TEXT = "a text in quotes"
    TOKEN = "a ladder token in quotes"


class _Required(Enum):
    REQUIRED = "required"


REQUIRED: Final = _Required.REQUIRED


@dataclass(frozen=True)
class Param:
    """One parameter of an instruction.

    ``default`` is REQUIRED, or None (left out), or the value of a flag or unit. ``typed_by`` names the parameter whose
    kind decides the form of a constant here: ``copy(5, dh.X)`` emits ``0005h``.

    A pin that is left out is an error (REQUIRED), or gets the never-contact and a warning (``missing_pin``), or is an
    input that the box then does not have.
    """

    name: str
    kind: ParamKind = ParamKind.OPERAND
    slot: Slot = field(default_factory=Slot)
    default: object = REQUIRED
    aliases: tuple[str, ...] = ()
    typed_by: str = ""
    pin: str = ""
    """The token of a pin's row: ``.reset()``; a format string over the parameters' rendered texts."""
    chained: str = ""
    """In a chain: the method's name where it is not the pin's own, or a keyword of the method (``of_pin``)."""
    of_pin: str = ""
    """The pin that this parameter belongs to: both are given or neither."""
    missing_pin: str = ""
    """The problem code when this pin is left out and gets the never-contact."""
    extends_over: str = ""
    """The range parameter whose length this first address is extended to (block copy)."""
    extends_to: str = ""
    """The parameter that names the last address of what begins here (search)."""
    by_name: bool = False
    """True for an operand that an imported program writes with its name; the others go by their places."""
    is_hex: bool = False
    """True for a formula of hexadecimal words."""


@dataclass(frozen=True)
class Pair:
    """One row of a copy matrix: these sources go to these targets.

    ``lengths`` bounds the range's length; ``disputed`` says who doubts the row, which makes it a warning.
    """

    sources: tuple[str, ...]
    targets: tuple[str, ...]
    lengths: tuple[int, int] | None = None
    disputed: str = ""


@dataclass(frozen=True)
class Variant:
    """One ladder token that an instruction can become. Without ``pairs`` it is the only one.

    ``token`` is a format string over the parameters' rendered texts.
    """

    token: str
    pairs: tuple[Pair, ...] = ()


@dataclass(frozen=True, eq=False)
class Spec:
    """One instruction of the language: each is declared once, and is equal to itself alone.

    ``height`` is in grid rows, pins included (click-facts [grid.heights]). ``alone`` instructions get a CLICK rung of
    their own. Whoever wants to know what an instruction does asks its ``effects``.
    """

    name: str
    params: tuple[Param, ...]
    variants: tuple[Variant, ...]
    summary: str
    example: str
    height: int = 1
    matrix: tuple[str, str] = ("", "")
    """The names of the source and target parameters that the variants' pairs speak of."""
    conversions: tuple[str, ...] = ()
    """The options that a copy takes."""
    alone: bool = False
    bare_enable: bool = False
    """True where a wire from the power rail alone is known to run a box with pins; others get a contact there."""
    effects: Effects = field(default_factory=Effects)
    own_row: int = 0
    """The row of its box that the rung itself leads to; 0 is the first."""
    short: Spec | None = None
    """The same instruction by another signature, in which one argument says what several do here."""
    built_from: Spec | None = None
    """CLICK has no such box: clickgen builds it from this one and scratch bits."""
    notes: tuple[str, ...] = ()

    @cached_property
    def pins(self) -> tuple[Param, ...]:
        return tuple(param for param in self.params if param.kind is ParamKind.PIN)

    @cached_property
    def ends(self) -> frozenset[str]:
        """The parameters that name the last address of what another one begins."""
        return frozenset(param.extends_to for param in self.params if param.extends_to)

    @property
    def forms(self) -> tuple[Spec, ...]:
        """The instruction by each of its signatures."""
        return (self,) if self.short is None else (self, self.short)

    @property
    def owns(self) -> tuple[Param, ...]:
        """The parameters of what belongs to the instruction alone."""
        return tuple(param for param in self.params if param.slot.access is Access.OWN)

    @property
    def methods(self) -> dict[str, Param]:
        """The pins by their names in a chain: ``ctud(...).down(...).reset(...)``."""
        return {param.chained or param.name: param for param in self.pins}

    @property
    def signature(self) -> str:
        """As a person writes it: ``ton(timer, setpoint, unit=Tms)``."""
        return f"{self.name}({', '.join(map(_shown, self.params))})"


def _shown(param: Param) -> str:
    if param.default is REQUIRED and param.kind is not ParamKind.PIN:
        return param.name
    if param.kind is ParamKind.PIN:
        return f"{param.name}=lambda: ..."
    return f"{param.name}={param.default}"


# click-facts [token.oneshot]
ONESHOT: Final = Param("oneshot", ParamKind.FLAG, default=False, aliases=("one_shot",))
