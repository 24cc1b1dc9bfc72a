"""Power reaches every output and input of a drawn rung exactly when the source's condition says so."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, note, settings
from judges.codec import assert_codec_reads
from judges.power import (
    CONDITION_COLUMNS,
    MAX_ROWS,
    LadderRung,
    Terminal,
    check_limits,
    check_no_backfeed,
    condition_tokens,
    power_sets,
    read_ladder,
    situations,
)
from strategies import (
    ALWAYS,
    PIN_TOKENS,
    Act,
    Branch,
    Condition,
    Contact,
    Group,
    Item,
    Program,
    Rung,
    leaves,
    power_programs,
    solve,
)

import clickgen


@cache
def workshop() -> Path:
    """A folder of this process for the programs under test; no table is ever written into it."""
    return Path(tempfile.mkdtemp(prefix="clickgen-properties-"))


def ladder_files(text: str) -> dict[str, str]:
    """The ladder files that a program becomes; it must build."""
    path = workshop() / "prog.py"
    path.write_text(text, encoding="utf-8")
    result = clickgen.build(path)
    assert result.ok, "\n".join(f"{one.code} {one.span}: {one.message}" for one in result.diagnostics)
    return {name: file for name, file in result.files.items() if name.startswith(("main", "subroutines/"))}


def expected(condition: Condition, items: Sequence[Item]) -> Iterator[tuple[Act, Condition]]:
    """Every instruction in source order with all it stands on."""
    for item in items:
        if isinstance(item, Act):
            yield item, condition
        else:
            assert isinstance(item, Branch)
            yield from expected(Group("all", (condition, item.condition)), item.items)


def check_rung(source: Rung, rung: LadderRung) -> None:
    assert 1 <= len(rung.rows) <= MAX_ROWS
    assert all(len(row.cells) == CONDITION_COLUMNS for row in rung.rows)
    wanted = list(expected(source.condition, source.items))
    tokens = [token for act, _ in wanted for token in act.tokens]
    assert [output.token for output in rung.outputs()] == tokens

    conditions = [condition for _, condition in wanted]
    conditions += [pin for act, _ in wanted for _, pin in act.pins if pin is not None]
    found = condition_tokens(rung)
    missing = {leaf.leaf for condition in conditions for leaf in leaves(condition)} - set(found)
    assert not missing, f"the rung has no {', '.join(sorted(missing))}"
    sets, full = situations([token for token in found if token != "SC1"], max_vars=11)
    sets["SC1"] = full
    one_way = power_sets(rung, sets, full)
    assert one_way == power_sets(rung, sets, full, bidirectional=True), "power comes back from the right"

    number = 0
    for act, condition in wanted:
        for token in act.tokens:
            same = one_way.pop(Terminal(number, "")) == solve(condition, sets, full)
            assert same, f"{token} does not get the power of its condition"
            for name, pin in act.pins:
                there = one_way.pop(Terminal(number, PIN_TOKENS[name]))
                wrong = there != (solve(pin, sets, full) if pin is not None else 0)
                assert not wrong, f"{name} of {token} does not get the power of its condition"
            number += 1
    assert not one_way, f"there is more than the program says: {one_way}"


def check_power(program: Program, codec: bool = False) -> None:
    """Every source rung is one CLICK rung, and that one is right."""
    text = ladder_files(program.text)["main.csv"]
    rungs = read_ladder(text)
    check_limits(rungs)
    assert len(rungs) == len(program.main) + 1, "a rung that fits was split"
    for source, rung in zip((*program.main, Rung(ALWAYS, (Act("end()", "end()"),))), rungs, strict=True):
        check_rung(source, rung)
        check_no_backfeed(rung, max_vars=8)
    if codec:
        assert_codec_reads(text)


@given(power_programs())
@settings(max_examples=150, deadline=None, print_blob=True)
def test_power_reaches_each_output_as_the_source_says(program: Program) -> None:
    note(program.text)
    check_power(program)


@given(power_programs())
@settings(max_examples=25, deadline=None, print_blob=True)
def test_the_codec_reads_what_was_drawn(program: Program) -> None:
    note(program.text)
    check_power(program, codec=True)


def test_the_reference_can_fail() -> None:
    """A rung drawn for another program does not pass."""
    one = Program((Rung(Group("any", (Contact("C1"), Contact("C2"))), (Act("out(c[3])", "out(C3)"),)),))
    other = Rung(Group("all", (Contact("C1"), Contact("C2"))), (Act("out(c[3])", "out(C3)"),))
    rung = read_ladder(ladder_files(one.text)["main.csv"])[0]
    check_rung(one.main[0], rung)
    with pytest.raises(AssertionError, match="does not get the power"):
        check_rung(other, rung)


POWER = {"power": (power_programs(), check_power), "codec": (power_programs(), lambda one: check_power(one, True))}
"""Each property with its examples, for ``fuzz.py``."""
