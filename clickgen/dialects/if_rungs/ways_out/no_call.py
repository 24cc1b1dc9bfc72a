"""Ways out for calls of instructions that do not exist, and for arguments that have other names elsewhere."""

from __future__ import annotations

import re
from collections.abc import Sequence

import libcst as cst

from clickgen.device.banks import Bank
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import Node, arguments, is_name, keyword_name, keywords, name_of, word
from clickgen.dialects.if_rungs.spelling import IfRungsSpelling
from clickgen.dialects.if_rungs.trade import ACTIONS, ARGUMENTS, CONDITIONS, advice
from clickgen.dialects.if_rungs.ways_out.hints import (
    Fits,
    own,
    own_code,
    replaced,
    timers_of,
    trade_advice,
)
from clickgen.dialects.ways_out import reset_hint
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.spec import ParamKind, Spec
from clickgen.ir.addresses import BANK_NAMES
from clickgen.problems.diagnostics import did_you_mean
from clickgen.text.edits import Edit, Fix

_FUNCTIONS = ("all", "any", "nc", "re", "fe")
_LIST = "clickgen explain instructions lists them all"
_RESETS = ("res", "rst", "clr", "clear")
_METHODS = {
    "on": "set",
    "turn_on": "set",
    "latch": "set",
    "off": "reset",
    "turn_off": "reset",
    "unlatch": "reset",
    "write": "copy",
    "assign": "copy",
}
"""The methods that people call on an address, and the instruction for each; others keep their name."""


def no_instruction(context: Context, node: cst.Call, fits: Fits) -> tuple[str, Fix | None]:
    """The way out for a call of something that is not an instruction, and a fix if the meaning is certain."""
    if context.is_trial:
        return "", None
    func, given = node.func, arguments(node)
    if isinstance(func, cst.Attribute):
        return _of_address(context, node, func, fits), None
    if not is_name(func):
        return _LIST, None
    name = name_of(func)
    lower = name.lower()
    if lower in INSTRUCTIONS:
        text = _renamed(context, node, lower)
        fix = replaced(context, func, lower, is_safe=True)
        return f"it is written in small letters: {text or INSTRUCTIONS[lower].signature}", fix
    routine = routine_named(context, name)
    if routine and not (given and lower in ACTIONS):
        fix = replaced(context, node, f"call({routine})", is_safe=routine == name and not node.args)
        return f"a subroutine is called with call({routine})", fix
    if lower in ("return", "pass"):
        return f"write {lower}", None
    if lower in BANK_NAMES:
        return f"{lower} is a bank; an address has square brackets, and an action names it: out(y[1])", None
    if lower in _FUNCTIONS:
        return f"{lower}(...) is a condition: write if {own(context, node) or f'{lower}(c.A)'}:", None
    bank = _bank_of(context, given[0]) if given else None
    if lower in _RESETS and bank is not None and bank.name in ("T", "CT"):
        shown = own(context, given[0])
        return reset_hint(IfRungsSpelling(), bank.name, shown, timers_of(context, shown)), None
    told = trade_advice(context, name, ACTIONS, given, fits, keywords(node))
    if told:
        return told, _rename(context, node, name, fits)
    told = trade_advice(context, name, CONDITIONS, given, lambda _: False)
    if told:
        return f"a condition belongs in the if: {told}", None
    return did_you_mean(name, (*INSTRUCTIONS, "return", "pass")) or _LIST, None


def _renamed(context: Context, node: cst.Call, name: str) -> str:
    text = own(context, node)
    return name + text[len(own(context, node.func)) :] if text else ""


def _rename(context: Context, node: cst.Call, name: str, fits: Fits) -> Fix | None:
    """The fix that renames a word of the trade to the instruction here, with the same arguments."""
    found = advice(name, ACTIONS)
    is_one = found is not None and not found.has_several
    text = own_code(context, found, arguments(node), fits, keywords(node)) if found and is_one else ""
    span = context.span(node)
    return replaced(context, node, text, is_safe=False) if text and span.line == span.end_line else None


def _bank_of(context: Context, node: Node) -> Bank | None:
    return BANK_NAMES.get(re.split(r"[.\[]", own(context, node), maxsplit=1)[0])


def _of_address(context: Context, node: cst.Call, func: cst.Attribute, fits: Fits) -> str:
    """``y[1].set()`` and ``ctu.res(ct.A)``: an instruction is a call, and the address its argument."""
    holder, method, given = func.value, word(func.attr).lower(), arguments(node)
    holder_name = name_of(holder).lower()
    if holder_name in INSTRUCTIONS:
        if method in ("res", "reset", "rst"):
            owner = "CT" if holder_name.startswith("ct") else "T"
            return reset_hint(IfRungsSpelling(), owner, own(context, given[0]) if given else f"{owner.lower()}.A")
        return f"an instruction is written alone: {INSTRUCTIONS[holder_name].example}"
    name = _METHODS.get(method, method)
    if name in INSTRUCTIONS and own(context, holder):
        texts = [own(context, argument) for argument in given]
        text = f"{name}({', '.join([*texts, own(context, holder)])})"
        if fits(text):
            return f"an instruction is called, and the address is its argument: {text}"
        bank = _bank_of(context, holder)
        if name == "reset" and bank is not None and bank.name in ("T", "CT"):
            return reset_hint(
                IfRungsSpelling(), bank.name, own(context, holder), timers_of(context, own(context, holder))
            )
    told = trade_advice(context, word(func.attr), ACTIONS, (), fits)
    return told or f"an instruction is called by its name alone: {INSTRUCTIONS['out'].example}; {_LIST}"


def routine_named(context: Context, name: str) -> str:
    """The function of this file, or one that it imports, that a call means; "" for none."""
    word = re.escape(name)
    text = context.source.text
    for found in re.finditer(
        rf"^[ \t]*(?:def[ \t]+({word})[ \t]*\(|from\b[^\n]*\bimport\b[^\n]*\b({word})\b)", text, re.I | re.M
    ):
        function = found[1] or found[2]
        if function.lower() != "main" and "clickgen.dsl" not in found[0]:
            return function
    return ""


# -- arguments --------------------------------------------------------------------------------------------------------


def other_argument(context: Context, spec: Spec, keyword: cst.Arg, names: Sequence[str]) -> tuple[str, Fix | None]:
    """The way out for an argument that has another name here; "" for a word that says nothing."""
    written = keyword_name(keyword)
    lower = written.lower()
    if lower in names:
        name, is_safe = lower, True
    else:
        name, is_safe = ARGUMENTS.get(lower, ""), lower == "preset"
    if name not in names:
        return "", None
    text = own(context, keyword.value)
    param = next(param for param in spec.params if name in (param.name, *param.aliases))
    if param.kind is ParamKind.PIN and not isinstance(keyword.value, cst.Lambda):
        text, is_safe = f"lambda: {text or 'c.Name'}", False
    fix = None
    if is_safe:
        assert keyword.keyword is not None
        fix = Fix((Edit(context.span(keyword.keyword), name),))
    return f"write {name}={text or '...'}:", fix
