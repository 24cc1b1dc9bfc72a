"""``nickname(ds.Recipe, ds[100:150])``: a block declared in the source, and the rows that mark it in the table."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from clickgen.device.banks import BANKS, Address
from clickgen.device.nicknames import comment_fault
from clickgen.diagnostics import Diagnostics, Label
from clickgen.ir.program import BlockDeclaration
from clickgen.resolve.blocks import Block, mark_in, marked, marked_blocks
from clickgen.resolve.declare import Declared, initial_of
from clickgen.resolve.rows import Row, default_row
from clickgen.resolve.table import AddressTable


def declare_blocks(
    declarations: Iterable[BlockDeclaration], table: AddressTable, declared: Declared, problems: Diagnostics
) -> dict[str, Block]:
    """Every block, those that the table marks among them, by lowercase name; rows go to ``declared``."""
    reader = _Blocks(table, declared, problems)
    for declaration in declarations:
        reader.read(declaration)
    return reader.blocks


class _Blocks:
    def __init__(self, table: AddressTable, declared: Declared, problems: Diagnostics) -> None:
        self.table = table
        self.declared = declared
        self.problems = problems
        self.blocks = marked_blocks(table)
        self.rows: dict[Address, Row] = {row.address: row for row in declared.rows}
        self.own: dict[str, Block] = {}

    def read(self, declaration: BlockDeclaration) -> None:
        named, range = declaration.named, declaration.range
        block = Block(named.name, range.bank, range.first, range.last, "nickname(...)", declaration.span)
        self.declared.addresses += block.addresses()
        fault = self._fault(declaration, block)
        if fault is not None:
            message, help, label = fault
            self.problems.add("CG205", declaration.span, message, help, label)
            return
        self.blocks[named.name.lower()] = self.own[named.name.lower()] = block
        self._set_up(declaration, block)
        self._mark(declaration, block)
        self.declared.rows = [row for row in self.rows.values() if self._is_news(row)]

    def _fault(self, declaration: BlockDeclaration, block: Block) -> tuple[str, str, tuple[Label, ...]] | None:
        """What stands against a block, the way out, and where."""
        named, lower = declaration.named, block.name.lower()
        if named.bank != block.bank:
            dotted = f"{named.bank.lower()}.{block.name}"
            return f"{dotted} cannot be {block}", f"write {block.bank.lower()}.{block.name}", ()
        if BANKS[block.bank].settings_fixed:
            return f"{block.bank} has no blocks: CLICK takes no comments there", "write the range itself", ()
        other = self.own.get(lower) or self._overlapping(block)
        if other is not None:
            return (
                f"{block.name} and the block {other.name}, {other}, meet",
                "give each its own name and addresses",
                (_label(other)),
            )
        stands = self.blocks.get(lower)
        if stands is not None and (stands.bank, stands.first, stands.last) != (block.bank, block.first, block.last):
            message = f"{block.name} is {block} here and {stands} in {stands.said_by}"
            return message, "change one of them; a PLC keeps its data by address", _label(stands)
        meaning = self.declared.meanings.get(lower)
        row = self.table.by_nickname.get(lower)
        if meaning is not None or row is not None:
            place = self.table.place(row) if row else "another nickname(...)"
            return f"{block.name} is the nickname of one address in {place}", "give the block another name", ()
        return None

    def _overlapping(self, block: Block) -> Block | None:
        return next(
            (
                other
                for other in self.own.values()
                if other.bank == block.bank and other.first <= block.last and block.first <= other.last
            ),
            None,
        )

    def _set_up(self, declaration: BlockDeclaration, block: Block) -> None:
        """Initial value and retention hold for every member."""
        if declaration.initial is None and declaration.retentive is None:
            return
        initial = initial_of(declaration.initial, block.addresses()[0], self.problems) if declaration.initial else None
        for address in block.addresses():
            row = self._row(address)
            row = row if initial is None else replace(row, initial=initial)
            self.rows[address] = row if declaration.retentive is None else replace(row, retentive=declaration.retentive)

    def _mark(self, declaration: BlockDeclaration, block: Block) -> None:
        first, last = block.addresses()[0], block.addresses()[-1]
        row = self._row(first)
        if declaration.comment is not None:
            mark = mark_in(row.comment)
            row = replace(row, comment=f"<{mark.word}>" if mark and mark.name == block.name else "")
            text = declaration.comment
        else:
            text = ""
        self._keep(declaration, replace(row, comment=marked(row.comment, block.name, True, first == last) + text))
        if first != last:
            row = self._row(last)
            self._keep(declaration, replace(row, comment=marked(row.comment, block.name, False, True)))

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
