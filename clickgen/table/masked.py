"""Initial values that CLICK masks: those of retentive addresses, in declarations and in the address table.

ClickNick shows such a value read-only, and CLICK's exports carry one only where Retentive is No (click-facts
[nickname-file.masked]).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Protocol

from clickgen.device.banks import BANKS, Address, Kind
from clickgen.ir.operands import Constant
from clickgen.ir.program import BlockDeclaration, Declaration, Program
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import Row, is_default_initial
from clickgen.text.wording import counted

CODE = "CG550"


class Words(Protocol):
    """What a dialect writes of names and declarations."""

    def name(self, bank: str, name: str) -> str:
        """A nickname seen through a bank."""

    def setting(self, name: str, value: str = "") -> str:
        """A setting of a declaration; without a value its word alone."""


def warn_of_masked(
    program: Program, rows: Iterable[Row], table: AddressTable, spell: Words, problems: Diagnostics
) -> None:
    """Report each masked value where it is written; ``rows`` are those that the program adds to the table."""
    known = {**table.by_address, **{row.address: row for row in rows}}
    masked = {address: row for address, row in known.items() if _is_masked(row)}
    if not masked:
        return
    declared: set[Address] = set()
    declarations: tuple[Declaration | BlockDeclaration, ...] = (*program.declarations, *program.blocks)
    for declaration in declarations:
        if declaration.initial is None:
            continue
        found = [address for address in _addresses(declaration) if address in masked]
        declared.update(found)
        if found:
            _report_declared(declaration, declaration.initial, found, masked, spell, problems)
    for run in _runs(address for address in masked if address not in declared and address in table.by_address):
        _report_rows([masked[address] for address in run], table, spell, problems)


def _is_masked(row: Row) -> bool:
    bank = BANKS[row.address.bank]
    return row.retentive and not bank.settings_fixed and not is_default_initial(bank.kind, row.initial)


def _addresses(declaration: Declaration | BlockDeclaration) -> list[Address]:
    if isinstance(declaration, BlockDeclaration):
        return declaration.range.addresses()
    return [declaration.cell.address]


def _report_declared(
    declaration: Declaration | BlockDeclaration,
    initial: Constant,
    found: list[Address],
    masked: Mapping[Address, Row],
    spell: Words,
    problems: Diagnostics,
) -> None:
    name, first = spell.name(declaration.named.bank, declaration.named.name), masked[found[0]]
    off, on = spell.setting("retentive", "False"), spell.setting("retentive", "True")
    instead = f"{off} in place of {on}" if declaration.retentive else off
    problems.add(
        CODE,
        initial.span,
        f"{name} is retentive, so CLICK masks its initial value {first.initial}: at power-up it keeps what it held",
        f"write {instead}, and {name} begins with {first.initial} at every power-up; or leave out "
        f"{spell.setting('initial')} and {_written_once(first, spell)}",
    )


def _report_rows(run: list[Row], table: AddressTable, spell: Words, problems: Diagnostics) -> None:
    first = run[0]
    if len(run) == 1:
        name = f"{first.address} ({first.nickname})" if first.nickname else str(first.address)
        said = f"{name} is retentive, so CLICK masks its initial value {first.initial}: at power-up it keeps"
    else:
        said = (
            f"{counted(len(run), 'address', 'addresses')} from {first.address} to {run[-1].address} are retentive, so "
            f"CLICK masks their initial values: at power-up they keep"
        )
    problems.add(
        CODE,
        table.span(table.by_address[first.address]),
        f"{said} what they held" if len(run) > 1 else f"{said} what it held",
        f"write No under Retentive, or take the initial value out and {_written_once(first, spell)}",
    )


def _written_once(row: Row, spell: Words) -> str:
    """The words for how a program gives an address its first value."""
    first_scan = spell.name("SC", "_1st_SCAN")
    return f"{'set it' if row.address.kind is Kind.BIT else 'copy the value'} where {first_scan} is on"


def _runs(addresses: Iterable[Address]) -> Iterator[list[Address]]:
    """Yield runs of consecutive addresses of a bank."""
    run: list[Address] = []
    for address in sorted(addresses, key=lambda address: address.sort_key):
        if run and (address.bank, address.number) != (run[-1].bank, run[-1].number + 1):
            yield run
            run = []
        run.append(address)
    if run:
        yield run
