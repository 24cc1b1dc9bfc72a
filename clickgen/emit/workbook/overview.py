"""The first sheet: the project, and the contents of the other sheets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet
from clickgen.emit.workbook.states import GIVEN, State
from clickgen.text.wording import counted

_ADVICE = (
    "clickgen makes this workbook from the program and the address table. It does not write over one that somebody has "
    "saved: save it under another name before you write notes into it."
)


def overview(project: Project, others: Sequence[Sheet]) -> Sheet:
    return Sheet(
        "Project",
        "What the project is, and what the other sheets hold.",
        (Column("CLICK program", 34, wraps=True), Column(project.built.name, 100, wraps=True)),
        _rows(project, others),
        has_filter=False,
    )


def _rows(project: Project, others: Sequence[Sheet]) -> Iterator[Cells]:
    yield from _counts(project)
    yield from _part("Sheet", "What it holds")
    for sheet in others:
        yield sheet.name, sheet.about
    yield from _part("State of a cell", "Meaning")
    for state in State:
        name = f"{state.letter} {state.words}".strip()
        yield Marked(name, state.look), state.meaning
    yield from _part("This workbook", "")
    yield None, _ADVICE


def _part(*titles: str) -> Iterator[Cells]:
    yield ()
    yield tuple(Marked(title, Look.TITLE) for title in titles)


def _counts(project: Project) -> Iterator[Cells]:
    for routine in project.built.routines:
        rows = sum(len(rung.grid) for rung in routine.rungs)
        yield routine.name, f"{counted(len(routine.rungs), 'rung')}, {counted(rows, 'row')}"
    yield "Tags", sum(not row.is_default for row in project.built.rows)
    if project.built.new:
        yield "not in the address table yet", f"{project.built.new}: clickgen build writes them into it"
    for bank in GIVEN:
        states = project.states.count(bank)
        taken = states[State.USED] + states[State.SCRATCH]
        if taken:
            yield f"{bank.name}, {bank.title}", f"{taken} in use, {states[State.FREE]} free"
