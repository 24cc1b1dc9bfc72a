"""The value of a part of a formula without running it, including numbers that are too large."""

from __future__ import annotations

from pathlib import Path

import pytest

from clickgen.api import check
from clickgen.problems.codes import CODES

BIG = " * ".join(["2147483647"] * 60)


@pytest.mark.parametrize(
    ("formula", "codes"),
    [
        ("SQRT(1 - 2)", ["CG553"]),
        ("SQRT(3 MOD 2 - 1)", []),
        ("LN(3 MOD 3)", ["CG553"]),
        ("ASIN(PI)", ["CG553"]),
        ("ACOS(RAD(180) / 4)", []),
        ("ACOS(DEG(1))", ["CG553"]),
        (f"SQRT(-({BIG}) * 1.5)", []),
        (f"SQRT(1.5 * ({BIG}) * ({'1e38 * ' * 5}1e38))", []),
        ("1 / (0 * 5)", ["CG517"]),
        ("2 ^ 0.5 + (0 - 2) ^ 2", []),
        ("(0 - 2) ^ 0.5", ["CG553"]),
        ("(1 - 1) ^ (0 - 1)", ["CG553"]),
    ],
)
def test_a_constant_part_is_worked_out(formula: str, codes: list[str], tmp_path: Path) -> None:
    program = tmp_path / "prog.py"
    program.write_text(f'def main():\n    if True:\n        calc("{formula}", df[1])\n        end()\n', "utf-8")
    found = [problem.code for problem in check(program).diagnostics]
    assert [code for code in found if CODES[code].is_on] == codes
