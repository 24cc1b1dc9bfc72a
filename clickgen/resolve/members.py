"""Turns members of blocks into addresses: ``ds.Recipe[3]`` a cell, ``ds.Recipe[0:10]`` and ``ds.Recipe`` a range."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from clickgen.device.banks import BANKS, Address
from clickgen.dialects.base import Spelling
from clickgen.ir.conditions import Contact
from clickgen.ir.operands import WHOLE, Cell, Immediate, Named, Operand, Range, Section, Single
from clickgen.ir.program import Operands, Program, Value
from clickgen.ir.proposals import Proposal
from clickgen.ir.walk import Rewriter
from clickgen.problems.diagnostics import Diagnostics, Suggestions
from clickgen.table.address_table import AddressTable
from clickgen.table.blocks import Block, unclosed_block


def without_members(
    program: Program, blocks: Mapping[str, Block], table: AddressTable, spell: Spelling, problems: Diagnostics
) -> Program:
    """Return the program with addresses in place of blocks and their members.

    A reference to no member stays a ``Named`` with a part, and has its problem. If a nickname is spelled like a block,
    the bare name is the nickname's.
    """
    return _Members(blocks, table, spell, problems).program(program)


def proposal_without_members(
    proposal: Proposal, blocks: Mapping[str, Block], table: AddressTable, spell: Spelling
) -> Proposal:
    """Do the same for a proposal, which is not part of the program: faults in its members are not reported."""
    return _Members(blocks, table, spell, Diagnostics()).proposal(proposal)


class _Members(Rewriter):
    def __init__(
        self, blocks: Mapping[str, Block], table: AddressTable, spell: Spelling, problems: Diagnostics
    ) -> None:
        self._spell = spell
        self._blocks = blocks
        self._table = table
        self._problems = problems
        self._near = Suggestions()

    # -- the place of an operand --------------------------------------------------------------------------------------

    def cell(self, cell: Named | Cell) -> Named | Cell:
        """Resolve where one address is expected."""
        found = self._found(cell)
        if isinstance(found, Range):
            assert isinstance(cell, Named)
            shown = self._spell.operand(cell)
            block = self._spell.operand(replace(cell, part=None))
            return self._refused(
                cell, f"{shown} is a block of {len(found)} where one address stands", self._spell.member(block, 0)
            )
        return found

    def operand(self, operand: Operand) -> Operand:
        """Resolve where one address or a range is expected."""
        if isinstance(operand, Named):
            return self._found(operand)
        if isinstance(operand, Immediate) and isinstance(operand.target, Named):
            return Immediate(self._found(operand.target), operand.span)
        return super().operand(operand)

    def contact(self, contact: Contact) -> Contact:
        """Resolve a contact: an edge belongs to one bit."""
        if contact.edge and isinstance(contact.operand, Named):
            return replace(contact, operand=self.cell(contact.operand))
        return super().contact(contact)

    def value(self, value: Value) -> Value:
        if not isinstance(value, Operands):
            return super().value(value)
        items: list[Single] = []
        for item in value.items:
            found = self._found(item) if isinstance(item, Named) else self.single(item)
            if isinstance(found, Range):
                items += [Cell(address, found.span) for address in found.addresses()]
            else:
                items.append(found)
        return Operands(tuple(items), value.span)

    def sum_range(self, operand: Range | Named) -> Range | Named:
        if isinstance(operand, Range):
            return operand
        found = self._found(operand)
        return found if isinstance(found, Range | Named) else self._refused(operand, "SUM adds up one range", self._sum)

    # -- what it is ---------------------------------------------------------------------------------------------------

    def _found(self, named: Named | Cell) -> Named | Cell | Range:
        if isinstance(named, Cell):
            return named
        block = self._blocks.get(named.name.lower())
        if named.part is None and (block is None or named.name.lower() in self._table.by_nickname):
            return named
        if block is None:
            return self._refused(named, *self._no_block(named))
        if not block.is_seen_as(named.bank):
            shown = self._spell.name(block.bank, block.name)
            return self._refused(named, f"{block.name} is the block {shown}, {block}", f"write {shown}")
        return self._member(named, block)

    def _member(self, named: Named, block: Block) -> Named | Cell | Range:
        part = WHOLE if named.part is None else named.part
        shown = self._spell.operand(replace(named, part=None))
        bounds = [part] if isinstance(part, int) else [bound for bound in (part.start, part.stop) if bound is not None]
        beyond = block.size - (1 if isinstance(part, int) else 0)
        if any(not -1 <= bound <= beyond for bound in bounds):
            ends = (self._spell.member(shown, index) for index in (0, block.size - 1))
            count = f"{block.size} members, {' to '.join(ends)}"
            return self._refused(named, f"{shown} has {count}", f"it is {block} ({block.said_by})")
        if isinstance(part, int):
            number = block.first + (part if part >= 0 else block.size - 1)
            missing = self._missing(named, number, number)
            return missing or Cell(Address(named.bank, number), named.span)
        return self._section(named, block, part)

    def _section(self, named: Named, block: Block, part: Section) -> Named | Range:
        if part.step not in (1, -1):
            return self._refused(
                named,
                "a range takes every address",
                f"leave the step out, or write {self._spell.backwards} for backwards",
            )
        indices = range(block.size)[slice(*part)]
        if not indices:
            return self._refused(named, "this part of the block is empty", self._spell.range_end)
        first, last = block.first + indices[0], block.first + indices[-1]
        return self._missing(named, first, last) or Range(named.bank, first, last, named.span)

    def _missing(self, named: Named, first: int, last: int) -> Named | None:
        """Refuse a member that CLICK does not have: a mark may span a gap of X or Y."""
        bank = BANKS[named.bank]
        missing = next((n for n in range(min(first, last), max(first, last) + 1) if not bank.has(n)), None)
        if missing is None:
            return None
        message = f"{self._spell.operand(named)} is no address: there is no {Address(bank.name, missing)}"
        return self._refused(named, message, f"{bank.name} has {bank.describe_range()}")

    def _no_block(self, named: Named) -> tuple[str, str]:
        shown = self._spell.operand(replace(named, part=None))
        row = unclosed_block(self._table, named.name)
        if row is not None:
            place = self._table.place(row)
            return f"the block {named.name} in {place} has no end", f"mark its last address </{named.name}>"
        known = self._near(named.name, [block.name for block in self._blocks.values()])
        return f"{shown} is no block", known or f"declare it: {self._declared(shown, named.bank)}"

    def _declared(self, shown: str, bank: str) -> str:
        return self._spell.declaration(shown, self._spell.range(bank, 1, 10))

    @property
    def _sum(self) -> str:
        return f"SUM({self._spell.range('DS', 1, 10)}) adds up DS1 to DS10; or name a block"

    def _refused(self, named: Named, message: str, help: str) -> Named:
        self._problems.add("CG214", named.span, message, help)
        return replace(named, part=WHOLE)
