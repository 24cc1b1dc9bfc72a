"""listing.txt: the program as a person reads it and as ``git diff`` shows it.

Nothing in it changes without the program changing: no dates, no source lines, rungs numbered in each routine.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain

from clickgen.click.draw.tokens import NEVER_CONTACT, action_token, operand_token, pin_token
from clickgen.click.draw.words import condition_words, term_words
from clickgen.device.banks import CURRENT_VALUE_OF, Address, parse_address
from clickgen.device.system import system_name_of
from clickgen.facts.uses import extents_of
from clickgen.instructions.raw import RAW
from clickgen.ir.conditions import All, Always, Any, Condition
from clickgen.ir.operands import Cell, Immediate, Operand, Pointer, Range
from clickgen.ir.program import Action, Branch, Item
from clickgen.ir.reach import touches
from clickgen.ir.walk import condition_operands
from clickgen.lower.split import ClickRoutine, ClickRung
from clickgen.text.wording import counted, escaped

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


def listing(title: str, routines: Iterable[ClickRoutine], nicknames: Mapping[Address, str]) -> str:
    """The whole listing: counts, every routine rung by rung, and the cross-reference."""
    routines = tuple(routines)
    names = Names(nicknames)
    lines = [f"CLICK program {escaped(title)}", ""]
    width = max(len(routine.name) for routine in routines)
    for routine in routines:
        rows = sum(len(rung.grid) for rung in routine.rungs)
        lines.append(f"  {routine.name:<{width}}  {counted(len(routine.rungs), 'rung')}, {counted(rows, 'row')}")
    for routine in routines:
        lines += ["", "", routine.name, "=" * len(routine.name)]
        for number, rung in enumerate(routine.rungs, 1):
            lines += ["", *_rung(number, rung, names)]
    lines += ["", "", "Cross-reference", "===============", ""]
    lines += _cross_reference(routines, names)
    return "\n".join(lines) + "\n"


# -- rungs ------------------------------------------------------------------------------------------------------------


def _rung(number: int, rung: ClickRung, names: Names) -> Iterator[str]:
    yield f"Rung {number}"
    for line in rung.comment.split("\n") if rung.comment else ():
        yield f"  | {line}".rstrip()
    yield from condition_lines("  ", rung.condition, names)
    yield from item_lines("    ", rung.items, names)


def item_lines(indent: str, items: tuple[Item, ...], names: Names) -> Iterator[str]:
    """What hangs on a condition, a line for each instruction, branches indented."""
    for item in items:
        if isinstance(item, Branch):
            yield from condition_lines(indent, item.condition, names)
            yield from item_lines(indent + "  ", item.items, names)
        else:
            assert isinstance(item, Action)
            yield from _broken(indent, action_token(item, names.show))
            for param in item.spec.pins:
                condition = item.pin(param.name)
                if condition is None and not param.missing_pin:
                    continue
                words = condition_words(condition, names.show) if condition else f"never ({NEVER_CONTACT})"
                yield f"{indent}  {pin_token(item, param, names.show)} if {words}"


def _broken(indent: str, token: str) -> Iterator[str]:
    """An instruction; a long one that CLICK writes with keywords has each of them on a line of its own.

    So have the fields of a long one that is kept, and a pattern has a line for each of its rows.
    """
    head, opening, inner = token.partition("(")
    parts = _parts(inner[:-1])
    is_kept = head == RAW.name and len(parts) > _KEPT_HEAD
    if len(token) <= _WIDTH or not (is_kept or all(_KEYWORD.match(part) for part in parts)):
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


# -- cross-reference --------------------------------------------------------------------------------------------------


@dataclass
class _Uses:
    written: dict[str, list[int]] = field(default_factory=dict)
    read: dict[str, list[int]] = field(default_factory=dict)

    def add(self, routine: str, rung: int, is_written: bool) -> None:
        rungs = (self.written if is_written else self.read).setdefault(routine, [])
        if not rungs or rungs[-1] != rung:
            rungs.append(rung)


_Key = tuple[tuple[int, int, bool], int, str]
"""Sorts addresses in CLICK's order, a range behind its first address, a pointer before its bank."""


class _CrossReference:
    """``known`` are the numbers by bank that get a line of their own where a range or a word leads to them."""

    def __init__(self, known: Mapping[str, Sequence[int]]) -> None:
        self._known = known
        self.uses: dict[_Key, _Uses] = {}

    def add(self, operand: Operand, routine: str, rung: int, is_written: bool) -> None:
        if isinstance(operand, Immediate):
            operand = operand.target
        if isinstance(operand, Cell):
            self._note_cell(operand.address, routine, rung, is_written)
        elif isinstance(operand, Range):
            low, high = sorted((operand.first, operand.last))
            first, length = Address(operand.bank, low), high - low + 1
            text = str(first) if length == 1 else f"{first}..{Address(operand.bank, high)}"
            self._note((first.sort_key, length - 1, text), routine, rung, is_written)
        elif isinstance(operand, Pointer):
            key = ((Address(operand.bank, -1).sort_key), 0, operand_token(operand))
            self._note(key, routine, rung, is_written)
        for index, (bank, low, high) in enumerate(extents_of(operand)):
            # The first one is the operand's own; the others are the points that its words hold.
            if index or low < high:
                for number in self._known_in(bank, low, high):
                    self._note_cell(Address(bank, number), routine, rung, is_written)

    def _known_in(self, bank: str, low: int, high: int) -> Sequence[int]:
        numbers = self._known.get(bank, ())
        return numbers[bisect_left(numbers, low) : bisect_left(numbers, high + 1)]

    def _note_cell(self, address: Address, routine: str, rung: int, is_written: bool) -> None:
        self._note((address.sort_key, 0, str(address)), routine, rung, is_written)

    def _note(self, key: _Key, routine: str, rung: int, is_written: bool) -> None:
        uses = self.uses.get(key)
        if uses is None:
            uses = self.uses[key] = _Uses()
        uses.add(routine, rung, is_written)


def _cross_reference(routines: tuple[ClickRoutine, ...], names: Names) -> list[str]:
    touched = tuple(_all_touched(routines))
    table = _CrossReference(known_numbers(names, (operand for operand, *_ in touched)))
    for operand, routine, number, is_written in touched:
        table.add(operand, routine, number, is_written)
    rows = [("Address", "Nickname", "Written", "Read")]
    for key, uses in sorted(table.uses.items()):
        _, length, text = key
        address = parse_address(text) if length == 0 else None
        nickname = names.nickname(address) if address else ""
        rows.append((text, nickname, _places(uses.written), _places(uses.read)))
    widths = [max(len(row[column]) for row in rows) for column in range(2)]
    return [f"{row[0]:<{widths[0]}}  {row[1]:<{widths[1]}}  {row[2] or '-'} | {row[3] or '-'}" for row in rows]


def known_numbers(names: Names, operands: Iterable[Operand]) -> Mapping[str, Sequence[int]]:
    """The addresses that have a nickname or that some operand names by themselves: numbers in order, by bank."""
    known: dict[str, set[int]] = defaultdict(set)
    targets = (operand.target if isinstance(operand, Immediate) else operand for operand in operands)
    cells = (target.address for target in targets if isinstance(target, Cell))
    for address in chain(names.addresses(), cells):
        if not address.upper:
            known[address.bank].add(address.number)
    return {bank: sorted(numbers) for bank, numbers in known.items()}


def _all_touched(routines: tuple[ClickRoutine, ...]) -> Iterator[tuple[Operand, str, int, bool]]:
    """Every operand with the routine and the rung that it stands in, and whether it is written there."""
    for routine in routines:
        for number, rung in enumerate(routine.rungs, 1):
            for operand in condition_operands(rung.condition):
                yield operand, routine.name, number, False
            for operand, is_written in _touched(rung.items):
                yield operand, routine.name, number, is_written


def _touched(items: tuple[Item, ...]) -> Iterator[tuple[Operand, bool]]:
    for item in items:
        if isinstance(item, Branch):
            yield from ((operand, False) for operand in condition_operands(item.condition))
            yield from _touched(item.items)
        else:
            assert isinstance(item, Action)
            yield from ((touch.operand, touch.is_written) for touch in touches(item))


def _places(uses: Mapping[str, list[int]]) -> str:
    return "; ".join(f"{routine} {', '.join(map(str, rungs))}" for routine, rungs in uses.items())
