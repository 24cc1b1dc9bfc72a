"""The judges are right on hand-drawn rungs, and they can fail."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product

import pytest
from drawn_by_hand import COPY, CTD, DRUM, SEND, Line, csv_rows, csv_text, draw
from hypothesis import given
from hypothesis import strategies as st
from judges.codec import assert_codec_reads, ladder_of_codec_rung, power_of_codec_rung
from judges.power import (
    CONDITION_COLUMNS,
    HEADER,
    LadderRung,
    Output,
    Row,
    Terminal,
    check_limits,
    check_no_backfeed,
    condition_tokens,
    flow,
    power,
    read_ladder,
    situations,
    truth_table,
)

Values = Mapping[str, bool]


Formula = Callable[[Values], bool]


TON = "on_delay(T1,TD1,preset=5,unit=Ts)"


CTU = "count_up(CT1,CTD1,preset=5)"


def rung_of(*lines: Line) -> LadderRung:
    (rung,) = read_ladder(draw(*lines))
    return rung


# Ways to wire a rung, with what each must mean (click-facts [grid.outputs, grid.power, grid.shared-tie, grid.wires]).
PATTERNS: dict[str, tuple[list[Line], dict[tuple[int, str], Formula]]] = {
    "series": (
        [("C1 ~C2 rise(C3) DS1==5", "out(Y001)")],
        {(0, ""): lambda v: v["C1"] and not v["C2"] and v["rise(C3)"] and v["DS1==5"]},
    ),
    "or-at-the-rail": ([("C1 T", "out(Y001)"), ("C2", "")], {(0, ""): lambda v: v["C1"] or v["C2"]}),
    "or-at-the-rail-three-ways": (
        [("C1 T", "out(Y001)"), ("C2 |", ""), ("C3", "")],
        {(0, ""): lambda v: v["C1"] or v["C2"] or v["C3"]},
    ),
    "or-at-the-rail-into-a-contact": (
        [("C1 T:C4", "out(Y001)"), ("C2 |", ""), ("C3", "")],
        {(0, ""): lambda v: (v["C1"] or v["C2"] or v["C3"]) and v["C4"]},
    ),
    "or-in-mid-rung": (
        [("X001 T:X002 T", "out(Y001)"), (". C1", "")],
        {(0, ""): lambda v: v["X001"] and (v["X002"] or v["C1"])},
    ),
    "or-in-mid-rung-three-ways": (
        [("X001 T:X002 T C9", "out(Y001)"), (". T:C1 |", ""), (". ~C2", "")],
        {(0, ""): lambda v: v["X001"] and (v["X002"] or v["C1"] or not v["C2"]) and v["C9"]},
    ),
    "two-ors-in-series": (
        [("X001 T T:C1 T", "out(Y001)"), ("X002 . C2", "")],
        {(0, ""): lambda v: (v["X001"] or v["X002"]) and (v["C1"] or v["C2"])},
    ),
    "series-inside-an-or": (
        [("X001 C1 T", "out(Y001)"), ("X002 -", "")],
        {(0, ""): lambda v: (v["X001"] and v["C1"]) or v["X002"]},
    ),
    "several-outputs": (
        [("C1 T", "out(Y001)"), (". T", "latch(Y002)"), (". -", "reset(Y003)")],
        {(n, ""): lambda v: v["C1"] for n in range(3)},
    ),
    "several-tall-outputs": (
        [("C1 T", COPY), (". T", SEND), (". -", COPY)],
        {(n, ""): lambda v: v["C1"] for n in range(3)},
    ),
    "branch": (
        [("C1 T", "out(Y001)"), (". C2", "out(Y002)")],
        {(0, ""): lambda v: v["C1"], (1, ""): lambda v: v["C1"] and v["C2"]},
    ),
    "branch-that-is-not-last": (
        [("C1 T", "out(Y001)"), (". T:C2", "out(Y002)"), (". -", "out(Y003)")],
        {(0, ""): lambda v: v["C1"], (1, ""): lambda v: v["C1"] and v["C2"], (2, ""): lambda v: v["C1"]},
    ),
    "branch-with-two-outputs": (
        [("C1 T", "out(Y001)"), (". T:C2 T", COPY), (". | -", "out(Y003)"), (". -", "out(Y004)")],
        {
            (0, ""): lambda v: v["C1"],
            (1, ""): lambda v: v["C1"] and v["C2"],
            (2, ""): lambda v: v["C1"] and v["C2"],
            (3, ""): lambda v: v["C1"],
        },
    ),
    "or-and-several-outputs-share-a-column": (
        [("rise(C1) T", COPY), ("fall(C1) |", ""), (". T", "copy(C1,C2)"), (". -", 'call("x")')],
        {(n, ""): lambda v: v["rise(C1)"] or v["fall(C1)"] for n in range(3)},
    ),
    "or-leg-beside-an-output": (
        [("C1 T", "out(Y001)"), ("C2 -", "out(Y002)")],
        {(n, ""): lambda v: v["C1"] or v["C2"] for n in range(2)},
    ),
    "or-into-a-pinned-box-above-it": (
        [("C1 |", ""), ("C2 -", TON), ("C3", ".reset()")],
        {(0, ""): lambda v: v["C1"] or v["C2"], (0, ".reset()"): lambda v: v["C3"]},
    ),
    "or-into-a-counter-above-it": (
        [("C1 |", ""), ("C2 |", ""), ("C3 -", CTU), ("~C4", ".reset()")],
        {(0, ""): lambda v: v["C1"] or v["C2"] or v["C3"], (0, ".reset()"): lambda v: not v["C4"]},
    ),
    "or-into-a-down-counter-above-it": (
        [("C1 |", ""), ("C2 -", CTD), ("C3", ".reset()")],
        {(0, ""): lambda v: v["C1"] or v["C2"], (0, ".reset()"): lambda v: v["C3"]},
    ),
    "or-in-the-last-pin": (
        [("C3", TON), ("C4 T", ".reset()"), ("C5", "")],
        {(0, ""): lambda v: v["C3"], (0, ".reset()"): lambda v: v["C4"] or v["C5"]},
    ),
    "or-in-the-last-pin-of-a-counter": (
        [("C1", CTU), ("C2", ".down()"), ("C3 T", ".reset()"), ("C4 |", ""), ("C5", "")],
        {
            (0, ""): lambda v: v["C1"],
            (0, ".down()"): lambda v: v["C2"],
            (0, ".reset()"): lambda v: v["C3"] or v["C4"] or v["C5"],
        },
    ),
    "or-in-the-last-pin-of-a-shift": (
        [("C1", "shift(C11..C18)"), ("C2", ".clock()"), ("C3 T", ".reset()"), ("C4", "")],
        {
            (0, ""): lambda v: v["C1"],
            (0, ".clock()"): lambda v: v["C2"],
            (0, ".reset()"): lambda v: v["C3"] or v["C4"],
        },
    ),
    "or-in-the-last-pin-of-a-drum": (
        [("C1", DRUM), ("C2", ".reset()"), ("C3", ".jump(DS2)"), ("C4 T", ".jog()"), ("C6", "")],
        {
            (0, ""): lambda v: v["C1"],
            (0, ".reset()"): lambda v: v["C2"],
            (0, ".jump(DS2)"): lambda v: v["C3"],
            (0, ".jog()"): lambda v: v["C4"] or v["C6"],
        },
    ),
    "or-in-the-last-pin-of-a-drum-without-jump": (
        # the unused jump row is written out, or laddercodec would take the leg for it
        [("C1", DRUM), ("C2", ".reset()"), ("", ""), ("C4 T", ".jog()"), ("C6", "")],
        {(0, ""): lambda v: v["C1"], (0, ".reset()"): lambda v: v["C2"], (0, ".jog()"): lambda v: v["C4"] or v["C6"]},
    ),
    "down-counter-below-an-output": (
        # its box starts one row above its own row, and that row is written because a wire passes through it
        [("C1 T", "out(Y001)"), (". |", ""), (". -", CTD), ("C2", ".reset()")],
        {(0, ""): lambda v: v["C1"], (1, ""): lambda v: v["C1"], (1, ".reset()"): lambda v: v["C2"]},
    ),
    "or-beside-a-tall-box": (
        [("C1 T", COPY), ("C2 |", ""), ("C3", "")],
        {(0, ""): lambda v: v["C1"] or v["C2"] or v["C3"]},
    ),
    "immediate-contacts": (
        [("immediate(X001) T", "out(immediate(Y001))"), ("~immediate(X002)", "")],
        {(0, ""): lambda v: v["immediate(X001)"] or not v["immediate(X002)"]},
    ),
    "no-contact": ([("", "end()")], {(0, ""): lambda _: True}),
    "unwired-nop": ([(" ".join(["."] * CONDITION_COLUMNS), "NOP")], {(0, ""): lambda _: False}),
}


@pytest.mark.parametrize("name", PATTERNS)
def test_power_follows_the_formula(name: str) -> None:
    lines, formulas = PATTERNS[name]
    rung = rung_of(*lines)
    assert set(rung.terminals()) == {Terminal(*key) for key in formulas}
    table = truth_table(rung)
    assert len(table) == 2 ** len(condition_tokens(rung))
    for values, reached in table:
        expected = {Terminal(*key): bool(formula(values)) for key, formula in formulas.items()}
        assert reached == expected
        assert power(rung, values.__getitem__) == expected
    check_no_backfeed(rung)


@pytest.mark.parametrize("name", PATTERNS)
def test_laddercodec_agrees(name: str) -> None:
    lines, _ = PATTERNS[name]
    text = draw(*lines, comment=("first line", "second, with a comma"))
    (theirs,) = assert_codec_reads(text)
    assert_codec_reads(text.replace("\n", "\r\n"))
    (ours,) = read_ladder(text)
    for values, reached in truth_table(ours):
        assert power_of_codec_rung(theirs, values.__getitem__) == reached
    assert ladder_of_codec_rung(theirs).comment == ("first line", "second, with a comma")


def test_all_patterns_in_one_file() -> None:
    rows = [row for lines, _ in PATTERNS.values() for row in csv_rows(*lines)]
    text = csv_text(*rows)
    assert len(assert_codec_reads(text)) == len(read_ladder(text)) == len(PATTERNS)


def test_outputs_and_heights() -> None:
    rung = rung_of(("C1 T", COPY), (". T", SEND), (". |", ""), (". T", CTU), ("C2", ".reset()"), ("C3 -", "out(C4)"))
    assert [(one.token, one.row, [(pin.token, pin.row) for pin in one.pins]) for one in rung.outputs()] == [
        (COPY, 0, []),
        (SEND, 2, []),
        (CTU, 5, [(".reset()", 7)]),
        ("out(C4)", 8, []),
    ]
    assert len(rung.rows) == 9


@pytest.mark.parametrize(
    ("lines", "height"),
    [
        ([("C1", TON)], 2),
        ([("C1", CTU), ("C2", ".reset()")], 3),
        ([("C1", CTD), ("C2", ".reset()")], 3),
        ([("C1 |", ""), ("C2 -", CTD), ("C3", ".reset()")], 3),
        ([("C1 |", ""), ("C2 -", CTU), ("C3", ".reset()")], 4),
        ([("C1", DRUM), ("C2", ".reset()")], 4),
        ([("C1", DRUM), ("C2", ".reset()"), ("C3", ".jog()")], 4),
        ([("C1", "shift(C1..C8)"), ("C2", ".clock()"), ("C3", ".reset()")], 3),
        ([("C1", SEND)], 3),
        ([("C1 T", SEND), ("C2 |", ""), ("C3", "")], 3),
        ([("C1 T", "math(DS1 + 1,DS2,mode=decimal)"), ("C2", "")], 2),
    ],
)
def test_expanded_height(lines: list[Line], height: int) -> None:
    assert len(rung_of(*lines).rows) == height
    assert_codec_reads(draw(*lines))


def test_thirty_two_rows_fit() -> None:
    sixteen = [("C1 T", COPY), *[(". T", COPY)] * 14, (". -", COPY)]
    assert len(rung_of(*sixteen).rows) == 32
    assert_codec_reads(draw(*sixteen))


# -- broken grids ------------------------------------------------------------------------------------------------------


BLANK = " ".join(["."] * CONDITION_COLUMNS)


BROKEN: dict[str, tuple[list[Line], str]] = {
    "missing-tie": ([("C1 -", "out(Y001)"), ("C2", "")], "'C2' in A on row 2 leads to no output"),
    "missing-tie-in-the-middle": ([("C1 T", "out(Y001)"), ("C2", ""), ("C3", "")], "'C3' in A on row 3 leads to no"),
    "tie-one-column-late": ([("C1 - T", "out(Y001)"), ("C2", "")], "nothing at its lower end"),
    "tie-into-the-air": ([("C1 T", "out(Y001)"), (". . C2", "out(Y002)")], "nothing at its lower end"),
    "tie-from-the-air": ([("C1 - -", "out(Y001)"), ("C2 . |", "out(Y002)"), ("C3 -", "")], "nothing at its upper end"),
    "hole-in-the-wire": ([("C1 - . -", "out(Y001)")], "'C1' in A on row 1 leads to no output"),
    "floating-row": ([("C1", "out(Y001)"), (". C2", "out(Y002)")], "'C2' in B on row 2 floats"),
    "unconnected-output": ([("C1", "out(Y001)"), (BLANK, "out(Y002)")], "out(Y002) on row 2 is not connected"),
    "output-without-its-last-wire": ([(" ".join(["-"] * 30) + " .", "out(Y001)")], "leads to no output"),
    "t-in-column-a": ([("T C1", "out(Y001)"), ("C2 -", "out(Y002)")], "downward wire 'T' in column A on row 1"),
    "bar-in-column-a": ([("| C1", "out(Y001)"), ("C2 -", "out(Y002)")], "downward wire '|' in column A on row 1"),
    "prefix-in-column-a": ([("T:C1 T", "out(Y001)"), ("C2", "")], "downward wire 'T:C1' in column A on row 1"),
    "t-on-the-last-row": ([("C1 T", "out(Y001)")], "downward wire 'T' in B on row 1, its last"),
    "bar-on-the-last-row": ([("C1 T", "out(Y001)"), ("C2 |", "")], "downward wire '|' in B on row 2, its last"),
    "prefix-on-the-last-row": ([("C1 T:C2", "out(Y001)")], "downward wire 'T:C2' in B on row 1, its last"),
    "33-rows": ([("C1 T", "out(Y001)"), *[(". T", "out(Y001)")] * 31, (". -", "out(Y001)")], "33 expanded rows"),
    "34-rows-when-expanded": ([("C1 T", COPY), *[(". T", COPY)] * 15, (". -", COPY)], "34 expanded rows"),
    "two-nops": ([("C1 T", "NOP"), (". -", "NOP")], "more than one NOP"),
    "no-output": ([("C1 C2", "")], "no output"),
    "unknown-cell": ([("C1 X", "out(Y001)")], "unknown cell 'X' in column B"),
    "negated-edge": ([("~rise(C1)", "out(Y001)")], "unknown cell '~rise(C1)'"),
    "spaced-compare": ([("DS1-5", "out(Y001)")], "unknown cell 'DS1-5'"),
    "register-as-contact": ([("DS1", "out(Y001)")], "unknown cell 'DS1'"),
    "unknown-output": ([("C1", "outt(Y001)")], "unknown output 'outt(Y001)'"),
    "half-an-output": ([("C1", "out(Y001")], "unknown output 'out(Y001'"),
    "pin-without-a-box": ([("C1", ".reset()")], ".reset() is not directly below its instruction"),
    "pin-of-a-coil": ([("C1", "out(Y001)"), ("C2", ".reset()")], "out has no .reset()"),
    "pin-of-an-off-delay": ([("C1", TON.replace("on_", "off_")), ("C2", ".reset()")], "off_delay has no .reset()"),
    "down-pin-of-a-down-counter": ([("C1", CTD), ("C2", ".down()"), ("C3", ".reset()")], "count_down has no .down()"),
    "pin-after-a-leg": ([("C1 T", TON), ("C2", ""), ("C3", ".reset()")], "not directly below its instruction"),
    "pins-out-of-order": ([("C1", CTU), ("C2", ".reset()"), ("C3", ".down()")], ".down() out of order in count_up"),
    "same-pin-twice": ([("C1", TON), ("C2", ".reset()"), ("C3", ".reset()")], ".reset() out of order in on_delay"),
    "counter-without-reset": ([("C1", CTU)], "count_up without .reset"),
    "drum-without-reset": ([("C1", DRUM), ("C2", ".jog()")], "event_drum without .reset"),
    "shift-without-clock": ([("C1", "shift(C1..C8)"), ("C2", ".reset()")], "shift without .clock"),
    "bare-pin": ([("C1", TON), ("", ".reset()")], ".reset() on row 2 has no condition"),
    "unconnected-pin": ([("C1", TON), (BLANK, ".reset()")], ".reset() on row 2 is not connected"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_grids_fail(name: str) -> None:
    lines, message = BROKEN[name]
    with pytest.raises(AssertionError) as caught:
        read_ladder(draw(*lines))
    assert message in str(caught.value)
    with pytest.raises(AssertionError):
        assert_codec_reads(draw(*lines))


GOOD_ROW = ",".join(csv_rows(("C1", "out(Y001)"))[0])


HEAD = ",".join(HEADER)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "wrong header"),
        (f"{HEAD.replace('AE', 'AG')}\n{GOOD_ROW}\n", "wrong header"),
        (f"{HEAD}\n{GOOD_ROW},\n", "line 2: 34 columns, expected 33"),
        (f"{HEAD}\n{GOOD_ROW[:-10]}\n", "line 2: 32 columns, expected 33"),
        (f"{HEAD}\nQ{GOOD_ROW[1:]}\n", "line 2: unknown marker 'Q'"),
        (f"{HEAD}\nRx{GOOD_ROW[1:]}\n", "line 2: unknown marker 'Rx'"),
        (f"{HEAD}\n{GOOD_ROW[1:]}\n", "line 2: continuation row without a rung above it"),
        (f"{HEAD}\n{GOOD_ROW}\n#,note\n{GOOD_ROW[1:]}\n", "line 4: continuation row without a rung above it"),
        (f"{HEAD}\n{GOOD_ROW}\n#,note\n", "comment at the end of the file"),
        (f"{HEAD}\n#,note,more\n{GOOD_ROW}\n", "line 2: comment row has 3 columns"),
        (f'{HEAD}\n#,"two\nlines"\n{GOOD_ROW}\n', "line break inside a cell"),
        (f"{HEAD}\n\n{GOOD_ROW}\n", "line 2: empty line"),
    ],
)
def test_broken_files_fail(text: str, message: str) -> None:
    with pytest.raises(AssertionError) as caught:
        read_ladder(text)
    assert message in str(caught.value)


def test_comment_and_indexed_markers_are_read() -> None:
    rows = [["#", "one"], ["#", ""], ["#", "three"], *csv_rows(("C1", "out(Y001)")), *csv_rows(("C2", "out(Y002)"))]
    rows[3][0], rows[4][0] = "R1", "R2"
    first, second = read_ladder(csv_text(*rows))
    assert first.comment == ("one", "", "three")
    assert second.comment == ()
    assert_codec_reads(csv_text(*rows))
    rows[4][0] = "R7"
    with pytest.raises(AssertionError, match="markers"):
        assert_codec_reads(csv_text(*rows))


def test_backfeed_is_found() -> None:
    """A bridge: C5 between two parallel legs conducts from right to left when everything conducts both ways."""
    bridge = rung_of(("C1 T C3 T", "out(Y001)"), (". C5 | |", ""), ("C2 - C4", ""))
    only = {"C2", "C5", "C3"}
    assert power(bridge, only.__contains__) == {Terminal(0, ""): False}
    assert power(bridge, only.__contains__, bidirectional=True) == {Terminal(0, ""): True}
    with pytest.raises(AssertionError, match=r"backfeed: out\(Y001\)"):
        check_no_backfeed(bridge)


def test_a_large_rung_is_sampled_the_same_way_each_time() -> None:
    rung = rung_of((" ".join(f"C{n}" for n in range(1, 21)), "out(Y001)"))
    table = truth_table(rung, max_vars=8)
    assert len(table) == 2**8
    assert table == truth_table(rung, max_vars=8)
    assert table != truth_table(rung, max_vars=8, seed=1)
    assert {row.power[Terminal(0, "")] for row in table} == {False, True}


def test_negated_leaves_share_a_variable() -> None:
    rung = rung_of(("C1 ~C1", "out(Y001)"))
    assert condition_tokens(rung) == ["C1"]
    assert not any(row.power[Terminal(0, "")] for row in truth_table(rung))


# -- the solver --------------------------------------------------------------------------------------------------------


CELLS = st.sampled_from(["", "-", "T", "|", "C1", "C2", "~C1", "T:C2", "T:C3", "~C3"])


def reached_by_walking(cells: list[list[str]], true: set[str], bidirectional: bool) -> set[tuple[int, int]]:
    """Nodes with power, by walking the grid one step at a time: slow, and nothing in common with `flow`."""
    seen = {(row, 0) for row in range(len(cells))}
    ready = list(seen)
    while ready:
        row, boundary = ready.pop()
        steps = []
        for column, after in [(boundary, boundary + 1), *([(boundary - 1, boundary - 1)] if bidirectional else [])]:
            if 0 <= column < len(cells[row]):
                token = cells[row][column].removeprefix("T:")
                live = token in ("-", "T") or token in true or (token.startswith("~") and token[1:] not in true)
                if live:
                    steps.append((row, after))
        if boundary < len(cells[row]):
            if cells[row][boundary][:1] in ("T", "|") and row + 1 < len(cells):
                steps.append((row + 1, boundary))
            if row and cells[row - 1][boundary][:1] in ("T", "|"):
                steps.append((row - 1, boundary))
        for node in steps:
            if node not in seen:
                seen.add(node)
                ready.append(node)
    return seen


@given(
    st.integers(1, 5).flatmap(lambda n: st.lists(st.lists(CELLS, min_size=5, max_size=5), min_size=n, max_size=n)),
    st.booleans(),
)
def test_flow_agrees_with_a_walk(drawn: list[list[str]], bidirectional: bool) -> None:
    cells = [line + [""] * (CONDITION_COLUMNS - len(line)) for line in drawn]
    for case in product((False, True), repeat=3):
        true = {f"C{n}" for n, on in enumerate(case, 1) if on}

        def conducts(token: str, true: set[str] = true) -> int:
            return int(token[1:] not in true if token.startswith("~") else token in true)

        level = flow(cells, conducts, 1, bidirectional)
        walked = reached_by_walking(cells, true, bidirectional)
        assert {(r, b) for r, line in enumerate(level) for b, bit in enumerate(line) if bit} == walked


def test_situations_are_every_combination_once() -> None:
    sets, full = situations(["a", "b", "c"])
    assert full == 0b11111111
    assert {tuple(one >> n & 1 for one in sets.values()) for n in range(8)} == set(product((0, 1), repeat=3))


# -- limits ------------------------------------------------------------------------------------------------------------


def plain_rung(height: int) -> LadderRung:
    return LadderRung((), (), (Row(("-",) * CONDITION_COLUMNS),) * height, (Output("NOP", 0),))


@pytest.mark.parametrize(
    ("heights", "message"),
    [
        ([1] * 256, ""),
        ([1] * 257, "257 rungs"),
        ([30] * 66 + [1], "2048"),
        ([30] * 66, ""),
    ],
)
def test_file_limits(heights: list[int], message: str) -> None:
    rungs = [plain_rung(height) for height in heights]
    if message:
        with pytest.raises(AssertionError, match=message):
            check_limits(rungs)
    else:
        check_limits(rungs)


def test_laddercodec_is_not_asked_about_files_over_the_limits() -> None:
    """At 2048 it corrupts without a word, so the limit is checked first."""
    tall = csv_rows(("C1 T", COPY), *[(". T", COPY)] * 14, (". -", COPY))
    assert_codec_reads(csv_text(*(tall * 62)))
    with pytest.raises(AssertionError, match="are 2079, at most 2047"):
        assert_codec_reads(csv_text(*(tall * 63)))
