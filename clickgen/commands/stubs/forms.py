"""The types of operands: one class for each form of an address in each bank, and unions of them."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from clickgen.device.banks import BANKS, VALUE_CLASSES
from clickgen.instructions.spec import CODE, HEX, INTEGER, REAL, TEXT, Slot

FAMILIES = {"bit": "_Bit", "decimal": "_Decimal", "hexadecimal": "_Hexadecimal", "text": "_Text"}
"""The base class of the cells of each value class; that of their ranges is ``_BitRange`` and so on."""

IMMEDIATE = ("X", "Y")
"""The banks with terminals, which can be read or driven past the image of the scan."""


def family(bank: str) -> str:
    """The base class of a bank's cells."""
    return FAMILIES[VALUE_CLASSES[BANKS[bank].kind]]


def within(bank: str) -> str:
    """The class of one address or several in a bank."""
    return f"_In{bank}"


def cell(bank: str) -> str:
    return f"_{bank}"


def block(bank: str) -> str:
    return f"_{bank}Block"


def named(bank: str) -> str:
    """The class of a nickname that may be an address or a block."""
    return f"_{bank}Name"


def span(bank: str) -> str:
    return f"_{bank}Range"


def pointer(bank: str) -> str:
    return f"_{bank}Pointer"


def immediate(bank: str) -> str:
    return f"_{bank}Immediate"


def union(names: Iterable[str]) -> str:
    """``_DS | _DD | int``; if every class of a family is there, their base class replaces them all."""
    kept = list(dict.fromkeys(names))
    for base in FAMILIES.values():
        banks = [bank for bank in BANKS if family(bank) == base]
        for whole, parts in ((base, map(cell, banks)), (f"{base}Range", map(span, banks))):
            members = list(parts)
            if len(members) > 1 and all(member in kept for member in members):
                kept[kept.index(members[0])] = whole
                kept = [name for name in kept if name not in members]
    return " | ".join(kept)


def operand(slot: Slot, wanted: Collection[str] | None = None) -> list[str]:
    """The classes that an operand position takes, in the wanted banks and forms of constants."""
    forms = ((slot.cells, cell), (slot.ranges, span), (slot.immediates, immediate), (slot.pointers, pointer))
    classes = [name(bank) for banks, name in forms for bank in banks if wanted is None or bank in wanted]
    return classes + constants([form for form in slot.constants if wanted is None or form in wanted])


def constants(forms: Collection[str]) -> list[str]:
    """The Python types of constants; float takes whole numbers, too."""
    number = "float" if REAL in forms else "int" if {INTEGER, HEX} & {*forms} else ""
    text = "str" if {HEX, TEXT, CODE} & {*forms} else ""
    return [name for name in (number, text) if name]
