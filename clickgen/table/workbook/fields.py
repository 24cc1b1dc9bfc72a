"""Reads a cell in the column of one field: an address, a nickname, an initial value, retention, a comment."""

from __future__ import annotations

from clickgen.device.banks import Address, Kind
from clickgen.table.judge_row import Fault, address_comment_fault, retention_fault, short
from clickgen.table.workbook.cells import Cell
from clickgen.table.workbook.titles import Field
from clickgen.table.workbook.values import initial_of, is_spare, name_of, retentive_of, same_initial


def says_something(what: Field, cell: Cell) -> bool:
    """True for a cell that is not blank in the column of a field."""
    if cell.fault or not isinstance(cell.value, str):
        return True
    if what is Field.ADDRESS:
        return name_of(cell) != "" and not is_spare(cell.text)
    if what is Field.NICKNAME:
        return name_of(cell) != ""
    return cell.text != "" or what is not Field.RETENTIVE


def is_blank_value(address: Address, what: Field, cell: Cell) -> bool:
    """True for spaces, a dash or N/A as an initial value or retention, unless they can be the character of a TXT."""
    if what is Field.RETENTIVE:
        return retentive_of(cell) is None and is_spare(cell.text)
    if what is not Field.INITIAL or address.kind is Kind.TEXT or not isinstance(cell.value, str):
        return False
    return not name_of(cell) or is_spare(cell.text)


def value_of(address: Address, what: Field, cell: Cell) -> str | bool | Fault:
    """Return what a cell says of an address, or the fault in it. Whether a nickname is legal is not checked here."""
    if what is Field.NICKNAME:
        return name_of(cell) or _no_name(address, cell)
    if what is Field.INITIAL:
        return initial_of(address, cell)
    if what is Field.COMMENT:
        comment = cell.value if isinstance(cell.value, str) else cell.shown
        return address_comment_fault(address, comment) or comment
    retentive = retentive_of(cell)
    if retentive is None:
        return Fault(f"the retentive setting of {address} reads {short(cell.shown)}", "write Yes or No")
    return retention_fault(address, retentive) or retentive


def _no_name(address: Address, cell: Cell) -> Fault:
    return Fault(
        f"the nickname of {address} is {cell.shown}, which is no text",
        "format the cell as text and write the nickname again",
    )


def agree(address: Address, what: Field, one: str | bool, other: str | bool) -> bool:
    """True for two values that mean the same in one field of an address."""
    if what is Field.RETENTIVE:
        return one == other
    one, other = str(one), str(other)
    if what is Field.NICKNAME:
        return one.lower() == other.lower()
    if what is Field.INITIAL:
        return same_initial(address.kind, one, other)
    return one.strip() in ("", other.strip())


def in_words(value: str | bool) -> str:
    """Return a value as messages show it."""
    return ("Yes" if value else "No") if isinstance(value, bool) else short(value)
