"""Whether rungs that look one after the other, and where arms do not run, do what one if with elif and else does."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from clickgen.device.banks import BANKS, TWIN_BANKS, VALUE_BANK
from clickgen.instructions import communication, copies, maths
from clickgen.instructions.coils import RESET, SET
from clickgen.instructions.control import CALL, END, FOR, NEXT, NOP, RETURN
from clickgen.instructions.raw import NOT_IMPORTED, RAW
from clickgen.instructions.spec import Access
from clickgen.ir.conditions import Condition
from clickgen.ir.operands import Cell, Immediate, Named, Operand, Range, form_of
from clickgen.ir.program import Action, Branch, Item, Loop, actions_in
from clickgen.ir.reach import length_of, touches
from clickgen.ir.walk import condition_operands, leaves
from clickgen.syntax.context import Context
from clickgen.syntax.opposites import is_block

_VOLATILE = ("T", "TD", "SC", "SD")
"""Banks that may change between two rungs although no instruction there writes them."""
_KEPT = (RAW, NOT_IMPORTED)
"""Nobody knows what these do."""
_UNKNOWN = (CALL, FOR, NEXT, END, RETURN, *_KEPT)
"""What runs behind these, or not, is not what stands behind them; or what they write is not known."""
_QUIET = (SET, RESET, NOP, CALL, NEXT, END, RETURN, *copies.SPECS, *maths.SPECS)
"""Instructions that change nothing while their condition does not hold."""
_MESSAGES = re.compile(rf"\b({'|'.join(spec.name for spec in (*communication.SPECS, RAW))})\s*\(")

_Place = tuple[str, object]
"""A bank, and a number or a name in it; None for all of the bank."""


def is_undone(context: Context, bodies: Sequence[tuple[Item, ...]]) -> bool:
    """True when an arm that does not run may undo what an earlier one did: out turns its bit off then."""
    for earlier, later in _pairs(bodies):
        after = _places_written(context, (action for action in actions_in(later) if action.spec not in _QUIET))
        if any(action.spec in _KEPT for action in actions_in(later)):
            return True
        is_open = any(action.spec in (CALL, FOR, *_KEPT) for action in actions_in(earlier))
        if after and (is_open or _meet(_places_written(context, actions_in(earlier)), after)):
            return True
    return False


def _pairs(bodies: Sequence[tuple[Item, ...]]) -> Iterator[tuple[tuple[Item, ...], tuple[Item, ...]]]:
    return ((earlier, later) for index, later in enumerate(bodies) for earlier in bodies[:index])


def may_look_again(
    context: Context, bodies: Sequence[tuple[Item, ...]], conditions: Sequence[Sequence[Condition]]
) -> bool:
    """True when what each later arm asks is the same before and behind the actions of the arms in front of it.

    ``conditions`` are what each arm but the first asks, in series.
    """
    # What other devices send arrives in its own time.
    if _MESSAGES.search(context.source.text):
        return False
    written: set[_Place] = set()
    for earlier, later, terms in zip(bodies, bodies[1:], conditions, strict=False):
        if any(action.spec in _UNKNOWN for action in actions_in(earlier)) or not all(map(_is_steady, terms)):
            return False
        written |= _places_written(context, actions_in(earlier))
        operands = [operand for term in terms for operand in condition_operands(term)]
        looked_at = {place for operand in (*operands, *_looked_at(later)) for place in _places(context, operand)}
        if _meet(written, looked_at):
            return False
    return True


def _is_steady(condition: Condition) -> bool:
    """True when nothing but an instruction changes it in the middle of a scan."""
    operands = list(condition_operands(condition))
    has_edge = any(getattr(leaf, "edge", "") for leaf in leaves(condition))
    is_immediate = any(isinstance(operand, Immediate) for operand in operands)
    return not has_edge and not is_immediate and not any(form_of(operand) in _VOLATILE for operand in operands)


def _looked_at(items: Iterable[Item]) -> Iterator[Operand]:
    """What the conditions of branches and pins look at."""
    for item in items:
        if isinstance(item, Branch):
            yield from condition_operands(item.condition)
            yield from _looked_at(item.items)
        elif not isinstance(item, Loop):
            for param in item.spec.pins:
                condition = item.pin(param.name)
                if condition is not None:
                    yield from condition_operands(condition)


def _places_written(context: Context, actions: Iterable[Action]) -> set[_Place]:
    places: set[_Place] = set()
    for action in actions:
        for touch in touches(action):
            if touch.is_written:
                places |= _places(context, touch.operand, length_of(action, touch.param) > 1)
            if touch.param.slot.access is Access.OWN and isinstance(touch.operand, Named | Cell):
                bank = touch.operand.bank
                places |= {(bank, None), (VALUE_BANK.get(bank, bank), None)}
    return places


def _places(context: Context, operand: Operand, is_long: bool = False) -> set[_Place]:
    """What an operand may be; names have no number yet."""
    if isinstance(operand, Immediate):
        return _places(context, operand.target)
    if isinstance(operand, Range):
        return {(address.bank, address.number) for address in operand.addresses()}
    if isinstance(operand, Cell):
        return {(operand.bank, operand.address.number)}
    if isinstance(operand, Named) and not is_long and not is_block(context, operand):
        return {(operand.bank, operand.name.lower())}
    return {(form_of(operand), None)} if form_of(operand) in BANKS else set()


def _meet(one: set[_Place], other: set[_Place]) -> bool:
    """True when two sets of places may have one in common: any name of a bank may be any number of it."""
    banks = {bank for bank, _ in one} | {TWIN_BANKS.get(bank, bank) for bank, _ in one}
    for bank in banks & {bank for bank, _ in other}:
        here = {key for name, key in one if name == bank}
        there = {key for name, key in other if name == bank}
        if not here or None in here | there or not here.isdisjoint(there):
            return True
        if len({type(key) for key in here | there}) > 1:
            return True
    return False
