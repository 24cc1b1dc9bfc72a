"""Turns what people write into a list into CLICK's form. Ambiguous cells are not guessed."""

from __future__ import annotations

import re
import unicodedata

from clickgen.device.banks import Address, Kind, parse_address
from clickgen.table.judge_row import Fault, initial_value_fault, short
from clickgen.table.rows import format_initial, initial_fault
from clickgen.table.workbook.cells import Cell

_ADDRESS = re.compile(r"([A-Za-z]{1,3})\s*(\d{1,8})\s*([uU]?)")
_HEX = re.compile(r"(?:0[xX])?([0-9A-Fa-f]{1,4})[hH]?")
_WORDS = {
    True: ("yes", "y", "true", "on", "1", "x", "✓", "✔", "☑", "ja", "j", "wahr", "sí", "si", "s", "verdadero"),
    False: ("no", "n", "false", "off", "0", "☐", "nein", "falsch", "falso"),
}
_TRUTH = {word: truth for truth, words in _WORDS.items() for word in words}
_BITS = {"on": "1", "true": "1", "off": "0", "false": "0"}


_SPARE = (
    "n/a, n.a., not applicable, none, nil, null, spare, spares, spare input, spare output, spare point, spare i/o, "
    "reserve, reserved, not used, unused, not in use, not connected, not assigned, unassigned, n/u, "
    "tbd, tba, tbc, to be defined, to be determined, to be assigned, xx, xxx, "
    "nicht belegt, nicht benutzt, nicht verwendet, unbenutzt, unbelegt, entfällt, "
    "réserve, réservé, non utilisé, inutilisé, non affecté, reserva, reservado, no usado, no utilizado, sin uso"
)
"""Words that people write for a point without a name."""
_SPARE_WHERE_TWICE = "x, open, free, empty, blank, future, n/c, n.b., k.a., frei, leer, libre, vide, s/o, vacío"
"""These may also be names, of a limit switch or an axis, but not if two points have them."""


def _letters(text: str) -> str:
    """A text without case, accents, spaces and punctuation."""
    return "".join(letter for letter in unicodedata.normalize("NFKD", text.casefold()) if letter.isalnum())


_SPARES = {_letters(word) for word in _SPARE.split(", ")}
_SPARES_WHERE_TWICE = {_letters(word) for word in _SPARE_WHERE_TWICE.split(", ")}


def is_spare(text: str) -> bool:
    """True for the words that mark a point without a name: ``N/A``, ``SPARE``, ``not used``, ``TBD``, ``???``."""
    letters = _letters(text)
    return text != "" and (not letters or letters in _SPARES)


def spare_where_twice(text: str) -> str:
    """The word, the same for each form, that is no name if two points have it, such as ``x``, ``Open`` or ``SPARE``."""
    letters = _letters(text)
    return letters if letters in _SPARES_WHERE_TWICE or letters in _SPARES else ""


_BETWEEN = re.compile(r"\s*(?:[-\u2010-\u2015~:,;/&+]|\.{2,3}|\bto\b|\bthrough\b|\band\b)\s*", re.IGNORECASE)


def addresses_in(text: str) -> tuple[str, ...]:
    """The addresses of a cell that names several: ``X001-X003``, ``X1..3``, ``X1, X2``; none for any other text."""
    parts = _BETWEEN.split(text) if len(text) < 200 else []
    if len(parts) < 2 or not _ADDRESS.fullmatch(parts[0]):
        return ()
    return tuple(parts) if all(_ADDRESS.fullmatch(part) or part.isdecimal() for part in parts) else ()


def looks_like_address(text: str) -> bool:
    """True for letters and a number, whether CLICK has such an address or not."""
    return _ADDRESS.fullmatch(text) is not None


def address_of(text: str) -> Address | None:
    """The address of ``X001``, ``x1``, ``DS 100`` or ``xd0u``; None for anything else."""
    match = _ADDRESS.fullmatch(text)
    return parse_address("".join(match.groups())) if match else None


def name_of(cell: Cell) -> str:
    """The name in a cell, trimmed; "" for a dash, which people write if there is none."""
    return "" if re.fullmatch(r"[-\u2013\u2014]*", cell.text) else cell.text


def retentive_of(cell: Cell) -> bool | None:
    """True for yes, x and the like, False for no and the like, None for anything else."""
    return None if cell.fault else _TRUTH.get(cell.shown.strip().lower())


def initial_of(address: Address, cell: Cell) -> str | Fault:
    """Return the initial value of an address in CLICK's form, or the fault in the cell."""
    value, kind = cell.value, address.kind
    if isinstance(value, str):
        text = _initial_of_text(kind, value)
    elif kind is Kind.HEX and value not in range(10):
        return _decimal_or_not(address, cell)
    elif kind is Kind.TEXT and not isinstance(value, bool):
        text = cell.shown
    else:
        number = int(value) if isinstance(value, float) and value.is_integer() else value
        text = format_initial(kind, number) or cell.shown
    return initial_value_fault(address, text) or text


def _decimal_or_not(address: Address, cell: Cell) -> Fault:
    number = cell.shown
    is_short = number.isdigit() and len(number) <= 4
    way_out = (
        f"write {number}h or {int(number):04X}h" if is_short else "write up to four digits with an h, such as 00FFh"
    )
    return Fault(f"{address} is hexadecimal, and {short(number)} is a number that may be meant decimal", way_out)


def _initial_of_text(kind: Kind, text: str) -> str:
    """A text in CLICK's form if it means a value of this kind; else unchanged. A character may be a space."""
    if initial_fault(kind, text) is None:
        return text
    text = text.strip()
    if kind is Kind.BIT:
        return _BITS.get(text.lower(), text)
    if kind is Kind.HEX and (digits := _HEX.fullmatch(text)):
        return format_initial(kind, digits[1]) or text
    return text


def same_initial(kind: Kind, one: str, other: str) -> bool:
    """True for two forms of one value, such as 1.50 and 1.5."""
    if kind is Kind.TEXT or initial_fault(kind, one) or initial_fault(kind, other):
        return one == other
    if kind is Kind.FLOAT:
        return format_initial(kind, float(one)) == format_initial(kind, float(other))
    base = 16 if kind is Kind.HEX else 10
    return int(one, base) == int(other, base)
