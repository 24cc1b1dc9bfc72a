"""Instruction calls: arguments bound to the Spec's parameters and read by their kind."""

from __future__ import annotations

import ast
import re

from clickgen.diagnostics import did_you_mean
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.maths import MATH_HEX
from clickgen.instructions.spec import REQUIRED, Param, ParamKind, Spec
from clickgen.instructions.timers import UNITS
from clickgen.ir.program import Action, FormulaText, Options, Value, Word
from clickgen.syntax.conditions import read_condition
from clickgen.syntax.context import Context
from clickgen.syntax.operands import read_operand, shorten

_COMPARISONS = {
    "==": "==",
    "!=": "!=",
    "<": "<",
    "<=": "<=",
    ">": ">",
    ">=": ">=",
    "eq": "==",
    "ne": "!=",
    "lt": "<",
    "le": "<=",
    "gt": ">",
    "ge": ">=",
}

_SETTINGS = ("suppress_zero", "exponential", "termination_code")
"""Of to_text (click-facts, section 3)."""
_CHARACTER_CODE = re.compile(r"\$([0-7][0-9A-Fa-f])")


def read_call(context: Context, node: ast.Call) -> Action | None:
    """The instruction that a call statement writes; None with problems."""
    name = node.func.id if isinstance(node.func, ast.Name) else ""
    spec = INSTRUCTIONS.get(name)
    if spec is None:
        shown = name or context.text(node.func)
        known = _elsewhere(name) or did_you_mean(name, INSTRUCTIONS) if name else ""
        context.problem("CG108", node.func, f"there is no instruction {shown!r}", known or "see the language reference")
        return None
    bound = _bind(context, spec, node)
    if bound is None:
        return None
    args: dict[str, Value] = {}
    complete = True
    for param in spec.params:
        expression = bound.get(param.name)
        if expression is None or _is_none(expression, param):
            continue
        value = _read_argument(context, spec, param, expression)
        if value is None:
            complete = False
        else:
            args[param.name] = value
    return Action(spec, args, context.span(node)) if complete else None


_ELSEWHERE = {
    "latch": "set",
    "on_delay": "ton",
    "off_delay": "tof",
    "count_up": "ctu",
    "count_down": "ctd",
    "blockcopy": "copy_block",
    "fill": "copy_fill",
    "pack_bits": "copy_pack",
    "pack_words": "copy_pack",
    "pack_text": "copy_pack",
    "unpack_to_bits": "copy_unpack",
    "unpack_to_words": "copy_unpack",
    "math": "calc",
    "next": "next_loop",
}
"""What CLICK's ladder files and other dialects call an instruction."""


def _elsewhere(name: str) -> str:
    own = _ELSEWHERE.get(name)
    return f"here it is called {INSTRUCTIONS[own].signature}" if own else ""


def _is_none(expression: ast.expr, param: Param) -> bool:
    return param.default is None and isinstance(expression, ast.Constant) and expression.value is None


def _bind(context: Context, spec: Spec, node: ast.Call) -> dict[str, ast.expr] | None:
    """Arguments by parameter name, every fault of the call reported; None when there was one."""
    names = {alias: param.name for param in spec.params for alias in (param.name, *param.aliases)}
    bound: dict[str, ast.expr] = {}
    faults = 0
    for index, argument in enumerate(node.args):
        if isinstance(argument, ast.Starred):
            context.problem("CG115", argument, "arguments are written one by one", spec.signature)
            faults += 1
        elif index >= len(spec.params):
            context.problem(
                "CG109", argument, f"{spec.name} takes no more than {len(spec.params)} arguments", spec.signature
            )
            faults += 1
        else:
            bound[spec.params[index].name] = argument
    for keyword in node.keywords:
        name = names.get(keyword.arg or "")
        if keyword.arg is None:
            context.problem("CG115", keyword, "arguments are written one by one", spec.signature)
            faults += 1
        elif name is None:
            help = " ".join(filter(None, (did_you_mean(keyword.arg, names), spec.signature)))
            context.problem("CG109", keyword, f"{spec.name} has no argument {keyword.arg!r}", help)
            faults += 1
        elif name in bound:
            context.problem("CG111", keyword, f"{spec.name} is given {name!r} twice", spec.signature)
            faults += 1
        else:
            bound[name] = keyword.value
    for param in spec.params:
        if param.default is REQUIRED and param.name not in bound and not faults:
            context.problem("CG110", node, f"{spec.name} needs {param.name!r}", spec.signature)
            faults += 1
    return None if faults else bound


def _read_argument(context: Context, spec: Spec, param: Param, node: ast.expr) -> Value | None:
    kind = param.kind
    if kind is ParamKind.OPERAND:
        return read_operand(context, node)
    if kind is ParamKind.PIN:
        return _read_pin(context, param, node)
    if kind is ParamKind.FORMULA:
        return _read_formula(context, spec, node)
    if kind is ParamKind.OPTIONS:
        return _read_options(context, node)
    value: str | bool | None = None
    if kind is ParamKind.FLAG and isinstance(node, ast.Constant) and isinstance(node.value, bool):
        value = node.value
    elif kind is ParamKind.UNIT and isinstance(node, ast.Name) and node.id in UNITS:
        value = node.id
    elif kind is ParamKind.COMPARISON and isinstance(node, ast.Constant):
        value = _COMPARISONS.get(str(node.value))
    elif kind is ParamKind.ROUTINE:
        if isinstance(node, ast.Name):
            value = node.id
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            value = node.value
    if value is None:
        _wrong_kind(context, spec, param, node)
        return None
    return Word(value, context.span(node))


def _wrong_kind(context: Context, spec: Spec, param: Param, node: ast.expr) -> None:
    help = spec.signature
    if param.kind is ParamKind.ROUTINE and isinstance(node, ast.Call):
        help = f"write {spec.name}({shorten(context.text(node.func))})"
    if param.kind is ParamKind.UNIT:
        word = str(node.value) if isinstance(node, ast.Constant) else context.text(node)
        help = did_you_mean(word, UNITS) or help
        exact = next((unit for unit in UNITS if word.lower() in (unit.lower(), unit[1:].lower())), None)
        help = f"write unit={exact}" if exact else help
    context.problem("CG115", node, f"{param.name!r} of {spec.name} must be {param.kind.value}", help)


def _read_pin(context: Context, param: Param, node: ast.expr) -> Value | None:
    if isinstance(node, ast.Lambda) and not ast.unparse(node.args):
        return read_condition(context, node.body)
    condition = node.body if isinstance(node, ast.Lambda) else node
    is_nothing = isinstance(condition, ast.Constant) and condition.value is None
    shown = "c.Name" if is_nothing else shorten(context.text(condition))
    fault = f"{param.name!r} must be a condition behind lambda:"
    context.problem("CG115", node, fault, f"{param.name}=lambda: {shown}")
    return None


def _read_formula(context: Context, spec: Spec, node: ast.expr) -> Value | None:
    if not (isinstance(node, ast.Constant) and isinstance(node.value, str)):
        context.problem("CG115", node, f"the formula of {spec.name} must be a text in quotes", spec.example)
        return None
    from clickgen.formula import parse_formula

    formula = parse_formula(context.embedded(node), "hex" if spec is MATH_HEX else "decimal", context.problems)
    return FormulaText(formula, context.span(node)) if formula is not None else None


def _read_options(context: Context, node: ast.expr) -> Value | None:
    """``to_value`` or ``to_text(suppress_zero=True, exponential=False, termination_code=None)``."""
    call = node if isinstance(node, ast.Call) else None
    head = call.func if call else node
    name = head.id if isinstance(head, ast.Name) else str(head.value) if isinstance(head, ast.Constant) else ""
    if name not in CONVERSIONS:
        help = did_you_mean(name, CONVERSIONS) or ParamKind.OPTIONS.value
        context.problem("CG115", node, f"options must be {ParamKind.OPTIONS.value}", help)
        return None
    settings: dict[str, bool] = {}
    code: int | None = None
    for argument in call.args if call else ():
        context.problem("CG109", argument, f"{name} takes its settings by name", "to_text(suppress_zero=True)")
        return None
    for keyword in call.keywords if call else ():
        value = keyword.value.value if isinstance(keyword.value, ast.Constant) else ...
        if name != "to_text" or keyword.arg not in _SETTINGS:
            known = did_you_mean(keyword.arg or "", _SETTINGS) if name == "to_text" else ""
            help = known or f"to_text alone has settings: {', '.join(_SETTINGS)}"
            context.problem("CG109", keyword, f"{name} has no setting {keyword.arg!r}", help)
            return None
        if keyword.arg == "termination_code":
            code = _character_code(value)
            if code is None and value is not None:
                context.problem(
                    "CG115", keyword.value, "termination_code must be a character code", 'termination_code="$0D"'
                )
                return None
        elif isinstance(value, bool):
            settings[keyword.arg] = value
        else:
            context.problem("CG115", keyword.value, f"{keyword.arg} must be True or False", f"{keyword.arg}=True")
            return None
    return Options(name, context.span(node), **settings, termination_code=code)


def _character_code(value: object) -> int | None:
    """``13``, ``"$0D"`` or a single character as a code 0..127 (TXT holds 7-bit ASCII)."""
    if type(value) is int and 0 <= value <= 127:
        return value
    if isinstance(value, str) and len(value) == 1 and value.isascii():
        return ord(value)
    code = _CHARACTER_CODE.fullmatch(value) if isinstance(value, str) else None
    return int(code[1], 16) if code else None
