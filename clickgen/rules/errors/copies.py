"""Copies go only between banks that CLICK copies between, with ranges that match.

click-facts [copy.block, copy.convert, copy.single]
"""

from __future__ import annotations

import re

from clickgen.device.banks import BANKS, PADDED_DIGITS, Address, Kind
from clickgen.dialects.if_rungs.ways_out.hints import flat_address
from clickgen.facts.facts import Facts
from clickgen.facts.values import copies, refused_operands
from clickgen.instructions import moving
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.effects import Shape
from clickgen.instructions.spec import Pair, ParamKind
from clickgen.ir.operands import Cell, Integer, Range, Text, form_of
from clickgen.ir.program import Action, Options
from clickgen.ir.reach import reached
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.wording import counted


def check(facts: Facts, problems: Diagnostics) -> None:
    refused = refused_operands(problems)
    for placed in facts.actions:
        action = placed.action
        operands = [action.args[name] for name in placed.spec.matrix if name]
        if not operands or any(operand.span in refused for operand in operands):
            continue
        if _check_options(action, problems) and _check_pair(facts, action, problems):
            _check_flags(action, problems)
            _check_lengths(action, problems)


def _check_flags(action: Action, problems: Diagnostics) -> None:
    """A flag that the chosen form of the instruction does not have, such as allow_whitespace for bits."""
    for param in action.spec.params:
        if param.kind is ParamKind.FLAG and action.flag(param.name) and f"{{{param.name}}}" not in action.variant.token:
            name = action.variant.token.partition("(")[0]
            problems.add(
                "CG314", action.args[param.name].span, f"{name} has no {param.name}: it is for text", "leave it out"
            )


def _check_options(action: Action, problems: Diagnostics) -> bool:
    """False with a problem."""
    options = action.args.get("options")
    if not isinstance(options, Options):
        return True
    before = len(problems.found)
    _judge_options(action, options, problems)
    return len(problems.found) == before


def _judge_options(action: Action, options: Options, problems: Diagnostics) -> None:
    spec = action.spec
    if options.name not in spec.conversions:
        takes = f"it takes {', '.join(spec.conversions)}" if spec.conversions else "it converts nothing"
        problems.add("CG314", options.span, f"{spec.name} has no option {options.name}: {takes}", "leave it out")
        return
    sources, targets = CONVERSIONS[options.name]
    source, target = (form_of(action.args[name]) for name in spec.matrix)
    if source not in sources or target not in targets:
        problems.add(
            "CG314",
            options.span,
            f"{options.name} converts {'/'.join(sources)} to {'/'.join(targets)}, not {source} to {target}",
            "leave it out, or choose another option",
        )
    elif options.exponential and source != "DF":
        problems.add(
            "CG314", options.span, "exponential text is for floating-point numbers (DF)", "leave out exponential=True"
        )
    elif options.exponential and not options.suppress_zero:
        # laddercodec gives this pair the code of to_value: CLICK would run another instruction (click-facts
        # [copy.exponential]).
        problems.add(
            "CG314",
            options.span,
            "exponential text with leading zeros cannot be put into CLICK",
            "leave out suppress_zero=False",
        )
    elif options.pad is not None and options.pad != PADDED_DIGITS.get(BANKS[source].kind):
        digits = PADDED_DIGITS.get(BANKS[source].kind)
        problems.add(
            "CG314",
            options.span,
            f"CLICK cannot pad {source} to {options.pad} characters",
            f"write pad={digits}: all digits of the type" if digits else "leave out pad",
        )


def _check_pair(facts: Facts, action: Action, problems: Diagnostics) -> bool:
    """False when CLICK does not copy between these."""
    spec = action.spec
    source, target = (action.args[name] for name in spec.matrix)
    source_form, target_form = form_of(source), form_of(target)
    pairs = [pair for variant in spec.variants for pair in variant.pairs]
    pair = next((pair for pair in pairs if source_form in pair.sources and target_form in pair.targets), None)
    if pair is None:
        _refuse(facts, action, source_form, target_form, pairs, problems)
        return False
    if pair.disputed:
        problems.add(
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
            problems.add(
                "CG306",
                packed.span,
                f"this range has {counted(len(packed), 'address', 'addresses')}; {source_form} to {target_form} takes "
                f"{allowed}",
                "the end of a slice is not included: c[1:17] is 16 bits",
            )
    return True


def _refuse(facts: Facts, action: Action, source: str, target: str, pairs: list[Pair], problems: Diagnostics) -> None:
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
        shown = facts.text(bit.span) if isinstance(bit, Cell) else "c.Name"
        is_off = isinstance(value, Integer) and value.value == 0
        help = f"a bit is turned off with reset({shown})" if is_off else f"a bit is turned on with set({shown})"
    help = _instead(facts, action) or help
    problems.add("CG305", action.span, f"CLICK cannot {action.spec.name} from {source} to {target}", help)


def _instead(facts: Facts, action: Action) -> str:
    """The way out for a copy that another instruction makes, or that a constant in quotes spoils; "" for none."""
    source, target = (action.args[name] for name in action.spec.matrix)
    if not isinstance(target, Cell | Range) or (isinstance(target, Cell) and target.address.upper):
        return ""
    name, shape, to = action.spec.name, action.effects.shape, facts.text(target.span)
    is_bit = BANKS[target.bank].is_bit
    if isinstance(source, Text) and not is_bit and shape in (Shape.VALUE, Shape.FILL):
        return _unquoted(name, source.value, target.bank, to)
    if isinstance(source, Integer) and is_bit and isinstance(target, Range):
        return f"bits are turned {'on with set' if source.value else 'off with reset'}({to})"
    if not isinstance(source, Cell | Range):
        return ""
    given = facts.text(source.span)
    if shape is Shape.VALUE and isinstance(source, Cell) and isinstance(target, Cell):
        if BANKS[source.bank].is_bit and not is_bit:
            return f"a bit becomes a number in two rungs: if {given}: copy(1, {to}) and if nc({given}): copy(0, {to})"
        if is_bit and BANKS[source.bank].kind not in (Kind.BIT, Kind.TEXT):
            none = "0x0000" if BANKS[source.bank].kind is Kind.HEX else "0"
            return f"a number becomes a bit by a comparison: if {given} != {none}: out({to})"
    if shape is Shape.BLOCK and copies(moving(Shape.PACK), source, target) and isinstance(target, Cell):
        return f"bits or words become one number with copy_pack({given}, {to})"
    return ""


_ADDRESS = re.compile(r"(?:x|y|c|t|ct|sc|ds|dd|dh|df|xd|yd|td|ctd|sd|txt)[.\[][^\n]+")


def _unquoted(name: str, text: str, bank: str, to: str) -> str:
    """The way out for a text that goes to a number: ``copy("5", ds.A)``."""
    kind = BANKS[bank].kind
    if kind is Kind.HEX and re.fullmatch(r"(?:0[xX])?[0-9A-Fa-f]{1,4}[hH]?", text):
        number = text.lower().removeprefix("0x").rstrip("h")
        return f"without quotes it is a number: {name}(0x{int(number, 16):04X}, {to})"
    if re.fullmatch(r"[+-]?[0-9]{1,9}", text):
        return f"without quotes it is a number: {name}({int(text)}, {to})"
    if re.fullmatch(r"[+-]?[0-9]{1,9}[.,][0-9]{1,9}", text):
        decimal = text.replace(",", ".")
        where = to if kind is Kind.FLOAT else "df.Name"
        return f"without quotes it is a number, and decimals go to DF: {name}({decimal}, {where})"
    flat = flat_address(text)
    if flat or _ADDRESS.fullmatch(text):
        return f"without quotes it is an address: {name}({flat or text}, {to})"
    return f'text goes to TXT: copy("{text}", txt.Name)' if name == "copy" and text.isprintable() else ""


def _check_lengths(action: Action, problems: Diagnostics) -> None:
    source, target = (action.args[name] for name in action.spec.matrix)
    if action.effects.shape is Shape.FILL and isinstance(source, Text) and len(source.value) > 1:
        help = 'fill with one: copy_fill("A", txt[1:9])'
        problems.add("CG302", source.span, "a TXT address holds one character", help)
    param = next(param for param in action.spec.params if param.name == action.spec.matrix[1])
    whole = reached(action, param)
    # How many characters a number becomes is known only when it is copied, so only its most is reserved.
    is_sure = isinstance(source, Text) or bool(param.extends_over)
    if isinstance(target, Cell) and isinstance(whole, Range) and is_sure:
        _check_room(whole, target, problems)
    if not param.extends_over:
        return
    if isinstance(target, Cell) and target.address.upper:
        problems.add("CG301", target.span, f"a block cannot begin at {target.address}", "copy it with copy(...)")
    if isinstance(target, Range) and isinstance(source, Range) and len(target) != len(source):
        problems.add(
            "CG306",
            target.span,
            f"the source has {counted(len(source), 'address', 'addresses')} and the destination {len(target)}",
            "write the destination's first address alone; its end follows from the source",
        )


def _check_room(whole: Range, first: Cell, problems: Diagnostics) -> None:
    bank = BANKS[whole.bank]
    if not all(bank.has(address.number) for address in whole.addresses()):
        problems.add(
            "CG306",
            first.span,
            f"the copy would reach {Address(whole.bank, whole.last)}: {bank.name} has {bank.describe_range()}",
            "begin it earlier, or copy fewer addresses",
        )
