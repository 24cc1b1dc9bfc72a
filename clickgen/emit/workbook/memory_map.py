"""The sheet with a map of memory, ten cells in a row."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.device.banks import Address, Bank
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet
from clickgen.emit.workbook.states import GIVEN, State

_TENS = 10


def memory_map(project: Project) -> Sheet:
    letters = "; ".join(f"{state.letter} {state.words}" for state in State if state.letter)
    return Sheet(
        "Memory map",
        f"Ten cells in a row, by the last digit of their numbers: {letters}; blank free; - no such cell.",
        (
            Column("Bank", 8),
            Column("From", 10),
            Column("To", 10),
            *(Column(str(digit % _TENS), 4, is_centered=True) for digit in range(1, _TENS + 1)),
            Column("Free", 8),
        ),
        (row for bank in GIVEN for row in _map(project, bank)),
    )


def _map(project: Project, bank: Bank) -> Iterator[Cells]:
    """The rows of a bank; numbers begin a row behind each ten."""
    free: list[int] = []
    for first, last in bank.ranges:
        for start in range(first, last + 1, _TENS):
            numbers = range(start, min(start + _TENS, last + 1))
            states = [project.states.at(Address(bank.name, number)) for number in numbers]
            if all(state is State.FREE for state in states):
                free += numbers
                continue
            yield from _free_row(bank, free)
            free = []
            cells = [Marked(state.letter, state.look) for state in states]
            absent = [Marked("-", Look.FAINT)] * (_TENS - len(cells))
            yield *_ends(bank, numbers[0], numbers[-1]), *cells, *absent, states.count(State.FREE)
    yield from _free_row(bank, free)


def _free_row(bank: Bank, numbers: list[int]) -> Iterator[Cells]:
    if numbers:
        ends = tuple(Marked(text, Look.FAINT) for text in _ends(bank, numbers[0], numbers[-1]))
        yield *ends, *(None for _ in range(_TENS)), len(numbers)


def _ends(bank: Bank, first: int, last: int) -> tuple[str, str, str]:
    return bank.name, str(Address(bank.name, first)), str(Address(bank.name, last))
