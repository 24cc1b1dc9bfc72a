"""Copies that write further than the address they name: texts past the end of TXT, and over what follows
(click-facts [text.cell])."""

from __future__ import annotations

import re
from collections.abc import Iterator

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.spec import Access, Param
from clickgen.ir.operands import Cell, Text
from clickgen.ir.program import Action
from clickgen.ir.reach import length_of
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.blocks import Block

_NUMBER = re.compile(r"[ _]*[0-9]*$")


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        for cell, param, length in _long_writes(placed):
            last = Address(cell.bank, cell.address.number + length - 1)
            is_text = not param.extends_over
            if not BANKS[last.bank].has(last.number):
                _past_the_end(placed.action, cell, last, length, problems)
                continue
            block = _block_of(facts, cell.address)
            reason = ""
            if block is not None:
                named = _first_named(facts, Address(cell.bank, block.last + 1), last)
                over = f" and over {facts.shown(named)}" if named else ""
                if last.number > block.last:
                    reason = f"runs past the block {block.name} ({block}){over}"
            elif is_text:
                # Which registers a block copy writes, the person said by its source.
                named = _first_named(facts, Address(cell.bank, cell.address.number + 1), last, cell.address)
                reason = f"runs over {facts.shown(named)}" if named else ""
            if reason:
                what = _said(placed.action, length) if is_text else f"this copy of {length} addresses"
                problems.add(
                    "CG431",
                    cell.span,
                    f"{what} {reason}, to {last}",
                    "begin it earlier, shorten it, or make room for it: a block of "
                    f"{length} addresses, or other addresses for what follows",
                )


def _long_writes(placed: Placed) -> Iterator[tuple[Cell, Param, int]]:
    """The operands that stand for more addresses than their own and are written."""
    for param in placed.spec.params:
        operand = placed.action.args.get(param.name)
        if isinstance(operand, Cell) and param.slot.access is Access.WRITE:
            length = length_of(placed.action, param)
            if length > 1:
                yield operand, param, length


def _past_the_end(action: Action, cell: Cell, last: Address, length: int, problems: Diagnostics) -> None:
    """A text that surely reaches too far is refused (CG306)."""
    if cell.bank == "TXT" and not _is_sure_text(action):
        end = BANKS["TXT"].last
        problems.add(
            "CG430",
            cell.span,
            f"{_said(action, length)} reaches {last}: TXT ends at TXT{end}",
            f"begin it at txt[{end + 1 - length}] or earlier",
        )


def _said(action: Action, length: int) -> str:
    if _is_sure_text(action):
        return f"this text of {length} characters"
    return f"this number can take {length} characters as text, and then"


def _is_sure_text(action: Action) -> bool:
    return isinstance(action.args.get(action.spec.matrix[0]), Text)


def _block_of(facts: Facts, address: Address) -> Block | None:
    """The innermost block around an address."""
    around = [
        block for block in facts.blocks if block.bank == address.bank and block.first <= address.number <= block.last
    ]
    return min(around, key=lambda block: block.size, default=None)


def _first_named(facts: Facts, first: Address, last: Address, own: Address | None = None) -> Address | None:
    """The first address of a stretch that is another name's; cells named alike but for a number are one thing."""
    stem = _stem(facts.nickname(own)) if own else ""
    for number in range(first.number, last.number + 1):
        address = Address(first.bank, number)
        nickname = facts.nickname(address)
        if nickname and not (stem and _stem(nickname) == stem):
            return address
        if any(block.bank == address.bank and block.first == number for block in facts.blocks):
            return address
    return None


def _stem(nickname: str) -> str:
    return _NUMBER.sub("", nickname).lower()
