"""Where each address comes from: the source, the address table, CLICK's own names, or allocation; first match wins."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import NamedTuple

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, UPPER_BYTE_BANKS, Address
from clickgen.device.nicknames import comment_fault, nickname_fault
from clickgen.device.system import system_name_of, system_nicknames
from clickgen.diagnostics import Diagnostics, Label, did_you_mean
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, CharCode, Constant, Immediate, Named, Operand, Range
from clickgen.ir.program import Action, Declaration, Program
from clickgen.ir.reach import reaching
from clickgen.ir.walk import Rewriter, program_operands
from clickgen.resolve.allocate import Allocator
from clickgen.resolve.constants import kind_of, typed
from clickgen.resolve.table import AddressTable, Row, default_row, format_initial
from clickgen.source import Span


@dataclass(frozen=True)
class Resolved:
    """A program without names, and what became of them."""

    program: Program
    rows: tuple[Row, ...]
    """The rows that the table lacks: declared and allocated names."""
    allocated: tuple[Row, ...]
    """Those of ``rows`` whose address clickgen chose."""
    allocator: Allocator
    table: AddressTable


class _Meaning(NamedTuple):
    """What a nickname stands for and who says so."""

    address: Address
    said_by: str
    span: Span | None


def resolve(program: Program, table: AddressTable, frozen: bool, problems: Diagnostics) -> Resolved:
    """Replace every name by its address. Names without one are allocated, or reported when ``frozen``.

    Names with a problem stay in the tree, so that the rules after this judge all the rest.
    """
    resolver = _Resolver(table, frozen, problems)
    resolver.warn_of_words()
    resolver.declare(program.declarations)
    operands = list(program_operands(program))
    resolver.allocator.take(_addresses(operands))
    resolver.name(list(_named(operands)), list(reaching(program)))
    resolved = _Names(resolver.addresses).program(program)
    rows = (*resolver.declared, *resolver.allocated)
    return Resolved(resolved, rows, tuple(resolver.allocated), resolver.allocator, table)


def _addresses(operands: Iterable[Operand]) -> Iterable[Address]:
    """Every address that the program writes by number."""
    for operand in operands:
        if isinstance(operand, Immediate):
            operand = operand.target
        if isinstance(operand, Cell):
            yield operand.address
        elif isinstance(operand, Range):
            yield from operand.addresses()


class _Resolver:
    def __init__(self, table: AddressTable, frozen: bool, problems: Diagnostics) -> None:
        self.table = table
        self.frozen = frozen
        self.problems = problems
        self.meanings: dict[str, _Meaning] = {
            name: _Meaning(row.address, f"line {row.line} of {table.path}", table.span(row))
            for name, row in table.by_nickname.items()
        }
        self.addresses: dict[tuple[str, str], Address] = {}
        """(bank, lowercase name) to the address; a name with a problem has none."""
        self.declared: list[Row] = []
        self.allocated: list[Row] = []
        self.allocator = Allocator(row.address for row in table.rows)

    # -- declarations -------------------------------------------------------------------------------------------------

    def declare(self, declarations: tuple[Declaration, ...]) -> None:
        """nickname(...) comes before every other source of an address."""
        by_name: dict[str, Declaration] = {}
        by_address: dict[Address, Declaration] = {}
        for declaration in declarations:
            named, address = declaration.named, declaration.cell.address
            lower = named.name.lower()
            self.allocator.take([address])
            earlier = by_name.setdefault(lower, declaration)
            if earlier is not declaration:
                self._conflict(declaration, f"{named.name} is declared twice", earlier)
                continue
            earlier = by_address.setdefault(address, declaration)
            if earlier is not declaration:
                self._conflict(declaration, f"{address} is declared as {earlier.named.name} already", earlier)
                continue
            if self._declaration_is_sound(declaration):
                self.meanings[lower] = _Meaning(address, "nickname(...)", declaration.span)
                self._warn_of_word(address, named.name, declaration.span)
                row = self._declared_row(declaration)
                stands = self.table.by_address.get(address)
                if stands is None or stands.content != row.content:
                    self.declared.append(row)

    def warn_of_words(self) -> None:
        """Nicknames in the table that ClickNick's importer loses (click-facts, section 1)."""
        for row in self.table.rows:
            if row.nickname:
                self._warn_of_word(row.address, row.nickname, self.table.span(row))

    def _warn_of_word(self, address: Address, name: str, span: Span | None) -> None:
        if address.bank in UPPER_BYTE_BANKS:
            self.problems.add(
                "CG211",
                span,
                f"{name} is the nickname of {address}: ClickNick drops XD0u and misreads other XD and YD rows",
                f"write {address.bank.lower()}[...] and give it no nickname, or check it in CLICK after the import",
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
                f"{named.bank.lower()}.{named.name} cannot be {address}",
                f"write {bank.dsl}.{named.name}, or an address in {named.bank}",
            )
            return False
        fault = nickname_fault(named.name, system=system_name_of(address) == named.name)
        if fault:
            add("CG203", named.span, f"CLICK does not take the nickname {named.name!r}: {fault}", "choose another name")
            return False
        fault = comment_fault(declaration.comment or "")
        if fault:
            add("CG203", declaration.span, f"CLICK does not take the comment of {named.name}: {fault}", "shorten it")
            return False
        system = system_nicknames().get(named.name.lower())
        if system and system[1] != address:
            add("CG205", declaration.span, f"{named.name} is CLICK's own name of {system[1]}", "choose another name")
            return False
        if bank.settings_fixed and (declaration.initial is not None or declaration.retentive is not None):
            add(
                "CG302",
                declaration.span,
                f"{address} has no initial value or retention to set (click-facts, section 1)",
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
                f"{named.name} is {address} here and {row.address} in line {row.line} of {self.table.path}",
                "change one of them; a PLC keeps its data by address",
                self._table_label(row),
            )
            return False
        row = self.table.by_address.get(address)
        if row is not None and row.nickname and row.nickname.lower() != named.name.lower():
            self.problems.add(
                "CG205",
                declaration.span,
                f"{address} is {named.name} here and {row.nickname} in line {row.line} of {self.table.path}",
                "change one of them",
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
        row = replace(stands, nickname=declaration.named.name, line=0, raw="")
        if declaration.comment is not None:
            row = replace(row, comment=declaration.comment)
        if declaration.retentive is not None:
            row = replace(row, retentive=declaration.retentive)
        if declaration.initial is not None:
            initial = format_initial(address.kind, _python_value(typed(declaration.initial, address.kind)))
            if initial is None:
                self.problems.add(
                    "CG302",
                    declaration.initial.span,
                    f"{address} cannot begin with this value",
                    f"{BANKS[address.bank].title} hold {_holds(address)}",
                )
            else:
                row = replace(row, initial=initial)
        return row

    # -- names --------------------------------------------------------------------------------------------------------

    def name(self, uses: list[Named], blocks: list[tuple[Operand, int]]) -> None:
        """Give every name of the program its address; those without one in order of first use.

        ``blocks`` are the operands that stand for more addresses than their own, with how many.
        """
        first_uses = {(use.bank, use.name.lower()): use for use in reversed(uses)}
        unknown = [use for use in reversed(first_uses.values()) if not self._give_known(use)]
        lengths: dict[tuple[str, str], int] = {}
        for operand, length in blocks:
            address = self._address_of(operand)
            if address is not None:
                self.allocator.take(Address(address.bank, address.number + n) for n in range(length))
            elif isinstance(operand, Named):
                key = (operand.bank, operand.name.lower())
                lengths[key] = max(length, lengths.get(key, 1))
        # td.Name may come before the first t.Name, which decides.
        for use in sorted(unknown, key=lambda use: use.bank in CURRENT_VALUE_OF):
            key = (use.bank, use.name.lower())
            if not self._give_known(use):
                self._allocate(use, lengths.get(key, 1))

    def _address_of(self, operand: Operand) -> Address | None:
        if isinstance(operand, Named):
            return self.addresses.get((operand.bank, operand.name.lower()))
        return operand.address if isinstance(operand, Cell) else None

    def _give_known(self, use: Named) -> bool:
        """True when the name has a meaning already, be it a wrong one for this bank."""
        lower = use.name.lower()
        meaning = self.meanings.get(lower)
        if meaning is None:
            system = system_nicknames().get(lower)
            if system is None:
                return False
            meaning = _Meaning(system[1], "CLICK's own name", None)
        address = self._known(use, meaning)
        if address is not None:
            self.addresses[use.bank, lower] = address
        return True

    def _known(self, use: Named, meaning: _Meaning) -> Address | None:
        address = meaning.address
        if address.bank == use.bank:
            return address
        if CURRENT_VALUE_OF.get(use.bank) == address.bank:
            return Address(use.bank, address.number)
        dotted = f"{address.bank.lower()}.{use.name}"
        labels = (Label(meaning.span, f"{dotted} is here"),) if meaning.span else ()
        self.problems.add(
            "CG204",
            use.span,
            f"{use.name} is {dotted} ({meaning.said_by}), so it cannot be {use.bank.lower()}.{use.name}",
            f"write {dotted}, or choose another name here",
            labels,
        )
        return None

    def _allocate(self, use: Named, length: int) -> None:
        if not self._is_allocatable(use):
            return
        address = self.allocator.lowest(use.bank, length)
        if address is None:
            what = use.name if length == 1 else f"{use.name} and the {length - 1} behind it"
            self.problems.add(
                "CG208",
                use.span,
                f"no {use.bank} address is free for {what}",
                f"{use.bank} has {BANKS[use.bank].describe_range()}; free some rows of {self.table.path}",
            )
            return
        if use.bank in ("X", "Y"):
            self.problems.add(
                "CG210",
                use.span,
                f"{use.name} was given {address}: is it wired there?",
                f"pin it: nickname({use.bank.lower()}.{use.name}, {use.bank.lower()}[{address.number}])",
            )
        self.meanings[use.name.lower()] = _Meaning(address, f"line {use.span.line}", use.span)
        self.addresses[use.bank, use.name.lower()] = address
        self.allocated.append(self.table.named(address, use.name))

    def _is_allocatable(self, use: Named) -> bool:
        bank = BANKS[use.bank]
        add = self.problems.add
        fault = nickname_fault(use.name)
        if use.bank in CURRENT_VALUE_OF:
            kind, bit = ("timer", "t") if use.bank == "TD" else ("counter", "ct")
            add(
                "CG207",
                use.span,
                f"there is no {kind} {use.name!r}",
                did_you_mean(use.name, self.meanings)
                or f"use {bit}.{use.name} in the program, or give the name to an address with nickname(...)",
            )
        elif not bank.allocatable:
            add(
                "CG206",
                use.span,
                f"CLICK has no {bank.title} named {use.name!r}",
                did_you_mean(use.name, system_nicknames()) or f"write the number: {bank.dsl}[{bank.first}]",
            )
        elif fault:
            add("CG203", use.span, f"CLICK does not take the nickname {use.name!r}: {fault}", "choose another name")
        elif self.frozen:
            add(
                "CG209",
                use.span,
                f"{use.bank.lower()}.{use.name} has no address in {self.table.path}",
                "build once without --frozen and commit the table",
            )
        else:
            return True
        return False


def _named(operands: Iterable[Operand]) -> Iterable[Named]:
    for operand in operands:
        if isinstance(operand, Immediate):
            operand = operand.target
        if isinstance(operand, Named):
            yield operand


def _python_value(constant: Operand) -> object:
    if isinstance(constant, CharCode):
        return chr(constant.value)
    return getattr(constant, "value", None)


def _holds(address: Address) -> str:
    return {
        "BIT": "0 or 1",
        "INT": "-32768..32767",
        "INT2": "-2147483648..2147483647",
        "HEX": "0x0000..0xFFFF",
        "FLOAT": "numbers up to 3.4028235E+38",
        "TEXT": "one character",
    }[address.kind.value]


class _Names(Rewriter):
    """Replaces names by cells and gives constants their types."""

    def __init__(self, addresses: dict[tuple[str, str], Address]) -> None:
        self.addresses = addresses

    def cell(self, cell: Named | Cell) -> Named | Cell:
        if isinstance(cell, Cell):
            return cell
        address = self.addresses.get((cell.bank, cell.name.lower()))
        return cell if address is None else Cell(address, cell.span)

    def compare(self, compare: Compare) -> Compare:
        left, right = self.single(compare.left), self.single(compare.right)
        return Compare(compare.op, typed(left, kind_of(right)), typed(right, kind_of(left)), compare.span)

    def action(self, action: Action) -> Action:
        resolved = super().action(action)
        changes = {}
        for param in action.spec.params:
            value = resolved.args.get(param.name)
            if param.typed_by and isinstance(value, Constant):
                changes[param.name] = typed(value, kind_of(resolved.args.get(param.typed_by)))
        if not changes:
            return resolved
        return Action(resolved.spec, {**resolved.args, **changes}, resolved.span)
