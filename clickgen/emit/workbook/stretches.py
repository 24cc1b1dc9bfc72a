"""The sheet of memory in stretches of consecutive cells of one state."""

from __future__ import annotations

from clickgen.emit.workbook.memory import pointers
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Marked, Sheet
from clickgen.emit.workbook.states import GIVEN, State, Stretch


def stretches(project: Project) -> Sheet:
    remarks = pointers(project)
    return Sheet(
        "Memory stretches",
        "Cells of one state in a row. Filter for free and sort by count to find room.",
        (
            Column("Bank", 8),
            Column("From", 12),
            Column("To", 12),
            Column("Count", 9),
            Column("State", 20),
            Column("Remarks", 60, wraps=True),
        ),
        (
            _stretch(stretch, "; ".join(remarks.get(bank.name, ())))
            for bank in GIVEN
            for stretch in project.states.stretches(bank)
        ),
    )


def _stretch(stretch: Stretch, pointers: str) -> Cells:
    words = Marked(stretch.state.words, stretch.state.look)
    remark = pointers if stretch.state in (State.FREE, State.BLOCK) else ""
    return stretch.first.bank, str(stretch.first), str(stretch.last), stretch.length, words, remark
