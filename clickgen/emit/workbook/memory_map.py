"""The sheet with a map of memory, ten cells in a row."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from clickgen.device.banks import Address, Bank
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet
from clickgen.emit.workbook.states import GIVEN, State

_TENS = 10


def memory_map(project: Project) -> Sheet:
    letters = "; ".join(f"{state.letter} {state.words}" for state in State if state.letter)
    return Sheet(
        "Memory map",
        f"Ten cells in a row, by the last digit of their numbers: {letters}; blank free; - no such cell. "
        "Tens that are free, reserved or in blocks are one row.",
        (
            Column("Bank", 8),
            Column("From", 10),
            Column("To", 10),
            *(Column(str(digit % _TENS), 4, is_centered=True) for digit in range(1, _TENS + 1)),
            Column("Free", 8),
        ),
        (row for bank in GIVEN for row in _map(project, bank)),
    )


_FOLDED = (State.FREE, State.RESERVED, State.BLOCK)
"""States that thousands of cells may have: consecutive rows of ten of one of them are one line."""


def _map(project: Project, bank: Bank) -> Iterator[Cells]:
    """Yield the rows of a bank; a row begins every ten numbers."""

    def states_of(numbers: range) -> list[State]:
        return [project.states.at(Address(bank.name, number)) for number in numbers]

    def folded(numbers: range) -> State | int:
        states = set(states_of(numbers))
        return states.pop() if len(states) == 1 and not states.isdisjoint(_FOLDED) else numbers.start

    tens = [
        range(start, min(start + _TENS, last + 1))
        for first, last in bank.ranges
        for start in range(first, last + 1, _TENS)
    ]
    for _, group in groupby(tens, folded):
        run = list(group)
        states = states_of(run[0])
        if states[0] is State.FREE and len(set(states)) == 1:
            yield _free_row(bank, run)
            continue
        cells = [Marked(state.letter, state.look) for state in states]
        absent = [Marked("-", Look.FAINT)] * (_TENS - len(cells))
        if len(run) > 1:
            cells, absent = [cells[0]] * _TENS, []
        yield *_ends(bank, run[0].start, run[-1].stop - 1), *cells, *absent, states.count(State.FREE)


def _free_row(bank: Bank, run: list[range]) -> Cells:
    ends = tuple(Marked(text, Look.FAINT) for text in _ends(bank, run[0].start, run[-1].stop - 1))
    return *ends, *(None for _ in range(_TENS)), sum(map(len, run))


def _ends(bank: Bank, first: int, last: int) -> tuple[str, str, str]:
    return bank.name, str(Address(bank.name, first)), str(Address(bank.name, last))
