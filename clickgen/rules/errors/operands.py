"""Each operand is one that its instruction takes there: its bank, form, constant, and whether it can be written."""

from __future__ import annotations

import re

from clickgen.device.banks import BANKS, READ_ONLY
from clickgen.device.system import DISPUTED_SC, WRITABLE_SC, WRITABLE_SD, system_name_of
from clickgen.dialects.if_rungs.ways_out.hints import text_hint
from clickgen.dialects.if_rungs.ways_out.unwritable import instead_of
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.setpoints import setpoint_hint
from clickgen.facts.values import constant_fault, copies, fitting, value_class
from clickgen.instructions import moving
from clickgen.instructions.effects import Shape
from clickgen.instructions.spec import Access, Param, Slot, Spec
from clickgen.ir.operands import Cell, Constant, Immediate, Integer, Named, Operand, Pointer, Range, Text, form_of
from clickgen.ir.program import Action, Operands
from clickgen.problems.diagnostics import Diagnostics
from clickgen.resolve.constants import kind_of
from clickgen.text.source import Span

_WRITABLE = {"SC": WRITABLE_SC, "SD": WRITABLE_SD}


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        refused: set[Span] = set()
        for param in placed.spec.params:
            value = placed.action.args.get(param.name)
            for operand in value.items if isinstance(value, Operands) else (value,):
                # A name without an address is a problem already.
                if isinstance(operand, Operand) and not isinstance(operand, Named) and operand.span not in refused:
                    before = len(problems.found)
                    _check(facts, placed, param, operand, problems)
                    refused |= {operand.span} if len(problems.found) > before else set()
        _check_oneshot(placed.action, refused, problems)


def _check(facts: Facts, placed: Placed, param: Param, operand: Operand, problems: Diagnostics) -> None:
    slot = param.slot
    if slot.access is Access.WRITE and _is_read_only(facts, placed, operand, slot, problems):
        return
    if isinstance(operand, Immediate):
        if operand.bank not in slot.immediates:
            banks = f"; it takes immediate {', '.join(slot.immediates)}" if slot.immediates else ""
            problems.add(
                "CG308",
                operand.span,
                f"{placed.spec.name} takes no immediate {operand.bank} here{banks}",
                "leave out .immediate",
            )
    elif isinstance(operand, Pointer):
        if operand.bank not in slot.pointers:
            problems.add(
                "CG307",
                operand.span,
                f"{placed.spec.name} takes no pointer here: pointers stand in copies and formulas",
                "name the address itself"
                if slot.access is Access.WRITE
                else "copy the value to a register first, and use that",
            )
    elif isinstance(operand, Constant):
        _check_constant(facts, placed, param, operand, problems)
    elif operand.bank not in (slot.ranges if isinstance(operand, Range) else slot.cells):
        _refuse(facts, placed, param, operand, problems)
    elif isinstance(operand, Range) and operand.is_reversed and not slot.reversible:
        problems.add(
            "CG202", operand.span, f"{placed.spec.name} takes its range forwards", "write the slice without :-1"
        )
    elif operand.bank in slot.disputed:
        problems.add(
            "CG312",
            operand.span,
            f"no source shows {placed.spec.name} with {operand.bank} as {param.name!r}",
            "try it on the machine before you rely on it",
        )


def _refuse(facts: Facts, placed: Placed, param: Param, operand: Named | Cell | Range, problems: Diagnostics) -> None:
    slot = param.slot
    what = f"a range of {operand.bank}" if isinstance(operand, Range) else _shown(operand)
    help = f"for example: {placed.spec.example}"
    is_source = placed.effects.shape is Shape.BLOCK and param.name == placed.spec.matrix[0]
    unpacked = _packed(facts, operand, placed.action.moved_to) if is_source else ""
    if unpacked:
        help = unpacked
    elif isinstance(operand, Cell) and operand.bank in slot.ranges:
        number = operand.address.number
        bank = BANKS[operand.bank].dsl
        help = f"write a range: {bank}[{number}:{number + 1}] is one address"
    elif isinstance(operand, Range) and operand.bank in slot.cells:
        help = _of_range(facts, placed, param, operand)
    elif operand.bank in BANKS and not BANKS[operand.bank].is_bit and "C" in slot.cells:
        value = 0 if placed.effects.turns_off else 1
        help = f"{placed.spec.name} is for bits; a register gets a number with copy({value}, {_text(facts, operand)})"
    problems.add(
        "CG301",
        operand.span,
        f"{placed.spec.name} does not take {what} as {param.name!r}: it takes {slot.describe()}",
        help,
    )


def _text(facts: Facts, operand: Operand) -> str:
    """An operand as the program writes it, on one line."""
    return " ".join(facts.text(operand.span).split())


def _of_range(facts: Facts, placed: Placed, param: Param, operand: Range) -> str:
    """The way out for a range in the place of one address: its first, or the instruction that takes ranges."""
    text = _text(facts, operand)
    first = f"{text}[0]" if _BLOCK.fullmatch(text) else f"{BANKS[operand.bank].dsl}[{operand.first}]"
    general = f"it takes one address, such as {first}"
    if placed.effects.shape is not Shape.VALUE:
        return general
    source, target = placed.action.source, placed.action.moved_to
    packed = _packed(facts, source, target)
    if packed:
        return packed
    if param.slot.access is Access.WRITE and isinstance(source, Constant):
        if isinstance(source, Text) and operand.bank == "TXT":
            return f"name the first address, {first}: the text goes on from there"
        if BANKS[operand.bank].is_bit:
            off = isinstance(source, Integer) and source.value == 0
            return f"write {'reset' if off else 'set'}({text})"
        fills = f"to write all of them: copy_fill({_text(facts, source)}, {text})"
        return fills if copies(moving(Shape.FILL), source, operand) else general
    if param.slot.access is Access.WRITE or not isinstance(target, Cell | Range):
        return general
    shown = _text(facts, target)
    if isinstance(target, Range):
        shown = f"{shown}[0]" if _BLOCK.fullmatch(shown) else f"{BANKS[target.bank].dsl}[{target.first}]"
    if copies(moving(Shape.PACK), operand, target) and operand.bank == "TXT":
        return f"a text of several characters becomes a number with copy_pack({text}, {shown})"
    block = f"a range is copied with copy_block({text}, {shown})"
    return block if copies(moving(Shape.BLOCK), operand, target) else general


def _packed(facts: Facts, source: object, target: object) -> str:
    """The way out for bits or words that become one number, or one number that becomes bits or words."""
    if isinstance(source, Range) and isinstance(target, Cell):
        text = _packed_part(facts, moving(Shape.PACK), source, target, source)
        what = "bits become a number" if BANKS[source.bank].is_bit else "two words become one number"
        return f"{what} with copy_pack({text}, {_text(facts, target)})" if text else ""
    if isinstance(target, Range) and isinstance(source, Cell):
        text = _packed_part(facts, moving(Shape.UNPACK), source, target, target)
        what = "a number becomes bits" if BANKS[target.bank].is_bit else "a number becomes two words"
        return f"{what} with copy_unpack({_text(facts, source)}, {text})" if text else ""
    return ""


def _packed_part(facts: Facts, spec: Spec, source: Operand, target: Operand, part: Range) -> str:
    """The range as it is written, or as much of it as fits; "" where the banks are wrong. Of text the copy speaks."""
    pairs = (pair for variant in spec.variants for pair in variant.pairs)
    pair = next((one for one in pairs if form_of(source) in one.sources and form_of(target) in one.targets), None)
    if pair is None or part.bank == "TXT":
        return ""
    low, high = pair.lengths or (1, len(part))
    if low <= len(part) <= high:
        return _text(facts, part)
    is_cut = len(part) > high and BANKS[part.bank].is_bit and not part.is_reversed
    return f"{BANKS[part.bank].dsl}[{part.first}:{part.first + high}]" if is_cut else ""


_BLOCK = re.compile(r"[a-z]+(\.\w+|\[\"[^\"]*\"\])")
"""A name without an index, which is a block where it is a range."""


def _is_read_only(facts: Facts, placed: Placed, operand: Operand, slot: Slot, problems: Diagnostics) -> bool:
    """Report a target that nothing can write (click-facts [bank.read-only])."""
    target = operand.target if isinstance(operand, Immediate) else operand
    reason = READ_ONLY.get(target.bank) if isinstance(target, Named | Cell | Range | Pointer) else None
    if reason and not (isinstance(target, Pointer) and target.bank in slot.pointers and target.bank != "XD"):
        message = f"{_shown(target)} is {reason}: no instruction writes it"
        problems.add("CG304", operand.span, message, _instead(facts, placed, target))
        return True
    if isinstance(target, Cell):
        addresses = [target.address]
    else:
        addresses = list(target.addresses()) if isinstance(target, Range) else []
    for address in addresses:
        writable = _WRITABLE.get(address.bank)
        if writable is not None and address.number not in writable:
            numbers = ", ".join(map(str, sorted(writable)))
            help = f"{_instead(facts, placed, Cell(address, operand.span))}; the writable {address.bank}: {numbers}"
            problems.add("CG304", operand.span, f"{address} cannot be written", help)
            return True
    disputed = [str(address) for address in addresses if address.bank == "SC" and address.number in DISPUTED_SC]
    if disputed:
        problems.add(
            "CG312",
            operand.span,
            f"one list of CLICK's addresses has {', '.join(disputed)} as writable, and CLICK PLUS 3.41 has not",
            "try it on the machine before you rely on it",
        )
    return False


def _instead(facts: Facts, placed: Placed, target: object) -> str:
    """The way out for what only CLICK itself writes."""
    bank = getattr(target, "bank", "")
    name = facts.nickname(target.address) if isinstance(target, Cell) else ""
    dsl = bank.lower()
    if isinstance(target, Cell):
        shown = f"{dsl}.{name}" if name.isidentifier() else f"{dsl}[{target.address.number}]"
    else:
        shown = f"{dsl}[1]"
    own = (system_name_of(target.address) or "") if isinstance(target, Cell) else ""
    source = placed.action.source
    value = _text(facts, source) if isinstance(source, Cell | Constant) else ""
    owners = frozenset(one.spec.name for one in facts.actions if _owns(one, target))
    return instead_of(bank, shown, placed.spec.name, value, own, owners)


def _owns(placed: Placed, target: object) -> bool:
    """True for the instruction of this timer."""
    timer = placed.action.owned
    return timer is not None and isinstance(target, Cell) and timer.address == target.address


def _shown(target: object) -> str:
    if isinstance(target, Cell):
        return str(target.address)
    if isinstance(target, Named):
        return f"{target.bank.lower()}.{target.name}"
    bank = form_of(target)
    return f"{'an' if bank[0] == 'X' else 'a'} {bank} address"


def _check_constant(facts: Facts, placed: Placed, param: Param, constant: Constant, problems: Diagnostics) -> None:
    slot, action = param.slot, placed.action
    if form_of(constant) not in slot.constants:
        help = setpoint_hint(action, param, constant)
        if isinstance(constant, Text):
            help = help or text_hint(constant.value, BANKS[slot.cells[0]].dsl if slot.cells else "c")
        problems.add(
            "CG301",
            constant.span,
            f"{placed.spec.name} does not take this constant as {param.name!r}: it takes {slot.describe()}",
            help or f"for example: {placed.spec.example}",
        )
        return
    if isinstance(constant, Integer) and slot.limits:
        low, high = slot.limits
        if not low <= constant.value <= high:
            problems.add(
                "CG302",
                constant.span,
                f"{param.name!r} of {placed.spec.name} is {constant.value}, outside {low}..{high}",
                setpoint_hint(action, param, constant) or f"write a number from {low} to {high}",
            )
            return
    other = action.args.get(param.typed_by)
    if placed.effects.finds is not None and isinstance(other, Operand) and value_class(other) != value_class(constant):
        return  # the rule about searches has the word
    fault = constant_fault(constant, kind_of(other))
    if fault:
        shown = (
            _text(facts, other)
            if isinstance(other, Operand) and placed.effects.shape in (Shape.VALUE, Shape.FILL)
            else ""
        )

        def copied(number: str) -> str:
            return f"{placed.spec.name}({number}, {shown})" if shown else number

        problems.add("CG302", constant.span, fault, fitting(constant, kind_of(other), _text(facts, constant), copied))


def _check_oneshot(action: Action, refused: set[Span], problems: Diagnostics) -> None:
    target = action.driven
    if isinstance(target, Immediate) and action.flag("oneshot") and target.span not in refused:
        span = action.args["oneshot"].span
        problems.add("CG313", span, "an immediate coil has no one-shot", "leave out one of the two")
