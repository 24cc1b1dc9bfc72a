"""A dialect: one way to write a program as text. It reads text to the IR, writes the IR, and spells it in messages.

To add a dialect, add a folder beside ``if_rungs`` whose package has a ``DIALECT``, and name it in ``registry.py``. No
other file knows which dialects there are: stages, rules, fixes and commands get a ``Dialect`` or a ``Spelling`` and ask
it. A new dialect inherits nothing but these two classes.

- A dialect is loaded for every command, so its package imports only what a look at a file needs; what reads and writes
  is imported in the methods. A test holds that.
- The IR has no dialect: what one reads, another can write.
- How comments that silence findings are written is the dialect's. Codes of problems, Specs of instructions, and the
  names of Specs and their parameters belong to all.
- The examples of rules (``wrong`` and ``right``) are source text of ``if_rungs``. A second dialect gets its own in its
  tests and pages: they are read there, and the IR is written in it. What cannot be written has no example in it.
- Formulas are a language of their own, with their own reader and ``formula.spelling``. A dialect may hold them as they
  are, or read and write calculations of its own to the same nodes.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Mapping, Sequence

    from clickgen.device.banks import Address
    from clickgen.instructions.spec import Spec
    from clickgen.ir.conditions import Condition
    from clickgen.ir.modbus import Remote
    from clickgen.ir.operands import Named, Operand
    from clickgen.ir.program import Action, FormulaText, Program, Routine
    from clickgen.ir.proposals import Proposal
    from clickgen.problems.diagnostics import Diagnostic, Diagnostics
    from clickgen.problems.silence import Directive
    from clickgen.table.rows import Row
    from clickgen.text.edits import Edit, Fix
    from clickgen.text.source import SourceFile, Span
    from clickgen.workspace import Workspace


class Spelling(ABC):
    """How a dialect writes what messages show. Texts go in and out: a person's own words are passed on as they are."""

    # -- addresses: the methods of ``ir.addresses.AddressSpelling`` ----------------------------------------------------

    @property
    @abstractmethod
    def range_end(self) -> str:
        """A remark on how the end of a range is written; "" where nothing is to be said."""

    @abstractmethod
    def cell(self, address: Address) -> str:
        """One address by its number."""

    @abstractmethod
    def name(self, bank: str, name: str) -> str:
        """A nickname seen through a bank."""

    @abstractmethod
    def in_quotes(self, bank: str, name: str) -> str:
        """``name`` in the form that takes any name, be it a plain word or not."""

    @abstractmethod
    def range(self, bank: str, first: int, last: int) -> str:
        """Consecutive addresses, both ends included; ``first`` above ``last`` runs backwards."""

    @abstractmethod
    def member(self, block: str, index: int) -> str:
        """One member of a block that is written so; the first one has the index 0."""

    @abstractmethod
    def members(self, block: str, count: int) -> str:
        """The first members of a block that is written so."""

    @abstractmethod
    def pointer(self, bank: str, register: str) -> str:
        """The cell of a bank whose number is in a register that is written so."""

    # -- addresses that a person wrote --------------------------------------------------------------------------------

    @abstractmethod
    def is_address(self, text: str) -> bool:
        """True for a text that looks like an address."""

    @abstractmethod
    def is_name(self, text: str) -> bool:
        """True for a name seen through its bank, without an index."""

    @abstractmethod
    def address_hint(self, text: str, bank: str = "C") -> str:
        """The way out for a text in quotes where an address is expected, likely one of this bank."""

    # -- what the IR has ----------------------------------------------------------------------------------------------

    @abstractmethod
    def operand(self, operand: Operand) -> str:
        """An address, a range, a pointer or a constant."""

    @abstractmethod
    def condition(self, condition: Condition) -> str:
        """A condition on one line."""

    @abstractmethod
    def remote(self, remote: Remote) -> str:
        """An address of another device."""

    @abstractmethod
    def action(self, action: Action) -> str:
        """An instruction on one line."""

    # -- conditions out of texts --------------------------------------------------------------------------------------

    @property
    @abstractmethod
    def always(self) -> str:
        """The condition that always holds."""

    @abstractmethod
    def off(self, bit: str) -> str:
        """The contact that is on while a bit is off."""

    @abstractmethod
    def rising(self, bit: str) -> str:
        """The contact on a rising edge."""

    @abstractmethod
    def compared(self, left: str, op: str, right: str) -> str:
        """A comparison; ``op`` is one of ``== != < <= > >=``."""

    @abstractmethod
    def every(self, *terms: str) -> str:
        """Conditions in series."""

    @abstractmethod
    def some(self, *terms: str) -> str:
        """Conditions in parallel."""

    # -- statements out of texts --------------------------------------------------------------------------------------

    @abstractmethod
    def call(self, spec: Spec, *texts: str, **named: str) -> str:
        """An instruction with these arguments: in the order of its parameters, or by their names.

        ``...`` is an argument that the reader of a message fills in.
        """

    @abstractmethod
    def rung(self, condition: str, *actions: str) -> str:
        """A rung on one line; "" is no condition, and without actions only its head is written."""

    @abstractmethod
    def example(self, spec: Spec) -> str:
        """An example of an instruction."""

    @abstractmethod
    def signature(self, spec: Spec) -> str:
        """An instruction with the names of its parameters."""

    @abstractmethod
    def rung_at(self, indent: str, action: str) -> str:
        """The lines of a rung without a condition, as they are written below a rung with this indent."""

    @abstractmethod
    def goes_on(self, line: str) -> bool:
        """True for a line after which the next one would be read as its rest."""

    @abstractmethod
    def pin(self, name: str, condition: str) -> str:
        """An input of a box, with the condition that it waits for."""

    @abstractmethod
    def chained(self, name: str, condition: str, **named: str) -> str:
        """The same as it is written after its box; "" where it cannot be."""

    @abstractmethod
    def declaration(self, *texts: str, **settings: str) -> str:
        """The declaration of a name: its own text, its address, and settings such as ``retentive``.

        Without any it is the word for a declaration.
        """

    @abstractmethod
    def setting(self, name: str, value: str = "") -> str:
        """A setting of a declaration, or an argument by its name; without a value its word alone."""

    @abstractmethod
    def ignore(self, code: str) -> str:
        """The comment that silences a finding."""

    @abstractmethod
    def routine(self, function: str, title: str = "", is_main: bool = False) -> str:
        """The head of a routine; a ``title`` is CLICK's name for a subroutine, where it is another."""

    @abstractmethod
    def subroutine_mark(self, title: str = "") -> str:
        """What makes a routine a subroutine, with CLICK's name for it."""

    @abstractmethod
    def imported(self, module: str, function: str) -> str:
        """The line that brings a subroutine from another file."""

    @abstractmethod
    def loop(self, count: str) -> str:
        """The head of a loop without a body of its own."""

    @abstractmethod
    def quoted(self, text: str) -> str:
        """A text constant."""

    @abstractmethod
    def hexadecimal(self, value: int) -> str:
        """A hexadecimal constant of 16 bits."""

    def no_opposite(self, shown: str, is_negated: bool = False) -> str:
        """The way out for what has no opposite; ``is_negated`` where a ``not`` asks for it, not an else."""
        from clickgen.instructions.offered import COIL

        nothing, then = "nothing", "test the bit"
        if is_negated:
            nothing, then = "nothing in the language", f"write {self.off('...')} of that bit"
        out = self.call(COIL, "...")
        return f"{nothing} is the opposite of {shown}: put it on a bit with {out} in a rung before, and {then}"

    @property
    @abstractmethod
    def immediate(self) -> str:
        """The word that makes a contact or a coil an immediate one."""

    @property
    @abstractmethod
    def backwards(self) -> str:
        """The word that makes a range run backwards."""


class Look(ABC):
    """What a look at a text tells, without reading it as a program."""

    @property
    @abstractmethod
    def is_program(self) -> bool:
        """True for a program of the dialect or a part of one, valid or broken; other text is left alone."""

    @property
    @abstractmethod
    def has_main(self) -> bool:
        """True where the main program is in this file."""

    @property
    @abstractmethod
    def imports(self) -> tuple[str, ...]:
        """The names of the files beside it that it may bring in; not all of them need be there."""


class Place(NamedTuple):
    """Where a name is written: the stretches that hold its characters; more than one where a text is in pieces."""

    stretches: tuple[Span, ...]

    def edits(self, name: str) -> tuple[Edit, ...]:
        """Another name in its place: in the first stretch, the others become empty."""
        from clickgen.text.edits import Edit

        return tuple(Edit(span, "" if index else name) for index, span in enumerate(self.stretches))


class Written(NamedTuple):
    """A fix: its edits, and what it writes on one line, for a message; "" for none."""

    edits: tuple[Edit, ...]
    shown: str = ""


class Mender(ABC):
    """Writes parts of the statements of one file otherwise. Every byte that is no part of them stays."""

    @abstractmethod
    def proposed(self, proposal: Proposal) -> Written | None:
        """The fix of a proposal as the reader left it, with names; None where there is none to write."""

    @abstractmethod
    def without_terms(self, terms: Sequence[Span]) -> tuple[Edit, ...] | None:
        """The edits that take these terms out of a condition; None if more than the terms would go."""


class NamePlaces(ABC):
    """Where names are written in one file."""

    @abstractmethod
    def place(self, named: Named) -> Place:
        """Where one of the names of the file has its characters."""

    @abstractmethod
    def takes(self, named: Named, name: str) -> bool:
        """True where another name can be written in the place of one."""


class Dialect(ABC):
    """A dialect of the language."""

    name: str
    suffix: str
    """How the names of its files end."""

    @property
    @abstractmethod
    def spell(self) -> Spelling:
        """How it writes what messages show."""

    # -- finding programs ---------------------------------------------------------------------------------------------

    @abstractmethod
    def look(self, path: str, text: str) -> Look:
        """A look at a file with this text, which may be broken."""

    # -- reading ------------------------------------------------------------------------------------------------------

    @abstractmethod
    def decode(self, path: str, data: bytes, problems: Diagnostics) -> SourceFile | None:
        """The source file that these bytes are, or None with a problem."""

    @abstractmethod
    def read(
        self, source: SourceFile, files: Workspace, problems: Diagnostics
    ) -> tuple[Program | None, tuple[SourceFile, ...]]:
        """The program that begins in this file, and every file it is made of; None where nothing can be read."""

    @abstractmethod
    def read_file(self, source: SourceFile, problems: Diagnostics) -> Sequence[object] | None:
        """The routines, declarations and imports of one file in the order of its text; None where it cannot be read."""

    @abstractmethod
    def routines_in(self, source: SourceFile) -> list[str]:
        """The functions that a file has, also those that no program uses."""

    @abstractmethod
    def places(self, source: SourceFile, formulas: Sequence[FormulaText]) -> NamePlaces:
        """Where the names of a file are, which has these formulas."""

    @abstractmethod
    def comments_with(self, source: SourceFile, word: str) -> int:
        """How many comments of a file hold this word, in any case."""

    # -- fixes --------------------------------------------------------------------------------------------------------

    def mender(self, source: SourceFile) -> Mender | None:  # noqa: ARG002
        """What writes the fixes of a file that can be read; None in a dialect without fixes."""
        return None

    # -- comments that silence findings -------------------------------------------------------------------------------

    @abstractmethod
    def directives(self, source: SourceFile, problems: Diagnostics) -> list[Directive]:
        """Every comment of a file that silences findings; what looks like one and is none is a problem."""

    @abstractmethod
    def ignoring(self, source: SourceFile, findings: Iterable[Diagnostic]) -> Fix | None:
        """The edits that silence these findings of a file; None when there is nothing to silence."""

    @abstractmethod
    def without(self, source: SourceFile, directive: Directive, codes: Sequence[str]) -> Edit:
        """The edit that takes codes out of a directive."""

    # -- writing ------------------------------------------------------------------------------------------------------

    @abstractmethod
    def write(
        self,
        routines: Sequence[Routine],
        names: Mapping[Address, str],
        declared: Sequence[Row] = (),
    ) -> str:
        """A program as one file: ``names`` are written in place of addresses, and ``declared`` ones are declared."""

    @abstractmethod
    def write_files(self, routines: Sequence[Routine], names: Mapping[Address, str]) -> dict[str, str]:
        """The texts of a program with a file for each subroutine, by the names of the files."""

    @abstractmethod
    def function_name(self, name: str, taken: Collection[str]) -> str:
        """The function for a subroutine of this name: its own where the dialect has no other use for it."""

    @abstractmethod
    def idle(self, line: str) -> str:
        """A line that does nothing, in the place of one that cannot be read; "" where there is none."""

    # -- help ---------------------------------------------------------------------------------------------------------

    @abstractmethod
    def system_point_hint(self, word: str) -> str:
        """Which of CLICK's own points a word of another machine means; "" for any other word."""

    @abstractmethod
    def explain_word(self, word: str) -> list[str]:
        """What a word of another machine is, a line for each place that it can have."""
