"""The conversion of a copy: ``options=to_text(...)``, or a modifier behind the source: ``ds[1].as_text(pad=5)``."""

from __future__ import annotations

import re

import libcst as cst

from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    NO_LITERAL,
    Node,
    arguments,
    keyword_name,
    keywords,
    literal,
    name_of,
    word,
)
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.spec import ParamKind
from clickgen.ir.program import Options
from clickgen.problems.diagnostics import did_you_mean

MODIFIERS = {f"as_{name.removeprefix('to_')}": name for name in CONVERSIONS}
"""``as_value`` and its relatives, each with the option that it means."""

_FLAGS = ("suppress_zero", "exponential")
_SETTINGS = (*_FLAGS, "termination_code")
"""Of to_text (click-facts [copy.to-text])."""
_CHARACTER_CODE = re.compile(r"\$([0-7][0-9A-Fa-f])")


def read_options(context: Context, node: Node, signature: str) -> Options | None:
    """``to_value`` or ``to_text(suppress_zero=True, exponential=False, termination_code=None)``."""
    call = node if isinstance(node, cst.Call) else None
    head = call.func if call else node
    value = literal(head)
    name = name_of(head) or ("" if value is NO_LITERAL else str(value))
    if name not in CONVERSIONS:
        help = " ".join(filter(None, (did_you_mean(name, CONVERSIONS), signature)))
        context.problem("CG115", node, f"options must be {ParamKind.OPTIONS.value}", help)
        return None
    return _with_settings(context, node, call, name, name, _SETTINGS)


def modifier_of(node: Node) -> tuple[cst.Call, cst.Attribute] | None:
    """The call and the attribute of ``txt[1].as_value()``; None for anything else."""
    if node.__class__ is not cst.Call:
        return None
    assert isinstance(node, cst.Call)
    if isinstance(node.func, cst.Attribute) and word(node.func.attr) in MODIFIERS:
        return node, node.func
    return None


def modifier_hint(node: Node) -> str:
    """What to say where a modifier has no place or is misspelled; "" for anything else."""
    if not (isinstance(node, cst.Call) and isinstance(node.func, cst.Attribute)):
        return ""
    attr = word(node.func.attr)
    if attr in MODIFIERS:
        return f".{attr}() belongs behind the source of a copy or copy_block"
    return did_you_mean(attr, MODIFIERS)


def read_modifier(context: Context, call: cst.Call, attribute: cst.Attribute) -> Options | None:
    """What a modifier means as an option; ``pad=5`` is text with all its zeros."""
    attr = word(attribute.attr)
    return _with_settings(context, call, call, attr, MODIFIERS[attr], (*_SETTINGS, "pad"))


def _with_settings(
    context: Context, node: Node, call: cst.Call | None, written: str, name: str, known: tuple[str, ...]
) -> Options | None:
    example = f"{written}(suppress_zero=False)" if name == "to_text" else written
    settings: dict[str, object] = {}
    faults = 0
    for argument in arguments(call) if call else ():
        context.problem("CG109", argument, f"{written} takes its settings by name", example)
        faults += 1
    for keyword in keywords(call) if call else ():
        setting = keyword_name(keyword)
        if name != "to_text" or setting not in known:
            close = did_you_mean(setting, known) if name == "to_text" else ""
            help = close or f"text alone has settings: {', '.join(known)}"
            context.problem("CG109", keyword, f"{written} has no setting {setting or '**'!r}", help)
            faults += 1
            continue
        try:
            settings[setting] = _setting(setting, keyword.value)
        except ValueError as error:
            context.problem("CG115", keyword.value, f"{setting} must be {error}", example)
            faults += 1
    if "pad" in settings and "suppress_zero" in settings:
        context.problem("CG111", node, "pad says already that zeros are kept", "leave out suppress_zero")
        faults += 1
    if faults:
        return None
    code, pad = settings.get("termination_code"), settings.get("pad")
    return Options(
        name,
        context.span(node),
        suppress_zero=settings.get("suppress_zero", True) is True and pad is None,
        exponential=settings.get("exponential") is True,
        termination_code=code if isinstance(code, int) else None,
        pad=pad if isinstance(pad, int) else None,
    )


def _setting(name: str, node: Node) -> object:
    """The value of one setting; ValueError says what it must be."""
    value = literal(node)
    if name in _FLAGS:
        if isinstance(value, bool):
            return value
        raise ValueError("True or False")
    if name == "pad":
        if value is None or type(value) is int:
            return value
        raise ValueError("a number of digits")
    code = _character_code(value)
    if code is None and value is not None:
        raise ValueError('a character code: "$0D"')
    return code


def _character_code(value: object) -> int | None:
    """``13``, ``"$0D"`` or a single character as a code 0..127 (TXT holds 7-bit ASCII)."""
    if type(value) is int and 0 <= value <= 127:
        return value
    if isinstance(value, str) and len(value) == 1 and value.isascii():
        return ord(value)
    code = _CHARACTER_CODE.fullmatch(value) if isinstance(value, str) else None
    return int(code[1], 16) if code else None
