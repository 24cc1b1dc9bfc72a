"""Power reaches every output and input of a drawn rung exactly when the source's condition says so."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import pytest
from budget import examples
from hypothesis import given, note
from judges.builds import ladder_files
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
from strategies.conditions import ALWAYS, Condition, Contact, Group, leaves, solve
from strategies.one_rung import power_programs
from strategies.programs import Act, Branch, Item, Pin, Program, Rung

END, RETURN = Rung(ALWAYS, (Act("end()", "end()"),)), Rung(ALWAYS, (Act("return", "return()"),))


def expected(condition: Condition, items: Sequence[Item]) -> Iterator[tuple[Act, Condition]]:
    """Every instruction in source order with all its conditions."""
    for item in items:
        if isinstance(item, Act):
            yield item, condition
        else:
            assert isinstance(item, Branch)
            yield from expected(Group("all", (condition, item.condition)), item.items)


def step_register(source: Rung, rung: LadderRung) -> str:
    """The register to which a CLICK rung before the drum's copies a jump's constant step."""
    [(act, _)] = expected(source.condition, source.items)
    [copy] = rung.outputs()
    match = re.fullmatch(rf"copy\({act.constant_step},(DS\d+)\)", copy.token)
    assert match, f"no copy of step {act.constant_step}: {copy.token}"
    assert not condition_tokens(rung), "the step is copied on a condition"
    return match[1]


def check_rung(source: Rung, rung: LadderRung, step: str = "") -> None:
    """Check that a CLICK rung matches its source rung; ``step`` is the register of a jump's constant step."""
    assert 1 <= len(rung.rows) <= MAX_ROWS
    assert all(len(row.cells) == CONDITION_COLUMNS for row in rung.rows)
    wanted = list(expected(source.condition, source.items))
    tokens = [token for act, _ in wanted for token in act.tokens]
    assert [output.token for output in rung.outputs()] == tokens

    conditions = [condition for _, condition in wanted]
    conditions += [pin.condition for act, _ in wanted for pin in act.pins if pin.condition is not None]
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
            for pin in act.pins:
                shown = f".{pin.name}({step})" if step and pin.step else pin.token
                there = one_way.pop(Terminal(number, shown))
                wrong = there != (solve(pin.condition, sets, full) if pin.condition is not None else 0)
                assert not wrong, f"{pin.name} of {token} does not get the power of its condition"
            number += 1
    assert not one_way, f"there is more than the program says: {one_way}"


def check_routine(rungs: Sequence[Rung], text: str) -> list[str]:
    """Check that every source rung is one CLICK rung, after the copy of a jump's step, and correct.

    Returns the registers that steps are copied to.
    """
    drawn = read_ladder(text)
    check_limits(drawn)
    registers: list[str] = []
    at = 0
    for source in rungs:
        step = ""
        if any(act.constant_step for act, _ in expected(source.condition, source.items)):
            step = step_register(source, drawn[at])
            registers.append(step)
            at += 1
        assert at < len(drawn), "a rung is missing"
        check_rung(source, drawn[at], step)
        check_no_backfeed(drawn[at], max_vars=8)
        at += 1
    assert at == len(drawn), "a rung that fits was split"
    return registers


def check_power(program: Program, codec: bool = False) -> None:
    """Check that every routine is correct, and no register of a step serves anything else."""
    files = ladder_files(program.texts)
    routines = {"main.csv": (*program.main, END)}
    routines |= {f"subroutines/{name}.csv": (*rungs, RETURN) for name, rungs in program.subroutines}
    assert files.keys() == routines.keys()
    registers = [register for name, rungs in routines.items() for register in check_routine(rungs, files[name])]
    for register in registers:
        uses = sum(len(re.findall(rf"\b{register}\b", text)) for text in files.values())
        assert uses == 2, f"{register} is for one step alone, and stands in {uses} places"
    if codec:
        for text in files.values():
            assert_codec_reads(text)


@given(power_programs())
@examples(25)
def test_power_reaches_each_output_as_the_source_says(program: Program) -> None:
    note(program.text)
    check_power(program)


@given(power_programs())
@examples(5)
def test_the_codec_reads_what_was_drawn(program: Program) -> None:
    note(program.text)
    check_power(program, codec=True)


def test_the_reference_can_fail() -> None:
    """A rung drawn for another program does not pass."""
    one = Program((Rung(Group("any", (Contact("C1"), Contact("C2"))), (Act("out(c[3])", "out(C3)"),)),))
    other = Rung(Group("all", (Contact("C1"), Contact("C2"))), (Act("out(c[3])", "out(C3)"),))
    rung = read_ladder(ladder_files(one.texts)["main.csv"])[0]
    check_rung(one.main[0], rung)
    with pytest.raises(AssertionError, match="does not get the power"):
        check_rung(other, rung)


def test_the_reference_sees_the_wrong_input() -> None:
    """A drum whose jump and jog are swapped does not pass."""
    drum = "event_drum([y[1]], [c[1]], [[1]], ds[1], c[2])"
    token = "event_drum(outputs=[Y001],events=[C1],pattern=[[1]],current_step=DS1,completion_flag=C2)"
    reset, jump, jog = Pin("reset", Contact("C3")), Pin("jump", Contact("C4"), "DS2"), Pin("jog", Contact("C5"))
    swapped = Pin("jump", Contact("C5"), "DS2"), Pin("jog", Contact("C4"))
    one, other = (Rung(ALWAYS, (Act(drum, token, 4, pins),)) for pins in ((reset, jump, jog), (reset, *swapped)))
    rung = read_ladder(ladder_files(Program((one,)).texts)["main.csv"])[0]
    check_rung(one, rung)
    with pytest.raises(AssertionError, match=r"jump of event_drum.* does not get the power"):
        check_rung(other, rung)
