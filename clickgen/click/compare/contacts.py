"""Contacts and comparisons as variables: one name for everything that is certainly on and off together."""

from __future__ import annotations

from decimal import Decimal
from typing import NamedTuple

from clickgen.click.draw.tokens import contact_token, operand_token
from clickgen.device.banks import VALUE_CLASSES, Kind
from clickgen.device.system import ALWAYS_ON
from clickgen.ir.conditions import MIRRORED, OPPOSITE, Compare, Contact
from clickgen.ir.operands import Cell, CharCode, Hex, Integer, Operand, Real, Text


class Literal(NamedTuple):
    """A variable or its negation; without a name it is always on."""

    name: str
    negated: bool = False


def literal_of(contact: Contact | Compare) -> Literal:
    """``X001`` and ``~X001`` are one variable, ``DS1!=5`` is the negation of ``5==DS1``, ``SC1`` is always on."""
    if isinstance(contact, Compare):
        return _compared(contact)
    token = operand_token(contact.operand)
    if contact.edge:
        return Literal(f"{contact.edge.value}({token})", contact.negated)
    is_constant = isinstance(contact.operand, Cell) and contact.operand.address == ALWAYS_ON
    return Literal("" if is_constant else token, contact.negated)


def contact_name(contact: Contact | Compare) -> str:
    """A contact as written in a square."""
    if isinstance(contact, Compare):
        return f"{operand_name(contact.left)}{contact.op}{operand_name(contact.right)}"
    return contact_token(contact)


def operand_name(operand: Operand) -> str:
    """An operand's token, with numbers of the same value alike: ``1.50`` is ``1.5``, and ``5.0`` is not ``5``."""
    if not isinstance(operand, Real):
        return operand_token(operand)
    text = repr(operand.value)
    # A number with more digits than a double holds stays as written.
    return text if Decimal(text) == Decimal(operand.text.replace("_", "")) else operand.text


def _compared(compare: Compare) -> Literal:
    """Exchange sides only between values of one kind: nobody knows how CLICK converts one for the other
    (click-facts [compare.mixed])."""
    left, right, op = compare.left, compare.right, compare.op
    kind = _kind(left)
    if kind and kind == _kind(right):
        if _key(right) < _key(left):
            left, right, op = right, left, MIRRORED[op]
        # A float may be no number; then neither a comparison nor its opposite need hold.
        is_total = kind in ("whole", "hexadecimal") or (kind == "text" and op in ("==", "!="))
        if is_total and op in ("!=", ">=", ">"):
            return Literal(f"{operand_name(left)}{OPPOSITE[op]}{operand_name(right)}", True)
    return Literal(f"{operand_name(left)}{op}{operand_name(right)}")


def _kind(operand: Operand) -> str:
    """The class of values that is compared without a conversion; "" if it is unknown."""
    if isinstance(operand, Cell):
        kind = operand.address.kind
        if kind in (Kind.INT16, Kind.INT32):
            return "whole"
        return "float" if kind is Kind.FLOAT else "" if kind is Kind.BIT else VALUE_CLASSES[kind]
    if isinstance(operand, Integer):
        return "whole"
    if isinstance(operand, Hex):
        return "hexadecimal"
    if isinstance(operand, Real):
        return "float"
    return "text" if isinstance(operand, Text | CharCode) else ""


def _key(operand: Operand) -> tuple[bool, str]:
    """Registers come before constants."""
    return not isinstance(operand, Cell), operand_name(operand)
