"""Ways out for statements that have no place where they stand: assignments, loops, with, conditions alone."""

from __future__ import annotations

import ast
import re
from typing import NamedTuple

from clickgen.device.banks import Bank, Kind
from clickgen.dialects.if_rungs.fix.rewrite import python_logic
from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.read.conditions import as_condition, fits_condition, rewrites
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.trade import ACTIONS, advice
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, has_bits, own, replaced
from clickgen.instructions import INSTRUCTIONS
from clickgen.problems.diagnostics import Edit, Fix, did_you_mean


class WayOut(NamedTuple):
    """What to say of a statement, what to do, and a fix. Without a ``message`` the reader's own is said."""

    help: str = ""
    message: str = ""
    fix: Fix | None = None


_LOOP = "a loop that ends within the scan is for _ in range(n):"
_NOTHING_RUNS = "a program is only read and never run as Python"
_WORDS: dict[type[ast.stmt], str] = {
    ast.Try: f"{_NOTHING_RUNS}: there are no exceptions to catch",
    ast.Raise: f"{_NOTHING_RUNS}: to stop a machine, set(c.Fault) and test c.Fault",
    ast.Assert: "CLICK checks nothing by itself: test the condition in a rung, and set(c.Fault)",
    ast.Delete: "nothing is deleted; copy(0, ds.A) clears a register",
    ast.Global: "every address is known everywhere: leave the line out",
    ast.Nonlocal: "every address is known everywhere: leave the line out",
    ast.Break: f"a loop always runs to its end; {_LOOP}",
    ast.Continue: f"a loop runs all of its rungs; {_LOOP}",
    ast.ClassDef: "a program has no classes: rungs stand in def main(): and in subroutines under @sub",
    ast.FunctionDef: "routines stand at the top level, and a subroutine under @sub is called with call(...)",
    ast.AsyncFunctionDef: "routines stand at the top level, and a subroutine under @sub is called with call(...)",
    ast.Import: "imports stand at the top of the file",
    ast.ImportFrom: "imports stand at the top of the file",
    ast.Match: "write a rung for each case: if ds.Step == 1:",
}


def way_out(context: Context, node: ast.stmt) -> WayOut:
    """The way out for a statement that is none of the language; nothing for one that says too little."""
    if context.is_trial:
        return WayOut()
    if isinstance(node, ast.Assign | ast.AugAssign | ast.AnnAssign):
        return _assignment(context, node)
    if isinstance(node, ast.While):
        return _while(context, node)
    if isinstance(node, ast.With):
        return WayOut(_with(context, node))
    if isinstance(node, ast.Expr):
        return _expression(context, node)
    return WayOut(_WORDS.get(type(node), ""))


def _as_it_is(context: Context, node: ast.expr) -> str:
    """An expression as a condition; with its and, or and not where only the resolved program knows their opposites."""
    text = own(context, node)
    return as_condition(context, node) or (text if python_logic(node) and rewrites(context, node) else "")


def _while(context: Context, node: ast.While) -> WayOut:
    shown = _as_it_is(context, node.test) or "c.Run"
    always = isinstance(node.test, ast.Constant)
    head = "True" if always else shown
    return WayOut(f"a rung is looked at in every scan: write if {head}:; {_LOOP}", "CLICK has no while")


def _with(context: Context, node: ast.With) -> str:
    call = node.items[0].context_expr
    name = call.func.id.lower() if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) else ""
    if name in ("rung", "branch") and isinstance(call, ast.Call):
        texts = [own(context, argument) for argument in call.args]
        series = "True" if not texts else texts[0] if len(texts) == 1 else f"all({', '.join(texts)})"
        shown = series if series == "True" or (all(texts) and fits_condition(context, series)) else "c.Run"
        return f"a {name} is an if: write if {shown}:"
    if name == "program":
        return "the rungs of a program stand in def main():"
    if name == "subroutine":
        return "a subroutine is a function at the top level: @sub on the line above def fill():"
    return "a rung is an if: write if c.Run:"


# -- assignments ------------------------------------------------------------------------------------------------------


def _assignment(context: Context, node: ast.Assign | ast.AugAssign | ast.AnnAssign) -> WayOut:
    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
    target, value = targets[0], node.value
    bank = bank_of(target)
    shown, text = own(context, target), own(context, value) if value is not None else ""
    general = "to set a value write copy(value, address) or calc(formula, address)"
    if len(targets) > 1 or value is None or not text or not shown:
        return WayOut(general)
    if bank is None:
        name = target.id if isinstance(target, ast.Name) else ""
        return WayOut(_no_variable(name, value, text) if name else general)
    if bank.is_bit and isinstance(node, ast.Assign):
        return _bit(context, node, shown, value, text)
    sign = _SIGNS.get(type(node.op), "") if isinstance(node, ast.AugAssign) else ""
    if isinstance(node, ast.AugAssign):
        return _counted(context, node, bank, shown, text, sign)
    written = f"copy({text}, {shown})"
    if fits_action(context, written):
        return WayOut(f"write {written}", fix=replaced(context, node, written, _is_exact(bank, value)))
    other = bank_of(value)
    if other is not None and other.is_bit:
        return WayOut(
            f"a bit becomes a number in two rungs: if {text}: copy(1, {shown}) and if nc({text}): copy(0, {shown})"
        )
    written = formula_call(bank, text, shown)
    if written and not has_bits(value) and fits_action(context, written):
        return WayOut(f"write {written}", fix=replaced(context, node, written, is_safe=False))
    return WayOut(general)


_SIGNS: dict[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.FloorDiv: "/"}
_EXACT = (ast.Add, ast.Sub, ast.Mult)


def _counted(context: Context, node: ast.AugAssign, bank: Bank, shown: str, text: str, sign: str) -> WayOut:
    """``ds[1] += 1`` as ``calc("ds[1] + 1", ds[1])``."""
    inner = text if isinstance(node.value, ast.Attribute | ast.Subscript | ast.Constant) else f"({text})"
    written = formula_call(bank, f"{shown} {sign} {inner}", shown) if sign else ""
    if not written or not fits_action(context, written):
        return WayOut('to change a value write a formula: calc("ds.A + 1", ds.A)')
    is_whole = isinstance(node.value, ast.Constant) and type(node.value.value) is int
    is_safe = isinstance(node.op, _EXACT) and is_whole and bank.name in ("DS", "DD") and not _is_part(node.target)
    return WayOut(f"write {written}", fix=replaced(context, node, written, is_safe))


def _is_part(node: ast.expr) -> bool:
    return not isinstance(node, ast.Attribute | ast.Subscript) or not isinstance(node.value, ast.Name)


def formula_call(bank: Bank, formula: str, destination: str) -> str:
    """``calc("...", ds.A)``, for a word ``math_hex``; "" where quotes are in the way."""
    if '"' in formula and "'" in formula:
        return ""
    quote = "'" if '"' in formula else '"'
    return f"{'math_hex' if bank.kind is Kind.HEX else 'calc'}({quote}{formula}{quote}, {destination})"


def _is_exact(bank: Bank, value: ast.expr) -> bool:
    """True where a copy stores just the value: a whole number, or a register of the same bank."""
    if isinstance(value, ast.Constant):
        return type(value.value) is int and bank.name in ("DS", "DD")
    return bank_of(value) is bank


_READ_ONLY = {
    "X": "an input follows its terminal; write an output, y.Name, or a bit of the program, c.Name",
    "T": "its timer alone turns it on; write a bit of the program, c.Name",
    "CT": "its counter alone turns it on; write a bit of the program, c.Name",
}


def _bit(context: Context, node: ast.Assign, shown: str, value: ast.expr, text: str) -> WayOut:
    """A bit that is assigned: turned on or off, or driven by what is on the right."""
    bank = bank_of(node.targets[0])
    if bank is not None and bank.name in _READ_ONLY:
        return WayOut(f"no instruction writes {shown}: {_READ_ONLY[bank.name]}")
    word = str(value.value) if isinstance(value, ast.Constant) else text
    state = {"true": "set", "1": "set", "on": "set", "false": "reset", "0": "reset", "off": "reset"}.get(word.lower())
    if state == "set":
        ways = f"write set({shown}) to turn it on until it is reset, or out({shown}) to have it follow the rung"
        fix = replaced(context, node, f"set({shown})", is_safe=False)
        return WayOut(ways, fix=fix if fits_action(context, f"set({shown})") else None)
    if state == "reset":
        return WayOut(f"write reset({shown})", fix=replaced(context, node, f"reset({shown})", is_safe=False))
    condition = _as_it_is(context, value) or "c.A"
    return WayOut(f"drive it under its condition: if {condition}: out({shown})")


def _no_variable(name: str, value: ast.expr, text: str) -> str:
    """The way out for a name of its own: CLICK has addresses and no variables."""
    bank = bank_of(value)
    if bank is not None:
        return f"give the address a nickname, nickname({bank.dsl}.{name}, {text}), and write {bank.dsl}.{name}"
    number = value.value if isinstance(value, ast.Constant) else None
    if isinstance(number, int | float):
        if isinstance(number, bool):
            home = f"nickname(c.{name}, c[1], initial={int(number)})"
        else:
            is_whole = isinstance(number, int)
            dsl = "df" if not is_whole else "ds" if -32768 <= number <= 32767 else "dd"
            home = f"nickname({dsl}.{name}, {dsl}[1], initial={text}, retentive=False)"
        return f"write {text} where it is used, or keep it in a register of its own, {home}, and use that"
    if isinstance(value, ast.Constant):
        return f"write {text} where it is used"
    return "a program has no variables; a register keeps a value: copy(5, ds.Limit)"


# -- expressions ------------------------------------------------------------------------------------------------------


def _expression(context: Context, node: ast.Expr) -> WayOut:
    value = node.value
    if isinstance(value, ast.Name):
        return _word(value.id)
    if isinstance(value, ast.BinOp) and isinstance(value.op, ast.FloorDiv):
        return _slashes(context, value)
    if isinstance(value, ast.Constant) and isinstance(value.value, str):
        return WayOut("a comment begins with #; directly above the rung it is the rung's comment in CLICK")
    if isinstance(value, ast.Tuple | ast.List) and all(isinstance(one, ast.Call) for one in value.elts):
        return WayOut("each action stands on a line of its own, without commas between them")
    if isinstance(value, ast.ListComp | ast.GeneratorExp | ast.SetComp | ast.DictComp):
        return WayOut("a program counts nothing through: write each action, or one for a range: out(y[1:5])")
    if isinstance(value, ast.Subscript) and isinstance(value.value, ast.Name) and value.value.id in INSTRUCTIONS:
        inner = own(context, value.slice)
        return WayOut(f"an instruction has round parentheses: {value.value.id}({inner})")
    if isinstance(value, ast.Compare) and len(value.ops) == 1 and isinstance(value.ops[0], ast.Eq):
        written = f"copy({own(context, value.comparators[0])}, {own(context, value.left)})"
        if fits_action(context, written):
            return WayOut(f"a comparison stands in an if; to store a value write {written}")
    if isinstance(value, ast.UnaryOp) and isinstance(value.op, ast.USub):
        return WayOut("a comment begins with #")
    condition = as_condition(context, value) if isinstance(value, _CONDITIONS) else ""
    if condition:
        return WayOut(f"a condition stands in an if: write if {condition}:")
    return WayOut()


_CONDITIONS = (ast.Attribute, ast.Subscript, ast.Compare, ast.BoolOp, ast.UnaryOp, ast.BinOp)


def _word(name: str) -> WayOut:
    """A bare word in the place of an action: ``end``, ``NOP``, ``RET``, ``endif``."""
    lower = name.lower()
    if lower in INSTRUCTIONS:
        spec = INSTRUCTIONS[lower]
        return WayOut(f"write {spec.signature}" if not spec.params else f"write {spec.signature}; as in {spec.example}")
    if lower in ("pass", "return", "break", "continue"):
        return WayOut(f"write {lower}" if lower in ("pass", "return") else f"a loop always runs to its end; {_LOOP}")
    if lower in ENDINGS:
        return WayOut("an if ends where its lines stop being indented: leave this out")
    found = advice(lower, ACTIONS)
    return WayOut(found.shown if found else did_you_mean(name, (*INSTRUCTIONS, "return", "pass")))


ENDINGS = frozenset(
    ("endif", "end_if", "fi", "endwhile", "end_while", "end_for", "endsub", "end_sub", "end_program", "begin")
)
"""Words that close a block in other languages."""


def _slashes(context: Context, value: ast.BinOp) -> WayOut:
    """``out(y[1]) // comment``: the comment sign of other languages."""
    span = context.span(value.left)
    line = context.source.line(span.end_line)
    found = re.match(r"[\s)]*(//)", line[span.end_col - 1 :])
    if found is None or not isinstance(value.left, ast.Call):
        return WayOut("a comment begins with #")
    start = span.end_col + found.start(1)
    is_broken = context.span(value).end_line != span.end_line
    place = span._replace(line=span.end_line, col=start, end_col=start + 2)
    return WayOut("a comment begins with #", fix=None if is_broken else Fix((Edit(place, "#"),)))
