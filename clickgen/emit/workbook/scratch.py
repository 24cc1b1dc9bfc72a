"""The sheet of the cells that clickgen needs for itself."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.emit.workbook.project import Project, or_none
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet
from clickgen.table.rows import is_scratch

_NONE = "The program needs no scratch cells."


def scratch(project: Project) -> Sheet:
    return Sheet(
        "Scratch",
        "Cells that clickgen needs for itself, and what for. Leave them alone: nothing else may write them.",
        (
            Column("Cell", 10),
            Column("Name", 20),
            Column("Reason", 80, wraps=True),
            Column("Written in", 28, wraps=True),
            Column("Read in", 28, wraps=True),
        ),
        or_none(_rows(project), _NONE),
    )


def _rows(project: Project) -> Iterator[Cells]:
    needed = {row.address for row in project.built.scratch}
    rows = {row.address: row for row in (*filter(is_scratch, project.built.rows), *project.built.scratch)}
    for address in sorted(rows, key=lambda address: address.sort_key):
        row = rows[address]
        texts = (str(address), row.nickname, row.comment)
        if address in needed:
            written, read = project.built.uses.writes(address), project.built.uses.reads(address)
            yield *texts, project.places(written), project.places(read)
        else:
            yield tuple(Marked(text, Look.FAINT) for text in (*texts, "not needed now", ""))
