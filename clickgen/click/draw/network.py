"""A condition as series and parallel contacts, and its size in the grid."""

from __future__ import annotations

from clickgen.click.draw.tokens import compare_token, contact_token
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Immediate, Range
from clickgen.records import dataclass


@dataclass(frozen=True, slots=True)
class Leaf:
    """One contact: one cell of the grid."""

    token: str
    width: int = 1
    height: int = 1


@dataclass(frozen=True, slots=True)
class Series:
    parts: tuple[Net, ...]
    width: int
    height: int


@dataclass(frozen=True, slots=True)
class Parallel:
    legs: tuple[Net, ...]
    width: int
    height: int


Net = Leaf | Series | Parallel


def network(condition: Condition) -> Net | None:
    """The contacts of a condition, flattened: no series in a series, no parallel in a parallel. None is a bare wire."""
    if isinstance(condition, Contact):
        if is_range(condition):
            return series([Leaf(contact_token(bit)) for bit in bits(condition)])
        return Leaf(contact_token(condition))
    if isinstance(condition, Compare):
        return Leaf(compare_token(condition))
    if isinstance(condition, All):
        nets = [net for term in condition.terms if (net := network(term)) is not None]
        return series(nets) if nets else None
    if isinstance(condition, Any):
        # A leg that is always on makes the others useless: the reader lets none through.
        legs = [net for term in condition.terms if (net := network(term)) is not None]
        return parallel(legs) if len(legs) == len(condition.terms) else None
    assert isinstance(condition, Always)
    return None


def is_range(contact: Contact) -> bool:
    """True for a contact on several bits."""
    operand = contact.operand
    return isinstance(operand.target if isinstance(operand, Immediate) else operand, Range)


def bits(contact: Contact) -> list[Contact]:
    """Return one contact for each bit of a range contact: CLICK has no range contacts.

    click-facts [contact.ranges]
    """
    operand = contact.operand
    is_immediate = isinstance(operand, Immediate)
    target = operand.target if isinstance(operand, Immediate) else operand
    assert isinstance(target, Range)
    cells = [Cell(address, contact.span) for address in target.addresses()]
    return [
        Contact(Immediate(cell, contact.span) if is_immediate else cell, contact.span, contact.negated)
        for cell in cells
    ]


def series(nets: list[Net]) -> Net:
    parts = [part for net in nets for part in (net.parts if isinstance(net, Series) else (net,))]
    if len(parts) == 1:
        return parts[0]
    return Series(tuple(parts), sum(part.width for part in parts), max(part.height for part in parts))


def parallel(nets: list[Net]) -> Net:
    legs = [leg for net in nets for leg in (net.legs if isinstance(net, Parallel) else (net,))]
    if len(legs) == 1:
        return legs[0]
    return Parallel(tuple(legs), max(leg.width for leg in legs), sum(leg.height for leg in legs))
