"""Ways out for statements that have no place where they stand: assignments, loops, with, conditions alone."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

import libcst as cst

from clickgen.device.banks import CURRENT_VALUE_OF, VALUE_BANK, Bank, Kind
from clickgen.dialects.if_rungs.fix.logic import python_logic
from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.read.conditions import as_condition, fits_condition, rewrites
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    ADDRESSES,
    Node,
    arguments,
    called,
    elements,
    index_of,
    is_literal,
    is_name,
    literal,
    name_of,
    text_value,
    whole_number,
    word,
)
from clickgen.dialects.if_rungs.trade import ACTIONS, CONDITIONS, FORMULAS, MEMBERS, advice
from clickgen.dialects.if_rungs.ways_out.binding import join
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, has_bits, own, replaced
from clickgen.dialects.if_rungs.ways_out.meant import meant
from clickgen.dialects.if_rungs.ways_out.no_call import routine_named
from clickgen.dialects.if_rungs.ways_out.unwritable import instead, is_known_owner, of_current_value, why_unwritable
from clickgen.instructions import INSTRUCTIONS
from clickgen.problems.diagnostics import did_you_mean
from clickgen.text.edits import Edit, Fix


class WayOut(NamedTuple):
    """What to say of a statement, what to do, and a fix. Without a ``message`` the reader's own is said."""

    help: str = ""
    message: str = ""
    fix: Fix | None = None


_LOOP = "a loop that ends within the scan is for _ in range(n):"
_NOTHING_RUNS = "a program is only read and never run as Python"
_WORDS: dict[type[Node], str] = {
    cst.Try: f"{_NOTHING_RUNS}: there are no exceptions to catch",
    cst.Raise: f"{_NOTHING_RUNS}: to stop a machine, set(c.Fault) and test c.Fault",
    cst.Assert: "CLICK checks nothing by itself: test the condition in a rung, and set(c.Fault)",
    cst.Del: "nothing is deleted; copy(0, ds.A) clears a register",
    cst.Global: "every address is known everywhere: leave the line out",
    cst.Nonlocal: "every address is known everywhere: leave the line out",
    cst.Break: f"a loop always runs to its end; {_LOOP}",
    cst.Continue: f"a loop runs all of its rungs; {_LOOP}",
    cst.ClassDef: "a program has no classes: rungs stand in def main(): and in subroutines under @sub",
    cst.FunctionDef: "routines stand at the top level, and a subroutine under @sub is called with call(...)",
    cst.Import: "imports stand at the top of the file",
    cst.ImportFrom: "imports stand at the top of the file",
    cst.Match: "write a rung for each case: if ds.Step == 1:",
}


def way_out(context: Context, node: Node) -> WayOut:
    """The way out for a statement that is none of the language; nothing for one that says too little."""
    if context.is_trial:
        return WayOut()
    if isinstance(node, cst.Assign | cst.AugAssign | cst.AnnAssign):
        return _assignment(context, node)
    if isinstance(node, cst.While):
        return _while(context, node)
    if isinstance(node, cst.With) and node.asynchronous is None:
        return WayOut(_with(context, node))
    if isinstance(node, cst.Expr):
        return _expression(context, node)
    return WayOut(_WORDS.get(type(node), ""))


def _as_it_is(context: Context, node: Node) -> str:
    """An expression as a condition; with its and, or and not where only the resolved program knows their opposites."""
    text = own(context, node)
    return as_condition(context, node) or (text if python_logic(node) and rewrites(context, node) else "")


def _while(context: Context, node: cst.While) -> WayOut:
    shown = _as_it_is(context, node.test) or "c.Run"
    always = is_literal(node.test)
    head = "True" if always else shown
    return WayOut(f"a rung is looked at in every scan: write if {head}:; {_LOOP}", "CLICK has no while")


def _with(context: Context, node: cst.With) -> str:
    call = node.items[0].item
    name = called(call).lower()
    if name in ("rung", "branch") and isinstance(call, cst.Call):
        texts = [own(context, argument) for argument in arguments(call)]
        series = "True" if not texts else texts[0] if len(texts) == 1 else f"all({', '.join(texts)})"
        shown = series if series == "True" or (all(texts) and fits_condition(context, series)) else "c.Run"
        return f"a {name} is an if: write if {shown}:"
    if name == "program":
        return "the rungs of a program stand in def main():"
    if name == "subroutine":
        return "a subroutine is a function at the top level: @sub on the line above def fill():"
    return "a rung is an if: write if c.Run:"


# -- assignments ------------------------------------------------------------------------------------------------------


def _assignment(context: Context, node: cst.Assign | cst.AugAssign | cst.AnnAssign) -> WayOut:
    targets = [one.target for one in node.targets] if isinstance(node, cst.Assign) else [node.target]
    target, value = targets[0], node.value
    bank = bank_of(target)
    shown, text = own(context, target), own(context, value) if value is not None else ""
    general = "to set a value write copy(value, address) or calc(formula, address)"
    if isinstance(node, cst.AnnAssign) and value is None:
        rung = _rung(context, target, [node.annotation.annotation])
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
    condition = _as_it_is(context, value) or "c.A"
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
    condition = _as_it_is(context, value) or "c.A"
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


# -- expressions ------------------------------------------------------------------------------------------------------


def _expression(context: Context, node: cst.Expr) -> WayOut:
    value = node.value
    if is_name(value):
        routine = routine_named(context, name_of(value))
        return WayOut(f"write call({routine})") if routine else _word(name_of(value))
    acted = driven(context, value)
    if acted:
        return WayOut(f"write {acted}", "an action stands under its condition, not behind it")
    if isinstance(value, cst.BinaryOperation) and isinstance(value.operator, cst.FloorDivide):
        return _slashes(context, value)
    if text_value(value) is not None:
        return WayOut("a comment begins with #; directly above the rung it is the rung's comment in CLICK")
    bare = _bare_call(context, value)
    if bare:
        return WayOut(f"write {bare}", "an instruction has its arguments in parentheses")
    if isinstance(value, cst.Tuple | cst.List) and all(isinstance(one, cst.Call) for one in elements(value)):
        return WayOut("each action stands on a line of its own, without commas between them")
    if isinstance(value, cst.ListComp | cst.GeneratorExp | cst.SetComp | cst.DictComp):
        return WayOut("a program counts nothing through: write each action, or one for a range: out(y[1:5])")
    if isinstance(value, cst.Subscript) and name_of(value.value) in INSTRUCTIONS:
        inner = own(context, index_of(value))
        return WayOut(f"an instruction has round parentheses: {name_of(value.value)}({inner})")
    if isinstance(value, cst.Comparison) and [one.operator.__class__ for one in value.comparisons] == [cst.Equal]:
        written = f"copy({own(context, value.comparisons[0].comparator)}, {own(context, value.left)})"
        if fits_action(context, written):
            return WayOut(f"a comparison stands in an if; to store a value write {written}")
    if isinstance(value, cst.UnaryOperation) and isinstance(value.operator, cst.Minus):
        return WayOut("a comment begins with #")
    condition = as_condition(context, value) if isinstance(value, _CONDITIONS) else ""
    if condition:
        return WayOut(f"a condition stands in an if: write if {condition}:")
    return WayOut()


def driven(context: Context, value: cst.BaseExpression) -> str:
    """``x[1] and out(y[1])`` and ``out(y[1]) if x[1] else None`` as rungs; "" for anything else."""
    if isinstance(value, cst.IfExp):
        rungs = [
            _rung(context, value.test, [action], holds)
            for holds, action in ((True, value.body), (False, value.orelse))
            if not is_literal(action)
        ]
        return " and ".join(rungs) if all(rungs) else ""
    logic = ("", "all", elements(value)) if isinstance(value, cst.Tuple) else python_logic(value)
    if logic is None or logic[1] == "nc":
        return ""
    terms = [term for part in logic[2] for term in _flat_terms(part, logic[1])]
    actions = [term for term in terms if _action(context, term)]
    asked = [term for term in terms if term not in actions]
    if not actions:
        return ""
    if not asked:
        return " and on a line of its own ".join(_action(context, action) for action in actions)
    test = join(context, cst.Or if logic[1] == "any" else cst.And, asked)
    # Python goes on behind an or where the condition before it does not hold.
    return _rung(context, test, actions, logic[1] == "all")


def _flat_terms(node: cst.BaseExpression, function: str) -> Iterator[cst.BaseExpression]:
    logic = python_logic(node)
    if logic and logic[1] == function:
        for term in logic[2]:
            yield from _flat_terms(term, function)
    else:
        yield node


def _action(context: Context, node: Node) -> str:
    """The action that a call is: ``OUT(y[1])`` as ``out(y[1])``, ``fill()`` as ``call(fill)``; "" for none."""
    name, text = called(node), own(context, node)
    if not isinstance(node, cst.Call) or not name:
        return ""
    routine = "" if node.args else routine_named(context, name)
    text = f"call({routine})" if routine else name.lower() + text.removeprefix(name) if text else ""
    return text if text and fits_action(context, text) else ""


def _rung(context: Context, test: Node, actions: Sequence[Node], wanted: bool = True) -> str:
    """``if x[1]: out(y[1])``; "" where one of the parts is none."""
    said = meant(context, test, partial(fits_condition, context), wanted)
    texts = [_action(context, action) for action in actions]
    return f"if {said.text}: {'; '.join(texts)}" if said is not None and not said.before and all(texts) else ""


def _bare_call(context: Context, value: cst.BaseExpression) -> str:
    """``copy(-1, ds.A)`` for ``copy -1, ds.A``, which Python reads as a subtraction; "" for anything else."""
    first = elements(value)[0] if isinstance(value, cst.Tuple) and value.elements else value
    if not isinstance(first, cst.BinaryOperation) or not isinstance(first.operator, cst.Subtract):
        return ""
    name, text = name_of(first.left), own(context, value)
    written = f"{name}({text.removeprefix(name).strip()})"
    return written if name in INSTRUCTIONS and text and fits_action(context, written) else ""


_CONDITIONS = (
    cst.Attribute,
    cst.Subscript,
    cst.Comparison,
    cst.BooleanOperation,
    cst.UnaryOperation,
    cst.BinaryOperation,
)


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


def _slashes(context: Context, value: cst.BinaryOperation) -> WayOut:
    """``out(y[1]) // comment``: the comment sign of other languages."""
    span = context.span(value.left)
    line = context.source.line(span.end_line)
    found = re.match(r"[\s)]*(//)", line[span.end_col - 1 :])
    if found is None or not isinstance(value.left, cst.Call):
        return WayOut("a comment begins with #")
    start = span.end_col + found.start(1)
    is_broken = context.span(value).end_line != span.end_line
    place = span._replace(line=span.end_line, col=start, end_col=start + 2)
    return WayOut("a comment begins with #", fix=None if is_broken else Fix((Edit(place, "#"),)))
