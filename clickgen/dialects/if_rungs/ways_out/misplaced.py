"""Ways out for misplaced statements: loops, with, conditions alone, bare words."""

from __future__ import annotations

import re

import libcst as cst

from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.read.conditions import as_condition, fits_condition
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    elements,
    index_of,
    is_literal,
    is_name,
    name_of,
    text_value,
)
from clickgen.dialects.if_rungs.trade import ACTIONS, CONDITIONS, advice
from clickgen.dialects.if_rungs.ways_out.assigned import assignment
from clickgen.dialects.if_rungs.ways_out.driven import as_it_is, driven
from clickgen.dialects.if_rungs.ways_out.hints import own
from clickgen.dialects.if_rungs.ways_out.no_call import routine_named
from clickgen.dialects.if_rungs.ways_out.way_out import WayOut
from clickgen.instructions import INSTRUCTIONS
from clickgen.problems.diagnostics import did_you_mean
from clickgen.text.edits import Edit, Fix

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
        return assignment(context, node)
    if isinstance(node, cst.While):
        return _while(context, node)
    if isinstance(node, cst.With) and node.asynchronous is None:
        return WayOut(_with(context, node))
    if isinstance(node, cst.Expr):
        return _expression(context, node)
    return WayOut(_WORDS.get(type(node), ""))


def _while(context: Context, node: cst.While) -> WayOut:
    shown = as_it_is(context, node.test) or "c.Run"
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
