"""Bundles, captures and program files to read."""

from __future__ import annotations

import csv
import io
import os
import re
from collections.abc import Sequence
from pathlib import Path

import pytest
from judges.power import HEADER

from clickgen.click.read.grid import DrawnRung, Square
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.project import Project, read_project
from clickgen.workspace import CouldNotRun

WIDTH = 31


SPAN = re.compile(r"Span\([^)]*\)")


END = [["-"] * WIDTH + ["end()"]]


RETURN = [["-"] * WIDTH + ["return()"]]


NICKNAMES = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\nC1,BIT,Start,0,0,\n"


Rung = tuple[str, list[list[str]]]


def row(*cells: str, out: str = "") -> list[str]:
    """One row, its wire continued to the output."""
    return [*cells, *(["-" if out else ""] * (WIDTH - len(cells))), out]


def sets(bit: str, by: str = "X001") -> list[list[str]]:
    return [row(by, out=f"out({bit})")]


def calls(*names: str) -> list[Rung]:
    return [("", [row(out=f'call("{name}")')]) for name in names]


EITHER: list[list[str]] = [row("X001", "T", out="out(C1)"), row("~X002", "-")]


MAIN: list[Rung] = [("Start\n  either way", EITHER), *calls("Heat"), ("", END)]


HEAT: list[Rung] = [("", sets("C2")), ("Back", RETURN)]


def ladder(rungs: Sequence[Rung], marker: str = "R") -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for comment, rows in rungs:
        writer.writerows(("#", line) for line in comment.split("\n") if comment)
        writer.writerows([(marker if not index else "", *cells) for index, cells in enumerate(rows)])
    return text.getvalue()


def put(folder: Path, files: dict[str, str | bytes]) -> Path:
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)
    return folder


def every_problem(found: Project) -> list[LadderProblem]:
    return [*found.problems, *(one for routine in found.routines for rung in routine.rungs for one in rung.problems)]


def whole(path: Path) -> Project:
    found = read_project(path)
    assert not every_problem(found), list(map(str, every_problem(found)))
    return found


def names(found: Project) -> list[str]:
    return [routine.name for routine in found.routines]


def messages(path: Path) -> list[str]:
    """The messages, with places relative to the folder."""
    folder = path if path.is_dir() else path.parent
    return [str(problem).replace(f"{folder}{os.sep}", "") for problem in every_problem(read_project(path))]


def shape(rungs: Sequence[DrawnRung]) -> list[object]:
    """The rungs without their places."""
    rows = [[(*map(drawn, line.squares), line.output) for line in rung.rows] for rung in rungs]
    return [(rung.number, rung.comment, rung.boxes, row) for rung, row in zip(rungs, rows, strict=True)]


def drawn(square: Square) -> tuple[bool, bool, str]:
    return square.right, square.down, SPAN.sub("", repr(square.contact))


def refused(path: Path) -> str:
    with pytest.raises(CouldNotRun) as caught:
        read_project(path)
    return str(caught.value)
