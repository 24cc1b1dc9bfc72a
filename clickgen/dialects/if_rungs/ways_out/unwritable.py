"""Addresses that no program writes: inputs, bits of timers and counters, CLICK's own points; what to use instead."""

from __future__ import annotations

import re

import libcst as cst

from clickgen.device.banks import CURRENT_VALUE_OF, READ_ONLY, Bank
from clickgen.device.system import WRITABLE_SC, WRITABLE_SD, system_nicknames
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import Node, index_of, name_of, text_value, whole_number, word
from clickgen.dialects.if_rungs.spelling import IfRungsSpelling
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, own
from clickgen.dialects.ways_out import counting, instead_of, reset_hint
from clickgen.instructions import INSTRUCTIONS

_WRITABLE = {"SC": WRITABLE_SC, "SD": WRITABLE_SD}


def why_unwritable(node: Node) -> str:
    """The description of an address that no instruction writes: ``an input``; "" for one that can be written."""
    bank = bank_of(node)
    if bank is None:
        return ""
    if bank.name in READ_ONLY:
        return READ_ONLY[bank.name]
    number = _system_number(bank, node) if bank.name in _WRITABLE else None
    return "one of CLICK's own" if number is not None else ""


def _system_number(bank: Bank, node: Node) -> int | None:
    """The number of a system point that is read-only; None for any other."""
    name, number = _name_of(node), None
    if name:
        known = system_nicknames().get(name.lower())
        number = known[1].number if known and known[1].bank == bank.name else None
    elif isinstance(node, cst.Subscript):
        index = whole_number(index_of(node))
        number = index if index is not None and bank.has(index) else None
    return None if number is None or number in _WRITABLE[bank.name] else number


def _name_of(node: Node) -> str:
    if isinstance(node, cst.Attribute) and name_of(node.value):
        return word(node.attr)
    return (text_value(index_of(node)) or "") if isinstance(node, cst.Subscript) else ""


def instead(context: Context, node: Node, action: str, value: str = "") -> str:
    """The code to write instead of an address that nothing writes: ``instead_of`` for a node."""
    bank = bank_of(node)
    assert bank is not None
    spec = INSTRUCTIONS[action]
    return instead_of(IfRungsSpelling(), bank.name, own(context, node), spec, value, _name_of(node))


def is_known_owner(context: Context, node: Node) -> bool:
    """True for a current value by its number, or by the name of a timer or counter that the file has."""
    return (
        isinstance(node, cst.Subscript)
        or re.search(rf"\b{re.escape(_owner(context, node))}\b", context.source.text) is not None
    )


def _owner(context: Context, node: Node) -> str:
    bank = bank_of(node)
    assert bank is not None
    return CURRENT_VALUE_OF[bank.name].lower() + own(context, node)[len(bank.dsl) :]


def of_current_value(context: Context, node: Node, value: str) -> str:
    """The way out when somebody resets or starts a timer by its current value: ``reset(td.A)``, ``td.A = 0``."""
    bank, shown = bank_of(node), own(context, node)
    assert bank is not None
    owner, written = _owner(context, node), f"copy({value}, {shown})"
    is_timer = bank.name == "TD"
    if value == "0":
        hint = reset_hint(IfRungsSpelling(), CURRENT_VALUE_OF[bank.name], owner)
        alone = f"its current value alone is cleared with {written}"
        return f"{alone}; {hint}" if is_known_owner(context, node) else f"{hint}; then {alone}"
    if is_known_owner(context, node):
        return f"write {written}"
    box = counting(IfRungsSpelling(), CURRENT_VALUE_OF[bank.name], owner)
    what = "timer" if is_timer else "counter"
    return f"a {what} counts by itself, {box}, and then its current value is written with {written}"
