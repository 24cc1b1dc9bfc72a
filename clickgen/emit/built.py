"""A program as it goes into CLICK: the one value that every writer takes its output from."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from clickgen.click.ladder_csv import ladder_csv
from clickgen.device.banks import Address
from clickgen.emit.rung_words import Names
from clickgen.emit.uses import RungUses
from clickgen.lower.split import ClickRoutine, ClickRung
from clickgen.table.blocks import Block
from clickgen.table.rows import Row


@dataclass(frozen=True, eq=False)
class BuiltProgram:
    """Routines in CLICK rungs, and the rows of the address table that go with them.

    ``path`` is the program's main file, as the user named it. ``ladders`` are the rungs of each ladder file, by its
    path in the output folder. ``rows`` is the whole table, ``scratch`` those of its rows that clickgen needs for itself
    in this program. ``blocks`` are those that the program declares and those that the table marks, ``reserved`` the
    addresses that the settings keep free. ``new``
    counts the names whose addresses the table on disk lacks. ``outputs`` are the files of this build, in their order.
    """

    path: str
    routines: tuple[ClickRoutine, ...]
    rows: tuple[Row, ...]
    scratch: tuple[Row, ...] = ()
    ladders: Mapping[str, tuple[ClickRung, ...]] = field(default_factory=dict)
    blocks: tuple[Block, ...] = ()
    reserved: frozenset[Address] = frozenset()
    new: int = 0
    outputs: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The name of the main file, without its ending."""
        return Path(self.path).stem

    @property
    def folder(self) -> str:
        """The folder of the main file; "" where the name has none."""
        return os.path.dirname(self.path)

    @cached_property
    def ladder_texts(self) -> Mapping[str, str]:
        """The text of each ladder file, by its path in the output folder."""
        return {path: ladder_csv(rungs) for path, rungs in self.ladders.items()}

    @cached_property
    def by_address(self) -> Mapping[Address, Row]:
        """The rows of the table by their addresses."""
        return {row.address: row for row in self.rows}

    @cached_property
    def names(self) -> Names:
        """Every nickname."""
        return Names({row.address: row.nickname for row in self.rows if row.nickname})

    @cached_property
    def uses(self) -> RungUses:
        """Every use of an address."""
        return RungUses(self.routines)
