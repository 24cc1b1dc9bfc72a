"""A drawn rung in the words of the listing, so that lines of two programs can be compared and names shown with them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

from clickgen.click.compare.outputs import Said, outputs_of, said_by
from clickgen.click.draw.tokens import compare_token, contact_token, operand_token
from clickgen.click.read.grid import DrawnRow, DrawnRung, Square
from clickgen.click.read.operands import ADDRESS
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.rungs import import_rung
from clickgen.device.banks import Address, parse_address
from clickgen.emit.rung_words import Names, condition_lines, item_lines
from clickgen.instructions.effects import Flow
from clickgen.ir.conditions import Always, Compare
from clickgen.ir.operands import Cell, Operand
from clickgen.ir.program import Action, Rung

_ROOM = "\ue000"
"""Keeps room for a nickname after its address, so that both sides of a difference break at the same places."""
_NAMED = re.compile(rf"({ADDRESS}){_ROOM}+")
_ADDRESS = re.compile(rf"(?<![\w.\"]){ADDRESS}(?!\w)")
_FEATURE = re.compile(r'"[^"]*"|[^\s(),"]+')
_COMMON = frozenset(("if", "and", "or", "not", "always"))
_ALONE = (Flow.END, Flow.RETURN, Flow.NEXT, Flow.PASS)


class Words:
    """The words of a rung, for comparison. Rungs that are drawn alike are equal, and then nobody needs the words."""

    def __init__(self, drawn: DrawnRung, wording: Wording) -> None:
        self._drawn = drawn
        self._wording = wording

    @cached_property
    def lines(self) -> tuple[str, ...]:
        return self._wording.lines(self._drawn)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Words):
            return self.lines == other
        return self._drawn.is_drawn_as(other._drawn) or self.lines == other.lines

    def __hash__(self) -> int:
        return hash(self.lines)


@dataclass(frozen=True)
class WordedRung:
    """A rung and its words. ``number`` counts in its routine.

    If scratch cells have the numbers of the other side, ``origin`` is the rung with its own.
    """

    routine: str
    number: int
    drawn: DrawnRung
    wording: Wording
    origin: WordedRung | None = None

    @cached_property
    def words(self) -> Words:
        """Equal for two rungs in the same words."""
        return Words(self.drawn, self.wording)

    @property
    def lines(self) -> tuple[str, ...]:
        """Its words without names, but with room for them."""
        return self.words.lines

    @cached_property
    def is_plain(self) -> bool:
        """True for a rung that every program has: an unconditional end, return or next, or nothing at all."""
        rung = _imported(self.drawn)
        return rung is not None and _is_plain(rung)

    @property
    def shown(self) -> WordedRung:
        """The rung as a person finds it."""
        return self.origin or self

    @cached_property
    def comment(self) -> tuple[str, ...]:
        lines = self.drawn.comment.rstrip().split("\n")
        return tuple(line.rstrip() for line in lines) if self.drawn.comment.strip() else ()

    @cached_property
    def features(self) -> frozenset[str]:
        """The features by which two rungs resemble each other: comment, whole lines, and the words in them."""
        lines = [line.replace(_ROOM, "").strip() for line in self.lines]
        words = {word for line in lines for word in _FEATURE.findall(line)}
        return frozenset({*lines, *words, *(f"| {line}" for line in self.comment)} - _COMMON)

    @cached_property
    def outputs(self) -> tuple[Said, ...]:
        """The outputs of the rung, in the order of its rows."""
        return tuple(said_by(box) for box in outputs_of(self.drawn))

    @property
    def is_idle(self) -> bool:
        """True for a rung that does nothing, such as one that a person drew for its comment."""
        return not outputs_of(self.drawn)

    @cached_property
    def cells(self) -> tuple[str, ...]:
        """The rung as drawn, a line for each row."""
        return drawn_cells(self.drawn)


class Wording:
    """Puts rungs into words; the names of both sides say how much room a name may take."""

    def __init__(self, one: Names, other: Names) -> None:
        self._names = _WithRoom(one, other)
        self._known: dict[tuple[tuple[str, ...], ...], tuple[str, ...]] = {}
        """The words of rungs, by the text that they were read from."""

    def rung(self, routine: str, number: int, drawn: DrawnRung) -> WordedRung:
        """Return a rung that is put into words on demand."""
        return WordedRung(routine, number, drawn, self)

    def lines(self, drawn: DrawnRung) -> tuple[str, ...]:
        """Return a rung as the listing would show it, or as it is drawn if it cannot be written."""
        text = drawn.text
        found = self._known.get(text) if text is not None else None
        if found is None:
            rung = _imported(drawn)
            found = tuple(map(self._with_room, drawn_cells(drawn)) if rung is None else self._lines(rung))
            if text is not None:
                self._known[text] = found
        return found

    def _lines(self, rung: Rung) -> Iterator[str]:
        yield from condition_lines("", rung.condition, self._names)
        yield from item_lines("  ", rung.items, self._names)

    def cells(self, rung: WordedRung) -> tuple[str, ...]:
        """The rung as drawn, with room for names."""
        return tuple(map(self._with_room, rung.shown.cells))

    def _with_room(self, line: str) -> str:
        parts = line.split('"')
        parts[::2] = (_ADDRESS.sub(lambda match: self._names.room_for(match[0]), part) for part in parts[::2])
        return '"'.join(parts)


class _WithRoom(Names):
    """Shows addresses with room for the longer one of two names."""

    def __init__(self, one: Names, other: Names) -> None:
        super().__init__({})
        self._sides = (one, other)

    def show(self, operand: Operand) -> str:
        return self.room_for(operand_token(operand)) if isinstance(operand, Cell) else super().show(operand)

    def room_for(self, token: str) -> str:
        address = parse_address(token)
        width = max(len(side.nickname(address)) for side in self._sides) if address else 0
        return f"{token}{_ROOM * (width + 1)}" if width else token


def named(line: str, names: Names) -> str:
    """A line with the names of one side in the room that it has."""

    def shown(match: re.Match[str]) -> str:
        address = parse_address(match[1])
        nickname = names.nickname(address) if address else ""
        return f"{match[1]}:{nickname}" if nickname else match[1]

    return _NAMED.sub(shown, line)


def without(line: str, address: Address, word: str) -> str:
    """A line with a word in place of an address, except in quotes."""
    parts = line.split('"')
    parts[::2] = (re.sub(rf"(?<!\w){address}(?!\w){_ROOM}*", word, part) for part in parts[::2])
    return '"'.join(parts)


def _imported(drawn: DrawnRung) -> Rung | None:
    """Return a rung as a program has it; None if it cannot be written."""
    try:
        # A comment is not logic, and some comments are not possible in a program.
        return import_rung(replace(drawn, comment="")).rung
    except LadderProblem:
        return None


def drawn_cells(drawn: DrawnRung) -> tuple[str, ...]:
    """Return a rung as it is drawn, a line for each row."""
    pins = {row: token for box in drawn.boxes for token, row in box.pins}
    tokens = {box.row: box.token for box in drawn.boxes} | pins
    return tuple(_cells(row, tokens.get(n, row.output)) for n, row in enumerate(drawn.rows))


def _is_plain(rung: Rung) -> bool:
    actions = [item for item in rung.items if isinstance(item, Action) and item.effects.flow in _ALONE]
    return isinstance(rung.condition, Always) and len(actions) == len(rung.items)


def _cells(row: DrawnRow, output: str) -> str:
    """The cells of a row, the same ones counted: ``X001  T:X002  29 x -  out(Y001)``."""
    words: list[list[str]] = []
    for square in row.squares:
        text = _cell(square)
        if words and words[-1][0] == text and square.contact is None:
            words[-1].append(text)
        else:
            words.append([text])
    shown = [run[0] if len(run) == 1 else f"{len(run)} x {run[0]}" for run in words]
    return "  ".join([*shown, output or "."])


def _cell(square: Square) -> str:
    contact = square.contact
    if contact is None:
        return ("T" if square.down else "-") if square.right else "|" if square.down else "."
    token = compare_token(contact) if isinstance(contact, Compare) else contact_token(contact)
    return f"T:{token}" if square.down else token
