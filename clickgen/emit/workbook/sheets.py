"""The sheets of the workbook, in their order.

Each sheet is a function from the project to rows, in a file of its own. ``book.py`` writes them, and ``looks.py``
defines their looks.
"""

from __future__ import annotations

from clickgen.emit.built import BuiltProgram
from clickgen.emit.workbook.cross_reference import cross_reference
from clickgen.emit.workbook.memory import memory
from clickgen.emit.workbook.memory_map import memory_map
from clickgen.emit.workbook.overview import overview
from clickgen.emit.workbook.points import inputs_and_outputs
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.rungs import rungs
from clickgen.emit.workbook.scratch import scratch
from clickgen.emit.workbook.sheet import Sheet
from clickgen.emit.workbook.stretches import stretches
from clickgen.emit.workbook.tags import tags
from clickgen.emit.workbook.timers import timers_and_counters

_SHEETS = (
    inputs_and_outputs,
    tags,
    cross_reference,
    timers_and_counters,
    memory,
    stretches,
    memory_map,
    scratch,
    rungs,
)


def sheets(project: Project) -> tuple[Sheet, ...]:
    """Return every sheet in its order."""
    others = tuple(sheet(project) for sheet in _SHEETS)
    return (overview(project, others), *others)


def workbook(built: BuiltProgram) -> bytes:
    """Return the workbook: the same program gives the same bytes."""
    from clickgen.emit.workbook.book import to_bytes

    return to_bytes(sheets(Project(built)), built.name)
