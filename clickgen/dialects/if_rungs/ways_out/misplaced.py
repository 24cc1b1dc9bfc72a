"""Ways out for statements that have no place where they stand: assignments, loops, with, conditions alone."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from clickgen.device.banks import CURRENT_VALUE_OF, VALUE_BANK, Bank, Kind
from clickgen.dialects.if_rungs.fix.rewrite import python_logic
from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.read.conditions import as_condition, fits_condition, rewrites
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.trade import ACTIONS, CONDITIONS, FORMULAS, MEMBERS, advice
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, has_bits, own, replaced
from clickgen.dialects.if_rungs.ways_out.meant import meant
from clickgen.dialects.if_rungs.ways_out.no_call import routine_named
from clickgen.dialects.if_rungs.ways_out.unwritable import instead, is_known_owner, of_current_value, why_unwritable
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
    if isinstance(node, ast.AnnAssign) and value is None:
        rung = _rung(context, target, [node.annotation])
        return WayOut(f"write {rung}", "a condition stands in an if") if rung else WayOut(general)
    if len(targets) > 1 or value is None or not text or not shown:
        return WayOut(general)
    if bank is None:
        name = target.id if isinstance(target, ast.Name) else ""
        return WayOut(_no_variable(name, value, text) if name else general)
    member = _current_value_of(context, target)
    if member and isinstance(node, ast.Assign) and fits_action(context, f"copy({text}, {member})"):
        return WayOut(f"write copy({text}, {member})", f"{shown} is written {member} here")
    if why_unwritable(target):
        return _unwritable(context, node, target, value, text)
    if bank.is_bit and isinstance(node, ast.Assign):
        return _bit(context, node, shown, value, text)
    if (
        bank.name in CURRENT_VALUE_OF
        and isinstance(node, ast.Assign)
        and fits_action(context, f"copy({text}, {shown})")
    ):
        fix = replaced(context, node, f"copy({text}, {shown})", is_safe=False)
        return WayOut(of_current_value(context, target, text), fix=fix if is_known_owner(context, target) else None)
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
    name = value.func.id if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) else ""
    chosen = advice(name, FORMULAS)
    if isinstance(value, ast.Call) and chosen is not None and chosen.has_several:
        written = chosen.written([own(context, one) for one in value.args], shown)
        if written:
            return WayOut(chosen.of(written))
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


STATES = {"true": "set", "1": "set", "on": "set", "false": "reset", "0": "reset", "off": "reset"}
"""What a bit is given, and the instruction that does it."""


def _bit(context: Context, node: ast.Assign, shown: str, value: ast.expr, text: str) -> WayOut:
    """A bit that is assigned: turned on or off, or driven by what is on the right."""
    word = str(value.value) if isinstance(value, ast.Constant) else text
    state = STATES.get(word.lower())
    if state == "set":
        ways = f"write set({shown}) to turn it on until it is reset, or out({shown}) to have it follow the rung"
        fix = replaced(context, node, f"set({shown})", is_safe=False)
        return WayOut(ways, fix=fix if fits_action(context, f"set({shown})") else None)
    if state == "reset":
        return WayOut(f"write reset({shown})", fix=replaced(context, node, f"reset({shown})", is_safe=False))
    condition = _as_it_is(context, value) or "c.A"
    return WayOut(f"drive it under its condition: if {condition}: out({shown})")


def _unwritable(
    context: Context, node: ast.Assign | ast.AugAssign | ast.AnnAssign, target: ast.expr, value: ast.expr, text: str
) -> WayOut:
    """An assignment to what nothing in a program writes: ``x[1] = 1``."""
    message = f"{own(context, target)} is {why_unwritable(target)}: no instruction writes it"
    bank = bank_of(target)
    if bank is not None and not bank.is_bit:
        if isinstance(node, ast.AugAssign):
            formula = f"{own(context, target)} {_SIGNS.get(type(node.op), '')} {text}"
            written = formula_call(bank, formula, "dh.Name" if bank.kind is Kind.HEX else "ds.Name")
            if written and fits_action(context, written):
                return WayOut(f"write a register of the program: {written}", message)
        fits = fits_action(context, f"copy({text}, dd.Name)") and bank_of(value) is not bank
        return WayOut(instead(context, target, "copy", text if fits else ""), message)
    word = str(value.value) if isinstance(value, ast.Constant) else text
    state = STATES.get(word.lower())
    if state:
        return WayOut(instead(context, target, state), message)
    condition = _as_it_is(context, value) or "c.A"
    return WayOut(f"{instead(context, target, 'out')}, in a rung of its own: if {condition}: out(c.Name)", message)


def _current_value_of(context: Context, target: ast.expr) -> str:
    """``td[1]`` for ``t[1].acc``; "" for anything else."""
    if not isinstance(target, ast.Attribute) or MEMBERS.get(target.attr.lower()) != "current":
        return ""
    owner = bank_of(target.value)
    value = VALUE_BANK.get(owner.name, "").lower() if owner is not None else ""
    return value + own(context, target.value)[len(owner.dsl) :] if owner is not None and value else ""


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
        routine = routine_named(context, value.id)
        return WayOut(f"write call({routine})") if routine else _word(value.id)
    acted = driven(context, value)
    if acted:
        return WayOut(f"write {acted}", "an action stands under its condition, not behind it")
    if isinstance(value, ast.BinOp) and isinstance(value.op, ast.FloorDiv):
        return _slashes(context, value)
    if isinstance(value, ast.Constant) and isinstance(value.value, str):
        return WayOut("a comment begins with #; directly above the rung it is the rung's comment in CLICK")
    bare = _bare_call(context, value)
    if bare:
        return WayOut(f"write {bare}", "an instruction has its arguments in parentheses")
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


def driven(context: Context, value: ast.expr) -> str:
    """``x[1] and out(y[1])`` and ``out(y[1]) if x[1] else None`` as rungs; "" for anything else."""
    if isinstance(value, ast.IfExp):
        rungs = [
            _rung(context, value.test, [action], holds)
            for holds, action in ((True, value.body), (False, value.orelse))
            if not isinstance(action, ast.Constant)
        ]
        return " and ".join(rungs) if all(rungs) else ""
    logic = ("", "all", value.elts) if isinstance(value, ast.Tuple) else python_logic(value)
    if logic is None or logic[1] == "nc":
        return ""
    terms = [term for part in logic[2] for term in _flat_terms(part, logic[1])]
    actions = [term for term in terms if _action(context, term)]
    asked = [term for term in terms if term not in actions]
    if not actions:
        return ""
    if not asked:
        return " and on a line of its own ".join(_action(context, action) for action in actions)
    test = asked[0] if len(asked) == 1 else ast.copy_location(ast.BoolOp(ast.And(), asked), asked[0])
    if logic[1] == "any" and len(asked) > 1:
        test = ast.copy_location(ast.BoolOp(ast.Or(), asked), asked[0])
    # Python goes on behind an or where the condition before it does not hold.
    return _rung(context, test, actions, logic[1] == "all")


def _flat_terms(node: ast.expr, function: str) -> Iterator[ast.expr]:
    logic = python_logic(node)
    if logic and logic[1] == function:
        for term in logic[2]:
            yield from _flat_terms(term, function)
    else:
        yield node


def _action(context: Context, node: ast.expr) -> str:
    """The action that a call is: ``OUT(y[1])`` as ``out(y[1])``, ``fill()`` as ``call(fill)``; "" for none."""
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
        return ""
    name, text = node.func.id, own(context, node)
    routine = "" if node.args or node.keywords else routine_named(context, name)
    text = f"call({routine})" if routine else name.lower() + text.removeprefix(name) if text else ""
    return text if text and fits_action(context, text) else ""


def _rung(context: Context, test: ast.expr, actions: list[ast.expr], wanted: bool = True) -> str:
    """``if x[1]: out(y[1])``; "" where one of the parts is none."""
    said = meant(context, test, partial(fits_condition, context), wanted)
    texts = [_action(context, action) for action in actions]
    return f"if {said.text}: {'; '.join(texts)}" if said is not None and not said.before and all(texts) else ""


def _bare_call(context: Context, value: ast.expr) -> str:
    """``copy(-1, ds.A)`` for ``copy -1, ds.A``, which Python reads as a subtraction; "" for anything else."""
    first = value.elts[0] if isinstance(value, ast.Tuple) and value.elts else value
    is_minus = isinstance(first, ast.BinOp) and isinstance(first.op, ast.Sub)
    if not (is_minus and isinstance(first, ast.BinOp) and isinstance(first.left, ast.Name)):
        return ""
    name, text = first.left.id, own(context, value)
    written = f"{name}({text.removeprefix(name).strip()})"
    return written if name in INSTRUCTIONS and text and fits_action(context, written) else ""


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
    asked = None if found else advice(lower, CONDITIONS)
    if asked is not None:
        return WayOut(f"a condition stands in the if: {asked.shown}")
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
