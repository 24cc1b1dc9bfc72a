"""What CLICK has no word for, in the words it has: pointers in formulas, one-shot ranges, the retentive off-delay."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from clickgen.device.banks import Address, Kind
from clickgen.formula.refs import Ref, map_refs
from clickgen.instructions.coils import OUT
from clickgen.instructions.copies import COPY
from clickgen.instructions.timers import RTOF, RTON
from clickgen.ir.conditions import All, Any, Condition, Contact
from clickgen.ir.operands import Cell, Named, Pointer, Range
from clickgen.ir.program import Action, FormulaText, Value
from clickgen.ir.walk import Rewriter
from clickgen.lower.tokens import operand_token
from clickgen.source import Span

_SCRATCH_BANK = {Kind.INT16: "DS", Kind.INT32: "DD", Kind.HEX: "DH", Kind.FLOAT: "DF"}
"""Where a value of a kind is kept for a formula: the same kind in a bank that every formula takes."""

TakeScratch = Callable[[str, str, Span], Cell]
"""Bank, purpose and place of a scratch use to its cell."""


@dataclass(frozen=True, slots=True)
class Own:
    """An action that stands on a condition of its own, not on its rung's."""

    condition: Condition
    action: Action


Expanded = Action | Own


def expand_formula(action: Action, take: TakeScratch) -> list[Action]:
    """A formula that reads a pointer or an XD/YD word: each is copied to a scratch register first, in the same rung."""
    text = action.args.get("formula")
    if not isinstance(text, FormulaText):
        return [action]
    copies: list[Action] = []
    replaced: dict[str, Cell] = {}

    def change(ref: Ref) -> Ref:
        if not (isinstance(ref, Pointer) or (isinstance(ref, Cell) and ref.bank in ("XD", "YD"))):
            return ref
        token = operand_token(ref)
        if token not in replaced:
            kind = Address(ref.bank, 1).kind
            replaced[token] = cell = take(_SCRATCH_BANK[kind], f"value of {token} for the formula", ref.span)
            args: dict[str, Value] = {"source": ref, "destination": cell}
            if "oneshot" in action.args:
                args["oneshot"] = action.args["oneshot"]
            copies.append(Action(COPY, args, action.span))
        return Cell(replaced[token].address, ref.span)

    formula = FormulaText(map_refs(text.formula, change), text.span)
    if not copies:
        return [action]
    return [*copies, Action(action.spec, {**action.args, "formula": formula}, action.span)]


def expand_range(action: Action) -> list[Action]:
    """A coil on a range of one bit, and a one-shot coil on any range: one coil for each bit (click-facts, 3)."""
    target = action.args.get("address")
    if not isinstance(target, Range) or not (len(target) == 1 or action.flag("oneshot")):
        return [action]
    return [
        Action(action.spec, {**action.args, "address": Cell(address, target.span)}, action.span)
        for address in target.addresses()
    ]


class OffDelays(Rewriter):
    """Retentive off-delay timers: which timers they are, and the scratch bits that stand for them.

    CLICK's retained timer is an on-delay only. Bit E follows the rung; a retentive on-delay runs while E is off; bit Q
    is on while E is, or while Q was and the timer has not elapsed. Reading the timer's bit means reading Q.
    """

    def __init__(self, take: TakeScratch) -> None:
        self._take = take
        self._outputs: dict[Address, Cell] = {}
        self._enables: dict[Address, Cell] = {}

    def add(self, action: Action) -> None:
        timer = action.args["timer"]
        assert isinstance(timer, Cell)
        name = timer.address
        if name not in self._outputs:
            self._enables[name] = self._take("C", f"rtof {name}: on while its rung is true", action.span)
            self._outputs[name] = self._take("C", f"rtof {name}: its output, read in place of {name}", action.span)

    def __bool__(self) -> bool:
        return bool(self._outputs)

    def cell(self, cell: Named | Cell) -> Named | Cell:
        output = self._outputs.get(cell.address) if isinstance(cell, Cell) else None
        return cell if output is None else Cell(output.address, cell.span)

    def action(self, action: Action) -> Action:
        """Only what reads the bit means Q; the timer instruction itself keeps its number."""
        timer = action.args.get("timer")
        changed = super().action(action)
        return changed if timer is None else Action(action.spec, {**changed.args, "timer": timer}, action.span)

    def expand(self, action: Action) -> list[Expanded]:
        timer = action.args.get("timer")
        if action.spec is not RTOF or not isinstance(timer, Cell):
            return [action]
        span = action.span
        enable, output = self._enables[timer.address], self._outputs[timer.address]
        running = Contact(enable, span)
        elapsed = Contact(timer, span)
        hold = All((Contact(output, span), replace(elapsed, negated=True)), span)
        return [
            Action(OUT, {"address": enable}, span),
            Own(replace(running, negated=True), Action(RTON, action.args, span)),
            Own(Any((running, hold), span), Action(OUT, {"address": output}, span)),
        ]
