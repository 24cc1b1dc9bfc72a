"""clickgen.logic.conditions case by case, and checked against every state of a small machine."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from clickgen.dialects.if_rungs.read.imports import read_program
from clickgen.dialects.registry import default
from clickgen.ir.conditions import All, Compare, Condition
from clickgen.ir.program import Program
from clickgen.logic.conditions import always_holds, are_exclusive, can_hold, decided, implies
from clickgen.problems.diagnostics import Diagnostics
from clickgen.resolve.resolve import resolve
from clickgen.table.address_table import AddressTable
from clickgen.text.source import SourceFile


def program(text: str) -> Program:
    problems = Diagnostics()
    source = SourceFile("prog.py", f"def main():\n    if {text}:\n        out(c[2000])\n")
    program, _ = read_program(source, lambda _: b"", problems)
    assert program
    assert not problems.has_errors, problems.found
    return program


def unresolved(text: str) -> Condition:
    """The condition of ``if text:``, names as they are."""
    return program(text).routines[0].rungs[0].condition


def read(text: str) -> Condition:
    """The condition of ``if text:``, names resolved."""
    problems = Diagnostics()
    resolved = resolve(program(text), AddressTable.empty(""), False, problems, default()).program
    assert not problems.has_errors, problems.found
    return resolved.routines[0].rungs[0].condition


# -- case by case -----------------------------------------------------------------------------------------------------

POSSIBLE = """
c[1]
True
all(c[1], nc(c[2]))
any(c[1], nc(c[1]))
all(any(c[1], c[2]), nc(c[1]))
re(c[1])
all(re(c[1]), c[1])
all(fe(c[1]), nc(c[1]))
all(re(c[1]), re(c[2]), fe(c[3]))
all(c[1:4], c[4])
any(c[1:4], nc(c[1:4]))
all(x[1].immediate, nc(x[1]))
all(x[1].immediate, nc(x[1].immediate))
all(x[1:4].immediate, nc(x[2].immediate))
all(ds[1] > 4, ds[1] < 6)
all(ds[1] >= 5, ds[1] <= 5)
all(ds[1] != 5, ds[1] != 6, ds[1] > 4, ds[1] < 8)
all(ds[1] > 4.5, ds[1] < 5.5)
all(df[1] > 4, df[1] < 5)
any(df[1] < 3, df[1] >= 3)
any(df[1] < df[2], df[1] >= df[2])
all(df[1] != 3, df[1] != df[1])
all(5 < ds[1], 7 > ds[1])
all(dh[1] == 0x00FF, dh[2] == "00FEh")
all(dh[1] > 0xFFFE, dh[1] != 0)
all(txt[1] == "A", txt[2] == "B")
all(ds[1] == ds[2], ds[1] >= ds[2])
all(ds[1] <= ds[2], ds[2] <= ds[1])
all(ds[1] < ds[2], ds[2] < ds[3], ds[3] < ds[1])
all(td[1] == 5, ds[1] == 6, ctd[1] == 7)
all(ds[1] < ds[2], ds[2] < 5, ds[1] > 6)
ds[1] == ds[1]
ds[1]
all(dd[1] == 16777217, dd[1] == 16777216.0)
all(xd[0] == 0x0001, nc(x[1]))
""".strip().split("\n")
"""Some state makes these true, or it cannot be decided: three registers in a circle, a register and two others."""

IMPOSSIBLE = """
all(c[1], nc(c[1]))
all(any(c[1], c[2]), nc(c[1]), nc(c[2]))
all(re(c[1]), nc(c[1]))
all(fe(c[1]), c[1])
all(re(c[1]), fe(c[1]))
all(c[1:4], nc(c[2]))
all(nc(c[1:4]), c[3])
all(c[1:4], nc(c[3:6]))
all(any(c[1], c[2]), nc(c[1:3]))
all(ds[1] == 1, ds[1] == 2)
all(ds[1] > 5, ds[1] < 6)
all(5 < ds[1], 6 > ds[1])
all(ds[1] > 5, ds[1] <= 6, ds[1] != 6)
all(ds[1] != 1, ds[1] != 2, ds[1] != 3, ds[1] > 0, ds[1] < 4)
all(ds[1], ds[1] == 0)
all(ds[1] > 4.2, ds[1] < 4.8)
ds[1] == 2.5
ds[1] > 32767
ds[1] < -32768
dd[1] > 2147483647
dh[1] < 0
dh[1] > 0xFFFF
all(df[1] > 5, df[1] < 5)
all(df[1] == 0.1, df[1] != 0.1)
all(df[1] > 0.1, df[1] < 0.10000000001)
all(dh[1] == 0x00FF, dh[1] == 254)
all(txt[1] == "A", txt[1] == "B")
all(ds[1] < ds[2], ds[2] < ds[1])
all(ds[1] == ds[2], ds[2] != ds[1])
ds[1] < ds[1]
ds[1] != ds[1]
all(td[1] > 10, td[1] < 10)
all(any(ds[1] == 1, ds[1] == 2), any(ds[1] == 3, ds[1] == 4))
""".strip().split("\n")

CERTAIN = """
True
any(c[1], nc(c[1]))
any(c[1:3], nc(c[1]), nc(c[2]))
any(nc(c[1:3]), c[1], c[2])
any(c[1], all(nc(c[1]), c[2]), nc(c[2]))
any(ds[1] <= 5, ds[1] > 5)
any(ds[1] == 1, ds[1] != 1)
any(ds[1] < 3, ds[1] > 2)
any(ds[1] < 3.5, ds[1] > 3.2)
any(df[1] == 3, df[1] != 3)
any(df[1] == df[2], df[1] != df[2])
any(ds[1] < ds[2], ds[1] >= ds[2])
ds[1] == ds[1]
ds[1] >= -32768
dh[1] >= 0
""".strip().split("\n")

IMPLIED = """
c[1] -> c[1]
all(c[1], c[2]) -> c[1]
c[1] -> any(c[1], c[2])
c[1] -> True
re(c[1]) -> c[1]
fe(c[1]) -> nc(c[1])
c[1:4] -> c[2]
c[1:6] -> c[2:4]
nc(c[1:6]) -> nc(c[2:4])
ds[1] == 5 -> ds[1] > 4
ds[1] > 4 -> ds[1] >= 5
ds[1] > 4.5 -> ds[1] >= 5
ds[1] == 5 -> 5 == ds[1]
ds[1] < ds[2] -> ds[2] > ds[1]
ds[1] == ds[2] -> ds[1] <= ds[2]
any(ds[1] == 1, ds[1] == 2) -> ds[1] > 0
all(c[1], nc(c[1])) -> c[2]
dh[1] == 0x0010 -> dh[1] > 15
txt[1] == "A" -> txt[1] != "B"
""".strip().split("\n")

NOT_IMPLIED = """
c[1] -> c[2]
c[1] -> re(c[1])
any(c[1], c[2]) -> c[1]
c[1:4] -> c[4]
c[2] -> c[1:4]
x[1].immediate -> x[1]
x[1] -> x[1].immediate
x[1].immediate -> x[1].immediate
ds[1] > 4 -> ds[1] > 5
df[1] > 4 -> df[1] >= 5
df[1] != 4 -> any(df[1] < 4, df[1] > 4)
df[1] != df[2] -> any(df[1] < df[2], df[1] > df[2])
ds[1] <= ds[2] -> ds[1] == ds[2]
True -> c[1]
""".strip().split("\n")


@pytest.mark.parametrize("text", POSSIBLE)
def test_what_may_hold(text: str) -> None:
    assert can_hold(read(text))


@pytest.mark.parametrize("text", IMPOSSIBLE)
def test_what_never_holds(text: str) -> None:
    condition = read(text)
    assert not can_hold(condition)
    assert not always_holds(condition)
    if isinstance(condition, All):
        assert are_exclusive(*condition.terms)


@pytest.mark.parametrize("text", CERTAIN)
def test_what_always_holds(text: str) -> None:
    assert always_holds(read(text))


@pytest.mark.parametrize("text", [text for text in POSSIBLE if text not in CERTAIN])
def test_what_does_not_always_hold(text: str) -> None:
    assert not always_holds(read(text))


@pytest.mark.parametrize("text", IMPLIED)
def test_what_follows(text: str) -> None:
    one, other = map(read, text.split(" -> "))
    assert implies(one, other)


@pytest.mark.parametrize("text", NOT_IMPLIED)
def test_what_does_not_follow(text: str) -> None:
    one, other = map(read, text.split(" -> "))
    assert not implies(one, other)


# -- names without an address -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "all(c.A, nc(c.A))",
        "all(c.A, nc(c.a))",
        "all(re(c.A), nc(c.A))",
        "all(c.Row[1], nc(c.Row[1]))",
        "all(c.Row[0:2], nc(c.Row[0:2]))",
        "all(ds.V == 1, ds.V == 2)",
        "all(ds.V < ds.W, ds.V > ds.W)",
        "ds.V > 32767",
        "all(td.T > 5, td.T < 5)",
    ],
)
def test_a_name_is_not_on_and_off_at_once(text: str) -> None:
    assert not can_hold(unresolved(text))


@pytest.mark.parametrize(
    "text",
    [
        "all(c.A, nc(c.B))",
        "all(c.A, nc(c[1]))",
        "all(c.Row[1], nc(c.Row[2]))",
        "all(c.Row[0], nc(c.Row))",
        "all(c.Row[0:2], nc(c.Row[1:3]))",
        "all(ds.V == 1, ds.W == 2)",
        "all(ds.V < ds.W, ds.V == ds.X)",
        "all(x.A.immediate, nc(x.A.immediate))",
    ],
)
def test_two_names_say_nothing_of_each_other(text: str) -> None:
    assert can_hold(unresolved(text))


def test_a_name_of_bits_may_be_a_block_that_is_neither_on_nor_off() -> None:
    for name in ("c.A", "c.Row[0:4]"):
        assert not always_holds(unresolved(f"any({name}, nc({name}))"))
        assert implies(unresolved(name), unresolved(f"any({name}, c.B)"))
        assert implies(unresolved(f"nc({name})"), unresolved(f"any(nc({name}), c.B)"))
    assert always_holds(unresolved("any(c.Row[1], nc(c.Row[1]))"))


@pytest.mark.parametrize("constant", ["1e39", "1e999", "-1e999", "16777217", "1" + "0" * 400 + ".0"])
def test_of_a_constant_that_a_register_cannot_hold_nothing_is_known(constant: str) -> None:
    for op, other in (("<", ">="), ("==", "!=")):
        condition = unresolved(f"all(df.X {op} {constant}, df.X {other} {constant})")
        assert can_hold(condition)
        assert not always_holds(unresolved(f"any(df.X {op} {constant}, df.X {other} {constant})"))


def test_a_whole_number_and_one_with_a_point_are_not_confused() -> None:
    for text, truth in (("dd[1] > 2147483647", False), ("dd[1] > 2147483647.0", None), ("dd.X > 1e999", None)):
        compare = unresolved(text)
        assert isinstance(compare, Compare)
        assert decided(compare) is truth


# -- limits -----------------------------------------------------------------------------------------------------------


def test_a_condition_too_large_to_decide_counts_as_possible() -> None:
    # Each choice of one bit of a pair excludes a bit of the others: 2 to the 40th ways, and none of them works.
    choices = ", ".join(f"any(c[{n}], c[{n + 1}])" for n in range(1, 81, 2))
    never = ", ".join(f"any(nc(c[{n}]), nc(c[{n + 1}]))" for n in range(1, 81, 2))
    condition = read(f"all({choices}, {never}, any(ds[1] == 1, ds[1] == 2), ds[1] > 2)")
    assert can_hold(condition)
    assert not are_exclusive(condition)


def test_a_long_series_and_a_long_range_are_decided() -> None:
    series = ", ".join(f"c[{n}]" for n in range(1, 1001))
    assert can_hold(read(f"all({series})"))
    assert not can_hold(read(f"all({series}, nc(c[1000]))"))
    assert not can_hold(read("all(c[1:2000], nc(c[1999]))"))
    assert implies(read("c[1:2000]"), read("c[1999]"))


# -- every state of a small machine -----------------------------------------------------------------------------------

_COMPARE: Mapping[str, Callable[[int, int], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}
BITS = (1, 2, 3)
VALUES = tuple(range(-2, 6))
"""Around the constants 0 to 3: every order that two registers and the constants can have."""


@dataclass(frozen=True)
class State:
    """Bits now and a scan before, and two registers."""

    now: tuple[bool, ...]
    before: tuple[bool, ...]
    registers: tuple[int, ...]


@dataclass(frozen=True)
class Term:
    """A condition as text, and whether it holds in a state."""

    text: str
    holds: Callable[[Any], bool]


def _level(bit: int, word: str) -> Term:
    wanted = word != "nc"
    edges: dict[str, Callable[[State], bool]] = {
        "re": lambda state: state.now[bit - 1] and not state.before[bit - 1],
        "fe": lambda state: state.before[bit - 1] and not state.now[bit - 1],
    }
    text = f"{word}(c[{bit}])" if word else f"c[{bit}]"
    return Term(text, edges.get(word, lambda state: state.now[bit - 1] is wanted))


def _range(first: int, last: int, wanted: bool) -> Term:
    text = f"c[{first}:{last + 1}]"
    return Term(
        text if wanted else f"nc({text})",
        lambda state: all(state.now[bit - 1] is wanted for bit in range(first, last + 1)),
    )


def _constant(register: int, op: str, value: int, is_left: bool) -> Term:
    compare = _COMPARE[op]
    if is_left:
        return Term(f"{value} {op} ds[{register}]", lambda state: compare(value, state.registers[register - 1]))
    return Term(f"ds[{register}] {op} {value}", lambda state: compare(state.registers[register - 1], value))


def _registers(one: int, op: str, other: int) -> Term:
    compare = _COMPARE[op]
    return Term(
        f"ds[{one}] {op} ds[{other}]",
        lambda state: compare(state.registers[one - 1], state.registers[other - 1]),
    )


def _group(word: str, terms: list[Term]) -> Term:
    test = all if word == "all" else any
    return Term(f"{word}({', '.join(term.text for term in terms)})", lambda state: test(t.holds(state) for t in terms))


levels = st.builds(_level, st.sampled_from(BITS), st.sampled_from(["", "nc", "re", "fe"]))
ranges = st.builds(_range, st.just(1), st.sampled_from([2, 3]), st.booleans())
constants = st.builds(
    _constant, st.sampled_from([1, 2]), st.sampled_from(sorted(_COMPARE)), st.integers(0, 3), st.booleans()
)
relations = st.builds(_registers, st.sampled_from([1, 2]), st.sampled_from(sorted(_COMPARE)), st.sampled_from([1, 2]))


def _nested(leaves: st.SearchStrategy[Term]) -> st.SearchStrategy[Term]:
    return st.recursive(
        leaves,
        lambda terms: st.builds(_group, st.sampled_from(["all", "any"]), st.lists(terms, min_size=1, max_size=4)),
        max_leaves=8,
    )


decidable = _nested(levels | ranges | constants)
"""Nothing here is beyond what logic.py can decide."""
mixed = _nested(levels | ranges | constants | relations)


def _states() -> Iterator[State]:
    bits = list(product((False, True), repeat=len(BITS)))
    for now, before in product(bits, bits):
        for registers in product(VALUES, repeat=2):
            yield State(now, before, registers)


STATES = tuple(_states())


@given(decidable, decidable)
def test_it_agrees_with_trying_every_state(one: Term, other: Term) -> None:
    first, second = read(one.text), read(other.text)
    truths = [(one.holds(state), other.holds(state)) for state in STATES]
    assert can_hold(first) is any(truth for truth, _ in truths)
    assert always_holds(first) is all(truth for truth, _ in truths)
    assert are_exclusive(first, second) is not any(both == (True, True) for both in truths)
    assert implies(first, second) is not any(both == (True, False) for both in truths)


@dataclass(frozen=True)
class Floats:
    """Two floating-point registers."""

    registers: tuple[float, ...]


_HALVES = (*(number / 2 for number in range(-2, 9)), math.nan)
FLOATS = tuple(map(Floats, product(_HALVES, repeat=2)))
"""Around and between the constants 0 to 3, and no number, which Python treats as IEEE 754 does."""


def _floats(term: Term) -> tuple[Condition, list[bool]]:
    """A condition of DF registers, and its value in every state."""
    return read(term.text.replace("ds[", "df[")), [term.holds(state) for state in FLOATS]


@given(_nested(constants), _nested(constants))
def test_it_agrees_with_trying_every_number_and_none(one: Term, other: Term) -> None:
    (first, here), (second, there) = map(_floats, (one, other))
    both = list(zip(here, there, strict=True))
    assert can_hold(first) is any(here)
    assert always_holds(first) is all(here)
    assert are_exclusive(first, second) is not any(truths == (True, True) for truths in both)
    assert implies(first, second) is not any(truths == (True, False) for truths in both)


@given(_nested(constants | relations), _nested(constants | relations))
def test_it_never_denies_a_state_of_floating_point(one: Term, other: Term) -> None:
    (first, here), (second, there) = map(_floats, (one, other))
    both = list(zip(here, there, strict=True))
    assert can_hold(first) or not any(here)
    assert not always_holds(first) or all(here)
    assert not are_exclusive(first, second) or (True, True) not in both
    assert not implies(first, second) or (True, False) not in both


@given(mixed, mixed)
def test_it_never_denies_a_state_that_there_is(one: Term, other: Term) -> None:
    first, second = read(one.text), read(other.text)
    truths = [(one.holds(state), other.holds(state)) for state in STATES]
    assert can_hold(first) or not any(truth for truth, _ in truths)
    assert not always_holds(first) or all(truth for truth, _ in truths)
    assert not are_exclusive(first, second) or (True, True) not in truths
    assert not implies(first, second) or (True, False) not in truths


NAMES = {"c[1]": "c.A", "c[2]": "c.B", "c[1:3]": "c.Two", "c[1:4]": "c.Three", "ds[1]": "ds.V", "ds[2]": "ds.W"}
"""Names for the bits, blocks and registers of these terms."""


def _named(text: str) -> str:
    for place, name in NAMES.items():
        text = text.replace(place, name)
    return text


@given(decidable, decidable, st.sampled_from([("c.A", "c.B"), ("ds.V", "ds.W"), ("c.B", "c[3]"), ("", "")]))
def test_what_it_says_of_names_holds_wherever_they_are(one: Term, other: Term, alike: tuple[str, str]) -> None:
    """Whatever it denies of names it denies of their addresses, even if two names have the same one."""
    name, twin = alike
    places = {name: place for place, name in NAMES.items()}
    first, second = map(unresolved, (_named(one.text), _named(other.text)))
    texts = [_named(term.text) for term in (one, other)]
    texts = [text.replace(name, twin) if name else text for text in texts]
    for known, place in places.items():
        texts = [text.replace(known, place) for text in texts]
    here, there = map(read, texts)
    assert can_hold(first) or not can_hold(here)
    assert not always_holds(first) or always_holds(here)
    assert not are_exclusive(first, second) or are_exclusive(here, there)
    assert not implies(first, second) or implies(here, there)


@given(decidable, st.sampled_from(["x[1].immediate", "nc(x[1].immediate)", "x[1:3].immediate"]))
def test_an_immediate_contact_says_nothing_of_another(term: Term, immediate: str) -> None:
    condition = read(term.text)
    assert can_hold(read(f"all({term.text}, {immediate})")) is can_hold(condition)
    assert implies(read(immediate), condition) is always_holds(condition)
