"""Whole projects: built into a folder and imported again they come back unchanged, or are refused.

The first half builds random programs with nicknames and titles, imports the folder and builds the result. The
second half damages the import's build before the comparison, and asks the judge of power whether that matters.
"""

from __future__ import annotations

import csv
import io
import random
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st
from judges import power
from strategies.meaning import meaning_programs
from strategies.one_rung import power_programs
from strategies.programs import PROGRAM, Program
from strategies.shown import ShownAsText
from test_importing_cases import check_same, compared, drawn, ladder_text
from test_importing_properties import ruff_changes

import clickgen
from clickgen.commands.import_.project import ImportResult, Target, import_project
from clickgen.config import Settings
from clickgen.dialects.if_rungs.write import files, routine
from clickgen.dialects.if_rungs.write.routine import write_source
from clickgen.results import BuildResult
from clickgen.table.rows import is_scratch

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment"
TABLE = "nicknames.csv"
NAMED = {
    "X001": "BIT",
    "X002": "BIT",
    "Y001": "BIT",
    "C1": "BIT",
    "C2": "BIT",
    "C3": "BIT",
    "T11": "BIT",
    "CT13": "BIT",
    "DS1": "INT",
    "DS2": "INT",
    "DS3": "INT",
    "DD1": "INT2",
    "DH1": "HEX",
    "TXT1": "TEXT",
}
"""Addresses that the programs use, in the order of the table."""
NAMES = (
    "Start",
    "Motor On",
    "for",
    "True",
    "any",
    "ds",
    "out",
    "immediate",
    "X003",
    "C2",
    "2nd",
    "5h",
    "other",
    "main",
    "Step_1",
    "SUMMIT",
    "T11",
    "as_text",
    "A_name_of_24_characters_",
)
TITLES = (
    "Auto Mode",
    "2nd-Line",
    "out",
    "class",
    "Ds",
    "Other 2",
    "fuenf_und_24_Zeichen_lan",
    "auto_mode",
    "con2",
    "_",
)


@dataclass(frozen=True)
class Plant(ShownAsText):
    """A program, the nicknames of its addresses, and CLICK's names for its subroutines."""

    program: Program
    nicknames: Mapping[str, str]
    titles: Mapping[str, str]

    @property
    def texts(self) -> dict[str, str]:
        found = {}
        for file, text in self.program.texts.items():
            for function, title in self.titles.items():
                text = text.replace(f"@sub\ndef {function}():", f'@sub("{title}")\ndef {function}():')
            found[file] = text
        return found

    @property
    def table(self) -> str:
        """The address table; "" without any nickname."""
        rows = [f'{one},{kind},"{self.nicknames[one]}",,,""' for one, kind in NAMED.items() if one in self.nicknames]
        return "\n".join([HEADER, *map(_with_defaults, rows), ""]) if rows else ""

    @property
    def text(self) -> str:
        parts = [*self.texts.items(), (TABLE, self.table)]
        return "".join(f"# ---- {file}\n{text}\n" for file, text in parts)


def _with_defaults(row: str) -> str:
    kind = row.split(",")[1]
    initial = {"HEX": "0000", "TEXT": ""}.get(kind, "0")
    retentive = "No" if kind == "BIT" and not row.startswith("CT") else "Yes"
    return row.replace(",,,", f",{initial},{retentive},")


@st.composite
def plants(draw: st.DrawFn) -> Plant:
    program = draw(st.one_of(power_programs(), meaning_programs()))
    addresses = draw(st.lists(st.sampled_from(list(NAMED)), unique=True, max_size=len(NAMED)))
    names = draw(st.permutations(NAMES))
    functions = [name for name, _ in program.subroutines if draw(st.booleans())]
    titles = draw(st.lists(st.sampled_from(TITLES), unique=True, min_size=len(functions), max_size=len(functions)))
    return Plant(program, dict(zip(addresses, names, strict=False)), dict(zip(functions, titles, strict=True)))


def bundle_of(plant: Plant, folder: Path) -> BuildResult:
    """Build a program into ``bundle``; it must build."""
    folder.mkdir()
    for name, text in plant.texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    if plant.table:
        (folder / TABLE).write_text(plant.table, encoding="utf-8")
    result = clickgen.build(folder / PROGRAM)
    assert result.ok, "\n".join(f"{one.code} {one.span}: {one.message}" for one in result.diagnostics)
    result.write(folder / "bundle")
    return result


def ladders(result: BuildResult) -> dict[str, str]:
    return {name: text for name, text in result.files.items() if name.startswith(("main", "subroutines/"))}


def names_in(data: bytes) -> dict[str, str]:
    """The nicknames of a table by their addresses."""
    rows = csv.DictReader(io.StringIO(data.decode("utf-8")))
    return {row["Address"]: row["Nickname"] for row in rows if row["Nickname"]}


def sources_of(result: ImportResult) -> dict[str, str]:
    return {path.name: data.decode() for path, data in result.files.items() if path.suffix == ".py"}


def imported(bundle: Path, place: Path) -> ImportResult:
    """Import into a folder, or into one file; everything must be verified, and drawn as it was."""
    is_folder = place.suffix != ".py"
    result = import_project(bundle, Target(place / "main.py" if is_folder else place, is_folder))
    assert result.ok, [(problem.code, problem.message) for problem in result.diagnostics]
    assert result.verdict is not None
    assert result.verdict.verified == result.rungs
    assert result.verdict.redrawn == []
    return result


def check_comes_back(plant: Plant) -> None:
    """With nicknames and without, into one file and into several: the same ladder, the same names, the same text."""
    with tempfile.TemporaryDirectory(prefix="clickgen-import-") as name:
        folder = Path(name)
        first = bundle_of(plant, folder / "program")
        bundle = folder / "program" / "bundle"
        names = {str(row.address): row.nickname for row in first.rows if row.nickname and not is_scratch(row)}
        if TABLE in first.files:
            check_place(bundle, folder / "named" / "prog.py", ladders(first), names)
            check_place(bundle, folder / "several", ladders(first), names)
            (bundle / TABLE).unlink()
        check_place(bundle, folder / "plain.py", ladders(first), {})


def check_place(bundle: Path, place: Path, before: Mapping[str, str], names: Mapping[str, str]) -> None:
    result = imported(bundle, place)
    result.write()
    built = clickgen.build(result.target.program, frozen=True)
    assert built.ok, built.diagnostics
    assert ladders(built) == before
    assert {str(row.address): row.nickname for row in built.rows if row.nickname} == names
    assert names_in(built.table) == names
    texts = sources_of(result)
    for text in texts.values():
        assert ruff_changes(text) == ""
    again = place.with_name(f"again-{place.name}")
    built.write(again.with_suffix(".bundle"))
    assert sources_of(imported(again.with_suffix(".bundle"), again)) == {
        again.name if file == place.name else file: text for file, text in texts.items()
    }


@given(plants())
@examples(2)
def test_a_project_comes_back(plant: Plant) -> None:
    check_comes_back(plant)


# -- what does not come back ------------------------------------------------------------------------------------------

Rows = list[list[str]]
Damage = Callable[[random.Random, Rows], None]
"""Changes rows of a ladder file."""


def _row(chance: random.Random, rows: Sequence[list[str]]) -> list[str]:
    return chance.choice([row for row in rows if row[0] != "#"])


def _other_square(chance: random.Random, rows: Rows) -> None:
    """Another contact or wire in a square that is not blank, mostly; or something in a blank one."""
    row = _row(chance, rows)
    columns = [column for column in range(1, 32) if row[column] not in ("", "-")] or [*range(1, 32)]
    column = chance.choice(columns if chance.random() < 0.7 else range(1, 32))
    cell = row[column]
    plain = cell.removeprefix("T:")
    changed = ["", "-", "T", "|", "X009", "rise(X009)", "DS9==1", f"T:{plain}", plain, f"~{plain}", plain.lstrip("~")]
    changed += [other[column] for other in rows if other[0] != "#"]
    row[column] = chance.choice([one for one in changed if one != cell] or ["X009"])


def _other_output(chance: random.Random, rows: Rows) -> None:
    row = chance.choice([row for row in rows if row[0] != "#" and row[-1]])
    token = row[-1]
    digits = [index for index, character in enumerate(token) if character.isdigit()]
    changed = ["", "NOP", "out(C9)", "out(C9,oneshot=1)", token.replace(",oneshot=1", "")]
    changed += [token.replace("out(", "latch("), token.replace("unit=Tms", "unit=Ts"), token.replace("..", "...")]
    changed += [other[-1] for other in rows if other[0] != "#"]
    for index in digits:
        changed.append(f"{token[:index]}{(int(token[index]) + 1) % 10}{token[index + 1 :]}")
    row[-1] = chance.choice([one for one in changed if one != token] or [""])


def _swapped_rows(chance: random.Random, rows: Rows) -> None:
    index = chance.randrange(len(rows))
    other = chance.randrange(len(rows))
    rows[index], rows[other] = rows[other], rows[index]


def _row_gone(chance: random.Random, rows: Rows) -> None:
    del rows[chance.randrange(len(rows))]


def _row_twice(chance: random.Random, rows: Rows) -> None:
    index = chance.randrange(len(rows))
    rows.insert(index, list(rows[index]))


def _comment_put_in(chance: random.Random, rows: Rows) -> None:
    index = chance.choice([index for index, row in enumerate(rows) if row[0].startswith("R")])
    rows.insert(index, ["#", "somebody else's"])


DAMAGES: tuple[Damage, ...] = (
    *(_other_square,) * 4,
    *(_other_output,) * 3,
    _swapped_rows,
    _row_gone,
    _row_twice,
    _comment_put_in,
)


def damaged(text: str, damage: Damage, chance: random.Random) -> str:
    [header, *rows] = list(csv.reader(io.StringIO(text)))
    damage(chance, rows)
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([header, *rows])
    return out.getvalue()


MUTATIONS: tuple[tuple[str, str], ...] = (
    ("any(", "all("),
    ("all(", "any("),
    ("nc(", "re("),
    ("re(", "fe("),
    (", oneshot=True", ""),
    ("[1]", "[2]"),
    ("[2]", "[1]"),
    ("x[", "c["),
    ("==", "!="),
    ("<", ">"),
    ("out(", "set("),
    (" 2)", " 3)"),
    ("reset=lambda: ", "reset=lambda: nc(x[8]) if 0 else "),
    ("setpoint=2", "setpoint=1"),
    ("if True:", "if x[9]:"),
    ("    # ", "    # not "),
    ("1", "2"),
    ("c.", "x."),
)


def mutated(text: str, chance: random.Random) -> str:
    """The source with one place of it changed."""
    possible = [pair for pair in MUTATIONS if pair[0] in text]
    if not possible:
        return text
    old, new = chance.choice(possible)
    at = chance.choice([index for index in range(len(text)) if text.startswith(old, index)])
    return text[:at] + new + text[at + len(old) :]


def _without_its_rules(comment: tuple[str, ...], written: tuple[power.Row, ...]) -> power.LadderRung:
    """A rung as the judge reads it, whether or not a person may draw it so: loose wires do nothing."""
    return power.LadderRung(comment, written, *power._expand(written))


def counts(files: Mapping[str, str]) -> dict[str, int]:
    """How many rungs each routine has."""
    return {name: len(rungs) for name, rungs in drawn(files).items()}


def is_same(before: Mapping[str, str], after: Mapping[str, str]) -> bool:
    """The judge's verdict. A drawing that it cannot read is different."""
    try:
        with patch.object(power, "_finish", _without_its_rules):
            if before.keys() != after.keys():
                return False
            for pair in compared(before, after):
                check_same(pair)
                if pair.before.comment != pair.after.comment:
                    return False
    except AssertionError:
        return False
    return True


@dataclass
class _Built:
    """The first build of the import, as it was compared."""

    chance: random.Random
    damages: bool
    files: Mapping[str, str] | None = None
    count: int = 0

    def build(self, *arguments: Any, **others: Any) -> BuildResult:
        result = clickgen.build(*arguments, **others)
        self.count += 1
        if self.count > 1:
            return result
        if result.ok and self.damages:
            name = self.chance.choice(sorted(ladders(result)))
            text = damaged(result.files[name], self.chance.choice(DAMAGES), self.chance)
            result = replace(result, files={**result.files, name: text})
        self.files = ladders(result) if result.ok else None
        return result


def check_refuses(plant: Plant, seed: int, damages: bool) -> None:
    """A build that differs from the drawing is refused, unless the judge finds it the same."""
    chance = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="clickgen-import-") as name:
        folder = Path(name)
        first = bundle_of(plant, folder / "program")
        built = _Built(chance, damages)
        state = chance.getrandbits(32)
        write = write_source

        def write_otherwise(*arguments: Any) -> str:
            text = write(*arguments)
            return text if built.count else mutated(text, random.Random(state))

        writer = write if damages else write_otherwise
        with (
            patch("clickgen.api.build", built.build),
            patch.object(routine, "write_source", writer),
            patch.object(files, "write_source", writer),
        ):
            result = import_project(
                folder / "program" / "bundle", Target(folder / "new" / "prog.py", settings=Settings())
            )
        codes = {problem.code for problem in result.diagnostics if problem.is_error}
        if built.files is None:
            assert codes, "a build refuses it, and nothing is said"
        elif not damages and not codes and counts(ladders(first)) != counts(built.files):
            # A rung that became several, which the judge does not read as one: test_comparing_properties runs such.
            assert result.verdict is not None
            assert result.verdict.redrawn or built.count > 1
        elif not is_same(ladders(first), built.files):
            assert codes, "the judge says that it is another ladder, and it was verified"
            assert not damages or codes & {"CG702", "CG703"}
        assert result.ok or not result.files


@given(plants(), st.integers(0, 2**32))
@examples(3)
def test_a_build_that_differs_is_refused(plant: Plant, seed: int) -> None:
    check_refuses(plant, seed, True)


@given(plants(), st.integers(0, 2**32))
@examples(3)
def test_a_source_that_says_something_else_is_refused(plant: Plant, seed: int) -> None:
    check_refuses(plant, seed, False)


GONE: Mapping[str, Callable[[str], str]] = {
    "the last rung is missing": lambda text: "\n".join([*text.splitlines()[:-1], ""]),
    "a rung stands behind the last": lambda text: f"{text}{text.splitlines()[-1]}\n",
    "there are no rungs": lambda text: f"{text.splitlines()[0]}\n",
    "the file is empty": lambda _: "",
}


@pytest.mark.parametrize("file", ["main.csv", "subroutines/Sub.csv"])
@pytest.mark.parametrize("name", GONE)
def test_rungs_too_many_or_too_few_are_refused(name: str, file: str, tmp_path: Path) -> None:
    """Each routine is compared as a whole: anything that a build adds or leaves out belongs to some rung."""
    (tmp_path / "bundle" / "subroutines").mkdir(parents=True)
    rung = ["R", "X001", *["-"] * 30, "out(C1)"]
    for one, last in (("main.csv", "end()"), ("subroutines/Sub.csv", "return()")):
        (tmp_path / "bundle" / one).write_text(ladder_text([rung, ["R", *["-"] * 31, last]]))

    def build_otherwise(*arguments: Any, **others: Any) -> BuildResult:
        result = clickgen.build(*arguments, **others)
        return replace(result, files={**result.files, file: GONE[name](result.files[file])})

    with patch("clickgen.api.build", build_otherwise):
        result = import_project(tmp_path / "bundle", Target(tmp_path / "prog.py"))
    assert "CG703" in {problem.code for problem in result.diagnostics}
    assert not result.files


# -- any drawing ------------------------------------------------------------------------------------------------------

OUTPUTS: tuple[tuple[str, ...], ...] = (
    ("out(C{})",),
    ("out(C{})",),
    ("latch(C{})",),
    ("copy(DS1,DS{})",),
    ("math(DS1 + 1,DS{},mode=decimal)",),
    ("NOP",),
    ("on_delay(T{0},TD{0},preset=5,unit=Ts)", ".reset()"),
    ("count_up(CT{0},CTD{0},preset=5)", ".down()", ".reset()"),
)
SQUARES = (
    *("-",) * 6,
    *("T",) * 4,
    "|",
    "",
    "",
    "X001",
    "~X002",
    "T:X003",
    "T:C20",
    "rise(X004)",
    "T:~X001",
    "DS20==1",
)


@st.composite
def drawings(draw: st.DrawFn) -> Rows:
    """A rung of any contacts and wires in its first columns, and of outputs in some rows."""
    rows: Rows = []
    number = 30
    width = draw(st.integers(1, 6))
    for _ in range(draw(st.integers(1, 6))):
        group = draw(st.sampled_from((("",), *OUTPUTS)))
        number += 1
        for output in group:
            squares = [draw(st.sampled_from(SQUARES)) for _ in range(width)]
            squares[0] = squares[0].removeprefix("T:").replace("T", "-").replace("|", "")
            rows.append(["", *squares, *["-" if output else ""] * (31 - width), output.format(number)])
    rows[0][0] = "R"
    return _without_loose_ends(rows)


def _without_loose_ends(rows: Rows) -> Rows:
    """The rung without contacts and wires that lead from or to nothing, in the written rows."""
    cells = [row[1:-1] for row in rows]
    fed = power.flow(cells, lambda _: 1, 1)
    useful = power._useful(cells, {index for index, row in enumerate(rows) if row[-1]})
    for index, row in enumerate(rows):
        for column, cell in enumerate(row[1:-1]):
            if power.goes_right(cell) and not (fed[index][column] and useful[index][column + 1]):
                row[column + 1] = "|" if power.goes_down(cell) else ""
    # A wire continues through blank squares (click-facts [grid.blank-wires]), which the judge wants to see.
    for above, row in pairwise(rows[:-1]):
        for column in range(2, 32):
            if power.goes_down(above[column]) and not row[column] and not power.goes_right(row[column - 1]):
                row[column] = "|"
    return rows


def looked_at(rows: Rows) -> bool:
    """Check that a kept drawing has, when built, the power that the judge finds in it; return whether it was looked at.

    A rung that becomes several is not: the judge knows one rung at a time.
    """
    tokens = [row[-1] for row in rows if row[-1] and row[-1] != "NOP"]
    end = ["R", *["-"] * 31, "end()"]
    with tempfile.TemporaryDirectory(prefix="clickgen-import-") as name:
        folder = Path(name)
        (folder / "plant.csv").write_text(ladder_text([*rows, end]))
        result = import_project(folder / "plant.csv", Target(folder / "prog.py"))
        if not result.ok:
            assert not result.files
            return False
        assert result.verdict is not None
        assert result.verdict.verified == 2
        result.write()
        built = clickgen.build(folder / "prog.py")
        assert built.ok
        is_split = len(built.routines[0].rungs) > 2
        if not is_split:
            again = sources_of(import_again(built, folder))
            # A bare wire into a box with inputs gets a contact that is always on (click-facts [grid.pin-contact]).
            is_bare = any("sc._Always_ON" in text for text in again.values())
            assert is_bare or again == sources_of(result)
    if not tokens or is_split:
        return False
    before = [[*row[:-1], ""] if row[-1] == "NOP" else row for row in rows]
    assert is_same({"main.csv": ladder_text([*before, end])}, {"main.csv": built.files["main.csv"]}), ladder_text(rows)
    return True


def import_again(built: BuildResult, folder: Path) -> ImportResult:
    built.write(folder / "bundle")
    return import_project(folder / "bundle", Target(folder / "second" / "prog.py"))


def check_drawing(rows: Rows) -> None:
    looked_at(rows)


@given(drawings())
@examples(20)
def test_what_is_kept_of_any_drawing_does_the_same(rows: Rows) -> None:
    check_drawing(rows)
