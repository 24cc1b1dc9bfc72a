"""Rungs as people draw them in CLICK, through the whole import: what a person would write, verified."""

from __future__ import annotations

from pathlib import Path

import pytest
from drawn_rungs import END, RETURN, SHAPES, first_rung, imported, rung
from test_importing_cases import check_same, compared, ladder_text

import clickgen
from clickgen.commands.import_.project import Target, import_project

SPLIT = (
    "a box with inputs between coils",
    "two boxes with inputs",
    "a box with inputs and a coil that it reads",
)
"""CLICK wants all inputs of a box on one branch (C000A), so a build makes several rungs of these, and import too.

The last one needs scratch bits, and stays as it is drawn.
"""


HANGING = ("a hanging wire", "a chain of T", "empty rows between circuits", "an empty row behind")
"""The judge takes no wires that hang in the air, and no rows without anything."""


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_is_written_as_a_person_would(name: str, tmp_path: Path) -> None:
    drawing, expected = SHAPES[name]
    rows = [*rung(*drawing), END]
    result = imported(tmp_path, {"main": rows, "Sub": [RETURN]})
    source = result.files[tmp_path / "prog.py"].decode()
    assert first_rung(source) == expected
    codes = {problem.code for problem in result.diagnostics}
    assert codes - {"CG705"} == ({"CG704"} if name in SPLIT else set())
    if name == SPLIT[-1]:
        return
    result.write()
    before = {"main.csv": ladder_text(rows), "subroutines/Sub.csv": ladder_text([RETURN])}
    built = clickgen.build(tmp_path / "prog.py", frozen=True)
    assert built.ok, built.diagnostics
    built.write(tmp_path / "again")
    second = import_project(tmp_path / "again", Target(tmp_path / "second" / "prog.py"))
    assert second.files[tmp_path / "second" / "prog.py"].decode() == source
    if name not in (*HANGING, *SPLIT) and "NOP" not in name:
        for pair in compared(before, {file: built.files[file] for file in before}):
            check_same(pair)


@pytest.mark.parametrize("name", SPLIT)
def test_a_rung_that_becomes_several_is_the_same(name: str, tmp_path: Path) -> None:
    """Without ``frozen``: the parts may need scratch bits. The second import has the parts."""
    result = imported(tmp_path, {"main": [*rung(*SHAPES[name][0]), END]})
    assert result.verdict is not None
    assert len(result.verdict.redrawn) == 1
    result.write()
    built = clickgen.build(tmp_path / "prog.py")
    assert built.ok, built.diagnostics
    assert len(built.routines[0].rungs) > 2
    built.write(tmp_path / "again")
    second = import_project(tmp_path / "again", Target(tmp_path / "second" / "prog.py"))
    assert second.ok
    assert second.verdict is not None
    assert (second.verdict.verified, second.verdict.redrawn) == (second.rungs, [])


def test_the_last_output_reads_what_the_first_wrote_before_the_rung(tmp_path: Path) -> None:
    """All conditions of a rung are looked at before its first output runs: a split needs a scratch bit for that."""
    name = "a box with inputs and a coil that it reads"
    imported(tmp_path, {"main": [*rung(*SHAPES[name][0]), END]}).write()
    built = clickgen.build(tmp_path / "prog.py")
    assert built.scratch_rows
    scratch = {str(row.address) for row in built.scratch_rows}
    lines = built.files["main.csv"].splitlines()
    coil = next(index for index, line in enumerate(lines) if line.endswith("out(C1)"))
    assert any(line.endswith(f"out({bit})") for line in lines[:coil] for bit in scratch)
    assert not any(",C1," in line for line in lines[coil + 1 :])
