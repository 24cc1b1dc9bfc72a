"""Parts of conditions that are written in another form: lists of values, comparison signs, boolean algebra."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import libcst as cst

from clickgen.dialects.if_rungs.read.nodes import Node, elements, is_name, literal, terms
from clickgen.dialects.if_rungs.ways_out.hints import is_condition, truth_of

SIGNS: dict[type[Node], str] = {
    cst.Equal: "==",
    cst.NotEqual: "!=",
    cst.Is: "==",
    cst.IsNot: "!=",
    cst.LessThan: "<",
    cst.LessThanEqual: "<=",
    cst.GreaterThan: ">",
    cst.GreaterThanEqual: ">=",
}
MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}


class Part(NamedTuple):
    """A single condition, or several in ``all`` or ``any``."""

    function: str
    texts: tuple[str, ...]

    @property
    def text(self) -> str:
        return f"{self.function}({', '.join(self.texts)})" if self.function else self.texts[0]


def single(text: str) -> Part:
    """Return a part of one condition."""
    return Part("", (text,))


def joined(function: str, parts: Iterable[Part | None]) -> Part | None:
    """Join parts with ``all`` or ``any``; None if one of them is not certain."""
    texts: list[str] = []
    for part in parts:
        if part is None:
            return None
        texts += part.texts if part.function in ("", function) else [part.text]
    return Part(function, tuple(texts)) if len(texts) > 1 else single(texts[0]) if texts else None


_ALGEBRA: dict[type[Node], str] = {cst.Add: "any", cst.Multiply: "all"}


def algebra(node: Node) -> tuple[str, str, list[cst.BaseExpression]] | None:
    """``c.A + c.B`` and ``c.A * c.B``, as boolean algebra writes or and and."""
    function = _ALGEBRA.get(node.operator.__class__) if isinstance(node, cst.BinaryOperation) else None
    if function is None or not isinstance(node, cst.BinaryOperation) or not is_condition(node):
        return None
    return ("+", function, [node.left, node.right])


def is_listed(node: Node) -> bool:
    """True for several values where one is compared."""
    if isinstance(node, cst.BooleanOperation):
        return not any(map(is_condition, terms(node)))
    return len(elements(node)) > 0


def is_bool(node: Node) -> bool:
    """True for ``True``, ``False`` and words that mean one of them."""
    return isinstance(literal(node), bool) or (is_name(node) and truth_of(node) is not None)
