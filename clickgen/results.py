"""The results of the pipeline: those of a build, of a check, and of a look for names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from clickgen.device.banks import Address
from clickgen.dialects.base import Dialect
from clickgen.emit.built import BuiltProgram
from clickgen.emit.delivery import Delivery, TableChange, deliver
from clickgen.facts.facts import Facts
from clickgen.facts.left_names import Left
from clickgen.lower.split import ClickRoutine
from clickgen.problems.diagnostics import Diagnostic
from clickgen.table.address_table import AddressTable
from clickgen.table.blocks import Block
from clickgen.table.rows import Row
from clickgen.text.source import SourceFile
from clickgen.workspace import CouldNotRun


@dataclass(frozen=True)
class BuildResult:
    """The result of a build, in memory.

    ``files`` maps each output's path inside the output folder (``main.csv``, ``subroutines/auto.csv``) to its text; a
    text is made on request. It is empty if there are errors.
    """

    program: Path
    sources: tuple[SourceFile, ...]
    """The program files as they were read."""
    diagnostics: tuple[Diagnostic, ...]
    files: Mapping[str, str]
    built: BuiltProgram
    """The source of the outputs; without routines and rows if there are errors."""
    new_rows: tuple[Row, ...]
    """The addresses that clickgen chose in this build, scratch included."""
    facts: Facts | None
    """The program without names, as far as it could be read."""
    table_path: Path
    address_table: AddressTable
    """The table as it should be after the build."""
    table_before: bytes | None
    """The file as it was read; None where there was none."""
    dialect: Dialect
    """The one that the program is written in."""
    left: tuple[Left, ...] = ()
    """The names that left the program while others came."""

    @property
    def routines(self) -> tuple[ClickRoutine, ...]:
        """The program in CLICK rungs; empty if there are errors."""
        return self.built.routines

    @property
    def rows(self) -> tuple[Row, ...]:
        """Every row of the address table as it should be after the build; empty if there are errors."""
        return self.built.rows

    @property
    def scratch_rows(self) -> tuple[Row, ...]:
        """Those of ``rows`` that clickgen needs for itself in this program."""
        return self.built.scratch

    @property
    def table(self) -> bytes:
        """The file of the address table as it should be after the build."""
        return self.address_table.to_bytes()

    @property
    def ok(self) -> bool:
        """True if there is no error."""
        return not any(problem.is_error for problem in self.diagnostics)

    @cached_property
    def needed(self) -> frozenset[Address]:
        """The addresses that the program declares, marks as blocks, or that clickgen needs for itself in it."""
        declared = self.facts.program if self.facts else None
        addresses = [row.address for row in self.scratch_rows]
        addresses += [each.cell.address for each in declared.declarations] if declared else []
        addresses += [address for block in declared.blocks for address in block.range.addresses()] if declared else []
        return frozenset(addresses)

    @property
    def placed_rows(self) -> tuple[Row, ...]:
        """The names that clickgen placed in this build."""
        return tuple(row for row in self.new_rows if row not in self.scratch_rows)

    @property
    def main(self) -> ClickRoutine:
        """The main program in CLICK rungs; only when ``ok``."""
        return next(routine for routine in self.routines if routine.is_main)

    @property
    def subroutines(self) -> tuple[ClickRoutine, ...]:
        """The subroutines in CLICK rungs."""
        return tuple(routine for routine in self.routines if not routine.is_main)

    def write(self, folder: Path) -> list[Path]:
        """Put the outputs into ``folder`` and the extended address table in its place: all of it or none.

        Removes the files of an earlier build that this one does not make. Returns the paths that really changed. Raises
        CouldNotRun if files that are not clickgen's are in the way in the folder; OSError if something cannot
        be written; ChangedMeanwhile if the table changed since it was read.
        """
        return write_all([(self, folder)])

    def delivery(self, folder: Path) -> Delivery:
        """Return the files to put in place. Raises CouldNotRun for a program with errors."""
        if not self.ok:
            raise CouldNotRun("a program with errors is not written")
        if self.address_table.base and self.table_before is None and not self.address_table.own_rows:
            return Delivery(folder, self.files, None)  # The workbook lacks nothing.
        left = {each.new.address: each.old.address for each in self.left}
        return Delivery(
            folder, self.files, TableChange(self.table_path, self.table_before, self.table, self.placed_rows, left)
        )


def write_all(results: Sequence[tuple[BuildResult, Path]]) -> list[Path]:
    """Write several results, each into its folder, as ``BuildResult.write`` does: all of them or none.

    If programs share an address table, each must have been built with the table that the one before it made.
    """
    return deliver([result.delivery(folder) for result, folder in results])


@dataclass(frozen=True)
class CheckResult:
    """The problems of a program: those of a build, and those that the rules about logic find."""

    program: Path
    sources: tuple[SourceFile, ...]
    diagnostics: tuple[Diagnostic, ...]
    reads: Mapping[str, bytes | None]
    """The files that were read, by path; None for a missing one. The same bytes give the same result."""


@dataclass(frozen=True)
class KnownNames:
    """Every name that a program can use: those of the address table, and those that it declares or would give."""

    rows: tuple[Row, ...]
    blocks: tuple[Block, ...]
    diagnostics: tuple[Diagnostic, ...]
    table_path: Path
    table: bytes
    """The address table with the names of the program, if these agree with it."""
