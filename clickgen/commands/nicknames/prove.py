"""Builds programs before and after a rename, and compares all their outputs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from clickgen.api import build
from clickgen.commands.nicknames.programs import Program
from clickgen.device.banks import Address
from clickgen.emit.registry import Outputs
from clickgen.lower.scratch import renamed_reason
from clickgen.problems.diagnostics import Diagnostic
from clickgen.results import BuildResult
from clickgen.table.blocks import renamed_mark
from clickgen.table.rows import Row, is_scratch
from clickgen.workspace import CouldNotRun, Workspace


@dataclass(frozen=True)
class Side:
    """The files of one side; ``tables`` are tables read in place of others, by the real paths of those."""

    workspace: Workspace
    tables: Mapping[str, Path]

    def build(self, program: Program) -> BuildResult:
        table = self.tables.get(program.table_key, program.settings.nicknames)
        settings = program.settings._replace(nicknames=table)
        return build(program.path, settings=settings, workspace=self.workspace.apart())


def errors_of(result: BuildResult) -> list[Diagnostic]:
    return [problem for problem in result.diagnostics if problem.is_error]


def prove_same(before: BuildResult, after: BuildResult, old: str, new: str, is_block: bool = False) -> None:
    """Raise CouldNotRun unless both make the same ladder, and differ elsewhere only in the name."""

    def renamed(row: Row) -> Row:
        if is_block:
            return replace(row, comment=renamed_mark(row.comment, old, new))
        if is_scratch(row):
            return replace(row, comment=renamed_reason(row.comment, old, new))
        return replace(row, nickname=new) if row.nickname.lower() == old.lower() else row

    rows = _by_address(map(renamed, before.rows))
    scratch = tuple(map(renamed, before.scratch_rows))
    expected = Outputs(replace(before.built, rows=tuple(rows.values()), scratch=scratch))
    found = _by_address(after.rows)
    differing = [name for name in {**expected, **after.files} if expected.get(name) != after.files.get(name)]
    if {address: row.content for address, row in rows.items()} != {a: row.content for a, row in found.items()}:
        differing.append(str(before.table_path))
    if differing:
        raise CouldNotRun(f"{before.program} would not stay the same with {new}: {differing[0]} would differ")


def _by_address(rows: Iterable[Row]) -> dict[Address, Row]:
    return {row.address: row for row in rows}
