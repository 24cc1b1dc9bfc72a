"""Texts that run past TXT1000, past their block or over another name: reported if it can happen, and only then."""

from __future__ import annotations

from pathlib import Path

import pytest

import clickgen

TOO_FAR = ("CG430", "CG431")
NAMES = """nickname(txt.Msg, txt[11:16])
nickname(txt.Mode, txt[16])
nickname(txt.Alone, txt[31])
nickname(txt.Next, txt[33])
"""


def said(rungs: str, folder: Path) -> list[str]:
    program = folder / "prog.py"
    program.write_text(f"{NAMES}\n\ndef main():\n{rungs}    if True:\n        end()\n")
    (folder / "nicknames.csv").unlink(missing_ok=True)
    result = clickgen.build(program)
    assert result.ok, result.diagnostics
    return [problem.code for problem in result.diagnostics if problem.code in TOO_FAR]


def always(action: str) -> str:
    return f"    if c[1]:\n        {action}\n"


@pytest.mark.parametrize(
    ("action", "codes"),
    [
        ("copy(ds[1], txt[998])", ["CG430"]),
        ("copy(ds[1], txt[995])", []),
        ("copy(td[1], txt[996])", ["CG430"]),
        ("copy(dd[1], txt[991])", ["CG430"]),
        ("copy(dh[1], txt[997])", []),
        ("copy(df[1], txt[987])", ["CG430"]),
        ("copy(5, txt[1000])", []),
        ("copy(50, txt[1000])", ["CG430"]),
        ("copy(ds[ds[3]], txt[999])", ["CG430"]),
        ("copy(txt[5], txt[1000])", []),
        ("copy(ds[1], txt[1000], options=to_binary)", []),
        ("copy(dd[1], txt.Msg[0])", ["CG431"]),
        ("copy(dh[1], txt.Msg[1])", []),
        ("copy(dh[1], txt.Msg[2])", ["CG431"]),
        ("copy(dd[1], txt.Msg[0], options=to_binary)", []),
        ("copy(ds[1], txt.Alone)", ["CG431"]),
        ("copy(10, txt.Alone)", []),
    ],
)
def test_a_number_that_goes_to_text(action: str, codes: list[str], tmp_path: Path) -> None:
    assert said(always(action), tmp_path) == codes


@pytest.mark.parametrize(
    ("rungs", "codes"),
    [
        (always('copy("FINISHED", txt[ds[1]])'), ["CG430"]),
        (always('copy("F", txt[ds[1]])'), []),
        (always('copy("$0D", txt[ds[1]])'), []),
        (always("copy(ds[2], txt[ds[1]], options=to_text())"), ["CG430"]),
        (always("copy(ds[2], txt[ds[1]], options=to_binary)"), []),
        (always("copy(ds[2], txt[ds[1]])"), ["CG430"]),
        ('    if ds[1] <= 993:\n        copy("FINISHED", txt[ds[1]])\n', []),
        # Only constants: each is looked at.
        (always("copy(100, ds[1])") + always('copy("FINISHED", txt[ds[1]])'), []),
        (always("copy(995, ds[1])") + always('copy("FINISHED", txt[ds[1]])'), ["CG430"]),
        (always("copy(12, ds[1])") + always('copy("FINISHED", txt[ds[1]])'), ["CG431"]),
        (always("copy(30, ds[1])") + always('copy("FINISHED", txt[ds[1]])'), ["CG431"]),
        (always("copy(30, ds[1])") + '    if ds[1] < 20:\n        copy("FINISHED", txt[ds[1]])\n', []),
        # Somewhere the program looks how far the pointer has come.
        (
            always('calc("ds[1] + 8", ds[1])')
            + "    if ds[1] > 900:\n        copy(101, ds[1])\n"
            + always('copy("FINISHED", txt[ds[1]])'),
            [],
        ),
        (always('calc("ds[1] + 8", ds[1])') + always('copy("FINISHED", txt[ds[1]])'), ["CG430"]),
    ],
)
def test_a_text_through_a_pointer(rungs: str, codes: list[str], tmp_path: Path) -> None:
    assert said(rungs, tmp_path) == codes
