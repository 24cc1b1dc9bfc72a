"""The formula that a person wrote, as frozen nodes. Written parentheses are kept, so that CLICK shows them too.

``start`` and ``end`` are character offsets into the formula; the end is exclusive.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from clickgen.ir.operands import Cell, Named, Pointer, Range
from clickgen.records import dataclass

Mode = Literal["decimal", "hex"]
"""``decimal`` for calc, ``hex`` for math_hex."""


@dataclass(frozen=True, slots=True)
class Number:
    """A decimal number of a decimal formula; ``text`` is as written."""

    text: str
    value: int | float
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class HexNumber:
    """A number of a hexadecimal formula, 0..FFFFh; ``digits`` is how many were written, at most 4."""

    value: int
    start: int
    end: int
    digits: int = 1

    @property
    def text(self) -> str:
        """The number as CLICK shows it: it begins with a digit or has all four.

        click-facts [math.hex-constants]
        """
        text = f"{self.value:0{self.digits}X}"
        return f"{text if text[0].isdigit() else text.zfill(4)}h"


@dataclass(frozen=True, slots=True)
class Pi:
    """CLICK's ``PI``, 3.1415927 (click-facts [math.functions])."""

    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Operand:
    """One cell, by name, address or pointer."""

    ref: Named | Cell | Pointer
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Sum:
    """``SUM(ds[1:11])``: the sum of DS1 to DS10. Both ends of ``range`` are included; a name is that of a block."""

    range: Range | Named
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Unary:
    """``-x`` or ``NOT x``. CLICK has neither: the printer lowers them."""

    op: Literal["-", "NOT"]
    operand: Node
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Binary:
    """``left op right``; op is one of ``+ - * / ^ MOD AND OR XOR LSH RSH LRO RRO``. A shift is a call in CLICK."""

    op: str
    left: Node
    right: Node
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Call:
    """A function of one value; ``name`` in upper case."""

    name: str
    argument: Node
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Group:
    """Parentheses that a person wrote."""

    inner: Node
    start: int
    end: int


Node = Number | HexNumber | Pi | Operand | Sum | Unary | Binary | Call | Group


@dataclass(frozen=True, slots=True)
class Formula:
    """A whole formula and the instruction family it belongs to."""

    root: Node
    mode: Mode


def walk(formula: Formula) -> Iterator[Node]:
    """Yield every node, from left to right, a node before its parts."""
    waiting: list[Node] = [formula.root]
    while waiting:
        node = waiting.pop()
        yield node
        if isinstance(node, Binary):
            waiting += (node.right, node.left)
        elif isinstance(node, Unary):
            waiting.append(node.operand)
        elif isinstance(node, Call):
            waiting.append(node.argument)
        elif isinstance(node, Group):
            waiting.append(node.inner)


def references(formula: Formula) -> list[Operand | Sum]:
    """The cells and ranges that the formula reads, from left to right."""
    return [node for node in walk(formula) if isinstance(node, Operand | Sum)]
