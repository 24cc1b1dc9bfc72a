"""The classes of conditions, of addresses in every form, and of their comparisons and conversions."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.commands.stubs.forms import (
    FAMILIES,
    IMMEDIATE,
    block,
    cell,
    family,
    immediate,
    named,
    pointer,
    span,
    within,
)
from clickgen.commands.stubs.text import class_text, function_text
from clickgen.device.banks import BANKS, POINTED, Bank

_BASES = '''\
class _Condition:
    """Anything that a rung, a branch or an input can depend on."""
    def __bool__(self) -> bool: ...

class _NoCondition:
    """Anything that cannot be a condition."""
    def __bool__(self) -> None: ...
    def __eq__(self, other: object) -> _NotComparable: ...
    def __ne__(self, other: object) -> _NotComparable: ...

class _NotComparable(_NoCondition):
    """CLICK compares decimal numbers with each other, hexadecimal words with each other, and text with text."""

class _RangeComparison(_NoCondition):
    """A range compared with a value, for a search."""

class _AsNumber(_NoCondition):
    """Text on its way into a number."""

class _AsNumbers(_NoCondition):
    """A range of text on its way into numbers."""

class _AsText(_NoCondition):
    """A number on its way into text."""

class _Number:
    """Anything that a copy can turn into text."""
    def as_binary(self) -> _AsText:
        """The character whose code this is."""
    def as_text(
        self,
        *,
        suppress_zero: bool = True,
        exponential: bool = False,
        termination_code: int | str | None = None,
        pad: int | None = None,
    ) -> _AsText:
        """The digits: without leading zeros, or all of them with suppress_zero=False or pad=5."""

class _Characters:
    """Anything that a copy can turn into a number."""
    def as_value(self) -> _AsNumber:
        """The value that the digits have: "5" becomes 5."""
    def as_ascii(self) -> _AsNumber:
        """The code of the character: "5" becomes 53."""
'''

_COMPARED = {
    "_Decimal": ("_Condition, _Number", "float", "A register with a decimal number."),
    "_Hexadecimal": ("_Condition, _Number", "int | str", "A register with a hexadecimal word."),
    "_Text": ("_NoCondition, _Characters", "str", "A register with a character."),
}
"""The description of the cells of a family, the constants they compare with, and their documentation."""

_CHARACTER_RANGE = '''\
def as_value(self) -> _AsNumbers:
    """The value of each digit: "5" becomes 5."""
def as_ascii(self) -> _AsNumbers:
    """The code of each character: "5" becomes 53."""
'''

_ALWAYS = ("__eq__", "__ne__")
"""Python has these for everything, so a comparison that CLICK does not know needs a type of its own."""
_ORDER = ("__lt__", "__le__", "__gt__", "__ge__")


def value_classes() -> Iterator[str]:
    """Every class that an expression of the language can have."""
    yield _BASES
    yield class_text("_Bit", "_Condition", "One bit.", map(_incomparable, _ALWAYS))
    yield class_text("_BitRange", "_Condition", "Bits in a row; as a condition, all of them.")
    for base, (bases, constants, doc) in _COMPARED.items():
        yield class_text(base, bases, doc, _comparisons(base, constants))
        own = [_CHARACTER_RANGE] if base == "_Text" else []
        others = f"{base} | {constants}"
        members = [*own, *(_compared(method, others, "_RangeComparison") for method in (*_ALWAYS, *_ORDER))]
        yield class_text(f"{base}Range", "_NoCondition", "Registers in a row.", members)
    for bank in BANKS.values():
        yield from _bank_classes(bank)


def _comparisons(base: str, constants: str) -> Iterator[str]:
    """The comparisons of a register; with a range on the right side it is a search's."""
    others = f"{base} | {constants}"
    for method in _ALWAYS:
        yield f"@overload\n{_compared(method, others, '_Condition')}"
        yield f"@overload\n{_compared(method, f'{base}Range', '_RangeComparison')}"
        yield f"@overload\n{_incomparable(method)}"
    yield from (_compared(method, others, "_Condition") for method in _ORDER)


def _compared(method: str, others: str, result: str) -> str:
    return function_text(method, ["self", f"other: {others}"], result)


def _incomparable(method: str) -> str:
    return _compared(method, "object", "_NotComparable")


def _bank_classes(bank: Bank) -> Iterator[str]:
    name, base = bank.name, family(bank.name)
    terminals = []
    if name in IMMEDIATE:
        doc = "The terminal itself, past the image of the scan."
        terminals = ["@property\n" + function_text("immediate", ["self"], immediate(name), doc)]
    yield class_text(within(name), "", f"Addresses in {name}, one or several.", terminals)
    yield class_text(cell(name), f"{base}, {within(name)}", f"An address in {name}: {bank.title}.")
    yield class_text(span(name), f"{base}Range, {within(name)}", f"Addresses in {name} in a row.")
    yield class_text(block(name), span(name), f"A block of addresses in {name}.", _members(name))
    yield class_text(named(name), f"{cell(name)}, {block(name)}", f"A nickname in {name}, or a block.")
    if name in IMMEDIATE:
        # An immediate contact reads an input; an output is only driven at once.
        kind = "_Condition" if name == "X" else "_NoCondition"
        yield class_text(immediate(name), kind, f"Terminals in {name}, past the image of the scan.")
    if name in POINTED:
        yield class_text(pointer(name), _pointer_bases(bank), f"The {name} address whose number a DS register holds.")


def _members(bank: str) -> Iterator[str]:
    """The members of a block as they are written, counted from 0."""
    keys = {"int": cell(bank), "slice[int | None, int | None, int | None]": span(bank)}
    for key, result in keys.items():
        yield "@overload\n" + function_text("__getitem__", ["self", f"key: {key}", "/"], result)


def _pointer_bases(bank: Bank) -> str:
    converted = {FAMILIES["text"]: ", _Characters", FAMILIES["bit"]: ""}
    return "_NoCondition" + converted.get(family(bank.name), ", _Number")
