"""Two runs of CLICK rungs: what is identical, what is the same though drawn otherwise, how a difference is told."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

import pytest
from judges.builds import ladder_files
from test_importing_cases import CASE_NAMES, golden_ladders, ladder_text, wired

from clickgen.click.compare.outputs import Surroundings
from clickgen.click.compare.same import Comparison, Likeness, compare
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.device.banks import Address
from clickgen.logic.equality import Decisions, Situations, TooMany

SCRATCH = frozenset(Address("C", number) for number in range(1900, 2001))


def rungs(*rows: list[str]) -> list[DrawnRung]:
    ladder = read_ladder(ladder_text(rows), "main.csv")
    assert not ladder.all_problems, ladder.all_problems
    return list(ladder.rungs)


def rung(*rows: str) -> list[DrawnRung]:
    """A rung of rows such as ``X001 T:X002 > out(Y001)``; ``.`` is a blank square."""
    found = []
    for number, row in enumerate(rows):
        contacts, output = re.split(r"(?:^| )>(?: |$)", row, maxsplit=1)
        found.append(wired(contacts, output, "" if number else "R"))
    return rungs(*found)


def run(*each: Sequence[str]) -> list[DrawnRung]:
    """Rungs one behind the other, each of its rows."""
    return [one for rows in each for one in rung(*rows)]


def series(*contacts: str, output: str = "out(Y001)") -> list[DrawnRung]:
    return rung(f"{' '.join(contacts)} > {output}")


def bits(count: int, start: int = 1) -> list[str]:
    return [f"C{number}" for number in range(start, start + count)]


def told(one: list[DrawnRung], other: list[DrawnRung]) -> str:
    compared = compare(one, other, SCRATCH)
    assert compared.likeness is Likeness.DIFFERENT, compared
    return compared.reason


def likeness(one: list[DrawnRung], other: list[DrawnRung]) -> str:
    """The same in both directions."""
    found = compare(one, other, SCRATCH)
    assert found.likeness is compare(other, one, SCRATCH).likeness
    assert (found.reason == "") is found.is_same
    return found.likeness.name


# -- identical --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", CASE_NAMES)
def test_a_golden_ladder_is_identical_to_itself(name: str) -> None:
    for text in golden_ladders(name).values():
        # The first line of a file moves the spans of all that follows.
        one, other = read_ladder(text, "main.csv"), read_ladder(text.replace("\nR,", "\n#,moved\nR,", 1), "other.csv")
        assert compare(one.rungs, other.rungs) == Comparison(Likeness.IDENTICAL)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (("X001.immediate", "out(Y001)"), ("immediate(X001)", "out( Y001 )")),
        (("DH1==00ffh", "out(Y001)"), ("DH1 == 00FFh", "out(Y001)")),
        (("DS1==+5", "copy(DS1, DS2)"), ("DS1==5", "copy(DS1,DS2,oneshot=0)")),
        (("X001", "copy(1.50,DF1)"), ("X001", "copy(1.5,DF1)")),
        (("X001", "copy(00ffh,DH1)"), ("X001", "copy(00FFh,DH1)")),
        (("X001", "math(DS1 + 1,DS2,mode=decimal)"), ("X001", "math(DS1+1, DS2, mode=decimal)")),
        (("X001", "pack_words(X001..X016,DH1)"), ("X001", "pack_bits(X001..X016,DH1)")),
    ],
)
def test_spelling_does_not_count(one: tuple[str, str], other: tuple[str, str]) -> None:
    sides = [wired("", output, "R") for _, output in (one, other)]
    for row, (contact, _) in zip(sides, (one, other), strict=True):
        row[1] = contact
    assert likeness(*(rungs(row) for row in sides)) == "IDENTICAL"


def test_blank_rows_at_the_end_and_comments_do_not_count() -> None:
    plain = rung("X001 > out(Y001)")
    assert likeness(plain, rung("X001 > out(Y001)", ". >")) == "IDENTICAL"
    assert likeness(plain, rungs(["#", "a comment"], wired("X001", "out(Y001)", "R"))) == "IDENTICAL"


# -- the same ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (["C1 T:C3 > out(Y001)", "C2 >"], ["C1 C3 T > out(Y001)", "C2 C3 >"]),
        (["C1 T:C3 > out(Y001)", "C2 >"], ["C2 C3 T > out(Y001)", "C1 C3 >"]),
        (["C1 C2 > out(Y001)"], ["C2 C1 > out(Y001)"]),
        (["C1 > out(Y001)"], ["C1 C1 SC1 > out(Y001)"]),
        (["C1 > out(Y001)"], ["C1 - T > out(Y001)", "C1 ~SC1 >"]),
        (["C1 - T > out(Y001)", "C1 C2 >"], ["C1 > out(Y001)"]),
        (["C1 T > out(Y001)", "~C1 >"], ["SC1 > out(Y001)"]),
        (["C1 - T > out(Y001)", "~C1 C2 >"], ["C1 T > out(Y001)", "C2 >"]),
        (["C1 > out(Y001)"], ["C1 > out(Y001)", "- - >"]),
        (["C1 T > out(Y001)", ". C2 > out(Y002)"], ["C1 > out(Y001)", "C1 C2 > out(Y002)"]),
        (["5==DS1 > out(Y001)"], ["DS1==5 > out(Y001)"]),
        (["5<DS1 > out(Y001)"], ["DS1>5 > out(Y001)"]),
        (["DS1<5 T > out(Y001)", "DS1>=5 >"], ["> out(Y001)"]),
        (["DS1!=5 T > out(Y001)", "DS1==5 >"], ["> out(Y001)"]),
        (['TXT1!="A" T > out(Y001)', 'TXT1=="A" >'], ["> out(Y001)"]),
        (["DH1<=0fh T > out(Y001)", "DH1>000Fh >"], ["> out(Y001)"]),
        (["DF1>1.50 > out(Y001)"], ["1.5<DF1 > out(Y001)"]),
        (["> NOP"], ["C1 > NOP"]),
        (["> NOP"], ["C1 >"]),
        (["C1 T > out(Y001)", ". - > NOP"], ["C1 > out(Y001)"]),
        (
            ["X001 > on_delay(T1,TD1,preset=5,unit=Ts)", "SC1 > .reset()"],
            ["X001 > on_delay(T1,TD1,preset=5,unit=Ts)", "> .reset()"],
        ),
    ],
)
def test_what_is_drawn_otherwise_may_be_the_same(one: list[str], other: list[str]) -> None:
    assert likeness(rung(*one), rung(*other)) == "SAME"


# -- different --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("one", "other", "reason"),
    [
        (["X001 > out(Y001)"], ["~X001 > out(Y001)"], "out(Y001) has power with X001 on in the first only"),
        (
            ["X001 C5 > out(Y001)"],
            ["X001 C5 T:X002 > out(Y001)", ". . - >"],
            "out(Y001) has power with X001 and C5 on and X002 off in the first only",
        ),
        (
            ["X001 > out(Y001)"],
            ["X001 T > out(Y001)", "C5 >"],
            "out(Y001) has power with C5 on and X001 off in the second only",
        ),
        (["> out(Y001)"], ["~SC1 > out(Y001)"], "out(Y001) has power always in the first, never in the other"),
        (
            ["rise(X001) > out(Y001)"],
            ["fall(X001) > out(Y001)"],
            "out(Y001) has power with rise(X001) on and fall(X001) off in the first only",
        ),
        (
            ["X001 > out(Y001)"],
            ["immediate(X001) > out(Y001)"],
            "out(Y001) has power with X001 on and immediate(X001) off in the first only",
        ),
        (["X001 > out(Y001)"], ["X001 > out(Y002)"], "output 1 is out(Y001) in the first, out(Y002) in the second"),
        (
            ["X001 > out(Y001)"],
            ["X001 > out(immediate(Y001))"],
            "output 1 is out(Y001) in the first, out(immediate(Y001)) in the second",
        ),
        (
            ["X001 > copy(5,DF1)"],
            ["X001 > copy(5.0,DF1)"],
            "output 1 is copy(5,DF1) in the first, copy(5.0,DF1) in the second",
        ),
        (["X001 > out(Y001)"], ["X001 T > out(Y001)", ". - > out(Y002)"], "only the second has out(Y002)"),
        (["X001 > out(Y001)"], ["X001 >"], "only the first has out(Y001)"),
        (
            ["X001 T > out(Y001)", ". - > out(Y002)"],
            ["X001 T > out(Y002)", ". - > out(Y001)"],
            "the outputs stand in another order: out(Y001), out(Y002) in the first, out(Y002), out(Y001) in the second",
        ),
        (
            ["X001 > count_up(CT1,CTD1,preset=5)", "X002 > .down()", "X003 > .reset()"],
            ["X001 > count_up(CT1,CTD1,preset=5)", "X003 > .down()", "X002 > .reset()"],
            ".down() of count_up(CT1,CTD1,preset=5) has power with X002 on and X003 off in the first only",
        ),
        (
            ["X001 > count_up(CT1,CTD1,preset=5)", "X002 > .down()", "X003 > .reset()"],
            ["X001 > count_up(CT1,CTD1,preset=5)", ". >", "X003 > .reset()"],
            "count_up(CT1,CTD1,preset=5) has the inputs .down(), .reset() in the first, .reset() in the second",
        ),
    ],
)
def test_what_differs_is_told(one: list[str], other: list[str], reason: str) -> None:
    assert told(rung(*one), rung(*other)) == reason
    assert likeness(rung(*one), rung(*other)) == "DIFFERENT"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        # A float may be no number, and how a whole number and a float are compared nobody knows.
        (["DF1<1.5 T > out(Y001)", "DF1>=1.5 >"], ["> out(Y001)"]),
        (["DF1==1.5 T > out(Y001)", "DF1!=1.5 >"], ["> out(Y001)"]),
        (["DS1<1.5 > out(Y001)"], ["1.5>DS1 > out(Y001)"]),
        (["DF1==5 > out(Y001)"], ["DF1==5.0 > out(Y001)"]),
        (["DS1<5 > out(Y001)"], ["5<DS1 > out(Y001)"]),
        (["X001 > math(( DS1 + 1 ),DS2,mode=decimal)"], ["X001 > math(DS1 + 1,DS2,mode=decimal)"]),
        (["X001 > math(DS1 + 1.50,DF2,mode=decimal)"], ["X001 > math(DS1 + 1.5,DF2,mode=decimal)"]),
        (
            ["X001 > shift(C1..C8)", "X002 > .clock()", "X003 > .reset()"],
            ["X001 > shift(C8..C1)", "X002 > .clock()", "X003 > .reset()"],
        ),
    ],
)
def test_what_is_not_proven_is_not_the_same(one: list[str], other: list[str]) -> None:
    assert likeness(rung(*one), rung(*other)) == "DIFFERENT"


def test_a_damaged_rung_stays_unknown() -> None:
    [damaged] = read_ladder(ladder_text([wired("X001 nonsense", "out(Y001)", "R")]), "main.csv").rungs
    compared = compare([damaged], [damaged])
    assert compared.likeness is Likeness.UNKNOWN
    assert "'nonsense'" in compared.reason


# -- many contacts ----------------------------------------------------------------------------------------------------


def parallel(*contacts: str) -> list[DrawnRung]:
    first, *middle, last = contacts
    return rung(f"{first} T > out(Y001)", *(f"{contact} | >" for contact in middle), f"{last} >")


def pairs(*contacts: str) -> list[DrawnRung]:
    """Pairs of parallel contacts in series."""
    tops, lows = contacts[::2], contacts[1::2]
    top = " ".join([tops[0], *(f"T:{contact}" for contact in tops[1:]), "T"])
    return rung(f"{top} > out(Y001)", f"{' '.join(lows)} >")


@pytest.mark.parametrize("drawing", [series, parallel, pairs])
def test_twenty_contacts_in_any_order_are_the_same(drawing: Callable[..., list[DrawnRung]]) -> None:
    names = bits(20)
    order = [*names[::-1]]
    assert likeness(drawing(*names), drawing(*order)) == "SAME"
    for index in range(20):
        assert likeness(drawing(*names), drawing(*names[:index], "C99", *names[index + 1 :])) == "DIFFERENT"


def test_what_stands_in_one_of_many_is_told_first() -> None:
    names = bits(30)
    assert told(series(*names), series(*names[:12], "~C13", *names[13:])) == (
        "out(Y001) has power with C13, C1, C2, C3, C4, C5, C6, C7, C8, C9, C10 and 19 more on in the first only"
    )
    assert told(parallel(*names), parallel(*names[:29], "C31")).startswith(
        "out(Y001) has power with C30 on and C31, C1"
    )


def test_a_rung_of_all_squares_is_compared() -> None:
    """Legs with an output each, and 15 columns of contacts that all of 32 rows share two by two."""
    rows = [" ".join(bits(15, 20 * number)) + f" > out(C{1000 + number})" for number in range(1, 33)]
    assert likeness(rung(*rows), rung(*rows[:5], rows[5].replace("C121 ", "C121 SC1 "), *rows[6:])) == "SAME"
    assert likeness(rung(*rows), rung(*rows[:5], rows[5].replace("C121 ", "~C121 "), *rows[6:])) == "DIFFERENT"


def test_bridges_of_many_contacts_are_compared() -> None:
    """Every column ties the two rows, or only some of them do."""
    top, low = bits(28, 1), bits(28, 101)
    tied = " ".join([top[0], *(f"T:{contact}" for contact in top[1:]), "T"])
    some = tied.replace("T:C14", "C14")
    rest = " ".join(low)
    swapped = " ".join([low[0], *(f"T:{contact}" for contact in low[1:]), "T"])
    assert (
        likeness(rung(f"{tied} > out(Y001)", f"{rest} >"), rung(f"{swapped} > out(Y001)", f"{' '.join(top)} >"))
        == "SAME"
    )
    assert told(rung(f"{tied} > out(Y001)", f"{rest} >"), rung(f"{some} > out(Y001)", f"{rest} >")).endswith(
        "first only"
    )


def test_what_no_diagram_can_hold_is_proven_by_a_sample_alone() -> None:
    """17 rows of 31 contacts: two in another order, which no sample can prove, and one that is negated."""
    names = [bits(31, 31 * number + 1) for number in range(17)]
    rows = [f"{' '.join(row)} > out(C{1000 + number})" for number, row in enumerate(names)]
    other = compare(rung(*rows), rung(rows[0].replace("C1 C2 ", "C2 C1 "), *rows[1:]))
    assert other == Comparison(Likeness.UNKNOWN, "the contacts can be on and off in too many ways to compare them all")
    assert told(rung(*rows), rung(f"~{rows[0]}", *rows[1:])) == "out(C1000) does not have power in the same situations"


# -- logics -----------------------------------------------------------------------------------------------------------


def test_both_logics_say_the_same() -> None:
    names = ["a", "b", "c"]
    sets, diagrams = Situations.every(names), Decisions(names)
    assert [sets.variable(name) for name in names] == [0b10101010, 0b11001100, 0b11110000]
    known = {0: 0, 1: sets.always, **{diagrams.variable(name): sets.variable(name) for name in names}}
    for _ in range(2):
        for one, mine in list(known.items()):
            known[diagrams.opposite(one)] = sets.opposite(mine)
            for other, theirs in list(known.items()):
                for found, expected in (
                    (diagrams.both(one, other), sets.both(mine, theirs)),
                    (diagrams.either(one, other), sets.either(mine, theirs)),
                ):
                    assert known.setdefault(found, expected) == expected
    assert len(known) == len(set(known.values()))
    assert len(known) > 200


def test_samples_hold_the_corners_and_are_the_same_each_time() -> None:
    names = bits(40)
    one = Situations.sampled(names)
    assert one == Situations.sampled(names)
    every = one.always
    for name in names:
        every &= one.variable(name)
    assert every
    for name in names:
        others = one.always
        for other in names:
            if other != name:
                others &= one.variable(other)
        assert others & ~one.variable(name)


def test_a_diagram_has_a_limit() -> None:
    diagrams = Decisions(bits(24), limit=100)

    def grow() -> None:
        found = diagrams.never
        for number in range(1, 13):
            one, other = diagrams.variable(f"C{number}"), diagrams.variable(f"C{number + 12}")
            found = diagrams.either(found, diagrams.both(one, other))

    with pytest.raises(TooMany):
        grow()
    with pytest.raises(TooMany):
        Decisions(bits(501))


# -- runs of rungs ----------------------------------------------------------------------------------------------------

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
        # What an earlier rung writes.
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
        # What must not be looked at twice, or is not reached.
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
        (["X001 T > end()", ". - > out(C1)"], [["X001 > end()"], ["X001 > out(C1)"]], "stands above outputs"),
        (
            ["X001 T > return()", ". rise(X002) > out(C1)"],
            [["X001 > return()"], ["X001 rise(X002) > out(C1)"]],
            "stands above outputs of the same rung",
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
        (["X001 T > for(3)", ". - > out(C1)"], [["X001 > for(3)"], ["X001 > out(C1)"]], "stands between the rungs"),
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


# -- what a build splits ----------------------------------------------------------------------------------------------


def built(*lines: str) -> list[DrawnRung]:
    """The rungs of a program's main, its last one aside."""
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
