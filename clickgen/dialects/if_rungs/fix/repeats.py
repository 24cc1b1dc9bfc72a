"""Cuts terms out of a condition, and all(...) or any(...) around a last one."""

from __future__ import annotations

from collections.abc import Sequence

import libcst as cst

from clickgen.dialects.if_rungs.fix.logic import SWAPPED
from clickgen.dialects.if_rungs.fix.statement import Statements
from clickgen.dialects.if_rungs.read.nodes import called, every
from clickgen.text.edits import Edit
from clickgen.text.source import Span

_Holder = cst.Call | cst.List | cst.Tuple


def without_terms(statements: Statements, terms: Sequence[Span]) -> tuple[Edit, ...] | None:
    """The cuts that take these terms of one statement out; None if a comment or parentheses would go with them."""
    holders = {id(item.value): node for node in statements.holders(terms[0].line) for item in _items(node)}
    gone: set[int] = set()
    touched: dict[int, _Holder] = {}
    waiting = [statements.node(span) for span in terms]
    while waiting:
        term = waiting.pop()
        holder = holders.get(id(term))
        if holder is None:
            return None
        gone.add(id(term))
        touched[id(holder)] = holder
        if all(id(item.value) in gone for item in _items(holder)):
            waiting.append(holder)
    edits: list[Edit] = []
    for holder in touched.values():
        cuts = [] if id(holder) in gone else _cuts(statements, holder, gone)
        if cuts is None:
            return None
        edits += (Edit(statements.context.stretch(start, end), "") for start, end in cuts)
    return tuple(edits)


def _items(holder: _Holder) -> Sequence[cst.Arg | cst.BaseElement]:
    return holder.args if isinstance(holder, cst.Call) else holder.elements


def _cuts(statements: Statements, holder: _Holder, gone: set[int]) -> list[tuple[int, int]] | None:
    if any(isinstance(node, cst.Comment) for node in every(holder)):
        return None
    items, of = _items(holder), statements.context.places.of
    kept = [item for item in items if id(item.value) not in gone]
    if len(kept) == 1 and called(holder) in SWAPPED:
        (start, end), (first, last) = statements.context.extent(holder), statements.context.extent(kept[0].value)
        # A comparison over several lines needs the parentheses that would go.
        is_loose = isinstance(kept[0].value, cst.Comparison) and "\n" in statements.source.text[first:last]
        return None if is_loose else [(start, first), (last, end)]
    head = items.index(kept[0])
    if any(item.value.lpar for item in items if id(item.value) in gone):
        return None
    cuts = [(of(items[0])[0], of(kept[0])[0])] if head else []
    for before, item in zip(items[head:], items[head + 1 :], strict=False):
        if id(item.value) in gone:
            cuts.append((of(before)[1], of(item)[1]))
    return cuts
