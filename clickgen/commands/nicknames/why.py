"""Explains the address of a name: where it comes from, why that one, and where the name is used."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, VALUE_BANK, Address, parse_address
from clickgen.device.system import addresses_of_system_name, doubt_about, find_system_name, system_name_of
from clickgen.dialects.base import Spelling
from clickgen.facts.uses import Use, extents_of
from clickgen.problems.diagnostics import did_you_mean
from clickgen.results import BuildResult
from clickgen.table.blocks import Block, marked_blocks
from clickgen.table.record import placed_in
from clickgen.table.rows import Row, is_scratch
from clickgen.text.wording import counted

_PLACES = 8
"""At most this many places of use are listed."""
_RUNS = 5
"""At most this many ranges of addresses are listed."""


def why(name: str, result: BuildResult, reserved: Iterable[Address], record: bytes | None) -> list[str]:
    """Explain a name or an address in a program that was built; nothing if the program knows neither.

    ``reserved`` are addresses that the settings keep free, ``record`` is the file of the names that clickgen placed.
    """
    blocks = blocks_of(result)
    meaning = _meaning(_asked(name.strip()), result, blocks)
    if meaning is None:
        return _moved_lines(_asked(name.strip()).name)
    if isinstance(meaning, Block):
        return _block_lines(meaning, result, blocks)
    return _address_lines(meaning, result, blocks, tuple(reserved), record)


def _moved_lines(name: str) -> list[str]:
    """Explain one of CLICK's own names that may mean one of several addresses."""
    return [doubt_about(name)] if addresses_of_system_name(name) else []


def suggestion(name: str, results: Iterable[BuildResult]) -> str:
    """``did you mean Motor?`` for a near miss."""
    known = [row.nickname for result in results for row in result.rows if row.nickname]
    return did_you_mean(name, [*known, *(block.name for result in results for block in blocks_of(result))])


# -- the question -----------------------------------------------------------------------------------------------------


class _Asked(NamedTuple):
    """A name or an address, with the bank before it and the index after it if the source has them."""

    name: str
    bank: str = ""
    part: int | None = None


_IN_BANK = re.compile(
    r"""(?P<bank>[A-Za-z]+)(?:\.(?P<name>\w+)|\[(?P<number>[0-9]{1,4})\]|\[(["\'])(?P<quoted>.+?)\4\])"""
    r"(?:\[(?P<part>[0-9]{1,4})\])?"
)
_MEMBER = re.compile(r"(?P<name>[^\[\]]+)\[(?P<part>[0-9]{1,4})\]")


def _asked(text: str) -> _Asked:
    """Read ``Speed``, ``DS5``, and a program's forms: ``ds.Speed``, ``ds[5]``, ``ds["Speed"]``, ``ds.Recipe[3]``."""
    match = _IN_BANK.fullmatch(text)
    bank = match["bank"].upper() if match else ""
    if match is not None and bank in BANKS:
        part = int(match["part"]) if match["part"] else None
        if match["number"] or (match["quoted"] or "").lower() == "0u":
            return _Asked(f"{bank}{match['number'] or '0u'}", bank, part)
        return _Asked(match["name"] or match["quoted"], bank, part)
    match = _MEMBER.fullmatch(text)
    return _Asked(match["name"], "", int(match["part"])) if match else _Asked(text)


def _meaning(asked: _Asked, result: BuildResult, blocks: Sequence[Block]) -> Address | Block | None:
    if asked.part is None:
        address = _seen_as(asked.bank, _address_of(asked.name, result))
        if address is not None:
            return address
    for block in blocks:
        if block.name.lower() == asked.name.lower() and (not asked.bank or block.is_seen_as(asked.bank)):
            if asked.part is None:
                return block
            number = block.first + asked.part
            return Address(asked.bank or block.bank, number) if number <= block.last else None
    return None


def _address_of(name: str, result: BuildResult) -> Address | None:
    row = next((row for row in result.rows if row.nickname and row.nickname.lower() == name.lower()), None)
    system = find_system_name(name)
    return row.address if row else system[1] if system else parse_address(name)


def _seen_as(bank: str, address: Address | None) -> Address | None:
    """The address as a bank has it: itself in its own, its current value in TD and CTD; None in any other."""
    if address is None or bank in ("", address.bank):
        return address
    return Address(bank, address.number) if CURRENT_VALUE_OF.get(bank) == address.bank else None


# -- blocks -----------------------------------------------------------------------------------------------------------


def blocks_of(result: BuildResult) -> list[Block]:
    """The blocks of the program and those of the table; one that both have comes twice, first as it is declared."""
    program = result.facts.program if result.facts else None
    spell = result.dialect.spell
    declared = [
        Block(
            each.named.name,
            each.range.bank,
            each.range.first,
            each.range.last,
            f"declared by {spell.declaration()} in {each.span}",
            each.span,
        )
        for each in (program.blocks if program else ())
    ]
    # A mark without a place is one that the build is about to write.
    marked = [block for block in marked_blocks(result.address_table).values() if block.span is not None]
    return [*declared, *(block._replace(said_by=f"marked in {block.said_by}") for block in marked)]


def _block_lines(block: Block, result: BuildResult, blocks: Iterable[Block]) -> list[str]:
    first = Address(block.bank, block.first)
    said_by = [other.said_by for other in blocks if other.name.lower() == block.name.lower()]
    uses = [use for use in _every_use(result) if _is_in(use, block)]
    lines = [*said_by, f"{_member(result.dialect.spell, block, first)} is {first}", *_places(uses)]
    return [
        f"{block.name} is the block {block}, {counted(block.size, 'address', 'addresses')}",
        *(f"  {line}" for line in lines),
    ]


def _is_in(use: Use, block: Block) -> bool:
    return any(
        block.is_seen_as(bank) and first <= block.last and block.first <= last
        for bank, first, last in extents_of(use.operand)
    )


def _memberships(spell: Spelling, address: Address, blocks: Iterable[Block]) -> Iterator[str]:
    told: set[str] = set()
    for block in blocks:
        is_inside = block.is_seen_as(address.bank) and block.first <= address.number <= block.last
        if is_inside and block.name.lower() not in told:
            told.add(block.name.lower())
            yield f"{_member(spell, block, address)} of the block {block.name}, {block}, {block.said_by}"


def _member(spell: Spelling, block: Block, address: Address) -> str:
    return spell.member(spell.name(address.bank, block.name), address.number - block.first)


def _every_use(result: BuildResult) -> Sequence[Use]:
    return result.facts.uses.every if result.facts else ()


# -- addresses --------------------------------------------------------------------------------------------------------


def _address_lines(
    address: Address,
    result: BuildResult,
    blocks: Sequence[Block],
    reserved: Sequence[Address],
    record: bytes | None,
) -> list[str]:
    rows = {row.address: row for row in result.rows}
    row = rows.get(address)
    bit = rows.get(Address(CURRENT_VALUE_OF.get(address.bank, ""), address.number))
    own = _own_name(result.dialect.spell, address, row, bit)
    uses = result.facts.uses.at(address) if result.facts else []
    members = list(_memberships(result.dialect.spell, address, blocks))
    if not own and not members and row is None and not uses:
        return [f"{address} has no name and {result.program} does not use it"]
    lines = [*members, *_origin(address, row, result, blocks, reserved, record)]
    if bit is not None and bit.nickname:
        lines.append(f"the current value of {bit.nickname}, {bit.address}")
        lines += _origin(bit.address, bit, result, blocks, reserved, record)
    lines += _places(uses)
    if row is None and not uses and system_name_of(address) is None:
        lines.append(f"{result.program} does not use it")
    return [_head(address, own, row), *(f"  {line}" for line in lines)]


def _own_name(spell: Spelling, address: Address, row: Row | None, bit: Row | None) -> str:
    """The nickname of an address; for a current value without one ``td.Pause``, by the nickname of its bit."""
    own = (row.nickname if row else "") or system_name_of(address) or ""
    return own or (spell.name(address.bank, bit.nickname) if bit and bit.nickname else "")


def _head(address: Address, own: str, row: Row | None) -> str:
    what = f"{own} is {address}" if own else f"{address} has no nickname"
    bank = BANKS[address.bank]
    settings = [bank.kind.value]
    if row is not None and not bank.settings_fixed:
        settings += ["retentive" if row.retentive else "not retentive", f"initial value {row.initial or 'empty'}"]
    comment = f": {row.comment}" if row and row.comment else ""
    return f"{what} ({', '.join(settings)}){comment}"


def _origin(
    address: Address,
    row: Row | None,
    result: BuildResult,
    blocks: Sequence[Block],
    reserved: Sequence[Address],
    record: bytes | None,
) -> Iterator[str]:
    program = result.facts.program if result.facts else None
    for declaration in program.declarations if program else ():
        if declaration.cell.address == address:
            yield f"declared by {result.dialect.spell.declaration()} in {declaration.span}"
    stands = result.address_table.by_address.get(address)
    if row in result.new_rows and row is not None:
        yield from _choice(row, result, blocks, reserved)
    elif stands is not None and (stands.line or stands.cell):
        placed = placed_in(record).get(address) == stands.nickname != ""
        by = "; clickgen placed it for itself" if is_scratch(stands) else "; clickgen placed it" if placed else ""
        yield f"from {result.address_table.place(stands)}{by}"
        if placed:
            yield from _left_by_settings(address, reserved)
    elif system_name_of(address):
        yield "CLICK's own name"


def _left_by_settings(address: Address, reserved: Iterable[Address]) -> Iterator[str]:
    """The addresses among which clickgen may choose in the bank, if the settings limit them."""
    bank = BANKS[address.bank]
    twins = (bank.name, VALUE_BANK.get(bank.name), CURRENT_VALUE_OF.get(bank.name))
    closed = {one.number for one in reserved if one.bank in twins}
    if address.number in closed:
        yield f"by the settings of today clickgen would not choose {address}"
    elif closed:
        runs = _runs(bank.name, (number for number in bank.numbers() if number not in closed))
        more = f" and {len(runs) - _RUNS} more" if len(runs) > _RUNS else ""
        yield f"the settings let clickgen choose in {', '.join(runs[:_RUNS])}{more}"


def _runs(bank: str, numbers: Iterable[int]) -> list[str]:
    """Numbers in order as stretches: ``DS1..DS99``, ``DS200``."""
    stretches: list[tuple[int, int]] = []
    for number in numbers:
        if stretches and stretches[-1][1] == number - 1:
            stretches[-1] = (stretches[-1][0], number)
        else:
            stretches.append((number, number))
    ends = ((Address(bank, first), Address(bank, last)) for first, last in stretches)
    return [str(first) if first == last else f"{first}..{last}" for first, last in ends]


def _choice(row: Row, result: BuildResult, blocks: Sequence[Block], reserved: Iterable[Address]) -> Iterator[str]:
    """The reason why clickgen takes this address: it is the first free one, or for its own cells the last."""
    bank = BANKS[row.address.bank]
    if row in result.scratch_rows:
        yield f"clickgen takes it for itself, the highest free address of {bank.name}: {row.comment}"
        return
    yield f"clickgen chooses it, the lowest free address of {bank.name}; clickgen build writes it into the table"
    below = [number for number in bank.numbers() if number < row.address.number]
    if below:
        taken = _taken(bank.name, result, blocks, reserved)
        counts = Counter(taken.get(number, "taken otherwise") for number in below)
        reasons = ", ".join(f"{count} {reason}" for reason, count in counts.items())
        yield f"below it {counted(len(below), 'address is', 'addresses are')} not free: {reasons}"


def _taken(bank: str, result: BuildResult, blocks: Iterable[Block], reserved: Iterable[Address]) -> dict[int, str]:
    """The reasons why numbers of a bank are not free; the first reason counts."""
    taken: dict[int, str] = {}
    new = {row.address for row in result.placed_rows}
    for row in result.rows:
        if row.address.bank == bank:
            why = "by names that came before in the program" if row.address in new else "by the table"
            taken.setdefault(row.address.number, why)
    for address in reserved:
        if address.bank == bank:
            taken.setdefault(address.number, "by the settings")
    for block in blocks:
        if block.bank == bank:
            taken |= {number: "by blocks" for number in range(block.first, block.last + 1) if number not in taken}
    for use in _every_use(result):
        for name, first, last in extents_of(use.operand):
            if name == bank:
                taken |= {n: "by numbers in the program" for n in range(first, last + 1) if n not in taken}
    return taken


def _places(uses: Iterable[Use]) -> Iterator[str]:
    for word, is_written in (("written", True), ("read", False)):
        places = list(dict.fromkeys(_place(use) for use in uses if use.is_written is is_written))
        if places:
            more = f" and {len(places) - _PLACES} more" if len(places) > _PLACES else ""
            yield f"{word} in {', '.join(places[:_PLACES])}{more}"


def _place(use: Use) -> str:
    span = use.operand.span
    return f"{span.path}:{span.line}" + (f" ({use.action.spec.name})" if use.action else "")
