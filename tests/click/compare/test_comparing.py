"""Two rungs: identical, the same though drawn differently, or different."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from runs_to_compare import bits, likeness, rung, rungs, told
from test_importing_cases import CASE_NAMES, golden_ladders, ladder_text, wired

from clickgen.click.compare.same import Comparison, Likeness, compare
from clickgen.click.read.grid import DrawnRung, read_ladder
from clickgen.logic.equality import Decisions, Situations, TooMany


def series(*contacts: str, output: str = "out(Y001)") -> list[DrawnRung]:
    return rung(f"{' '.join(contacts)} > {output}")


# -- identical ---------------------------------------------------------------------------------------------------------


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


# -- the same ----------------------------------------------------------------------------------------------------------


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


# -- different ---------------------------------------------------------------------------------------------------------


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
            "the outputs are in another order: out(Y001), out(Y002) in the first, out(Y002), out(Y001) in the second",
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
        # A float may be no number, and nobody knows how a whole number and a float are compared.
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


# -- many contacts -----------------------------------------------------------------------------------------------------


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
    """Every column ties the two rows, or only some do."""
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
    """17 rows of 31 contacts: two exchanged, where a sample cannot prove equality, and one negated."""
    names = [bits(31, 31 * number + 1) for number in range(17)]
    rows = [f"{' '.join(row)} > out(C{1000 + number})" for number, row in enumerate(names)]
    other = compare(rung(*rows), rung(rows[0].replace("C1 C2 ", "C2 C1 "), *rows[1:]))
    assert other == Comparison(Likeness.UNKNOWN, "the contacts can be on and off in too many ways to compare them all")
    assert told(rung(*rows), rung(f"~{rows[0]}", *rows[1:])) == "out(C1000) does not have power in the same situations"


# -- logics ------------------------------------------------------------------------------------------------------------


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
