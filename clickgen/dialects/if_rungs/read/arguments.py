"""Arguments of instructions, each read by the kind of its parameter."""

from __future__ import annotations

from dataclasses import replace

import libcst as cst

from clickgen.device.elsewhere import UNITS as UNIT_WORDS
from clickgen.dialects.if_rungs.read.conditions import (
    FUNCTIONS,
    fits_condition,
    pin_readings,
    propose_turned,
    read_condition,
)
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.modbus import read_remote, read_target
from clickgen.dialects.if_rungs.read.nodes import (
    NO_LITERAL,
    Node,
    called,
    elements,
    every,
    has_placeholders,
    is_name,
    literal,
    name_of,
    string_pieces,
    text_value,
)
from clickgen.dialects.if_rungs.read.operands import read_operand
from clickgen.dialects.if_rungs.read.options import read_options
from clickgen.dialects.if_rungs.read.places import has_parameters
from clickgen.dialects.if_rungs.trade.formulas import formula_advice
from clickgen.dialects.if_rungs.ways_out.formulas import is_formula
from clickgen.dialects.if_rungs.ways_out.hints import own, replaced
from clickgen.instructions.spec import Param, ParamKind, Spec
from clickgen.instructions.timers import UNITS
from clickgen.ir.kept import kept_token
from clickgen.ir.operands import WHOLE, Cell, Immediate, Named, Range, Single
from clickgen.ir.program import FormulaText, Operands, Pattern, Value, Word
from clickgen.text.edits import Edit, Fix
from clickgen.text.wording import shorten

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


def read_argument(context: Context, spec: Spec, param: Param, node: Node, target: str = "") -> Value | None:
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
    if kind is ParamKind.TOKEN and isinstance(node, cst.BaseExpression) and text_value(node) is not None:
        return kept_token(context.embedded(node), context.span(node))
    return _read_word(context, spec, param, node)


def _refuse(context: Context, spec: Spec, param: Param, node: Node, hint: str = "", fix: Fix | None = None) -> None:
    help = " ".join(filter(None, (hint, spec.signature)))
    context.problem("CG115", node, f"{param.name!r} of {spec.name} must be {param.kind.value}", help, fix)


def _read_word(context: Context, spec: Spec, param: Param, node: Node) -> Value | None:
    kind = param.kind
    value: str | bool | None = None
    is_function = False
    found = literal(node)
    if kind is ParamKind.FLAG and isinstance(found, bool):
        value = found
    elif kind is ParamKind.UNIT and name_of(node) in UNITS:
        value = name_of(node)
    elif kind is ParamKind.COMPARISON and found is not NO_LITERAL:
        value = _COMPARISONS.get(str(found))
    elif kind is ParamKind.TEXT and isinstance(found, str):
        value = found
    elif kind is ParamKind.ROUTINE:
        if is_name(node):
            value, is_function = name_of(node), True
        elif isinstance(found, str):
            value = found
    if value is None:
        _refuse(context, spec, param, node, *_word_hint(context, spec, param, node))
        return None
    return Word(value, context.span(node), is_function)


def _word_hint(context: Context, spec: Spec, param: Param, node: Node) -> tuple[str, Fix | None]:
    if param.kind is ParamKind.ROUTINE and isinstance(node, cst.Call):
        text = context.text(node.func)
        is_bare = is_name(node.func) and not node.args
        return f"write {spec.name}({shorten(text)}):", replaced(context, node, text, is_safe=True) if is_bare else None
    value = literal(node)
    word = context.text(node) if value is NO_LITERAL else str(value)
    if param.kind is ParamKind.FLAG and word.lower() in _FLAGS:
        flag = _FLAGS[word.lower()]
        return f"write {param.name}={flag}:", replaced(context, node, flag, is_name(node))
    if param.kind is ParamKind.FLAG and isinstance(node, cst.Attribute | cst.Subscript) and param.name == "oneshot":
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


def _read_pin(context: Context, spec: Spec, param: Param, node: Node) -> Value | None:
    if isinstance(node, cst.Lambda) and not has_parameters(node.params):
        return read_condition(context, node.body)
    condition = node.body if isinstance(node, cst.Lambda) else node
    fault = f"{param.name!r} of {spec.name} must be a condition behind lambda:"
    fix = None
    if not isinstance(node, cst.Lambda) and fits_condition(context, context.text(node)):
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


def _read_formula(context: Context, spec: Spec, param: Param, node: Node, target: str) -> Value | None:
    is_hex = param.is_hex
    if not isinstance(node, cst.BaseExpression) or text_value(node) is None:
        text = _as_formula(context, node)
        quote = "'" if '"' in text else '"'
        is_right = bool(text) and not ("'" in text and '"' in text) and is_formula(context, text, is_hex)
        if is_right:
            written = f"{quote}{text}{quote}"
            is_plain = not has_placeholders(node) and _is_plain(node)
            _refuse(context, spec, param, node, f"write {written}:", replaced(context, node, written, is_plain))
        else:
            _refuse(context, spec, param, node, _no_formula(node))
        return None
    from clickgen.formula import Mode, parse_formula

    mode: Mode = "hex" if is_hex else "decimal"
    formula = parse_formula(context.embedded(node), mode, context.problems, target, formula_advice)
    return FormulaText(formula, context.span(node)) if formula is not None else None


def _as_formula(context: Context, node: Node) -> str:
    """The text of a formula without its quotes, or with the addresses that an f-string puts in; "" for neither."""
    if not isinstance(node, cst.BaseExpression) or not has_placeholders(node):
        return own(context, node)
    parts: list[str] = []
    for piece in string_pieces(node):
        for part in piece.parts if isinstance(piece, cst.FormattedString) else (piece,):
            if isinstance(part, cst.FormattedStringText):
                parts.append(part.value.replace("{{", "{").replace("}}", "}"))
            elif isinstance(part, cst.SimpleString):
                parts.append(str(literal(part)))
            elif isinstance(part, cst.FormattedStringExpression) and _is_bare(part):
                parts.append(own(context, part.expression))
            else:
                return ""
    return "".join(parts)


def _is_bare(part: cst.FormattedStringExpression) -> bool:
    """True for ``{ds.A}`` without a format behind it."""
    return part.format_spec is None and part.conversion is None and part.equal is None


def _is_plain(node: Node) -> bool:
    """True where Python and CLICK calculate in the same order."""
    return all(
        not isinstance(part, cst.BinaryOperation) or isinstance(part.operator, cst.Add | cst.Subtract | cst.Multiply)
        for part in every(node)
    )


def _no_formula(node: Node) -> str:
    if has_placeholders(node):
        return "nothing is put into the text: write the address or the number in it:"
    return "the formula stands in quotes:" if isinstance(node, cst.BinaryOperation) else ""


# -- lists ------------------------------------------------------------------------------------------------------------


def _read_operands(context: Context, spec: Spec, param: Param, node: Node) -> Value | None:
    """A list of addresses and constants; a slice, alone or in the list, stands for each of its addresses."""
    if isinstance(node, cst.List | cst.Tuple):
        given: list[Node] = [*elements(node)]
    elif isinstance(node, cst.Subscript):
        given = [node]
    elif isinstance(node, cst.Attribute) and isinstance(block := read_operand(context, node, spec.signature), Named):
        return Operands((replace(block, part=WHOLE),), block.span)
    else:
        _refuse(context, spec, param, node)
        return None
    items: list[Single] = []
    is_whole = True
    for element in given:
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


def _is_condition(node: Node) -> bool:
    """True for a comparison or one of the functions of conditions."""
    return called(node) in FUNCTIONS or isinstance(node, cst.Comparison | cst.BooleanOperation)


def _read_pattern(context: Context, spec: Spec, param: Param, node: Node) -> Value | None:
    if not isinstance(node, cst.List | cst.Tuple):
        _refuse(context, spec, param, node)
        return None
    rows: list[tuple[bool, ...]] = []
    for row in elements(node):
        cells = elements(row) if isinstance(row, cst.List | cst.Tuple) else None
        wrong = row if cells is None else next((cell for cell in cells if not _is_bit(cell)), None)
        if cells is None or wrong is not None:
            _refuse(context, spec, param, wrong or row)
            return None
        rows.append(tuple(literal(cell) == 1 for cell in cells))
    return Pattern(tuple(rows), context.span(node))


def _is_bit(node: Node) -> bool:
    value = literal(node)
    return isinstance(value, int) and value in (0, 1)
