"""Contacts up to the last column: laddercodec reads back the drawing, however the condition is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from judges.codec import assert_codec_reads

import clickgen
from clickgen.commands.import_.project import Target, import_project

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


# -- however a rung is written, it is drawn alike ----------------------------------------------------------------------

BODIES = {
    "a coil": "out(y[1])",
    "two coils": "out(y[1])\nout(y[2])",
    "a loop": "for _ in range(3):\n    if True:\n        calc('ds[1] + 1', ds[1])",
    "an open loop": "for _ in range(3): pass",
    "an end": "end()",
    "a copy": "copy(1, ds[1])",
    "a timer": "ton(t[1], 5)",
    "a retentive timer": "rton(t[1], 5, reset=lambda: x[1])",
    "an off-delay": "rtof(t[1], 5, reset=lambda: x[1])",
    "a counter": "ctud(ct[1], 5, count_down=lambda: x[2], reset=lambda: x[1])",
    "a drum": BOXES[4],
    "a shift register": "shift(c[101:105], clock=lambda: x[2], reset=lambda: x[1])",
    "a coil and a counter": "out(y[1])\nctu(ct[1], 5, reset=lambda: x[1])",
    "a loop that its own rung stops": "set(c[1])\nfor _ in range(3):\n    if True:\n        calc('ds[1] + 1', ds[1])",
    "a counter that its own rung stops": "reset(c[30])\nctu(ct[1], 5, reset=lambda: x[1])",
}


def _spellings(count: int) -> list[list[str]]:
    """The same series of contacts as the conditions of nested ifs."""
    middle, whole = count // 2, f"all({_bits(1, count)})"
    return [
        [whole],
        [f"all({_bits(1, middle)})", f"all({_bits(middle + 1, count)})"],
        ["c[1]", f"all({_bits(2, 20)})", f"all({_bits(21, count)})"],
        ["True", whole],
        [f"all(all({_bits(1, middle)}), all({_bits(middle + 1, count)}))"],
        [f"c[1:{count + 1}]"],
        [f"all({_bits(1, 5)}, c[6:{count}], c[{count}])"],
    ]


def _nested(conditions: list[str], body: str) -> str:
    lines = ["def main():"]
    for depth, condition in enumerate(conditions, 1):
        lines.append(f"{'    ' * depth}if {condition}:")
    lines += ["    " * (len(conditions) + 1) + line for line in body.splitlines()]
    closing = ["    if True:", "        next_loop()"] if body.endswith(": pass") else []
    return "\n".join([*lines, *closing, "    if True:", "        end()", ""])


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("count", [30, 31, 32, 61])
def test_nested_ifs_and_a_series_are_one_rung(tmp_path: Path, body: str, count: int) -> None:
    drawn = set()
    for conditions in _spellings(count):
        (tmp_path / "nicknames.csv").unlink(missing_ok=True)
        (tmp_path / "wide.py").write_text(_nested(conditions, BODIES[body]))
        result = clickgen.build(tmp_path / "wide.py")
        assert result.ok, result.diagnostics
        drawn.add(result.files["main.csv"])
    assert len(drawn) == 1
    assert_codec_reads(*drawn)


@pytest.mark.parametrize("body", ["a coil", "a loop", "an open loop", "an end"])
def test_31_contacts_before_one_row_need_no_scratch_bit_and_come_back(tmp_path: Path, body: str) -> None:
    (tmp_path / "wide.py").write_text(_nested([f"all({_bits(1, 31)})"], BODIES[body]))
    result = clickgen.build(tmp_path / "wide.py")
    assert not result.scratch_rows
    result.write(tmp_path / "built")
    back = import_project(tmp_path / "built", Target(tmp_path / "back" / "prog.py"))
    assert not [problem for problem in back.diagnostics if problem.code == "CG704"]
