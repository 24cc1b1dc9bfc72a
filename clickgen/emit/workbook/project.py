"""What a workbook tells of: a program as it goes into CLICK, with the address table that goes with it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, islice

from clickgen.device.banks import Address
from clickgen.emit.listing import Names
from clickgen.emit.workbook.sheet import Cells, Look, Marked
from clickgen.emit.workbook.states import States
from clickgen.facts.uses import Use, Uses
from clickgen.ir.program import Program, Routine, Rung
from clickgen.lower.split import ClickRoutine
from clickgen.table.rows import Row
from clickgen.text.source import SourceFile, Span

_PLACES_MAX = 12
"""So many rungs are named in one cell; the cross-reference has them all."""


@dataclass(frozen=True, eq=False)
class Project:
    """``rows`` are the address table's, ``scratch`` those of them that this program needs for itself, ``blocks`` the
    addresses inside of blocks.

    Source files are named relative to ``base``, the folder of the program. ``new`` counts the names whose addresses the
    table on disk does not have yet.
    """

    name: str
    routines: tuple[ClickRoutine, ...]
    rows: tuple[Row, ...]
    scratch: tuple[Row, ...] = ()
    reserved: frozenset[Address] = frozenset()
    new: int = 0
    base: str = ""
    blocks: frozenset[Address] = frozenset()

    @cached_property
    def by_address(self) -> Mapping[Address, Row]:
        return {row.address: row for row in self.rows}

    @cached_property
    def names(self) -> Names:
        return Names({row.address: row.nickname for row in self.rows if row.nickname})

    def text_of(self, address: Address) -> str:
        """The comment of an address."""
        row = self.by_address.get(address)
        return row.comment if row else ""

    def spare_word(self, address: Address) -> str:
        """What the I/O list has in place of a nickname: ``SPARE``."""
        row = self.by_address.get(address)
        return row.spare if row else ""

    @cached_property
    def uses(self) -> Uses:
        """Every use of an address in the rungs of CLICK."""
        return Uses.of(self._program)

    @cached_property
    def states(self) -> States:
        return States.of(self.rows, self.blocks, self.reserved, self.uses)

    def rung_of(self, use: Use) -> int:
        """The number of the CLICK rung that a use stands in, from 1 in its routine."""
        return self._numbers[id(use.rung)]

    @cached_property
    def _program(self) -> Program:
        """The rungs of CLICK in the form in which the index takes them."""
        routines = tuple(
            Routine(
                routine.name,
                tuple(Rung(rung.condition, rung.items, rung.comment, rung.span, rung.span) for rung in routine.rungs),
                routine.span,
                routine.is_main,
            )
            for routine in self.routines
        )
        return Program(SourceFile("", ""), routines, ())

    @cached_property
    def _numbers(self) -> Mapping[int, int]:
        """By identity: two rungs may say the same."""
        return {id(rung): number for routine in self._program.routines for number, rung in enumerate(routine.rungs, 1)}

    @cached_property
    def _files(self) -> dict[str, str]:
        return {}

    def file(self, path: str) -> str:
        """A source file as seen from the program, the same however the program was named."""
        if path not in self._files:
            self._files[path] = os.path.relpath(path, self.base or ".").replace(os.sep, "/")
        return self._files[path]

    def line(self, span: Span) -> str:
        """``conveyor.py:12``"""
        return f"{self.file(span.path)}:{span.line}"

    def lines(self, span: Span) -> str:
        """``conveyor.py:12-14``"""
        return self.line(span) + (f"-{span.end_line}" if span.end_line > span.line else "")

    def places(self, uses: Iterable[Use]) -> str:
        """``main 3, 7; auto 2``: the rungs of some uses, each once."""
        places = list(dict.fromkeys((use.routine.name, self.rung_of(use)) for use in uses))
        shown = dict.fromkeys(name for name, _ in places[:_PLACES_MAX])
        words = (f"{routine} {listed(n for name, n in places[:_PLACES_MAX] if name == routine)}" for routine in shown)
        more = len(places) - _PLACES_MAX
        return "; ".join(words) + (f" and {more} more" if more > 0 else "")


def listed(numbers: Iterable[int]) -> str:
    return ", ".join(map(str, numbers))


def or_none(rows: Iterator[Cells], none: str) -> Iterator[Cells]:
    """The rows, or where there are none a line that says so."""
    first = tuple(islice(rows, 1))
    return chain(first or ((Marked(none, Look.FAINT),),), rows)
