"""The sheets' view of a program."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain, islice

from clickgen.device.banks import Address
from clickgen.emit.built import BuiltProgram
from clickgen.emit.uses import RungUse
from clickgen.emit.workbook.sheet import Cells, Look, Marked
from clickgen.emit.workbook.states import States
from clickgen.text.source import Span

_PLACES_MAX = 12
"""This many rungs are named in one cell; the cross-reference has them all."""


@dataclass(frozen=True, eq=False)
class Project:
    """A built program, with the words of the sheets for places and the states of its cells."""

    built: BuiltProgram
    _files: dict[str, str] = field(default_factory=dict)

    def text_of(self, address: Address) -> str:
        """The comment of an address."""
        row = self.built.by_address.get(address)
        return row.comment if row else ""

    def spare_word(self, address: Address) -> str:
        """The text that the I/O list has in place of a nickname: ``SPARE``."""
        row = self.built.by_address.get(address)
        return row.spare if row else ""

    @cached_property
    def states(self) -> States:
        """The state of each cell."""
        blocks = (address for block in self.built.blocks for address in block.addresses())
        return States.of(self.built.rows, blocks, self.built.reserved, self.built.uses.every)

    def file(self, path: str) -> str:
        """A source file relative to the program, the same however the program was named."""
        if path not in self._files:
            self._files[path] = os.path.relpath(path, self.built.folder or ".").replace(os.sep, "/")
        return self._files[path]

    def line(self, span: Span) -> str:
        """``conveyor.py:12``"""
        return f"{self.file(span.path)}:{span.line}"

    def lines(self, span: Span) -> str:
        """``conveyor.py:12-14``"""
        return self.line(span) + (f"-{span.end_line}" if span.end_line > span.line else "")

    def places(self, uses: Iterable[RungUse]) -> str:
        """``main 3, 7; auto 2``: the rungs of some uses, each once."""
        places = list(dict.fromkeys((use.routine, use.rung) for use in uses))
        shown = dict.fromkeys(name for name, _ in places[:_PLACES_MAX])
        words = (f"{routine} {listed(n for name, n in places[:_PLACES_MAX] if name == routine)}" for routine in shown)
        more = len(places) - _PLACES_MAX
        return "; ".join(words) + (f" and {more} more" if more > 0 else "")


def listed(numbers: Iterable[int]) -> str:
    """``3, 7, 12``"""
    return ", ".join(map(str, numbers))


def or_none(rows: Iterator[Cells], none: str) -> Iterator[Cells]:
    """The rows; if there are none, one line that says so."""
    first = tuple(islice(rows, 1))
    return chain(first or ((Marked(none, Look.FAINT),),), rows)
