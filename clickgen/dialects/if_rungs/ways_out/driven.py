"""Rungs that are written as one expression: ``x[1] and out(y[1])``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import libcst as cst

from clickgen.dialects.if_rungs.fix.logic import python_logic
from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.read.conditions import as_condition, fits_condition, rewrites
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import Node, called, elements, is_literal
from clickgen.dialects.if_rungs.ways_out.binding import join
from clickgen.dialects.if_rungs.ways_out.hints import own
from clickgen.dialects.if_rungs.ways_out.meant import meant
from clickgen.dialects.if_rungs.ways_out.no_call import routine_named


def driven(context: Context, value: cst.BaseExpression) -> str:
    """``x[1] and out(y[1])`` and ``out(y[1]) if x[1] else None`` as rungs; "" for anything else."""
    if isinstance(value, cst.IfExp):
        rungs = [
            rung_of(context, value.test, [action], holds)
            for holds, action in ((True, value.body), (False, value.orelse))
            if not is_literal(action)
        ]
        return " and ".join(rungs) if all(rungs) else ""
    logic = ("", "all", elements(value)) if isinstance(value, cst.Tuple) else python_logic(value)
    if logic is None or logic[1] == "nc":
        return ""
    terms = [term for part in logic[2] for term in _flat_terms(part, logic[1])]
    actions = [term for term in terms if action_of(context, term)]
    asked = [term for term in terms if term not in actions]
    if not actions:
        return ""
    if not asked:
        return " and on a line of its own ".join(action_of(context, action) for action in actions)
    test = join(context, cst.Or if logic[1] == "any" else cst.And, asked)
    # Python goes on behind an or where the condition before it does not hold.
    return rung_of(context, test, actions, logic[1] == "all")


def _flat_terms(node: cst.BaseExpression, function: str) -> Iterator[cst.BaseExpression]:
    logic = python_logic(node)
    if logic and logic[1] == function:
        for term in logic[2]:
            yield from _flat_terms(term, function)
    else:
        yield node


def action_of(context: Context, node: Node) -> str:
    """The action that a call is: ``OUT(y[1])`` as ``out(y[1])``, ``fill()`` as ``call(fill)``; "" for none."""
    name, text = called(node), own(context, node)
    if not isinstance(node, cst.Call) or not name:
        return ""
    routine = "" if node.args else routine_named(context, name)
    text = f"call({routine})" if routine else name.lower() + text.removeprefix(name) if text else ""
    return text if text and fits_action(context, text) else ""


def rung_of(context: Context, test: Node, actions: Sequence[Node], wanted: bool = True) -> str:
    """``if x[1]: out(y[1])``; "" where one of the parts is none."""
    said = meant(context, test, partial(fits_condition, context), wanted)
    texts = [action_of(context, action) for action in actions]
    return f"if {said.text}: {'; '.join(texts)}" if said is not None and not said.before and all(texts) else ""


def as_it_is(context: Context, node: Node) -> str:
    """An expression as a condition; with its and, or and not where only the resolved program knows their opposites."""
    text = own(context, node)
    return as_condition(context, node) or (text if python_logic(node) and rewrites(context, node) else "")
