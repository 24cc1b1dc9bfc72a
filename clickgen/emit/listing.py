"""listing.txt: the program as a person reads it and as ``git diff`` shows it.

Nothing in it changes without the program changing: no dates, no source lines, rungs numbered in each routine.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from operator import itemgetter

from clickgen.click.draw.tokens import operand_token
from clickgen.device.banks import UPPER_BYTE_BANKS, Address, parse_address
from clickgen.emit.built import BuiltProgram
from clickgen.emit.rung_words import Names, condition_lines, item_lines
from clickgen.emit.uses import RungUse, known_numbers
from clickgen.emit.writer import one_file
from clickgen.facts.uses import extents_of
from clickgen.ir.operands import Cell, Pointer, Range
from clickgen.lower.split import ClickRung
from clickgen.text.wording import counted, escaped

_HEAD = "CLICK program "


def listing(built: BuiltProgram) -> str:
    """The whole listing: counts, every routine rung by rung, and the cross-reference."""
    lines = [_HEAD + escaped(built.name), ""]
    width = max(len(routine.name) for routine in built.routines)
    for routine in built.routines:
        rows = sum(len(rung.grid) for rung in routine.rungs)
        lines.append(f"  {routine.name:<{width}}  {counted(len(routine.rungs), 'rung')}, {counted(rows, 'row')}")
    for routine in built.routines:
        lines += ["", "", routine.name, "=" * len(routine.name)]
        for number, rung in enumerate(routine.rungs, 1):
            lines += ["", *_rung(number, rung, built.names)]
    lines += ["", "", "Cross-reference", "===============", ""]
    lines += _cross_reference(built)
    return "\n".join(lines) + "\n"


def _rung(number: int, rung: ClickRung, names: Names) -> Iterator[str]:
    yield f"Rung {number}"
    for line in rung.comment.split("\n") if rung.comment else ():
        yield f"  | {line}".rstrip()
    yield from condition_lines("  ", rung.condition, names)
    yield from item_lines("    ", rung.items, names)


# -- cross-reference --------------------------------------------------------------------------------------------------


@dataclass
class _Uses:
    written: dict[str, list[int]] = field(default_factory=dict)
    read: dict[str, list[int]] = field(default_factory=dict)

    def add(self, use: RungUse) -> None:
        rungs = (self.written if use.is_written else self.read).setdefault(use.routine, [])
        if not rungs or rungs[-1] != use.rung:
            rungs.append(use.rung)


_Key = tuple[tuple[int, int, bool], int, str]
"""Sorts addresses in CLICK's order, a range after its first address, a pointer before its bank."""


class _CrossReference:
    """``known`` has, by bank, the numbers that get a line of their own where a range or a word leads to them."""

    def __init__(self, known: Mapping[str, Sequence[int]]) -> None:
        self._known = known
        self._cells: dict[Address, _Uses] = {}
        self._others: dict[_Key, _Uses] = {}

    @property
    def uses(self) -> list[tuple[_Key, _Uses]]:
        """The lines in their order."""
        cells = (((address.sort_key, 0, str(address)), uses) for address, uses in self._cells.items())
        return sorted((*cells, *self._others.items()), key=itemgetter(0))

    def add(self, use: RungUse) -> None:
        operand = use.target
        if isinstance(operand, Cell):
            self._note_cell(operand.address, use)
            if operand.address.bank not in UPPER_BYTE_BANKS:
                return  # Only a word holds points.
        elif isinstance(operand, Range):
            low, high = sorted((operand.first, operand.last))
            first, length = Address(operand.bank, low), high - low + 1
            if length == 1:
                self._note_cell(first, use)
            else:
                self._note((first.sort_key, length - 1, f"{first}..{Address(operand.bank, high)}"), use)
        elif isinstance(operand, Pointer):
            self._note((Address(operand.bank, -1).sort_key, 0, operand_token(operand)), use)
        for index, (bank, low, high) in enumerate(extents_of(operand)):
            # The first extent is the operand's own; the others are the points that its words hold.
            if index or low < high:
                for number in self._known_in(bank, low, high):
                    self._note_cell(Address(bank, number), use)

    def _known_in(self, bank: str, low: int, high: int) -> Sequence[int]:
        numbers = self._known.get(bank, ())
        return numbers[bisect_left(numbers, low) : bisect_left(numbers, high + 1)]

    def _note_cell(self, address: Address, use: RungUse) -> None:
        uses = self._cells.get(address)
        if uses is None:
            uses = self._cells[address] = _Uses()
        uses.add(use)

    def _note(self, key: _Key, use: RungUse) -> None:
        uses = self._others.get(key)
        if uses is None:
            uses = self._others[key] = _Uses()
        uses.add(use)


def _cross_reference(built: BuiltProgram) -> list[str]:
    uses, names = built.uses.every, built.names
    table = _CrossReference(known_numbers(names, uses))
    for use in uses:
        table.add(use)
    rows = [("Address", "Nickname", "Written", "Read")]
    for key, found in table.uses:
        _, length, text = key
        address = parse_address(text) if length == 0 else None
        nickname = names.nickname(address) if address else ""
        rows.append((text, nickname, _places(found.written), _places(found.read)))
    widths = [max(len(row[column]) for row in rows) for column in range(2)]
    return [f"{row[0]:<{widths[0]}}  {row[1]:<{widths[1]}}  {row[2] or '-'} | {row[3] or '-'}" for row in rows]


def _places(uses: Mapping[str, list[int]]) -> str:
    return "; ".join(f"{routine} {', '.join(map(str, rungs))}" for routine, rungs in uses.items())


WRITER = one_file("listing.txt", listing, lambda data: data.startswith(_HEAD.encode()), rank=30)
