"""Contacts up to the last column: laddercodec reads back what is drawn, however the condition is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from judges.codec import assert_codec_reads

import clickgen

BOXES = {
    1: "out(y[1])",
    2: "copy(1, ds[1])",
    3: "ctu(ct[1], 5, reset=lambda: x[1])",
    4: "time_drum([y[1]], [5], Ts, [[1]], ds[1], td[1], c[91], reset=lambda: x[1])",
}
"""An instruction of each height in rows; those of three and four have inputs."""
OTHERS = (
    "ton(t[1], 5)",
    "rton(t[1], 5, reset=lambda: x[1])",
    "search(ds[1:5] == 3, result=ds[9], found=c[95])",
    'receive(ModbusTcpTarget(ip="10.0.0.2"), "DS1", ds[1:6])',
    "shift(c[101:105], clock=lambda: x[2], reset=lambda: x[1])",
)
WAYS = {
    "one series": "if all({}):\n        {}",
    "nested": "if all({0}):\n        if all({1}):\n            {2}",
    "a range": "if c[1:{}]:\n        {}",
    "an any in it": "if all({}, any(c[71], c[72])):\n        {}",
    "a branch": "if all({0}):\n        set(c[8])\n        if all({1}):\n            {2}\n        set(c[9])",
}


def _bits(first: int, last: int) -> str:
    return ", ".join(f"c[{number}]" for number in range(first, last + 1))


def _rung(way: str, count: int, action: str) -> str:
    if way == "a range":
        return WAYS[way].format(count + 1, action)
    if way == "one series":
        return WAYS[way].format(_bits(1, count), action)
    if way == "an any in it":
        return WAYS[way].format(_bits(1, count - 1), action)
    return WAYS[way].format(_bits(1, count // 2), _bits(count // 2 + 1, count), action)


@pytest.mark.parametrize(
    ("action", "way", "count"),
    [
        *((action, way, count) for action in BOXES.values() for way in WAYS for count in (30, 31)),
        *((action, "nested", 31) for action in OTHERS),
        *((BOXES[2], "one series", count) for count in (29, 32)),
    ],
)
def test_a_wide_rung_is_read_back(tmp_path: Path, action: str, way: str, count: int) -> None:
    (tmp_path / "wide.py").write_text(f"def main():\n    {_rung(way, count, action)}\n    if True:\n        end()\n")
    result = clickgen.build(tmp_path / "wide.py")
    assert result.ok, result.diagnostics
    assert_codec_reads(result.files["main.csv"])
    if way in ("one series", "nested", "a range"):
        is_box = action != BOXES[1]
        assert bool(result.scratch_rows) is (count > (30 if is_box else 31))
