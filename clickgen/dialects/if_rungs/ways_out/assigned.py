"""Ways out for assignments: CLICK has addresses and instructions that write them."""

from __future__ import annotations

import libcst as cst

from clickgen.device.banks import CURRENT_VALUE_OF, VALUE_BANK, Bank, Kind
from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    ADDRESSES,
    Node,
    arguments,
    called,
    is_literal,
    literal,
    name_of,
    whole_number,
    word,
)
from clickgen.dialects.if_rungs.trade import FORMULAS, MEMBERS, advice
from clickgen.dialects.if_rungs.ways_out.driven import as_it_is, rung_of
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, has_bits, own, replaced
from clickgen.dialects.if_rungs.ways_out.unwritable import instead, is_known_owner, of_current_value, why_unwritable
from clickgen.dialects.if_rungs.ways_out.way_out import WayOut


def assignment(context: Context, node: cst.Assign | cst.AugAssign | cst.AnnAssign) -> WayOut:
    """Return the instruction that stores the assigned value."""
    targets = [one.target for one in node.targets] if isinstance(node, cst.Assign) else [node.target]
    target, value = targets[0], node.value
    bank = bank_of(target)
    shown, text = own(context, target), own(context, value) if value is not None else ""
    general = "to set a value write copy(value, address) or calc(formula, address)"
    if isinstance(node, cst.AnnAssign) and value is None:
        rung = rung_of(context, target, [node.annotation.annotation])
        return WayOut(f"write {rung}", "a condition stands in an if") if rung else WayOut(general)
    if len(targets) > 1 or value is None or not text or not shown:
        return WayOut(general)
    if bank is None:
        name = name_of(target)
        return WayOut(_no_variable(name, value, text) if name else general)
    member = _current_value_of(context, target)
    if member and isinstance(node, cst.Assign) and fits_action(context, f"copy({text}, {member})"):
        return WayOut(f"write copy({text}, {member})", f"{shown} is written {member} here")
    if why_unwritable(target):
        return _unwritable(context, node, target, value, text)
    if bank.is_bit and isinstance(node, cst.Assign):
        return _bit(context, node, shown, value, text)
    if (
        bank.name in CURRENT_VALUE_OF
        and isinstance(node, cst.Assign)
        and fits_action(context, f"copy({text}, {shown})")
    ):
        fix = replaced(context, node, f"copy({text}, {shown})", is_safe=False)
        return WayOut(of_current_value(context, target, text), fix=fix if is_known_owner(context, target) else None)
    if isinstance(node, cst.AugAssign):
        return _counted(context, node, bank, shown, text)
    written = f"copy({text}, {shown})"
    if fits_action(context, written):
        return WayOut(f"write {written}", fix=replaced(context, node, written, _is_exact(bank, value)))
    other = bank_of(value)
    if other is not None and other.is_bit:
        return WayOut(
            f"a bit becomes a number in two rungs: if {text}: copy(1, {shown}) and if nc({text}): copy(0, {shown})"
        )
    chosen = advice(called(value), FORMULAS)
    if isinstance(value, cst.Call) and chosen is not None and chosen.has_several:
        written = chosen.written([own(context, one) for one in arguments(value)], shown)
        if written:
            return WayOut(chosen.of(written))
    written = formula_call(bank, text, shown)
    if written and not has_bits(value) and fits_action(context, written):
        return WayOut(f"write {written}", fix=replaced(context, node, written, is_safe=False))
    return WayOut(general)


_SIGNS: dict[type[Node], str] = {
    cst.AddAssign: "+",
    cst.SubtractAssign: "-",
    cst.MultiplyAssign: "*",
    cst.DivideAssign: "/",
    cst.FloorDivideAssign: "/",
}
_EXACT = (cst.AddAssign, cst.SubtractAssign, cst.MultiplyAssign)


def _counted(context: Context, node: cst.AugAssign, bank: Bank, shown: str, text: str) -> WayOut:
    """``ds[1] += 1`` as ``calc("ds[1] + 1", ds[1])``."""
    sign = _SIGNS.get(node.operator.__class__, "")
    inner = text if node.value.__class__ in ADDRESSES or is_literal(node.value) else f"({text})"
    written = formula_call(bank, f"{shown} {sign} {inner}", shown) if sign else ""
    if not written or not fits_action(context, written):
        return WayOut('to change a value write a formula: calc("ds.A + 1", ds.A)')
    is_whole = whole_number(node.value) is not None
    is_exact = isinstance(node.operator, _EXACT) and bank.name in ("DS", "DD")
    is_safe = is_exact and is_whole and not _is_part(node.target)
    return WayOut(f"write {written}", fix=replaced(context, node, written, is_safe))


def _is_part(node: Node) -> bool:
    return not isinstance(node, cst.Attribute | cst.Subscript) or not name_of(node.value)


def formula_call(bank: Bank, formula: str, destination: str) -> str:
    """``calc("...", ds.A)``, for a word ``math_hex``; "" where quotes are in the way."""
    if '"' in formula and "'" in formula:
        return ""
    quote = "'" if '"' in formula else '"'
    return f"{'math_hex' if bank.kind is Kind.HEX else 'calc'}({quote}{formula}{quote}, {destination})"


def _is_exact(bank: Bank, value: Node) -> bool:
    """True where a copy stores just the value: a whole number, or a register of the same bank."""
    if is_literal(value):
        return whole_number(value) is not None and bank.name in ("DS", "DD")
    return bank_of(value) is bank


STATES = {"true": "set", "1": "set", "on": "set", "false": "reset", "0": "reset", "off": "reset"}
"""What a bit is given, and the instruction that does it."""


def _bit(context: Context, node: cst.Assign, shown: str, value: Node, text: str) -> WayOut:
    """A bit that is assigned: turned on or off, or driven by what is on the right."""
    state = _state(value, text)
    if state == "set":
        ways = f"write set({shown}) to turn it on until it is reset, or out({shown}) to have it follow the rung"
        fix = replaced(context, node, f"set({shown})", is_safe=False)
        return WayOut(ways, fix=fix if fits_action(context, f"set({shown})") else None)
    if state == "reset":
        return WayOut(f"write reset({shown})", fix=replaced(context, node, f"reset({shown})", is_safe=False))
    condition = as_it_is(context, value) or "c.A"
    return WayOut(f"drive it under its condition: if {condition}: out({shown})")


def _state(value: Node, text: str) -> str:
    """``set`` or ``reset`` for a value that a bit is given; "" for any other."""
    word = str(literal(value)) if is_literal(value) else text
    return STATES.get(word.lower(), "")


def _unwritable(
    context: Context, node: cst.Assign | cst.AugAssign | cst.AnnAssign, target: Node, value: Node, text: str
) -> WayOut:
    """An assignment to what nothing in a program writes: ``x[1] = 1``."""
    message = f"{own(context, target)} is {why_unwritable(target)}: no instruction writes it"
    bank = bank_of(target)
    if bank is not None and not bank.is_bit:
        if isinstance(node, cst.AugAssign):
            formula = f"{own(context, target)} {_SIGNS.get(node.operator.__class__, '')} {text}"
            written = formula_call(bank, formula, "dh.Name" if bank.kind is Kind.HEX else "ds.Name")
            if written and fits_action(context, written):
                return WayOut(f"write a register of the program: {written}", message)
        fits = fits_action(context, f"copy({text}, dd.Name)") and bank_of(value) is not bank
        return WayOut(instead(context, target, "copy", text if fits else ""), message)
    state = _state(value, text)
    if state:
        return WayOut(instead(context, target, state), message)
    condition = as_it_is(context, value) or "c.A"
    return WayOut(f"{instead(context, target, 'out')}, in a rung of its own: if {condition}: out(c.Name)", message)


def _current_value_of(context: Context, target: Node) -> str:
    """``td[1]`` for ``t[1].acc``; "" for anything else."""
    if not isinstance(target, cst.Attribute) or MEMBERS.get(word(target.attr).lower()) != "current":
        return ""
    owner = bank_of(target.value)
    value = VALUE_BANK.get(owner.name, "").lower() if owner is not None else ""
    return value + own(context, target.value)[len(owner.dsl) :] if owner is not None and value else ""


def _no_variable(name: str, value: Node, text: str) -> str:
    """The way out for a name of its own: CLICK has addresses and no variables."""
    bank = bank_of(value)
    if bank is not None:
        return f"give the address a nickname, nickname({bank.dsl}.{name}, {text}), and write {bank.dsl}.{name}"
    number = literal(value)
    if isinstance(number, int | float):
        if isinstance(number, bool):
            home = f"nickname(c.{name}, c[1], initial={int(number)})"
        else:
            is_whole = isinstance(number, int)
            dsl = "df" if not is_whole else "ds" if -32768 <= number <= 32767 else "dd"
            home = f"nickname({dsl}.{name}, {dsl}[1], initial={text}, retentive=False)"
        return f"write {text} where it is used, or keep it in a register of its own, {home}, and use that"
    if is_literal(value):
        return f"write {text} where it is used"
    return "a program has no variables; a register keeps a value: copy(5, ds.Limit)"
