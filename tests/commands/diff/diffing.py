"""Programs, bundles and repositories to compare, for the tests of ``clickgen diff``."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import pytest
from hypothesis import strategies as st
from strategies.meaning import meaning_programs
from strategies.one_rung import power_programs
from test_importing_cases import ladder_text, wired

from clickgen.cli import main
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.click.read.project import DrawnRoutine
from clickgen.commands.diff.changes import Difference
from clickgen.commands.diff.sides import Side
from clickgen.commands.diff.words import Wording
from clickgen.device.banks import parse_address
from clickgen.emit.rung_words import Names
from clickgen.ir.conditions import Contact
from clickgen.table.address_table import AddressTable
from clickgen.table.rows import default_row, scratch_name

RUNGS = [
    "    # Start and stop\n    if all(c.Start, nc(c.EStop)):\n        set(c.Running)\n",
    "    if c.Running:\n        out(y[1])\n",
    "    # How many\n    if re(c.Running):\n        copy(ds.Count, ds.Shown)\n",
    "    if c.Running:\n        ton(t.Delay, 5, unit=Ts)\n",
]


END = "    if True:\n        end()\n"


SUB = "\n\n@sub\ndef wash():\n    if c.Wash:\n        out(c.Valve)\n\n    if True:\n        return\n"


TABLE = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"


class Said(NamedTuple):
    code: int
    out: str
    err: str

    @property
    def lines(self) -> list[str]:
        """The lines between the names of the sides and the summary."""
        return [line for line in self.out.split("\n")[3:] if line]


Run = Callable[..., Said]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run ``clickgen diff`` with these arguments in a folder of its own."""
    monkeypatch.chdir(tmp_path)

    def run_diff(*arguments: str) -> Said:
        try:
            code = main(["diff", *arguments])
        except SystemExit as stop:
            code = int(str(stop.code))
        said = capsys.readouterr()
        return Said(code, said.out, said.err)

    return run_diff


def program(*rungs: str, sub: str = "", top: str = "") -> str:
    return f"{top}def main():\n" + "\n".join([*rungs, END]) + sub


def write(name: str, text: str) -> None:
    path = Path(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


def build(name: str, folder: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", name, "-o", folder]) == 0
    capsys.readouterr()


@pytest.fixture
def bundle(run: Run, capsys: pytest.CaptureFixture[str]) -> str:
    """Write prog.py and its build."""
    del run  # Only its folder is needed.
    write("prog.py", program(*RUNGS, sub=SUB))
    build("prog.py", "plc", capsys)
    return "plc"


Drawing = Sequence[tuple[str, str]]
"""Rows of a rung: contacts, ``.`` for a blank square; and the output."""


END_RUNG: Drawing = [("-", "end()")]


def plant(*drawings: Drawing) -> dict[str, list[DrawnRung]]:
    """A main with these rungs and an end."""
    rows = [wired(*row, "" if n else "R") for drawing in (*drawings, END_RUNG) for n, row in enumerate(drawing)]
    return {"main": list(read_ladder(ladder_text(rows), "main.csv").rungs)}


def write_plant(folder: str, *drawings: Drawing) -> None:
    rows = [wired(*row, "" if n else "R") for drawing in (*drawings, END_RUNG) for n, row in enumerate(drawing)]
    write(f"{folder}/main.csv", ladder_text(rows))


def with_scratch(rungs: dict[str, list[DrawnRung]], *addresses: str, reason: str = "condition of main rung 9") -> Side:
    """A side in which clickgen uses these addresses for itself."""
    found = [parse_address(address) for address in addresses]
    rows = [default_row(address, scratch_name(address), reason) for address in found if address]
    return replace(side(rungs), table=AddressTable.empty("nicknames.csv").extended(rows))


def git(*words: str) -> str:
    if not shutil.which("git"):
        pytest.skip("there is no git")
    who = ["-c", "user.name=Test", "-c", "user.email=test@example.org", "-c", "commit.gpgsign=false"]
    done = subprocess.run(["git", *who, *words], capture_output=True, encoding="utf-8", check=True)
    return done.stdout.strip()


def side(files: dict[str, list[DrawnRung]]) -> Side:
    return Side("a", tuple(DrawnRoutine(name, name == "main", tuple(rungs), name) for name, rungs in files.items()))


def happened(difference: Difference) -> list[tuple[str, str, int]]:
    """The change to each rung; for an added one its new number."""
    found = []
    for routine in difference.routines:
        for change in routine.changes:
            rung = change.one or change.other
            assert rung
            found.append((change.kind, routine.name, rung.number))
    return found


programs = st.one_of(power_programs(), meaning_programs())


def words(rung: DrawnRung) -> tuple[str, ...]:
    return Wording(Names({}), Names({})).rung("", 1, rung).lines


def negated(rung: DrawnRung) -> DrawnRung:
    """The rung with its first contact negated."""
    rows = list(rung.rows)
    for index, row in enumerate(rows):
        for column, square in enumerate(row.squares):
            if isinstance(square.contact, Contact) and not square.contact.edge:
                contact = replace(square.contact, negated=not square.contact.negated)
                squares = [*row.squares]
                squares[column] = replace(square, contact=contact)
                rows[index] = replace(row, squares=tuple(squares))
                return replace(rung, rows=tuple(rows))
    return rung
