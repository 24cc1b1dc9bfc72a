"""The values that copies put into a register: constants, other registers, and what these hold in turn."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.uses import addresses_of
from clickgen.instructions.effects import Shape
from clickgen.ir.operands import Cell, Constant, Pointer, Range, Single
from clickgen.ir.reach import touches

_PLAIN = (Shape.VALUE, Shape.FILL, Shape.BLOCK)
"""The ways in which a value arrives as it is."""


def put_in(writer: Placed, address: Address) -> Single | None:
    """The one value that a copy puts into an address; None if the writer is not a copy, or one of another kind."""
    if writer.effects.shape not in _PLAIN:
        return None
    source = writer.action.moved
    if isinstance(source, Range):
        written = [one for touch in touches(writer.action) if touch.is_written for one in addresses_of(touch.operand)]
        read = source.addresses()
        return Cell(read[written.index(address)], source.span) if len(read) == len(written) else None
    return source if isinstance(source, Cell | Pointer | Constant) else None


def origins(facts: Facts, address: Address) -> Iterator[Single]:
    """The registers and constants that copies, and copies of copies, put unchanged into a register.

    A whole number goes unchanged into any register, a floating-point number only into another one of its bank.
    """
    seen = {address}
    waiting = [address]
    while waiting:
        at = waiting.pop()
        for writer in facts.writers(at):
            put = put_in(writer, at)
            if isinstance(put, Cell) and (put.bank != "DF" or at.bank == "DF") and put.address not in seen:
                seen.add(put.address)
                waiting.append(put.address)
                yield put
            elif put is not None and not isinstance(put, Cell):
                yield put


def origin_registers(facts: Facts, address: Address) -> set[Address]:
    """A register and those that copies, and copies of copies, put into it."""
    return {address, *(put.address for put in origins(facts, address) if isinstance(put, Cell))}
