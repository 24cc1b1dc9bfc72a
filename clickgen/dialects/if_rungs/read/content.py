"""What one program file holds, as the reader gives it."""

from __future__ import annotations

from dataclasses import dataclass

from clickgen.ir.imports import Import
from clickgen.ir.program import BlockDeclaration, Declaration, Routine
from clickgen.ir.proposals import Proposal


@dataclass(frozen=True)
class FileContent:
    """What one file holds at its top level, in the order of its text."""

    path: str
    items: tuple[Routine | Declaration | BlockDeclaration | Import, ...]
    proposals: tuple[Proposal, ...] = ()
    """The fixes of what is wrong in its routines."""
    is_declared: bool = True
    """False when what it declares or imports could not be read."""
