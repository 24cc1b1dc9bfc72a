"""``nickname(ds.Recipe, ds[100:150])``: a block declared in the source, and the rows that mark it in the table."""

from __future__ import annotations

from bisect import bisect_left, bisect_right, insort
from collections.abc import Iterable
from dataclasses import replace
from operator import itemgetter
from typing import NamedTuple

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address
from clickgen.device.nicknames import comment_fault, nickname_fault
from clickgen.dialects.base import Spelling
from clickgen.ir.program import BlockDeclaration
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.resolve.declare import Declared, initial_of, rename_command
from clickgen.table.address_table import AddressTable
from clickgen.table.blocks import Block, Mark, Marks, mark_in, marked, read_marks
from clickgen.table.rows import Row, default_row, looks_like_scratch

_OVERLAPS_MAX = 8
"""A block is reported as overlapping with at most this many that begin before it."""


def declare_blocks(
    declarations: Iterable[BlockDeclaration],
    table: AddressTable,
    declared: Declared,
    spell: Spelling,
    problems: Diagnostics,
) -> dict[str, Block]:
    """Return every block, including those that the table marks, by lowercase name; rows go to ``declared``."""
    marks = read_marks(table)
    reader = _Blocks(table, marks, declared, spell, problems)
    for declaration in declarations:
        reader.read(declaration)
    reader.hand_over()
    _warn_of_marks(marks, reader.named, table, spell, problems)
    _warn_of_overlaps({**marks.blocks, **reader.own}.values(), problems)
    return reader.blocks


class _Fault(NamedTuple):
    """An objection to a block, the way out, and where."""

    message: str
    help: str
    labels: tuple[Label, ...] = ()


class _Blocks:
    def __init__(
        self, table: AddressTable, marks: Marks, declared: Declared, spell: Spelling, problems: Diagnostics
    ) -> None:
        self.table = table
        self.spell = spell
        self.declared = declared
        self.problems = problems
        self.marks = marks
        self.blocks = dict(marks.blocks)
        self.rows: dict[Address, Row] = {row.address: row for row in declared.rows}
        self.own: dict[str, Block] = {}
        self._places: dict[str, list[tuple[int, str]]] = {}
        """The beginnings of own blocks, by bank and in order, with their lowercase names: no two of them overlap."""
        self._given = {row.address: row for row in table.base}
        self._marks_at: dict[Address, list[int]] = {}
        self._marks_of: dict[tuple[str, str], list[int]] = {}
        for index, (row, mark) in enumerate(marks.rows):
            self._marks_at.setdefault(row.address, []).append(index)
            self._marks_of.setdefault((row.address.bank, mark.name.lower()), []).append(index)
        self.named: set[str] = set()
        """The lowercase names of all declarations, including wrong ones."""

    def read(self, declaration: BlockDeclaration) -> None:
        named, range = declaration.named, declaration.range
        block = Block(named.name, range.bank, range.first, range.last, self.spell.declaration(), declaration.span)
        lower = named.name.lower()
        self.declared.addresses += block.addresses()
        self.named.add(lower)
        fault = self._name_fault(block.name)
        if fault is not None:
            self.problems.add("CG203", named.span, *fault)
            self._know(block)
            return
        fault = self._fault(declaration, block)
        if fault is not None:
            self.problems.add("CG205", declaration.span, *fault)
            if named.bank == block.bank:
                self._know(block)
            return
        self.blocks[lower] = self.own[lower] = block
        insort(self._places.setdefault(block.bank, []), (block.first, lower))
        self._set_up(declaration, block)
        self._mark(declaration, block)

    def hand_over(self) -> None:
        """Add the rows that say something new to ``declared``."""
        if self.own:
            self.declared.rows = [row for row in self.rows.values() if self._is_news(row)]

    def _know(self, block: Block) -> None:
        """Record a block, even a wrong one, so that its members have no problem of their own."""
        lower = block.name.lower()
        if lower not in self.declared.meanings and lower not in self.table.by_nickname:
            self.blocks.setdefault(lower, block)

    def _name_fault(self, name: str) -> _Fault | None:
        """A block follows the rules of nicknames, or has a name that the table marks already."""
        if name.lower() in self.marks.blocks:
            return None
        if looks_like_scratch(name):
            return _Fault(f"clickgen keeps names like {name} for its own cells", "choose another name")
        fault = nickname_fault(name)
        if fault is None and not any(character.isalpha() for character in name):
            fault = "it has no letter"
        if fault is None:
            return None
        return _Fault(f"{name!r} cannot be the name of a block: {fault}", "choose another name")

    def _fault(self, declaration: BlockDeclaration, block: Block) -> _Fault | None:
        named, lower = declaration.named, block.name.lower()
        if named.bank != block.bank:
            written = self.spell.name(named.bank, block.name)
            return _Fault(f"{written} cannot be {block}", f"write {self.spell.name(block.bank, block.name)}")
        if BANKS[block.bank].settings_fixed:
            return _Fault(f"{block.bank} has no blocks: CLICK takes no comments there", "write the range itself")
        other = self.own.get(lower) or self._met(block)
        if other is not None:
            message = f"{block.name} and the block {other.name}, {other}, meet"
            return _Fault(message, "give each its own name and addresses", _label(other))
        stands = self.blocks.get(lower)
        if stands is not None and (stands.bank, stands.first, stands.last) != (block.bank, block.first, block.last):
            message = f"{block.name} is {block} here and {stands} in {stands.said_by}"
            return _Fault(message, "change one of them; a PLC keeps its data by address", _label(stands))
        meaning = self.declared.meanings.get(lower)
        row = self.table.by_nickname.get(lower)
        if meaning is not None or row is not None:
            place = self.table.place(row) if row else f"another {self.spell.declaration()}"
            return _Fault(f"{block.name} is the nickname of one address in {place}", "give the block another name")
        return self._mark_in_the_way(block)

    def _met(self, block: Block) -> Block | None:
        """The first own block that shares an address with this one."""
        places = self._places.get(block.bank, [])
        at = bisect_right(places, (block.first, "\uffff"))
        near = (self.own[lower] for _, lower in places[max(at - 1, 0) : at + 1])
        return next((other for other in near if other.meets(block)), None)

    def _mark_in_the_way(self, block: Block) -> _Fault | None:
        """A mark of another block where this one begins or ends, or one of this name anywhere else."""
        first, last = block.addresses()[0], block.addresses()[-1]
        named = self._marks_of.get((block.bank, block.name.lower()), ())
        for index in sorted({*self._marks_at.get(first, ()), *self._marks_at.get(last, ()), *named}):
            row, mark = self.marks.rows[index]
            due = (row.address == first, row.address == last)
            is_same = mark.name.lower() == block.name.lower() and row.address.bank == block.bank
            if (is_same or any(due)) and not (is_same and due == (mark.opens, mark.closes)):
                where = f"the comment of {row.address} is marked <{mark.word}> in {self.table.place(row)}"
                help = f"take the marks of {mark.name} out of the comments, or leave the block as these marks have it"
                if self._is_other_name_of(block, mark.name):
                    renamed = rename_command(mark.name, block.name)
                    help = f"if {block.name} is {mark.name} by another name: {renamed}; if not, {help}"
                span = self.table.span(row)
                labels = (Label(span, "this mark"),) if span else ()
                return _Fault(f"{block.name} is {block} here, and {where}", help, labels)
        return None

    def _is_other_name_of(self, block: Block, name: str) -> bool:
        """True if the table has exactly these addresses as a block of this name."""
        marked = self.marks.blocks.get(name.lower())
        return (
            marked is not None
            and name.lower() != block.name.lower()
            and (marked.bank, marked.first, marked.last) == (block.bank, block.first, block.last)
        )

    def _set_up(self, declaration: BlockDeclaration, block: Block) -> None:
        """Set initial value and retention for every member."""
        if declaration.initial is None and declaration.retentive is None:
            return
        initial = initial_of(declaration.initial, block.addresses()[0], self.problems) if declaration.initial else None
        for address in block.addresses():
            row = self._row(address)
            row = row if initial is None else replace(row, initial=initial)
            self.rows[address] = row if declaration.retentive is None else replace(row, retentive=declaration.retentive)

    def _mark(self, declaration: BlockDeclaration, block: Block) -> None:
        """Mark both ends of a block; neither if one is a row of the workbook, which nobody writes."""
        first, last = block.addresses()[0], block.addresses()[-1]
        rows = [self._opened(declaration, block, self._row(first))]
        if first != last:
            row = self._row(last)
            rows.append(replace(row, comment=marked(row.comment, block.name, False, True)))
        given = self._given
        if all(row.address not in given or row.comment == given[row.address].comment for row in rows):
            for row in rows:
                self._keep(declaration, row)

    def _opened(self, declaration: BlockDeclaration, block: Block, row: Row) -> Row:
        """The first row, with its mark and the declaration's settings."""
        text = ""
        if declaration.comment is not None:
            mark = mark_in(row.comment)
            is_own = mark is not None and mark.name.lower() == block.name.lower()
            row = replace(row, comment=f"<{mark.word}>" if mark and is_own else "")
            text = declaration.comment
        return replace(row, comment=marked(row.comment, block.name, True, block.size == 1) + text)

    def _keep(self, declaration: BlockDeclaration, row: Row) -> None:
        fault = comment_fault(row.comment)
        if fault is not None:
            message = f"with the mark of the block the comment of {row.address} is not CLICK's: {fault}"
            self.problems.add("CG203", declaration.span, message, "shorten the comment")
            return
        self.rows[row.address] = row

    def _row(self, address: Address) -> Row:
        stands = self.rows.get(address) or self.table.by_address.get(address) or default_row(address, "")
        return replace(stands, line=0, raw="")

    def _is_news(self, row: Row) -> bool:
        stands = self.table.by_address.get(row.address)
        return not row.is_default if stands is None else stands.content != row.content


def _label(block: Block) -> tuple[Label, ...]:
    return (Label(block.span, "this one"),) if block.span else ()


# -- marks in the table that do not fit -------------------------------------------------------------------------------


def _warn_of_marks(
    marks: Marks, declared: set[str], table: AddressTable, spell: Spelling, problems: Diagnostics
) -> None:
    """Warn of marks that make no block, and of blocks that cannot be meant so. A declaration judges its own name."""
    for row, mark in marks.halves:
        if mark.name.lower() not in declared:
            problems.add("CG606", table.span(row), *_half(row.address, mark))
    for block, other in marks.doubles:
        # In CLICK the rows of T and TD alternate: a block over both is marked in both
        # (click-facts [nickname-file.interleaved]).
        if block.name.lower() not in declared and CURRENT_VALUE_OF.get(block.bank) != other.bank:
            message = f"a second block {block.name}, {block}, is marked: {other} is it in {other.said_by}, and counts"
            problems.add("CG606", block.span, message, "give one of the two another name in both of its marks")
    for lower, block in marks.blocks.items():
        if lower in table.by_nickname:
            row = table.by_nickname[lower]
            dotted = spell.name(block.bank, block.name)
            problems.add(
                "CG429",
                table.span(row),
                f"{row.nickname} is the nickname of {row.address} and the name of the block {block}, which "
                f"{block.said_by} marks: {dotted} alone is {row.address}, and {spell.member(dotted, 0)} is "
                f"{Address(block.bank, block.first)}",
                "give one of the two another name: the nickname, or the block in both of its marks",
                _label(block),
            )
        gap = BANKS[block.bank].gap_in(block.first, block.last)
        if gap is not None:
            missing = Address(block.bank, gap)
            message = f"the block {block.name}, {block}, spans addresses that CLICK does not have, such as {missing}"
            help = f"{block.bank} has {BANKS[block.bank].describe_range()}: mark a block for each part"
            problems.add("CG606", block.span, message, help)


def _half(address: Address, mark: Mark) -> tuple[str, str]:
    """The message and the way out for a mark without its other half."""
    if mark.opens:
        end, other, place = "beginning", f"</{mark.name}>", "last"
    else:
        end, other, place = "end", f"<{mark.name}>", "first"
    message = f'"<{mark.word}>" in the comment of {address} is taken for the {end} of a block, and there is no {other}'
    return message, f"mark its {place} address {other}; or take the angle brackets away where this is only text"


def _warn_of_overlaps(blocks: Iterable[Block], problems: Diagnostics) -> None:
    """Warn of blocks that overlap without nesting. There may be thousands: each is reported with a few others."""
    begun: list[tuple[int, int, Block]] = []
    """The blocks of the bank that are not over yet, by their last numbers, with their places in the order."""
    bank = ""
    for place, block in enumerate(sorted(blocks, key=lambda block: (block.bank, block.first, -block.last))):
        if block.bank != bank:
            bank, begun = block.bank, []
        del begun[: bisect_left(begun, (block.first,))]
        # Those that are over before this one is.
        for _, _, one in sorted(begun[: bisect_left(begun, (block.last,))][:_OVERLAPS_MAX], key=itemgetter(1)):
            message = f"the blocks {one.name}, {one}, and {block.name}, {block}, overlap"
            problems.add("CG606", block.span, message, "end one where the other begins", _label(one))
        insort(begun, (block.last, place, block))
