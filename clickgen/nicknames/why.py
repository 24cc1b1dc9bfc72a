"""Where the address of a name comes from, why it is that one, and where the name is used."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from clickgen.check.uses import Use, extents_of
from clickgen.device.banks import BANKS, Address, parse_address
from clickgen.device.system import find_system_name, system_name_of
from clickgen.diagnostics import did_you_mean
from clickgen.pipeline import BuildResult
from clickgen.resolve.blocks import marked_blocks
from clickgen.resolve.record import placed_in
from clickgen.resolve.rows import Row
from clickgen.wording import counted

_PLACES = 8
"""So many places of use are listed."""


def why(name: str, result: BuildResult, reserved: Iterable[Address], record: bytes | None) -> list[str]:
    """What is to be said of a name or an address in a program that was built; nothing when the program knows neither.

    ``reserved`` are addresses that the settings keep free, ``record`` is the file of the names that clickgen placed.
    """
    address = _address_of(name, result)
    if address is None:
        return _block_lines(name, result)
    row = next((row for row in result.rows if row.address == address), None)
    uses = result.facts.uses.at(address) if result.facts else []
    if row is None and not uses and system_name_of(address) is None:
        return [f"{address} has no name and {result.program} does not use it"]
    lines = [_head(address, row)]
    lines += [f"  {line}" for line in _origin(address, row, result, reserved, record)]
    lines += [f"  {line}" for line in _places(uses)]
    return lines


def suggestion(name: str, results: Iterable[BuildResult]) -> str:
    """``did you mean Motor?`` for a near miss."""
    return did_you_mean(name, [row.nickname for result in results for row in result.rows if row.nickname])


def _address_of(name: str, result: BuildResult) -> Address | None:
    row = next((row for row in result.rows if row.nickname.lower() == name.lower()), None)
    system = find_system_name(name)
    return row.address if row else system[1] if system else parse_address(name)


def _head(address: Address, row: Row | None) -> str:
    own = (row.nickname if row else "") or system_name_of(address) or ""
    what = f"{own} is {address}" if own else f"{address} has no nickname"
    bank = BANKS[address.bank]
    settings = [bank.kind.value]
    if row is not None and not bank.settings_fixed:
        settings += ["retentive" if row.retentive else "not retentive", f"initial value {row.initial or 'empty'}"]
    comment = f": {row.comment}" if row and row.comment else ""
    return f"{what} ({', '.join(settings)}){comment}"


def _origin(
    address: Address, row: Row | None, result: BuildResult, reserved: Iterable[Address], record: bytes | None
) -> Iterator[str]:
    program = result.facts.program if result.facts else None
    for declaration in program.declarations if program else ():
        if declaration.cell.address == address:
            yield f"declared by nickname(...) in {declaration.span}"
    stands = result.address_table.by_address.get(address)
    if row in result.new_rows and row is not None:
        yield from _choice(row, result, reserved)
    elif stands is not None and (stands.line or stands.cell):
        placed = placed_in(record).get(address) == stands.nickname != ""
        yield f"from {result.address_table.place(stands)}" + ("; clickgen placed it" if placed else "")
    elif system_name_of(address):
        yield "CLICK's own name"


def _choice(row: Row, result: BuildResult, reserved: Iterable[Address]) -> Iterator[str]:
    """Why clickgen takes this address: it is the first, or for its own cells the last, that is free."""
    bank = BANKS[row.address.bank]
    if row in result.scratch_rows:
        yield f"clickgen takes it for itself, the highest free address of {bank.name}: {row.comment}"
        return
    yield f"clickgen chooses it, the lowest free address of {bank.name}; clickgen build writes it into the table"
    below = [number for number in bank.numbers() if number < row.address.number]
    if below:
        taken = _taken(bank.name, result, reserved)
        counts = Counter(taken.get(number, "taken otherwise") for number in below)
        reasons = ", ".join(f"{count} {reason}" for reason, count in counts.items())
        yield f"below it {counted(len(below), 'address is', 'addresses are')} not free: {reasons}"


def _taken(bank: str, result: BuildResult, reserved: Iterable[Address]) -> dict[int, str]:
    """Why numbers of a bank are not free; the first reason counts."""
    taken: dict[int, str] = {}
    new = {row.address for row in result.placed_rows}
    for row in result.rows:
        if row.address.bank == bank:
            why = "by names that came before in the program" if row.address in new else "by the table"
            taken.setdefault(row.address.number, why)
    for address in reserved:
        if address.bank == bank:
            taken.setdefault(address.number, "by the settings")
    for block in marked_blocks(result.address_table).values():
        if block.bank == bank:
            taken |= {number: "by blocks" for number in range(block.first, block.last + 1) if number not in taken}
    for use in result.facts.uses.every if result.facts else ():
        for name, first, last in extents_of(use.operand):
            if name == bank:
                taken |= {n: "by numbers in the program" for n in range(first, last + 1) if n not in taken}
    return taken


def _block_lines(name: str, result: BuildResult) -> list[str]:
    block = marked_blocks(result.address_table).get(name.lower())
    if block is None:
        return []
    return [
        f"{block.name} is the block {block}, {block.size} addresses",
        f"  marked in {block.said_by}",
        f"  {block.bank.lower()}.{block.name}[0] is {Address(block.bank, block.first)}",
    ]


def _places(uses: Iterable[Use]) -> Iterator[str]:
    for word, is_written in (("written", True), ("read", False)):
        places = list(dict.fromkeys(_place(use) for use in uses if use.is_written is is_written))
        if places:
            more = f" and {len(places) - _PLACES} more" if len(places) > _PLACES else ""
            yield f"{word} in {', '.join(places[:_PLACES])}{more}"


def _place(use: Use) -> str:
    span = use.operand.span
    return f"{span.path}:{span.line}" + (f" ({use.action.spec.name})" if use.action else "")
