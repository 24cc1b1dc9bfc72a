"""nickname(...) in the source: it comes before every other source of an address, and must agree with the table."""

from __future__ import annotations

import shlex
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from clickgen.device.banks import BANKS, FLOAT_MAX, INTEGER_RANGES, UPPER_BYTE_BANKS, Address, Kind
from clickgen.device.nicknames import comment_fault, nickname_fault_at
from clickgen.device.system import addresses_of_system_name
from clickgen.dialects.base import Spelling
from clickgen.ir.operands import CharCode, Constant, Operand
from clickgen.ir.program import Declaration
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.resolve.constants import typed
from clickgen.table.address_table import AddressTable
from clickgen.table.blocks import mark_in
from clickgen.table.rows import Row, default_row, format_initial, looks_like_scratch
from clickgen.text.source import Span


class Meaning(NamedTuple):
    """The meaning of a nickname and who gives it; without words, the place gives it."""

    address: Address
    said_by: str
    span: Span | None


@dataclass
class Declared:
    """The declarations of a program."""

    meanings: dict[str, Meaning] = field(default_factory=dict)
    """By the lowercase name."""
    rows: list[Row] = field(default_factory=list)
    """Rows that the table lacks, or that differ there from the source."""
    misdeclared: set[str] = field(default_factory=set)
    """The lowercase names of wrong declarations: they get no other address either."""
    addresses: list[Address] = field(default_factory=list)
    """Every declared address, including those of wrong declarations: nothing is allocated there."""


def declare(
    declarations: tuple[Declaration, ...], table: AddressTable, spell: Spelling, problems: Diagnostics
) -> Declared:
    """Judge the declarations against each other, the table and CLICK's rules."""
    reader = _Declarations(table, spell, problems)
    reader.warn_of_words()
    reader.read(declarations)
    return reader.declared


class _Declarations:
    def __init__(self, table: AddressTable, spell: Spelling, problems: Diagnostics) -> None:
        self.table = table
        self.spell = spell
        self.problems = problems
        self.declared = Declared()

    def read(self, declarations: tuple[Declaration, ...]) -> None:
        by_name: dict[str, Declaration] = {}
        by_address: dict[Address, Declaration] = {}
        for declaration in declarations:
            named, address = declaration.named, declaration.cell.address
            lower = named.name.lower()
            self.declared.addresses.append(address)
            earlier = by_name.setdefault(lower, declaration)
            if earlier is not declaration:
                self._conflict(declaration, f"{named.name} is declared twice", earlier)
                continue
            earlier = by_address.setdefault(address, declaration)
            if earlier is not declaration:
                self._conflict(declaration, f"{address} is declared as {earlier.named.name} already", earlier)
                continue
            if self._declaration_is_sound(declaration):
                self.declared.meanings[lower] = Meaning(address, self.spell.declaration(), declaration.span)
                self._warn_of_word(address, named.name, declaration.span)
                row = self._declared_row(declaration)
                stands = self.table.by_address.get(address)
                if stands is None or stands.content != row.content:
                    self.declared.rows.append(row)
            else:
                self.declared.misdeclared.add(lower)

    def warn_of_words(self) -> None:
        """Warn of nicknames in the table that ClickNick's importer loses (click-facts [nickname-file.lost])."""
        for row in self.table.rows:
            if row.nickname:
                self._warn_of_word(row.address, row.nickname, self.table.span(row))

    def _warn_of_word(self, address: Address, name: str, span: Span | None) -> None:
        if address.bank in UPPER_BYTE_BANKS:
            self.problems.add(
                "CG211",
                span,
                f"{name} is the nickname of {address}: ClickNick drops XD0u and misreads other XD and YD rows",
                f"write {self.spell.pointer(address.bank, '...')} and give it no nickname, or check it in CLICK "
                "after the import",
            )

    def _conflict(self, declaration: Declaration, message: str, earlier: Declaration) -> None:
        self.problems.add(
            "CG205",
            declaration.span,
            message,
            f"the earlier one: {earlier.span}",
            (Label(earlier.span, "declared here first"),),
        )

    def _declaration_is_sound(self, declaration: Declaration) -> bool:
        named, address = declaration.named, declaration.cell.address
        bank = BANKS[address.bank]
        add = self.problems.add
        if named.bank != address.bank:
            add(
                "CG205",
                declaration.span,
                f"{self.spell.name(named.bank, named.name)} cannot be {address}",
                f"write {self.spell.name(bank.name, named.name)}, or an address in {named.bank}",
            )
            return False
        if looks_like_scratch(named.name):
            add("CG203", named.span, f"clickgen keeps names like {named.name} for its own cells", "choose another name")
            return False
        fault = nickname_fault_at(address, named.name)
        if fault:
            add("CG203", named.span, f"CLICK does not take the nickname {named.name!r}: {fault}", "choose another name")
            return False
        fault = comment_fault(declaration.comment or "")
        if fault:
            add("CG203", declaration.span, f"CLICK does not take the comment of {named.name}: {fault}", "shorten it")
            return False
        if not (declaration.comment or " ").isprintable():
            help = "write it on one line"
            add(
                "CG203",
                declaration.span,
                f"the comment of {named.name} holds a line break or a control character",
                help,
            )
            return False
        system = addresses_of_system_name(named.name)
        if system and address not in system:
            own = " or ".join(map(str, system))
            add("CG205", declaration.span, f"{named.name} is CLICK's own name of {own}", "choose another name")
            return False
        if bank.settings_fixed and (declaration.initial is not None or declaration.retentive is not None):
            add(
                "CG302",
                declaration.initial.span if declaration.initial else declaration.span,
                f"{address} has no initial value or retention that can be set",
                "leave out initial= and retentive=",
            )
            return False
        return self._agrees_with_table(declaration)

    def _agrees_with_table(self, declaration: Declaration) -> bool:
        named, address = declaration.named, declaration.cell.address
        row = self.table.by_nickname.get(named.name.lower())
        if row is not None and row.address != address:
            self.problems.add(
                "CG205",
                declaration.span,
                f"{named.name} is {address} here and {row.address} in {self.table.place(row)}",
                "change one of them; a PLC keeps its data by address",
                self._table_label(row),
            )
            return False
        row = self.table.by_address.get(address)
        if row is not None and row.nickname and row.nickname.lower() != named.name.lower():
            self.problems.add(
                "CG205",
                declaration.span,
                f"{address} is {named.name} here and {row.nickname} in {self.table.place(row)}",
                f"change one of them; if {named.name} is {row.nickname} by another name: "
                f"{rename_command(row.nickname, named.name)}",
                self._table_label(row),
            )
            return False
        return True

    def _table_label(self, row: Row) -> tuple[Label, ...]:
        span = self.table.span(row)
        return (Label(span, "the address table says"),) if span else ()

    def _declared_row(self, declaration: Declaration) -> Row:
        address = declaration.cell.address
        stands = self.table.by_address.get(address) or default_row(address, "")
        # A table that spells the name in another case keeps its spelling: for CLICK it is the same name
        # (click-facts [name.unique]).
        row = replace(stands, nickname=stands.nickname or declaration.named.name, line=0, raw="")
        if declaration.comment is not None:
            mark = mark_in(stands.comment)
            row = replace(row, comment=f"<{mark.word}>{declaration.comment}" if mark else declaration.comment)
        if declaration.retentive is not None:
            row = replace(row, retentive=declaration.retentive)
        if declaration.initial is not None:
            initial = initial_of(declaration.initial, address, self.problems)
            row = row if initial is None else replace(row, initial=initial)
        return row


PROGRAM = "PROG.py"
"""Placeholder in a command for the program and its table, which the pipeline knows."""


def rename_command(old: str, new: str) -> str:
    """The command that renames a name in the table to the one that a declaration gives."""
    return f"clickgen nicknames rename {shlex.quote(old)} {shlex.quote(new)} {PROGRAM}"


def name_program(words: str, problems: Diagnostics) -> None:
    """Put the program and its table into the commands that the problems of declarations show."""
    problems.found = [
        problem._replace(help=problem.help.replace(PROGRAM, words)) if problem.code == "CG205" else problem
        for problem in problems.found
    ]


def initial_of(constant: Constant, address: Address, problems: Diagnostics) -> str | None:
    """Return an initial value in CLICK's form; None, with a problem, if the address cannot begin with it."""
    initial = format_initial(address.kind, _python_value(typed(constant, address.kind)))
    if initial is None or not initial.isprintable():
        problems.add(
            "CG302",
            constant.span,
            f"{address} cannot begin with this value",
            f"{BANKS[address.bank].title} hold {_holds(address)}",
        )
        return None
    return initial


def _python_value(constant: Operand) -> object:
    if isinstance(constant, CharCode):
        return chr(constant.value)
    return getattr(constant, "value", None)


def _holds(address: Address) -> str:
    if address.kind in INTEGER_RANGES:
        low, high = INTEGER_RANGES[address.kind]
        return f"{low}..{high}"
    return {
        Kind.BIT: "0 or 1",
        Kind.HEX: "0x0000..0xFFFF",
        Kind.FLOAT: f"numbers up to {FLOAT_MAX}",
        Kind.TEXT: "one character",
    }[address.kind]
