"""Expands what CLICK has no word for into words it has: pointers in formulas, one-shot ranges, jumps, rtof."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from clickgen.click.draw.tokens import operand_token
from clickgen.device.banks import BANKS, Address, Kind
from clickgen.ir.conditions import All, Always, Any, Condition, Contact
from clickgen.ir.formula_nodes import Operand as FormulaOperand
from clickgen.ir.formula_nodes import references
from clickgen.ir.formula_operands import Ref, map_refs
from clickgen.ir.made import coil, copy
from clickgen.ir.operands import Cell, Immediate, Integer, Named, Pointer, Range
from clickgen.ir.program import Action, FormulaText
from clickgen.ir.walk import Rewriter
from clickgen.records import dataclass
from clickgen.text.source import Span

_SCRATCH_BANK = {Kind.INT16: "DS", Kind.INT32: "DD", Kind.HEX: "DH", Kind.FLOAT: "DF"}
"""The bank that keeps a value of a kind for a formula: the same kind, and every formula takes it."""

TakeScratch = Callable[[str, str, Span], Cell]
"""Gives the cell for the bank, purpose and place of a scratch use."""


@dataclass(frozen=True, slots=True)
class Own:
    """An action with a condition of its own, not that of its rung."""

    condition: Condition
    action: Action


Expanded = Action | Own


def expand(action: Action, take: TakeScratch, delays: OffDelays) -> Iterator[Expanded]:
    """Yield an action in instructions that CLICK has, most often itself."""
    for single in _range(action):
        for plain in _formula(single, take):
            for expanded in delays.expand(plain):
                yield from (expanded,) if isinstance(expanded, Own) else _jump(expanded, take)


def copied_first(action: Action) -> list[Ref]:
    """The operands that CLICK's formulas cannot read: pointers and XD/YD words (click-facts [math.no-pointers])."""
    text = action.args.get("formula")
    if not isinstance(text, FormulaText):
        return []
    refs = [node.ref for node in references(text.formula) if isinstance(node, FormulaOperand)]
    return [ref for ref in refs if isinstance(ref, Pointer) or ref.bank in ("XD", "YD")]


def _formula(action: Action, take: TakeScratch) -> list[Action]:
    """Copy each pointer or XD/YD word that a formula reads to a scratch register first, in the same rung."""
    text = action.args.get("formula")
    wanted = {operand_token(ref): ref for ref in copied_first(action)}
    if not wanted or not isinstance(text, FormulaText):
        return [action]
    copies: list[Action] = []
    kept: dict[str, Cell] = {}
    for token, ref in wanted.items():
        bank = _SCRATCH_BANK[BANKS[ref.bank].kind]
        kept[token] = take(bank, f"value of {token} for the formula", ref.span)
        copies.append(copy(ref, kept[token], action.span, action.args.get("oneshot")))

    def change(ref: Ref) -> Ref:
        cell = kept.get(operand_token(ref))
        return ref if cell is None else Cell(cell.address, ref.span)

    formula = FormulaText(map_refs(text.formula, change), text.span)
    return [*copies, Action(action.spec, {**action.args, "formula": formula}, action.span)]


def _range(action: Action) -> list[Action]:
    """Expand a coil on a range of one bit, and a one-shot coil on any range: one coil for each bit.

    click-facts [coil.oneshot]
    """
    drives = action.effects.drives
    target = action.args.get(drives.target) if drives is not None else None
    bits = target.target if isinstance(target, Immediate) else target
    if drives is None or not isinstance(bits, Range) or not (len(bits) == 1 or action.flag("oneshot")):
        return [action]
    cells = [Cell(address, bits.span) for address in bits.addresses()]
    targets = [Immediate(cell, bits.span) for cell in cells] if isinstance(target, Immediate) else cells
    return [Action(action.spec, {**action.args, drives.target: one}, action.span) for one in targets]


def _jump(action: Action, take: TakeScratch) -> list[Expanded]:
    """Expand a drum that jumps to a constant step: CLICK jumps to the step that a DS register holds.

    click-facts [drum.inputs]
    """
    step = action.args.get("jump_step")
    if not isinstance(step, Integer):
        return [action]
    register = take("DS", f"step {step.value} of the drum's jump", step.span)
    return [
        Own(Always(step.span), copy(step, register, action.span)),
        Action(action.spec, {**action.args, "jump_step": register}, action.span),
    ]


class OffDelays(Rewriter):
    """Retentive off-delay timers: which ones there are, and the scratch bits that implement them.

    CLICK's retained timer is an on-delay only (click-facts [timer.no-rtof]). Bit E follows the rung; a retentive
    on-delay runs while E is off; bit Q is on while E is, or while Q was and the timer has not elapsed. Reading the
    timer's bit means reading Q.
    """

    def __init__(self, take: TakeScratch) -> None:
        self._take = take
        self._outputs: dict[Address, Cell] = {}
        self._enables: dict[Address, Cell] = {}

    def add(self, action: Action) -> None:
        timer = action.owned
        assert timer is not None
        name = timer.address
        if name not in self._outputs:
            self._enables[name] = self._take("C", f"rtof {name}: on while its rung is true", action.span)
            self._outputs[name] = self._take("C", f"rtof {name}: its output, read in place of {name}", action.span)

    def bits_of(self, action: Action) -> tuple[Cell, ...]:
        """The scratch bits that an rtof drives; none for any other instruction."""
        timer = action.owned
        if action.spec.built_from is None or timer is None:
            return ()
        return self._enables[timer.address], self._outputs[timer.address]

    def __bool__(self) -> bool:
        return bool(self._outputs)

    def cell(self, cell: Named | Cell) -> Named | Cell:
        output = self._outputs.get(cell.address) if isinstance(cell, Cell) else None
        return cell if output is None else Cell(output.address, cell.span)

    def action(self, action: Action) -> Action:
        """Replace the bit by Q only where it is read; the timer instruction itself keeps its number."""
        changed = super().action(action)
        owned = {param.name: action.args[param.name] for param in action.spec.owns if param.name in action.args}
        return Action(action.spec, {**changed.args, **owned}, action.span) if owned else changed

    def expand(self, action: Action) -> list[Expanded]:
        """Return the instructions that implement an rtof; any other instruction is unchanged."""
        bits = self.bits_of(action)
        timer, built_from = action.owned, action.spec.built_from
        if not bits or timer is None or built_from is None:
            return [action]
        span = action.span
        enable, output = bits
        running = Contact(enable, span)
        elapsed = Contact(timer, span)
        hold = All((Contact(output, span), replace(elapsed, negated=True)), span)
        return [
            coil(enable, span),
            Own(replace(running, negated=True), Action(built_from, action.args, span)),
            Own(Any((running, hold), span), coil(output, span)),
        ]
