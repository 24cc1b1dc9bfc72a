"""The example program of the language's specification builds unchanged; skipped if the specification is missing."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from judges.codec import assert_codec_reads
from judges.power import check_limits, check_no_backfeed, read_ladder
from pyclickplc import read_csv

import clickgen

SPECIFICATION = Path(__file__).parents[3] / "shared" / "spec" / "click-plc-dsl-v1.1.md"

pytestmark = pytest.mark.skipif(not SPECIFICATION.is_file(), reason="the specification is not beside the project")


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """The last Python block of the specification, in a folder of its own."""
    blocks = re.findall(r"^```python\n(.*?)^```", SPECIFICATION.read_text("utf-8"), re.DOTALL | re.MULTILINE)
    path = tmp_path / "prog.py"
    path.write_text(blocks[-1], "utf-8")
    return path


def test_it_builds_without_errors(program: Path) -> None:
    result = clickgen.build(program)
    assert result.ok, result.diagnostics
    # Inputs and outputs without an address, and a counter without a reset.
    assert {problem.code for problem in result.diagnostics} == {"CG210", "CG418"}


def test_a_retentive_timer_and_a_second_counter_get_rungs_of_their_own(program: Path) -> None:
    source_rungs = re.findall(r"^(?:def main|    if )", program.read_text("utf-8").partition("@sub")[0], re.MULTILINE)
    assert len(source_rungs) - 1 == 17
    result = clickgen.build(program)
    assert len(result.main.rungs) == 19
    assert [(routine.name, len(routine.rungs)) for routine in result.subroutines] == [("auto_mode", 3)]


def test_outside_readers_take_it(program: Path, tmp_path: Path) -> None:
    result = clickgen.build(program)
    result.write(tmp_path / "out")
    for name in ("main.csv", "subroutines/auto_mode.csv"):
        text = (tmp_path / "out" / name).read_bytes().decode()
        rungs = read_ladder(text)
        check_limits(rungs)
        for rung in rungs:
            check_no_backfeed(rung)
        assert_codec_reads(text)
    records = read_csv(tmp_path / "out" / "nicknames.csv")
    assert records.tag["SystemRunning"].display_address.startswith("C")
    assert len(records) == sum(1 for row in result.new_rows if row.nickname)


def test_a_second_build_changes_nothing(program: Path, tmp_path: Path) -> None:
    first = clickgen.build(program)
    first.write(tmp_path / "out")
    again = clickgen.build(program, frozen=True)
    assert (again.files, again.table, again.new_rows) == (first.files, first.table, ())
