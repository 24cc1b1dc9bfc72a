"""The forms in which CLICK writes a nickname CSV: with or without Modbus numbers, and how it writes those.

With "Display MODBUS address" checked, an export has two more columns, decimal or hexadecimal. The upper words of XD1
to XD8 and YD1 to YD8 then have rows with an empty address. Some files have ``## `` before the header (click-facts
[nickname-file.modbus-columns, nickname-file.old-header, nickname-file.upper-rows]).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from clickgen.device.banks import UPPER_BYTE_BANKS, Address, Kind
from clickgen.device.modbus import modbus_number
from clickgen.table.rows import COLUMNS, HEADER, Row, format_row

MODBUS_COLUMNS = ("Modbus Address", "Function Code")
WITH_MODBUS = (*COLUMNS[:2], *MODBUS_COLUMNS, *COLUMNS[2:])
_MODBUS_AT = len(COLUMNS[:2])
_HEX = re.compile(r"[0-9A-Fa-f]{1,4}[hH]")
_OLD_HEADER = re.compile(r"\A##\s*")


class TableForm(NamedTuple):
    """The form of the rows of one table."""

    has_modbus: bool = False
    is_hex: bool = False
    """True if the table writes Modbus numbers as ``0000h``, not as ``400001``."""
    quotes_codes: bool = False
    """True if the table also quotes ``FC=02``; ``FC=01,05,15`` always needs quotes."""

    @property
    def width(self) -> int:
        return len(WITH_MODBUS if self.has_modbus else COLUMNS)

    @property
    def header(self) -> str:
        """The first line, without the marks of older drivers."""
        return ",".join(WITH_MODBUS) if self.has_modbus else HEADER

    def column(self, field: int) -> int:
        """The column of a field of COLUMNS in a row of this form."""
        return field + len(MODBUS_COLUMNS) if self.has_modbus and field >= _MODBUS_AT else field

    def fields(self, row: Sequence[str]) -> list[str]:
        """The fields of COLUMNS in a row of this form."""
        if not self.has_modbus:
            return list(row)
        return [row[self.column(field)] for field in range(len(COLUMNS))]

    def format(self, row: Row) -> str:
        """Return a row as CLICK writes it in this form."""
        plain = format_row(row)
        if not self.has_modbus:
            return plain
        number = modbus_number(row.address)
        code = number.function_code
        if self.quotes_codes or "," in code:
            code = f'"{code}"'
        address, word, rest = plain.split(",", _MODBUS_AT)
        return ",".join((address, word, self.number(row.address), code, rest))

    def number(self, address: Address) -> str:
        """The Modbus number of an address in the notation of the table."""
        number = modbus_number(address)
        return number.hexadecimal if self.is_hex else number.decimal

    def has_number(self, row: Sequence[str], address: Address) -> bool:
        """False if a row gives a Modbus number other than that of its address; leading zeros do not count."""
        said = row[_MODBUS_AT] if self.has_modbus else ""
        number = modbus_number(address)
        known = (number.hexadecimal, number.decimal)
        return not said or said.lstrip("0").casefold() in {one.lstrip("0").casefold() for one in known}


PLAIN = TableForm()
"""The form that CLICK imports, and that clickgen uses for a new table."""


def without_marks(header: str) -> str:
    """A header line without the ``## `` of older drivers."""
    return _OLD_HEADER.sub("", header)


def form_of(header: Sequence[str]) -> TableForm | None:
    """The form of a table with these column names; None if it is not a nickname table."""
    names = tuple(header)
    return TableForm(names == WITH_MODBUS) if names in (COLUMNS, WITH_MODBUS) else None


def settled(form: TableForm, fields: Sequence[str], raw: str) -> TableForm:
    """The form once one of its rows has shown how the table writes its numbers and codes."""
    is_hex = form.is_hex or bool(_HEX.fullmatch(fields[_MODBUS_AT]))
    code = fields[_MODBUS_AT + 1]
    return form._replace(is_hex=is_hex, quotes_codes=form.quotes_codes or ("," not in code and f'"{code}"' in raw))


_UPPER_WORDS = {
    text.lstrip("0").casefold()
    for bank in UPPER_BYTE_BANKS
    for number in range(1, 9)
    for start in (modbus_number(Address(bank, number)),)
    for upper in (start._replace(offset=start.offset + 1),)
    for text in (upper.decimal, upper.hexadecimal)
}


def is_upper_word(form: TableForm, fields: Sequence[str]) -> bool:
    """True for a row without an address that CLICK writes for the upper word of an XD or YD, and that says nothing."""
    address, word, nickname, initial, retentive, comment = form.fields(fields)
    says_nothing = not (address or nickname or comment) and not initial.strip("0") and retentive == "No"
    if word != Kind.HEX.value or not says_nothing:
        return False
    return not form.has_modbus or fields[_MODBUS_AT].lstrip("0").casefold() in _UPPER_WORDS
