"""The sheet of the inputs and outputs, slot by slot, with the points that are free."""

from __future__ import annotations

from collections.abc import Iterator

from clickgen.device.banks import BANKS, Address, points_of
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Look, Marked, Sheet
from clickgen.emit.workbook.states import State

_NUMBERS = ((0, False), (0, True), *((number, False) for number in range(1, BANKS["XD"].last + 1)))
_WORDS = tuple(Address(bank, number, upper) for bank in ("XD", "YD") for number, upper in _NUMBERS)
"""Each word holds the points of one slot, inputs before outputs."""


def inputs_and_outputs(project: Project) -> Sheet:
    return Sheet(
        "Inputs and outputs",
        "X and Y in the slots of 16 points that CLICK numbers together. A slot that nothing speaks of is one line.",
        (
            Column("Slot", 13),
            Column("Word", 7),
            Column("Terminal", 13),
            Column("Nickname", 27),
            Column("Comment", 50, wraps=True),
            Column("State", 20),
            Column("Written in", 28, wraps=True),
            Column("Read in", 28, wraps=True),
        ),
        (row for word in _WORDS for row in _slot(project, word)),
    )


def _slot(project: Project, word: Address) -> Iterator[Cells]:
    points, built = points_of(word), project.built
    slot = f"{points[0]}-{points[-1]}"
    states = {project.states.at(point) for point in points}
    if states in ({State.FREE}, {State.RESERVED}):
        what = f"{states.pop().words}: {len(points)} points"
        yield tuple(Marked(text, Look.FAINT) for text in (slot, str(word), slot, "", "", what))
        return
    for point in points:
        state = project.states.at(point)
        look = Look.FAINT if state is State.FREE else Look.PLAIN
        written, read = (project.places(uses) for uses in (built.uses.writes(point), built.uses.reads(point)))
        nickname, comment = built.names.nickname(point), project.text_of(point) or project.spare_word(point)
        texts = (slot, str(word), str(point), nickname, comment, state.words, written, read)
        yield tuple(Marked(text, look) for text in texts)
