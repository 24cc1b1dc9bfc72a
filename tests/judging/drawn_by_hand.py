"""Rungs drawn by hand, for the tests of the judges."""

from __future__ import annotations

import csv
import io

from judges.power import (
    CONDITION_COLUMNS,
    HEADER,
)

Line = tuple[str, str]


COPY = "copy(1,DS1)"


CTD = "count_down(CT1,CTD1,preset=5)"


DRUM = "event_drum(outputs=[Y001],events=[C5],pattern=[[1]],current_step=DS1,completion_flag=C9)"


SEND = (
    'send(target=ModbusTcpTarget(name="tcp",ip="192.168.1.10",port=502,device_id=1),remote_start="DS1",'
    "source=DS1,sending=C1,success=C2,error=C3,exception_response=DS100)"
)


def csv_rows(*lines: Line) -> list[list[str]]:
    """One rung from (cells separated by spaces, AF); ``.`` is a blank, and a row with an AF is wired up to it."""
    rows = []
    for number, (drawn, af) in enumerate(lines):
        cells = ["" if cell == "." else cell for cell in drawn.split()]
        cells += ["-" if af else ""] * (CONDITION_COLUMNS - len(cells))
        rows.append(["" if number else "R", *cells, af])
    return rows


def csv_text(*rows: list[str]) -> str:
    out = io.StringIO(newline="")
    csv.writer(out, lineterminator="\n").writerows([list(HEADER), *rows])
    return out.getvalue()


def draw(*lines: Line, comment: tuple[str, ...] = ()) -> str:
    return csv_text(*(["#", text] for text in comment), *csv_rows(*lines))
