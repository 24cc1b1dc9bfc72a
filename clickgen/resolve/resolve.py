"""Finds the address of each name: the source, the address table, CLICK's own names, allocation; first match wins."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from copy import copy
from dataclasses import dataclass, replace

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, Address
from clickgen.device.nicknames import nickname_fault
from clickgen.device.system import addresses_of_system_name, doubt_about, near_system_name
from clickgen.dialects.base import Dialect
from clickgen.instructions.spec import Access
from clickgen.ir.conditions import Compare
from clickgen.ir.operands import Cell, Constant, Immediate, Named, Operand
from clickgen.ir.program import Action, Program, Routine, Value, Word, actions_in, rungs_in
from clickgen.ir.proposals import Proposal
from clickgen.ir.reach import reaching
from clickgen.ir.walk import Rewriter, program_operands
from clickgen.problems.diagnostics import Diagnostics, Label, Suggestions
from clickgen.resolve.allocate import Allocator
from clickgen.resolve.constants import kind_of, stored, typed
from clickgen.resolve.declare import Declared, Meaning, declare
from clickgen.resolve.declare_blocks import declare_blocks
from clickgen.resolve.guard_scratch import addresses_in, guard_scratch
from clickgen.resolve.members import proposal_without_members, without_members
from clickgen.table.address_table import AddressTable
from clickgen.table.blocks import Block, covered
from clickgen.table.masked import warn_of_masked
from clickgen.table.rows import Row, looks_like_scratch
from clickgen.text.wording import counted


@dataclass(frozen=True)
class Resolved:
    """A program without names, and the result of resolving them."""

    program: Program
    rows: tuple[Row, ...]
    """The rows that the table lacks: declared and allocated names."""
    allocated: tuple[Row, ...]
    """The ``rows`` whose address clickgen chose."""
    allocator: Allocator
    table: AddressTable
    blocks: Mapping[str, Block]
    """By their lowercase names."""
    proposals: tuple[Proposal, ...] = ()
    """The proposals of the program, in the same order, with addresses where they are known."""
    chosen: frozenset[Address] = frozenset()
    """The addresses of names, proposals included, that nothing declares: clickgen chose or would choose them."""
    is_declared: bool = True
    """False if something that could declare a name was not understood: then such a name may mean anything."""


def resolve(
    program: Program,
    table: AddressTable,
    frozen: bool,
    problems: Diagnostics,
    dialect: Dialect,
    reserved: Iterable[Address] = (),
) -> Resolved:
    """Replace every name by its address. Names without one are allocated, or reported when ``frozen``.

    ``dialect`` is the one that the program is written in. ``reserved`` addresses are given to no name. Names with a
    problem stay in the tree, so that the rules after this judge all the rest.
    """
    before = _faults(problems)
    declared = declare(program.declarations, table, dialect.spell, problems)
    blocks = declare_blocks(program.blocks, table, declared, dialect.spell, problems)
    # Any problem of the table, even a warning, may hide a row or a block.
    is_declared = program.is_declared and _faults(problems) == before and not _doubts_table(problems)
    operands = list(program_operands(program))
    if blocks or any(name.part is not None for name in _names_in(operands)):
        program = without_members(program, blocks, table, dialect.spell, problems)
        operands = list(program_operands(program))
    proposals = [proposal_without_members(proposal, blocks, table, dialect.spell) for proposal in program.proposals]
    proposed = replace(program, routines=tuple(Routine("", tuple(one.rungs()), one.span, False) for one in proposals))
    resolver = _Resolver(table, declared, frozen, problems, dialect, reserved)
    resolver.allocator.take((*resolver.reserved, *covered(blocks.values()), *addresses_in(operands)))
    resolver.allocator.take(addresses_in(program_operands(proposed)))
    resolver.name(program, list(_named(operands)))
    functions = {routine.function: routine.name for routine in program.subroutines}
    resolved = _Names(resolver.addresses, functions).program(program)
    guard_scratch(resolved, table, problems)
    rows = (*declared.rows, *resolver.allocated)
    warn_of_masked(program, rows, table, dialect.spell, problems)
    beside = resolver.beside()
    beside.name(proposed, list(_named(program_operands(proposed))))
    names = _Names(beside.addresses, functions)
    return Resolved(
        resolved,
        rows,
        tuple(resolver.allocated),
        resolver.allocator,
        table,
        blocks,
        tuple(map(names.proposal, proposals)),
        frozenset(row.address for row in (*resolver.allocated, *beside.allocated)),
        is_declared,
    )


def _faults(problems: Diagnostics) -> int:
    return sum(problem.is_error for problem in problems.found)


def _doubts_table(problems: Diagnostics) -> bool:
    return any(problem.code.startswith("CG6") for problem in problems.found)


class _Resolver:
    def __init__(
        self,
        table: AddressTable,
        declared: Declared,
        frozen: bool,
        problems: Diagnostics,
        dialect: Dialect,
        reserved: Iterable[Address] = (),
    ) -> None:
        self.dialect, self.spell = dialect, dialect.spell
        self.table = table
        self.reserved = tuple(reserved)
        self.frozen = frozen
        self.problems = problems
        self._near = Suggestions()
        self.meanings: dict[str, Meaning] = {
            name: Meaning(row.address, table.place(row), table.span(row)) for name, row in table.by_nickname.items()
        }
        self.meanings.update(declared.meanings)
        self.misdeclared = declared.misdeclared
        self.addresses: dict[tuple[str, str], Address] = {}
        """(bank, lowercase name) to the address; a name with a problem has none."""
        self.allocated: list[Row] = []
        self.allocator = Allocator((*_taken(table), *declared.addresses))
        self.owned: set[tuple[str, str]] = set()
        """(bank, lowercase name) of what an instruction keeps for itself, such as a drum's accumulator."""

    def beside(self) -> _Resolver:
        """Return a resolver that starts from here for what is not part of the program; it reports and keeps nothing."""
        other = copy(self)
        other.problems, other.allocated = Diagnostics(), []
        other.meanings, other.addresses = dict(self.meanings), dict(self.addresses)
        return other

    # -- names --------------------------------------------------------------------------------------------------------

    def name(self, program: Program, uses: list[Named]) -> None:
        """Give every name of the program its address; those without one in order of first use."""
        self.owned = set(_owned(program))
        first_uses: dict[tuple[str, str], Named] = {}
        for use in uses:
            first_uses.setdefault((use.bank, use.name.lower()), use)
        unknown = [use for use in first_uses.values() if not self._give_known(use)]
        lengths: dict[tuple[str, str], int] = {}
        for operand, length in reaching(program, self._address_of):
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

    def _address_of(self, operand: object) -> Address | None:
        if isinstance(operand, Named):
            return self.addresses.get((operand.bank, operand.name.lower()))
        return operand.address if isinstance(operand, Cell) else None

    def _give_known(self, use: Named) -> bool:
        """Return True if the name has a meaning already, even a wrong one for this bank."""
        lower = use.name.lower()
        meaning = self.meanings.get(lower)
        if meaning is None:
            system = addresses_of_system_name(use.name)
            if len(system) > 1 and lower not in self.misdeclared:
                self._ambiguous(use, system)
                return True
            if not system or lower in self.misdeclared:
                return lower in self.misdeclared
            meaning = Meaning(system[0], "CLICK's own name", None)
        address = self._known(use, meaning)
        if address is not None:
            self.addresses[use.bank, lower] = address
        return True

    def _ambiguous(self, use: Named, addresses: tuple[Address, ...]) -> None:
        """Report one of CLICK's own names that may mean one of several addresses."""
        written = " or ".join(map(self.spell.cell, addresses))
        pin = self.spell.declaration(self.spell.operand(use), self.spell.cell(addresses[0]))
        self.problems.add(
            "CG215",
            use.span,
            doubt_about(use.name),
            f"look which one your CLICK shows, and write {written}, or tie the name to it: {pin}",
        )

    def _known(self, use: Named, meaning: Meaning) -> Address | None:
        address = meaning.address
        if address.bank == use.bank:
            return address
        if CURRENT_VALUE_OF.get(use.bank) == address.bank:
            return Address(use.bank, address.number)
        dotted = self.spell.name(address.bank, use.name)
        labels = (Label(meaning.span, f"{dotted} is here"),) if meaning.span else ()
        said_by = meaning.said_by or (meaning.span.seen_from(use.span) if meaning.span else "")
        self.problems.add(
            "CG204",
            use.span,
            f"{use.name} is {dotted} ({said_by}), so it cannot be {self.spell.name(use.bank, use.name)}",
            f"write {dotted}, or choose another name here",
            labels,
        )
        return None

    def _allocate(self, use: Named, length: int) -> None:
        if not self._is_allocatable(use):
            return
        address = self.allocator.lowest(use.bank, length)
        if address is None:
            what = use.name if length == 1 else f"{use.name}, which needs {length} in a row"
            self.problems.add(
                "CG208",
                use.span,
                f"no {use.bank} address is free for {what}",
                f"{use.bank} has {BANKS[use.bank].describe_range()}; "
                f"free some rows of {self.table.path}{self._closed(use)}",
            )
            return
        if use.bank in ("X", "Y"):
            self.problems.add(
                "CG210",
                use.span,
                f"{use.name} was given {address}: is it wired there?",
                f"pin it: {self.spell.declaration(self.spell.operand(use), self.spell.cell(address))}",
            )
        self.meanings[use.name.lower()] = Meaning(address, "", use.span)
        self.addresses[use.bank, use.name.lower()] = address
        self.allocated.append(self.table.named(address, use.name))

    def _named_in(self, bank: str) -> list[str]:
        """The names that belong to a bank."""
        return [name for name, meaning in self.meanings.items() if meaning.address.bank == bank]

    def _closed(self, use: Named) -> str:
        """How much of a bank the settings keep free, for a message."""
        count = sum(address.bank == use.bank for address in self.reserved)
        return f", or some of the {counted(count, 'address', 'addresses')} that the settings keep free" if count else ""

    def _is_allocatable(self, use: Named) -> bool:
        bank = BANKS[use.bank]
        add = self.problems.add
        fault = nickname_fault(use.name)
        if use.bank in CURRENT_VALUE_OF and (use.bank, use.name.lower()) not in self.owned:
            kind = "timer" if use.bank == "TD" else "counter"
            bit = self.spell.name(CURRENT_VALUE_OF[use.bank], use.name)
            add(
                "CG207",
                use.span,
                f"there is no {kind} {use.name!r}",
                self._near(use.name, self._named_in(CURRENT_VALUE_OF[use.bank]))
                or f"use {bit} in the program, or give the name to an address with {self.spell.declaration()}",
            )
        elif not bank.allocatable and use.bank not in CURRENT_VALUE_OF:
            add(
                "CG206",
                use.span,
                f"CLICK has no {bank.title} named {use.name!r}",
                self._own_name_help(use),
            )
        elif use.name.lower() in self.table.spares:
            place = self.table.place(self.table.spares[use.name.lower()])
            add(
                "CG619",
                use.span,
                f"{use.name} stands in place of a nickname in {place}, so it is the name of no address",
                "give the address a nickname of its own in the workbook, and write that here",
            )
        elif looks_like_scratch(use.name):
            add("CG203", use.span, f"clickgen keeps names like {use.name} for its own cells", "choose another name")
        elif fault:
            add("CG203", use.span, f"CLICK does not take the nickname {use.name!r}: {fault}", "choose another name")
        elif self.frozen:
            add(
                "CG209",
                use.span,
                f"{self.spell.name(use.bank, use.name)} has no address in {self.table.path}",
                "build once without --frozen and commit the table",
            )
        else:
            return True
        return False

    def _own_name_help(self, use: Named) -> str:
        """A name of CLICK's own is suggested only where it can be nothing else: a neighbour is another register."""
        near = near_system_name(use.name, use.bank)
        if near:
            return f"did you mean {near if near.isidentifier() else self.spell.name(use.bank, near)}?"
        known = self.dialect.system_point_hint(use.name) if use.bank == "SC" else ""
        number = self.spell.pointer(use.bank, "number")
        return known or f"write its number in brackets, {number}, or one of CLICK's own names as CLICK shows it"


def _taken(table: AddressTable) -> Iterator[Address]:
    """The addresses of a table. A CLICK export may list every address; an empty row of it takes none."""
    return (row.address for row in table.rows if row.cell is not None or not row.is_default)


def _named(operands: Iterable[Operand]) -> Iterable[Named]:
    # A reference to no member of a block has its problem.
    return (name for name in _names_in(operands) if name.part is None)


def _names_in(operands: Iterable[Operand]) -> Iterator[Named]:
    for operand in operands:
        named = operand.target if isinstance(operand, Immediate) else operand
        if isinstance(named, Named):
            yield named


def _owned(program: Program) -> Iterator[tuple[str, str]]:
    for routine in program.routines:
        for rung in rungs_in(routine.rungs):
            for action in actions_in(rung.items):
                for param in action.spec.params:
                    operand = action.args.get(param.name)
                    if param.slot.access is Access.OWN and isinstance(operand, Named):
                        yield operand.bank, operand.name.lower()


class _Names(Rewriter):
    """Replaces names by cells and functions by CLICK's names for them, and gives constants their types."""

    def __init__(self, addresses: dict[tuple[str, str], Address], functions: Mapping[str, str]) -> None:
        self.addresses = addresses
        self.functions = functions

    def cell(self, cell: Named | Cell) -> Named | Cell:
        if isinstance(cell, Cell) or cell.part is not None:
            return cell
        address = self.addresses.get((cell.bank, cell.name.lower()))
        return cell if address is None else Cell(address, cell.span)

    def value(self, value: Value) -> Value:
        if isinstance(value, Word) and value.is_function and str(value.value) in self.functions:
            return Word(self.functions[str(value.value)], value.span)
        return super().value(value)

    def compare(self, compare: Compare) -> Compare:
        left, right = self.single(compare.left), self.single(compare.right)
        return Compare(compare.op, typed(left, kind_of(right)), typed(right, kind_of(left)), compare.span)

    def action(self, action: Action) -> Action:
        resolved = super().action(action)
        changes = {}
        params = {param.name: param for param in action.spec.params}
        for param in action.spec.params:
            value = resolved.args.get(param.name)
            if param.typed_by and isinstance(value, Constant):
                kind = kind_of(resolved.args.get(param.typed_by))
                is_stored = params[param.typed_by].slot.access is Access.WRITE
                changes[param.name] = stored(value, kind) if is_stored else typed(value, kind)
        if not changes:
            return resolved
        return Action(resolved.spec, {**resolved.args, **changes}, resolved.span)
