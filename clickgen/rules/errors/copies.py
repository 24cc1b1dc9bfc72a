"""Copies go only between banks that CLICK copies between, with ranges that match.

click-facts [copy.block, copy.convert, copy.single]
"""

from __future__ import annotations

import re

from clickgen.device.banks import BANKS, PADDED_DIGITS, Address, Kind, parse_address
from clickgen.dialects.base import Spelling
from clickgen.facts.facts import Facts
from clickgen.facts.refusals import refused
from clickgen.facts.values import copies
from clickgen.instructions import moving
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.effects import Shape
from clickgen.instructions.offered import COIL, COPY, COPY_FILL, COPY_PACK, LATCH, UNLATCH
from clickgen.instructions.spec import Pair, ParamKind, Spec
from clickgen.ir.operands import Cell, Integer, Range, Text, form_of
from clickgen.ir.program import Action, Options
from clickgen.ir.reach import reached
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.wording import counted


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        action = placed.action
        operands = [action.args[name] for name in placed.spec.matrix if name]
        if operands and refused(action).isdisjoint(operand.span for operand in operands):
            yield from _check(facts, action)


def _check(facts: Facts, action: Action) -> Findings:
    wrong = list(_check_options(facts.spell, action))
    yield from wrong
    if wrong:
        return
    pairs = [pair for variant in action.spec.variants for pair in variant.pairs]
    source, target = (form_of(action.args[name]) for name in action.spec.matrix)
    pair = next((pair for pair in pairs if source in pair.sources and target in pair.targets), None)
    if pair is None:
        yield from _refuse(facts, action, source, target, pairs)
        return
    yield from _check_pair(facts.spell, action, pair)
    yield from _check_flags(action)
    yield from _check_lengths(facts.spell, action)


def _check_flags(action: Action) -> Findings:
    """A flag that the chosen form of the instruction does not have, such as allow_whitespace for bits."""
    for param in action.spec.params:
        if param.kind is ParamKind.FLAG and action.flag(param.name) and f"{{{param.name}}}" not in action.variant.token:
            name = action.variant.token.partition("(")[0]
            yield finding(
                "CG314", action.args[param.name].span, f"{name} has no {param.name}: it is for text", "leave it out"
            )


def _check_options(spell: Spelling, action: Action) -> Findings:
    options, spec = action.args.get("options"), action.spec
    if not isinstance(options, Options):
        return
    if options.name not in spec.conversions:
        takes = f"it takes {', '.join(spec.conversions)}" if spec.conversions else "it converts nothing"
        yield finding("CG314", options.span, f"{spec.name} has no option {options.name}: {takes}", "leave it out")
        return
    sources, targets = CONVERSIONS[options.name]
    source, target = (form_of(action.args[name]) for name in spec.matrix)
    if source not in sources or target not in targets:
        yield finding(
            "CG314",
            options.span,
            f"{options.name} converts {'/'.join(sources)} to {'/'.join(targets)}, not {source} to {target}",
            "leave it out, or choose another option",
        )
    elif options.exponential and source != "DF":
        yield finding(
            "CG314",
            options.span,
            "exponential text is for floating-point numbers (DF)",
            f"leave out {spell.setting('exponential', 'True')}",
        )
    elif options.exponential and not options.suppress_zero:
        # laddercodec gives this pair the code of to_value: CLICK would run another instruction (click-facts
        # [copy.exponential]).
        yield finding(
            "CG314",
            options.span,
            "exponential text with leading zeros cannot be put into CLICK",
            f"leave out {spell.setting('suppress_zero', 'False')}",
        )
    elif options.pad is not None and options.pad != PADDED_DIGITS.get(BANKS[source].kind):
        digits = PADDED_DIGITS.get(BANKS[source].kind)
        yield finding(
            "CG314",
            options.span,
            f"CLICK cannot pad {source} to {options.pad} characters",
            f"write {spell.setting('pad', str(digits))}: all digits of the type" if digits else "leave out pad",
        )


def _check_pair(spell: Spelling, action: Action, pair: Pair) -> Findings:
    """CLICK copies between these, if the sources agree about it and the lengths fit."""
    spec = action.spec
    source, target = (action.args[name] for name in spec.matrix)
    source_form, target_form = form_of(source), form_of(target)
    if pair.disputed:
        yield finding(
            "CG312",
            action.span,
            f"{spec.name} from {source_form} to {target_form}: {pair.disputed}",
            "try it on the machine before you rely on it",
        )
    if pair.lengths:
        packed = source if isinstance(source, Range) else target
        low, high = pair.lengths
        if isinstance(packed, Range) and not low <= len(packed) <= high:
            allowed = str(low) if low == high else f"{low} to {high}"
            yield finding(
                "CG306",
                packed.span,
                f"this range has {counted(len(packed), 'address', 'addresses')}; {source_form} to {target_form} takes "
                f"{allowed}",
                f"{spell.range('C', 1, 16)} is 16 bits{f'; {spell.range_end}' if spell.range_end else ''}",
            )


def _refuse(facts: Facts, action: Action, source: str, target: str, pairs: list[Pair]) -> Findings:
    reachable = list(dict.fromkeys(bank for pair in pairs if source in pair.sources for bank in pair.targets))
    help = (
        f"{source} goes to {', '.join(reachable)}" if reachable else f"{action.spec.name} copies nothing from {source}"
    )
    if (
        action.effects.shape is Shape.VALUE
        and BANKS.get(target) is not None
        and BANKS[target].is_bit
        and source not in BANKS
    ):
        bit, value = action.args[action.spec.matrix[1]], action.args[action.spec.matrix[0]]
        shown = facts.text(bit.span) if isinstance(bit, Cell) else facts.spell.name("C", "Name")
        is_off = isinstance(value, Integer) and value.value == 0
        help = f"a bit is turned {_switched(facts.spell, not is_off, shown)}"
    help = _instead(facts, action) or help
    yield finding("CG305", action.span, f"CLICK cannot {action.spec.name} from {source} to {target}", help)


def _instead(facts: Facts, action: Action) -> str:
    """The way out for a copy that another instruction makes, or that a constant in quotes spoils; "" for none."""
    source, target = (action.args[name] for name in action.spec.matrix)
    if not isinstance(target, Cell | Range) or (isinstance(target, Cell) and target.address.upper):
        return ""
    shape, to, spell = action.effects.shape, facts.text(target.span), facts.spell
    is_bit = BANKS[target.bank].is_bit
    if isinstance(source, Text) and not is_bit and shape in (Shape.VALUE, Shape.FILL):
        return _unquoted(facts.spell, action.spec, source.value, target.bank, to)
    if isinstance(source, Integer) and is_bit and isinstance(target, Range):
        return f"bits are turned {_switched(facts.spell, bool(source.value), to)}"
    if not isinstance(source, Cell | Range):
        return ""
    given = facts.text(source.span)
    if shape is Shape.VALUE and isinstance(source, Cell) and isinstance(target, Cell):
        if BANKS[source.bank].is_bit and not is_bit:
            one = spell.rung(given, spell.call(COPY, "1", to))
            other = spell.rung(spell.off(given), spell.call(COPY, "0", to))
            return f"a bit becomes a number in two rungs: {one} and {other}"
        if is_bit and BANKS[source.bank].kind not in (Kind.BIT, Kind.TEXT):
            none = spell.hexadecimal(0) if BANKS[source.bank].kind is Kind.HEX else "0"
            rung = spell.rung(spell.compared(given, "!=", none), spell.call(COIL, to))
            return f"a number becomes a bit by a comparison: {rung}"
    if shape is Shape.BLOCK and copies(moving(Shape.PACK), source, target) and isinstance(target, Cell):
        return f"bits or words become one number with {spell.call(COPY_PACK, given, to)}"
    return ""


def _switched(spell: Spelling, is_on: bool, bits: str) -> str:
    """``on with set(c.Name)``, ``off with reset(c.Name)``"""
    return f"{'on' if is_on else 'off'} with {spell.call(LATCH if is_on else UNLATCH, bits)}"


def _unquoted(spell: Spelling, spec: Spec, text: str, bank: str, to: str) -> str:
    """The way out for a text that goes to a number: ``copy("5", ds.A)``."""
    kind = BANKS[bank].kind
    if kind is Kind.HEX and re.fullmatch(r"(?:0[xX])?[0-9A-Fa-f]{1,4}[hH]?", text):
        number = text.lower().removeprefix("0x").rstrip("h")
        return f"without quotes it is a number: {spell.call(spec, spell.hexadecimal(int(number, 16)), to)}"
    if re.fullmatch(r"[+-]?[0-9]{1,9}", text):
        return f"without quotes it is a number: {spell.call(spec, str(int(text)), to)}"
    if re.fullmatch(r"[+-]?[0-9]{1,9}[.,][0-9]{1,9}", text):
        decimal = text.replace(",", ".")
        where = to if kind is Kind.FLOAT else spell.name("DF", "Name")
        return f"without quotes it is a number, and decimals go to DF: {spell.call(spec, decimal, where)}"
    address = parse_address(text) if len(text) < 10 else None
    if address is not None or spell.is_address(text):
        shown = text if address is None else spell.cell(address)
        return f"without quotes it is an address: {spell.call(spec, shown, to)}"
    if spec.effects.shape is not Shape.VALUE or not text.isprintable():
        return ""
    return f"text goes to TXT: {spell.call(COPY, spell.quoted(text), spell.name('TXT', 'Name'))}"


def _check_lengths(spell: Spelling, action: Action) -> Findings:
    source, target = (action.args[name] for name in action.spec.matrix)
    if action.effects.shape is Shape.FILL and isinstance(source, Text) and len(source.value) > 1:
        help = f"fill with one: {spell.call(COPY_FILL, spell.quoted('A'), spell.range('TXT', 1, 8))}"
        yield finding("CG302", source.span, "a TXT address holds one character", help)
    param = next(param for param in action.spec.params if param.name == action.spec.matrix[1])
    whole = reached(action, param)
    # How many characters a number becomes is known only when it is copied, so only its most is reserved.
    is_sure = isinstance(source, Text) or bool(param.extends_over)
    if isinstance(target, Cell) and isinstance(whole, Range) and is_sure:
        yield from _check_room(whole, target)
    if not param.extends_over:
        return
    if isinstance(target, Cell) and target.address.upper:
        yield finding(
            "CG301", target.span, f"a block cannot begin at {target.address}", f"copy it with {spell.call(COPY, '...')}"
        )
    if isinstance(target, Range) and isinstance(source, Range) and len(target) != len(source):
        yield finding(
            "CG306",
            target.span,
            f"the source has {counted(len(source), 'address', 'addresses')} and the destination {len(target)}",
            "write the destination's first address alone; its end follows from the source",
        )


def _check_room(whole: Range, first: Cell) -> Findings:
    bank = BANKS[whole.bank]
    if not all(bank.has(address.number) for address in whole.addresses()):
        yield finding(
            "CG306",
            first.span,
            f"the copy would reach {Address(whole.bank, whole.last)}: {bank.name} has {bank.describe_range()}",
            "begin it earlier, or copy fewer addresses",
        )


CODES = (
    Code(
        "CG305",
        Severity.ERROR,
        "CLICK cannot copy between these",
        """
CLICK's copy instructions cannot copy from this bank to that one. The pages of the [copy
family](../instructions/README.md#the-copy-family) list the pairs that work. You cannot copy a constant into a bit:
use `set` and `reset`. `send` and `receive` move bits to bits and registers to registers.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    copy(1, c.Run)  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    set(c.Run)
    copy(1, ds.Mode)
""",
        ),
    ),
    Code(
        "CG306",
        Severity.ERROR,
        "the range has the wrong length",
        """
Source and destination have different lengths, a copy ends outside the bank, or the program packs more
bits than the word has. Or a search ends in another bank than it begins in, or before its beginning. Or a Modbus
request moves more than [the protocol allows](../language.md#send-and-receive), or goes past the end of the bank in
the other CLICK. A slice excludes its end: `c[1:17]` is 16 bits.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    copy_pack(c[1:18], dh.Word)  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    copy_pack(c[1:17], dh.Word)
""",
        ),
    ),
    Code(
        "CG312",
        Severity.WARNING,
        "sources disagree whether CLICK takes this",
        """
One source says that CLICK takes this and another says that it does not, or no source shows it. clickgen
builds it. Try it on your CLICK before you rely on it. The pages of the [instructions](../instructions/README.md) name
the banks.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    copy_pack(x[1:9], ds.Inputs)  # <-
    search(ds[1:101] >= 100, result=dd.At, found=c.Found)  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    copy_pack(x[1:9], dh.Inputs)
    search(ds[1:101] >= 100, result=ds.At, found=c.Found)
""",
        ),
    ),
    Code(
        "CG314",
        Severity.ERROR,
        "this option has no place here",
        """
The option or modifier does not fit this instruction or these banks. For example, `to_text` needs a
number and a TXT address, and `copy_fill` converts nothing. With `pad`, CLICK writes all digits of the type and no
other number of digits. `allow_whitespace` is for text, `word_swap` is for registers, and a decimal Modbus address
already implies its register type.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    copy(ds.Speed, ds.Copy, options=to_text)  # <-
    copy(ds.Weight.as_text(pad=3), txt[1])  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    copy(ds.Weight.as_text(pad=5), txt[1])
""",
        ),
    ),
)

RULE = Rule(
    find,
    CODES,
    also=(
        "CG301",
        "CG302",
    ),
    holds_in_parts=True,
)
