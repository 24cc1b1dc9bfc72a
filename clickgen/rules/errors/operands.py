"""Each operand is one that its instruction takes there: its bank, its form, and the size of a constant."""

from __future__ import annotations

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.refusals import Refusal, operands_of, refusal, shown_target
from clickgen.facts.setpoints import setpoint_hint
from clickgen.facts.values import constant_fault, copies, fitting, value_class
from clickgen.instructions import moving
from clickgen.instructions.effects import Shape
from clickgen.instructions.offered import COPY, COPY_BLOCK, COPY_FILL, COPY_PACK, COPY_UNPACK, LATCH, UNLATCH
from clickgen.instructions.spec import Access, Param, Spec
from clickgen.ir.operands import Cell, Constant, Immediate, Integer, Named, Operand, Pointer, Range, Text, form_of
from clickgen.ir.program import Action
from clickgen.resolve.constants import kind_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.source import Span


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        said: set[Span] = set()
        for param, operand in operands_of(placed.action):
            if operand.span not in said:
                why = refusal(param.slot, operand)
                found = list(_check(facts, placed, param, operand, why))
                yield from found
                said |= {operand.span} if found or why else set()
        yield from _check_oneshot(placed.action, said)


def _check(facts: Facts, placed: Placed, param: Param, operand: Operand, why: Refusal | None) -> Findings:
    slot = param.slot
    if why is Refusal.READ_ONLY:
        return  # unwritable.py reports it
    if isinstance(operand, Immediate):
        if why:
            banks = f"; it takes immediate {', '.join(slot.immediates)}" if slot.immediates else ""
            yield finding(
                "CG308",
                operand.span,
                f"{placed.spec.name} takes no immediate {operand.bank} here{banks}",
                f"leave out {facts.spell.immediate}",
            )
    elif isinstance(operand, Pointer):
        if why:
            yield finding(
                "CG307",
                operand.span,
                f"{placed.spec.name} takes no pointer here: pointers stand in copies and formulas",
                "name the address itself"
                if slot.access is Access.WRITE
                else "copy the value to a register first, and use that",
            )
    elif isinstance(operand, Constant):
        yield from _check_constant(facts, placed, param, operand)
    elif why:
        yield from _refuse(facts, placed, param, operand)
    elif isinstance(operand, Range) and operand.is_reversed and not slot.reversible:
        yield finding(
            "CG202",
            operand.span,
            f"{placed.spec.name} takes its range forwards",
            f"write the range without {facts.spell.backwards}",
        )
    elif operand.bank in slot.disputed:
        yield finding(
            "CG312",
            operand.span,
            f"no source shows {placed.spec.name} with {operand.bank} as {param.name!r}",
            "try it on the machine before you rely on it",
        )


def _refuse(facts: Facts, placed: Placed, param: Param, operand: Named | Cell | Range) -> Findings:
    slot = param.slot
    what = f"a range of {operand.bank}" if isinstance(operand, Range) else shown_target(facts.spell, operand)
    help = f"for example: {facts.spell.example(placed.spec)}"
    is_source = placed.effects.shape is Shape.BLOCK and param.name == placed.spec.matrix[0]
    unpacked = _packed(facts, operand, placed.action.moved_to) if is_source else ""
    if unpacked:
        help = unpacked
    elif isinstance(operand, Cell) and operand.bank in slot.ranges:
        number = operand.address.number
        help = f"write a range: {facts.spell.range(operand.bank, number, number)} is one address"
    elif isinstance(operand, Range) and operand.bank in slot.cells:
        help = _of_range(facts, placed, param, operand)
    elif operand.bank in BANKS and not BANKS[operand.bank].is_bit and "C" in slot.cells:
        value = 0 if placed.effects.turns_off else 1
        copy = facts.spell.call(COPY, str(value), _text(facts, operand))
        help = f"{placed.spec.name} is for bits; a register gets a number with {copy}"
    yield finding(
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
    first = _first(facts, text, operand)
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
            return f"write {facts.spell.call(UNLATCH if off else LATCH, text)}"
        fills = f"to write all of them: {facts.spell.call(COPY_FILL, _text(facts, source), text)}"
        return fills if copies(moving(Shape.FILL), source, operand) else general
    if param.slot.access is Access.WRITE or not isinstance(target, Cell | Range):
        return general
    shown = _text(facts, target)
    if isinstance(target, Range):
        shown = _first(facts, shown, target)
    if copies(moving(Shape.PACK), operand, target) and operand.bank == "TXT":
        return f"a text of several characters becomes a number with {facts.spell.call(COPY_PACK, text, shown)}"
    block = f"a range is copied with {facts.spell.call(COPY_BLOCK, text, shown)}"
    return block if copies(moving(Shape.BLOCK), operand, target) else general


def _packed(facts: Facts, source: object, target: object) -> str:
    """The way out for bits or words that become one number, or one number that becomes bits or words."""
    if isinstance(source, Range) and isinstance(target, Cell):
        text = _packed_part(facts, moving(Shape.PACK), source, target, source)
        what = "bits become a number" if BANKS[source.bank].is_bit else "two words become one number"
        return f"{what} with {facts.spell.call(COPY_PACK, text, _text(facts, target))}" if text else ""
    if isinstance(target, Range) and isinstance(source, Cell):
        text = _packed_part(facts, moving(Shape.UNPACK), source, target, target)
        what = "a number becomes bits" if BANKS[target.bank].is_bit else "a number becomes two words"
        return f"{what} with {facts.spell.call(COPY_UNPACK, _text(facts, source), text)}" if text else ""
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
    return facts.spell.range(part.bank, part.first, part.first + high - 1) if is_cut else ""


def _first(facts: Facts, text: str, operand: Range) -> str:
    """The first address of a range that is written so: of a block its first member."""
    if facts.spell.is_name(text):
        return facts.spell.member(text, 0)
    return facts.spell.cell(Address(operand.bank, operand.first))


def _check_constant(facts: Facts, placed: Placed, param: Param, constant: Constant) -> Findings:
    slot, action = param.slot, placed.action
    if refusal(slot, constant):
        help = setpoint_hint(facts.spell, action, param, constant)
        if isinstance(constant, Text):
            help = help or facts.spell.address_hint(constant.value, slot.cells[0] if slot.cells else "C")
        yield finding(
            "CG301",
            constant.span,
            f"{placed.spec.name} does not take this constant as {param.name!r}: it takes {slot.describe()}",
            help or f"for example: {facts.spell.example(placed.spec)}",
        )
        return
    if isinstance(constant, Integer) and slot.limits:
        low, high = slot.limits
        if not low <= constant.value <= high:
            yield finding(
                "CG302",
                constant.span,
                f"{param.name!r} of {placed.spec.name} is {constant.value}, outside {low}..{high}",
                setpoint_hint(facts.spell, action, param, constant) or f"write a number from {low} to {high}",
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
            return facts.spell.call(placed.spec, number, shown) if shown else number

        way = fitting(constant, kind_of(other), _text(facts, constant), facts.spell, copied)
        yield finding("CG302", constant.span, fault, way)


def _check_oneshot(action: Action, said: set[Span]) -> Findings:
    target = action.driven
    if isinstance(target, Immediate) and action.flag("oneshot") and target.span not in said:
        span = action.args["oneshot"].span
        yield finding("CG313", span, "an immediate coil has no one-shot", "leave out one of the two")


CODES = (
    Code(
        "CG301",
        Severity.ERROR,
        "the instruction does not take this operand",
        """
The instruction takes another bank or another form here: a range instead of one address, for example, or
a register instead of a constant. The message lists what it takes.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    ton(t.Delay, setpoint=dd.Time)  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    ton(t.Delay, setpoint=ds.Time)
""",
        ),
    ),
    Code(
        "CG302",
        Severity.ERROR,
        "the constant is out of range",
        """
The constant does not fit: a setpoint above 32767 (choose a larger unit), a number that the destination
cannot hold, or a number that makes a comparison always true or always false.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    copy(40000, ds.Speed)  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    copy(40000, dd.Speed)
""",
        ),
    ),
    Code(
        "CG307",
        Severity.ERROR,
        "a pointer has no place here",
        """
A pointer is in a condition, or in an instruction other than `copy`, `calc` and `math_hex`. First copy
the value to a register, in an earlier rung.
""",
        wrong=(
            Wrong(
                """
if ds[ds.Index] == 5:  # <-
    out(y[1])
""",
            ),
        ),
        right=(
            """
if True:
    copy(ds[ds.Index], ds.Value)
if ds.Value == 5:
    out(y[1])
""",
        ),
    ),
    Code(
        "CG313",
        Severity.ERROR,
        "oneshot has no place here",
        """
An immediate coil has no one-shot. Put an edge contact, `re(...)`, in the rung's condition instead.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    out(y[1].immediate, oneshot=True)  # <-
""",
            ),
        ),
        right=(
            """
if re(x[1]):
    out(y[1].immediate)
""",
        ),
    ),
)

RULE = Rule(
    find,
    CODES,
    also=(
        "CG202",
        "CG308",
        "CG312",
    ),
    holds_in_parts=True,
)
