"""What a program is built with beside its own text."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from clickgen.device.banks import Address
from clickgen.table.layers import is_workbook

TABLE_NAME = "nicknames.csv"
"""The address table beside a program, when none is named."""


@dataclass(frozen=True)
class Settings:
    """What a program is built with beside its own text.

    ``nicknames`` names the address table; None is ``nicknames.csv`` beside the program. A workbook that it names is
    only read: what it lacks stands in ``nicknames.csv`` beside the program. ``table_must_exist`` refuses one that is
    not there. ``frozen`` forbids choosing addresses; ``reserved`` are never chosen. ``overlay`` gives files
    contents other than those on disk, by real path. ``wants`` says of a code whether a check should look for it.
    ``named_elsewhere`` are the names, in small letters, and the addresses that other programs of the table use.
    """

    nicknames: str | os.PathLike[str] | None = None
    table_must_exist: bool = False
    frozen: bool = False
    reserved: tuple[Address, ...] = ()
    overlay: Mapping[str, bytes] = field(default_factory=dict)
    wants: Callable[[str], bool] = field(default=lambda _: True)
    is_part: bool = False
    named_elsewhere: frozenset[str] = frozenset()

    @property
    def workbook(self) -> Path | None:
        """The workbook that is named in the place of an address table."""
        named = Path(self.nicknames) if self.nicknames is not None else None
        return named if named is not None and is_workbook(named) else None

    def table_of(self, program: Path) -> Path:
        """The address table that new names of a program go into."""
        if self.nicknames is None or self.workbook is not None:
            return program.parent / TABLE_NAME
        return Path(self.nicknames)
