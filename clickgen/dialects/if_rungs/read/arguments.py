"""Arguments of instructions, each read by the kind of its parameter."""

from __future__ import annotations

import ast
from dataclasses import replace

from clickgen.dialects.if_rungs.read.conditions import (
    FUNCTIONS,
    fits_condition,
    pin_readings,
    propose_turned,
    read_condition,
)
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.modbus import read_remote, read_target
from clickgen.dialects.if_rungs.read.operands import read_operand, shorten
from clickgen.dialects.if_rungs.read.options import read_options
from clickgen.dialects.if_rungs.trade import UNITS as UNIT_WORDS
from clickgen.dialects.if_rungs.ways_out.formulas import is_formula
from clickgen.dialects.if_rungs.ways_out.hints import own, replaced
from clickgen.instructions.maths import MATH_HEX
from clickgen.instructions.spec import Param, ParamKind, Spec
from clickgen.instructions.timers import UNITS
from clickgen.ir.kept import kept_token
from clickgen.ir.operands import WHOLE, Cell, Immediate, Named, Range, Single
from clickgen.ir.program import FormulaText, Operands, Pattern, Value, Word
from clickgen.problems.diagnostics import Edit, Fix

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


def read_argument(context: Context, spec: Spec, param: Param, node: ast.expr, target: str = "") -> Value | None:
    """The value of one argument; None with problems. ``target`` is where the result goes, as the person wrote it."""
    kind = param.kind
    if kind is ParamKind.OPERAND:
        return read_operand(context, node, spec.signature)
    if kind is ParamKind.OPERANDS:
        return _read_operands(context, spec, param, node)
    if kind is ParamKind.PATTERN:
        return _read_pattern(context, spec, param, node)
    if kind is ParamKind.PIN:
        return _read_pin(context, spec, param, node)
    if kind is ParamKind.FORMULA:
        return _read_formula(context, spec, param, node, target)
    if kind is ParamKind.OPTIONS:
        return read_options(context, node, spec.signature)
    if kind is ParamKind.TARGET:
        return read_target(context, node, spec.signature)
    if kind is ParamKind.REMOTE:
        return read_remote(context, node, spec.signature)
    if kind is ParamKind.TOKEN and isinstance(node, ast.Constant) and isinstance(node.value, str):
        return kept_token(context.embedded(node), context.span(node))
    return _read_word(context, spec, param, node)


def _refuse(context: Context, spec: Spec, param: Param, node: ast.expr, hint: str = "", fix: Fix | None = None) -> None:
    help = " ".join(filter(None, (hint, spec.signature)))
    context.problem("CG115", node, f"{param.name!r} of {spec.name} must be {param.kind.value}", help, fix)


def _read_word(context: Context, spec: Spec, param: Param, node: ast.expr) -> Value | None:
    kind = param.kind
    value: str | bool | None = None
    is_function = False
    if kind is ParamKind.FLAG and isinstance(node, ast.Constant) and isinstance(node.value, bool):
        value = node.value
    elif kind is ParamKind.UNIT and isinstance(node, ast.Name) and node.id in UNITS:
        value = node.id
    elif kind is ParamKind.COMPARISON and isinstance(node, ast.Constant):
        value = _COMPARISONS.get(str(node.value))
    elif kind is ParamKind.TEXT and isinstance(node, ast.Constant) and isinstance(node.value, str):
        value = node.value
    elif kind is ParamKind.ROUTINE:
        if isinstance(node, ast.Name):
            value, is_function = node.id, True
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            value = node.value
    if value is None:
        _refuse(context, spec, param, node, *_word_hint(context, spec, param, node))
        return None
    return Word(value, context.span(node), is_function)


def _word_hint(context: Context, spec: Spec, param: Param, node: ast.expr) -> tuple[str, Fix | None]:
    if param.kind is ParamKind.ROUTINE and isinstance(node, ast.Call):
        text = context.text(node.func)
        is_bare = isinstance(node.func, ast.Name) and not (node.args or node.keywords)
        return f"write {spec.name}({shorten(text)}):", replaced(context, node, text, is_safe=True) if is_bare else None
    word = str(node.value) if isinstance(node, ast.Constant) else context.text(node)
    if param.kind is ParamKind.FLAG and word.lower() in _FLAGS:
        flag = _FLAGS[word.lower()]
        is_safe = isinstance(node, ast.Name)
        return f"write {param.name}={flag}:", replaced(context, node, flag, is_safe)
    if param.kind is ParamKind.FLAG and isinstance(node, ast.Attribute | ast.Subscript) and param.name == "oneshot":
        return f"one address or range at a time; another one gets a line of its own, {spec.name}({word}):", None
    if param.kind is not ParamKind.UNIT:
        return "", None
    exact = _unit(word)
    return (f"write unit={exact}:", replaced(context, node, exact, word.lower() != "m")) if exact else (_NO_UNIT, None)


_FLAGS = {"true": "True", "1": "True", "yes": "True", "false": "False", "0": "False", "no": "False"}
_NO_UNIT = "Tms are milliseconds, Ts seconds, Tm minutes, Th hours, Td days:"


def _unit(word: str) -> str:
    """The unit of time that a word means; "" for none."""
    return UNIT_WORDS.get(word.lower(), "")


def _read_pin(context: Context, spec: Spec, param: Param, node: ast.expr) -> Value | None:
    if isinstance(node, ast.Lambda) and not ast.unparse(node.args):
        return read_condition(context, node.body)
    condition = node.body if isinstance(node, ast.Lambda) else node
    fault = f"{param.name!r} of {spec.name} must be a condition behind lambda:"
    fix = None
    if not isinstance(node, ast.Lambda) and fits_condition(context, context.text(node)):
        start = context.span(node)
        fix = Fix((Edit(start._replace(end_line=start.line, end_col=start.col), "lambda: "),))
        # Around a condition on several lines the parentheses belong to it.
        fix = fix if start.line == start.end_line else None
    readings = [] if context.is_trial else pin_readings(context, condition)
    shown = [f"{param.name}=lambda: {reading.text}" for reading in readings] or [f"{param.name}=lambda: c.Name"]
    before = f"{readings[0].rungs}, and " if readings and readings[0].before else ""
    ways = f"{shown[0]} for all of them, {shown[1]} for one of them," if len(shown) > 1 else shown[0]
    context.problem("CG115", node, fault, f"{before}write {ways} in {spec.signature}", fix)
    if readings and fix is None:
        propose_turned(context, "CG115", node, readings[0])
    return None


def _read_formula(context: Context, spec: Spec, param: Param, node: ast.expr, target: str) -> Value | None:
    is_hex = spec is MATH_HEX
    if not (isinstance(node, ast.Constant) and isinstance(node.value, str)):
        text = _as_formula(context, node)
        quote = "'" if '"' in text else '"'
        is_right = bool(text) and not ("'" in text and '"' in text) and is_formula(text, is_hex)
        if is_right:
            written = f"{quote}{text}{quote}"
            is_plain = not isinstance(node, ast.JoinedStr) and _is_plain(node)
            _refuse(context, spec, param, node, f"write {written}:", replaced(context, node, written, is_plain))
        else:
            _refuse(context, spec, param, node, _no_formula(node))
        return None
    from clickgen.formula import parse_formula

    formula = parse_formula(context.embedded(node), "hex" if is_hex else "decimal", context.problems, target)
    return FormulaText(formula, context.span(node)) if formula is not None else None


def _as_formula(context: Context, node: ast.expr) -> str:
    """The text of a formula without its quotes, or with the addresses that an f-string puts in; "" for neither."""
    if not isinstance(node, ast.JoinedStr):
        return own(context, node)
    parts: list[str] = []
    for part in node.values:
        if isinstance(part, ast.Constant) and isinstance(part.value, str):
            parts.append(part.value)
        elif isinstance(part, ast.FormattedValue) and part.format_spec is None and part.conversion == -1:
            parts.append(ast.unparse(part.value))
        else:
            return ""
    return "".join(parts)


def _is_plain(node: ast.expr) -> bool:
    """True where Python and CLICK calculate in the same order."""
    return all(
        not isinstance(part, ast.BinOp) or isinstance(part.op, ast.Add | ast.Sub | ast.Mult) for part in ast.walk(node)
    )


def _no_formula(node: ast.expr) -> str:
    if isinstance(node, ast.JoinedStr):
        return "nothing is put into the text: write the address or the number in it:"
    return "the formula stands in quotes:" if isinstance(node, ast.BinOp) else ""


# -- lists ------------------------------------------------------------------------------------------------------------


def _read_operands(context: Context, spec: Spec, param: Param, node: ast.expr) -> Value | None:
    """A list of addresses and constants; a slice, alone or in the list, stands for each of its addresses."""
    if isinstance(node, ast.List | ast.Tuple):
        elements = node.elts
    elif isinstance(node, ast.Subscript):
        elements = [node]
    elif isinstance(node, ast.Attribute) and isinstance(block := read_operand(context, node, spec.signature), Named):
        return Operands((replace(block, part=WHOLE),), block.span)
    else:
        _refuse(context, spec, param, node)
        return None
    items: list[Single] = []
    is_whole = True
    for element in elements:
        if _is_condition(element):
            help = "put the condition on a C bit in a rung before, and name that bit here"
            context.problem("CG115", element, f"{param.name!r} of {spec.name} takes plain addresses", help)
            is_whole = False
            continue
        operand = read_operand(context, element, spec.signature)
        if isinstance(operand, Range):
            items += [Cell(address, operand.span) for address in operand.addresses()]
        elif isinstance(operand, Immediate):
            context.problem("CG308", element, f"{spec.name} takes no immediate address here", "leave out .immediate")
            is_whole = False
        elif operand is None:
            is_whole = False
        else:
            items.append(operand)
    return Operands(tuple(items), context.span(node)) if is_whole else None


def _is_condition(node: ast.expr) -> bool:
    """True for a comparison or one of the functions of conditions."""
    is_function = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in FUNCTIONS
    return is_function or isinstance(node, ast.Compare | ast.BoolOp)


def _read_pattern(context: Context, spec: Spec, param: Param, node: ast.expr) -> Value | None:
    if not isinstance(node, ast.List | ast.Tuple):
        _refuse(context, spec, param, node)
        return None
    rows: list[tuple[bool, ...]] = []
    for row in node.elts:
        cells = row.elts if isinstance(row, ast.List | ast.Tuple) else None
        wrong = row if cells is None else next((cell for cell in cells if not _is_bit(cell)), None)
        if cells is None or wrong is not None:
            _refuse(context, spec, param, wrong or row)
            return None
        rows.append(tuple(isinstance(cell, ast.Constant) and cell.value == 1 for cell in cells))
    return Pattern(tuple(rows), context.span(node))


def _is_bit(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and type(node.value) in (int, bool) and node.value in (0, 1)
