"""Every golden ladder, imported and built again, is the same ladder: outputs, power, comments, and cell by cell."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import golden
import pytest
from judges.builds import ladder_files
from judges.codec import comments_agree, normalise
from judges.power import HEADER, LadderRung, Row, condition_tokens, power_sets, read_ladder, situations
from test_ladder_tokens import TOKENS

from clickgen.click.read.grid import read_ladder as read_drawn
from clickgen.click.read.rungs import ImportedRung, import_rung, routine_of
from clickgen.dialects.if_rungs.write.functions import function_name
from clickgen.dialects.if_rungs.write.routine import write_source


@dataclass(frozen=True)
class Compared:
    """A rung of the source beside the one built from its import."""

    before: LadderRung
    after: LadderRung

    @property
    def is_identical(self) -> bool:
        return [row.cells for row in self.before.rows] == [row.cells for row in self.after.rows]


def routine_name(file: str) -> str:
    return "main" if file.startswith("main") else file.removeprefix("subroutines/").removesuffix(".csv")


def imported(files: Mapping[str, str]) -> dict[str, list[ImportedRung]]:
    """The rungs of each routine; the parts of main one after the other."""
    found: dict[str, list[ImportedRung]] = {}
    for file, text in files.items():
        ladder = read_drawn(text, file)
        assert not ladder.all_problems, ladder.all_problems
        found.setdefault(routine_name(file), []).extend(map(import_rung, ladder.rungs))
    return found


def source_of(files: Mapping[str, str]) -> str:
    routines = []
    functions = {"main": "main"}
    for name, rungs in imported(files).items():
        functions.setdefault(name, function_name(name, functions.values()))
        routines.append(routine_of(name, [one.rung for one in rungs], name == "main", functions[name]))
    return write_source(routines)


def drawn(files: Mapping[str, str]) -> dict[str, list[LadderRung]]:
    found: dict[str, list[LadderRung]] = {}
    for file in sorted(files, key=lambda name: (routine_name(name), name)):
        found.setdefault(routine_name(file), []).extend(read_ladder(files[file]))
    return found


def compared(before: Mapping[str, str], after: Mapping[str, str]) -> list[Compared]:
    one, other = drawn(before), drawn(after)
    assert {name: len(rungs) for name, rungs in one.items()} == {name: len(rungs) for name, rungs in other.items()}
    return [Compared(*pair) for name in one for pair in zip(one[name], other[name], strict=True)]


def check_same(pair: Compared) -> None:
    """Check for the same outputs and inputs in the same order, power in the same situations, and the same comment."""
    sides = [_in_one_spelling(rung) for rung in (pair.before, pair.after)]
    shown = [[(out.token, [pin.token for pin in out.pins]) for out in side.outputs()] for side in sides]
    assert shown[0] == shown[1]
    leaves = dict.fromkeys(token for side in sides for token in condition_tokens(side) if token != "SC1")
    sets, full = situations(list(leaves))
    sets["SC1"] = full
    assert power_sets(sides[0], sets, full) == power_sets(sides[1], sets, full), f"line {pair.before.written[0].line}"
    if any(pair.before.comment):
        plain = [tuple(line.rstrip() for line in rung.comment) for rung in (pair.before, pair.after)]
        assert comments_agree(*plain)
        assert plain[0] == plain[1]


def _in_one_spelling(rung: LadderRung) -> LadderRung:
    rows = tuple(Row(tuple(map(normalise, row.cells)), normalise(row.af), row.line) for row in rung.rows)
    return LadderRung(rung.comment, rung.written, rows, rung.found)


def round_trip(files: Mapping[str, str]) -> list[Compared]:
    """Import and build, and import and build again: the same source. Every rung must be the same."""
    source = source_of(files)
    built = ladder_files({"prog.py": source})
    assert source_of(built) == source, "a second import gives another source"
    pairs = compared(files, built)
    for pair in pairs:
        check_same(pair)
    return pairs


def ladder_text(rows: Iterable[Iterable[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([HEADER, *rows])
    return text.getvalue()


def wired(contacts: str, output: str, marker: str = "") -> list[str]:
    """A row of contacts, wired to its output if it has one; ``.`` is a blank square."""
    cells = ["" if cell == "." else cell for cell in contacts.split()]
    rest = 31 - len(cells)
    return [marker, *cells, *["-" if output else ""] * rest, output]


CASE_NAMES = golden.names()


def golden_ladders(name: str) -> dict[str, str]:
    files = golden.expected(golden.CASES / name)
    return {
        file: data.decode()
        for file, data in files.items()
        if file.startswith(("main", "subroutines/")) and file.endswith(".csv")
    }


@pytest.mark.parametrize("name", CASE_NAMES)
def test_a_golden_ladder_comes_back_cell_by_cell(name: str) -> None:
    pairs = round_trip(golden_ladders(name))
    assert pairs
    for pair in pairs:
        assert pair.is_identical, f"rung at line {pair.before.written[0].line} is drawn otherwise"


@pytest.mark.skipif(not TOKENS.exists(), reason="the list of known tokens is not beside the project")
def test_every_known_token_comes_back_cell_by_cell() -> None:
    """Each example alone; loops, returns and calls with what they need around them."""
    with TOKENS.open(encoding="utf-8", newline="") as file:
        records = list(csv.reader(file))[1:]
    examples: dict[str, list[list[str]]] = {}
    for name, contacts, output in records:
        place, _, marker = name.partition(":")
        examples.setdefault(place, []).append(wired(contacts, output, "" if marker == "+" else "R"))
    ends = {"main.csv": wired("", "end()", "R"), "subroutines/coverage_sub.csv": wired("", "return()", "R")}
    for name, rows in examples.items():
        place = "subroutines/coverage_sub.csv" if name.startswith("return") else "main.csv"
        files = {file: [*(rows if file == place else []), end] for file, end in ends.items()}
        pairs = round_trip({file: ladder_text(content) for file, content in files.items()})
        assert all(pair.is_identical for pair in pairs), name
