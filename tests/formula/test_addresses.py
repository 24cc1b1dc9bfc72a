"""One reader of addresses: a wrong address has the same problem in a condition, in an action and in a formula."""

from __future__ import annotations

import re

from hypothesis import example, given
from hypothesis import strategies as st

from clickgen.device.banks import BANKS, POINTED
from clickgen.device.elsewhere import BANKS as FOREIGN
from clickgen.dialects.if_rungs.read.imports import read_program
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.source import SourceFile

BANK_WORDS = [bank.dsl for bank in BANKS.values()]
WORDS = st.one_of(
    st.sampled_from(BANK_WORDS),
    st.sampled_from([word.upper() for word in BANK_WORDS]),
    # A word of Python's or of the formula's own is another mistake.
    st.sampled_from(sorted(word for word in FOREIGN if word.isidentifier() and word not in ("in", "mod"))),
    st.sampled_from(["dss", "dz", "ds5", "x001", "quux", "Ds"]),
)
NUMBERS = st.one_of(st.integers(-3, 40), st.sampled_from([4500, 4501, 5000, 99999, 10**12]))
SCALARS = st.one_of(
    NUMBERS.map(str),
    st.sampled_from(
        ['"0u"', '"My name"', '""', '" "', "Name", "1.5", "ds.A + 1", "5 - 1", "1-16", "+5", "1,2", "-ds.A"]
    ),
    st.sampled_from(
        ["ds.Index", "dd.Index", "ds[5]", "ds[1:5]", "ds[ds[1]]", "dss.A", "ds.Recipe[0:3]", "C.A", "0x10"]
    ),
)
BOUNDS = st.one_of(NUMBERS.map(str), st.sampled_from(["", "Name", "ds.A", "1.5"]))
INDICES = st.one_of(
    SCALARS,
    st.builds(lambda first, stop: f"{first}:{stop}", BOUNDS, BOUNDS),
    st.builds(lambda first, stop, step: f"{first}:{stop}:{step}", BOUNDS, BOUNDS, st.sampled_from(["1", "-1", "2"])),
)
ADDRESSES = st.one_of(
    st.builds(lambda bank, index: f"{bank}[{index}]", WORDS, INDICES),
    st.builds(lambda bank: f"{bank}.Name", WORDS),
    st.builds(lambda bank, index: f"{bank}.Recipe[{index}]", WORDS, INDICES),
)
READER = ("CG113", "CG201", "CG202", "CG203", "CG212", "CG213", "CG214")


def problems(rung: str) -> list[Diagnostic]:
    """What reading a program with this rung has to say; names are not resolved."""
    found = Diagnostics()
    read_program(SourceFile("prog.py", f"def main():\n{rung}    if True:\n        end()\n"), no_file, found)
    return found.found


def no_file(path: str) -> bytes:
    raise FileNotFoundError(path)


def told(rung: str, at: int) -> list[tuple[str, str, str, int, int]]:
    """What the reader says of the address that begins in this column."""
    found = [one for one in problems(rung) if one.code in READER and one.span is not None]
    return [(one.code, one.message, one.help, one.span.col - at, one.span.end_col - at) for one in found if one.span]


def as_source(address: str) -> list[tuple[str, str, str, int, int]]:
    return told(f"    if True:\n        copy({address}, txt[1])\n", 14)


def as_formula(address: str) -> list[tuple[str, str, str, int, int]]:
    return told(f"    if True:\n        calc('{address}', df[1])\n", 15)


@given(ADDRESSES)
@example("ds[ds.A + 1]")
@example("ds[Name]")
@example("ds[1-16]")
@example("DS[5]")
@example("xd[9]")
@example("ds.Recipe[-1]")
@example("ds[A:B]")
def test_a_wrong_address_has_the_same_problem_everywhere(address: str) -> None:
    wrong = as_source(address)
    in_formula = as_formula(address)
    if not wrong:
        # Only a formula refuses a range that runs backwards or skips addresses.
        assert all("range" in message for _, message, *_ in in_formula), in_formula
        return
    assert in_formula == wrong


def test_the_banks_of_pointers_are_said_alike() -> None:
    for bank in BANK_WORDS:
        wrong = as_source(f"{bank}[ds.Index]")
        assert bool(wrong) is (bank.upper() not in POINTED)
        assert as_formula(f"{bank}[ds.Index]") == wrong


SHOWN = re.compile(
    rf"\b(?:{'|'.join(BANK_WORDS)})(?:\.\w+|\[(?:\"[^\"]*\"|[a-z]+\.\w+|[a-z]+\[\d+\]|[-\d:]+)\])(?:\[[-\d:]*\])?(?!\w)"
)
"""An address in a way out."""


@given(ADDRESSES)
@example("ds[ds.A + 1]")
@example("x[1-40]")
@example("sc[Name]")
@example("XD[9]")
@example("t4[1]")
@example("x.Recipe[-1]")
def test_a_way_out_shows_addresses_that_can_be_read(address: str) -> None:
    for _, _, help, *_ in as_source(address):
        # The person's own words come back after a bank in capital letters: they may have another fault.
        own = "banks are written in small letters"
        for shown in SHOWN.findall(help) if own not in help else ():
            assert as_source(shown) == [], (help, shown)
