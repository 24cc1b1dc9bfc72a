"""Finds what each scratch cell serves: the output, timer or other instruction that waits for it.

A scratch cell is identified by what it serves. Unlike a rung number, that stays when rungs are inserted before it or a
condition is changed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from clickgen.click.draw.tokens import operand_token
from clickgen.device.banks import Address
from clickgen.instructions.effects import Flow
from clickgen.instructions.spec import Access, ParamKind
from clickgen.ir.operands import Cell, Immediate, Operand, Pointer
from clickgen.ir.program import Action, Branch, Item
from clickgen.ir.reach import touches
from clickgen.ir.walk import action_operands, condition_operands
from clickgen.lower.split import ClickRoutine

NicknameOf = Callable[[Address], str]
"""The nickname of an address, or ""."""


def served(routines: Iterable[ClickRoutine], ends: Mapping[Address, str], nickname: NicknameOf) -> dict[Address, str]:
    """Return what each placeholder serves, in words: ``out Y001 Motor``.

    A placeholder that only serves another one serves what that one serves. Those in ``ends`` have a purpose of their
    own, in words, and are not followed.
    """
    readers = [
        reader
        for routine in routines
        for rung in routine.rungs
        for reader in _readers(rung.items, _placeholders(condition_operands(rung.condition)))
    ]
    words = _Words(ends, nickname)
    best: dict[Address, tuple[int, int]] = {}
    # Backwards: whatever reads a scratch cell comes after the rung that writes it.
    for index, (action, placeholders) in reversed([*enumerate(readers)]):
        target = words.own(action)
        serves = (words.rank(action), index) if target is None or target in ends else best.get(target)
        if serves is not None:
            best.update((placeholder, min(serves, best.get(placeholder, serves))) for placeholder in placeholders)
    return {placeholder: words.said(readers[index][0]) for placeholder, (_, index) in best.items()}


def _readers(items: tuple[Item, ...], above: frozenset[Address]) -> Iterator[tuple[Action, frozenset[Address]]]:
    """The instructions that look at placeholders, or whose condition does: ``above`` has those above them."""
    for item in items:
        if isinstance(item, Branch):
            yield from _readers(item.items, above | _placeholders(condition_operands(item.condition)))
        else:
            assert isinstance(item, Action)
            placeholders = above | _placeholders(action_operands(item))
            if placeholders:
                yield item, placeholders


class _Words:
    def __init__(self, ends: Mapping[Address, str], nickname: NicknameOf) -> None:
        self._ends = ends
        self._nickname = nickname

    def rank(self, action: Action) -> int:
        """How reliably it is found again: an output, then a box, then the rest. The first of those counts."""
        if action.effects.follows_power and self.own(action) not in self._ends:
            return 0
        is_box = bool(action.spec.pins) or any(param.slot.access is Access.OWN for param in action.spec.params)
        return 1 if is_box else 2

    def own(self, action: Action) -> Address | None:
        """The placeholder that an instruction writes."""
        written = _placeholders(touch.operand for touch in touches(action) if touch.is_written)
        return min(written, default=None)

    def said(self, action: Action) -> str:
        """An instruction and what it writes: ``copy to DS5 Speed``."""
        name = action.spec.name
        if action.effects.flow is Flow.CALL:
            return f"{name} {action.called}"
        own = self.own(action)
        if own is not None:
            return self._ends[own]
        written = (touch.operand for touch in touches(action) if touch.is_written)
        target = next(written, None)
        if target is None:
            return name
        # The operand that an instruction reads is its first argument: copy(ds.A, ds.B), calc("...", ds.B).
        first = action.spec.params[0]
        is_to = first.slot.access is Access.READ and first.kind in (ParamKind.OPERAND, ParamKind.FORMULA)
        return f"{name}{' to' if is_to else ''} {self._shown(target)}"

    def _shown(self, operand: Operand) -> str:
        if isinstance(operand, Immediate):
            operand = operand.target
        if isinstance(operand, Pointer):
            return operand_token(operand)
        name = self._nickname(operand.address) if isinstance(operand, Cell) else ""
        return f"{operand_token(operand)} {name}".strip()


def _placeholders(operands: Iterable[Operand]) -> frozenset[Address]:
    cells = (operand.target if isinstance(operand, Immediate) else operand for operand in operands)
    return frozenset(cell.address for cell in cells if isinstance(cell, Cell) and cell.address.number < 0)
