"""Two runs of rungs: when they are the same, and how a difference is reported."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from judges.builds import ladder_files
from runs_to_compare import SCRATCH, bits, likeness, rung, told

from clickgen.click.compare.outputs import Surroundings
from clickgen.click.compare.same import Comparison, Likeness, compare
from clickgen.click.read.grid import DrawnRung, read_ladder


def run(*each: Sequence[str]) -> list[DrawnRung]:
    """Rungs one after the other, each given by its rows."""
    return [one for rows in each for one in rung(*rows)]


# -- runs of rungs -----------------------------------------------------------------------------------------------------


WHOLE = rung("X001 T > out(Y001)", ". C5 > count_up(CT1,CTD1,preset=5)", "X002 > .reset()")


COUNTER = ("X001 C5 > count_up(CT1,CTD1,preset=5)", "X002 > .reset()")


def test_a_rung_may_be_split() -> None:
    assert likeness(WHOLE, run(["X001 > out(Y001)"], COUNTER)) == "SAME"
    on_scratch = run(
        ["X001 C5 > out(C2000)"], ["X001 > out(Y001)"], ["C2000 > count_up(CT1,CTD1,preset=5)", COUNTER[1]]
    )
    assert likeness(WHOLE, on_scratch) == "SAME"
    other = run(["X001 C5 > out(C1999)"], ["X001 > out(Y001)"], ["C1999 > count_up(CT1,CTD1,preset=5)", COUNTER[1]])
    assert likeness(on_scratch, other) == "SAME"
    assert likeness(on_scratch, run(["X001 > out(Y001)"], COUNTER)) == "SAME"


@pytest.mark.parametrize(
    "parts",
    [
        [COUNTER, ["X001 > out(Y001)"]],
        [["X001 > out(Y001)"]],
        [["X001 > out(Y001)"], ["X001 > count_up(CT1,CTD1,preset=5)", COUNTER[1]]],
        [["X001 > out(Y001)"], ["X001 C5 > count_up(CT1,CTD1,preset=5)", "~X002 > .reset()"]],
        [["X001 > out(Y001)"], COUNTER, ["X001 > out(C1)"]],
        # A definition that no later rung reads is an output.
        [["X001 > out(Y001)"], COUNTER, ["X001 > out(C2000)"]],
        [["X001 > out(C2000)"], ["X001 > out(Y001)"], COUNTER],
        [["X001 > out(C2000)"], ["X001 > out(Y001)"], ["C2000 > count_up(CT1,CTD1,preset=5)", COUNTER[1]]],
        [["X001 C5 > out(C2000)"], ["X001 > out(Y001)"], ["~C2000 > count_up(CT1,CTD1,preset=5)", COUNTER[1]]],
    ],
)
def test_what_a_split_changes_is_found(parts: list[Sequence[str]]) -> None:
    assert likeness(WHOLE, run(*parts)) == "DIFFERENT"


@pytest.mark.parametrize(
    ("whole", "parts", "reason"),
    [
        # Addresses that an earlier rung writes.
        (["C1 T > out(C1)", ". - > out(Y001)"], [["C1 > out(C1)"], ["C1 > out(Y001)"]], "C1 in rung 2 may be changed"),
        (
            ["X001 T > out(C1..C8)", ". C5 > out(Y001)"],
            [["X001 > out(C1..C8)"], ["X001 C5 > out(Y001)"]],
            "C5 in rung 2",
        ),
        (
            ["X001 T > copy(1,C[DS1])", ". C5 > out(Y001)"],
            [["X001 > copy(1,C[DS1])"], ["X001 C5 > out(Y001)"]],
            "C5 in rung 2",
        ),
        (
            ["X001 T > copy(DH1,YD0)", ". Y001 > out(C1)"],
            [["X001 > copy(DH1,YD0)"], ["X001 Y001 > out(C1)"]],
            "Y001 in rung 2",
        ),
        (
            ["X001 T > copy(DS1,DS2)", ". SC43 > out(C1)"],
            [["X001 > copy(DS1,DS2)"], ["X001 SC43 > out(C1)"]],
            "SC43 in rung 2",
        ),
        (
            ["X001 T > on_delay(T1,TD1,preset=5,unit=Ts)", ". >", ". T1 > out(C1)"],
            [["X001 > on_delay(T1,TD1,preset=5,unit=Ts)"], ["X001 T1 > out(C1)"]],
            "T1 in rung 2",
        ),
        (
            ["X001 T > copy(0,TD1)", ". >", ". T1 > out(C1)"],
            [["X001 > copy(0,TD1)"], ["X001 T1 > out(C1)"]],
            "T1 in rung 2",
        ),
        (
            ["X001 T > out(Y001)", ". rise(Y001) > out(C1)"],
            [["X001 > out(Y001)"], ["X001 rise(Y001) > out(C1)"]],
            "rise(Y001) in rung 2",
        ),
        (
            ['X001 T > call("sub")', ". C5 > out(C1)"],
            [['X001 > call("sub")'], ["X001 C5 > out(C1)"]],
            'call("sub") may change anything',
        ),
        # Conditions that must not be looked at twice, or are not reached.
        (
            ["immediate(X001) T > out(Y001)", ". - > out(C1)"],
            [["immediate(X001) > out(Y001)"], ["immediate(X001) > out(C1)"]],
            "looks at the terminal itself",
        ),
        (
            ["immediate(X001) T C1 > out(Y001)", ". C2 > out(Y002)"],
            [["immediate(X001) C1 > out(Y001)", "immediate(X001) C2 > out(Y002)"]],
            "looks at the terminal itself",
        ),
        (
            ["immediate(X001) T > out(Y001)", "immediate(X001) > "],
            [["immediate(X001) immediate(X001) > out(Y001)"]],
            "2 and 2 times",
        ),
        (["X001 T > end()", ". - > out(C1)"], [["X001 > end()"], ["X001 > out(C1)"]], "is above outputs"),
        (
            ["X001 T > return()", ". rise(X002) > out(C1)"],
            [["X001 > return()"], ["X001 rise(X002) > out(C1)"]],
            "is above outputs of the same rung",
        ),
        # Scratch bits.
        (
            ["X001 T > out(Y001)", ". - > out(C1)"],
            [
                ["X001 > out(Y001)"],
                ["C2000 > out(C1)"],
            ],
            "which no rung above it defines",
        ),
        (
            ["X001 T > out(Y001)", ". - > out(C1)"],
            [["C2000 > out(Y001)"], ["X001 > out(C2000)"], ["C2000 > out(C1)"]],
            "which no rung above it defines",
        ),
        (
            ["X001 T > out(Y001)", ". - > out(C1)"],
            [["X001 > out(C2000)"], ["C2000 > out(Y001)"], ["rise(C2000) > out(C1)"]],
            "looks at the scratch",
        ),
        (
            ["X001 T > copy(1,C[DS1])", ". - > out(C1)"],
            [["X001 > out(C2000)"], ["C2000 > copy(1,C[DS1])"], ["C2000 > out(C1)"]],
            "may touch a scratch bit",
        ),
        (
            ["X001 T > copy(C2000,Y001)", ". - > out(C1)"],
            [["X001 > out(C2000)"], ["C2000 > copy(C2000,Y001)"], ["C2000 > out(C1)"]],
            "may touch a scratch bit",
        ),
        # Loops.
        (["X001 T > for(3)", ". - > out(C1)"], [["X001 > for(3)"], ["X001 > out(C1)"]], "is between the rungs"),
    ],
)
def test_a_split_that_may_do_something_else_stays_unknown(
    whole: list[str], parts: list[list[str]], reason: str
) -> None:
    compared = compare(rung(*whole), run(*parts), SCRATCH)
    assert compared.likeness is Likeness.UNKNOWN
    assert reason in compared.reason
    assert compare(run(*parts), rung(*whole), SCRATCH) == compared


@pytest.mark.parametrize(
    ("whole", "parts"),
    [
        (["rise(X001) T > out(Y001)", ". - > out(C1)"], [["rise(X001) > out(Y001)"], ["rise(X001) > out(C1)"]]),
        (['X001 T > call("sub")', ". X002 > out(C1)"], [['X001 > call("sub")'], ["X001 X002 > out(C1)"]]),
        (
            ["immediate(X001) T > out(Y001)", ". - > out(C1)"],
            [["immediate(X001) > out(C2000)"], ["C2000 > out(Y001)"], ["C2000 > out(C1)"]],
        ),
        (["C1 T > out(C1)", ". - > out(Y001)"], [["C1 > out(C2000)"], ["C2000 > out(C1)"], ["C2000 > out(Y001)"]]),
        (["X001 > out(Y001)"], [["> NOP"], ["X001 > out(Y001)"]]),
    ],
)
def test_a_safe_split_is_the_same(whole: list[str], parts: list[list[str]]) -> None:
    assert likeness(rung(*whole), run(*parts)) == "SAME"


def test_what_a_subroutine_changes_may_be_known() -> None:
    whole = rung('X001 T > call("sub")', ". C5 > out(C1)")
    parts = run(['X001 > call("sub")'], ["X001 C5 > out(C1)"])
    for output, is_same in (("out(C6)", True), ("out(C5)", False), ("copy(1,C[DS1])", False), ('call("x")', False)):
        around = Surroundings.of({"sub": rung(f"X001 > {output}")})
        assert compare(whole, parts, SCRATCH, around).is_same is is_same


def test_a_subroutine_may_write_a_scratch_bit() -> None:
    whole = rung('X001 T > call("sub")', ". - > out(C1)")
    parts = run(["X001 > out(C2000)"], ['C2000 > call("sub")'], ["C2000 > out(C1)"])
    around = Surroundings.of({"sub": rung("X002 > out(C5)")})
    assert compare(whole, parts, SCRATCH, around).likeness is Likeness.SAME
    around = Surroundings.of({"sub": rung("X002 > out(C2000)")})
    assert compare(whole, parts, SCRATCH, around) == Comparison(
        Likeness.UNKNOWN, "the scratch bit C2000 may be written between its definition and rung 3"
    )


def test_rungs_that_are_the_same_one_by_one_are_the_same_together() -> None:
    """Whatever they read and write, and whichever scratch registers they need."""
    one = run(["C1 T > out(C1)", "C2 >"], ["C1 > copy(3,DS4500)"], ["C2000 > out(C1999)"])
    other = run(["C2 T > out(C1)", "C1 >"], ["C1 SC1 > copy(3,DS4500)"], ["C2000 > out(C1999)"])
    assert likeness(one, other) == "SAME"
    assert likeness(one, one) == "IDENTICAL"
    moved = run(["C2 T > out(C1)", "C1 >"], ["C1 > copy(3,DS4499)"], ["C2000 > out(C1999)"])
    assert likeness(one, moved) == "DIFFERENT"


# -- rungs that a build splits ----------------------------------------------------------------------------------------


def built(*lines: str) -> list[DrawnRung]:
    """The rungs of a program's main, except its last one."""
    text = "\n    ".join(["def main():", *lines, "if True:", "    end()"])
    [ladder] = ladder_files({"prog.py": text + "\n"}).values()
    return list(read_ladder(ladder, "main.csv").rungs[:-1])


def test_a_counter_beside_other_outputs() -> None:
    found = built("if x[1]:", "    out(y[1])", "    if c[5]:", "        ctu(ct[1], 5, reset=lambda: x[2])")
    assert len(found) == 2
    assert likeness(WHOLE, found) == "SAME"


def test_a_condition_that_the_first_output_changes() -> None:
    found = built(
        "if any(c[1], c[2]):", "    out(c[1])", "    ton(t[1], 5, Ts)", "    ctu(ct[1], 5, reset=lambda: c[1])"
    )
    whole = rung(
        "C1 T > out(C1)",
        "C2 T > on_delay(T1,TD1,preset=5,unit=Ts)",
        ". - > count_up(CT1,CTD1,preset=5)",
        "C1 > .reset()",
    )
    assert len(found) == 4
    assert likeness(whole, found) == "SAME"
    # Without a scratch bit for its reset the counter would see another input.
    bare = run(
        ["C1 T > out(C2000)", "C2 >"],
        ["C2000 > out(C1)"],
        ["C2000 > on_delay(T1,TD1,preset=5,unit=Ts)"],
        ["C2000 > count_up(CT1,CTD1,preset=5)", "C1 > .reset()"],
    )
    assert compare(whole, bare, SCRATCH).reason == "C1 in rung 4 may be changed by an output above it"


def test_forty_contacts_in_series() -> None:
    names = [f"c[{number}]" for number in range(1, 41)]
    found = built(f"if all({', '.join(names)}):", "    out(y[1])")
    assert len(found) == 2
    by_hand = run([f"{' '.join(bits(20, 21))} > out(C1990)"], [f"{' '.join([*bits(20), 'C1990'])} > out(Y001)"])
    assert likeness(found, by_hand) == "SAME"
    wrong = run([f"{' '.join(bits(20, 22))} > out(C1990)"], [f"{' '.join([*bits(20), 'C1990'])} > out(Y001)"])
    assert told(found, wrong).startswith("out(Y001) has power with C21, C1, C2, ")


def test_of_a_hundred_contacts_the_one_that_differs_is_told_first() -> None:
    first, second, third = (" ".join(bits(30, start)) for start in (1, 31, 61))
    last = "C1991 " + third
    sides = [
        run([f"{one} > out(C1990)"], [f"C1990 {second} > out(C1991)"], [f"{last} > out(Y001)"])
        for one in (first, first.replace("C17 ", "~C17 "))
    ]
    assert told(*sides).startswith("out(Y001) has power with C17, C1, C2, ")


def test_forty_contacts_in_parallel() -> None:
    names = [f"c[{number}]" for number in range(1, 41)]
    found = built(f"if any({', '.join(names)}):", "    out(y[1])")
    some = [
        f"C{number} {'T' if number == 1 else '|'} > {'out(C1990)' if number == 1 else ''}" for number in range(1, 20)
    ]
    rest = [
        f"C{number} {'T' if number == 21 else '|'} > {'out(Y001)' if number == 21 else ''}" for number in range(21, 41)
    ]
    by_hand = run([*some, "C20 >"], [*rest, "C1990 >"])
    assert likeness(found, by_hand) == "SAME"
    wrong = run([*some, "C19 >"], [*rest, "C1990 >"])
    assert told(found, wrong).startswith("out(Y001) has power with C20 on and C1, C2, C3, C4, ")
