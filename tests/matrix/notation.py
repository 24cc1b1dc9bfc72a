"""The notation of the tables: operands with their tokens, the operands of a slot, which banks go to which.

Nothing here comes from clickgen: banks, limits and tokens are those of docs/click-facts.md.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

BANKS = ("X", "Y", "C", "T", "CT", "SC", "DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "SD", "TXT")
BITS = "X Y C T CT SC"
REGISTERS = "DS DD DH DF XD YD TD CTD SD TXT"
POINTED = "C DS DD DH DF XD YD TD CTD TXT"
NEVER_WRITTEN = "X T CT XD"
WRITABLE_SC = (50, 51, 53, 55, 60, 61, 65, 66, 67, 75, 76, 120, 121, 303, 304, 323, 324)
DOUBTED_SC = (305, 306, 325, 326)
"""Writable in one list taken from an export, read-only in that of CLICK PLUS 3.41
(click-facts [bank.writable-sc-disputed])."""
WRITABLE_SD = (
    *(29, 31, 32, 34, 35, 36, 40, 41, 42, 50, 51, 60, 61, 106, 107, 108, 112, 113, 114),
    *(140, 141, 142, 143, 144, 145, 146, 147, 214, 215),
)

WARNINGS = ("CG312", "CG315", "CG418", "CG419", "CG420")
"""The message for a rung that is built all the same."""


# -- operands ---------------------------------------------------------------------------------------------------------


class Operand(NamedTuple):
    """An operand as a program writes it and as CLICK does. ``bank`` is empty for a constant."""

    form: str
    bank: str
    source: str
    token: str

    @property
    def kind(self) -> str:
        """Its name in a table: its bank, or the form of a constant."""
        return self.bank or self.form

    @property
    def word(self) -> str:
        """Its token where a hexadecimal word is meant: ``dh.x == 5`` is ``0005h``."""
        return f"{int(self.token):04X}h" if self.form == "integer" else self.token


def cell(bank: str, number: int) -> Operand:
    return Operand("cell", bank, f"{bank.lower()}[{number}]", address(bank, number))


def span(bank: str, first: int, length: int) -> Operand:
    last = first + length - 1
    token = f"{address(bank, first)}..{address(bank, last)}"
    return Operand("range", bank, f"{bank.lower()}[{first}:{last + 1}]", token)


def pointer(bank: str, register: int) -> Operand:
    return Operand("pointer", bank, f"{bank.lower()}[ds[{register}]]", f"{bank}[DS{register}]")


def immediate(operand: Operand) -> Operand:
    return Operand("immediate", operand.bank, f"{operand.source}.immediate", f"immediate({operand.token})")


def integer(value: int) -> Operand:
    return Operand("integer", "", str(value), str(value))


def hexadecimal(value: int) -> Operand:
    return Operand("hex", "", f"0x{value:04X}", f"{value:04X}h")


def hex_text(value: int) -> Operand:
    return Operand("hex", "", f'"{value:04X}h"', f"{value:04X}h")


def real(written: str) -> Operand:
    return Operand("real", "", written, written)


def text(value: str) -> Operand:
    quoted, doubled = value.replace('"', '\\"'), value.replace('"', '""')
    return Operand("text", "", f'"{quoted}"', f'"{doubled}"')


def code(value: int) -> Operand:
    return Operand("code", "", f'"${value:02X}"', f"${value:02X}")


CONSTANTS = (integer(5), hexadecimal(0x00FF), real("1.5"), text("A"), code(0x0D))


def address(bank: str, number: int) -> str:
    """X and Y have three digits (click-facts [bank.ranges])."""
    return f"{bank}{number:03}" if bank in ("X", "Y") else f"{bank}{number}"


Numbers = Mapping[str, int]
"""The number of the example of each bank."""


def numbered(number: int) -> dict[str, int]:
    return dict.fromkeys(BANKS, number)


READ = numbered(1)
WRITTEN = numbered(5) | {"SC": 50, "SD": 140}
"""Addresses that can be written, if the bank can; the next one can be too."""


def cells(numbers: Numbers) -> list[Operand]:
    """One address of each bank."""
    return [cell(bank, numbers[bank]) for bank in BANKS]


def ranges(numbers: Numbers) -> list[Operand]:
    """Two addresses of each bank."""
    return [span(bank, numbers[bank], 2) for bank in BANKS]


def pointers(register: int = 9) -> list[Operand]:
    return [pointer(bank, register) for bank in BANKS]


def immediates(numbers: Numbers) -> list[Operand]:
    """One address and a range of each bank, immediate."""
    return [immediate(operand) for operand in (*cells(numbers), *ranges(numbers))]


def addresses(numbers: Numbers) -> list[Operand]:
    """Every bank in every form."""
    return [*cells(numbers), *ranges(numbers), *pointers(), *immediates(numbers)]


# -- cells of a matrix ------------------------------------------------------------------------------------------------


class Cell(NamedTuple):
    """One rung: its source, its tokens in the ladder file, and the problems at its lines.

    ``tokens`` are contacts and outputs in reading order; ``C?`` matches any C that clickgen chose.
    """

    source: str
    tokens: tuple[str, ...]
    codes: tuple[str, ...]

    @property
    def builds(self) -> bool:
        return all(code in WARNINGS for code in self.codes)


def condition(source: str, *tokens: str, codes: str = "") -> Cell:
    return Cell(f"    if {source}:\n        out(c[2000])\n", (*tokens, "out(C2000)"), tuple(codes.split()))


def action(source: str, *tokens: str, codes: str = "") -> Cell:
    return Cell(f"    if c[1]:\n        {source}\n", ("C1", *tokens), tuple(codes.split()))


Matrices = dict[str, list[Cell]]


# -- one operand ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Takes:
    """The operands that a position takes: banks by form, and forms of constants.

    ``disputed`` banks are taken as one address, with a warning. A refused operand has the code of its form.
    """

    cells: str = ""
    ranges: str = ""
    pointers: str = ""
    immediates: str = ""
    constants: str = ""
    disputed: str = ""
    is_written: bool = False

    def fault(self, operand: Operand) -> str:
        """The code that an operand has here, "" for none."""
        form, bank = operand.form, operand.bank
        if form == "pointer" and bank not in POINTED.split():
            return "CG213"
        if self.is_written and bank in NEVER_WRITTEN.split():
            return "CG304"
        if form == "cell" and bank in self.disputed.split():
            return "CG312"
        taken = {
            "cell": self.cells,
            "range": self.ranges,
            "pointer": self.pointers,
            "immediate": self.immediates,
        }
        if operand.kind in taken.get(form, self.constants).split():
            return ""
        return {"pointer": "CG307", "immediate": "CG308"}.get(form, "CG301")


def slot(takes: Takes, write: Callable[[Operand], Sequence[str]]) -> list[Cell]:
    """One operand position: every bank in every form, and the constants. ``write`` gives the source and its tokens."""
    operands = [*addresses(WRITTEN if takes.is_written else READ), *CONSTANTS]
    return [action(*write(operand), codes=takes.fault(operand)) for operand in operands]


# -- two operands -----------------------------------------------------------------------------------------------------


def table(rows: str) -> dict[tuple[str, str], str]:
    """Read rows like ``X Y -> DH``, or ``X Y ?> DS`` for a disputed one, as pairs of kinds with their code."""
    pairs: dict[tuple[str, str], str] = {}
    for row in rows.strip().splitlines():
        arrow, verdict = ("?>", "CG312") if "?>" in row else ("->", "")
        sources, targets = row.split(arrow)
        pairs |= {(source, target): verdict for source in sources.split() for target in targets.split()}
    return pairs


def pairs(
    legal: dict[tuple[str, str], str], takes: tuple[Takes, Takes], sources: Iterable[Operand], targets: list[Operand]
) -> Iterator[tuple[Operand, Operand, str]]:
    """Every source with every target, and the codes of the two together: their own faults, or that of the pair."""
    for source in sources:
        for target in targets:
            faults = [fault for fault in (takes[0].fault(source), takes[1].fault(target)) if fault]
            # An operand that cannot be read at all hides other faults.
            faults = [fault for fault in faults if fault == "CG213"] or faults
            yield source, target, " ".join(faults) or legal.get((source.kind, target.kind), "CG305")
