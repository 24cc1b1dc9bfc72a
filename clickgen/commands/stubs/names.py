"""Nicknames and blocks as attributes of their banks, with address, comment and settings as documentation."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from clickgen.commands.stubs.forms import block as block_class
from clickgen.commands.stubs.forms import cell, named
from clickgen.commands.stubs.text import docstring, is_attribute
from clickgen.device.banks import VALUE_BANK, Address, Kind, current_value
from clickgen.device.system import system_nicknames
from clickgen.table.blocks import Block
from clickgen.table.rows import Row, is_scratch


class _Name(NamedTuple):
    """The meaning of one attribute of a bank: its class, and its documentation."""

    bank: str
    name: str
    type: str
    about: str


def name_attributes(rows: Iterable[Row] = (), blocks: Iterable[Block] = ()) -> dict[str, str]:
    """The attributes of each bank, sorted by name: these nicknames and blocks, and CLICK's own names."""
    found: dict[tuple[str, str], list[_Name]] = {}
    for name in (*_nicknames(rows), *_blocks(blocks), *_system()):
        if is_attribute(name.name):
            found.setdefault((name.bank, name.name), []).append(name)
    attributes: dict[str, str] = {}
    for (bank, _), names in sorted(found.items(), key=lambda item: (item[0][1].lower(), item[0])):
        attributes[bank] = attributes.get(bank, "") + _attribute(names)
    return attributes


def _attribute(names: list[_Name]) -> str:
    """One attribute; programs of one folder may give its name to different addresses, or to a block as well."""
    first = names[0]
    type = first.type if len({name.type for name in names}) == 1 else named(first.bank)
    abouts = dict.fromkeys(name.about for name in names)
    return f"{first.name}: Final[{type}]\n{docstring('; '.join(abouts))}"


def describe(row: Row) -> str:
    """``DS5: "Tank level", initial 10, retentive``."""
    settings = [f'"{row.comment}"'] if row.comment else []
    if row.initial not in ("", "0") or (row.address.kind is Kind.TEXT and row.initial):
        settings.append(f"initial {row.initial}")
    if row.retentive:
        settings.append("retentive")
    return f"{row.address}: {', '.join(settings)}" if settings else str(row.address)


def _nicknames(rows: Iterable[Row]) -> Iterator[_Name]:
    own = [row for row in rows if row.nickname and not is_scratch(row)]
    taken = {(row.address.bank, row.nickname.lower()) for row in own}
    for row in own:
        address, name = row.address, row.nickname
        yield _Name(address.bank, name, cell(address.bank), describe(row))
        value = current_value(address)
        if address.bank in VALUE_BANK and (value.bank, name.lower()) not in taken:
            yield _Name(value.bank, name, cell(value.bank), f"{value}: current value of {name}")


def _blocks(blocks: Iterable[Block]) -> Iterator[_Name]:
    for block in blocks:
        for bank in filter(None, (block.bank, VALUE_BANK.get(block.bank))):
            first, last = Address(bank, block.first), Address(bank, block.last)
            about = f"{first} to {last}: members 0 to {block.size - 1}"
            yield _Name(bank, block.name, block_class(bank), about)


def _system() -> Iterator[_Name]:
    for name, address in system_nicknames().values():
        yield _Name(address.bank, name, cell(address.bank), f"{address}: CLICK's own")
