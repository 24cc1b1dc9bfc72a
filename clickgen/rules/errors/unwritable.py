"""What an instruction writes can be written (click-facts [bank.read-only])."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.device.system import DISPUTED_SC, system_name_of
from clickgen.dialects.ways_out import instead_of
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.refusals import (
    Refusal,
    addresses_named,
    operands_of,
    read_only,
    refusal,
    shown_target,
    target_of,
    unwritable,
)
from clickgen.instructions.spec import Access, Slot
from clickgen.ir.operands import Cell, Constant, Operand
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        said: set[Span] = set()
        for param, operand in operands_of(placed.action):
            if param.slot.access is Access.WRITE and operand.span not in said:
                why = refusal(param.slot, operand)
                is_read_only = why is Refusal.READ_ONLY
                found = list(_refuse(facts, placed, operand, param.slot) if is_read_only else _check_disputed(operand))
                yield from found
                # A drum's outputs may be a slice. Its cells have one place, which needs one finding.
                said |= {operand.span} if found or why else set()


def _refuse(facts: Facts, placed: Placed, operand: Operand, slot: Slot) -> Findings:
    target = target_of(operand)
    reason = read_only(slot, operand)
    if reason:
        message = f"{shown_target(facts.spell, target)} is {reason}: no instruction writes it"
        yield finding("CG304", operand.span, message, _instead(facts, placed, target))
        return
    found = unwritable(operand)
    if found:
        address, writable = found
        numbers = ", ".join(map(str, sorted(writable)))
        help = f"{_instead(facts, placed, Cell(address, operand.span))}; the writable {address.bank}: {numbers}"
        yield finding("CG304", operand.span, f"{address} cannot be written", help)


def _check_disputed(operand: Operand) -> Findings:
    named = addresses_named(operand)
    disputed = [str(address) for address in named if address.bank == "SC" and address.number in DISPUTED_SC]
    if disputed:
        yield finding(
            "CG312",
            operand.span,
            f"one list of CLICK's addresses has {', '.join(disputed)} as writable, and CLICK PLUS 3.41 has not",
            "try it on the machine before you rely on it",
        )


def _instead(facts: Facts, placed: Placed, target: object) -> str:
    """The way out for what only CLICK itself writes."""
    bank = getattr(target, "bank", "")
    name = facts.nickname(target.address) if isinstance(target, Cell) else ""
    if isinstance(target, Cell):
        shown = facts.spell.name(bank, name) if name.isidentifier() else facts.spell.cell(target.address)
    else:
        shown = facts.spell.cell(Address(bank, 1))
    own = (system_name_of(target.address) or "") if isinstance(target, Cell) else ""
    source = placed.action.args.get("source")
    value = " ".join(facts.text(source.span).split()) if isinstance(source, Cell | Constant) else ""
    owners = frozenset(one.spec.name for one in facts.actions if _owns(one, target))
    return instead_of(facts.spell, bank, shown, placed.spec, value, own, owners)


def _owns(placed: Placed, target: object) -> bool:
    """True for the instruction of this timer."""
    timer = placed.action.args.get("timer")
    return isinstance(timer, Cell) and isinstance(target, Cell) and timer.address == target.address


ABOUT = Code(
    "CG304",
    Severity.ERROR,
    "this address cannot be written",
    """
No instruction can write X, XD or the bits of timers and counters. In SC and SD, only [some
addresses](../language.md#instructions) are writable. `send` cannot write the inputs of another device either. A timer
or counter has its own input for the reset.
""",
    wrong=(
        Wrong(
            """
if c.Clear:
    reset(ct.Parts)  # <-
""",
        ),
    ),
    right=(
        """
if re(x[1]):
    ctu(ct.Parts, setpoint=100, reset=lambda: c.Clear)
""",
    ),
)

RULE = Rule(find, (ABOUT,), also=("CG312",), holds_in_parts=True)
