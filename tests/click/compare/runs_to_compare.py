"""Rungs to compare."""

from __future__ import annotations

import re

from test_importing_cases import ladder_text, wired

from clickgen.click.compare.same import Likeness, compare
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.device.banks import Address

SCRATCH = frozenset(Address("C", number) for number in range(1900, 2001))


def rungs(*rows: list[str]) -> list[DrawnRung]:
    ladder = read_ladder(ladder_text(rows), "main.csv")
    assert not ladder.all_problems, ladder.all_problems
    return list(ladder.rungs)


def rung(*rows: str) -> list[DrawnRung]:
    """A rung of rows such as ``X001 T:X002 > out(Y001)``; ``.`` is a blank square."""
    found = []
    for number, row in enumerate(rows):
        contacts, output = re.split(r"(?:^| )>(?: |$)", row, maxsplit=1)
        found.append(wired(contacts, output, "" if number else "R"))
    return rungs(*found)


def bits(count: int, start: int = 1) -> list[str]:
    return [f"C{number}" for number in range(start, start + count)]


def told(one: list[DrawnRung], other: list[DrawnRung]) -> str:
    compared = compare(one, other, SCRATCH)
    assert compared.likeness is Likeness.DIFFERENT, compared
    return compared.reason


def likeness(one: list[DrawnRung], other: list[DrawnRung]) -> str:
    """The same in both directions."""
    found = compare(one, other, SCRATCH)
    assert found.likeness is compare(other, one, SCRATCH).likeness
    assert (found.reason == "") is found.is_same
    return found.likeness.name
