"""An operand that its instruction does not take has one finding, and the other rules keep quiet about it."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_examples import program_of

import clickgen

DRUM = "event_drum(outputs={}, events=[c[1], c[2]], pattern=[[1, 0], [0, 1]], current_step=ds[1], completion_flag=c[3])"


def said(action: str, folder: Path) -> list[str]:
    program = folder / "prog.py"
    program.write_text(program_of(f"if x[1]:\n    {action}\n"), "utf-8")
    return [problem.code for problem in clickgen.build(program).diagnostics if problem.code != "CG418"]


@pytest.mark.parametrize(
    ("outputs", "codes"),
    [
        ("y[1:3]", []),
        # No drum takes SC; some of it can be written, some cannot, and what comes first counts for the slice.
        ("sc[50:52]", ["CG301"]),
        ("sc[51:53]", ["CG301"]),
        ("sc[52:54]", ["CG304"]),
        ("[sc[51], sc[52]]", ["CG301", "CG304"]),
    ],
)
def test_the_cells_of_a_slice_are_refused_once(outputs: str, codes: list[str], tmp_path: Path) -> None:
    assert said(f"{DRUM.format(outputs)}.reset(c[4])", tmp_path) == codes


@pytest.mark.parametrize(
    ("action", "codes"),
    [
        ("copy(ds[1], xd[0])", ["CG304"]),
        ("copy(x[1].immediate, dh[1])", ["CG308"]),
        ("copy_block(ds[ds[2]], txt[1])", ["CG307"]),
        ("search(ds[1:9] >= c[1], result=ds[20], found=c[2])", ["CG301"]),
    ],
)
def test_a_copy_or_search_says_nothing_more_about_what_is_refused(
    action: str, codes: list[str], tmp_path: Path
) -> None:
    assert said(action, tmp_path) == codes
