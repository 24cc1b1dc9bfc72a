"""The program: routines, rungs, branches, loops, actions."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from clickgen.device.banks import BANKS, Kind
from clickgen.instructions.effects import Drives, Effects, Flow
from clickgen.instructions.raw import WORD, rows_of
from clickgen.instructions.spec import ParamKind, Spec, Variant
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.modbus import Remote, Target
from clickgen.ir.operands import Cell, Constant, Hex, Integer, Named, Operand, Pointer, Range, Single, form_of
from clickgen.records import dataclass
from clickgen.text.source import SourceFile, Span

if TYPE_CHECKING:
    from clickgen.ir.formula_nodes import Formula
    from clickgen.ir.proposals import Proposal


@dataclass(frozen=True, slots=True)
class FormulaText:
    """A formula as read, and the span of its string."""

    formula: Formula
    span: Span


@dataclass(frozen=True, slots=True)
class Options:
    """A copy's conversion: ``to_text(suppress_zero=False)``. Only to_text has the settings."""

    name: str
    span: Span
    suppress_zero: bool = True
    exponential: bool = False
    termination_code: int | None = None
    pad: int | None = None
    """The digits that the person asked for; if zeros are not suppressed, CLICK writes as many as the type has
    (click-facts [value.number-text])."""


@dataclass(frozen=True, slots=True)
class Word:
    """A word of the language in an argument: a unit, a comparison, a subroutine's name, True or False.

    ``is_function`` marks a subroutine given by its function's name. After resolving, all names are CLICK's.
    """

    value: str | bool
    span: Span
    is_function: bool = False


@dataclass(frozen=True, slots=True)
class Operands:
    """A list of operands: the outputs of a drum."""

    items: tuple[Single, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Pattern:
    """The pattern of a drum: a row for each step, with one bit for each output."""

    rows: tuple[tuple[bool, ...], ...]
    span: Span


@dataclass(frozen=True, slots=True)
class KeptToken:
    """A ladder token from an old project, unchanged, and every address that it names (``kept.py`` finds them)."""

    text: str
    operands: tuple[Cell | Range | Pointer, ...]
    span: Span

    @property
    def is_formula(self) -> bool:
        """True for a formula, which runs at once like any other; False for an instruction that nobody knows."""
        return not self.text.startswith(f"{WORD}(")


Value = Operand | Condition | FormulaText | Options | Word | Operands | Pattern | Target | Remote | KeptToken
CONDITION_TYPES = (Contact, Compare, All, Any, Always)


@dataclass(frozen=True, slots=True)
class Action:
    """One instruction with its arguments by parameter name; arguments left out are absent."""

    spec: Spec
    args: Mapping[str, Value]
    span: Span

    def flag(self, name: str) -> bool:
        word = self.args.get(name)
        return isinstance(word, Word) and word.value is True

    def word(self, name: str) -> str:
        """The text of a word argument, or "" if it was left out."""
        word = self.args.get(name)
        return str(word.value) if isinstance(word, Word) else ""

    @property
    def height(self) -> int:
        """The height in grid rows, pins included; a kept token has its own."""
        token = self.args.get("token")
        return rows_of(token.text) if isinstance(token, KeptToken) else self.spec.height

    @property
    def variant(self) -> Variant:
        """The token form that the operands' banks choose: pack_bits, pack_words or pack_text.

        Raises ValueError if no form takes them, which the rule about copies refuses.
        """
        variants = self.spec.variants
        if len(variants) == 1:
            return variants[0]
        source, target = (form_of(self.args.get(name)) for name in self.spec.matrix)
        for variant in variants:
            if any(source in pair.sources and target in pair.targets for pair in variant.pairs):
                return variant
        raise ValueError(f"no form of {self.spec.name} takes {source} to {target}")

    def pin(self, name: str) -> Condition | None:
        value = self.args.get(name)
        return value if isinstance(value, CONDITION_TYPES) else None

    # -- what it does -------------------------------------------------------------------------------------------------

    @property
    def effects(self) -> Effects:
        return self.spec.effects

    @property
    def callee(self) -> Word | None:
        """The word that names the subroutine of a call."""
        words = (self.args.get(param.name) for param in self.spec.params if param.kind is ParamKind.ROUTINE)
        return next((word for word in words if isinstance(word, Word)), None)

    @property
    def called(self) -> str:
        """The name of the subroutine that runs first; "" for what is no call."""
        return str(self.callee.value) if self.effects.flow is Flow.CALL and self.callee else ""

    @property
    def owned(self) -> Cell | None:
        """The timer, counter or current value that belongs to it alone."""
        owned = (self.args.get(param.name) for param in self.spec.owns)
        return next((cell for cell in owned if isinstance(cell, Cell)), None)

    @property
    def source(self) -> Value | None:
        """The argument whose value it takes to its target; None where it takes none."""
        moves = self.effects.moves
        return self.args.get(moves.source) if moves is not None else None

    @property
    def moved(self) -> Value | None:
        """The value that it takes to its target, a number in the form that the target holds; None for no value."""
        moves = self.effects.moves
        if moves is None:
            return None
        if moves.source:
            return self.source
        bank = BANKS.get(form_of(self.moved_to))
        if bank is None or bank.kind in (Kind.BIT, Kind.TEXT):
            return None
        return (Hex if bank.kind is Kind.HEX else Integer)(moves.value, self.span)

    @property
    def moved_to(self) -> Value | None:
        """Where it takes a value; None where it moves none."""
        moves = self.effects.moves
        return self.args.get(moves.target) if moves is not None else None

    @property
    def driven(self) -> Value | None:
        """The bits that it turns on or off by what its rung or its step is."""
        drives = self.effects.drives
        if drives is not None:
            return self.args.get(drives.target)
        return self.moved_to if self._clears_bits else None

    @property
    def turns(self) -> bool | None:
        """True for what turns bits on whenever it runs, False for what turns them off, and None for all else."""
        how = self.effects.drives.how if self.effects.drives is not None else None
        if how is Drives.ON or how is Drives.OFF:
            return how is Drives.ON
        return False if self._clears_bits else None

    @property
    def _clears_bits(self) -> bool:
        moves = self.effects.moves
        if moves is None or moves.source or moves.value:
            return False
        bank = BANKS.get(form_of(self.moved_to))
        return bank is not None and bank.is_bit

    @property
    def may_be_late(self) -> bool:
        """True for what may change its targets in its own time: a message, and a kept instruction, but no formula."""
        token = self.args.get("token")
        is_formula = isinstance(token, KeptToken) and token.is_formula
        return self.effects.is_late or (self.effects.is_unknown and not is_formula)


@dataclass(frozen=True, slots=True)
class Branch:
    """A nested ``if``: its condition is in series with its parents'."""

    condition: Condition
    items: tuple[Item, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Loop:
    """``for _ in range(n):``. ``body`` is None if next_loop() closes the loop, else the rungs in it."""

    action: Action
    body: tuple[Rung, ...] | None

    @property
    def span(self) -> Span:
        return self.action.span


Item = Action | Branch | Loop


@dataclass(frozen=True, slots=True)
class Rung:
    """One ``if`` of a routine. ``span`` is the whole statement, ``head`` its ``if`` line up to the colon."""

    condition: Condition
    items: tuple[Item, ...]
    comment: str
    head: Span
    span: Span


@dataclass(frozen=True, slots=True)
class Routine:
    """main or a subroutine. ``span`` is its ``def`` up to the name.

    ``is_whole`` is False if part of it could not be read: then nothing is reported as missing from it.
    """

    name: str
    """The name in CLICK: ``Auto Mode``."""
    rungs: tuple[Rung, ...]
    span: Span
    is_main: bool
    is_whole: bool = True
    function: str = ""
    """The name in the source: ``auto_mode``. Without one, CLICK's name."""
    title: Span | None = None
    """The text of ``@sub("Auto Mode")``; None under ``@sub`` alone."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "function", self.function or self.name)

    @property
    def named_at(self) -> Span:
        """The place of CLICK's name."""
        return self.title or self.span


@dataclass(frozen=True, slots=True)
class Declaration:
    """``nickname(ds.MaxAlarms, ds[5], initial=10, retentive=False, comment="...")``; None for what was left out."""

    named: Named
    cell: Cell
    span: Span
    initial: Constant | None = None
    retentive: bool | None = None
    comment: str | None = None


@dataclass(frozen=True, slots=True)
class BlockDeclaration:
    """``nickname(ds.Recipe, ds[100:150])``: a name for a range, whose members are named by their index."""

    named: Named
    range: Range
    span: Span
    initial: Constant | None = None
    retentive: bool | None = None
    comment: str | None = None


@dataclass(frozen=True, slots=True)
class Offer:
    """A subroutine that could be imported: CLICK's name for it, and the module that has it."""

    name: str
    module: str


@dataclasses.dataclass(frozen=True)
class Program:
    """All that was read: routines in the order of their definitions, main among them."""

    source: SourceFile
    routines: tuple[Routine, ...]
    declarations: tuple[Declaration, ...]
    blocks: tuple[BlockDeclaration, ...] = ()
    misimported: frozenset[str] = frozenset()
    """Functions that an import should bring and does not: their problem is reported there."""
    offered: Mapping[str, Offer] = dataclasses.field(default_factory=dict)
    """Subroutines that could be imported, by their functions."""
    proposals: tuple[Proposal, ...] = ()
    """The fixes that the text of all its files suggests."""
    is_declared: bool = True
    """False if a file or a declaration could not be read: then any name may have an unknown meaning."""

    @property
    def main(self) -> Routine | None:
        return next((routine for routine in self.routines if routine.is_main), None)

    @property
    def subroutines(self) -> tuple[Routine, ...]:
        return tuple(routine for routine in self.routines if not routine.is_main)


def actions_in(items: tuple[Item, ...]) -> Iterator[Action]:
    """Yield every action of a rung in source order, branches included; a loop is its ``for``, without its body."""
    for item in items:
        if isinstance(item, Branch):
            yield from actions_in(item.items)
        elif isinstance(item, Loop):
            yield item.action
        else:
            yield item


def rungs_in(rungs: tuple[Rung, ...]) -> Iterator[Rung]:
    """Yield every rung in source order, the bodies of loops included."""
    for rung in rungs:
        yield rung
        for item in loops_in(rung.items):
            yield from rungs_in(item.body or ())


def loops_in(items: tuple[Item, ...]) -> Iterator[Loop]:
    for item in items:
        if isinstance(item, Loop):
            yield item
        elif isinstance(item, Branch):
            yield from loops_in(item.items)
