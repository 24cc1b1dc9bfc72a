"""Rungs of CLICK in words, with nicknames beside addresses: for the listing, the workbook and ``clickgen diff``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from clickgen.click.draw.tokens import NEVER_CONTACT, action_token, operand_token, pin_token
from clickgen.click.draw.words import condition_words, term_words
from clickgen.device.banks import CURRENT_VALUE_OF, Address
from clickgen.device.system import system_name_of
from clickgen.ir.conditions import All, Always, Any, Condition
from clickgen.ir.operands import Cell, Immediate, Operand, Pointer
from clickgen.ir.program import Action, Branch, Item, KeptToken

_KEYWORD = re.compile(r"[a-z_]+=")
_KEPT_HEAD = 3
"""The parts of a kept token before its fields: ``raw(Email,0x2737,1,``."""
_WIDTH = 100
"""A condition longer than this is broken at its terms, an instruction at its arguments."""


class Names:
    """Addresses with their nicknames beside them: ``C1:StartButton``."""

    def __init__(self, nicknames: Mapping[Address, str]) -> None:
        self._nicknames = nicknames

    def nickname(self, address: Address) -> str:
        """The nickname of an address, CLICK's own included; a current value goes by its timer's or counter's."""
        own = self._nicknames.get(address)
        if own:
            return own
        bit = CURRENT_VALUE_OF.get(address.bank)
        if bit:
            return self._nicknames.get(Address(bit, address.number), "")
        return system_name_of(address) or ""

    def show(self, operand: Operand) -> str:
        if isinstance(operand, Cell):
            nickname = self.nickname(operand.address)
            return f"{operand.address}:{nickname}" if nickname else str(operand.address)
        if isinstance(operand, Pointer):
            return f"{operand.bank}[{self.show(operand.register)}]"
        if isinstance(operand, Immediate):
            return f"immediate({self.show(operand.target)})"
        return operand_token(operand)

    def addresses(self) -> Iterable[Address]:
        """Every address that has a nickname."""
        return self._nicknames


def item_lines(indent: str, items: tuple[Item, ...], names: Names) -> Iterator[str]:
    """What hangs on a condition, a line for each instruction, branches indented."""
    for item in items:
        if isinstance(item, Branch):
            yield from condition_lines(indent, item.condition, names)
            yield from item_lines(indent + "  ", item.items, names)
        else:
            assert isinstance(item, Action)
            kept = item.args.get("token")
            is_kept = isinstance(kept, KeptToken) and not kept.is_formula
            yield from _broken(indent, action_token(item, names.show), is_kept)
            for param in item.spec.pins:
                condition = item.pin(param.name)
                if condition is None and not param.missing_pin:
                    continue
                words = condition_words(condition, names.show) if condition else f"never ({NEVER_CONTACT})"
                yield f"{indent}  {pin_token(item, param, names.show)} if {words}"


def _broken(indent: str, token: str, is_kept: bool) -> Iterator[str]:
    """An instruction; a long one that CLICK writes with keywords has each of them on a line of its own.

    So have the fields of a long one that is kept, and a pattern has a line for each of its rows.
    """
    if len(token) <= _WIDTH:
        yield indent + token
        return
    head, opening, inner = token.partition("(")
    parts = _parts(inner[:-1])
    is_kept = is_kept and len(parts) > _KEPT_HEAD
    if not (is_kept or all(_KEYWORD.match(part) for part in parts)):
        yield indent + token
        return
    if is_kept:
        opening += "".join(f"{part}," for part in parts[:_KEPT_HEAD])
        parts = parts[_KEPT_HEAD:]
    yield indent + head + opening
    for index, part in enumerate(parts):
        comma = "," if index < len(parts) - 1 else ""
        if part.startswith("pattern=["):
            rows = _parts(part[len("pattern=[") : -1])
            yield f"{indent}  pattern=["
            yield from (f"{indent}    {row}{',' if row is not rows[-1] else ''}" for row in rows)
            part = "]"
        yield f"{indent}  {part}{comma}"
    yield indent + ")"


def _parts(inner: str) -> list[str]:
    """The parts between the commas that stand in no bracket and no quotes."""
    parts, depth, quoted, start = [], 0, False, 0
    for index, character in enumerate(inner):
        if character == '"':
            quoted = not quoted
        elif not quoted and character in "([":
            depth += 1
        elif not quoted and character in ")]":
            depth -= 1
        elif not quoted and character == "," and depth == 0:
            parts.append(inner[start:index])
            start = index + 1
    return [*parts, inner[start:]]


def condition_lines(indent: str, condition: Condition, names: Names) -> Iterator[str]:
    """``if`` and the condition in words; a long one with each term on a line of its own."""
    words = condition_words(condition, names.show)
    if isinstance(condition, Always):
        yield f"{indent}always"
    elif len(words) <= _WIDTH or not isinstance(condition, All | Any):
        yield f"{indent}if {words}"
    else:
        joiner = "and" if isinstance(condition, All) else "or"
        for index, term in enumerate(condition.terms):
            yield f"{indent}{f'   {joiner}' if index else 'if'} {term_words(term, condition, names.show)}"
