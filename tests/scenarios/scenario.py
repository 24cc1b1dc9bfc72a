"""How a scenario is written: a program, and lines of scans with the memory that they leave."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from judges.simulator import Value
from pyclickplc.addresses import format_address_display, parse_address

Cell = Value | Sequence[Value]
"""The content of one address; a list, or a text longer than one character, also fills the addresses after it."""


@dataclass(frozen=True)
class Disagreement:
    """pyrung differs from docs/click-facts.md, which clickgen follows."""

    address: str
    click: Value
    pyrung: Value
    reason: str


@dataclass(frozen=True)
class Step:
    """Some scans, what is written to the memory before the first, and what is expected after the last."""

    scans: int
    given: Mapping[str, Value]
    powers_up: bool = False
    expected: Mapping[str, Value] = field(default_factory=dict)
    disagreements: tuple[Disagreement, ...] = ()

    def give(self, **cells: Cell) -> Step:
        return replace(self, expected=dict(_single(cells)))

    def but_pyrung(self, reason: str, **cells: Cell) -> Step:
        """Where pyrung disagrees with ``give``, and why."""
        found = [Disagreement(address, self.expected[address], value, reason) for address, value in _single(cells)]
        assert all(one.click != one.pyrung for one in found), "where both agree there is no disagreement"
        return replace(self, disagreements=self.disagreements + tuple(found))


def scans(count: int, /, **given: Cell) -> Step:
    """The next scans, after the given values are written."""
    return Step(count, dict(_single(given)))


def power_up(count: int, /, **given: Cell) -> Step:
    """The first scans after the PLC was switched off and on."""
    return Step(count, dict(_single(given)), powers_up=True)


@dataclass(frozen=True)
class Scenario:
    """A program and the table of its steps."""

    name: str
    text: str
    steps: tuple[Step, ...]
    ms: float
    """The time of a scan."""
    pyrung_cannot: str
    """The message with which pyrung refuses to read the ladder."""
    ends_return: bool
    """Run it with main as a subroutine and its ends as returns; otherwise, if pyrung refuses, it does not run."""

    @property
    def program(self) -> str:
        """The whole source file; a text without a main is the inside of one."""
        text = textwrap.dedent(self.text).strip()
        if "def main():" not in text:
            text = f"def main():\n{textwrap.indent(text, '    ')}"
        return f"{text}\n\n    if True:\n        end()\n"


def scenario(
    name: str, text: str, *steps: Step, ms: float = 10, pyrung_cannot: str = "", ends_return: bool = False
) -> Scenario:
    return Scenario(name, text, steps, ms, pyrung_cannot, ends_return)


def _single(cells: Mapping[str, Cell]) -> Iterator[tuple[str, Value]]:
    """Each address with its own value."""
    for address, cell in cells.items():
        values = [cell] if isinstance(cell, (int, float)) or cell == "" else list(cell)
        bank, number = parse_address(address)
        for offset, value in enumerate(values):
            yield format_address_display(bank, number + offset), value
